/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

What a section, all edges that two regions share, carries. Default and copy constructible; `absorb()` is
associative and commutative.

\cgalHasModel `CGAL::Region_segmentation::Section_geometry`
\cgalHasModel `CGAL::Region_segmentation::Cut_data`
*/
class SectionData
{
public:
  /// accounts for a dual edge of the mesh; called in the order of dual edges.
  void add_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// takes in another section between the same two regions.
  void absorb(const SectionData& other);
};
