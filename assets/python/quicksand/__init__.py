"""quicksand from Python: runs, sessions and campaigns of cohesive grain packings.

    import quicksand

    run = quicksand.run("collapse", set={"contact.cohesion_force": 5000})
    run.series["depth"]

The module calls the program ``quicksand`` and reads what it writes. It needs nothing but Python; with numpy,
columns are arrays, and with pandas, tables become frames.
"""
from .campaigns import Campaign, campaign
from .commands import Reply
from .errors import (CommandFailed, Error, InputError, Interrupted, ProgramNotFound, RunFailed, SessionEnded,
                     ValidationFailed)
from .history import History, Sample
from .picture import Picture
from .program import find_program
from .runs import Run, run
from .sessions import Session
from .state import State
from .table import Table

__all__ = [
    "Campaign", "CommandFailed", "Error", "History", "InputError", "Interrupted", "Picture", "ProgramNotFound", "Reply",
    "Run", "RunFailed", "Sample", "Session", "SessionEnded", "State", "Table", "ValidationFailed", "campaign",
    "find_program", "run",
]
