#!/usr/bin/env python3
"""outputs_test.py PROGRAM READER: what segment_mesh writes, read by another program: as many parts as segments, with the areas
that they have by the .seg file and the mesh. READER is assimp, vtk, prusa-slicer, painted (by prusa-slicer) or step (by
gmsh), of the Debian packages assimp-utils, python3-vtk9, prusa-slicer and python3-gmsh, or tables, Python's. Without
it, or where the program was built without a format, the test is skipped."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile
from xml.etree import ElementTree

import numpy

from helpers import BLOCK, EXAMPLES, Case, area, meshes_of_glb, need, rows_of, skip


def check_assimp(case):
    case.write("a.obj", "a.glb", "a.stl", "a.3mf", "a.ply")
    for kind in "obj", "glb", "stl", "3mf", "ply", "off":
        mesh = "mesh.off" if kind == "off" else f"a.{kind}"
        subprocess.run(["assimp", "export", mesh, f"{kind}_back.glb", "-fglb2"], cwd=case.folder, check=True,
                       stdout=subprocess.DEVNULL)
        parts = list(meshes_of_glb(case.folder / f"{kind}_back.glb"))
        areas = [area(attributes["POSITION"]) for _, attributes, _ in parts]
        if kind in ("ply", "off"): # which have one mesh
            numpy.testing.assert_allclose(areas, [sum(case.areas)], rtol=1e-6)
            continue
        case.expect(areas)
        if kind == "3mf": # whose names assimp 5.2 does not read
            continue
        assert [name for name, _, _ in parts] == case.names, kind
        if kind != "stl":
            assert [material["name"] for _, _, material in parts] == case.names
            colors = [material["pbrMetallicRoughness"]["baseColorFactor"] for _, _, material in parts]
            assert len(set(map(tuple, colors))) == len(parts), colors
    for _, attributes, _ in meshes_of_glb(case.folder / "a.glb"):
        a, b, c = attributes["POSITION"].transpose(1, 0, 2)
        flat = numpy.cross(b - a, c - a)
        flat /= numpy.linalg.norm(flat, axis=1)[:, None]
        numpy.testing.assert_allclose(numpy.linalg.norm(attributes["NORMAL"], axis=2), 1, atol=1e-6)
        cosines = numpy.einsum("tcx,tx->tc", attributes["NORMAL"], flat)
        assert cosines.min() > 0.6, "smooth where the mesh is sharp"
        assert cosines.min() < 0.999 or len(case.faces) < 100, "flat where the mesh is smooth"


def check_vtk(case):
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
        from vtkmodules.vtkIOPLY import vtkPLYReader
        from vtkmodules.vtkIOGeometry import vtkOBJReader
    except ImportError:
        skip("no python3-vtk9")

    def read(reader, name):
        reader.SetFileName(str(case.folder / name))
        reader.Update()
        data = reader.GetOutput()
        cells = []
        for i in range(data.GetNumberOfCells()):
            ids = data.GetCell(i).GetPointIds() # valid until the next cell
            cells.append([ids.GetId(c) for c in range(ids.GetNumberOfIds())])
        return data, [data.GetPoint(i) for i in range(data.GetNumberOfPoints())], cells

    def array(data, name):
        values = data.GetCellData().GetArray(name)
        return [tuple(map(int, values.GetTuple(i))) for i in range(values.GetNumberOfTuples())]

    case.write("a.vtp", "a.ply", options=["--borders", "b.obj"])
    data, points, faces = read(vtkXMLPolyDataReader(), "a.vtp")
    assert (points, faces) == (case.points, case.faces)
    assert array(data, "segment") == [(label,) for label in case.labels]
    assert array(data, "color") == case.colors
    data, points, faces = read(vtkPLYReader(), "a.ply")
    assert array(data, "RGB") == case.colors
    label_of_color = dict(zip(case.colors, case.labels))
    case.expect(case.areas_by(points, faces, [label_of_color[color] for color in array(data, "RGB")]))

    # Every border edge is one of faces of both segments, and none is missing; there are no other points.
    sides = {}
    for face, label in zip(case.faces, case.labels):
        for a, b in zip(face, face[1:] + face[:1]):
            sides[case.points[a], case.points[b]] = label
    expected = {(a, b) for (a, b), label in sides.items() if sides[b, a] != label}
    statements = [line.split() for line in (case.folder / "b.obj").read_text().splitlines()]
    points = [tuple(map(float, words[1:])) for words in statements if words[0] == "v"]
    lines = [[int(i) - 1 for i in words[1:]] for words in statements if words[0] == "l"]
    names = [words[1] for words in statements if words[0] == "g"]
    found = set()
    for line, name in zip(lines, names, strict=True):
        for a, b in zip(line, line[1:]):
            a, b = points[a], points[b]
            assert name == f"border_{sides[a, b]}_{sides[b, a]}"
            found |= {(a, b), (b, a)}
    assert found == expected and found
    assert sorted(points) == sorted({a for a, _ in found})
    data, points_of_obj, lines_of_obj = read(vtkOBJReader(), "b.obj")
    assert lines_of_obj == lines
    numpy.testing.assert_allclose(points_of_obj, points, rtol=1e-6)


def run_slicer(case, *arguments):
    return subprocess.run(["prusa-slicer", *arguments], cwd=case.folder, check=True, capture_output=True, text=True).stdout


def check_slicer(case):
    case.write("a.stl", "a.3mf")
    for kind in "stl", "3mf":
        run_slicer(case, "--export-stl", "--dont-arrange", "--no-ensure-on-bed", "-o", f"{kind}_back.stl", f"a.{kind}")
        data = (case.folder / f"{kind}_back.stl").read_bytes()
        corners = numpy.frombuffer(data[84:], [("normal", "<3f4"), ("corners", "<9f4"), ("attribute", "<u2")])["corners"]
        numpy.testing.assert_allclose(area(corners.reshape(-1, 3, 3)), sum(case.areas), rtol=1e-6)
    assert run_slicer(case, "--info", "a.3mf").count("number_of_facets") == len(case.areas)

    case.write("a.stl", "a.3mf", "part_{segment}.stl", options=["--solids"])
    for names in ["a.stl"], ["a.3mf"], [f"part_{i}.stl" for i in range(len(case.areas))]:
        info = "".join(run_slicer(case, "--info", name) for name in names)
        values = {name: re.findall(rf"^{name} = +(\S+)", info, re.MULTILINE)
                  for name in ("manifold", "number_of_parts", "volume")}
        assert set(values["manifold"]) == {"yes"}, info
        assert sum(map(int, values["number_of_parts"])) == len(case.areas), info
        numpy.testing.assert_allclose(sum(map(float, values["volume"])), case.volume, rtol=1e-4)


def check_painted(case):
    """The extruder of each triangle, as the slicer keeps it."""
    case.write("painted.3mf", options=["--painted"])
    run_slicer(case, "--export-3mf", "--dont-arrange", "--no-ensure-on-bed", "-o", "back.3mf", "painted.3mf")
    with zipfile.ZipFile(case.folder / "back.3mf") as archive:
        model = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
    points = numpy.array([[vertex.get(axis) for axis in "xyz"] for vertex in model.findall(".//{*}vertex")], dtype=float)
    triangles = model.findall(".//{*}triangle")
    corners = numpy.array([[triangle.get(corner) for corner in ("v1", "v2", "v3")] for triangle in triangles], dtype=int)
    code, = (name for name in triangles[0].keys() if name.endswith("}mmu_segmentation"))
    # Hexadecimal digits, the last one first: four times the extruder, or 12 and then the extruder less 3.
    extruder_of_code = {"4": 1, "8": 2, **{f"{i - 3:X}C": i for i in range(3, 16)}}
    extruders = numpy.array([extruder_of_code[triangle.get(code)] for triangle in triangles])
    label_of_side = {side: label for face, label in zip(case.faces, case.labels) for side in zip(face, face[1:] + face[:1])}
    original = numpy.linalg.norm(points[:, None] - numpy.array(case.points), axis=2).argmin(axis=1) # rounded by the slicer
    for (a, b, c), extruder in zip(original[corners], extruders, strict=True):
        labels = {label_of_side[side] for side in ((a, b), (b, c), (c, a)) if side in label_of_side}
        assert {label % 15 + 1 for label in labels} == {extruder}


def check_tables(case):
    """The table says what the labels and the JSON file say."""
    case.write("a.csv", "a.json")
    rows, segments = rows_of(case.folder / "a.csv"), json.loads((case.folder / "a.json").read_text())["segments"]
    assert [row["segment"] for row in rows] == [str(i) for i in range(len(case.areas))]
    assert [int(row["faces"]) for row in rows] == list(numpy.bincount(case.labels))
    case.expect([float(row["area"]) for row in rows])
    for row, segment in zip(rows, segments, strict=True):
        surface = segment["primitive"]
        expected = {**surface, **segment, "primitive": surface["type"], "smooth_neighbors": " ".join(
            str(n["segment"]) for n in segment["neighbors"] if n.get("border") == "smooth"),
            "neighbors": " ".join(str(n["segment"]) for n in segment["neighbors"])}
        expected["lowest"], expected["highest"] = surface.get("extent", (None, None))
        for name in "point", "direction", "centroid":
            expected.update((f"{name}_{axis}", x) for axis, x in zip("xyz", expected.get(name) or ()))
        expected.update((f"extent_{i + 1}", x) for i, x in enumerate(segment["extents"]))
        for name in row.keys() - {"segment", "area_share"}:
            value = expected.get(name)
            value = "" if value is None else int(value) if isinstance(value, bool) else value
            assert row[name] == value or float(row[name]) == float(value), (name, row[name], value)


def check_step(case):
    """One solid of the volume of the mesh, of a block of its six faces; two of blocks that touch, one with a void. A block without
    a face is none, and nothing is written."""
    try:
        import gmsh
    except ImportError:
        skip("no python3-gmsh")
    case.write("a.step")
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    (_, solid), = gmsh.model.occ.importShapes(str(case.folder / "a.step"))
    gmsh.model.occ.synchronize()
    is_block = len(case.faces) == 6
    numpy.testing.assert_allclose(gmsh.model.occ.getMass(3, solid), case.volume, rtol=1e-9 if is_block else 0.01)
    if is_block:
        faces = sorted(gmsh.model.occ.getMass(2, face) for _, face in gmsh.model.getEntities(2))
        numpy.testing.assert_allclose(faces, [2, 2, 3, 3, 6, 6], rtol=1e-9)

    lines = [line.split() for line in BLOCK.splitlines()]
    corners, quads = numpy.array(lines[2:10], float), numpy.array(lines[10:16], int)[:, 1:]
    points = numpy.concatenate([corners, corners + [2, 0, 0], corners / 4 + [1, 0.5, 1]])
    faces = [[4, *quad] for quad in (*quads, *(quads + 8), *(quads + 16)[:, ::-1])]
    with open(case.folder / "bodies.off", "w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        numpy.savetxt(file, points)
        numpy.savetxt(file, faces, "%d")
    subprocess.run([case.command[0], "bodies.off", "-q", "-o", "bodies.step"], cwd=case.folder, check=True)
    gmsh.clear()
    solids = gmsh.model.occ.importShapes(str(case.folder / "bodies.step"))
    numpy.testing.assert_allclose(sorted(gmsh.model.occ.getMass(*solid) for solid in solids), [6 - 6 / 64, 6], rtol=1e-9)
    gmsh.finalize()

    (case.folder / "open.off").write_text(BLOCK.replace("8 6 0", "8 5 0").replace("4 3 0 4 7\n", ""))
    outcome = subprocess.run([case.command[0], "open.off", "-o", "b.step"], cwd=case.folder, capture_output=True, text=True)
    assert outcome.returncode == 1 and "b.step: no solid: " in outcome.stderr and "open" in outcome.stderr, outcome
    assert not (case.folder / "b.step").exists()
    outcome = subprocess.run([case.command[0], "block.off", "-o", "b.step"], cwd=case.folder, capture_output=True, text=True,
                             env={**os.environ, "PATH": "/usr/bin:/bin"})
    assert outcome.returncode == 1 and "mesh_to_step: not found (an example" in outcome.stderr, outcome
    for arguments in ["block.off"], ["c.step", "--report", "block.off"], ["c.step", "--report", "c.step"]:
        outcome = subprocess.run(["mesh_to_step", "block.off", *arguments], cwd=case.folder, capture_output=True, text=True)
        assert outcome.returncode == 1 and "would replace" in outcome.stderr, outcome
    assert (case.folder / "block.off").read_text() == BLOCK and not (case.folder / "c.step").exists()


def main(program, reader):
    need(*{"assimp": ["assimp"], "prusa-slicer": ["prusa-slicer"], "painted": ["prusa-slicer"]}.get(reader, []))
    check = {"assimp": check_assimp, "vtk": check_vtk, "prusa-slicer": check_slicer, "painted": check_painted,
             "tables": check_tables, "step": check_step}[reader]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "block.off").write_text(BLOCK)
        if reader == "painted":
            check(Case(program, folder, "--demo", ["-k", "20"])) # more segments than extruders
        if reader in ("tables", "step"):
            check(Case(program, folder, EXAMPLES / "data/flange.off", ["--method", "smooth-faces"]))
        if reader != "step": # the figure has faces that are not made
            check(Case(program, folder, "--demo", []))
        check(Case(program, folder, "block.off", ["--method", "smooth-faces"]))
        check(Case(program, folder, "block.off", ["-k", "2"])) # sharp edges inside segments


if __name__ == "__main__":
    main(*sys.argv[1:])
