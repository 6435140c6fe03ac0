"""Many runs of one scene over parameters and seeds, as one table."""
import json
import math
import os
import tempfile
import warnings
from pathlib import Path

from .errors import file_of_argument
from .program import call, option_words, plain, units
from .runs import Run, found_from_everywhere, self_contained
from .table import Table

_FAILED = 1  # exit code: some runs failed


def campaign(scene, grid=None, *, points=None, set=None, realizations=1, name=None, frames=False, out=None,
             quiet=False, program=None, **options) -> "Campaign":
    """Computes all runs on all cores and returns their results, one row per run.

    scene:        the name of a shipped scene, the path of a file, or the scene itself, a dict
    grid:         lists of values by path; all combinations are run: {"contact.friction": [0.3, 0.6]}
    points:       single points instead of or in addition to a grid, each a dict of values by path
    set:          values for all runs
    realizations: runs of each point, with seeds s, s+1, ..., where s is the scene's seed
    out:          the folder for the results, out/<name> by default
    options:      the other options of `quicksand campaign`: threads=2, engine="slurm", wait=True

    The same call, given again, computes only runs that are new or were interrupted. A failed run stops nothing: the
    column `status` shows it, and a warning is issued. Raises InputError, Interrupted.
    """
    if name is None:
        stem = scene.get("name", "scene") if isinstance(scene, dict) else Path(scene).stem
        name = f"{stem}_campaign"
    out = Path(out if out is not None else Path("out") / name)
    described = {"name": name, "scene": _scene(scene), "set": set and self_contained(set, "set"),
                 "grid": grid and _self_contained_grid(grid), "list": points and
                 [self_contained(point, f"points[{i}]") for i, point in enumerate(points)],
                 "realizations": realizations, "frames": frames}
    with (tempfile.TemporaryDirectory(prefix="quicksand-") as folder,
          file_of_argument(f"{folder}/campaign.json", names={"list": "points"})):
        file = Path(folder) / "campaign.json"
        described = plain({key: value for key, value in described.items() if value is not None})
        file.write_text(json.dumps(described), encoding="utf-8")
        call(["campaign", file, *option_words({"out": out, "quiet": quiet, **options})], program, quiet,
             fine=(0, _FAILED))
    result = Campaign(out, program)
    failed = sum(status == "failed" for status in result["status"])
    if failed:
        warnings.warn(f"{failed} of {result.height} runs failed; the column failure says why", stacklevel=2)
    return result


def _self_contained_grid(grid):
    grid = plain(grid, "grid")
    if isinstance(grid, dict) and isinstance(grid.get("start_from"), list):
        grid["start_from"] = [found_from_everywhere(path) for path in grid["start_from"]]
    return grid


def _scene(scene):
    if isinstance(scene, dict):
        return self_contained(scene)
    # Paths count from here, not from the file of the campaign; a name is none.
    return os.path.abspath(scene) if os.path.isfile(scene) or set(os.fspath(scene)) & set("/.") else scene


class Campaign(Table):
    """The results of a campaign, one row per run: parameters, seed, status, and the quantities at the end of the run."""

    def __init__(self, folder, program=None):
        self.folder = Path(folder)
        self._program = program
        super().__init__(Table.read(self.folder / "results.csv"), units("series", program))

    @property
    def parameters(self) -> list[str]:
        """The paths of the values that vary."""
        names = list(self)
        return names[names.index("run") + 1:names.index("seed")]

    @property
    def runs(self) -> list[Run]:
        """The run of each row."""
        return [Run(self.folder / "runs" / str(name), self._program) for name in self["run"]]

    def mean(self, *quantities) -> Table:
        """One row per point: its parameters, the number n of finished runs, and for each quantity (named as in
        `quicksand list quantities`) the mean over the seeds and, as NAME_error, its standard error, which is nan for
        a single run."""
        points = {}
        for row in self.rows():
            values = points.setdefault(tuple(row[name] for name in self.parameters), [])
            if row["status"] == "finished":
                values.append(row)
        columns = {name: [point[i] for point in points] for i, name in enumerate(self.parameters)}
        columns["n"] = [len(rows) for rows in points.values()]
        for name in quantities:
            self[name]  # tells a misspelt one
            pairs = [mean_and_error([row[name] for row in rows]) for rows in points.values()]
            columns[name] = [mean for mean, _ in pairs]
            columns[f"{name}_error"] = [error for _, error in pairs]
        return Table(columns, self._units)


def mean_and_error(values) -> tuple[float, float]:
    """Mean and standard error of the numbers among these values."""
    numbers = [value for value in values if not math.isnan(value)]
    n = len(numbers)
    if n == 0:
        return math.nan, math.nan
    mean = math.fsum(numbers) / n
    if n == 1:
        return mean, math.nan
    return mean, math.sqrt(math.fsum((value - mean) ** 2 for value in numbers) / (n - 1) / n)
