/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The computation between reading a mesh and its labels: a value whose public members are the parts of a method, each an
instance that may hold constants, data and state of the user. `CGAL::Region_segmentation::segment()` and
`CGAL::Region_segmentation::Segmenter` store a copy. Every run copies the policy, so a method can be reused, also from
several threads; parts that share state hold pointers to it.

A method has the members `initializer`, `annotator`, and either `policy` and `chooser`, or `partitioner`.

Only the annotator defines the types of the graph's data. The other parts must read these types: otherwise the
combination does not compile, and a static assertion states the reason.

\cgalHasModel `CGAL::Region_segmentation::Segmentation_method`
\cgalHasModel `CGAL::Region_segmentation::Partitioning_method`
\cgalHasModel `CGAL::Region_segmentation::Visibility_merging`
\cgalHasModel `CGAL::Region_segmentation::Learned_merging`
\cgalHasModel `CGAL::Region_segmentation::Two_step`
\cgalHasModel `CGAL::Region_segmentation::Smooth_faces`
*/
class SegmentationMethod
{
public:
  RegionInitializer initializer; ///< makes the first regions
  GraphAnnotator annotator;      ///< defines and fills the data of the region graph

  /// \name Merging
  /// @{
  RegionMergingPolicy policy; ///< proposes which regions are merged next
  /// Chooses the number of segments where none is given, or `CGAL::Region_segmentation::No_number_chooser`.
  NumberChooser chooser;
  /// @}

  /// \name Or Partitioning
  /// @{
  GraphPartitioner partitioner; ///< assigns the regions to a given number of segments
  /// @}
};
