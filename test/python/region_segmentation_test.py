# SPDX-License-Identifier: GPL-3.0-or-later

import importlib.metadata
import inspect
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import types
import typing

import numpy
import pytest

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


def test_two_sides_of_a_valley():
    points, faces = grid(10, 1)
    labels = segment(points, faces, 2, method="two-step")
    assert labels.dtype == numpy.int32 and (labels == halves(10)).all()
    assert (numpy.bincount(labels) == 100).all()


@pytest.mark.parametrize("method, numbers", [("learned", [1, 3, 7]), ("visibility", [3]), ("two-step", [1, 2]), ("smooth-faces", [1, 2])])
def test_numbers_given_and_chosen(method, numbers):
    points, faces = grid(10, 1)
    segmenter = Segmenter(points, faces, method)
    for k in numbers:
        labels = segmenter.segment(k)
        first = [numpy.flatnonzero(labels == i)[0] for i in range(k)]
        assert labels.max() == k - 1 and first == sorted(first)
        assert (labels == segment(points, faces, k, method)).all()
    if method != "two-step":
        assert (segmenter.segment() == segment(points, faces, method=method)).all()


@pytest.mark.filterwarnings("ignore:1 segments")  # of two-step
def test_methods_differ():
    mesh = turned_part(48)
    assert (segment(mesh, number_of_segments=6) == segment(mesh, number_of_segments=6, method="learned")).all()
    labels = [segment(mesh, number_of_segments=6, method=m).tolist() for m in typing.get_args(region_segmentation.Method)]
    assert len(labels) == 4 and all(labels.count(x) == 1 for x in labels)


def test_constrained_edges_are_borders():
    with pytest.warns(UserWarning, match="2 segments: 1 are not possible"):
        labels = segment(*grid(10, 0), 1, constrained_edges=middle(10))
    assert (labels == halves(10)).all()


def test_arrays_of_other_types_and_orders():
    points, faces = grid(10, 1)
    expected = segment(points, faces, 4)
    for p in points.astype("f4"), numpy.asfortranarray(points), points.tolist(), points.astype(int):
        for f in faces.astype("i4"), numpy.asfortranarray(faces), faces.tolist():
            assert (segment(p, f, 4) == expected).all()


def meshes(points, faces):
    """Objects with the attributes of meshes of trimesh, Open3D, PyVista and meshio; and a tuple."""
    padded = numpy.insert(faces, 0, faces.shape[1], 1).reshape(-1)
    yield types.SimpleNamespace(vertices=points, faces=faces)
    yield types.SimpleNamespace(vertices=memoryview(points), triangles=memoryview(faces))
    yield types.SimpleNamespace(points=points, faces=padded)
    yield types.SimpleNamespace(points=points, cells=[types.SimpleNamespace(type="triangle", data=faces)])
    yield points, faces


def test_faces_of_different_sizes():
    points, faces = grid(10, 1)
    quads = numpy.concatenate([faces[::2], faces[1::2, 2:]], 1)
    assert (segment(points, quads, 2, method="two-step") == halves(10)[::2]).all()
    mixed = quads[:50].tolist() + faces[100:].tolist()
    padded = numpy.array([i for face in mixed for i in (len(face), *face)], "u2")
    block = types.SimpleNamespace
    cells = [block(type="quad", data=quads[:50]), block(type="line", data=[[0, 1]]), block(type="triangle", data=faces[100:])]
    for form in mixed, [numpy.array(face) for face in mixed], padded, padded.tolist(), cells:
        mesh = types.SimpleNamespace(points=points, cells=cells) if form is cells else (points, form)
        assert (segment(mesh, number_of_segments=2, method="two-step") == [0] * 50 + [1] * 100).all()


def test_meshes_of_other_libraries():
    mesh = grid(10, 1)
    for other in meshes(*mesh):
        assert (segment(other, number_of_segments=2, method="two-step") == halves(10)).all()
        assert (Segmenter(other).segment(5) == segment(*mesh, 5)).all()
        assert (region_segmentation.segment_borders(other, labels=halves(10)) == middle(10)).all()
        assert len(region_segmentation.describe_segments(other, labels=halves(10))) == 2
        assert len(region_segmentation.close_segments(other, labels=halves(10))) == 2
        assert (region_segmentation.smooth_borders(other, labels=halves(10)) == halves(10)).all()
        assert (region_segmentation.find_part_faces(other)[0] == halves(10)).all()
        assert (region_segmentation.transfer_labels(other, halves(10), other) == halves(10)).all()


