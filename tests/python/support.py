"""What the tests of the Python module share: a folder of their own, and scenes that take a fraction of a second."""
import os
import tempfile
import unittest

# Twenty grains fall into a narrow box, stick, and are pressed.
SMALL = {
    "name": "small", "seed": 5, "gravity": {},
    "box": {"width": 6, "height": 8},
    "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
    "step": {"dt": 0.01},
    "phases": [
        {"type": "deposit", "grains": 20, "interval": 0.02},
        {"type": "settle", "max_time": 0.3, "until_rest": False},
        {"type": "push", "diameter": 2, "force": 300, "max_time": 0.3, "sample_every": 0.05}],
}

# With these its solver cannot converge.
HOPELESS = {"solver.method": "gauss_seidel", "solver.max_iterations": 1, "solver.tolerance": 1e-14,
            "step.max_halvings": 0}


class InFolder(unittest.TestCase):
    """Each test has an empty working folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="quicksand-test-")
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)


def needs(*packages):
    """Skips a test or a class where a package is absent, and says how to get it."""
    import importlib.util

    missing = [one for one in packages if importlib.util.find_spec(one) is None]
    debian = " ".join(f"python3-{one}" for one in missing)
    return unittest.skipIf(missing, f"needs {', '.join(missing)}: apt-get install {debian}")
