/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Makes the regions from which merging starts.

A type that needs more mesh data than normals, areas, lengths and angles declares them:
`static constexpr Mesh_data required_mesh_data = Mesh_data::POINTS | Mesh_data::CENTROIDS`. Data that were not requested
cannot be read: `CGAL::Region_segmentation::Invalid_method` is thrown.

\cgalHasModel `CGAL::Region_segmentation::Region_growing`
\cgalHasModel `CGAL::Region_segmentation::Superfacets`
*/
class RegionInitializer
{
public:
  /*!
  assigns a region to every face of a mesh.

  Instead, a type may accept a second argument, `const Execution<ConcurrencyTag>&`, to run in parallel, report progress
  and be cancelled; the regions do not depend on the tag.

  \post there is an element for each face, no edge with the flag `CONSTRAINED` joins two faces of a region by itself,
        and every region is connected
  */
  Partition operator()(const Flat_mesh& mesh) const;

  /*!
  splits the regions of a mesh into a larger number of segments. Optional: without it, there are never more segments than
  first regions.

  \post each part lies in a region that `operator()` makes of the mesh
  */
  template <typename ConcurrencyTag>
  Partition split(const Flat_mesh& mesh, std::size_t number_of_segments, const Execution<ConcurrencyTag>& execution) const;
};
