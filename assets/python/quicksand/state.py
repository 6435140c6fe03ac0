"""A saved state as arrays, numbers and pictures."""
import json
import tempfile
from functools import cached_property
from pathlib import Path

from .picture import Picture
from .program import call, option_words, units
from .table import Table


def measure(path, program, options) -> dict:
    """The output of `quicksand measure --json` for a state or a run."""
    return json.loads(call(["measure", path, "--json", *option_words(options)], program).out)


class State:
    """A checkpoint (`state.cbor` of a run, or a state saved by a session).

    disks, contacts, walls: tables; `quicksand list columns` lists their columns and units
    """

    def __init__(self, path, program=None):
        self.path = Path(path)
        self._program = program

    @cached_property
    def _tables(self) -> dict[str, Table]:
        with tempfile.TemporaryDirectory(prefix="quicksand-") as folder:
            call(["export", self.path, "--format", "csv", "--out", folder], self._program)
            return {name: Table.read(f"{folder}/{name}.csv", units(name, self._program))
                    for name in ("disks", "contacts", "walls", "states")}

    @property
    def disks(self) -> Table:
        return self._tables["disks"]

    @property
    def contacts(self) -> Table:
        return self._tables["contacts"]

    @property
    def walls(self) -> Table:
        return self._tables["walls"]

    @property
    def about(self) -> dict:
        """Time, step and box."""
        return self._tables["states"].rows()[0]

    def measure(self, **options) -> dict:
        """Regions, profile and distributions, as `quicksand measure --json` gives them, with its options.

        since: the path of an earlier state, relative to which `changes` are then given
        """
        return measure(self.path, self._program, options)

    def picture(self, **options) -> Picture:
        """The state drawn anew, with options of `quicksand render`: `colour="pressure", forces=True, size=(800, 600)`."""
        with tempfile.TemporaryDirectory(prefix="quicksand-") as folder:
            file = Path(folder) / "state.png"
            call(["render", self.path, "--out", file, *option_words(options)], self._program)
            return Picture.read(file)

    def _repr_png_(self):
        return self.picture().data

    def __repr__(self):
        return f"State({str(self.path)!r})"
