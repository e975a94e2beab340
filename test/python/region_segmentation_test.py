# SPDX-License-Identifier: GPL-3.0-or-later

import doctest
import importlib.metadata
import inspect
import itertools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import typing
from types import SimpleNamespace

import hypothesis
import numpy
import pytest
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import region_segmentation
from region_segmentation import Segmenter, segment


def grid(n, height):
    """An n x n grid of squares as triangles, bent along its middle to a concave valley."""
    x, y = numpy.meshgrid(numpy.arange(n + 1.0), numpy.arange(n + 1.0), indexing="ij")
    points = numpy.stack([x, y, height * abs(x - n / 2)], -1).reshape(-1, 3)
    a = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)[None, :]).reshape(-1)
    b, c, d = a + n + 1, a + n + 2, a + 1
    return points, numpy.stack([a, b, c, a, c, d], -1).reshape(-1, 3)


def halves(n):
    return numpy.repeat([0, 1], n * n)


def middle(n):
    column = n // 2 * (n + 1) + numpy.arange(n + 1)
    return numpy.stack([column[:-1], column[1:]], -1)


def turned_part(n):
    """Quads of a turned part: a foot that widens to a cylinder, rounded at the top, with a hole along its axis."""
    arc = [(2.5 + 0.5 * numpy.cos(t), 2 + 0.5 * numpy.sin(t)) for t in numpy.linspace(0, numpy.pi / 2, 7)]
    profile = numpy.array([(1, 0), (2.5, 0), (3, 1), *arc, (1, 2.5)])
    t = numpy.arange(n) * 2 * numpy.pi / n
    points = [(r * numpy.cos(s), r * numpy.sin(s), z) for r, z in profile for s in t]
    a = numpy.arange(len(profile) * n)
    b = a // n * n + (a + 1) % n
    return numpy.array(points), numpy.stack([a, b, (b + n) % len(a), (a + n) % len(a)], -1)


def volume(points, faces):
    return sum(points[f[0]] @ numpy.cross(points[f[i - 1]], points[f[i]]) / 6 for f in faces for i in range(2, len(f)))


@pytest.mark.parametrize("method, numbers", [("learned", [1, 3, 7]), ("visibility", [3]), ("two-step", [1, 2]), ("smooth-faces", [1, 2])])
def test_numbers_given_and_chosen(method, numbers):
    points, faces = grid(10, 1)
    segmenter = Segmenter((points, faces), method)
    for k in numbers:
        labels = segmenter.segment(k)
        first = [numpy.flatnonzero(labels == i)[0] for i in range(k)]
        assert labels.max() == k - 1 and first == sorted(first)
        assert (labels == segment((points, faces), k, method)).all()
    if method != "two-step":
        assert (segmenter.segment() == segment((points, faces), method=method)).all()


@pytest.mark.filterwarnings("ignore:1 segments")  # of two-step
def test_methods_differ():
    mesh = turned_part(48)
    assert (segment(mesh, number_of_segments=6) == segment(mesh, number_of_segments=6, method="learned")).all()
    labels = [segment(mesh, number_of_segments=6, method=m).tolist() for m in typing.get_args(region_segmentation.Method)]
    assert len(labels) == 4 and all(labels.count(x) == 1 for x in labels)


def as_array(array, types, form):
    """The array in another type and order of memory, or as a list."""
    array = array.astype(types)
    return {
        "C": array, "Fortran": numpy.asfortranarray(array), "strided": numpy.repeat(array, 2, 0)[::2],
        "backwards": array[::-1].copy()[::-1], "memory": memoryview(array), "list": array.tolist(),
    }[form]


def as_faces(faces, types, form):
    """Faces of one or of several sizes as arrays, as lists, as an array padded with their sizes, and as cells of meshio."""
    if form == "lists":
        return [face.tolist() for face in faces]
    if form == "arrays":
        return [face.astype(types) for face in faces]
    if form == "padded":
        return numpy.concatenate([[len(face), *face] for face in faces]).astype(types)
    if form == "cells":
        blocks = [("line", [[0, 1]])]
        for size, block in itertools.groupby(faces, len):
            blocks.append(({3: "triangle", 4: "quad"}[size], numpy.array(list(block), types)))
        return [SimpleNamespace(type=kind, data=data) for kind, data in blocks]
    return as_array(numpy.array(faces), types, form)


