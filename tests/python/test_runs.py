"""Runs from Python: what they give, how they are interrupted, what their errors say."""
import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import quicksand
from support import HOPELESS, SMALL, InFolder, needs


class Runs(InFolder):
    def test_a_dict_a_name_and_a_path_are_scenes(self):
        run = quicksand.run(SMALL, no_frames=True)
        self.assertEqual(run.folder, Path("out/small"))
        again = quicksand.run("out/small/scene.json", out="again", no_frames=True)
        self.assertEqual(again.world_hash, run.world_hash)
        self.assertTrue(run.finished)
        chain = quicksand.run("chain", {"phases[0].max_time": 0.1}, no_frames=True)
        self.assertEqual(chain.folder, Path("out/chain"))

    def test_values_and_seed_are_set(self):
        run = quicksand.run(SMALL, set={"contact.friction": 0.5, "phases[2]": {"type": "settle", "max_time": 0.1}},
                            seed=7, out="set", no_frames=True)
        self.assertEqual(run.scene["contact"]["friction"], 0.5)
        self.assertEqual(run.scene["phases"][2]["type"], "settle")
        self.assertEqual(run.summary["seed"], 7)

    def test_what_is_no_scene_and_no_value_is_refused(self):
        for scene, values, place in ((3, None, "scene"), (SMALL, {"contact.friction": object()}, "set.contact.friction"),
                                     (SMALL, [1], "set")):
            with self.assertRaises(quicksand.InputError) as caught:
                quicksand.run(scene, values)
            self.assertEqual(caught.exception.where, place)

    def test_series_state_and_pictures_are_those_of_the_folder(self):
        run = quicksand.run(SMALL, size=(160, 120), every=0.1)
        self.assertEqual(run.series["time"][-1], run.summary["time"])
        self.assertEqual(len(run.frames), run.series.height)
        self.assertEqual(run.picture().size, (160, 120))
        self.assertEqual(run.picture(size="200x100", colour="speed").size, (200, 100))
        disks = run.state.disks
        self.assertEqual(disks.height, 21)
        self.assertEqual(sum(role == 0 for role in disks["role"]), run.summary["grains"])
        self.assertEqual(run.state.about["step"], run.summary["step"])
        self.assertIn("coordination", str(run.state.measure()))

    def test_the_history_holds_the_state_of_each_sample(self):
        run = quicksand.run(SMALL, no_frames=True, every=0.1)
        history = run.history
        self.assertEqual(len(history), run.series.height)
        self.assertEqual(history.times, list(run.series["time"]))
        self.assertEqual(history[-1].disks.height, run.state.disks.height)
        for ours, saved in zip(history[-1].disks["position_y"], run.state.disks["position_y"]):
            self.assertAlmostEqual(ours, saved, places=6)
        self.assertEqual(history.at(history.times[2] + 0.01).about["step"], history[2].about["step"])
        part = history.between(history.times[1], history.times[2])
        self.assertEqual(part.times, history.times[1:3])
        self.assertEqual(history.between(history.times[1], history.times[1])[0].about["step"], history[1].about["step"])
        self.assertIn("bond", str(list(history[1].contacts)))

    def test_the_history_refuses_times_at_which_the_run_was_not(self):
        history = quicksand.run(SMALL, no_frames=True).history
        for time in (1e9, -1, float("nan")):
            with self.assertRaisesRegex(quicksand.InputError, "time: is .*, must be a number from 0 to 1 "):
                history.at(time)
        with self.assertRaisesRegex(quicksand.InputError, "^start 5: must be a number from 0 to 1 "):
            history.between(5, 6).times

    def test_two_moments_are_compared(self):
        run = quicksand.run(SMALL, no_frames=True)
        changes = run.measure(time=1, since=0.4)["changes"]
        self.assertGreater(changes["largest_displacement"], 0)
        self.assertEqual(run.history[-1].measure(since=0.4)["changes"], changes)
        self.assertEqual(run.state.measure(since=run.state.path)["changes"]["bonds_broken"], 0)

    def test_a_table_that_is_not_there_is_told_with_those_that_are(self):
        with self.assertRaisesRegex(quicksand.InputError, "out/small: sries: is not a table of this run, .* series") as caught:
            quicksand.run(SMALL, no_frames=True).table("sries")
        self.assertEqual(caught.exception.nearest, "series")

    def test_tables_know_their_units(self):
        run = quicksand.run(SMALL, no_frames=True)
        self.assertEqual(run.series.label("depth"), "depth [d]")
        self.assertEqual(run.series.label("coordination"), "coordination")
        self.assertEqual(run.state.disks.label("velocity_x"), "velocity_x [sqrt(g d)]")
        for table in (run.series, run.state.disks, run.state.contacts, run.state.walls):
            self.assertEqual(set(table) - set(table._units), set())

    def test_a_run_shows_itself_in_a_notebook(self):
        run = quicksand.run(SMALL, size=(160, 120), every=0.3)
        self.assertTrue(run._repr_png_().startswith(b"\x89PNG"))
        page = run._repr_html_()
        for text in ("small", "finished", run.world_hash, "data:image/png;base64,"):
            self.assertIn(text, page)
        self.assertIn("finished", repr(run))
        self.assertEqual(run.film, Path("out/small/film.mp4" if Path("out/small/film.mp4").exists() else
                                        "out/small/film.png"))

    def test_a_folder_that_holds_a_run_is_only_replaced_if_asked(self):
        quicksand.run(SMALL, no_frames=True)
        with self.assertRaises(quicksand.InputError):
            quicksand.run(SMALL, no_frames=True)
        quicksand.run(SMALL, no_frames=True, overwrite=True)

    def test_resume_reads_what_is_finished_and_refuses_another_scene(self):
        run = quicksand.run(SMALL, no_frames=True)
        before = os.stat("out/small/state.cbor").st_mtime_ns
        self.assertEqual(quicksand.run(SMALL, no_frames=True, resume=True).world_hash, run.world_hash)
        self.assertEqual(os.stat("out/small/state.cbor").st_mtime_ns, before)
        with self.assertRaisesRegex(quicksand.InputError, "another scene.*contact"):
            quicksand.run(SMALL, {"contact.friction": 0.1}, no_frames=True, resume=True)


