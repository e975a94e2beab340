# Types of the module region_segmentation. A mesh is points and faces, or an object with both.
from collections.abc import Sequence
from typing import Literal, Optional, Protocol, TypedDict, Union, overload

from numpy import uint64
from numpy.typing import ArrayLike, NDArray

__version__: str

class Mesh(Protocol):
    @property
    def vertices(self) -> ArrayLike: ...
    @property
    def faces(self) -> ArrayLike: ...

Faces = Union[ArrayLike, Sequence[Sequence[int]]]
Method = Literal["learned", "visibility", "two-step", "smooth-faces"]
Triple = tuple[float, float, float]

class Neighbor(TypedDict):
    segment: int
    border_length: float
    mean_signed_deviation: float

class Primitive(TypedDict):
    type: Literal["plane", "sphere", "cylinder", "cone"]
    point: Triple
    direction: Triple
    radius: float
    half_angle: float
    error: float

class Description(TypedDict):
    segment: int
    number_of_faces: int
    area: float
    volume: float
    centroid: Triple
    axes: list[Triple]
    extents: Triple
    border_length: float
    boundary_length: float
    neighbors: list[Neighbor]
    primitive: Primitive

class InvalidInput(ValueError): ...

def segment(
    points: Union[ArrayLike, Mesh],
    faces: Optional[Faces] = None,
    number_of_segments: Optional[int] = None,
    method: Method = "learned",
    constrained_edges: Optional[ArrayLike] = None,
    seeds: Optional[ArrayLike] = None,
    component_links: bool = True,
    face_sizes: Optional[ArrayLike] = None,
) -> NDArray[uint64]: ...
@overload
def segment_borders(
    points: ArrayLike, faces: Faces, labels: ArrayLike, face_sizes: Optional[ArrayLike] = None
) -> NDArray[uint64]: ...
@overload
def segment_borders(points: Mesh, *, labels: ArrayLike) -> NDArray[uint64]: ...
@overload
def describe_segments(
    points: ArrayLike, faces: Faces, labels: ArrayLike, face_sizes: Optional[ArrayLike] = None
) -> list[Description]: ...
@overload
def describe_segments(points: Mesh, *, labels: ArrayLike) -> list[Description]: ...

class Segmenter:
    def __init__(
        self,
        points: Union[ArrayLike, Mesh],
        faces: Optional[Faces] = None,
        method: Method = "learned",
        constrained_edges: Optional[ArrayLike] = None,
        seeds: Optional[ArrayLike] = None,
        component_links: bool = True,
        face_sizes: Optional[ArrayLike] = None,
    ) -> None: ...
    def segment(self, number_of_segments: Optional[int] = None) -> NDArray[uint64]: ...
    def add_constraints(self, constrained_edges: ArrayLike) -> None: ...
    def set_seeds(self, seeds: ArrayLike) -> None: ...
    @property
    def regions(self) -> NDArray[uint64]: ...
    @property
    def merges(self) -> list[tuple[int, int, float]]: ...
