/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a region. They are filled from the mesh before merging, so that policies need no mesh. Default
and copy constructible; `absorb()` is associative and commutative.

Data that are more than sums declare the annotator that fills them as `%GraphAnnotator`: with another one, unless
derived from it, they do not compile. They declare the mesh data that they read by `required_mesh_data`, like a
`RegionInitializer`.

\cgalHasModel `CGAL::Region_segmentation::Region_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_region_data`
\cgalHasModel `CGAL::Region_segmentation::Learned_region_data`
\cgalHasModel `CGAL::Region_segmentation::Scalar_region_data`
\cgalHasModel `CGAL::Region_segmentation::Smoothness_region_data`
*/
class RegionData
{
public:
  /// accounts for a face of the region; called in the order of faces.
  void add_face(const Flat_mesh& mesh, std::size_t face);

  /// accounts for a dual edge between the region and another one; called by the lower, then by the higher face of the edges.
  void add_border_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// adds a region on the other side of the section `between`.
  void absorb(const RegionData& other, const SectionData& between);
};
