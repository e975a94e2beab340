/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a region. They are filled from the mesh before merging, so that policies need no mesh. Default
and copy constructible; `absorb()` is associative and commutative.

A type that derives from another model and has members of its own declares its own `absorb()`, which calls that of the base
class; the inherited one would not merge the members, and does not compile. If `Geometry_annotator` provides the data, it also
declares its own `add_face()` or `add_border_edge()`.

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

  /// accounts for a dual edge between the region and another one; called once for each such edge and each of its two regions,
  /// the edges sorted by their lower face, then by their higher one.
  void add_border_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge);

  /// adds a region on the other side of the section `between`, whose data are those before the merge.
  void absorb(const RegionData& other, const SectionData& between);
};
