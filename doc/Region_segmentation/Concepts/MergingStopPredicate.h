/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Decides when merging ends.

\cgalHasModel `CGAL::Region_segmentation::Stop_at_count`
\cgalHasModel `CGAL::Region_segmentation::Stop_at_cost`
*/
class MergingStopPredicate
{
public:
  /// whether to end before the next merge, which would cost `next_cost`.
  bool operator()(const Graph& graph, double next_cost);
};
