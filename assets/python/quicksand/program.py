"""Finds the program, calls it, and turns what it says into progress, results and exceptions."""
import functools
import json
import math
import os
import shutil
import signal
import subprocess
import threading
from pathlib import Path

from .errors import InputError, Interrupted, ProgramNotFound, error_of
from .progress import Progress

INTERRUPTED = 130  # exit code


def find_program(program=None) -> Path:
    """The program: `program`, else $QUICKSAND, else `quicksand` on the PATH, else the one in the folder of this module.

    Raises ProgramNotFound.
    """
    for origin, named in (("the argument program", program), ("QUICKSAND in the environment", os.environ.get("QUICKSAND"))):
        if named:
            found = shutil.which(os.path.expanduser(named))
            if found is None:
                raise ProgramNotFound(f"{named} is not a program ({origin})")
            return Path(found)
    found = shutil.which("quicksand")
    if found:
        return Path(found)
    # assets/python/quicksand/program.py of the sources or, below share/quicksand, of an installation.
    here = Path(__file__).resolve()
    beside = [here.parents[up] / name for up, name in ((3, "build/quicksand"), (5, "bin/quicksand"))
              if len(here.parents) > up]
    for path in beside:
        if os.access(path, os.X_OK):
            return path
    raise ProgramNotFound(
        "there is no program quicksand on the PATH, and none of: " + ", ".join(map(str, beside)) +
        "; build it with app/run.sh --version, or name it with QUICKSAND in the environment or with program=...")


def start(words, program, **pipes) -> subprocess.Popen:
    """Starts the program. It is in a process group of its own: a Ctrl-C reaches it through us, and once."""
    path = find_program(program)
    try:
        return subprocess.Popen([path, *words], process_group=0,
                                env={**os.environ, "QUICKSAND_MESSAGES": "json"}, **pipes)
    except OSError as error:
        raise ProgramNotFound(f"{path} does not start: {error.strerror}") from error


class Messages:
    """The program's standard error: lines, some of them errors as JSON, and a status line that is overwritten."""

    def __init__(self, progress):
        self.progress = progress
        self.notes = []
        self.error = None  # as JSON
        self._rest = ""

    def feed(self, text):
        *lines, self._rest = (self._rest + text).split("\n")
        for line in lines:
            self._take(line.rsplit("\r", 1)[-1].strip())
        *over, last = self._rest.rsplit("\r", 1)
        if over:
            self._rest = "\r" + last
            self.progress.show(last.strip())

    def _take(self, line):
        if line.startswith('{"error":'):
            self.error = json.loads(line)["error"]
        elif line:
            self.notes.append(line)
            self.progress.note(line)


class Outcome:
    """The result of a finished call: its standard output and its notes."""

    def __init__(self, out, notes, exit_code):
        self.out, self.notes, self.exit_code = out, notes, exit_code


def call(words, program=None, quiet=True, fine=(0,), names=None) -> Outcome:
    """Runs the program to its end. Raises the error that it reports, and Interrupted after a Ctrl-C, which it receives.

    names: as of error_of
    """
    process = start([str(word) for word in words], program, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE)
    out = []
    reader = threading.Thread(target=lambda: out.append(process.stdout.read()), daemon=True)
    reader.start()
    messages = Messages(Progress(quiet))
    try:
        interrupted = _follow(process, messages)
    except BaseException:
        process.terminate()  # it saves what it computed
        raise
    finally:
        reader.join()
        process.stdout.close()
        process.stderr.close()
        code = process.wait()
    text = out[0].decode(errors="replace")
    if interrupted or code == INTERRUPTED:
        messages.progress.end()
        raise Interrupted("interrupted")
    messages.progress.end(text.split("\n", 1)[0])
    if code not in fine or (messages.error and code):
        raise error_of(messages.error, code, names)
    return Outcome(text, messages.notes, code)


def _follow(process, messages) -> bool:
    """Reads standard error to its end; whether there was a Ctrl-C."""
    interrupted = False
    source = process.stderr.fileno()
    while True:
        try:
            while chunk := os.read(source, 1 << 16):
                messages.feed(chunk.decode(errors="replace"))
            return interrupted
        except KeyboardInterrupt:  # a second one ends the program at once
            interrupted = True
            process.send_signal(signal.SIGINT)


@functools.cache
def _units(program, _changed) -> dict:
    return json.loads(call(["list", "units"], program).out)


def units(table, program=None) -> dict:
    """Unit and meaning of the columns of a table, by name: of "series", "disks", "contacts", "walls" or "states"."""
    path = find_program(program)
    return _units(path, path.stat().st_mtime_ns)[table]


def option_words(options) -> list[str]:
    """Options of the command line by their names: no_frames=True is --no-frames, size=(640, 480) is --size 640x480."""
    words = []
    for name, value in options.items():
        if name in ("help", "version"):
            raise InputError("is for the command line only", where=name, path=name)
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
        else:
            text = "x".join(map(str, value)) if isinstance(value, (tuple, list)) else str(value)
            words.append(f"{option}={text}")
    return words


def plain(value, where=""):
    """A value as JSON accepts it, including numbers and arrays of numpy, tuples and paths.

    Raises InputError for nan and infinity, which JSON cannot represent, and names their place from `where` on.
    """
    if isinstance(value, dict):
        return {str(key): plain(item, f"{where}.{key}" if where else str(key)) for key, item in value.items()}
    if isinstance(value, (list, tuple, range)):
        return [plain(item, f"{where}[{i}]") for i, item in enumerate(value)]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return plain(value.tolist(), where)
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError(f"is {value}, must be a finite number", where=where, path=where)
    if not isinstance(value, (str, int, float, bool, type(None))):
        raise InputError(f"is {type(value).__name__}, which JSON cannot represent", where=where, path=where)
    return value


def plain_values(values, where) -> dict:
    """Values by path, as JSON accepts them; none for None. Raises InputError."""
    if not isinstance(values or {}, dict):
        raise InputError(f"is {type(values).__name__}, must be a dict of values by path", where=where, path=where)
    return plain(values or {}, where)
