"""The errors of this module, by who can fix them."""
import contextlib
import re


class Error(Exception):
    """The base of all errors of this module."""


class ProgramNotFound(Error):
    """The program was not found, or it does not start."""


class InputError(Error, ValueError):
    """A scene, an option, a file or the arguments of a command are wrong.

    where:   the place, as messages name it: "scene.json: contact.frction (from --set)"
    file:    the file, if it is known
    path:    the place inside the file or the command: "contact.frction"
    message: what is wrong, and what is allowed
    nearest: the valid name nearest to a mistyped one, or None
    """

    def __init__(self, message, where="", file=None, path=None, nearest=None):
        super().__init__(f"{where}: {message}" if where else message)
        self.message, self.where, self.file, self.path, self.nearest = message, where, file, path, nearest

    def of_argument(self, file, argument, names) -> "InputError":
        """The same error for a caller who gave the file's content as arguments and never saw the file."""
        place = f"{argument}: " if argument else ""
        where, message = (text.replace(f"{file}: ", place).replace(file, argument or "the arguments")
                          for text in (self.where, self.message))
        path = self.path
        for key, name in names.items():
            where, path = (text and re.sub(rf"(^|\(from ){key}\b", rf"\g<1>{name}", text) for text in (where, path))
        return InputError(message, where, None if self.file == file else self.file, path, self.nearest)


class RunFailed(Error):
    """The simulation stopped, or disk or memory is full.

    message:      why
    kind:         "run_failed", "scene", "session", "validation", "disk_full", "memory" or "unexpected"
    how_to_go_on: what the program advises, as text
    run:          what was computed, as a Run, or None
    """

    def __init__(self, message, kind="unexpected", how_to_go_on="", run=None):
        super().__init__(f"{message}\n{how_to_go_on}" if how_to_go_on else message)
        self.message, self.kind, self.how_to_go_on, self.run = message, kind, how_to_go_on, run


class ValidationFailed(RunFailed):
    """The run is complete but breaks the limits of ``strict=True``."""


class CommandFailed(Error):
    """A command of a session is well formed but failed: an expectation that does not hold, a simulation that stopped.

    command: the command as it was sent, a dict
    message: why
    """

    def __init__(self, message, command=None):
        super().__init__(message)
        self.message, self.command = message, command


class SessionEnded(Error):
    """The session was closed or its program has ended."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C: the program has saved what it computed.

    run:   the interrupted run, which ``run.resume()`` continues, or None
    state: the saved state of an interrupted session, or None
    """

    def __init__(self, message, run=None, state=None):
        super().__init__(message)
        self.run, self.state = run, state


@contextlib.contextmanager
def file_of_argument(file, argument="", names=None):
    """Errors raised inside name the argument that this file was made from, not the file, which will soon be gone.

    names: arguments whose name here differs from their key in the file
    """
    try:
        yield
    except InputError as error:
        raise error.of_argument(str(file), argument, names or {}) from None


_HELP = re.compile(r' \(see `quicksand [^`]*`\)|; did you mean "--(help|version)"\?|(?<=known: )--help, ')
_OPTION = re.compile(r"(?<![\w-])--([a-z][a-z-]*)")


def _as_keywords(text, names):
    """Options by their names here: "--no-frames" is no_frames."""
    def keyword(option):
        return names.get(option[1], option[1].replace("-", "_"))

    return text and _OPTION.sub(keyword, _HELP.sub("", text))


def error_of(told, exit_code, names=None):
    """The exception for the error that the program reported as JSON, or for its exit code alone if there is none.

    names: arguments whose name here differs from their option
    """
    if told is None:
        return RunFailed(f"the program ended with exit code {exit_code}")
    if told["kind"] == "input":
        message, where, path, nearest = (_as_keywords(told.get(key), names or {})
                                         for key in ("message", "where", "path", "nearest"))
        return InputError(message, where or "", told.get("file"), path,
                          None if nearest in ("help", "version") else nearest)
    kind = ValidationFailed if told["kind"] == "validation" else RunFailed
    return kind(told["message"], told["kind"], told.get("how_to_go_on", ""))
