#!/usr/bin/env python3
"""vtk_test.py PROGRAM: what segment_mesh writes for ParaView, read by VTK. Needs Debian's python3-vtk9; without it the test
is skipped."""

import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOGeometry import vtkOBJReader
except ImportError:
    print("skipped: no python3-vtk9")
    sys.exit(SKIPPED)


def read(reader, file):
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def array(data, name, components=1):
    values = data.GetCellData().GetArray(name)
    assert values is not None, f"no array {name}"
    assert values.GetNumberOfComponents() == components
    return [values.GetTuple(i) for i in range(values.GetNumberOfTuples())]


def check(program, folder):
    subprocess.run([program, "--demo", "-q", "-o", "a.off", "-o", "a.seg", "-o", "a.vtp", "-o", "a.ply", "--borders",
                    "b.vtp", "--borders", "b.obj"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    labels = [int(x) for x in (folder / "a.seg").read_text().split()]
    off = (folder / "a.off").read_text().split("\n")
    number_of_points = int(off[1].split()[0])
    points = [tuple(map(float, line.split())) for line in off[2:2 + number_of_points]]
    faces = [tuple(map(int, line.split())) for line in off[2 + number_of_points:] if line]

    mesh = read(vtkXMLPolyDataReader(), folder / "a.vtp")
    assert mesh.GetNumberOfPolys() == len(faces) == mesh.GetNumberOfCells()
    assert [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())] == points
    for i, face in enumerate(faces):
        ids = mesh.GetCell(i).GetPointIds()
        assert tuple(ids.GetId(c) for c in range(ids.GetNumberOfIds())) == face[1:4]
    assert [int(x) for x, in array(mesh, "segment")] == labels
    assert [tuple(map(int, c)) for c in array(mesh, "color", 3)] == [face[4:7] for face in faces]

    ply = read(vtkPLYReader(), folder / "a.ply")
    assert ply.GetNumberOfPolys() == len(faces)
    assert [tuple(map(int, c)) for c in array(ply, "RGB", 3)] == [face[4:7] for face in faces]

    # Every border edge is one of faces of both segments, and none is missing.
    sides = {}
    for face, label in zip(faces, labels):
        for i in range(3):
            sides[face[1 + i], face[1 + (i + 1) % 3]] = label
    expected = {(a, b) for (a, b), label in sides.items() if sides[b, a] != label}
    borders = read(vtkXMLPolyDataReader(), folder / "b.vtp")
    left, right = array(borders, "left_segment"), array(borders, "right_segment")
    found = set()
    for i in range(borders.GetNumberOfLines()):
        ids = borders.GetCell(i).GetPointIds()
        line = [ids.GetId(c) for c in range(ids.GetNumberOfIds())]
        for a, b in zip(line, line[1:]):
            assert (sides[a, b], sides[b, a]) == (left[i][0], right[i][0])
            found |= {(a, b), (b, a)}
    assert found == expected and found
    assert read(vtkOBJReader(), folder / "b.obj").GetNumberOfLines() == borders.GetNumberOfLines()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        check(sys.argv[1], pathlib.Path(name))
