# SPDX-License-Identifier: GPL-3.0-or-later

import threading

import numpy
import pytest

import region_segmentation


def grid(n, height):
    """An n x n grid of squares as triangles, bent along its middle to a concave valley."""
    x, y = numpy.meshgrid(numpy.arange(n + 1.0), numpy.arange(n + 1.0), indexing="ij")
    points = numpy.stack([x, y, height * abs(x - n / 2)], -1).reshape(-1, 3)
    a = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)[None, :]).reshape(-1)
    b, c, d = a + n + 1, a + n + 2, a + 1
    return points, numpy.stack([a, b, c, a, c, d], -1).reshape(-1, 3)


def halves(n):
    return numpy.repeat([0, 1], n * n)


def test_two_sides_of_a_valley():
    points, faces = grid(10, 1)
    labels = region_segmentation.segment(points, faces, 2, method="two-step")
    assert labels.dtype == numpy.uint64
    assert (labels == halves(10)).all()


@pytest.mark.parametrize("method, numbers", [("learned", [1, 3, 7]), ("visibility", [1, 3, 7]), ("smooth-faces", [1, 2])])
def test_numbers_given_and_chosen(method, numbers):
    points, faces = grid(10, 1)
    segmenter = region_segmentation.Segmenter(points, faces, method)
    for k in numbers:
        labels = segmenter.segment(k)
        first = [numpy.flatnonzero(labels == i)[0] for i in range(k)]
        assert labels.max() == k - 1 and first == sorted(first)
        assert (labels == region_segmentation.segment(points, faces, k, method)).all()
    assert (segmenter.segment() == region_segmentation.segment(points, faces, method=method)).all()


def test_constrained_edges_are_borders():
    points, faces = grid(10, 0)
    column = 5 * 11 + numpy.arange(11)
    edges = numpy.stack([column[:-1], column[1:]], -1)
    assert (region_segmentation.segment(points, faces, 1, constrained_edges=edges) == halves(10)).all()


def test_arrays_of_other_types_and_orders():
    points, faces = grid(10, 1)
    expected = region_segmentation.segment(points, faces, 4)
    for p in points.astype("f4"), numpy.asfortranarray(points), points.tolist():
        for f in faces.astype("i4"), numpy.asfortranarray(faces), faces.tolist():
            assert (region_segmentation.segment(p, f, 4) == expected).all()


def test_quads():
    points, faces = grid(10, 1)
    quads = numpy.concatenate([faces[::2], faces[1::2, 2:]], 1)
    assert (region_segmentation.segment(points, quads, 2, method="two-step") == halves(10)[::2]).all()


def test_faces_of_different_sizes():
    points, faces = grid(10, 1)
    quads = numpy.concatenate([faces[::2], faces[1::2, 2:]], 1)
    mixed = quads[:50].tolist() + faces[100:].tolist()
    expected = [0] * 50 + [1] * 100
    assert (region_segmentation.segment(points, mixed, 2, method="two-step") == expected).all()
    sizes = [len(face) for face in mixed]
    flat = numpy.concatenate(mixed).astype("u2")
    assert (region_segmentation.segment(points, flat, 2, method="two-step", face_sizes=sizes) == expected).all()


class Mesh:
    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces


def test_objects_with_vertices_and_faces():
    points, faces = grid(10, 1)
    labels = region_segmentation.segment(Mesh(points, faces), number_of_segments=2, method="two-step")
    assert (labels == halves(10)).all()


def test_soups():
    points, faces = grid(10, 1)
    separate = points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)
    turned = numpy.where((numpy.arange(len(faces)) % 3 == 0)[:, None], faces[:, ::-1], faces)
    unused = numpy.concatenate([points, [[1e9, 0, 0]]])
    expected = region_segmentation.segment(points, faces, 5)
    for p, f in separate, (points, turned), (unused, faces):
        assert (region_segmentation.segment(p, f, 5) == expected).all()


def test_components_are_linked_unless_asked_off():
    points, faces = grid(10, 1)
    two = numpy.concatenate([points, points + [10.5, 0, 0]]), numpy.concatenate([faces, faces + len(points)])
    assert region_segmentation.segment(*two, 1).max() == 0
    with pytest.warns(UserWarning, match="2 segments: 1 are not possible"):
        labels = region_segmentation.segment(*two, 1, component_links=False)
    assert (labels == numpy.repeat([0, 1], 200)).all()


def test_seeds_and_tree():
    points, faces = grid(10, 1)
    segmenter = region_segmentation.Segmenter(points, faces)
    regions, merges = segmenter.regions, segmenter.merges
    assert len(merges) == regions.max()
    seeds = numpy.full(len(faces), -1)
    seeds[0], seeds[1] = 4, 2
    segmenter.set_seeds(seeds)
    labels = segmenter.segment(2)
    assert labels[0] != labels[1]
    column = 5 * 11 + numpy.arange(11)
    segmenter.set_seeds(numpy.full(len(faces), -1))
    segmenter.add_constraints(numpy.stack([column[:-1], column[1:]], -1))
    assert (segmenter.segment(2) == halves(10)).all()


