"""What the program says while it computes, and where it is shown."""
import io
import sys
import unittest
from unittest import mock

from quicksand.program import Messages
from quicksand.progress import Progress

# A status that is written over twice and wiped, a note, and an error.
SAID = '\rpush  3 %\rpush 40 %  \r          \rended at its max_time\n{"error":{"kind":"input","message":"no"}}\n'


class Listener:
    def __init__(self):
        self.shown, self.noted = [], []

    def show(self, text):
        self.shown.append(text)

    def note(self, text):
        self.noted.append(text)


class MessagesOfTheProgram(unittest.TestCase):
    def test_are_told_apart_however_they_arrive(self):
        for size in (1, 7, 1000):
            messages = Messages(Listener())
            for begin in range(0, len(SAID), size):
                messages.feed(SAID[begin:begin + size])
            self.assertEqual(messages.notes, ["ended at its max_time"])
            self.assertEqual(messages.progress.noted, messages.notes)
            self.assertEqual(messages.error, {"kind": "input", "message": "no"})

    def test_status_is_what_was_written_last(self):
        messages = Messages(Listener())
        messages.feed("\rpush  3 %")
        messages.feed("\rpush 40 %  ")
        self.assertEqual(messages.progress.shown, ["push  3 %", "push 40 %"])


class Terminal(io.StringIO):
    def isatty(self):
        return True


class ProgressLines(unittest.TestCase):
    def shown(self, stream, quiet=False):
        with mock.patch.object(sys, "stderr", stream):
            progress = Progress(quiet)
            progress.show("push 40 %")
            progress.note("a note")
            progress.end("done")
        return stream.getvalue()

    def test_a_terminal_keeps_notes_only(self):
        text = self.shown(Terminal())
        self.assertIn("\rpush 40 %", text)
        self.assertEqual([line.rsplit("\r")[-1] for line in text.split("\n")], ["a note", ""])

    def test_where_nobody_looks_nothing_is_written(self):
        self.assertEqual(self.shown(io.StringIO()), "")
        self.assertEqual(self.shown(Terminal(), quiet=True), "")

    def test_a_notebook_keeps_one_output_that_changes(self):
        outputs = []

        class Handle:
            def update(self, data, raw):
                outputs[-1] = data["text/plain"]

        def display(data, raw, display_id=None):
            outputs.append(data["text/plain"])
            return Handle()

        with mock.patch("quicksand.progress._notebook_display", lambda: display):
            progress = Progress(quiet=False)
            for text in ("push  3 %", "push 40 %"):
                progress.show(text)
            progress.end("done")
        self.assertEqual(outputs, ["done"])


if __name__ == "__main__":
    unittest.main()
