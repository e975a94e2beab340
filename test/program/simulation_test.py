#!/usr/bin/env python3
"""simulation_test.py PROGRAM READER: the segments of segment_mesh in the tools of simulation: groups, sets and patches
of the names and areas of the segments, on surfaces and on volume meshes by examples/pipelines/volume_mesh.geo. READER is gmsh,
calculix, meshio or openfoam, of the Debian packages gmsh with python3-gmsh, calculix-ccx,
python3-meshio and openfoam. Without it the test is skipped."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

from helpers import BLOCK, EXAMPLES, Case, area, need, run, skip


def volume_of_tetrahedra(corners):
    return numpy.linalg.det(corners[:, 1:] - corners[:, :1]).sum() / 6


def expect(found, expected, tolerance=1e-6):
    """Dictionaries of areas by name."""
    assert sorted(found) == sorted(expected), found
    numpy.testing.assert_allclose([found[name] for name in expected], list(expected.values()), rtol=tolerance)


def make_volume_mesh(case, output, *options):
    run(case.folder, "gmsh", "-3", "a.msh", EXAMPLES / "pipelines/volume_mesh.geo", *options, "-o", output)


def groups_of_gmsh(gmsh, dimension):
    """The elements of each physical group of the open model by name: the tags of their corners."""
    groups = {}
    for _, tag in gmsh.model.getPhysicalGroups(dimension):
        corners = [gmsh.model.mesh.getElements(dimension, entity)[2]
                   for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)]
        groups[gmsh.model.getPhysicalName(dimension, tag)] = numpy.concatenate(corners, axis=None).reshape(-1, dimension + 1)
    return groups


def check_gmsh(case):
    try:
        import gmsh
    except ImportError:
        skip("no python3-gmsh")
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)

    def read(name):
        gmsh.open(str(case.folder / name))
        tags, points, _ = gmsh.model.mesh.getNodes()
        point_of_tag = numpy.full((int(tags.max()) + 1, 3), numpy.nan)
        point_of_tag[tags] = points.reshape(-1, 3)
        return point_of_tag

    points = read("a.msh")
    triangles = groups_of_gmsh(gmsh, 2)
    expect({name: area(points[corners]) for name, corners in triangles.items()}, case.area_of_name)
    assert sum(map(len, triangles.values())) == sum(len(face) - 2 for face in case.faces)
    gmsh.model.mesh.createTopology()
    assert all(len(gmsh.model.getAdjacencies(1, curve)[0]) == 2 for _, curve in gmsh.model.getEntities(1))

    for options in [], ["-setnumber", "size", str(case.size)]:
        make_volume_mesh(case, "volume.msh", *options)
        points = read("volume.msh")
        triangles, tetrahedra = groups_of_gmsh(gmsh, 2), groups_of_gmsh(gmsh, 3)
        # A chord of a curved segment is shorter than its arc.
        tolerance = 0.15 if options and case.curved else 1e-6
        expect({name: area(points[corners]) for name, corners in triangles.items()}, case.area_of_name, tolerance)
        assert list(tetrahedra) == ["volume"]
        numpy.testing.assert_allclose(volume_of_tetrahedra(points[tetrahedra["volume"]]), case.volume, rtol=tolerance / 10)
        sides = numpy.sort(tetrahedra["volume"], axis=1)[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3)
        sides, counts = numpy.unique(sides, axis=0, return_counts=True)
        boundary = numpy.unique(numpy.sort(numpy.concatenate(list(triangles.values())), axis=1), axis=0)
        assert numpy.array_equal(sides[counts == 1], boundary), "the groups are not the boundary"
    gmsh.finalize()


def check_meshio(case):
    """Also the file that gmsh writes for Abaqus, where each set of elements is one of their points, too."""
    try:
        import meshio
    except ImportError:
        skip("no python3-meshio")

    mesh = meshio.read(case.folder / "a.msh")
    triangles = numpy.concatenate([block.data for block in mesh.cells])
    tags = numpy.concatenate(mesh.cell_data["gmsh:physical"])
    assert {block.type for block in mesh.cells} == {"triangle"} and all(d == 2 for _, d in mesh.field_data.values())
    expect({name: area(mesh.points[triangles[tags == tag]]) for name, (tag, _) in mesh.field_data.items()}, case.area_of_name)

    for file in "volume.msh", "part.inp":
        make_volume_mesh(case, file)
        mesh = meshio.read(case.folder / file)
        corners = {}
        for name in (*case.area_of_name, "volume"):
            parts = [block.data[members] for block, members in zip(mesh.cells, mesh.cell_sets[name]) if len(members)]
            corners[name] = numpy.concatenate(parts)
            if file == "part.inp":
                assert set(mesh.point_sets[name]) == set(corners[name].flat), name
        numpy.testing.assert_allclose(volume_of_tetrahedra(mesh.points[corners.pop("volume")]), case.volume, rtol=1e-6)
        expect({name: area(mesh.points[triangles]) for name, triangles in corners.items()}, case.area_of_name)


def check_calculix(case):
    """The block, lengthened by a tenth along each axis: each of two opposite sides has the force that strain and area give."""
    if case.curved:
        return
    make_volume_mesh(case, "part.inp", "-setnumber", "size", str(case.size))
    manual = (EXAMPLES.parent / "doc" / "Region_segmentation" / "Program.txt").read_text()
    subprocess.run(re.search(r"^awk .*part_solid.inp$", manual, re.MULTILINE)[0], shell=True, cwd=case.folder, check=True)
    points = numpy.array(case.points)
    sides = {name: points[case.faces[label]] for label, name in enumerate(case.names)} # a face each
    young = 1000
    lines = ["*INCLUDE, INPUT=part_solid.inp", "*MATERIAL, NAME=elastic", "*ELASTIC", f"{young}, 0",
             "*SOLID SECTION, ELSET=volume, MATERIAL=elastic", "*STEP", "*STATIC", "*BOUNDARY"]
    forces = {}
    for name, corners in sides.items():
        axis, = numpy.flatnonzero(numpy.ptp(corners, axis=0) == 0)
        at = corners[0, axis]
        lines.append(f"{name}, {axis + 1}, {axis + 1}, {0.1 * at}")
        force = numpy.zeros(3)
        force[axis] = 0.1 * young * case.area_of_name[name] * (1 if at == points[:, axis].max() else -1)
        forces[name] = force
    for name in sides:
        lines += [f"*NODE PRINT, NSET={name}, TOTALS=ONLY", "RF"]
    (case.folder / "run.inp").write_text("\n".join(lines + ["*END STEP", ""]))
    subprocess.run(["ccx", "run"], cwd=case.folder, check=True, stdout=subprocess.DEVNULL)
    report = (case.folder / "run.dat").read_text()
    for name, force in forces.items():
        numbers = re.search(rf"for set {name.upper()} .*\n\s*\n(.*)\n", report)[1]
        axis = abs(force).argmax()
        numpy.testing.assert_allclose(float(numbers.split()[axis]), force[axis], rtol=1e-4)


def check_openfoam(case):
    case.write("a.stl")
    report = subprocess.run(["surfaceCheck", "-checkSelfIntersection", "a.stl"], cwd=case.folder, capture_output=True, text=True,
                            env={"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ})
    assert report.returncode == 0, report.stderr
    table = re.search(r"^Region\tSize\n-+\t-+\n(.+?)\n\n", report.stdout, re.MULTILINE | re.DOTALL)[1]
    triangles = dict.fromkeys(case.area_of_name, 0)
    for face, label in zip(case.faces, case.labels):
        triangles[case.names[label]] += len(face) - 2
    assert [line.split("\t") for line in table.split("\n")] == [[name, str(n)] for name, n in triangles.items()], table
    for line in "no illegal triangles", "Surface is closed", "not self-intersecting":
        assert line in report.stdout, report.stdout


def main(program, reader):
    check = {"gmsh": check_gmsh, "calculix": check_calculix, "meshio": check_meshio, "openfoam": check_openfoam}[reader]
    need(*{"openfoam": ["surfaceCheck"], "calculix": ["ccx", "gmsh"]}.get(reader, ["gmsh"]))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "block.off").write_text(BLOCK)
        part = ["--method", "smooth-faces"]
        for mesh, options, size in (("block.off", part, 0.5), (EXAMPLES / "data/flange.off", part, 8), ("--demo", [], 0.05)):
            case = Case(program, folder, mesh, options)
            case.curved, case.size = mesh != "block.off", size
            case.write("a.msh")
            check(case)


if __name__ == "__main__":
    main(*sys.argv[1:])
