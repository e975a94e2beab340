/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Proposes which regions are merged next. A policy is copy constructible. Several policies that take
over from each other are a `CGAL::Region_segmentation::Policy_phases`. `Graph` is a
`CGAL::Region_segmentation::Region_adjacency_graph`, which a policy does not change.

\cgalHasModel `CGAL::Region_segmentation::Lowest_cost_first`
\cgalHasModel `CGAL::Region_segmentation::Smallest_region_first`
\cgalHasModel `CGAL::Region_segmentation::Least_compact_region_first`
*/
class MergingPolicy
{
public:
  /// is called before the first merge of each run.
  void initialize(const Graph& graph);

  /// proposes the next merge, across a section for which `graph.is_mergeable(section)` is `true`;
  /// returns nothing if there is no such section. The cost of the candidate is a number: otherwise
  /// `CGAL::Region_segmentation::Invalid_method` is thrown. If the function is called again before
  /// the regions are merged, it proposes the same merge.
  std::optional<Merge_candidate> next(const Graph& graph);

  /// is called after each merge. A section of the kept region that was mergeable before may not be
  /// mergeable any more.
  void on_merge(const Graph& graph, const Graph::Merge& merge);
};
