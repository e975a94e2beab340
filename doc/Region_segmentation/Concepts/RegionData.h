/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a region. They are filled from the mesh before merging, so that policies need no mesh. Default
and copy constructible; `absorb()` is associative and commutative.

Data that are more than sums name the annotator that fills them as `%GraphAnnotator`: with another one, unless it derives
from it, they do not compile. They state with `required_mesh_data` what they read of the mesh, as a `RegionInitializer`
does.

\cgalHasModel `CGAL::Region_segmentation::Region_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_region_data`
*/
class RegionData
{
public:
  /// accounts for a face of the region; called in the order of faces.
  void add_face(const Flat_mesh& mesh, std::size_t face);

  /// accounts for a dual edge between the region and another one; called by the lower, then by the higher face of the edges.
  void add_border_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// takes in a region on the other side of the section `between`.
  void absorb(const RegionData& other, const SectionData& between);
};