# A run of some seconds in a Python of its own; `Interrupted` is what a notebook's kernel would see.
INTERRUPTED_RUN = """
import quicksand
try:
    quicksand.run("chain", {"phases[0].max_time": 150, "phases[0].until_rest": False}, no_frames=True, out="run")
except quicksand.Interrupted as interrupted:
    assert isinstance(interrupted, KeyboardInterrupt)
    print(interrupted.run.summary["interrupted"], interrupted.run.finished)
"""


class Interrupts(InFolder):
    def test_ctrl_c_saves_the_run_which_then_ends_as_if_nothing_had_been(self):
        python = subprocess.Popen([sys.executable, "-c", INTERRUPTED_RUN], stdout=subprocess.PIPE, text=True)
        while not (Path("run/series.csv").exists() and Path("run/series.csv").stat().st_size > 2000):
            self.assertIsNone(python.poll())
            time.sleep(0.02)
        python.send_signal(signal.SIGINT)
        self.assertEqual(python.communicate()[0].split(), ["True", "False"])
        settings = {"phases[0].max_time": 150, "phases[0].until_rest": False}
        resumed = quicksand.run("chain", settings, no_frames=True, out="run", resume=True)
        whole = quicksand.run("chain", settings, no_frames=True, out="whole")
        self.assertTrue(resumed.finished)
        self.assertEqual(resumed.world_hash, whole.world_hash)
        self.assertEqual(Path("run/series.csv").read_bytes(), Path("whole/series.csv").read_bytes())

    def test_ctrl_c_ends_a_session_whose_state_is_kept(self):
        script = """
import quicksand
session = quicksand.Session(out="live")
session.load("chain", set={"phases[0].max_time": 1e6, "phases[0].until_rest": False})
session.view(width=64, height=64)
session.record(on=True, folder="film", every=1)
try:
    session.run()
except quicksand.Interrupted as interrupted:
    print(interrupted.state.about["step"] > 0)
"""
        python = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        while len(list(Path("live/film/frames").glob("*.png"))) < 3:  # until it computes
            self.assertIsNone(python.poll())
            time.sleep(0.02)
        python.send_signal(signal.SIGINT)
        self.assertEqual(python.communicate()[0], "True\n")


