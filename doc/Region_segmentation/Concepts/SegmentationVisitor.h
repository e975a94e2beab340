/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Is told how far a segmentation is, and can end it.
*/
class SegmentationVisitor
{
public:
  /*!
  is called at the start of each stage, and about a hundred times in a long one: "reading", "features",
  "regions", "merging". `fraction` is in [0, 1] and does not fall within a stage.

  \returns false to end the run by `CGAL::Region_segmentation::Segmentation_cancelled`
  */
  bool go_further(const char* stage, double fraction);
};
