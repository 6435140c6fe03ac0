"""Tables as the program writes them (CSV): columns by name."""
import csv
import difflib
import html
import math
from collections.abc import Mapping

try:
    import numpy
except ImportError:  # columns are lists then
    numpy = None


def _whole(text):
    number = int(text)
    if str(number) != text:  # 00012 is a name
        raise ValueError
    return number


def _real(text):
    if "_" in text or (text[:1] == "0" and text[1:2].isdigit()):  # a name, too
        raise ValueError
    return float(text) if text else math.nan


_TRUTHS = {"true": True, "false": False, "": None}


def _values(texts):
    """The column's whole numbers, numbers (nan where a row has none), truth values (None where a row has none) or texts."""
    for read in (_whole, _real, _TRUTHS.__getitem__):
        try:
            return [read(text) for text in texts]
        except (ValueError, KeyError):
            pass
    return list(texts)


def column(values):
    """An array of numpy or, without it, a list."""
    return list(values) if numpy is None else numpy.array(values)


class Table(Mapping):
    """Columns by name, each an array of numpy (a list without numpy); missing values are nan, or None in
    columns of true and false.

    `table["depth"]` is a column, `table.rows()` a list of dicts, `table.frame()` a frame of pandas, and
    `table.label("depth")` the label of an axis.
    """

    def __init__(self, columns, units=None):
        self._columns = {name: column(values) for name, values in columns.items()}
        self._units = units or {}

    @classmethod
    def read(cls, path, units=None) -> "Table":
        """Reads a CSV file with a header. An incomplete last line, of a run that is still computing, is left out."""
        with open(path, newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file)
        rows = [row for row in rows if len(row) == len(names)]
        columns = zip(*rows) if rows else [[] for _ in names]
        return cls({name: _values(texts) for name, texts in zip(names, columns)}, units)

    def __getitem__(self, name):
        try:
            return self._columns[name]
        except KeyError:
            near = difflib.get_close_matches(str(name), self, 1)
            raise KeyError(f"{name} is not a column" + (f"; did you mean {near[0]}?" if near else "")) from None

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    @property
    def height(self) -> int:
        """The number of rows."""
        return len(next(iter(self._columns.values()), []))

    def rows(self) -> list[dict]:
        """Each row as a dict of plain numbers and texts."""
        plain = [values if isinstance(values, list) else values.tolist() for values in self._columns.values()]
        return [dict(zip(self._columns, row)) for row in zip(*plain)]

    def label(self, name) -> str:
        """The name with its unit: "depth [d]"."""
        self[name]  # tells a misspelt one
        unit = self._units.get(name.removesuffix("_error"), {}).get("unit", "1")
        return name if unit == "1" else f"{name} [{unit}]"

    def frame(self):
        """A frame of pandas. Raises ImportError without pandas."""
        import pandas

        return pandas.DataFrame(self._columns)

    def _ipython_key_completions_(self):
        return list(self._columns)

    def __repr__(self):
        return f"<Table {self.height} rows: {', '.join(self._columns)}>"

    def _repr_html_(self, most=10):
        rows = self.rows()
        shown = rows if len(rows) <= most else rows[: most // 2] + rows[-(most // 2):]
        cells = ["".join(f"<td>{html.escape(text_of(value))}</td>" for value in row.values()) for row in shown]
        if shown is not rows:
            cells.insert(most // 2, f"<td colspan={len(self)}>... {len(rows) - len(shown)} rows ...</td>")
        head = "".join(f"<th>{html.escape(name)}</th>" for name in self)
        return f"<table><tr>{head}</tr>" + "".join(f"<tr>{cell}</tr>" for cell in cells) + "</table>"


def text_of(value) -> str:
    """A value as text for a table."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    return f"{value:.6g}" if isinstance(value, float) else str(value)
