// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SURFACE_FACE_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_SURFACE_FACE_COST_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/Surface_faces.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/faces/find_face_roles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// How the surfaces of two faces meet along a section, filled by `annotate_surface_faces()`. A
/// model of `SectionData`.
struct Surface_face_section_data
{
  double length = 0; ///< of edges and seams, in units of the square root of the area of the surface
  double smooth_length = 0; ///< of those at which the two surfaces meet smoothly

  bool has_links_alone() const { return !(length > 0); }
  bool is_smooth() const { return smooth_length > 0.5 * length; }

  void add_adjacency(const Surface& surface, std::size_t adjacency)
  {
    if (!surface.has_flag(adjacency, Surface::LINK))
      length += surface.length(adjacency) / surface.length_unit();
  }

  /// Adds another section between the same two regions.
  void absorb(const Surface_face_section_data& other)
  {
    length += other.length;
    smooth_length += other.smooth_length;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area and role of a region of faces of a machine part, filled by `annotate_surface_faces()`. A
/// model of `RegionData`.
struct Surface_face_region_data
{
  using Index = Partition::Index;
  static constexpr Index several = (std::numeric_limits<Index>::max)();

  double area = 0;      ///< as a share of the area of the surface
  Index face = several; ///< the part of `Surface_faces` that it belongs to, or `several`
  Face_role role = Face_role::NONE; ///< that of all of its faces, or none

  void add_face(const Surface& surface, std::size_t f)
  {
    area += surface.area() > 0 ? surface.weight(f) / surface.area() : 0;
  }
  void add_border(const Surface&, std::size_t /* adjacency */) {}

  /// Adds the region on the other side of a section. One without area, as a crumb, does not count.
  void absorb(const Surface_face_region_data& other, const Surface_face_section_data& /* between */)
  {
    if (area == 0)
      *this = other;
    else if (other.area > 0) {
      area += other.area;
      face = face == other.face ? face : several;
      role = role == other.role ? role : Face_role::NONE;
    }
  }
};

/// \ingroup PkgRegionSegmentationAnnotators
/// fills a graph of regions, of which each is a face of a machine part or a piece of one.
///
/// Complexity: O(F).
template <typename Graph>
void annotate_surface_faces(Graph& graph, const Surface& surface, const Partition& regions,
                            const Surface_faces& faces)
{
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    graph[regions[f]].face = faces.partition[f];
    graph[regions[f]].role = faces.roles[faces.partition[f]];
  }
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const std::size_t f = surface.lower_face(a), g = surface.higher_face(a);
    if (regions[f] == regions[g] ||
        !internal::meet_smoothly(surface, a, faces.surfaces[faces.partition[f]],
                                 faces.surfaces[faces.partition[g]]))
      continue;
    if (const auto section = graph.section(regions[f], regions[g]))
      graph[*section].smooth_length += surface.length(a) / surface.length_unit();
  }
}

/// \ingroup PkgRegionSegmentationPolicies
/// The order in which faces of a machine part are merged where fewer segments are wanted: by rank,
/// then by size. A model of `SectionCost`.
///
/// | rank | two regions |
/// |---|---|
/// | 0 | pieces of one face, which constraints or seeds have separated |
/// | 1 | a blend and what it blends: they meet smoothly along more than half of their section |
/// | 2 | a hole, a boss or a blend, and anything else |
/// | 3 | others |
/// | 4 | components that are adjacent across links alone |
///
/// The cost is the rank \f$+ \sqrt{a} (1 - A / 2) / 2\f$, \f$a\f$ and \f$A\f$ the areas of the
/// smaller and the larger region as shares of the area of the surface: small regions are merged
/// before large ones, into the largest neighbor.
struct Surface_face_cost
{
  using RegionData = Surface_face_region_data;
  using SectionData = Surface_face_section_data;

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Surface_face_region_data &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double smaller = (std::min)(a.area, b.area), larger = (std::max)(a.area, b.area);
    return rank(a, b, graph[s]) + std::sqrt(smaller) * (1 - larger / 2) / 2;
  }

private:
  static double rank(const Surface_face_region_data& a, const Surface_face_region_data& b,
                     const Surface_face_section_data& between)
  {
    if (between.has_links_alone())
      return 4;
    if (a.face == b.face && a.face != Surface_face_region_data::several)
      return 0;
    if (a.role == Face_role::NONE && b.role == Face_role::NONE)
      return 3;
    const bool is_one_blend = (a.role == Face_role::BLEND) != (b.role == Face_role::BLEND);
    return is_one_blend && between.is_smooth() ? 1 : 2;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SURFACE_FACE_COST_H
