/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Names the types of the data of a region graph, and fills in what cannot be summed face by face and edge by edge.

It states with `required_mesh_data` what it reads of the mesh, as a `RegionInitializer` does.

\cgalHasModel `CGAL::Region_segmentation::Geometry_annotator`
\cgalHasModel `CGAL::Region_segmentation::Visibility_annotator`
*/
class GraphAnnotator
{
public:
  using RegionData = unspecified_type;  ///< a model of `RegionData`
  using SectionData = unspecified_type; ///< a model of `SectionData`

  /*!
  What is kept between two calls for the same mesh with changed regions, so that only new regions are measured.
  Optional. It is default constructible and movable, and has a member function
  `void renumber(const std::vector<std::uint32_t>& previous_of)`: `previous_of[r]` is what the region r was called before, or
  the highest number if it is new.
  */
  using Cache = unspecified_type;

  /*!
  changes the data of regions and sections; may add sections between regions without a common edge by
  `add_nonadjacent_section()`. The data hold their sums over faces and edges already. Annotating a graph twice is the same
  as once.

  A type may take a fourth argument, `const Execution<ConcurrencyTag>&`, and with a cache a fifth, `Cache&`.
  */
  void operator()(Graph& graph, const Flat_mesh& mesh, const Partition& regions) const;
};