ARRAYS = ["C", "Fortran", "strided", "backwards", "memory", "list"]


@pytest.mark.filterwarnings("ignore:. segments")
@hypothesis.settings(derandomize=True, deadline=None, max_examples=60)
@hypothesis.given(st.data())
def test_meshes_in_every_form(data):
    """Meshes as attributes of trimesh, Open3D, PyVista and meshio, and as a tuple; of any types."""
    points, faces = grid(10, 1)
    labels = halves(10)
    sizes = data.draw(st.sampled_from(["triangles", "quads", "mixed"]))
    if sizes != "triangles":
        quads = numpy.concatenate([faces[::2], faces[1::2, 2:]], 1)
        faces, labels = (quads, labels[::2]) if sizes == "quads" else ([*quads[:50], *faces[100:]], labels[50:])
    form = data.draw(st.sampled_from(["lists", "arrays", "padded", "cells"] + ARRAYS * (sizes != "mixed")))
    p = as_array(points, data.draw(st.sampled_from(["f4", "f8", ">f8", "i2", "u1"])), data.draw(st.sampled_from(ARRAYS)))
    f = as_faces(faces, data.draw(st.sampled_from(["i4", "i8", "u2", ">i4"])), form)
    kinds = [("points", "cells")] if form == "cells" else [("vertices", "faces"), ("vertices", "triangles"), ("points", "faces"), None]
    kind = data.draw(st.sampled_from(kinds))
    mesh = SimpleNamespace(**dict(zip(kind, (p, f)))) if kind else (p, f)
    marks = as_array(labels, data.draw(st.sampled_from(["i1", "u4", "i8", "u8", ">i4"])), data.draw(st.sampled_from(ARRAYS)))
    assert (segment(mesh, number_of_segments=2, method="two-step") == labels).all()
    assert (segment(mesh, number_of_segments=1, constrained_edges=middle(10), method="two-step") == labels).all()
    assert (Segmenter(mesh).segment(5) == segment((points, [list(face) for face in faces]), 5)).all()
    assert (region_segmentation.segment_borders(mesh, marks) == middle(10)).all()
    assert len(region_segmentation.describe_segments(mesh, marks)) == 2
    assert len(region_segmentation.close_segments(mesh, marks)) == 2
    assert (region_segmentation.smooth_borders(mesh, marks) == labels).all()
    assert (region_segmentation.find_part_faces(mesh)[0] == labels).all()
    assert (region_segmentation.transfer_labels(mesh, marks, mesh) == labels).all()


@pytest.mark.filterwarnings("ignore:. segments")
@hypothesis.settings(derandomize=True, deadline=None, max_examples=100)
@hypothesis.given(st.data())
def test_random_soups(data):
    number = data.draw(st.integers(1, 12))
    coordinates = st.sampled_from([0, 1, 2, 0.5, -1e-7, 1e6]) | st.floats(-10, 10)
    points = data.draw(arrays("f8", (number, 3), elements=coordinates))
    polygon = st.lists(st.integers(0, number - 1), min_size=3, max_size=6)
    faces = data.draw(st.lists(polygon, min_size=1, max_size=20))
    labels = data.draw(arrays("i4", len(faces), elements=st.integers(-1, 3)))
    for method in typing.get_args(region_segmentation.Method):
        result = Segmenter((points, faces), method, component_links=True).segment(3)
        seen = list(dict.fromkeys(result.tolist()))
        assert result.dtype == numpy.int32 and len(result) == len(faces) and seen == list(range(len(seen))) and len(seen) <= 3
    mesh = points, faces
    borders = region_segmentation.segment_borders(mesh, labels)
    assert borders.shape[1] == 2 and (borders.size == 0 or borders.max() < number)
    known = set(labels.tolist())
    assert {d.segment for d in region_segmentation.describe_segments(mesh, labels)} <= known
    assert set(region_segmentation.smooth_borders(mesh, labels).tolist()) <= known
    assert set(region_segmentation.transfer_labels(mesh, labels, mesh).tolist()) <= known | {-1}
    for solid in region_segmentation.close_segments(mesh, labels):
        sides = [(f[i - 1], f[i]) for f in solid.faces for i in range(len(f))]
        assert sorted(sides) == sorted((b, a) for a, b in sides)


