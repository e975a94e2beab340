# SPDX-License-Identifier: LGPL-3.0-or-later
"""Segmentation of triangle and polygon meshes into parts, and of machine parts into faces.

A mesh is a tuple (points, faces), a mesh of trimesh, Open3D, PyVista or meshio, or another object with
vertices or points, and faces, triangles or cells (of meshio: triangles, quads, polygons). Points are an
array of shape (n, 3); faces an array of shape (m, 3), (m, 4), ... of indices of points, a list of lists
of different lengths, or the padded array of VTK (3, a, b, c, 4, d, e, ...). It need not be manifold,
oriented or connected.

Labels are an int32 for each face, in an array of shape (m,); -1 is no segment. Angles are in degrees;
lengths, areas and volumes in units of the mesh. InvalidInput, a ValueError, names the place of wrong
data. Arguments of wrong types and shapes are a TypeError or ValueError that begins with their name.

threads is the number of threads, None for one a core; labels do not depend on it. progress is called
as progress(stage, fraction), with a str and a float from 0 to 1 for each stage; Cancelled is raised if
it returns False. Ctrl-C interrupts every function that takes progress. Other threads run meanwhile.
"""

from __future__ import annotations

import json
import operator
import os
import shutil
import subprocess
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, Optional, SupportsFloat, SupportsIndex, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Cancelled as Cancelled, InvalidInput as InvalidInput, __version__ as __version__

Cancelled.__module__ = InvalidInput.__module__ = __name__  # as tracebacks say

Method = Literal["learned", "visibility", "two-step", "smooth-faces"]
Progress = Callable[[str, float], Optional[bool]]
Triple = tuple[float, float, float]
Labels = NDArray[np.int32]


@dataclass(frozen=True)
class Neighbor:
    """A segment beside another one."""

    segment: int
    border_length: float
    mean_signed_deviation: float  # the angle between normals, positive for convex edges


@dataclass(frozen=True)
class Surface:
    """What a surface does not have is None."""

    type: Literal["plane", "cylinder", "cone", "sphere", "torus", "freeform"]
    deviation: Optional[float] = None  # the largest distance of a vertex
    point: Optional[Triple] = None  # of a plane, the axis of a cylinder; an apex or a center
    direction: Optional[Triple] = None  # a normal or an axis
    extent: Optional[tuple[float, float]] = None  # from point along direction
    radius: Optional[float] = None  # the major one of a torus
    minor_radius: Optional[float] = None  # of a torus
    half_angle: Optional[float] = None  # of a cone


@dataclass(frozen=True)
class Description:
    """What a segment is like."""

    segment: int
    number_of_faces: int
    area: float
    volume: float  # with caps on the borders
    volume_share: float
    centroid: Triple
    axes: tuple[Triple, Triple, Triple]  # principal axes, the one of largest variance first
    extents: Triple  # of the box along the axes
    border_length: float  # to other segments
    boundary_length: float  # on the border of the mesh
    neighbors: list[Neighbor]
    surface: Surface  # the plane, cylinder, cone or sphere that fits best
    surface_error: float  # the root mean square distance


@dataclass(frozen=True)
class PartFaceNeighbor:
    """A face beside another one."""

    face: int
    length: float
    is_smooth: bool


@dataclass(frozen=True)
class PartFace:
    """A face of a machine part."""

    surface: Surface
    is_concave: bool
    area: float
    first_on_surface: int  # the first face on the same surface
    first_on_axis: int  # the first face with the same axis
    neighbors: list[PartFaceNeighbor]
    role: Optional[Literal["blend", "hole", "boss"]] = None  # fillets and rounds are blends


@dataclass(frozen=True)
class Solid:
    """The faces of a segment, and caps that close its borders."""

    segment: int
    points: NDArray[np.float64]
    faces: Union[NDArray[np.int32], list[list[int]]]  # an array if all have as many corners
    face_of_mesh: NDArray[np.int32]  # for each face; -1 of caps


