"""The states that a run passed through, as arrays."""
import shutil
import tempfile
import weakref
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path

from .errors import InputError
from .program import call, option_words, units
from .state import measure
from .table import Table


_ROUNDING = 1e-9  # times are sums of steps
_AS_WRITTEN = 0.005  # pictures round times to two digits [sqrt(d/g)]


class Sample:
    """One sample. disks, contacts, walls: tables, with the columns of a State."""

    def __init__(self, history, folder, suffix, about):
        self._history = history  # with which the folder goes
        self._folder, self._suffix = folder, suffix
        self.about = about  # time, step and box

    def _table(self, name) -> Table:
        return Table.read(self._folder / f"{name}{self._suffix}.csv", units(name, self._history._program))

    @cached_property
    def disks(self) -> Table:
        return self._table("disks")

    @cached_property
    def contacts(self) -> Table:
        return self._table("contacts")

    @cached_property
    def walls(self) -> Table:
        return self._table("walls")

    def measure(self, **options) -> dict:
        """As State.measure; `since` is an earlier time of the run, or the path of a state."""
        return measure(self._history._run, self._history._program, {"time": self.about["time"], **options})

    def __repr__(self):
        return f"<Sample at {self.about['time']}>"


class History(Sequence):
    """The samples in `history.qsh` of a run, in order: `history[-1].disks["position_y"]`, `history.at(3.2)`.

    The program writes them to a temporary folder when the first is requested; each is read when it is used.
    """

    def __init__(self, folder, program=None, **bounds):
        self._run, self._program, self._bounds = Path(folder), program, bounds

    def between(self, start, end) -> "History":
        """The samples from one time to another."""
        return History(self._run, self._program, **{"from": start, "to": end})

    @cached_property
    def _samples(self) -> list[Sample]:
        folder = Path(tempfile.mkdtemp(prefix="quicksand-"))
        weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        call(["export", self._run, "--format", "csv", "--out", folder, *option_words(self._bounds)], self._program,
             names={"from": "start", "to": "end"})
        rows = Table.read(folder / "states.csv").rows()
        files = sorted(folder.glob("disks*.csv"), key=lambda file: (len(file.stem), file.stem))
        return [Sample(self, folder, file.stem.removeprefix("disks"), about)
                for file, about in zip(files, rows, strict=True)]

    @property
    def times(self) -> list[float]:
        return [sample.about["time"] for sample in self._samples]

    def at(self, time) -> Sample:
        """The sample nearest to a time. Raises InputError if the run does not cover that time."""
        first, last = self.times[0], self.times[-1]
        slack = max(_AS_WRITTEN, _ROUNDING * last)
        if not first - slack <= time <= last + slack:
            raise InputError(f"is {time:g}, must be a number from {first:g} to {last:g} sqrt(d/g), the times of {self._run}",
                             where="time", path="time")
        return min(self._samples, key=lambda sample: abs(sample.about["time"] - time))

    def __len__(self):
        return len(self._samples)

    def __getitem__(self, k):
        return self._samples[k]

    def __repr__(self):
        return f"<History of {self._run}>"
