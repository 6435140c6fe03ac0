"""Pictures that show themselves in a notebook."""
from pathlib import Path


class Picture:
    """A PNG. `data` are its bytes; Jupyter shows it, and `save` writes it to a file."""

    def __init__(self, data: bytes):
        self.data = data

    @classmethod
    def read(cls, path) -> "Picture":
        return cls(Path(path).read_bytes())

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [px]."""
        return int.from_bytes(self.data[16:20], "big"), int.from_bytes(self.data[20:24], "big")

    def save(self, path) -> Path:
        path = Path(path)
        path.write_bytes(self.data)
        return path

    def _repr_png_(self):
        return self.data

    def __repr__(self):
        return "<Picture {} x {} px>".format(*self.size)
