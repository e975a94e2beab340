#!/usr/bin/env python3
"""generated_meshes_test.py PROGRAM: meshes as generators leave them, which are not manifold, not
connected, or not closed, through the methods and outputs of segment_mesh. Each has a label for each face, and as many groups, parts
and solids as segments; most of what is one part by construction has one label."""

import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

import numpy

from helpers import area, fan, meshes_of_glb, skip, write_off

# Of a dumbbell: a ball at each end of the x axis, joined by a stick.
BALLS, RADIUS, STICK = numpy.array([[-2, 0, 0], [2, 0, 0]]), 1, 0.35


def part_of_dumbbell(points):
    """0 and 1: the balls; 2: the stick."""
    distances = numpy.linalg.norm(points[..., None, :] - BALLS, axis=-1)
    return numpy.where(distances.min(axis=-1) < 1.2 * RADIUS, distances.argmin(axis=-1), 2)


def sphere(center, radius, n=24):
    """Of quadrangles, and of triangles at the poles on the x axis."""
    latitudes, longitudes = numpy.pi * numpy.arange(1, n) / n, 2 * numpy.pi * numpy.arange(2 * n) / (2 * n)
    u, v = (a.ravel() for a in numpy.meshgrid(latitudes, longitudes, indexing="ij"))
    points = numpy.stack([numpy.cos(u), numpy.sin(u) * numpy.cos(v), numpy.sin(u) * numpy.sin(v)], axis=1)
    return numpy.concatenate([points, [[1, 0, 0], [-1, 0, 0]]]) * radius + center, tube_faces(n - 1, 2 * n)


def cylinder(radius, half_length, rows=20, n=24):
    """Around the x axis, closed by triangles."""
    x, v = (a.ravel() for a in numpy.meshgrid(numpy.linspace(half_length, -half_length, rows),
                                              2 * numpy.pi * numpy.arange(n) / n, indexing="ij"))
    points = numpy.stack([x, radius * numpy.cos(v), radius * numpy.sin(v)], axis=1)
    return numpy.concatenate([points, [[half_length, 0, 0], [-half_length, 0, 0]]]), tube_faces(rows, n)


def tube_faces(rows, n):
    """Between rows of n points around the x axis, with decreasing x, and two poles after them."""
    first, last = rows * n, rows * n + 1
    faces = [[i * n + j, (i + 1) * n + j, (i + 1) * n + (j + 1) % n, i * n + (j + 1) % n] for i in range(rows - 1) for j in range(n)]
    faces += [[first, j, (j + 1) % n] for j in range(n)]
    return faces + [[last, (rows - 1) * n + (j + 1) % n, (rows - 1) * n + j] for j in range(n)]


def grid(nx, ny, origin, along, across):
    points = [numpy.add(origin, numpy.multiply(along, i / nx) + numpy.multiply(across, j / ny))
              for i in range(nx + 1) for j in range(ny + 1)]
    return numpy.array(points), [[i * (ny + 1) + j, (i + 1) * (ny + 1) + j, (i + 1) * (ny + 1) + j + 1, i * (ny + 1) + j + 1]
                                 for i in range(nx) for j in range(ny)]


def join(*meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [[i + sum(map(len, points)) for i in face] for face in f]
        points.append(p)
    return numpy.concatenate(points), faces


def bodies():
    return [sphere(BALLS[0], RADIUS), sphere(BALLS[1], RADIUS), cylinder(STICK, 1.5)]


def indices(meshes):
    """Of the mesh that each face of their join is of."""
    return numpy.repeat(numpy.arange(len(meshes)), [len(faces) for _, faces in meshes])


def by_place(mesh):
    return part_of_dumbbell(numpy.array([mesh[0][face].mean(axis=0) for face in mesh[1]]))


def isosurface(field, spacing, origin):
    """Of the value 0, below which it is inside: by marching cubes."""
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
        from vtkmodules.vtkCommonDataModel import vtkImageData
        from vtkmodules.vtkFiltersCore import vtkMarchingCubes
    except ImportError:
        skip("no python3-vtk9")
    image = vtkImageData()
    image.SetDimensions(field.shape)
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(numpy_to_vtk(-field.ravel(order="F")))
    marching = vtkMarchingCubes()
    marching.SetInputData(image)
    marching.SetValue(0, 0)
    marching.ComputeNormalsOff()
    marching.Update()
    surface = marching.GetOutput()
    faces = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float), faces.tolist()


