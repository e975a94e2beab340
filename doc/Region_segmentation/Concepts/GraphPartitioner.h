/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Deals the regions of a graph out to segments, all at once: for what is no sequence of merges. It may name the
data that it needs by the types `%RegionData` and `%SectionData`.
`CGAL::Region_segmentation::partition_into_segments()` runs it on a mesh.

\cgalHasModel `CGAL::Region_segmentation::Spectral_partitioner`
*/
class GraphPartitioner
{
public:
  /*!
  gives every region of the graph a segment. `%Merge_tree::Segmentation::of_region` has an entry for each index
  of a region; that of a removed region has no meaning.

  \post the ids are 0 .. number_of_segments - 1, numbered by the first region that is not removed; the number
  is the wanted one where the graph can be partitioned so. Every segment is connected by sections that are
  mergeable.
  */
  Merge_tree::Segmentation operator()(const Graph& graph, std::size_t number_of_segments) const;
};
