/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Chooses the number of segments where none is wanted. A merging policy whose order does not depend on the
number names its chooser by the nested type `%NumberChooser`.

\cgalHasModel `CGAL::Region_segmentation::Number_from_costs`
*/
class NumberChooser
{
public:
  /// the number at which the tree, merged to the end, is to be cut.
  std::size_t operator()(const Merge_tree& tree) const;
};