def lattice(n):
    """Of points around the dumbbell, n in a unit: an array of them by x, y and z."""
    return numpy.stack(numpy.meshgrid(*(numpy.arange(-a * n, a * n + 1) / n for a in (3.25, 1.25, 1.25)), indexing="ij"), axis=-1)


def dumbbell_field(points):
    """The signed distance, nearly."""
    balls = numpy.linalg.norm(points[..., None, :] - BALLS, axis=-1).min(axis=-1) - RADIUS
    stick = numpy.maximum(numpy.linalg.norm(points[..., 1:], axis=-1) - STICK, abs(points[..., 0]) - 2)
    return numpy.minimum(balls, stick)


def voxels(inside, size):
    """The sides of cubes at these points, whose corners they share: edges of four faces and vertices where cubes touch."""
    index, faces = {}, []
    full = set(map(tuple, numpy.argwhere(inside)))
    for cube in sorted(full):
        for axis in range(3):
            for side in 0, 1:
                if tuple(numpy.add(cube, numpy.eye(3, dtype=int)[axis] * (2 * side - 1))) in full:
                    continue
                square = [numpy.roll([side, a, b], axis) + cube for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                corners = [index.setdefault(tuple(corner), len(index)) for corner in square]
                faces.append(corners if side else corners[::-1])
    return (numpy.array(list(index)) - numpy.array(inside.shape) / 2) * size, faces


def make_meshes():
    """The meshes by name; of each the part of each face, -1 where it does not matter, the options by which parts are found, and
    the least share of the area of a part in one segment, if it is not .7."""
    random = numpy.random.default_rng(7)
    dumbbell = join(*bodies())
    body = indices(bodies())
    yield "bodies that overlap", dumbbell, body, ["-k", "3"]

    # Without a number, since each fragment that floats counts as a part.
    n = 12
    field, noise = dumbbell_field(lattice(n)), random.standard_normal(lattice(n).shape[:3])
    mesh = voxels(field + 0.06 * noise < 0, 1 / n)
    yield "voxels", mesh, by_place(mesh), []
    mesh = isosurface(field + 0.02 * noise, 1 / n, lattice(n)[0, 0, 0])
    yield "marching cubes with noise", mesh, by_place(mesh), ["-k", "3"]
    mesh = isosurface(field + 0.13 * noise, 1 / n, lattice(n)[0, 0, 0])
    yield "fragments that float", mesh, by_place(mesh), [], 0.4 # of the area of the bar, which is divided in two

    points, faces = dumbbell
    again = random.choice(len(faces), len(faces) // 5, replace=False)
    mesh = points, faces + [faces[i][::random.choice([-1, 1])] for i in again]
    yield "faces that are there twice", mesh, numpy.concatenate([body, body[again]]), ["-k", "3"]
    shells = [*bodies(), sphere(BALLS[0], 0.8), sphere(BALLS[1], 0.6)]
    points, faces = join(*shells)
    yield "inside out", (points, [face[::-1] for face in faces]), indices(shells), ["-k", "5"]

    sheets = [grid(30, 30, (0, 0, 0), (3, 0, 0), (0, 3, 0)), grid(30, 20, (0, 1.53, 0), (3, 0, 0), (0, 0, 2)),
              grid(17, 13, (1.51, 0, 0), (0, 1.5, 0), (0, 0, 1))]
    yield "sheets that touch", join(*sheets), indices(sheets), ["--method", "smooth-faces"]

    # Quadrangles of the upper half of a dumbbell in four, without the points that this gives on edges of the lower half.
    points, split, parts = list(dumbbell[0]), [], []
    for part, face in zip(body, dumbbell[1]):
        if len(face) == 4 and dumbbell[0][face][:, 2].mean() > 0:
            a, b, c, d = dumbbell[0][face]
            e, f, g, h, i = (len(points) + j for j in range(5))
            points += [(a + b) / 2, (b + c) / 2, (c + d) / 2, (d + a) / 2, (a + b + c + d) / 4]
            split += [[face[0], e, i, h], [e, face[1], f, i], [i, f, face[2], g], [h, i, g, face[3]]]
            parts += [part] * 4
        else:
            split.append(face)
            parts.append(part)
    points, index = numpy.unique(numpy.round(points, 12), axis=0, return_inverse=True)
    mesh = points, [[int(index[corner]) for corner in face] for face in split]
    yield "points on edges", mesh, numpy.array(parts), ["-k", "3"]

    crumbs = [(random.random(3) * (10, 10, 0.05) + 0.01 * random.standard_normal((3, 3)), [[0, 1, 2]]) for _ in range(4000)]
    plate = grid(150, 150, (0, 0, 0), (10, 0, 0), (0, 10, 0))
    yield ("plate with crumbs", join(plate, *crumbs), numpy.repeat([0, -1], [len(plate[1]), len(crumbs)]),
           ["--method", "smooth-faces"])


def counts_of_groups(folder):
    """By format, of the outputs that are there."""
    with zipfile.ZipFile(folder / "a.3mf") as archive:
        yield "3mf", archive.read("3D/3dmodel.model").count(b"<object ")
    yield "glb", len(list(meshes_of_glb(folder / "a.glb")))
    for name, pattern in ("obj", r"^g "), ("stl", r"^solid "), ("msh", r'^2 \d+ "'):
        if (folder / f"a.{name}").exists():
            yield name, len(re.findall(pattern, (folder / f"a.{name}").read_text(), re.MULTILINE))


def check(program, folder, mesh, parts, options, least_share=0.7):
    def run(*arguments):
        outcome = subprocess.run([program, "a.off", "-q", *arguments], cwd=folder, capture_output=True, text=True)
        assert outcome.returncode == 0, outcome.stderr
        labels = numpy.array((folder / "a.seg").read_text().split(), dtype=int)
        assert len(labels) == len(mesh[1])
        assert numpy.array_equal(numpy.unique(labels), numpy.arange(labels.max() + 1))
        return labels

    write_off(folder / "a.off", *mesh)
    endings = "obj", "glb", "stl", "3mf"
    outputs = [word for ending in endings for word in ("-o", f"a.{ending}")]
    for method in [], ["--method", "smooth-faces"]:
        n = run(*method, "-o", "a.seg", *outputs, "-o", "a.msh").max() + 1
        assert dict(counts_of_groups(folder)) == dict.fromkeys([*endings, "msh"], n), n
        (folder / "a.msh").unlink()
        run("--labels", "a.seg", "--solids", *outputs)
        assert dict(counts_of_groups(folder)) == dict.fromkeys(endings, n), n
        print("  ", *method, n, "segments")

    labels = run(*options, "-o", "a.seg")
    areas = numpy.array([area(fan(mesh[0], face)) for face in mesh[1]])
    best = []
    for part in range(parts.max() + 1):
        shares = numpy.bincount(labels[parts == part], areas[parts == part]) / areas[parts == part].sum()
        best.append(shares.argmax())
        assert shares.max() > least_share, (part, shares)
    assert len(set(best)) == len(best), best


def main(program):
    with tempfile.TemporaryDirectory() as name:
        for title, mesh, *expected in make_meshes():
            print(f"{title}: {len(mesh[1])} faces", flush=True)
            check(program, pathlib.Path(name), mesh, *expected)


if __name__ == "__main__":
    main(*sys.argv[1:])
