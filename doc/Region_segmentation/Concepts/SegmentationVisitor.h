/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Follows the progress of a segmentation, and can cancel it. It is called by the thread that called
the function, also if stages run in parallel.
*/
class SegmentationVisitor
{
public:
  /*!
  is called at the start of each stage, and repeatedly within it. The stages are, in this order,
  "reading", "regions", "rays", "draws", "graph", "merging", "borders", as far as the method has them:
  the methods on superfacets merge their draws in "draws", and again in "merging" where there are
  seeds.
  `smooth_borders()` has "reading" and "borders".
  `fraction` is in [0, 1] and does not decrease within a stage.

  \returns false to end the run by `CGAL::Region_segmentation::Segmentation_cancelled`; no map is
           written
  */
  bool on_progress(const char* stage, double fraction);
};
