"""Campaigns from Python: a row a run, means over the seeds."""
import math
import unittest
import warnings

import quicksand
from support import HOPELESS, SMALL, InFolder


class Campaigns(InFolder):
    def test_are_a_table_with_a_row_a_run(self):
        result = quicksand.campaign(SMALL, {"contact.friction": [0.1, 0.6]}, realizations=2)
        self.assertEqual(result.height, 4)
        self.assertEqual(result.parameters, ["contact.friction"])
        self.assertEqual(set(result["missed_rest"]), {True})
        self.assertEqual(list(result["contact.friction"]), [0.1, 0.1, 0.6, 0.6])
        self.assertEqual(set(result["status"]), {"finished"})
        self.assertEqual([run.world_hash for run in result.runs], list(result["world_hash"]))
        self.assertEqual([run.scene["seed"] for run in result.runs], [5, 6, 5, 6])

    def test_have_means_and_errors_over_the_seeds(self):
        result = quicksand.campaign(SMALL, {"contact.friction": [0.1, 0.6]}, realizations=2)
        mean = result.mean("coordination", "depth")
        self.assertEqual(list(mean), ["contact.friction", "n", "coordination", "coordination_error", "depth",
                                      "depth_error"])
        self.assertEqual(list(mean["n"]), [2, 2])
        first, second = result["depth"][:2]
        self.assertAlmostEqual(mean["depth"][0], (first + second) / 2)
        self.assertAlmostEqual(mean["depth_error"][0], abs(first - second) / 2)

    def test_take_points_and_a_shipped_scene(self):
        result = quicksand.campaign("chain", points=[{"phases[0].max_time": 0.1}, {"phases[0].max_time": 0.2}],
                                    name="chains")
        self.assertEqual(result.folder.as_posix(), "out/chains")
        self.assertEqual(result.height, 2)

    def test_start_from_states_of_the_current_folder(self):
        quicksand.run(SMALL)
        later = {"box": {"width": 6, "height": 8}, "gravity": {}, "phases": [{"type": "settle", "max_time": 0.02}]}
        start = {"start_from": "out/small/state.cbor"}
        for given in ({"set": start}, {"points": [start]}, {"grid": {"start_from": [start["start_from"]]}}):
            result = quicksand.campaign(later, name="_".join(given), quiet=True, **given)
            self.assertEqual(list(result["status"]), ["finished"])

    def test_refuse_what_is_no_path_or_no_values(self):
        for given in ({"points": [5]}, {"set": [1]}, {"points": [{"start_from": 3}]}, {"grid": {"start_from": [3]}},
                      {"grid": {"start_from": "state.cbor"}}):
            with self.subTest(given), self.assertRaises(quicksand.InputError):
                quicksand.campaign(SMALL, name="refused", quiet=True, **given)

    def test_compute_only_what_is_new(self):
        first = quicksand.campaign(SMALL, realizations=1)
        more = quicksand.campaign(SMALL, realizations=2)
        self.assertEqual(list(more["wall_seconds"])[:1], list(first["wall_seconds"]))
        self.assertEqual(more.height, 2)

    def test_warn_of_runs_that_failed_and_leave_them_out_of_means(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            result = quicksand.campaign(SMALL, points=[HOPELESS, {"contact.friction": 0.3}])
        self.assertIn("1 of 2 runs failed", str(told[0].message))
        mean = result.mean("coordination")
        self.assertEqual(list(mean["n"]), [0, 1])
        self.assertTrue(math.isnan(mean["coordination"][0]))

    def test_refuse_a_mistake_before_the_first_run(self):
        with self.assertRaises(quicksand.InputError) as caught:
            quicksand.campaign(SMALL, {"contact.frction": [0.1]})
        self.assertEqual((caught.exception.path, caught.exception.nearest), ("contact.frction", "friction"))
        self.assertTrue(str(caught.exception).startswith("contact.frction (from grid; run 00000"), caught.exception)

    def test_name_the_arguments_of_the_caller(self):
        for points, message in (([{"contact.frction": 1}], r"^contact.frction \(from points; run 00000"),
                                ([{"contact.friction": math.inf}], r"^points\[0\].contact.friction: is inf, must be a finite")):
            with self.assertRaisesRegex(quicksand.InputError, message):
                quicksand.campaign(SMALL, points=points)
        for name, value in (("set", math.nan), ("grid", [math.nan])):
            with self.assertRaisesRegex(quicksand.InputError, rf"^{name}.contact.friction(\[0\])?: is nan, must be"):
                quicksand.campaign(SMALL, **{name: {"contact.friction": value}})


if __name__ == "__main__":
    unittest.main()
