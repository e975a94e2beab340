/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a section, all edges that two regions share. Default and copy constructible; `absorb()` is associative and
commutative. The requirements of `RegionData` on annotators, mesh data and derived types apply to them, too: a type that
derives from another model and has members of its own declares its own `absorb()` and, if `Geometry_annotator` provides the
data, its own `add_edge()`.

\cgalHasModel `CGAL::Region_segmentation::Section_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_section_data`
\cgalHasModel `CGAL::Region_segmentation::Learned_section_data`
\cgalHasModel `CGAL::Region_segmentation::Smoothness_section_data`
*/
class SectionData
{
public:
  /// accounts for a dual edge of the mesh; called once for each edge of the section, sorted by their lower face, then by their
  /// higher one.
  void add_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// adds another section between the same two regions.
  void absorb(const SectionData& other);
};
