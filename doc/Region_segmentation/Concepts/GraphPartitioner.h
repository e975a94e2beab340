/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Assigns the regions of a graph to segments, for algorithms that are not a sequence of merges. It replaces policy and
chooser in a `SegmentationMethod`. It may declare the data that it reads by the types `%RegionData` and `%SectionData`.

\cgalHasModel `CGAL::Region_segmentation::Spectral_partitioner`
*/
class GraphPartitioner
{
public:
  /*!
  assigns a segment to every region of the graph.

  \pre no region was removed
  \post there is an element for each region; the number of parts is the wanted one if the graph has such a partition.
        Every segment is connected by sections that are mergeable.
  */
  Partition operator()(const Graph& graph, std::size_t number_of_segments) const;
};