def test_soups():
    points, faces = grid(10, 1)
    separate = points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)
    turned = numpy.where((numpy.arange(len(faces)) % 3 == 0)[:, None], faces[:, ::-1], faces)
    unused = numpy.concatenate([points, [[numpy.nan, 0, 0]]])
    expected = segment((points, faces), 5)
    for p, f in separate, (points, turned), (unused, faces):
        assert (segment((p, f), 5) == expected).all()
        assert len(region_segmentation.segment_borders((p, f), halves(10))) == 10
        # Torn apart and merged, so that the valley is an edge of two faces.
        (neighbor,) = region_segmentation.describe_segments((p, f), halves(10))[0].neighbors
        assert neighbor.border_length == pytest.approx(10)


def test_components_are_linked_unless_asked_off():
    points, faces = grid(10, 1)
    two = numpy.concatenate([points, points + [10.5, 0, 0]]), numpy.concatenate([faces, faces + len(points)])
    assert segment(two, 1).max() == 0
    with pytest.warns(UserWarning, match="2 segments: 1 are not possible"):
        labels = segment(two, 1, component_links=False)
    assert (labels == numpy.repeat([0, 1], 200)).all()


def test_seeds_and_tree():
    mesh = grid(10, 1)
    seeds = numpy.full(200, -1)
    seeds[0], seeds[1] = 4, 2
    segmenter = Segmenter(mesh)
    assert segmenter.regions.dtype == numpy.int32 and len(segmenter.merges) == segmenter.regions.max()
    assert [[type(x) for x in merge] for merge in segmenter.merges] == [[int, int, float]] * len(segmenter.merges)
    labels = segment(mesh, 2, seeds=seeds)
    assert labels[0] != labels[1] and labels.max() == 1


def test_borders():
    points, faces = grid(10, 1)
    borders = region_segmentation.segment_borders((points, faces), halves(10))
    assert (borders == middle(10)).all() and borders.dtype.kind in "iu"
    assert region_segmentation.segment_borders((points, faces), numpy.zeros(200, int)).shape == (0, 2)
    # Three sheets at an edge.
    assert region_segmentation.segment_borders((numpy.arange(15).reshape(5, 3), [[0, 1, 2], [1, 0, 3], [0, 1, 4]]), [0, 1, 2]).tolist() == [[0, 1]]


def test_descriptions():
    points, faces = grid(10, 1)
    first, second = region_segmentation.describe_segments((points, faces), 3 * halves(10) + 1)
    assert (first.segment, second.segment) == (1, 4)
    assert first.number_of_faces == 100
    assert first.area == pytest.approx(50 * 2**0.5)
    assert first.centroid == pytest.approx((2.5, 5, 2.5))
    assert first.extents == pytest.approx((10, 50**0.5, 0))
    assert abs(numpy.array(first.axes)[0]) == pytest.approx((0, 1, 0))
    assert first.border_length == pytest.approx(10)
    assert first.boundary_length == pytest.approx(10 + 10 * 2**0.5)
    (neighbor,) = first.neighbors
    assert (neighbor.segment, neighbor.border_length, neighbor.mean_signed_deviation) == (4, pytest.approx(10), pytest.approx(-90))
    assert first.surface.type == "plane" and first.surface_error < 1e-9
    assert abs(numpy.array(first.surface.direction)) == pytest.approx((0.5**0.5, 0, 0.5**0.5))
    assert len(region_segmentation.describe_segments((points, faces), numpy.full(200, -1))) == 0
    # Three sheets at an edge are torn apart, and faces with a point twice are left out.
    x = numpy.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 1]], "f4")
    sheets = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [0, 1, 1]]
    assert [d.area for d in region_segmentation.describe_segments((x, sheets), [0, 1, 2, 3])] == [0.5] * 3


