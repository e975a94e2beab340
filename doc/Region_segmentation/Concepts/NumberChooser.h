/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Chooses the number of segments where none is given, from the merges of a policy whose order does not
depend on it. It is used where no number is given, and to compare draws of superfacets.

The constants of the models have the unit of the costs, and are found anew for another cost:
- `CGAL::Region_segmentation::Number_from_costs` is for costs on a logarithmic scale. On a few meshes
  whose number \f$k\f$ is known, let \f$c_k\f$ be the cost of the merge from \f$k\f$ to
  \f$k - 1\f$ regions (`merges()[number_of_regions() - k].cost` of the `merge_tree`), \f$b\f$ the
  highest cost of the merges before it, from 40 regions on, and \f$c\f$ the highest of all from
  there. If \f$b < c_k\f$, the level \f$b + c_k - c\f$ gives \f$k\f$; take the mean of the
  meshes. A cost that is larger by a constant has a level that is larger by it.
- `CGAL::Region_segmentation::Number_below_cost` is for costs that mean the same on every mesh: its
  bound is the cost above which two regions are not one.
- `CGAL::Region_segmentation::Number_from_expected_costs` is for costs whose sum is to be lowest: they
  are below 0 where a merge pays.

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
