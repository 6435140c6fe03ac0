"""Sessions from Python: their methods are the program's commands."""
import inspect
import json
import unittest
from pathlib import Path
from typing import Any, Literal

import quicksand
from quicksand.commands import methods
from quicksand.program import call
from support import SMALL, InFolder


def schema():
    return json.loads(call(["list", "session_schema"]).out)


class Sessions(InFolder):
    def setUp(self):
        super().setUp()
        self.session = quicksand.Session()
        self.addCleanup(self.session.close)

    def test_computes_measures_and_tells_where_it_stands(self):
        told = self.session.load(SMALL)
        self.assertEqual(told["scene"], "small")
        reply = self.session.run(steps=10)
        self.assertEqual((reply.step, self.session.last.step), (10, 10))
        self.assertEqual(self.session.measure("grains")["grains"], self.session.state().disks.height)
        self.session.expect_hash(reply.hash)

    def test_draws(self):
        self.session.load("chain")
        self.session.view(width=160, height=120, theme="dark")
        self.assertEqual(self.session.picture().size, (160, 120))
        self.assertEqual(self.session.picture(width=200).size[0], 200)

    def test_removes_a_value_with_none_and_leaves_out_what_is_not_given(self):
        self.session.load(SMALL)
        self.session.set("contact.friction", 0.5)
        self.session.set("contact.rolling_friction", None)
        self.session.run(steps=1, time=None)
        self.assertEqual(self.session.last.step, 1)

    def test_goes_on_after_an_error(self):
        with self.assertRaises(quicksand.CommandFailed) as failed:
            self.session.load(SMALL)
            self.session.expect(quantity="grains", at_least=1000)
        self.assertEqual(failed.exception.command["command"], "expect")
        with self.assertRaises(quicksand.InputError) as wrong:
            self.session.measure("coordnation")
        self.assertEqual(wrong.exception.nearest, "coordination")
        with self.assertRaises(quicksand.InputError) as misspelt:
            self.session.load(SMALL, set={"contact.frction": 1})
        self.assertEqual((misspelt.exception.path, misspelt.exception.nearest), ("set.contact.frction", "friction"))
        with self.assertRaisesRegex(quicksand.InputError, "^load: \"collaps\" is neither") as no_scene:
            self.session.load("collaps")
        self.assertEqual((no_scene.exception.path, no_scene.exception.nearest), (None, "collapse"))
        with self.assertRaises(quicksand.InputError) as inside:
            self.session.load("chain", set={"contact.frction": 1})
        with self.assertRaisesRegex(quicksand.InputError, "^run: time: is nan, must be a finite number") as no_number:
            self.session.run(time=float("nan"))
        self.assertEqual(no_number.exception.path, "time")
        self.assertEqual((Path(inside.exception.file).name, inside.exception.path), ("chain.json", "contact.frction"))
        self.session.run(steps=1)

    def test_refuses_arguments_that_no_command_has_as_python_does(self):
        with self.assertRaises(TypeError):
            self.session.run(stepps=1)
        with self.assertRaises(AttributeError):
            self.session.dance()

    def test_is_over_when_it_is_closed(self):
        folder = self.session.folder
        self.session.quit()
        with self.assertRaises(quicksand.SessionEnded):
            self.session.reset()
        self.session.close()
        self.session.close()
        self.assertFalse(folder.exists())

    def test_keeps_the_files_of_a_folder_of_its_own(self):
        with quicksand.Session(out="mine") as session:
            session.load("chain")
            session.save("start.cbor")
        self.assertEqual(quicksand.State("mine/start.cbor").disks.height, 10)


class Methods(unittest.TestCase):
    def test_are_the_commands_and_hide_none(self):
        made = methods(schema())
        self.assertGreater(len(made), 20)
        own = set(dir(quicksand.Session))
        self.assertEqual(own & set(made), set(), "these commands have the name of a method of Session")
        with quicksand.Session() as session:
            self.assertLessEqual(set(made), set(dir(session)))

    def test_have_signatures_types_and_help(self):
        made = methods(schema())
        push = inspect.signature(made["push"])
        self.assertEqual(push.parameters["force"].annotation, float | None)
        self.assertIs(push.parameters["density"].annotation, float)
        self.assertIs(push.parameters["force"].kind, inspect.Parameter.KEYWORD_ONLY)
        self.assertEqual(made["set"].__annotations__, {"path": str, "value": Any, "return": quicksand.Reply})
        self.assertEqual(inspect.signature(made["view"]).parameters["theme"].annotation, Literal["light", "dark"])
        for name, method in made.items():
            self.assertTrue(method.__doc__.strip(), name)
            self.assertIn(f">>> session.{name}(", method.__doc__)

    def test_examples_of_their_help_bind(self):
        made = methods(schema())
        for name, method in made.items():
            example = method.__doc__.split(">>> session.")[1].strip()
            arguments = eval(f"dict{example[len(name):]}")
            inspect.signature(method).bind(None, **arguments)

    def test_follow_a_program_with_another_vocabulary(self):
        other = {"properties": {"commands": {"items": {"oneOf": [{
            "properties": {
                "command": {"const": "shake", "description": "Shakes the floor."},
                "from": {"type": ["string", "object"], "description": "where"},
                "at": {"type": "array", "items": {"type": "number"}}},
            "required": ["command", "at"], "examples": [{"command": "shake", "at": [1, 2], "from": "x"}]}]}}}}
        shake = methods(other)["shake"]

        class Listener:
            def command(self, name, **arguments):
                return name, arguments

        self.assertEqual(shake(Listener(), [1, 2], from_="x"), ("shake", {"at": [1, 2], "from": "x"}))
        self.assertEqual(shake.__annotations__["at"], list[float])
        self.assertEqual(shake.__annotations__["from_"], str | dict | None)
        self.assertIn(">>> session.shake(at=[1, 2], from_='x')", shake.__doc__)


if __name__ == "__main__":
    unittest.main()