def test_volumes_and_solids():
    """Two cubes are a box, which is cut between them."""
    points = numpy.array([(x, y, z) for x in range(3) for y in range(2) for z in range(2)], float)
    ring = [0, 1, 3, 2]
    sides = [[4 * i + a, 4 * i + 4 + a, 4 * i + 4 + b, 4 * i + b] for i in (0, 1) for a, b in zip(ring, ring[1:] + ring[:1])]
    quads = numpy.array([ring, *sides, [8 + a for a in ring[::-1]]])
    for faces in quads, numpy.concatenate([quads[:, :3], quads[:, [0, 2, 3]]]):
        labels = numpy.where(points[faces].mean(1)[:, 0] > 1, 3, 5)
        solids = region_segmentation.close_segments((points, faces), labels)
        assert [s.segment for s in solids] == [5, 3]
        assert [volume(s.points, s.faces) for s in solids] == pytest.approx([1, 1])
        apart = region_segmentation.close_segments((points, faces), labels, clearance=0.1)
        assert [volume(s.points, s.faces) for s in apart] == pytest.approx([0.95, 0.95])
        described = region_segmentation.describe_segments((points, faces), labels)
        assert [getattr(d, key) for d in described for key in ("volume", "volume_share")] == pytest.approx([1, 0.5, 1, 0.5])
        for s in solids:
            original = s.face_of_mesh[s.face_of_mesh >= 0]
            assert (original == numpy.flatnonzero(labels == s.segment)).all()
            assert len(s.faces) == len(s.face_of_mesh) > len(original)
            assert isinstance(s.faces, numpy.ndarray) == (faces is not quads)
            assert s.points[s.faces[0]].mean(0) == pytest.approx(points[faces[original[0]]].mean(0))


def test_part_faces():
    points, quads = turned_part(48)
    labels, faces = region_segmentation.find_part_faces((points, quads))
    assert labels.dtype == numpy.int32 and (labels == segment((points, quads), method="smooth-faces")).all()
    assert [f.surface.type for f in faces] == ["plane", "cone", "cylinder", "torus", "plane", "cylinder"]
    plane, cone, cylinder, torus, _, hole = faces
    assert [f.role for f in faces] == [None, None, None, "blend", None, "hole"]
    assert [f.is_concave for f in (cylinder, hole)] == [False, True]
    assert cone.surface.half_angle == pytest.approx(numpy.degrees(numpy.arctan(0.5)))
    assert cone.surface.point == pytest.approx((0, 0, -5)) and cone.surface.extent == pytest.approx((5, 6))
    assert (cylinder.surface.radius, hole.surface.radius) == pytest.approx((3, 1)) and plane.surface.radius is None and plane.surface.point
    assert (torus.surface.radius, torus.surface.minor_radius) == pytest.approx((2.5, 0.5))
    along = sorted(hole.surface.point[2] + hole.surface.direction[2] * numpy.array(hole.surface.extent))
    assert along == pytest.approx([0, 2.5]) and hole.surface.deviation < 1e-9
    assert abs(plane.surface.direction[2]) == pytest.approx(1)
    assert cylinder.area == pytest.approx(6 * numpy.pi, rel=0.01)
    assert [f.first_on_surface for f in faces] == list(range(6))
    assert [f.first_on_axis for f in faces] == [0, 1, 1, 1, 4, 1]
    cone_length = 96 * 3 * numpy.sin(numpy.pi / 48)
    assert [(n.face, n.length, n.is_smooth) for n in cylinder.neighbors] == [
        (1, pytest.approx(cone_length), False), (3, pytest.approx(cone_length), True)]


