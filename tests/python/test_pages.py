"""What a reader copies: the page's Python, the example notebook, the installation by pip."""
import contextlib
import csv
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import unittest
from pathlib import Path
from unittest import mock

import quicksand
from quicksand.program import call
from support import InFolder, needs

SOURCE = Path(__file__).resolve().parents[2]
MODULE = SOURCE / "assets/python"
NOTEBOOK = MODULE / "examples/cohesion_sweep.ipynb"


class Page(InFolder):
    def test_examples_of_the_page_run_one_after_the_other(self):
        page = (SOURCE / "assets/doc/python.md").read_text()
        blocks = re.findall(r"^```python\n(.*?)^```", page, re.M | re.S)
        self.assertGreater(len(blocks), 4)
        scope = {}
        for block in blocks:
            with self.subTest(block=block), contextlib.redirect_stdout(io.StringIO()) as told:
                exec(compile(block, "python.md", "exec"), scope)
        self.assertIn("contact.frction friction", told.getvalue())  # as the last block promises


@needs("numpy")
class Demo(InFolder):
    def test_ends_with_the_numbers_that_the_pages_print(self):
        run = quicksand.run("collapse", no_frames=True, quiet=True)
        readme = (SOURCE / "README.md").read_text()
        self.assertIn(f"\n{run.summary['steps']} steps in ", readme)
        self.assertIn(f"with {run.summary['grains']} bodies", readme)
        page = (SOURCE / "assets/doc/export.md").read_text()
        printed, script = re.search(r"prints\n`([^`]*)`:\n\n```python\n(.*?)^```", page, re.M | re.S).groups()
        call(["export", run.folder / "state.cbor", "--format", "npy", "--out", run.folder / "npy"])
        with contextlib.redirect_stdout(io.StringIO()) as told:
            exec(compile(script, "export.md", "exec"), {})
        self.assertEqual(told.getvalue(), printed + "\n")


class FirstScene(InFolder):
    def test_campaign_gives_the_table_of_the_page(self):
        page = (SOURCE / "assets/doc/first_scene.md").read_text()
        for text in re.findall(r"^```json\n(.*?)^```", page, re.M | re.S):  # the last of each kind counts
            Path("heap.json" if "phases" in json.loads(text) else "strength.json").write_text(text)
        call(["campaign", "strength.json", "--quiet"])
        with open("out/strength/results.csv") as file:
            rows = list(csv.DictReader(file))
        names = ["phases[2].force_over_cohesion", "seed", "depth", "bonds_broken"]
        table = "".join(" ".join(row[name] for name in names) + "\n" for row in rows)
        self.assertIn(f"```\n{' '.join(names)}\n{table}```", page)


@needs("nbclient", "nbformat", "ipykernel", "matplotlib", "numpy")
class Notebook(InFolder):
    @staticmethod
    def outputs(notebook, kind):
        """What its cells show of this kind."""
        return [output["data"][kind] for cell in notebook.cells for output in cell.get("outputs", [])
                if kind in output.get("data", {})]

    def test_example_runs_from_its_first_cell_to_its_last(self):
        import nbformat
        from nbclient import NotebookClient

        notebook = nbformat.read(NOTEBOOK, as_version=4)
        table = self.outputs(notebook, "text/html")[0]
        # Jupyter keeps its own files here, and its debugger silent.
        env = {**os.environ, "IPYTHONDIR": os.path.abspath("ipython"), "JUPYTER_RUNTIME_DIR": os.path.abspath("runtime"),
               "PYDEVD_DISABLE_FILE_VALIDATION": "1", "PYTHONDONTWRITEBYTECODE": "1"}
        with mock.patch.dict(os.environ, env):
            NotebookClient(notebook, timeout=240, record_timing=False, resources={"metadata": {"path": os.getcwd()}}).execute()
        self.assertGreaterEqual(len(self.outputs(notebook, "image/png")), 3)
        if os.environ.get("QUICKSAND_UPDATE_NOTEBOOK"):
            notebook.metadata["language_info"] = {"name": "python"}  # without versions
            nbformat.write(notebook, NOTEBOOK)
        else:
            self.assertEqual(self.outputs(notebook, "text/html")[0], table, "QUICKSAND_UPDATE_NOTEBOOK=1 writes it anew")


@needs("pip", "setuptools", "wheel")
class Installation(InFolder):
    def test_by_pip_needs_nothing_but_python(self):
        shutil.copytree(MODULE, "module")  # pip builds inside the folder
        pip = subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps",
                              "--no-build-isolation", "--target", "installed", "./module"],
                             capture_output=True, text=True)
        self.assertEqual(pip.returncode, 0, pip.stderr)
        # -S: no packages of the system.
        script = 'import quicksand; print(type(quicksand.run("chain", no_frames=True, quiet=True).series["time"]))'
        python = subprocess.run([sys.executable, "-S", "-c", script], capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": "installed"})
        self.assertEqual(python.stdout, "<class 'list'>\n", python.stderr)


class Version(unittest.TestCase):
    def test_is_that_of_the_program(self):
        version = tomllib.loads((MODULE / "pyproject.toml").read_text())["project"]["version"]
        self.assertIn(f"project(quicksand VERSION {version} ", (SOURCE / "CMakeLists.txt").read_text())


if __name__ == "__main__":
    unittest.main()
