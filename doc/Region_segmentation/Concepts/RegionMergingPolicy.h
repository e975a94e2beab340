/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Which section goes next. A policy may name the data that it needs by the types `%RegionData` and
`%SectionData`; without them it gets `CGAL::Region_segmentation::Region_geometry` and
`CGAL::Region_segmentation::Section_geometry`. It may name what `CGAL::Region_segmentation::segment()` uses
it with by the types `%RegionInitializer`, `%GraphAnnotator` and `%NumberChooser`; without them these are
`CGAL::Region_segmentation::Region_growing`, none, and none.

\cgalHasModel `CGAL::Region_segmentation::Smallest_region_first`
\cgalHasModel `CGAL::Region_segmentation::Least_compact_region_first`
\cgalHasModel `CGAL::Region_segmentation::Lowest_cost_first`
\cgalHasModel `CGAL::Region_segmentation::Policy_sequence`
\cgalHasModel `CGAL::Region_segmentation::Two_step`
\cgalHasModel `CGAL::Region_segmentation::Best`
*/
class RegionMergingPolicy
{
public:
  /// is called before the first merge; a policy that gives every number from one tree ignores the
  /// second argument.
  void initialize(const Graph& graph, std::size_t number_of_segments);

  /// proposes the next merge, of a section for which `graph.is_mergeable(section)`; empty when nothing is left. It may be
  /// asked again before the proposal was carried out, and then proposes the same.
  std::optional<Merge_candidate> next(const Graph& graph);

  /// is called after each merge.
  void on_merge(const Graph& graph, const Graph::Merge& merge);
};
