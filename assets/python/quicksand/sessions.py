"""A simulation steered while it runs, over the program's live connection."""
import json
import shutil
import signal
import subprocess
import tempfile
from functools import cache
from pathlib import Path

from .commands import Reply, methods
from .errors import CommandFailed, InputError, Interrupted, SessionEnded, error_of
from .picture import Picture
from .program import INTERRUPTED, Messages, call, find_program, option_words, plain, start
from .progress import Progress
from .state import State


@cache
def _with_commands(base, program, _changed):
    schema = json.loads(call(["list", "session_schema"], program).out)
    added = {name: method for name, method in methods(schema).items() if not hasattr(base, name)}
    for method in added.values():
        method.__qualname__ = f"Session.{method.__name__}"
    return type(base.__name__, (base,), {**added, "__module__": base.__module__, "__doc__": base.__doc__})


class Session:
    """A session with the program. Each command of `quicksand list commands` is a method:

        with quicksand.Session() as session:
            session.load("collapse")
            session.run(phase_end=True)
            print(session.measure("coordination"))
            session.picture()

    out:     the folder that receives files; by default one that is removed when the session closes
    options: the other options of `quicksand session`: threads=1

    A method returns a Reply: a dict, with the attributes step, time and hash. It raises InputError for wrong
    arguments and CommandFailed for what could not be done; the session continues after both. Ctrl-C ends the session:
    it raises Interrupted, whose `state` is what the program has saved.
    """

    def __new__(cls, *_, program=None, **__):
        path = find_program(program)
        return super().__new__(_with_commands(cls, path, path.stat().st_mtime_ns))

    def __init__(self, out=None, *, program=None, **options):
        self.last: Reply | None = None
        self._program = program
        self._sent = 0
        self._pictures = 0
        self._temporary = out is None
        self.folder = Path(tempfile.mkdtemp(prefix="quicksand-") if out is None else out)
        self._errors = tempfile.TemporaryFile()
        self._process = start(["session", "-", f"--out={self.folder}", *option_words(options)], program, text=True,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors)

    def command(self, command, /, **arguments) -> Reply:
        """Sends a command by its name; the methods of the session do the same."""
        if self._process is None:
            raise SessionEnded("the session is closed")
        try:
            message = {"command": command, **plain(arguments)}
        except InputError as error:
            raise InputError(error.message, f"{command}: {error.where}", path=error.path) from None
        self._sent += 1
        try:
            answer = self._ask({**message, "id": self._sent})
        except KeyboardInterrupt:
            self._interrupt()
        if answer["ok"]:
            self.last = Reply(answer)
            return self.last
        if "where" in answer:
            # The place inside the command, without the word that stands for it.
            where = answer["where"].removeprefix("command").lstrip(".")
            file = answer.get("file")
            raise InputError(answer["error"], f"{command}: {where}" if where else command, file,
                             answer.get("path") if file else where or None, answer.get("nearest"))
        raise CommandFailed(answer["error"], message)

    def _ask(self, message) -> dict:
        try:
            self._process.stdin.write(json.dumps(message) + "\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            self._ended()
        return json.loads(line)

    def _interrupt(self):
        self._process.send_signal(signal.SIGINT)
        self._ended()

    def _ended(self):
        """The program has ended by itself: says why."""
        process = self._process
        self._leave()
        code = process.returncode
        self._errors.seek(0)
        messages = Messages(Progress(quiet=True))
        messages.feed(self._errors.read().decode(errors="replace"))
        state = self.folder / "interrupted.cbor"
        if code == INTERRUPTED:
            self._temporary = False
            raise Interrupted(messages.notes[-1] if messages.notes else "interrupted",
                              state=State(state, self._program) if state.exists() else None)
        if messages.error:
            raise error_of(messages.error, code)
        raise SessionEnded(f"the program has ended with exit code {code}: {' '.join(messages.notes)}")

    def picture(self, **arguments) -> Picture:
        """A picture of the current moment, as `view` and `camera` set it; arguments: those of `snapshot`, without file."""
        self._pictures += 1
        file = f"picture_{self._pictures}.png"
        self.command("snapshot", file=file, **arguments)
        return Picture.read(self.folder / file)

    def state(self) -> State:
        """The current state with its tables of disks, contacts and walls."""
        self._pictures += 1
        file = f"state_{self._pictures}.cbor"
        self.command("save", file=file)
        state = State(self.folder / file, self._program)
        state.about  # reads the tables while the file is there
        return state

    def _leave(self):
        """Closes the connection, and waits until the program has ended."""
        process, self._process = self._process, None
        if process is None:
            return
        with process.stdout:
            try:
                process.stdin.close()
            except BrokenPipeError:
                pass
            process.stdout.read()
            process.wait()

    def close(self):
        """Ends the program, and removes the folder if it is a temporary one."""
        self._leave()
        self._errors.close()
        if self._temporary:
            shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __repr__(self):
        return f"<Session in {self.folder}{', closed' if self._process is None else ''}>"