def test_borders():
    points, faces = grid(10, 1)
    column = 5 * 11 + numpy.arange(11)
    expected = numpy.stack([column[:-1], column[1:]], -1)
    borders = region_segmentation.segment_borders(points, faces, halves(10))
    assert (borders == expected).all()
    separate = points[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3)
    assert len(region_segmentation.segment_borders(*separate, halves(10))) == 10
    assert region_segmentation.segment_borders(points, faces, numpy.zeros(200, int)).shape == (0, 2)
    assert len(region_segmentation.segment_borders(Mesh(points, faces), labels=halves(10))) == 10
    # They are borders of another segmentation, as constraints.
    assert (region_segmentation.segment(points, faces, 2, constrained_edges=borders) == halves(10)).all()


def test_descriptions():
    points, faces = grid(10, 1)
    first, second = region_segmentation.describe_segments(points, faces, 3 * halves(10) + 1)
    assert (first["segment"], second["segment"]) == (1, 4)
    assert first["number_of_faces"] == 100
    assert first["area"] == pytest.approx(50 * 2**0.5)
    assert first["centroid"] == pytest.approx((2.5, 5, 2.5))
    assert first["border_length"] == pytest.approx(10)
    assert first["boundary_length"] == pytest.approx(10 + 10 * 2**0.5)
    (neighbor,) = first["neighbors"]
    assert neighbor["segment"] == 4 and neighbor["border_length"] == pytest.approx(10)
    assert neighbor["mean_signed_deviation"] == pytest.approx(-numpy.pi / 2)
    assert first["primitive"]["type"] == "plane" and first["primitive"]["error"] < 1e-9
    normal = numpy.array(first["primitive"]["direction"])
    assert abs(normal @ (1, 0, 1)) == pytest.approx(2**0.5)
    # Three sheets at an edge, and points given twice: torn apart and merged.
    x = numpy.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 1]], "f4")
    sheets = [[0, 1, 2], [1, 0, 3], [0, 1, 4]]
    described = region_segmentation.describe_segments(x, sheets, [0, 1, 2])
    assert [d["area"] for d in described] == [0.5] * 3
    assert len(region_segmentation.describe_segments(points, faces, numpy.full(200, -1))) == 0


def test_descriptions_of_faces_with_a_point_twice():
    points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 0]], "f8")
    faces = [[1, 1, 2], [0, 1, 2], [1, 3, 2], [0, 4, 1], [0, 1, 3, 0, 2]]
    labels = [7, 0, 0, 0, 2]
    assert len(region_segmentation.segment(points, faces, 1)) == len(faces)
    described = region_segmentation.describe_segments(points, faces, labels)
    assert [d["segment"] for d in described] == [7, 0, 2]
    assert [d["number_of_faces"] for d in described] == [1, 3, 1]
    assert [d["area"] for d in described] == [0, 1, 0.5]
    assert [d["primitive"]["type"] for d in described] == ["plane"] * 3


def test_wrong_input_is_named():
    points, faces = grid(3, 1)

    def message(*arguments, **keywords):
        with pytest.raises(ValueError) as error:
            region_segmentation.segment(*arguments, **keywords)
        return str(error.value)

    assert message(points[:, :2], faces) == "points: not an array of n x 3 numbers"
    assert message(points, faces[:, :2]).startswith("faces: not an array of m x 3 indices")
    assert message(points, faces + 7) == "face 6, from 0: index 16 is out of range: there are 16 points"
    assert message(points, [0, 1, 2], face_sizes=[4]) == "face_sizes: their sum is not the number of indices"
    assert message(points, faces, seeds=[1]) == "seeds: not an integer for each face, -1 for none"
    for number in 0, -1, -(10**30):
        expected = f"number_of_segments: not None or an integer of at least 1, but {number}"
        assert message(points, faces, number) == expected
    for number in 2.5, True, numpy.True_, "2":
        for function in region_segmentation.segment, lambda *a: region_segmentation.Segmenter(*a[:2]).segment(a[2]):
            with pytest.raises(TypeError, match=f"^number_of_segments: not None or an integer of at least 1, but {number!r}$"):
                function(points, faces, number)
    assert (region_segmentation.segment(points, faces, numpy.int32(2)) == region_segmentation.segment(points, faces, 2)).all()
    assert all(len(region_segmentation.segment(points, none)) == 0 for none in ([], (), numpy.empty((0, 3), int)))
    assert message(points, faces, method="two-step") == "method two-step needs number_of_segments"
    assert message(points, faces, method="x").startswith("method: not learned")
    assert message(points, faces, constrained_edges=[[0, 9]]) == "constrained_edges: there is no edge between points 0 and 9"
    with pytest.raises(ValueError, match="labels: not an integer for each face"):
        region_segmentation.segment_borders(points, faces, [1, 2])
    with pytest.raises(TypeError, match="labels: not an integer for each face"):
        region_segmentation.describe_segments(points, faces, [0.5] * len(faces))
    points[5] = numpy.nan
    with pytest.raises(region_segmentation.InvalidInput):
        region_segmentation.segment(points, faces)
    for arguments in (points, faces.astype("f8")), ("abc", faces), (points, 5.5), (points,):
        with pytest.raises(TypeError, match=": not "):
            region_segmentation.segment(*arguments)


def test_other_threads_run_meanwhile():
    points, faces = grid(150, 1)
    is_done = threading.Event()
    counts = [0]

    def count():
        while not is_done.is_set():
            counts[0] += 1
            is_done.wait(0.0001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counts[0]
    region_segmentation.Segmenter(points, faces)
    during = counts[0] - before
    is_done.set()
    thread.join()
    assert during > 3