def test_soups():
    points, faces = grid(10, 1)
    separate = points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)
    turned = numpy.where((numpy.arange(len(faces)) % 3 == 0)[:, None], faces[:, ::-1], faces)
    unused = numpy.concatenate([points, [[numpy.nan, 0, 0]]])
    expected = segment(points, faces, 5)
    for p, f in separate, (points, turned), (unused, faces):
        assert (segment(p, f, 5) == expected).all()
        assert len(region_segmentation.segment_borders(p, f, halves(10))) == 10
        # Torn apart and merged, so that the valley is an edge of two faces.
        (neighbor,) = region_segmentation.describe_segments(p, f, halves(10))[0]["neighbors"]
        assert neighbor["border_length"] == pytest.approx(10)


def test_components_are_linked_unless_asked_off():
    points, faces = grid(10, 1)
    two = numpy.concatenate([points, points + [10.5, 0, 0]]), numpy.concatenate([faces, faces + len(points)])
    assert segment(*two, 1).max() == 0
    with pytest.warns(UserWarning, match="2 segments: 1 are not possible"):
        labels = segment(*two, 1, component_links=False)
    assert (labels == numpy.repeat([0, 1], 200)).all()


def test_seeds_and_tree():
    mesh = grid(10, 1)
    seeds = numpy.full(200, -1)
    seeds[0], seeds[1] = 4, 2
    segmenter = Segmenter(*mesh)
    assert segmenter.regions.dtype == numpy.int32 and len(segmenter.merges) == segmenter.regions.max()
    assert [[type(x) for x in merge] for merge in segmenter.merges] == [[int, int, float]] * len(segmenter.merges)
    labels = segment(*mesh, 2, seeds=seeds)
    assert labels[0] != labels[1] and labels.max() == 1


def test_borders():
    points, faces = grid(10, 1)
    borders = region_segmentation.segment_borders(points, faces, halves(10))
    assert (borders == middle(10)).all() and borders.dtype.kind in "iu"
    assert region_segmentation.segment_borders(points, faces, numpy.zeros(200, int)).shape == (0, 2)
    # Three sheets at an edge.
    assert region_segmentation.segment_borders(numpy.arange(15).reshape(5, 3), [[0, 1, 2], [1, 0, 3], [0, 1, 4]], [0, 1, 2]).tolist() == [[0, 1]]


def test_descriptions():
    points, faces = grid(10, 1)
    first, second = region_segmentation.describe_segments(points, faces, 3 * halves(10) + 1)
    assert (first["segment"], second["segment"]) == (1, 4)
    assert first["number_of_faces"] == 100
    assert first["area"] == pytest.approx(50 * 2**0.5)
    assert first["centroid"] == pytest.approx((2.5, 5, 2.5))
    assert first["extents"] == pytest.approx((10, 50**0.5, 0))
    assert abs(numpy.array(first["axes"])[0]) == pytest.approx((0, 1, 0))
    assert first["border_length"] == pytest.approx(10)
    assert first["boundary_length"] == pytest.approx(10 + 10 * 2**0.5)
    (neighbor,) = first["neighbors"]
    assert neighbor == {"segment": 4, "border_length": pytest.approx(10), "mean_signed_deviation": pytest.approx(-90)}
    assert first["primitive"]["type"] == "plane" and first["primitive"]["error"] < 1e-9
    assert abs(numpy.array(first["primitive"]["direction"])) == pytest.approx((0.5**0.5, 0, 0.5**0.5))
    assert len(region_segmentation.describe_segments(points, faces, numpy.full(200, -1))) == 0
    # Three sheets at an edge are torn apart, and faces with a point twice are left out.
    x = numpy.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 1]], "f4")
    sheets = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [0, 1, 1]]
    assert [d["area"] for d in region_segmentation.describe_segments(x, sheets, [0, 1, 2, 3])] == [0.5] * 3


