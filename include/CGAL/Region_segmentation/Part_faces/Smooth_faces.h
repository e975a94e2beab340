// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_SMOOTH_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_SMOOTH_FACES_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Number_below_cost.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_face_roles.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_faces.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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
  internal::for_each_shared_side(
    surface, [&](Surface::Index a, Surface::Index v, Surface::Index w) {
      const std::size_t f = surface.lower_face(a), g = surface.higher_face(a);
      if (regions[f] == regions[g] ||
          !internal::meet_smoothly(surface, a, 0.5 * (surface.point(v) + surface.point(w)),
                                   faces.surfaces[faces.partition[f]],
                                   faces.surfaces[faces.partition[g]]))
        return;
      if (const auto section = graph.section(regions[f], regions[g]))
        graph[*section].smooth_length += surface.length(a) / surface.length_unit();
    });
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

/// \ingroup PkgRegionSegmentationMethods
/// The faces of a machine part as its designer drew them: planes, cylinders, cones, spheres, tori,
/// and freeform faces, by `find_surface_faces()`. A model of `SegmentationMethod`. It needs Eigen.
///
/// No number is required: the segments are the faces. With a lower one, faces are merged in the
/// order of `Surface_face_cost`, blends into what they blend first. There are at most as many
/// segments as faces, unless constraints or seeds divide them.
struct Smooth_faces
{
  /// The largest distance of a vertex from the surface of its face, in units of the mesh; 0: found
  /// from the mesh.
  double tolerance = 0;
  Surface_face_cost cost;
  Number_below_cost chooser = {0.5}; ///< stops where all pieces of faces are merged

  struct Prepared
  {
    Surface_faces faces;
  };

  Prepared prepare(const Surface& surface, std::size_t /* number_of_segments */ = 0,
                   const Execution& execution = Execution()) const
  {
    internal::check_constant("Smooth_faces: tolerance", tolerance, 0);
    chooser.check_constants();
    return {internal::find_faces(surface, tolerance / surface.unit(), execution.stage("regions"))};
  }

  Hierarchy merge(const Surface& surface, const Prepared& prepared, const Request& request,
                  const Execution& execution = Execution()) const
  {
    Requested_regions requested = requested_regions(surface, prepared.faces.partition,
                                                    request.seeds);
    auto graph = build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>(
      surface, requested.regions, execution.stage("graph"));
    annotate_surface_faces(graph, surface, requested.regions, prepared.faces);
    Merge_tree tree = merge_requested_regions(surface, requested, graph,
                                              Lowest_cost_first<Surface_face_cost>(cost), 1,
                                              execution.stage("merging"));
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments
                                                              : chooser(tree, surface);
    return Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Smooth_faces>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_SMOOTH_FACES_H
