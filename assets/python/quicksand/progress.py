"""The progress line of a computation, in a terminal and in a notebook."""
import sys


def _notebook_display():
    """The display of IPython, if this is a kernel of Jupyter."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython.display import display

    return display


class Progress:
    """Shows nothing if `quiet`, or if there is neither a terminal nor a notebook."""

    def __init__(self, quiet):
        self._display = None if quiet else _notebook_display()
        self._terminal = not quiet and self._display is None and sys.stderr is not None and sys.stderr.isatty()
        self._handle = None  # of the notebook's output
        self._width = 0  # of the terminal's line

    def show(self, text):
        if not text:
            return
        if self._display:
            if self._handle is None:
                self._handle = self._display({"text/plain": text}, raw=True, display_id=True)
            else:
                self._handle.update({"text/plain": text}, raw=True)
        elif self._terminal:
            sys.stderr.write("\r" + text.ljust(self._width))
            sys.stderr.flush()
            self._width = len(text)

    def note(self, text):
        if self._display:
            self._display({"text/plain": text}, raw=True)
        elif self._terminal:
            self._wipe()
            sys.stderr.write(text + "\n")

    def end(self, last=""):
        """A notebook keeps the last line, a terminal keeps nothing."""
        if self._handle is not None and last:
            self._handle.update({"text/plain": last}, raw=True)
        self._wipe()

    def _wipe(self):
        if self._width:
            sys.stderr.write("\r" + " " * self._width + "\r")
            self._width = 0
