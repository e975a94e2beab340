/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Follows the progress of a segmentation, and can cancel it. It is called by the thread that called the function, also if
stages run in parallel.
*/
class SegmentationVisitor
{
public:
  /*!
  is called at the start of each stage, and repeatedly within it: "reading", "regions", "graph", "merging"; in
  `detect_feature_edges()` "features", in `smooth_borders()` "borders". `fraction` is in [0, 1] and does not decrease
  within a stage.

  \returns false to end the run by `CGAL::Region_segmentation::Segmentation_cancelled`; no map is written
  */
  bool go_further(const char* stage, double fraction);
};