def test_primitives():
    points, quads = turned_part(48)
    labels = region_segmentation.find_part_faces((points, quads))[0]
    cone, cylinder = (d.surface for d in region_segmentation.describe_segments((points, quads), labels)[1:3])
    assert (cone.type, cone.radius, cylinder.type, cylinder.half_angle) == ("cone", None, "cylinder", None)
    assert cone.half_angle == pytest.approx(numpy.degrees(numpy.arctan(0.5)), rel=1e-3)
    assert cone.point == pytest.approx((0, 0, -5), abs=1e-3) and cylinder.radius == pytest.approx(3)
    points, faces = grid(20, 0)
    points = points - (10, 10, -8)
    points *= 2 / numpy.linalg.norm(points, axis=1)[:, None]
    sphere = region_segmentation.describe_segments((points, faces), numpy.zeros(800, int))[0].surface
    assert (sphere.type, sphere.direction, sphere.radius) == ("sphere", None, pytest.approx(2, rel=0.01))


def test_transfer():
    coarse, fine = grid(10, 1), grid(20, 2)
    fine = fine[0] / 2, fine[1]
    labels = region_segmentation.transfer_labels(coarse, 5 * halves(10) - 1, fine)
    assert labels.dtype == numpy.int32 and (labels == 5 * halves(20) - 1).all()
    assert (region_segmentation.transfer_labels(fine, labels, coarse) == 5 * halves(10) - 1).all()
    points, faces = coarse
    assert region_segmentation.transfer_labels(coarse, halves(10), (points, [[0, 1, 1], *faces[-2:]])).tolist() == [-1, 1, 1]


def test_smoothing():
    rough = halves(30) + 7
    rough[840:900:4] = 8  # every second triangle at the border
    smooth = region_segmentation.smooth_borders(grid(30, 1), rough)
    assert smooth.dtype == numpy.int32 and (smooth == halves(30) + 7).all()


def test_tolerance():
    """Two planes at a small angle are one within a tolerance."""
    mesh = grid(20, 0.01)
    labels, (face,) = region_segmentation.find_part_faces(mesh, tolerance=0.1)
    assert labels.max() == 0 and face.surface.type == "plane" and 0.01 < face.surface.deviation < 0.1
    assert [segment(mesh, method="smooth-faces", tolerance=t).max() for t in (None, 0.01, 0.1)] == [1, 1, 0]


def test_estimator():
    points, faces = grid(10, 1)
    segmenter = Segmenter(method="two-step")
    labels = segmenter.fit_predict((points, faces), 2)
    assert (labels == halves(10)).all() and labels is segmenter.labels_
    assert segmenter.fit((points, faces[:100])).segment(1).max() == 0


def test_colors():
    colors = region_segmentation.colors([0, -1, 1, 0])
    assert colors.dtype == numpy.uint8 and colors.tolist() == [[68, 119, 170], [96, 96, 96], [238, 102, 119], [68, 119, 170]]


def test_show(monkeypatch):
    """By PyVista, or by trimesh where that is missing."""
    points, faces = grid(3, 1)
    shown = []

    class PolyData:
        def __init__(self, points, faces):
            shown.append(faces.reshape(-1, 4)[:, 1:])

        def plot(self, scalars, rgb):
            shown.append(scalars)

    class Trimesh:
        def __init__(self, points, faces, face_colors, process):
            shown.extend([faces, face_colors])

        def show(self):
            pass

    labels = numpy.arange(len(faces))
    for module in SimpleNamespace(PolyData=PolyData), None:
        monkeypatch.setitem(sys.modules, "pyvista", module)
        monkeypatch.setitem(sys.modules, "trimesh", SimpleNamespace(Trimesh=Trimesh))
        region_segmentation.show((points, faces), labels)
    assert len(shown) == 4
    for found_faces, colors in shown[:2], shown[2:]:
        assert (found_faces == faces).all() and (colors == region_segmentation.colors(labels)).all()


