"""What can go wrong, by who can mend it."""


class Error(Exception):
    """The base of all errors of this module."""


class ProgramNotFound(Error):
    """There is no program to call, or it does not start."""


class InputError(Error, ValueError):
    """A scene, an option, a file or the arguments of a command are wrong.

    where:   the place, as messages say it: "scene.json: contact.frction (from --set)"
    file:    the file, if it is known
    path:    the place inside the file or the command: "contact.frction"
    message: what is wrong, and what is possible
    nearest: the valid name nearest to a mistyped one, or None
    """

    def __init__(self, message, where="", file=None, path=None, nearest=None):
        super().__init__(f"{where}: {message}" if where else message)
        self.message, self.where, self.file, self.path, self.nearest = message, where, file, path, nearest


class RunFailed(Error):
    """The simulation stopped, the disk or the memory is full.

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


def error_of(told, exit_code):
    """The exception for what the program told as JSON, or for its exit code alone if that is None."""
    if told is None:
        return RunFailed(f"the program ended with exit code {exit_code}")
    if told["kind"] == "input":
        return InputError(told["message"], told.get("where", ""), told.get("file"), told.get("path"),
                          told.get("nearest"))
    kind = ValidationFailed if told["kind"] == "validation" else RunFailed
    return kind(told["message"], told["kind"], told.get("how_to_go_on", ""))
