/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The cost of merging across a section. It depends only on the section and its two regions.
`CGAL::Region_segmentation::Lowest_cost_first` turns it into a \concept{MergingPolicy}. It may
declare the data that it reads by the types `%RegionData` and `%SectionData`: unless the data of the
graph are or derive from these, the combination does not compile. A lambda that takes
`(const auto& graph, auto section)` is a model, too. It may have a member function
`double recorded_cost(const Graph& graph, Graph::section_descriptor section) const`: the cost of the
merge in the `CGAL::Region_segmentation::Merge_tree`, a number, in place of the cost that determines
the order.

\cgalHasModel `CGAL::Region_segmentation::Visibility_cost`
\cgalHasModel `CGAL::Region_segmentation::Learned_cost`
\cgalHasModel `CGAL::Region_segmentation::Scalar_cost`
\cgalHasModel `CGAL::Region_segmentation::Surface_face_cost`
*/
class SectionCost
{
public:
  /// the cost; not a number if the section must not be merged across.
  double operator()(const Graph& graph, Graph::section_descriptor section) const;
};