def test_step(monkeypatch, tmp_path):
    """By mesh_to_step, of which this is one that tells what it was given; without it there is a reason."""
    part, arguments, program = tmp_path / "part.step", tmp_path / "arguments", tmp_path / "mesh_to_step"
    monkeypatch.setenv("PATH", str(tmp_path))
    mesh = [[0.1, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
    with pytest.raises(FileNotFoundError, match="mesh_to_step is not on the PATH"):
        region_segmentation.to_step(mesh, part)
    program.write_text(f"""#!/bin/sh
while read line; do echo "$line"; done <"$1"
echo "$@" >{arguments}
echo '{{"is_right": true}}' >"$6"
[ "$4" = inch ]
""")
    program.chmod(0o755)
    assert region_segmentation.to_step(mesh, part, unit="inch", as_found=True) == {"is_right": True}
    _, to, *rest = arguments.read_text().split()
    assert to == str(part) and rest[:3] == ["--unit", "inch", "--report"] and rest[4:] == ["--as-found"]
    with pytest.raises(ValueError, match="to_step: OFF 4 2 0\n0.1 0.0 0.0\n(.*\n){3}3 0 1 2\n3 0 2 3"):
        region_segmentation.to_step(mesh, part)


def test_examples_of_the_documentation():
    assert doctest.testmod(region_segmentation).failed == 0 < doctest.testmod(region_segmentation).attempted


def test_types():
    """As annotated: in strict mode mypy finds nothing in the module."""
    if not shutil.which("mypy"):
        pytest.skip("there is no mypy (Debian: mypy)")
    module = pathlib.Path(region_segmentation.__file__).parent
    stubs = "--ignore-missing-imports", "--python-version", "3.9"
    done = subprocess.run(["mypy", "--strict", *stubs, "--cache-dir", os.devnull, module], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_package():
    metadata = importlib.metadata.metadata("region-segmentation")
    assert metadata["Version"] == region_segmentation.__version__
    assert metadata["License"] == "LGPL-3.0-or-later" and "Author" not in metadata
    assert metadata["Description-Content-Type"] == "text/markdown" and "PyVista" in metadata.get_payload()
    assert any(f.name == "py.typed" for f in importlib.metadata.files("region-segmentation"))
    for name, value in vars(region_segmentation).items():
        if inspect.isfunction(value) and value.__module__ == "region_segmentation" and not name.startswith("_"):
            assert value.__doc__ and all(p.annotation is not p.empty for p in inspect.signature(value).parameters.values())


INVALID = region_segmentation.InvalidInput
POINTS, FACES = grid(3, 1)
NAN = numpy.where(numpy.arange(16)[:, None] == 5, numpy.nan, POINTS)
LABELLED = ["segment_borders", "describe_segments", "close_segments", "smooth_borders"]


@pytest.mark.parametrize("kind, words, name, arguments, keywords", [
    (ValueError, "points: not an array of", "segment", ((POINTS[:, :2], FACES),), {}),
    (ValueError, "faces: not an array of", "segment", ((POINTS, FACES[:, :2]),), {}),
    (ValueError, "faces: .* ends within its last face", "segment", ((POINTS, [3, 0, 1, 2, 4, 0, 1, 2]),), {}),
    (INVALID, "face 6, .* 16 .* 16 points", "segment", ((POINTS, FACES + 7),), {}),
    (INVALID, "face 1, .* -1 .* 16 points", "segment", ((POINTS, [[0, 1, 2], [0, 1, 2, -1]]),), {}),
    (INVALID, "face 1, .* no corners", "segment", ((POINTS, [[0, 1, 2], []]),), {}),
    *((INVALID, "face 0, .* no corners", "segment", ((POINTS, [size, 3, 0, 1, 2]),), {}) for size in (0, -4)),
    (ValueError, "seeds: not an int32", "segment", ((POINTS, FACES),), {"seeds": [1]}),
    *((kind, f"{key}: .* {re.escape(repr(n))}", name, ((POINTS, FACES),), {key: n})
      for key, name in (("number_of_segments", "segment"), ("threads", "Segmenter"))
      for n, kind in ((0, ValueError), (-(10**30), ValueError), (2.5, TypeError), (True, TypeError), (numpy.True_, TypeError), ("2", TypeError))),
    (ValueError, "two-step needs the number", "segment", ((POINTS, FACES),), {"method": "two-step"}),
    *((ValueError, "method: not learned", "segment", ((POINTS, FACES),), {"method": method}) for method in ("x", None)),
    (TypeError, "mesh: not a tuple", "segment", (None,), {}),
    (TypeError, "tolerance: not a finite length", "segment", ((POINTS, FACES),), {"method": "smooth-faces", "tolerance": "1"}),
    (INVALID, "constrained edges: .* 0 and 9", "segment", ((POINTS, FACES),), {"constrained_edges": [[0, 9]]}),
    (INVALID, "constrained edges: index 16", "segment", ((POINTS, FACES),), {"constrained_edges": [[0, 16]]}),
    *((ValueError, "constrained_edges: not an array", "segment", ((POINTS, FACES),), {"constrained_edges": e}) for e in ([0, 1], [[0, 1, 2]])),
    *((kind, "labels: not an int32", name, ((POINTS, FACES), labels), {}) for name in LABELLED
      for labels, kind in (([1, 2], ValueError), ([2**31] * 18, ValueError), ([0.5] * 18, TypeError))),
    *((ValueError, "clearance: not", "close_segments", ((POINTS, FACES), [0] * 18, c), {}) for c in (-1, numpy.inf, numpy.nan)),
    *((INVALID, "vertex 5 ", name, ((NAN, FACES),), {}) for name in ("segment", "find_part_faces")),
    *((TypeError, ": not ", "segment", arguments, {}) for arguments in (
        ((POINTS, FACES.astype("f8")),), ((POINTS, [[0, 1, 2], [0, 1, 2, 3.5]]),), ((POINTS, [[], []]),), (("abc", FACES),), ((POINTS, 5.5),), (POINTS,), (POINTS, FACES),
        (SimpleNamespace(points=POINTS, cells=FACES),))),
    *((ValueError, "tolerance: not a finite", "find_part_faces", ((POINTS, FACES), t), {}) for t in (-1, numpy.inf, numpy.nan)),
    (ValueError, "tolerance: only of the method smooth-faces", "segment", ((POINTS, FACES),), {"tolerance": 1}),
])
def test_wrong_input_is_named(kind, words, name, arguments, keywords):
    with pytest.raises(kind, match=words) as error:
        getattr(region_segmentation, name)(*arguments, **keywords)
    assert error.type is kind


def test_errors_and_empty_meshes():
    assert issubclass(INVALID, ValueError) and issubclass(region_segmentation.Cancelled, RuntimeError)
    assert INVALID.__module__ == region_segmentation.Cancelled.__module__ == "region_segmentation"
    assert (segment((POINTS, FACES), numpy.int32(2)) == segment((POINTS, FACES), 2)).all()
    assert all(len(segment((POINTS, none))) == 0 for none in ([], (), numpy.empty((0, 3), int)))
    for name in "regions", "merges":
        with pytest.raises(ValueError, match="two-step has no "):
            getattr(Segmenter((POINTS, FACES), "two-step"), name)


def test_other_threads_run_meanwhile():
    counts, is_done = [0], threading.Event()

    def count():
        while not is_done.wait(0.0001):
            counts[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counts[0]
    Segmenter(grid(150, 1))
    during = counts[0] - before
    is_done.set()
    thread.join()
    assert during > 3


def test_threads():
    code = """if True:
        import os, sys, numpy, region_segmentation
        points = numpy.random.default_rng(0).random((30000, 3))
        region_segmentation.segment((points, numpy.arange(30000).reshape(-1, 3)), 2, "two-step", threads=int(sys.argv[1]))
        print(len(os.listdir("/proc/self/task")))"""
    numbers = [int(subprocess.check_output([sys.executable, "-c", code, n], text=True)) for n in "12"]
    assert numbers[1] > numbers[0] or os.cpu_count() == 1
    mesh = grid(40, 1)
    for threads in 2, 10**9:
        assert (segment(mesh, 5, threads=1) == segment(mesh, 5, threads=threads)).all()


FUNCTIONS = [("segment", {}), ("Segmenter", {}), ("find_part_faces", {}), ("smooth_borders", {"labels": numpy.arange(7200) // 9})]


@pytest.mark.parametrize("name, keywords", FUNCTIONS)
def test_progress(name, keywords):
    function, reports = getattr(region_segmentation, name), []
    function(grid(60, 1), **keywords, progress=lambda stage, fraction: reports.append((stage, fraction)))
    assert len({stage for stage, _ in reports}) > 1
    assert all(isinstance(stage, str) and 0 <= fraction <= 1 for stage, fraction in reports)
    with pytest.raises(region_segmentation.Cancelled):
        function(grid(60, 1), **keywords, progress=lambda stage, fraction: False)
    with pytest.raises(ZeroDivisionError):
        function(grid(60, 1), **keywords, progress=lambda stage, fraction: 1 / 0)


def test_progress_of_a_segmenter_that_merges_again():
    reports = []
    segmenter = Segmenter(grid(60, 1), "two-step", progress=lambda *report: reports.append(report))
    reports.clear()
    segmenter.segment(2)
    assert reports


@pytest.mark.parametrize("name, keywords", FUNCTIONS[1:3])
def test_control_c_interrupts(name, keywords):
    function, mesh, fractions = getattr(region_segmentation, name), grid(300, 1), []
    begin = time.monotonic()
    function(mesh, **keywords, progress=lambda stage, fraction: fractions.append(fraction))
    whole = time.monotonic() - begin
    assert any(0 < fraction < 1 for fraction in fractions) and len(fractions) < 20 * whole + 20
    timer = threading.Timer(whole / 5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        function(mesh, **keywords)
        time.sleep(10)
    assert time.monotonic() - begin < 0.7 * whole + 0.05


def test_examples_of_the_readme(tmp_path, monkeypatch):
    """With modules that have what the examples use of trimesh, Open3D and PyVista."""
    monkeypatch.chdir(tmp_path)
    points, faces = grid(10, 1)
    like_trimesh = SimpleNamespace(vertices=points, faces=faces, visual=SimpleNamespace())
    like_open3d = SimpleNamespace(vertices=points, triangles=faces)
    like_pyvista = SimpleNamespace(points=points, faces=as_faces(faces, int, "padded"), cell_data={})
    like_trimesh.export = lambda name: open(name, "w").close()
    like_open3d.remove_triangles_by_mask = lambda mask: written.append((~mask).sum())
    like_pyvista.save = lambda name: open(name, "w").close()
    written = []
    io = SimpleNamespace(read_triangle_mesh=lambda name: like_open3d, write_triangle_mesh=lambda name, part: open(name, "w").close())
    monkeypatch.setitem(sys.modules, "trimesh", SimpleNamespace(load_mesh=lambda name: like_trimesh))
    monkeypatch.setitem(sys.modules, "open3d", SimpleNamespace(io=io))
    monkeypatch.setitem(sys.modules, "pyvista", SimpleNamespace(read=lambda name: like_pyvista))
    readme = (pathlib.Path(__file__).parents[2] / "examples/python/README.md").read_text()
    examples = re.findall(r"```python\n(.*?)```", readme, re.S)
    assert len(examples) == 4
    for example in examples:
        exec(example, {})
    assert set(os.listdir()) == {"segments.ply", "face_0.ply", "face_1.ply", "segments.vtp"}
    assert like_trimesh.visual.face_colors.shape == (200, 3)
    assert sorted(written) == [100, 100]
    assert like_pyvista.cell_data["segment"].max() == 3
    for name in re.findall(r"^\| `(.*?)` \|", readme, re.M):
        assert all(hasattr(region_segmentation, n) for n in name.split("`, `"))
