/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The members of a region graph that policies, costs and partitioners may use. They access it as `const`.

\cgalRefines `VertexListGraph`, `EdgeListGraph`, `IncidenceGraph` and `AdjacencyGraph` of Boost.Graph, with
`boost::vertex_index` and `boost::edge_index` as property maps, and `get(&RegionData::member, graph)` for any member of the
data of regions or sections.

\cgalHasModel `CGAL::Region_segmentation::Region_adjacency_graph`
*/
class RegionAdjacencyGraph
{
public:
  using RegionData = unspecified_type;         ///< a model of `RegionData`
  using SectionData = unspecified_type;        ///< a model of `SectionData`
  using region_descriptor = unspecified_type;  ///< an integer; the vertex descriptor
  using section_descriptor = unspecified_type; ///< a section seen from one of its regions; the edge descriptor

  /// The result of a merge.
  struct Merge
  {
    region_descriptor kept;    ///< the lower one of the two
    region_descriptor removed;
  };

  const RegionData& operator[](region_descriptor r) const;   ///< the data of a region
  const SectionData& operator[](section_descriptor s) const; ///< the data of a section

  std::size_t number_of_regions() const;       ///< that are not removed
  std::size_t number_of_sections() const;      ///< that are not removed
  std::size_t index_bound_of_regions() const;  ///< indices are below it, removed ones included
  std::size_t index_bound_of_sections() const; ///< as above, for `section_descriptor::id()`

  bool is_removed(region_descriptor r) const;
  bool is_removed(section_descriptor s) const;
  bool is_adjacent(section_descriptor s) const;  ///< whether the regions have a common edge
  bool is_mergeable(section_descriptor s) const; ///< whether they may be merged across the section

  region_descriptor source(section_descriptor s) const; ///< the region from which the section is seen
  region_descriptor target(section_descriptor s) const; ///< the other one
  std::size_t degree(region_descriptor r) const;        ///< the number of its sections

  /// the sections of a region, each with the region as its source.
  unspecified_range sections(region_descriptor r) const;
  /// the section between two regions, with `a` as its source; empty where there is none. O(1) expected.
  std::optional<section_descriptor> section(region_descriptor a, region_descriptor b) const;
};
