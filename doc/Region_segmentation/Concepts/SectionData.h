/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a section, which consists of all edges, seams and links that two regions share. A model
is default and copy constructible; `absorb()` is associative and commutative. A type that derives
from another model and has members of its own declares its own `add_adjacency()` and `absorb()`,
which call those of the base class.

\cgalHasModel `CGAL::Region_segmentation::Section_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_section_data`
\cgalHasModel `CGAL::Region_segmentation::Learned_section_data`
\cgalHasModel `CGAL::Region_segmentation::Surface_face_section_data`
*/
class SectionData
{
public:
  /// adds an adjacency of the surface to the data of the section; called once for each adjacency of
  /// the section, in order: adjacencies are sorted by their higher, then by their lower face.
  void add_adjacency(const Surface& surface, std::size_t adjacency);

  /// adds the data of another section between the same two regions.
  void absorb(const SectionData& other);
};
