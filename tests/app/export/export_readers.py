"""Reads exported files with the libraries that others will read them with, and compares every number
with the CSV files, bit by bit. Usage: export_readers.py npy|vtk|pvd|xyz, in the folder with csv/ and the
other export. Exits with 77 where the library is missing."""
import csv
import struct
import sys

TABLES = ["disks", "contacts", "walls"]


def table(name):
    with open(f"csv/{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def same(a, b):
    return struct.pack("<d", float(a)) == struct.pack("<d", float(b))


def compare(name, columns, aliases={}):
    """columns: name -> list of numbers or of vectors."""
    rows = table(name)
    seen = set()
    for column, values in columns.items():
        column = aliases.get(column, column)
        vector = column + "_x" in rows[0]
        assert len(values) == len(rows), (name, column)
        for row, value in zip(rows, values):
            texts = [row[column + "_x"], row[column + "_y"]] if vector else [row[column]]
            numbers = list(value) if vector else [value]
            for text, number in zip(texts, numbers):
                assert same(text, number), (name, column, text, number)
            assert all(number == 0 for number in numbers[2:]), (name, column)
        seen.update([column + "_x", column + "_y"] if vector else [column])
    assert seen == set(rows[0]), set(rows[0]) ^ seen
    print(name, len(rows), "rows", len(seen), "columns")


def read_npy():
    import numpy

    for name in TABLES:
        array = numpy.load(f"npy/{name}.npy", allow_pickle=False)
        compare(name, {column: array[column] for column in array.dtype.names})


def read_vtk():
    import vtk

    for name in TABLES:
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(f"vtk/{name}.vtp")
        reader.Update()
        assert reader.GetErrorCode() == 0
        data = reader.GetOutput()
        values = data.GetPointData() if name == "disks" else data.GetCellData()
        columns = {}
        for i in range(values.GetNumberOfArrays()):
            array = values.GetArray(i)
            tuples = [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]
            columns[array.GetName()] = tuples if array.GetNumberOfComponents() == 3 else [
                t[0] for t in tuples]
        points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
        if name == "disks":
            assert data.GetNumberOfVerts() == len(points)
            columns["position"] = points
        compare(name, columns)
        if name == "contacts":
            rows = table("contacts")
            disks = table("disks")
            assert data.GetNumberOfLines() == len(rows)
            for i, row in enumerate(rows):
                ids = data.GetCell(i).GetPointIds()
                start, end = (points[ids.GetId(k)] for k in (0, 1))
                disk = disks[int(row["a"])]
                assert same(start[0], disk["position_x"]) and same(start[1], disk["position_y"])
                assert same(end[0], start[0] + float(row["branch_x"]))
                assert same(end[1], start[1] + float(row["branch_y"]))
        time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
        assert same(time, table("states")[0]["time"])


def read_pvd():
    import xml.etree.ElementTree

    states = table("states")
    for name in TABLES:
        root = xml.etree.ElementTree.parse(f"vtk/{name}.pvd").getroot()
        assert root.tag == "VTKFile" and root.get("type") == "Collection"
        sets = root.findall("Collection/DataSet")
        assert len(sets) == len(states)
        for entry, state in zip(sets, states):
            assert same(entry.get("timestep"), state["time"])
            piece = xml.etree.ElementTree.parse("vtk/" + entry.get("file")).getroot()
            assert piece.get("type") == "PolyData"


def read_xyz():
    import ase.io

    frames = ase.io.read("disks.xyz", index=":", format="extxyz")
    assert len(frames) == 1
    atoms = frames[0]
    columns = {name: atoms.arrays[name] for name in atoms.arrays if name != "numbers"}
    assert list(columns.pop("body")) == list(columns["id"])
    compare("disks", columns, {"positions": "position", "velo": "velocity", "id": "disk"})
    symbols = ["I" if row["role"] == "1" else "Si" for row in table("disks")]
    assert atoms.get_chemical_symbols() == symbols
    state = table("states")[0]
    assert list(atoms.pbc) == [state["periodic"] == "1", False, False]
    assert same(atoms.cell[0][0], state["box_x"])
    assert same(atoms.info["Time"], state["time"]) and atoms.info["Step"] == int(state["step"])


try:
    {"npy": read_npy, "vtk": read_vtk, "pvd": read_pvd, "xyz": read_xyz}[sys.argv[1]]()
except ModuleNotFoundError as missing:
    print(f"{missing.name} is missing; Debian has python3-numpy, python3-ase and python3-vtk9")
    sys.exit(77)
