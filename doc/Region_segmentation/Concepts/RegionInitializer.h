/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

A maker of the regions that merging starts from.

A type that needs the points of the mesh says so by
`static constexpr Flat_mesh::Content content = Flat_mesh::Content::ANGLES_AND_POINTS`.

\cgalHasModel `CGAL::Region_segmentation::Region_growing`
\cgalHasModel `CGAL::Region_segmentation::Superfacets`
*/
class RegionInitializer
{
public:
  /*!
  gives every face of a mesh a region. `is_feature` holds a byte for each dual edge of the mesh, not 0
  where it is a feature edge.

  A maker that can work in parallel takes a third argument, a concurrency tag, and is called with that of
  `segment()`; it gives the same regions with either.

  \post the ids are 0 .. number_of_regions - 1, numbered by their first face; every region is connected
  */
  Region_labels operator()(const Flat_mesh& mesh, const Edge_marks& is_feature) const;
};