def test_volumes_and_solids():
    """Two cubes are a box, which is cut between them."""
    points = numpy.array([(x, y, z) for x in range(3) for y in range(2) for z in range(2)], float)
    ring = [0, 1, 3, 2]
    sides = [[4 * i + a, 4 * i + 4 + a, 4 * i + 4 + b, 4 * i + b] for i in (0, 1) for a, b in zip(ring, ring[1:] + ring[:1])]
    quads = numpy.array([ring, *sides, [8 + a for a in ring[::-1]]])
    for faces in quads, numpy.concatenate([quads[:, :3], quads[:, [0, 2, 3]]]):
        labels = numpy.where(points[faces].mean(1)[:, 0] > 1, 3, 5)
        solids = region_segmentation.close_segments(points, faces, labels)
        assert [s["segment"] for s in solids] == [5, 3]
        assert [volume(s["points"], s["faces"]) for s in solids] == pytest.approx([1, 1])
        apart = region_segmentation.close_segments(points, faces, labels, clearance=0.1)
        assert [volume(s["points"], s["faces"]) for s in apart] == pytest.approx([0.95, 0.95])
        described = region_segmentation.describe_segments(points, faces, labels)
        assert [d[key] for d in described for key in ("volume", "volume_share")] == pytest.approx([1, 0.5, 1, 0.5])
        for s in solids:
            original = s["face_of_mesh"][s["face_of_mesh"] >= 0]
            assert (original == numpy.flatnonzero(labels == s["segment"])).all()
            assert len(s["faces"]) == len(s["face_of_mesh"]) > len(original)
            assert isinstance(s["faces"], numpy.ndarray) == (faces is not quads)
            assert s["points"][s["faces"][0]].mean(0) == pytest.approx(points[faces[original[0]]].mean(0))


def test_part_faces():
    points, quads = turned_part(48)
    labels, faces = region_segmentation.find_part_faces(points, quads)
    assert labels.dtype == numpy.int32 and (labels == segment(points, quads, method="smooth-faces")).all()
    assert [f["type"] for f in faces] == ["plane", "cone", "cylinder", "torus", "plane", "cylinder"]
    plane, cone, cylinder, torus, _, hole = faces
    assert [f["role"] for f in faces] == ["none", "none", "none", "blend", "none", "hole"]
    assert [f["is_concave"] for f in (cylinder, hole)] == [False, True]
    assert cone["half_angle"] == pytest.approx(numpy.degrees(numpy.arctan(0.5)))
    assert cone["point"] == pytest.approx((0, 0, -5)) and cone["extent"] == pytest.approx((5, 6))
    assert (cylinder["radius"], hole["radius"]) == pytest.approx((3, 1)) and plane["radius"] == 0
    assert (torus["radius"], torus["minor_radius"]) == pytest.approx((2.5, 0.5))
    along = sorted(hole["point"][2] + hole["direction"][2] * numpy.array(hole["extent"]))
    assert along == pytest.approx([0, 2.5]) and hole["deviation"] < 1e-9
    assert abs(plane["direction"][2]) == pytest.approx(1)
    assert cylinder["area"] == pytest.approx(6 * numpy.pi, rel=0.01)
    assert [f["first_on_surface"] for f in faces] == list(range(6))
    assert [f["first_on_axis"] for f in faces] == [0, 1, 1, 1, 4, 1]
    cone_length = 96 * 3 * numpy.sin(numpy.pi / 48)
    assert cylinder["neighbors"] == [
        {"face": 1, "length": pytest.approx(cone_length), "is_smooth": False},
        {"face": 3, "length": pytest.approx(cone_length), "is_smooth": True},
    ]


def test_primitives():
    points, quads = turned_part(48)
    labels = region_segmentation.find_part_faces(points, quads)[0]
    cone, cylinder = (d["primitive"] for d in region_segmentation.describe_segments(points, quads, labels)[1:3])
    assert (cone["type"], cone["radius"], cylinder["type"], cylinder["half_angle"]) == ("cone", 0, "cylinder", 0)
    assert cone["half_angle"] == pytest.approx(numpy.degrees(numpy.arctan(0.5)), rel=1e-3)
    assert cone["point"] == pytest.approx((0, 0, -5), abs=1e-3) and cylinder["radius"] == pytest.approx(3)
    points, faces = grid(20, 0)
    points = points - (10, 10, -8)
    points *= 2 / numpy.linalg.norm(points, axis=1)[:, None]
    sphere = region_segmentation.describe_segments(points, faces, numpy.zeros(800, int))[0]["primitive"]
    assert (sphere["type"], sphere["direction"], sphere["radius"]) == ("sphere", (0, 0, 0), pytest.approx(2, rel=0.01))


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
    smooth = region_segmentation.smooth_borders(*grid(30, 1), rough)
    assert smooth.dtype == numpy.int32 and (smooth == halves(30) + 7).all()


