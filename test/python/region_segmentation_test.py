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


def test_wrong_input_is_named():
    points, faces = grid(3, 1)

    def message(*arguments, **keywords):
        with pytest.raises(ValueError) as error:
            region_segmentation.segment(*arguments, **keywords)
        return str(error.value)

    assert message(points[:, :2], faces) == "points: not an array of n x 3 numbers"
    assert message(points, faces[:, :2]).startswith("faces: not an array of m x 3 indices")
    assert message(points, faces + 7) == "face 6, from 0: index 16 is out of range: there are 16 points"
    assert message(points, [[0, 1, 1]]) == "face 0, from 0: point 1 is there twice"
    assert message(points, [[0, 1, 2], [0, 1, 3]]) == "face 1, from 0: the faces up to this one are not an oriented 2-manifold"
    assert message(points, faces, 0) == "number_of_segments: at least 1"
    assert message(points, faces, method="two-step") == "method two-step needs number_of_segments"
    assert message(points, faces, method="x").startswith("method: not learned")
    assert message(points, faces, constrained_edges=[[0, 9]]) == "constrained_edges: there is no edge between points 0 and 9"
    points[5] = numpy.nan
    with pytest.raises(region_segmentation.InvalidInput):
        region_segmentation.segment(points, faces)
    with pytest.raises(TypeError):
        region_segmentation.segment(points, faces.astype("f8"))


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
