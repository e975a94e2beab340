// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_ANNOTATOR_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_data.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/Face_links.h>
#include <CGAL/Region_segmentation/internal/regions/Normal_section.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationAnnotators
/// measures at every edge whether it is a crease of a machine part, a joint of two smooth faces, or an edge of the
/// triangulation of one: for graphs with `Smoothness_region_data` and
/// `Smoothness_section_data`.
///
/// From the middle of an edge a straight path is followed over the faces on either side, at right angles to the edge.
/// It is a polygon inscribed in the normal section of the surface, so its bends tell the normal curvatures
/// \f$\kappa_0, \kappa_1\f$ beside the edge and the lengths \f$l_0, l_1\f$ of the facets at the edge, whatever the
/// triangles are: a facet of a coarse cylinder bends at both of its sides alike, the border of a fillet bends half as
/// much as the edges on it, and a crease bends alone. The *discontinuity* of an edge of deviation \f$\beta\f$ is
/// \f[ \frac{|\kappa_0 - \kappa_1|}{\max(|\kappa_0|, |\kappa_1|, w K)}
///   + \frac{1}{\beta_1} \max(0, |\beta - \bar\beta| - 4 \max(|\kappa_0| l_0, |\kappa_1| l_1)),
///   \quad \bar\beta = \frac{\kappa_0 l_0 + \kappa_1 l_1}{2}, \f]
/// with \f$K\f$ the largest curvature on the two faces, \f$w = 0.8\f$ and \f$\beta_1\f$ 5 degrees; at most 3. It
/// has no unit: 0 is smooth, 1 a jump of the curvature to 0, as where a plane becomes a cylinder. It is
/// \f$3 \beta / \beta_c\f$ if \f$\beta\f$ exceeds the angle \f$\beta_c\f$ of a certain crease. Edges of degenerate
/// faces are left out.
///
/// Paths are 2.5 times as long as the face at the edge is high, and at most 7.5 times as long as the other one is. Where
/// \f$\beta\f$ is above 2 degrees, the facet counts in place of the face: the flat piece of the surface on the path, of which
/// faces may be slivers or a fine triangulation.
///
/// Complexity: O(F log F) if a path crosses O(1) faces. Deterministic. With `Parallel_tag` the paths are followed in
/// parallel.
class Smoothness_annotator
{
public:
  using RegionData = Smoothness_region_data;
  using SectionData = Smoothness_section_data;

  double crease_angle = 32;     ///< degrees, in (0, 180]: a larger deviation is a crease, whatever is beside it
  double flat_angle = 0.15;     ///< degrees, positive: a smaller deviation is rounding
  double curvature_floor = 0.8; ///< w, in (0, 1]: the larger, the less the triangulation matters

  /// The discontinuities of the edges of a surface, which do not depend on its regions: by side of a face; of the lower of
  /// the two faces.
  std::vector<double> discontinuities(const Surface& surface, const Execution& execution = Execution()) const
  {
    CGAL_precondition_msg(crease_angle > 0 && crease_angle <= 180, "crease_angle is in (0, 180] degrees");
    CGAL_precondition_msg(flat_angle > 0, "flat_angle is positive");
    CGAL_precondition_msg(curvature_floor > 0 && curvature_floor <= 1, "curvature_floor is in (0, 1]");
    return discontinuities(surface, internal::Face_links(surface), execution);
  }

  template <typename Graph>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const std::vector<double>& discontinuities) const
  {
    const internal::Face_links links(surface);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      graph[*range.first].discontinuity = graph[*range.first].measured_length = 0;
    for_each_edge(surface, links, 0, surface.number_of_faces(), [&](const internal::Face_edge& e) {
      const auto a = regions[e.face], b = regions[links.opposite(e).face];
      if (a == b || surface.is_degenerate(e.face) || surface.is_degenerate(links.opposite(e).face))
        return;
      if (const auto section = graph.section(a, b)) {
        const double length = norm(links.target(e) - links.source(e));
        graph[*section].measured_length += length;
        graph[*section].discontinuity += length * discontinuities[links.number(e)];
      }
    });
  }

