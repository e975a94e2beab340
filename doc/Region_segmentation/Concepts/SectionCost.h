/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

What it costs to merge across a section. It depends on the section and on its two regions alone.
`CGAL::Region_segmentation::Lowest_cost_first` turns it into a policy. It may name the data that it needs
by the types `%RegionData` and `%SectionData`.

\cgalHasModel `CGAL::Region_segmentation::Cut_cost`
*/
class SectionCost
{
public:
  /// the cost; not a number if the section must not be merged across.
  double operator()(const Graph& graph, Graph::section_descriptor section) const;
};
