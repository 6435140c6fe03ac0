"""Runs: computing one, and reading its results."""
import base64
import difflib
import html
import json
import os
import tempfile
from functools import cached_property
from pathlib import Path

from .errors import InputError, Interrupted, RunFailed, file_of_argument
from .history import History
from .picture import Picture
from .program import call, option_words, plain, plain_values, units
from .state import State, measure
from .table import Table, text_of


def scene_file(scene, folder) -> str:
    """The scene for the program: a name, a path, or a file in `folder` that holds this dict."""
    if not isinstance(scene, dict):
        if not isinstance(scene, (str, os.PathLike)):
            raise InputError(f"is {type(scene).__name__}, must be a name, a path or a dict", where="scene", path="scene")
        return os.fspath(scene)
    file = Path(folder) / "scene.json"
    file.write_text(json.dumps(self_contained(scene)), encoding="utf-8")
    return str(file)


def self_contained(scene, where="scene") -> dict:
    """The scene, or values for one, as plain JSON; the state that it starts from is found from everywhere."""
    scene = plain(scene, where)
    if isinstance(scene, dict) and "start_from" in scene:
        scene["start_from"] = found_from_everywhere(scene["start_from"])
    return scene


def found_from_everywhere(path):
    """A path, absolute; what is none the program refuses."""
    return os.path.abspath(path) if path and isinstance(path, str) else path


def run(scene, set=None, *, seed=None, out=None, overwrite=False, resume=False, quiet=False, program=None,
        **options) -> "Run":
    """Computes a scene and returns the run.

    scene:     the name of a shipped scene, the path of a file, or the scene itself, a dict
    set:       values of the scene by path: {"contact.friction": 0.5, "phases[1].force": 2e4}
    out:       the folder for the results, out/<name of the scene> by default
    overwrite: replaces the run already in the folder
    resume:    continues the run of this very scene in the folder; if it is finished, only reads it
    quiet:     shows no progress
    options:   the other options of `quicksand run`: every=0.1, no_frames=True, threads=1, strict=True,
               colour="speed", size=(640, 480)

    Ctrl-C raises Interrupted, a KeyboardInterrupt, once the program has saved what it computed; continue with its
    `run` or with resume=True. Raises InputError, RunFailed (with its `run`), ValidationFailed.
    """
    with tempfile.TemporaryDirectory(prefix="quicksand-") as folder, file_of_argument(f"{folder}/scene.json", "scene"):
        words = [scene_file(scene, folder)]
        words += [f"--set={path}={json.dumps(value)}" for path, value in plain_values(set, "set").items()]
        words += option_words({"seed": seed})
        resolved = json.loads(call(["check", "--json", *words], program).out)
        out = Path(out if out is not None else Path("out") / resolved["name"])
        if resume and (out / "scene.json").exists():
            return Run(out, program)._resume_as(resolved, quiet)
        words += option_words({"out": out, "overwrite": overwrite, "quiet": quiet, **options})
        return _compute(["run", *words], out, quiet, program)


def _compute(words, out, quiet, program) -> "Run":
    try:
        call(words, program, quiet)
    except Interrupted:
        raise Interrupted(f"interrupted; Run({str(out)!r}).resume() continues it", run=Run(out, program)) from None
    except RunFailed as error:
        error.run = Run(out, program)
        raise
    return Run(out, program)


