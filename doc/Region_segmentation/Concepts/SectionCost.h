/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The cost of merging two regions across their section. It depends only on the section and its two
regions. `CGAL::Region_segmentation::Lowest_cost_first` makes a \concept{MergingPolicy} of it. A
lambda that takes `(const auto& graph, auto section)` is a model, too.

A cost may name the data that it reads by the nested types `%RegionData` and `%SectionData`. It then
compiles only with a graph whose data are of these types, or derive from them.

A cost may have a member function
`double recorded_cost(const Graph& graph, Graph::section_descriptor section) const`. Its value, which
is a number, is the cost of the merge in the `CGAL::Region_segmentation::Merge_tree`, in place of the
cost that determines the order of merges.

\cgalHasModel `CGAL::Region_segmentation::Visibility_cost`
\cgalHasModel `CGAL::Region_segmentation::Learned_cost`
\cgalHasModel `CGAL::Region_segmentation::Surface_face_cost`
*/
class SectionCost
{
public:
  /// returns the cost of merging across the section; NaN if its regions must not be merged.
  double operator()(const Graph& graph, Graph::section_descriptor section) const;
};
