/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

Deals the regions of a graph out to segments, all at once: for what is no sequence of merges. It takes the place of
policy and chooser in a `SegmentationMethod`. It may name the data that it reads by the types `%RegionData` and
`%SectionData`.

\cgalHasModel `CGAL::Region_segmentation::Spectral_partitioner`
*/
class GraphPartitioner
{
public:
  /*!
  gives every region of the graph a segment.

  \pre no region was removed
  \post there is an element for each region; the number of parts is the wanted one where the graph can be partitioned so.
        Every segment is connected by sections that are mergeable.
  */
  Partition operator()(const Graph& graph, std::size_t number_of_segments) const;
};