def _corners_and_sizes(faces: Any) -> tuple[NDArray[Any], NDArray[Any]]:
    expected = "faces: not an array of (m, 3) or more indices, a list of lists of them, or a padded array"
    sizes = None
    try:
        array = np.asarray(faces)
    except ValueError:  # of different lengths
        array, sizes = np.array([i for face in faces for i in face]), np.array([len(face) for face in faces])
    if array.ndim > 0 and len(array) == 0:
        return np.empty(0, int), np.empty(0, int)
    if array.dtype.kind not in "iu":
        raise TypeError(expected)
    if sizes is not None:
        return array, sizes
    if array.ndim == 2 and array.shape[1] >= 3:
        return array.reshape(-1), np.full(len(array), array.shape[1])
    if array.ndim != 1:
        raise ValueError(expected)
    padded, starts, end = array.tolist(), [], 0
    while end < len(padded):
        starts.append(end)
        end += 1 + max(padded[end], 0)
    if end != len(padded):
        raise ValueError("faces: the padded array ends within its last face")
    return np.delete(array, starts), array[starts]


def _arrays(mesh: Any) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Points, the corners of all faces, and how many each face has."""
    if isinstance(mesh, tuple) and len(mesh) == 2:
        points, faces = mesh
    else:
        points = next((getattr(mesh, a) for a in ("vertices", "points") if hasattr(mesh, a)), None)
        faces = next((getattr(mesh, a) for a in ("faces", "triangles") if hasattr(mesh, a)), None)
        if faces is None and isinstance(getattr(mesh, "cells", None), list):
            faces = [f for block in mesh.cells if block.type in ("triangle", "quad", "polygon") for f in block.data]
        if points is None or faces is None:
            raise TypeError("mesh: not a tuple (points, faces), nor an object with points and faces")
    points = np.asarray(points)
    if points.dtype.kind not in "fiu":
        raise TypeError("points: not an array of (n, 3) numbers")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("points: not an array of (n, 3) numbers")
    return points, *_corners_and_sizes(faces)


def _soup(mesh: Any) -> _core.Soup:
    return _core.Soup(*_arrays(mesh))


def _integers(values: Any, shape: tuple[Any, ...], dtype: type, expected: str) -> NDArray[Any]:
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError(expected)
    if array.ndim != len(shape) or array.shape[1:] != shape[1:] or shape[0] not in (None, len(array)):
        raise ValueError(expected)
    result: NDArray[Any] = array.astype(dtype)
    if (result != array).any():
        raise ValueError(expected)
    return result


def _labels(soup: _core.Soup, labels: Any, name: str = "labels") -> Labels:
    return _integers(labels, (len(soup),), np.int32, f"{name}: not an int32 for each face, -1 for none")


def _count(name: str, value: Any) -> Optional[int]:
    expected = f"{name}: not None or an integer of at least 1, but {value!r}"
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, SupportsIndex):
        raise TypeError(expected)
    if operator.index(value) < 1:
        raise ValueError(expected)
    return min(operator.index(value), 2**31 - 1)


def _length(name: str, value: Any) -> float:
    expected = f"{name}: not a finite length of at least 0, but {value!r}"
    if not isinstance(value, SupportsFloat):
        raise TypeError(expected)
    if not 0 <= float(value) < float("inf"):
        raise ValueError(expected)
    return float(value)


def _attributes(values: dict[str, Any], neighbor: type) -> dict[str, Any]:
    return dict(values, neighbors=[neighbor(**n) for n in values["neighbors"]], surface=Surface(**values["surface"]))


class Segmenter:
    """A mesh that is prepared once, and segmented into any number in little time.

    Made without a mesh it is an estimator as of scikit-learn: fit() and fit_predict() take one.

    Parameters
    ----------
    mesh, method, constrained_edges, seeds, component_links, tolerance, threads, progress
        As of segment().

    Attributes
    ----------
    labels_ : numpy.ndarray of int32, shape (m,)
        Those of the last segmentation.

    Examples
    --------
    >>> points = [[0, 0, 1], [0, 1, 1], [1, 0, 0], [1, 1, 0], [2, 0, 1], [2, 1, 1]]
    >>> segmenter = Segmenter((points, [[0, 2, 3, 1], [2, 4, 5, 3]]), method="smooth-faces")
    >>> [segmenter.segment(k).tolist() for k in (1, 2)]
    [[0, 0], [0, 1]]
    """

    labels_: Labels
    _fitted: Optional[_core.Segmenter] = None

    def __init__(
        self, mesh: Any = None, method: Method = "learned", constrained_edges: Optional[ArrayLike] = None,
        seeds: Optional[ArrayLike] = None, component_links: bool = True, tolerance: Optional[float] = None,
        *, threads: Optional[int] = None, progress: Optional[Progress] = None,
    ) -> None:
        if tolerance is not None and method != "smooth-faces":
            raise ValueError("tolerance: only of the method smooth-faces")
        self._method, self._tolerance = str(method), _length("tolerance", tolerance or 0)
        self._edges = np.empty((0, 2), int) if constrained_edges is None else constrained_edges
        self._seeds, self._component_links = seeds, component_links
        self._threads, self._progress = min(_count("threads", threads) or 0, os.cpu_count() or 1), progress
        if mesh is not None:
            self.fit(mesh)

    def fit(self, mesh: Any) -> Segmenter:
        """Prepares a mesh, in place of the one before."""
        soup = _soup(mesh)
        edges = _integers(self._edges, (None, 2), np.int64, "constrained_edges: not an array of (n, 2) indices")
        seeds = _labels(soup, np.full(len(soup), -1) if self._seeds is None else self._seeds, "seeds")
        self._fitted = _core.Segmenter(
            soup, self._method, self._tolerance, edges, seeds, self._component_links, self._threads, self._progress)
        return self

    def fit_predict(self, mesh: Any, number_of_segments: Optional[int] = None) -> Labels:
        """fit(), then segment()."""
        return self.fit(mesh).segment(number_of_segments)

    def segment(self, number_of_segments: Optional[int] = None) -> Labels:
        """The labels of a number of segments, as of the function segment."""
        number = _count("number_of_segments", number_of_segments)
        self.labels_ = self._prepared.segment(number)
        n = int(self.labels_.max(initial=-1)) + 1
        if number not in (None, n):
            warnings.warn(f"{n} segments: {number} are not possible", stacklevel=2)
        return self.labels_

    @property
    def regions(self) -> Labels:
        """What segments consist of: the region of each face, 0 to r - 1. Not with two-step."""
        return self._prepared.regions()

    @property
    def merges(self) -> list[tuple[int, int, float]]:
        """The merges of the regions in their order: (kept, removed, cost). Not with two-step."""
        return self._prepared.merges()

    @property
    def _prepared(self) -> _core.Segmenter:
        if self._fitted is None:
            raise ValueError("mesh: there is none before fit()")
        return self._fitted


def segment(
    mesh: Any, number_of_segments: Optional[int] = None, method: Method = "learned",
    constrained_edges: Optional[ArrayLike] = None, seeds: Optional[ArrayLike] = None, component_links: bool = True,
    tolerance: Optional[float] = None, *, threads: Optional[int] = None, progress: Optional[Progress] = None,
) -> Labels:
    """The segment of each face, 0 to k - 1 in the order of their first faces.

    Parameters
    ----------
    number_of_segments : int, optional
        k; by default the method chooses it. A UserWarning says where it is impossible.
    method : {"learned", "visibility", "two-step", "smooth-faces"}
        Parts as people see them; the same by a formula without training; parts between concave creases, which
        needs a number; the faces of machine parts.
    constrained_edges : array_like of int, shape (n, 2), optional
        Pairs of indices of points: these edges are borders of segments.
    seeds : array_like of int, shape (m,), optional
        Faces with equal seeds end in one segment, others do not; -1 is none.
    component_links : bool
        Whether components that touch or are near each other can be in one segment.
    tolerance : float, optional
        Of smooth-faces: how far vertices may be from their surfaces; by default found from the mesh.

    Returns
    -------
    numpy.ndarray of int32, shape (m,)

    Raises
    ------
    InvalidInput
        Of a point that is not finite, an index out of range, seeds that cannot be met.

    Examples
    --------
    >>> strip = [[i // 2, i % 2, 0] for i in range(8)], [[i, i + 2, i + 3, i + 1] for i in (0, 2, 4)]
    >>> segment(strip, 2, seeds=[0, 1, -1]).tolist()
    [0, 1, 1]
    """
    segmenter = Segmenter(
        None, method, constrained_edges, seeds, component_links, tolerance, threads=threads, progress=progress)
    return segmenter.fit_predict(mesh, number_of_segments)


def segment_borders(mesh: Any, labels: ArrayLike) -> NDArray[np.int64]:
    """The edges between faces of different labels.

    Returns
    -------
    numpy.ndarray of int64, shape (n, 2)
        Sorted indices of points.

    Examples
    --------
    >>> strip = [[i // 2, i % 2, 0] for i in range(8)], [[i, i + 2, i + 3, i + 1] for i in (0, 2, 4)]
    >>> segment_borders(strip, [0, 1, 1]).tolist()
    [[2, 3]]
    """
    soup = _soup(mesh)
    return _core.segment_borders(soup, _labels(soup, labels)).reshape(-1, 2)


def describe_segments(mesh: Any, labels: ArrayLike) -> list[Description]:
    """Describes each segment, in the order of their first faces.

    What is not manifold is torn apart before; faces of fewer than three different points are left out.

    Returns
    -------
    list of Description

    Examples
    --------
    >>> strip = [[i // 2, i % 2, 0] for i in range(8)], [[i, i + 2, i + 3, i + 1] for i in (0, 2, 4)]
    >>> [(d.area, d.neighbors[0].segment, d.surface.type, d.surface.radius) for d in describe_segments(strip, [0, 1, 1])]
    [(1.0, 1, 'plane', None), (2.0, 0, 'plane', None)]
    """
    soup = _soup(mesh)
    return [Description(**_attributes(d, Neighbor)) for d in _core.describe_segments(soup, _labels(soup, labels))]


def find_part_faces(
    mesh: Any, tolerance: Optional[float] = None, *, progress: Optional[Progress] = None,
) -> tuple[Labels, list[PartFace]]:
    """The faces of a machine part as its designer drew them.

    Parameters
    ----------
    tolerance : float, optional
        As of segment().

    Returns
    -------
    labels : numpy.ndarray of int32, shape (m,)
        Those of segment() with smooth-faces.
    faces : list of PartFace
        By label.

    Examples
    --------
    >>> points = [[0, 0, 1], [0, 1, 1], [1, 0, 0], [1, 1, 0], [2, 0, 1], [2, 1, 1]]
    >>> labels, faces = find_part_faces((points, [[0, 2, 3, 1], [2, 4, 5, 3]]))
    >>> labels.tolist(), [(face.surface.type, face.role, face.neighbors[0].is_smooth) for face in faces]
    ([0, 1], [('plane', None, False), ('plane', None, False)])
    """
    labels, faces = _core.find_part_faces(_soup(mesh), _length("tolerance", tolerance or 0), progress)
    return labels, [PartFace(**_attributes(face, PartFaceNeighbor)) for face in faces]


def close_segments(mesh: Any, labels: ArrayLike, clearance: float = 0) -> list[Solid]:
    """Closes each segment by caps on its borders. The solids fit together.

    Parameters
    ----------
    clearance : float
        The distance between the caps of two solids, for parts that are printed; at least 0.

    Returns
    -------
    list of Solid

    Examples
    --------
    >>> mesh = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> [(solid.segment, len(solid.faces), solid.face_of_mesh.tolist()) for solid in close_segments(mesh, [0] * 4)]
    [(0, 4, [0, 1, 2, 3])]
    """
    soup = _soup(mesh)
    closed = _core.close_segments(soup, _labels(soup, labels), _length("clearance", clearance))
    solids = []
    for segment, points, corners, sizes, face_of_mesh in closed:
        polygons = np.split(corners, np.cumsum(sizes)[:-1])
        same = len(set(sizes)) == 1
        faces: Any = np.array(polygons) if same else [p.tolist() for p in polygons]
        solids.append(Solid(segment, points.reshape(-1, 3), faces, face_of_mesh))
    return solids


def to_step(
    mesh: Any, path: Union[str, os.PathLike[str]], *, unit: Literal["mm", "cm", "m", "inch"] = "mm",
    as_found: bool = False, allow_facets: bool = False,
) -> dict[str, Any]:
    """Writes a machine part as solids of planes, cylinders, ... and freeform faces, to a STEP file.

    It runs the program mesh_to_step, which has to be on the PATH: it is an example of the C++ package, and needs
    OpenCASCADE. The manual describes it. FileNotFoundError is raised without it, ValueError with the reason if there
    is no solid; then no file is written. The unit is that of the mesh.

    Returns the report: errors and surfaces of faces, relations, holes, patterns and fillets, in mm.
    """
    program = shutil.which("mesh_to_step")
    if program is None:
        raise FileNotFoundError("to_step: mesh_to_step is not on the PATH; build this example, with OpenCASCADE")
    points, corners, sizes = _arrays(mesh)
    faces = np.split(corners, np.cumsum(sizes)[:-1])
    with tempfile.TemporaryDirectory() as folder:
        part, report = os.path.join(folder, "part.off"), os.path.join(folder, "report.json")
        with open(part, "w") as file:
            print("OFF", len(points), len(faces), 0, file=file)
            for row in (*points.tolist(), *([len(face), *face.tolist()] for face in faces)):
                print(*row, file=file)
        flags = ["--as-found"] * as_found + ["--allow-facets"] * allow_facets
        done = subprocess.run([program, part, path, "--unit", unit, "--report", report, *flags],
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise ValueError(f"to_step: {(done.stdout + done.stderr).strip()}")
        with open(report) as file:
            result: dict[str, Any] = json.load(file)
        return result


def transfer_labels(from_mesh: Any, labels: ArrayLike, to_mesh: Any) -> Labels:
    """The labels of a mesh for another mesh of the same surface, in the same place.

    Returns
    -------
    numpy.ndarray of int32
        By face of to_mesh; -1 of faces of fewer than three different points.

    Examples
    --------
    >>> points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> transfer_labels((points, [[0, 1, 2, 3]]), [7], (points, [[0, 1, 2], [0, 2, 3]])).tolist()
    [7, 7]
    """
    source = _soup(from_mesh)
    return _core.transfer_labels(source, _labels(source, labels), _soup(to_mesh))


def smooth_borders(mesh: Any, labels: ArrayLike, *, progress: Optional[Progress] = None) -> Labels:
    """Moves the borders between segments to where they are short and in valleys.

    Constrained edges of the segmentation are not known here.

    Returns
    -------
    numpy.ndarray of int32, shape (m,)

    Examples
    --------
    >>> strip = [[i // 2, i % 2, 0] for i in range(8)], [[i, i + 2, i + 3, i + 1] for i in (0, 2, 4)]
    >>> smooth_borders(strip, [0, 1, 1]).tolist()
    [0, 1, 1]
    """
    soup = _soup(mesh)
    return _core.smooth_borders(soup, _labels(soup, labels), progress)


def colors(labels: ArrayLike) -> NDArray[np.uint8]:
    """The colors of labels, as in pictures and files of the program; dark gray for -1.

    Returns
    -------
    numpy.ndarray of uint8, shape (m, 3)

    Examples
    --------
    >>> colors([0, 1, -1]).tolist()
    [[68, 119, 170], [238, 102, 119], [96, 96, 96]]
    """
    return _core.colors(_integers(labels, (None,), np.int32, "labels: not an int32 for each face")).reshape(-1, 3)


def show(mesh: Any, labels: ArrayLike) -> None:
    """Opens a window with the mesh in the colors of its labels, by PyVista, or of triangles by trimesh."""
    (points, corners, sizes), rgb = _arrays(mesh), colors(labels)
    try:
        import pyvista
    except ImportError:
        import trimesh

        trimesh.Trimesh(points, corners.reshape(-1, 3), face_colors=rgb, process=False).show()
    else:
        padded = np.insert(corners, np.cumsum(sizes) - sizes, sizes)
        pyvista.PolyData(points, padded).plot(scalars=rgb, rgb=True)
