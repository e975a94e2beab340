/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Fills those data of regions and sections that are no sums over faces and adjacencies, for the policy
of a `CGAL::Region_segmentation::Superfacet_merging`.

\cgalHasModel `CGAL::Region_segmentation::Visibility_annotator`
\cgalHasModel `CGAL::Region_segmentation::Learned_annotator`
*/
class GraphAnnotator
{
public:
  /// a model of `RegionData`
  typedef unspecified_type RegionData;

  /// a model of `SectionData`
  typedef unspecified_type SectionData;

  /*!
  sets data of the regions and sections of a graph. The sums of `RegionData::add_face()`,
  `RegionData::add_border()` and `SectionData::add_adjacency()` have been computed before. The
  function is called for the graph of each draw, with `CGAL::Parallel_tag` for several graphs at the
  same time, and again when seeds divide regions.

  \param graph a `Region_adjacency_graph<RegionData, SectionData>`; its vertices are the regions
  \param surface the surface that is measured
  \param regions of the faces of the surface
  \param rays the rays from the superfacets of the first draw, and the shapes of the regions
  */
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const;
};
