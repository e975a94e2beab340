/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Fills the data of the region graph that its own regions and borders do not sum up, for the policy of
a `CGAL::Region_segmentation::Superfacet_merging`.

\cgalHasModel `CGAL::Region_segmentation::Visibility_annotator`
\cgalHasModel `CGAL::Region_segmentation::Learned_annotator`
\cgalHasModel `CGAL::Region_segmentation::Scalar_annotator`
*/
class GraphAnnotator
{
public:
  /// a model of `RegionData`
  typedef unspecified_type RegionData;

  /// a model of `SectionData`
  typedef unspecified_type SectionData;

  /*!
  sets data of the regions and sections of a graph. Those that sum up faces and borders, by
  `RegionData::add_face()` and the like, are set before. It is called for the graph of each draw, of
  several at the same time with `CGAL::Parallel_tag`, and again when seeds divide regions.

  \param graph a `Region_adjacency_graph<RegionData, SectionData>`; its vertices are the regions
  \param surface the surface that is measured
  \param regions of the faces of the surface
  \param rays from the superfacets of the first draw, and the shapes of the regions
  */
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const;
};
