/*!
\ingroup PkgRegionSegmentationConcepts
\cgalConcept

The data of a region. They are filled from the surface before merging, so that policies and costs
need no surface. Default and copy constructible; `absorb()` is associative and commutative.

A type that derives from another model and has members of its own declares its own `absorb()`, which
calls that of the base class, and the functions that sum its members.

\cgalHasModel `CGAL::Region_segmentation::Region_geometry`
\cgalHasModel `CGAL::Region_segmentation::Visibility_region_data`
\cgalHasModel `CGAL::Region_segmentation::Learned_region_data`
\cgalHasModel `CGAL::Region_segmentation::Scalar_region_data`
\cgalHasModel `CGAL::Region_segmentation::Surface_face_region_data`
*/
class RegionData
{
public:
  /// accounts for a face of the region; called in the order of faces.
  void add_face(const Surface& surface, std::size_t face);

  /// accounts for an adjacency of the region and another one; called once for each such adjacency
  /// and each of its two regions, in the order of adjacencies.
  void add_border(const Surface& surface, std::size_t adjacency);

  /// adds a region on the other side of the section `between`, whose data are those before the
  /// merge.
  void absorb(const RegionData& other, const SectionData& between);
};