private:
  using Face_edge = internal::Face_edge;

  static constexpr double reach = 2.5;             // of a path, in heights of the facet
  static constexpr double largest_height = 3;      // of a facet, in heights of the other one
  static constexpr double least_bend_of_facets = 2; // degrees: of faces that meet at less, none is a part of a coarse facet
  static constexpr double tolerance_of_bend = 4;   // of a bend that is not a crease, in those expected
  static constexpr double unit_of_crease = 5;      // beta_1, degrees
  static constexpr double most = 3;                // discontinuity short of a certain crease

  static double radians(double degrees) { return degrees * (CGAL_PI / 180); }

  /// Calls `f` for each edge of the given faces whose other face is a higher one.
  template <typename F>
  static void for_each_edge(const Surface& mesh, const internal::Face_links& links, std::size_t begin,
                            std::size_t end, const F& f)
  {
    using Index = Surface::Index;
    for (Index face = Index(begin); face < end; ++face)
      for (Face_edge e{face, 0}; e.corner < mesh.number_of_corners(face); ++e.corner) {
        const Face_edge other = links.opposite(e);
        if (other.exists() && other.face > face)
          f(e);
      }
  }

  struct Joint
  {
    double bend = 0;
    double curvatures[2] = {0, 0};
    double facet_lengths[2] = {0, 0};
    double path_length = 0; ///< the shorter one
  };

  std::vector<double> discontinuities(const Surface& mesh, const internal::Face_links& links,
                                      const Execution& execution) const
  {
    std::vector<Joint> joints(links.number_of_edges());
    internal::for_each_block(execution, mesh.number_of_faces(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for_each_edge(mesh, links, begin, end,
                    [&](const Face_edge& e) { joints[links.number(e)] = measure(mesh, links, e); });
    });
    std::vector<double> largest(mesh.number_of_faces()); // curvature on a face
    for_each_edge(mesh, links, 0, mesh.number_of_faces(), [&](const Face_edge& e) {
      const Joint& joint = joints[links.number(e)];
      const std::size_t faces[] = {e.face, links.opposite(e).face};
      for (std::size_t side : {0u, 1u})
        largest[faces[side]] = (std::max)(largest[faces[side]], std::abs(joint.curvatures[side]));
    });
    std::vector<double> result(joints.size());
    for_each_edge(mesh, links, 0, mesh.number_of_faces(), [&](const Face_edge& e) {
      const std::size_t i = links.number(e);
      result[i] = discontinuity(joints[i], (std::max)(largest[e.face], largest[links.opposite(e).face]));
    });
    return result;
  }

  Joint measure(const Surface& mesh, const internal::Face_links& links, const Face_edge& e) const
  {
    Joint joint;
    joint.bend = bend(mesh, links, e);
    if (std::abs(joint.bend) > radians(crease_angle))
      return joint;
    const Face_edge edges[] = {e, links.opposite(e)};
    const auto height = [&](const Face_edge& side) {
      return std::abs(joint.bend) > radians(least_bend_of_facets) ? facet_height(mesh, links, side, radians(flat_angle))
                                                                 : internal::height(mesh, links, side);
    };
    const double heights[] = {height(edges[0]), height(edges[1])};
    const auto section = [&](std::size_t side) {
      const double h = (std::min)(heights[side], largest_height * heights[1 - side]);
      return internal::Normal_section(mesh, links, edges[side], reach * h, radians(flat_angle), radians(crease_angle));
    };
    const internal::Normal_section sections[] = {section(0), section(1)};
    joint.path_length = (std::min)(sections[0].length, sections[1].length);
    for (std::size_t side : {0u, 1u}) {
      joint.curvatures[side] = sections[side].curvature;
      joint.facet_lengths[side] = sections[side].facet_length;
    }
    for (std::size_t side : {0u, 1u})
      if (sections[side].is_open && !sections[1 - side].is_open && joint.facet_lengths[side] > 0)
        joint.curvatures[side] = curvature_of_facet(joint, side);
    return joint;
  }

  /// Of a facet between an edge and a crease. Half of its turn is at the edge, with half of that of the facet on the
  /// other side.
  static double curvature_of_facet(const Joint& joint, std::size_t side)
  {
    const double other_turn = joint.curvatures[1 - side] * joint.facet_lengths[1 - side];
    return (2 * joint.bend - other_turn) / joint.facet_lengths[side];
  }

  double discontinuity(const Joint& joint, double largest_curvature) const
  {
    if (std::abs(joint.bend) > radians(crease_angle))
      return most * std::abs(joint.bend) / radians(crease_angle);
    if (!(joint.path_length > 0))
      return 0;
    const auto [k0, k1] = joint.curvatures;
    const double turns[] = {k0 * joint.facet_lengths[0], k1 * joint.facet_lengths[1]};
    const double scale = (std::max)({std::abs(k0), std::abs(k1), curvature_floor * largest_curvature}) +
                         radians(flat_angle) / joint.path_length; // of rounding
    const double excess = std::abs(joint.bend - (turns[0] + turns[1]) / 2) -
                          tolerance_of_bend * (std::max)(std::abs(turns[0]), std::abs(turns[1]));
    return (std::min)(most, std::abs(k0 - k1) / scale + (std::max)(0.0, excess) / radians(unit_of_crease));
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_ANNOTATOR_H
