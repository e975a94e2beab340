/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Defines the types of the data of a region graph, and computes those data that are not sums over faces and edges.

It declares the mesh data that it reads by `required_mesh_data`, like a `RegionInitializer`.

\cgalHasModel `CGAL::Region_segmentation::Geometry_annotator`
\cgalHasModel `CGAL::Region_segmentation::Visibility_annotator`
\cgalHasModel `CGAL::Region_segmentation::Learned_annotator`
\cgalHasModel `CGAL::Region_segmentation::Scalar_annotator`
\cgalHasModel `CGAL::Region_segmentation::Smoothness_annotator`
*/
class GraphAnnotator
{
public:
  using RegionData = unspecified_type;  ///< a model of `RegionData`
  using SectionData = unspecified_type; ///< a model of `SectionData`

  /*!
  The data kept between calls for the same mesh with changed regions, so that only new regions are measured. Optional.
  It is default constructible and movable, and has a member function
  `void renumber(const std::vector<std::uint32_t>& previous_of)`: `previous_of[r]` is the former index of region r, or
  the highest number if it is new. It is called before the graph of the changed regions is annotated. The example
  \ref write_a_method.cpp has one.
  */
  using Cache = unspecified_type;

  /*!
  changes the data of regions and sections; may add sections between regions without a common edge by
  `add_nonadjacent_section()`. The data already hold their sums over faces and edges. The result must not depend on earlier
  values of those data that the annotator itself fills: assign before adding. (A graph may be annotated more than once.)

  The call with these three arguments is required, or one with a fourth, `const Execution<ConcurrencyTag>&`, to run in
  parallel, report progress and be cancelled. A type with a `Cache` is in addition callable with a fifth argument, `Cache&`.
  The call with the most arguments is used.
  */
  void operator()(Graph& graph, const Flat_mesh& mesh, const Partition& regions) const;
};