class Errors(InFolder):
    def test_a_mistake_in_a_scene_has_file_path_and_nearest_name(self):
        with self.assertRaises(quicksand.InputError) as caught:
            quicksand.run("chain", {"contact.frction": 0.5})
        error = caught.exception
        self.assertEqual(Path(error.file).name, "chain.json")
        self.assertEqual(error.path, "contact.frction")
        self.assertEqual(error.nearest, "friction")
        self.assertIn("(from set)", error.where)
        self.assertIn("is not a key", error.message)
        self.assertIsInstance(error, ValueError)

    def test_unknown_scenes_and_options_have_a_nearest_name(self):
        for call, nearest in ((lambda: quicksand.run("chian"), "chain"),
                              (lambda: quicksand.run(SMALL, no_frame=True), "no_frames"),
                              (lambda: quicksand.run(SMALL, colour="sped"), "speed")):
            with self.assertRaises(quicksand.InputError) as caught:
                call()
            self.assertEqual(caught.exception.nearest, nearest)

    def test_names_the_arguments_of_the_caller(self):
        for call, message in (
                (lambda: quicksand.run({**SMALL, "gravty": {}}), "^scene: gravty: is not a key of a scene; did you mean"),
                (lambda: quicksand.run(SMALL, {"contact.frction": 1}), r"^scene: contact.frction \(from set\): is not"),
                (lambda: quicksand.run(SMALL, {"contact.friction": float("nan")}), "^set.contact.friction: is nan, must be"),
                (lambda: quicksand.run("chain", helpp=True), "^helpp is not an option of run$"),
                (lambda: quicksand.run("chain", help=True), "^help: is for the command line only$"),
                (lambda: quicksand.run("chain", xx=1), "^xx is not an option of run; known: out, "),
                (lambda: quicksand.run("chain", every=-1), r"^every: is -1, must be a number [^(]*sqrt\(d/g\)$")):
            with self.assertRaisesRegex(quicksand.InputError, message) as caught:
                call()
            self.assertFalse("--" in str(caught.exception) or caught.exception.file, caught.exception)

    def test_a_run_that_breaks_its_limits_is_there_to_look_at(self):
        with self.assertRaises(quicksand.ValidationFailed) as caught:
            quicksand.run(SMALL, no_frames=True, strict=True, max_overlap=0)
        self.assertTrue(caught.exception.run.finished)
        self.assertIn("overlapped", caught.exception.message)

    def test_a_failed_run_says_how_to_go_on(self):
        with self.assertRaises(quicksand.RunFailed) as caught:
            quicksand.run(SMALL, HOPELESS, no_frames=True)
        error = caught.exception
        self.assertEqual(error.kind, "run_failed")
        self.assertIn("--continue", error.how_to_go_on)
        self.assertEqual(error.run.summary["finished"], False)

    def test_a_folder_without_a_run_is_none(self):
        with self.assertRaises(quicksand.InputError):
            quicksand.Run(".")


class Program(InFolder):
    def test_is_found_by_argument_then_environment_then_path(self):
        program = quicksand.find_program()
        for name in ("named", "on_path"):
            Path(name).mkdir()
            Path(name, "quicksand").symlink_to(program)
        self.assertEqual(quicksand.find_program("named/quicksand"), Path("named/quicksand"))
        before = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
        os.environ["PATH"] = os.path.abspath("on_path")
        self.assertEqual(quicksand.find_program(), program)
        del os.environ["QUICKSAND"]
        self.assertEqual(quicksand.find_program(), Path("on_path/quicksand").absolute())

    def test_that_is_missing_is_told_with_the_ways_to_name_it(self):
        with self.assertRaisesRegex(quicksand.ProgramNotFound, "argument program"):
            quicksand.find_program("/nowhere/quicksand")

    def test_that_does_not_start_is_told(self):
        Path("broken").write_text("no program")
        Path("broken").chmod(0o755)
        with self.assertRaisesRegex(quicksand.ProgramNotFound, "does not start"):
            quicksand.run("chain", program="./broken")


@needs("pandas")
class Frames(InFolder):
    def test_are_the_tables(self):
        run = quicksand.run(SMALL, no_frames=True)
        frame = run.series.frame()
        self.assertEqual(list(frame.columns), list(run.series))
        self.assertEqual(len(frame), run.series.height)


if __name__ == "__main__":
    unittest.main()
