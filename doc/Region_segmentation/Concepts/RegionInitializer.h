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

  Only the number of elements is checked. If regions are not connected, neither are segments; constrained edges inside a
  region have no effect.
  */
  Partition operator()(const Flat_mesh& mesh) const;

  /*!
  moves the borders of the regions when it is known which of them are borders of segments: the region of each face
  afterwards, by its former number. Optional; called where one tree of merges gives every number of segments. A region
  can lose all its faces: then its merge is left out. A number that is not given has been chosen before.

  `tree`: of the merges of the regions. `is_fixed(region)`: whether its faces must stay in the segments of the region, since
  they have a seed; at most one region of those that are merged.

  `number_of_segments`: if it is less than the number of regions, only the segments of this number are wanted. Then the
  segment of each face may be returned, named by any of its regions; they are those that the regions give for this number.

  \post for every number of merges of `tree`, the faces of each segment are connected, and lie in the connected component of
        the region graph that they lay in
  */
  template <typename IsFixed, typename ConcurrencyTag>
  std::vector<Flat_mesh::Index> straighten_borders(const Flat_mesh& mesh, const Partition& regions,
                                                   const Merge_tree& tree, const IsFixed& is_fixed,
                                                   const Execution<ConcurrencyTag>& execution,
                                                   std::size_t number_of_segments) const;

  /*!
  splits connected regions into a larger number of segments. Optional: without it, there are never more segments than
  regions.

  \post each part is connected and lies in one of `regions`
  */
  template <typename ConcurrencyTag>
  Partition split(const Flat_mesh& mesh, const Partition& regions, std::size_t number_of_segments,
                  const Execution<ConcurrencyTag>& execution) const;
};