class Run:
    """The folder of a run, finished or not. Files are read once: make a new Run to read them again."""

    def __init__(self, folder, program=None):
        self.folder = Path(folder)
        self._program = program
        if not (self.folder / "run.json").exists():
            raise InputError("is not the folder of a run: it has no run.json", where=str(folder), file=str(folder))

    def _json(self, name) -> dict:
        file = self.folder / name
        return json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}

    @cached_property
    def scene(self) -> dict:
        """The scene with every default made explicit; it can be run again."""
        return self._json("scene.json")

    @cached_property
    def summary(self) -> dict:
        """Final values, how the run ended, its energy balance; empty while it computes or after a kill."""
        return self._json("summary.json")

    @property
    def finished(self) -> bool:
        return self.summary.get("finished", False)

    @property
    def world_hash(self) -> str | None:
        """The hash of the last state: equal runs have equal hashes."""
        return self.summary.get("world_hash")

    @cached_property
    def series(self) -> Table:
        """The time history, one row per sample; `quicksand list quantities` lists its columns and units."""
        return Table.read(self.folder / "series.csv", units("series", self._program))

    def table(self, name) -> Table:
        """Another table of the run: "critical_forces" of a search, "adiabatic" of a deposition."""
        file = self.folder / f"{name}.csv"
        if not file.exists():
            there = sorted(one.stem for one in self.folder.glob("*.csv"))
            raise InputError(f"is not a table of this run, which has: {', '.join(there) or 'none'}",
                             where=f"{self.folder}: {name}", path=str(name),
                             nearest=next(iter(difflib.get_close_matches(str(name), there, 1)), None))
        return Table.read(file)

    @property
    def state(self) -> State:
        """The last saved state."""
        return State(self.folder / "state.cbor", self._program)

    def measure(self, **options) -> dict:
        """As State.measure, of the sample nearest to `time` (the last state if absent); `since` is an earlier time, or
        the path of a state: `run.measure(time=13, since=5.96)["changes"]`."""
        return measure(self.folder, self._program, options)

    @cached_property
    def history(self) -> History:
        """The states of all samples; `between` selects a part of a long run."""
        return History(self.folder, self._program)

    @property
    def frames(self) -> list[Path]:
        """The pictures of the samples, in order."""
        return sorted((self.folder / "frames").glob("frame_*.png"))

    @property
    def film(self) -> Path | None:
        """film.mp4 or, without ffmpeg, film.png, which browsers play."""
        return next((file for file in (self.folder / "film.mp4", self.folder / "film.png") if file.exists()), None)

    def report(self) -> Path:
        """Writes report.html, one page with warnings, time histories, pictures and the model."""
        call(["report", self.folder], self._program)
        return self.folder / "report.html"

    @property
    def figures(self) -> dict[str, Picture]:
        """The plots of the report by name; writes the report if there is none."""
        if not (self.folder / "plots").exists():
            self.report()
        return {file.stem: Picture.read(file) for file in sorted((self.folder / "plots").glob("*.png"))}

    def picture(self, **options) -> Picture:
        """The last frame; with options of `quicksand render`, or without frames, the last state drawn anew."""
        if self.frames and not options:
            return Picture.read(self.frames[-1])
        return self.state.picture(**options)

    def resume(self, quiet=False) -> "Run":
        """Continues an interrupted or killed run; the results are those of an uninterrupted run."""
        return _compute(["resume", self.folder, *option_words({"quiet": quiet})], self.folder, quiet, self._program)

    def _resume_as(self, scene, quiet) -> "Run":
        if scene != self.scene:
            keys = ", ".join(key for key in scene | self.scene if scene.get(key) != self.scene.get(key))
            raise InputError(f"holds a run of another scene (they differ in {keys}); choose another out, or "
                             "overwrite=True instead of resume=True", where=str(self.folder), file=str(self.folder))
        return self if self.finished else self.resume(quiet)

    def _how_it_ended(self) -> str:
        if not self.summary:
            return "not finished"
        if self.summary["failure"]:
            return "failed: " + self.summary["failure"]
        return "finished" if self.finished else "interrupted"

    def _repr_png_(self):
        return self._shown().data

    def _shown(self) -> Picture:
        """What a notebook shows: small, since it keeps it."""
        return self.picture() if self.frames else self.picture(size=(640, 360))

    def _repr_html_(self):
        told = {name: self.summary.get(name) for name in (
            "time", "steps", "grains", "contacts", "coordination", "volume_fraction", "active_bond_fraction",
            "bonds_broken", "depth", "unconverged_steps", "wall_seconds", "world_hash")}
        rows = {self.scene.get("name", "run"): self._how_it_ended(), **told, "folder": self.folder}
        cells = "".join(f"<tr><th style='text-align:left'>{html.escape(name)}</th>"
                        f"<td style='text-align:left'>{html.escape(text_of(value))}</td></tr>"
                        for name, value in rows.items() if value is not None)
        picture = ""
        if self.frames or (self.folder / "state.cbor").exists():
            data = base64.b64encode(self._shown().data).decode()
            picture = f"<img style='max-width:640px' src='data:image/png;base64,{data}'>"
        return f"<div style='display:flex;gap:1em;align-items:flex-start'><table>{cells}</table>{picture}</div>"

    def __repr__(self):
        return f"<Run {self.folder}: {self._how_it_ended()}>"
