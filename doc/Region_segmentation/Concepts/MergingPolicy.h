/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Proposes which regions are merged next. Copy constructible. Several policies one after the other are
`CGAL::Region_segmentation::Policy_phases`. `Graph` is a
`CGAL::Region_segmentation::Region_adjacency_graph`, which a policy does not change.

It may declare the data that it reads by the types `%RegionData` and `%SectionData`: unless the data
of the graph are or derive from these, the combination does not compile.

\cgalHasModel `CGAL::Region_segmentation::Lowest_cost_first`
\cgalHasModel `CGAL::Region_segmentation::Smallest_region_first`
\cgalHasModel `CGAL::Region_segmentation::Least_compact_region_first`
*/
class MergingPolicy
{
public:
  /// is called before the first merge of each run.
  void initialize(const Graph& graph);

  /// proposes the next merge, of a section for which `graph.is_mergeable(section)`; empty if there
  /// is none. The cost of the candidate is a number: otherwise
  /// `CGAL::Region_segmentation::Invalid_method` is thrown. If called again before the proposal is
  /// carried out, it proposes the same.
  std::optional<Merge_candidate> next(const Graph& graph);

  /// is called after each merge. Sections of the kept region may also have become not mergeable.
  void on_merge(const Graph& graph, const Graph::Merge& merge);
};