def test_dictionaries_have_the_keys_that_are_annotated():
    part = turned_part(48)
    labels, faces = region_segmentation.find_part_faces(part)
    (description, *_) = region_segmentation.describe_segments(part, labels=labels)
    (solid, *_) = region_segmentation.close_segments(part, labels=labels)
    for kind, dictionary in {
        "Description": description, "Primitive": description["primitive"], "Neighbor": description["neighbors"][0],
        "PartFace": faces[0], "PartFaceNeighbor": faces[0]["neighbors"][0], "Solid": solid,
    }.items():
        assert set(dictionary) == set(typing.get_type_hints(getattr(region_segmentation, kind)))


def test_package():
    metadata = importlib.metadata.metadata("region-segmentation")
    assert metadata["Version"] == region_segmentation.__version__
    assert metadata["License"] == "GPL-3.0-or-later" and "Author" not in metadata
    assert metadata["Description-Content-Type"] == "text/markdown" and "PyVista" in metadata.get_payload()
    assert any(f.name == "py.typed" for f in importlib.metadata.files("region-segmentation"))
    for name, value in vars(region_segmentation).items():
        if inspect.isfunction(value) and value.__module__ == "region_segmentation" and not name.startswith("_"):
            assert value.__doc__ and all(p.annotation is not p.empty for p in inspect.signature(value).parameters.values())


def test_wrong_input_is_named():
    points, faces = grid(3, 1)

    def message(*arguments, function=segment, kind=ValueError, **keywords):
        with pytest.raises(kind) as error:
            function(*arguments, **keywords)
        assert error.type is kind
        return str(error.value)

    invalid = region_segmentation.InvalidInput
    assert issubclass(invalid, ValueError) and issubclass(region_segmentation.Cancelled, RuntimeError)
    assert invalid.__module__ == region_segmentation.Cancelled.__module__ == "region_segmentation"
    assert message(points[:, :2], faces) == "points: not an array of (n, 3) numbers"
    assert message(points, faces[:, :2]).startswith("faces: not an array of (m, 3) or more indices")
    assert message(points, faces + 7, kind=invalid) == "face 6, from 0: index 16 is out of range: there are 16 points"
    assert message(points, [[0, 1, 2], [0, 1, 2, -1]], kind=invalid) == "face 1, from 0: index -1 is out of range: there are 16 points"
    assert message(points, [[0, 1, 2], []], kind=invalid) == "face 1, from 0: has no corners"
    assert message(points, [3, 0, 1, 2, 4, 0, 1, 2]) == "faces: the padded array ends within its last face"
    for sizes in (0, 3, 0, 1, 2), (-4, 3, 0, 1, 2):
        assert message(points, sizes, kind=invalid) == "face 0, from 0: has no corners"
    assert message(points, faces, seeds=[1]) == "seeds: not an int32 for each face, -1 for none"
    for name, function in ("number_of_segments", segment), ("threads", Segmenter):
        for number, kind in (0, ValueError), (-(10**30), ValueError), (2.5, TypeError), (True, TypeError), (numpy.True_, TypeError), ("2", TypeError):
            expected = f"{name}: not None or an integer of at least 1, but {number!r}"
            assert message(points, faces, function=function, kind=kind, **{name: number}) == expected
    assert (segment(points, faces, numpy.int32(2)) == segment(points, faces, 2)).all()
    assert all(len(segment(points, none)) == 0 for none in ([], (), numpy.empty((0, 3), int)))
    assert message(points, faces, method="two-step") == "method two-step needs the number of segments"
    for name in "regions", "merges":
        assert message(Segmenter(points, faces, "two-step"), name, function=getattr).startswith("method two-step has no ")
    assert message(points, faces, method="x").startswith("method: not learned")
    assert message(points, faces, kind=invalid, constrained_edges=[[0, 9]]) == "constrained edges: there is no edge between points 0 and 9"
    assert message(points, faces, kind=invalid, constrained_edges=[[0, 16]]).startswith("constrained edges: index 16 is out of range")
    for edges in [0, 1], [[0, 1, 2]]:
        assert message(points, faces, constrained_edges=edges) == "constrained_edges: not an array of (n, 2) indices"
    expected = "labels: not an int32 for each face, -1 for none"
    for labels, kind in ([1, 2], ValueError), ([2**31] * 18, ValueError), ([0.5] * 18, TypeError):
        for name in "segment_borders", "describe_segments", "close_segments", "smooth_borders":
            assert message(points, faces, labels, function=getattr(region_segmentation, name), kind=kind) == expected
    for clearance in -1, numpy.inf, numpy.nan:
        assert message(points, faces, [0] * 18, clearance, function=region_segmentation.close_segments).startswith("clearance: not")
    points[5] = numpy.nan
    for function in segment, region_segmentation.find_part_faces:
        assert message(points, faces, function=function, kind=invalid) == "the point of vertex 5 is not finite"
    for arguments in (points, faces.astype("f8")), (points, [[0, 1, 2], [0, 1, 2, 3.5]]), (points, [[], []]), ("abc", faces), (points, 5.5), (points,), (types.SimpleNamespace(points=points, cells=faces),):
        assert ": not " in message(*arguments, kind=TypeError)
    assert message(types.SimpleNamespace(points=points, faces=faces), 8, kind=TypeError).startswith("faces: given beside a mesh")


