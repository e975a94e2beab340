/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Adds to the data of a region graph what cannot be told face by face and edge by edge, before merging.
A merging policy names its annotator by the nested type `%GraphAnnotator`.

\cgalHasModel `CGAL::Region_segmentation::Sight`
*/
class GraphAnnotator
{
public:
  /// changes the data of regions and sections; may add sections between regions without a common edge. One
  /// that can work in parallel takes a fourth argument, the concurrency tag of `segment()`.
  void operator()(Graph& graph, const Flat_mesh& mesh, const Region_labels& regions) const;
};
