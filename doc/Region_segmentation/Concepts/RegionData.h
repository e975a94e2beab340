/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a region that policies and costs read. They are collected from the surface before
regions are merged, so that policies and costs need no surface. A model is default and copy
constructible; `absorb()` is associative and commutative.

A type that derives from another model and has members of its own declares its own `absorb()`, which
calls that of the base class, and its own `add_face()` and `add_border()`, if its members are sums.

\cgalHasModel `CGAL::Region_segmentation::Region_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_region_data`
\cgalHasModel `CGAL::Region_segmentation::Learned_region_data`
\cgalHasModel `CGAL::Region_segmentation::Surface_face_region_data`
*/
class RegionData
{
public:
  /// adds a face of the region to its data; called in the order of faces.
  void add_face(const Surface& surface, std::size_t face);

  /// adds an adjacency of the region and another one to the data of the region; called once for
  /// each such adjacency and each of its two regions, in the order of adjacencies.
  void add_border(const Surface& surface, std::size_t adjacency);

  /// adds the data of the region on the other side of the section `between`, which are those before
  /// the merge.
  void absorb(const RegionData& other, const SectionData& between);
};
