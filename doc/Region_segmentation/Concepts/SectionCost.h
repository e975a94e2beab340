/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The cost of merging across a section. It depends on the section and on its two regions alone.
`CGAL::Region_segmentation::Lowest_cost_first` turns it into a policy. It may name the data that it reads
by the types `%RegionData` and `%SectionData`: the data of the graph are or derive from these, or the combination does not
compile.

\cgalHasModel `CGAL::Region_segmentation::Visibility_cost`
*/
class SectionCost
{
public:
  /// the cost; not a number if the section must not be merged across.
  double operator()(const Graph& graph, Graph::section_descriptor section) const;
};