def test_other_threads_run_meanwhile():
    counts, is_done = [0], threading.Event()

    def count():
        while not is_done.wait(0.0001):
            counts[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counts[0]
    Segmenter(*grid(150, 1))
    during = counts[0] - before
    is_done.set()
    thread.join()
    assert during > 3


def test_threads():
    code = """if True:
        import os, sys, numpy, region_segmentation
        points = numpy.random.default_rng(0).random((30000, 3))
        region_segmentation.segment(points, numpy.arange(30000).reshape(-1, 3), 2, "two-step", threads=int(sys.argv[1]))
        print(len(os.listdir("/proc/self/task")))"""
    numbers = [int(subprocess.check_output([sys.executable, "-c", code, n], text=True)) for n in "12"]
    assert numbers[1] > numbers[0] or os.cpu_count() == 1
    mesh = grid(40, 1)
    assert (segment(*mesh, 5, threads=1) == segment(*mesh, 5, threads=2)).all()


FUNCTIONS = [("segment", {}), ("Segmenter", {}), ("find_part_faces", {}), ("smooth_borders", {"labels": numpy.arange(7200) // 9})]


@pytest.mark.parametrize("name, keywords", FUNCTIONS)
def test_progress(name, keywords):
    function, reports = getattr(region_segmentation, name), []
    function(*grid(60, 1), **keywords, progress=lambda stage, fraction: reports.append((stage, fraction)))
    assert len({stage for stage, _ in reports}) > 1
    assert all(isinstance(stage, str) and 0 <= fraction <= 1 for stage, fraction in reports)
    with pytest.raises(region_segmentation.Cancelled):
        function(*grid(60, 1), **keywords, progress=lambda stage, fraction: False)
    with pytest.raises(ZeroDivisionError):
        function(*grid(60, 1), **keywords, progress=lambda stage, fraction: 1 / 0)


def test_progress_of_a_segmenter_that_merges_again():
    reports = []
    segmenter = Segmenter(*grid(60, 1), "two-step", progress=lambda *report: reports.append(report))
    reports.clear()
    segmenter.segment(2)
    assert reports


@pytest.mark.parametrize("name, keywords", FUNCTIONS[1:3])
def test_control_c_interrupts(name, keywords):
    function, mesh, fractions = getattr(region_segmentation, name), grid(300, 1), []
    begin = time.monotonic()
    function(*mesh, **keywords, progress=lambda stage, fraction: fractions.append(fraction))
    whole = time.monotonic() - begin
    assert any(0 < fraction < 1 for fraction in fractions) and len(fractions) < 20 * whole + 20
    timer = threading.Timer(whole / 5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        function(*mesh, **keywords)
        time.sleep(10)
    assert time.monotonic() - begin < 0.7 * whole + 0.05


def test_examples_of_the_readme(tmp_path, monkeypatch):
    """With modules that have what the examples use of trimesh, Open3D and PyVista."""
    monkeypatch.chdir(tmp_path)
    points, faces = grid(10, 1)
    like_trimesh, like_open3d, like_pyvista, *_ = meshes(points, faces)
    like_trimesh.visual = types.SimpleNamespace()
    like_trimesh.export = lambda name: open(name, "w").close()
    like_open3d.vertices, like_open3d.triangles = points, faces  # which can be copied
    like_open3d.remove_triangles_by_mask = lambda mask: written.append((~mask).sum())
    like_pyvista.cell_data = {}
    like_pyvista.save = lambda name: open(name, "w").close()
    written = []
    io = types.SimpleNamespace(read_triangle_mesh=lambda name: like_open3d, write_triangle_mesh=lambda name, part: open(name, "w").close())
    monkeypatch.setitem(sys.modules, "trimesh", types.SimpleNamespace(load_mesh=lambda name: like_trimesh))
    monkeypatch.setitem(sys.modules, "open3d", types.SimpleNamespace(io=io))
    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(read=lambda name: like_pyvista))
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
