/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Chooses the number of segments where none is given, from the merges of a policy whose order does not
depend on it.

\cgalHasModel `CGAL::Region_segmentation::Number_from_costs`
\cgalHasModel `CGAL::Region_segmentation::Number_from_expected_costs`
\cgalHasModel `CGAL::Region_segmentation::Number_below_cost`
*/
class NumberChooser
{
public:
  /*!
  the number of segments, at least 1. A number that the tree does not have is replaced by the
  nearest one that it has.

  The tree holds all merges, those of crumbs first, down to one segment for each connected piece of
  the region graph, unless the policy ends before, or sections are barred. It is the tree before
  borders are straightened. Straightening can take all faces from a region, which leaves out a merge
  of the tree; so the final tree may have fewer regions than this one.
  */
  std::size_t operator()(const Merge_tree& tree, const Surface& surface) const;
};
