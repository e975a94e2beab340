/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

What a region carries. It is filled from the mesh before merging, so that policies need no mesh. Default
and copy constructible; `absorb()` is associative and commutative.

\cgalHasModel `CGAL::Region_segmentation::Region_geometry`
\cgalHasModel `CGAL::Region_segmentation::Part_data`
*/
class RegionData
{
public:
  /// accounts for a face of the region; called in the order of faces.
  void add_face(const Flat_mesh& mesh, std::size_t face);

  /// accounts for a dual edge between the region and another one; called in the order of dual edges.
  void add_border_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// takes in a region on the other side of the section `between`.
  void absorb(const RegionData& other, const SectionData& between);
};
