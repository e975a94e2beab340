# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation of triangle and polygon meshes into parts, and of machine parts into faces.

A mesh is points, an array of shape (n, 3), and faces: an array of shape (m, 3), (m, 4), ... of indices
of points, a list of lists of different lengths, or the padded array of VTK (3, a, b, c, 4, d, e, ...).
In place of both it can be a tuple of them, or a mesh of trimesh, Open3D, PyVista or meshio, or another
object with vertices or points, and faces, triangles or cells (of meshio: triangles, quads, polygons).
It need not be manifold, oriented or connected.

Labels are an int32 for each face, in an array of shape (m,); -1 is no segment. Angles are in degrees;
lengths, areas and volumes in units of the mesh. InvalidInput, a ValueError, names the place of wrong
data. Arguments of wrong types and shapes are a TypeError or ValueError that begins with their name.

threads is the number of threads, None for one a core; labels do not depend on it. progress is called
as progress(stage, fraction), with a str and a float from 0 to 1 for each stage; Cancelled is raised if
it returns False. Ctrl-C interrupts every function that takes progress. Other threads run meanwhile.
"""

from __future__ import annotations

import operator
import warnings
from collections.abc import Callable
from typing import Any, Literal, Optional, SupportsIndex, TypedDict, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Cancelled, InvalidInput, __version__

Cancelled.__module__ = InvalidInput.__module__ = __name__  # as tracebacks say

Method = Literal["learned", "visibility", "two-step", "smooth-faces"]
Progress = Callable[[str, float], Optional[bool]]
Triple = tuple[float, float, float]
Labels = NDArray[np.int32]


class Neighbor(TypedDict):
    segment: int
    border_length: float
    mean_signed_deviation: float  # the angle between normals, positive for convex edges


class Surface(TypedDict):
    type: Literal["plane", "cylinder", "cone", "sphere", "torus", "freeform"]
    point: Triple  # of a plane, the axis of a cylinder; an apex or a center
    direction: Triple  # a normal or an axis; (0, 0, 0) of a sphere
    radius: float  # the major one of a torus; 0 if there is none
    minor_radius: float  # of a torus
    half_angle: float  # of a cone


class Primitive(Surface):
    error: float  # root mean square distance


class Description(TypedDict):
    segment: int
    number_of_faces: int
    area: float
    volume: float  # with caps on the borders
    volume_share: float
    centroid: Triple
    axes: list[Triple]  # principal axes, the one of largest variance first
    extents: Triple  # of the box along the axes
    border_length: float  # to other segments
    boundary_length: float  # on the border of the mesh
    neighbors: list[Neighbor]
    primitive: Primitive  # the plane, cylinder, cone or sphere that fits best


class PartFaceNeighbor(TypedDict):
    face: int
    length: float
    is_smooth: bool


class PartFace(Surface):
    is_concave: bool
    extent: tuple[float, float]  # from point along direction
    deviation: float  # the largest distance of a vertex
    role: Literal["none", "blend", "hole", "boss"]  # fillets and rounds are blends
    area: float
    first_on_surface: int  # the first face on the same surface
    first_on_axis: int  # the first face with the same axis
    neighbors: list[PartFaceNeighbor]


class Solid(TypedDict):
    segment: int
    points: NDArray[np.float64]
    faces: Union[NDArray[np.int32], list[list[int]]]  # an array if all have as many corners
    face_of_mesh: NDArray[np.int32]  # for each face; -1 of caps


def _corners_and_sizes(faces: Any) -> tuple[np.ndarray, np.ndarray]:
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


def _soup(mesh: Any, faces: Any = None) -> _core.Soup:
    points = mesh
    if faces is None and isinstance(mesh, tuple) and len(mesh) == 2:
        points, faces = mesh
    elif faces is None:
        points = next((getattr(mesh, a) for a in ("vertices", "points") if hasattr(mesh, a)), None)
        faces = next((getattr(mesh, a) for a in ("faces", "triangles") if hasattr(mesh, a)), None)
        if faces is None and isinstance(getattr(mesh, "cells", None), list):
            faces = [f for block in mesh.cells if block.type in ("triangle", "quad", "polygon") for f in block.data]
        if points is None or faces is None:
            raise TypeError("mesh: not points and faces, nor an object with vertices or points, and faces or triangles")
    elif hasattr(mesh, "vertices") or hasattr(mesh, "points"):
        raise TypeError("faces: given beside a mesh; name what follows the mesh, as in number_of_segments=8")
    points = np.asarray(points)
    if points.dtype.kind not in "fiu":
        raise TypeError("points: not an array of (n, 3) numbers")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("points: not an array of (n, 3) numbers")
    return _core.Soup(points, *_corners_and_sizes(faces))


def _integers(values: Any, shape: tuple, dtype: type, expected: str) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError(expected)
    if array.ndim != len(shape) or array.shape[1:] != shape[1:] or shape[0] not in (None, len(array)):
        raise ValueError(expected)
    result = array.astype(dtype)
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


class Segmenter:
    """A mesh that is prepared once, with the arguments of segment(), and segmented into any number in little time."""

    def __init__(
        self, mesh: Any, faces: Any = None, method: Method = "learned",
        constrained_edges: Optional[ArrayLike] = None, seeds: Optional[ArrayLike] = None, component_links: bool = True,
        *, threads: Optional[int] = None, progress: Optional[Progress] = None,
    ) -> None:
        soup = _soup(mesh, faces)
        edges = _integers(
            np.empty((0, 2), int) if constrained_edges is None else constrained_edges, (None, 2), np.int64,
            "constrained_edges: not an array of (n, 2) indices")
        labels = _labels(soup, np.full(len(soup), -1) if seeds is None else seeds, "seeds")
        threads = _count("threads", threads) or 0
        self._core = _core.Segmenter(soup, method, edges, labels, component_links, threads, progress)

    def segment(self, number_of_segments: Optional[int] = None) -> Labels:
        """The labels of a number of segments, as of the function segment."""
        number = _count("number_of_segments", number_of_segments)
        labels = self._core.segment(number)
        n = int(labels.max(initial=-1)) + 1
        if number not in (None, n):
            warnings.warn(f"{n} segments: {number} are not possible", stacklevel=2)
        return labels

    @property
    def regions(self) -> Labels:
        """What segments consist of: the region of each face, 0 to r - 1. Not with two-step."""
        return self._core.regions()

    @property
    def merges(self) -> list[tuple[int, int, float]]:
        """The merges of the regions in their order: (kept, removed, cost). Not with two-step."""
        return self._core.merges()


def segment(
    mesh: Any, faces: Any = None, number_of_segments: Optional[int] = None, method: Method = "learned",
    constrained_edges: Optional[ArrayLike] = None, seeds: Optional[ArrayLike] = None, component_links: bool = True,
    *, threads: Optional[int] = None, progress: Optional[Progress] = None,
) -> Labels:
    """The segment of each face, 0 to k - 1 in the order of their first faces.

    number_of_segments: k; by default the method chooses it. There is a UserWarning where it is impossible.
    method: learned (parts as people see them), visibility (the same by a formula without training), two-step
        (parts between concave creases; needs a number), or smooth-faces (the faces of machine parts).
    constrained_edges: indices of points of shape (n, 2); these edges are borders of segments.
    seeds: an integer for each face, -1 for none; faces with equal seeds end in one segment, others do not.
    component_links: whether components that touch or are near each other can be in one segment.
    """
    segmenter = Segmenter(
        mesh, faces, method, constrained_edges, seeds, component_links, threads=threads, progress=progress)
    return segmenter.segment(number_of_segments)


def segment_borders(mesh: Any, faces: Any = None, labels: ArrayLike = ()) -> NDArray[np.int64]:
    """The edges between faces of different labels: sorted indices of points, of shape (n, 2)."""
    soup = _soup(mesh, faces)
    return _core.segment_borders(soup, _labels(soup, labels)).reshape(-1, 2)


def describe_segments(mesh: Any, faces: Any = None, labels: ArrayLike = ()) -> list[Description]:
    """A dictionary for each segment: see Description. They are in the order of their first faces.

    What is not manifold is torn apart before; faces of fewer than three different points are left out.
    """
    soup = _soup(mesh, faces)
    return _core.describe_segments(soup, _labels(soup, labels))


def find_part_faces(
    mesh: Any, faces: Any = None, *, progress: Optional[Progress] = None) -> tuple[Labels, list[PartFace]]:
    """The faces of a machine part as its designer drew them: their labels, and a PartFace for each.

    Faces of the mesh of fewer than three different points have the label -1.
    """
    return _core.find_part_faces(_soup(mesh, faces), progress)


def close_segments(mesh: Any, faces: Any = None, labels: ArrayLike = (), clearance: float = 0) -> list[Solid]:
    """A closed mesh for each segment, its faces and caps: see Solid. They fit together.

    clearance: the distance between the caps of two solids, for parts that are printed; 0 or more.
    """
    if not 0 <= clearance < float("inf"):
        raise ValueError(f"clearance: not a finite length of at least 0, but {clearance!r}")
    soup = _soup(mesh, faces)
    solids = []
    for segment, points, corners, sizes, face_of_mesh in _core.close_segments(soup, _labels(soup, labels), clearance):
        polygons = np.split(corners, np.cumsum(sizes)[:-1])
        same = len(set(sizes)) == 1
        polygons = np.array(polygons) if same else [polygon.tolist() for polygon in polygons]
        solids.append(Solid(segment=segment, points=points.reshape(-1, 3), faces=polygons, face_of_mesh=face_of_mesh))
    return solids


def transfer_labels(from_mesh: Any, labels: ArrayLike, to_mesh: Any) -> Labels:
    """The labels of from_mesh for the faces of to_mesh: another mesh of the same surface, in the same place.

    Meshes are objects or tuples (points, faces). Faces of fewer than three different points get -1.
    """
    source = _soup(from_mesh)
    return _core.transfer_labels(source, _labels(source, labels), _soup(to_mesh))


def smooth_borders(
    mesh: Any, faces: Any = None, labels: ArrayLike = (), *, progress: Optional[Progress] = None) -> Labels:
    """The labels with the borders between segments moved to where they are short and in valleys.

    Constrained edges of the segmentation are not known here.
    """
    soup = _soup(mesh, faces)
    return _core.smooth_borders(soup, _labels(soup, labels), progress)
