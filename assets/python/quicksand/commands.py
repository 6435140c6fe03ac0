"""Methods of sessions, made from the schema that the program prints, so that both have the same commands."""
import inspect
import keyword
from typing import Any, Literal


class Reply(dict):
    """The result of a command, and the step, time [sqrt(d/g)] and hash of the world after it."""

    step: int | None
    time: float | None
    hash: str | None

    def __init__(self, answer):
        super().__init__(answer["result"])
        self.step, self.time, self.hash = (answer.get(name) for name in ("step", "time", "hash"))


_TYPES = {"number": float, "integer": int, "boolean": bool, "string": str, "object": dict, "array": list}
_FEW = 2  # arguments that may be given by position though they are optional


def methods(schema) -> dict:
    """Functions (self, ...) by the names of the commands of a session schema."""
    commands = schema["properties"]["commands"]["items"]["oneOf"]
    return {_name(one): _method(one) for one in commands}


def _name(command) -> str:
    return command["properties"]["command"]["const"]


def _python_name(argument) -> str:
    return argument + "_" if keyword.iskeyword(argument) else argument


def annotation(argument):
    """The Python type of what a schema admits."""
    if "enum" in argument:
        return Literal[tuple(argument["enum"])]
    kinds = argument.get("type", [])
    union = None
    for kind in [kinds] if isinstance(kinds, str) else kinds:
        python = _TYPES[kind]
        if kind == "array":
            python = list[annotation(argument.get("items", {}))]
        union = python if union is None else union | python
    return Any if union is None else union


def _method(command):
    name = _name(command)
    arguments = {key: value for key, value in command["properties"].items() if key != "command"}
    required = command.get("required", [])
    ordered = sorted(arguments, key=lambda key: key not in required)
    few = len(arguments) <= _FEW
    keys = {_python_name(key): key for key in ordered}
    parameters = [inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)]
    for python, key in keys.items():
        needed = key in required
        default = inspect.Parameter.empty if needed else arguments[key].get("default")
        kind = annotation(arguments[key])
        parameters.append(inspect.Parameter(
            python,
            inspect.Parameter.POSITIONAL_OR_KEYWORD if needed or few else inspect.Parameter.KEYWORD_ONLY,
            default=default,
            annotation=kind | None if default is None and kind is not Any else kind))
    signature = inspect.Signature(parameters, return_annotation=Reply)

    def method(self, /, *given, **named):
        bound = signature.bind(self, *given, **named).arguments
        del bound["self"]
        # What is absent has the program's default; None means absent unless the command takes any value.
        return self.command(name, **{keys[key]: value for key, value in bound.items()
                                     if value is not None or annotation(arguments[keys[key]]) is Any})

    method.__name__ = method.__qualname__ = name
    method.__doc__ = _docstring(command, arguments, required, keys)
    method.__signature__ = signature
    method.__annotations__ = {one.name: one.annotation for one in parameters[1:]} | {"return": Reply}
    return method


def _docstring(command, arguments, required, keys) -> str:
    text = command["properties"]["command"]["description"]
    lines = [f"{python}: {_meaning(arguments[key], key in required)}" for python, key in keys.items()]
    calls = [_call(example, keys) for example in command.get("examples", [])]
    return "\n\n".join([text, *(["\n".join(lines)] if lines else []), *calls])


def _meaning(argument, required) -> str:
    low = argument.get("minimum", argument.get("exclusiveMinimum"))
    high = argument.get("maximum")
    notes = []
    if required:
        notes.append("required")
    if low is not None and high is not None:
        notes.append(f"above {low:g}, at most {high:g}" if "exclusiveMinimum" in argument else f"{low:g} to {high:g}")
    if "enum" in argument:
        notes.append("one of " + ", ".join(map(str, argument["enum"])))
    if "default" in argument:
        notes.append(f"default {argument['default']}")
    return argument.get("description", "") + (f" ({'; '.join(notes)})" if notes else "")


def _call(example, keys) -> str:
    """An example in JSON as a call."""
    python = {key: name for name, key in keys.items()}
    words = ", ".join(f"{python.get(key, key)}={value!r}" for key, value in example.items() if key != "command")
    return f">>> session.{example['command']}({words})"


