// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_RAY_TREE_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A ray and the first face that it hits so far.
struct Ray
{
  using Index = Surface::Index;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Double_3 source, direction;           // of length 1
  Index skipped;                        // a face that is not hit
  Axis_box::Coordinates start, inverse; // the source relative to that of boxes, 1 / direction
  Index face = Surface::none;
  double distance = infinity;

  Ray(const Double_3& source_, const Double_3& direction_, Index skipped_, const Double_3& origin)
    : source(source_)
    , direction(direction_)
    , skipped(skipped_)
    , start(Axis_box::rounded(source - origin))
    , inverse(Axis_box::rounded(direction))
  {
    for (float& x : inverse) // finite, so that its product with 0 is 0
      x = std::abs(x) > 1e-30f ? 1 / x : 1e30f;
  }

  /// The distance at which the ray enters a box; infinite if it does not before the face that it
  /// hits.
  double entry(const Axis_box& box) const
  {
    float in = 0, out = float(distance);
    for (std::size_t i = 0; i < 3; ++i) {
      const float low = (box.low[i] - start[i]) * inverse[i],
                  high = (box.high[i] - start[i]) * inverse[i];
      in = (std::max)(in, (std::min)(low, high));
      out = (std::min)(out, (std::max)(low, high));
    }
    return in <= out ? in : infinity;
  }

  /// Intersects the ray with a triangle of a face; of faces at the same distance the lowest is hit.
  /// Moeller and Trumbore 1997, with a margin of one millionth against gaps.
  void intersect(const Double_3& corner, const Double_3& second, const Double_3& third, Index f)
  {
    constexpr double rim = -1e-6;
    const Double_3 a = second - corner, b = third - corner, p = cross(direction, b),
                   from_corner = source - corner;
    const double scale = 1 / dot(a, p), u = dot(from_corner, p) * scale;
    if (!(u >= rim && u <= 1 - rim))
      return;
    const Double_3 q = cross(from_corner, a);
    const double v = dot(direction, q) * scale, t = dot(b, q) * scale;
    const bool is_hit = v >= rim && u + v <= 1 - rim && t > 0;
    if (is_hit && f != skipped && (t < distance || (t == distance && f < face))) {
      distance = t;
      face = f;
    }
  }
};

/// Finds the face that a ray hits first from inside the body, by a tree of the boxes of patches:
/// the coarse ones of a mesh of few faces, else the fine ones. (With the fine ones of a torus of
/// 60,000 faces the default takes 1.2 times as long, with the coarse ones of a Loop-subdivided
/// elephant of 356,000 faces 1.4 times.) Rays pass through crumbs.
///
/// Construction takes O(F + P log P) for P patches, a ray O(log P + F / P) in practice.
class Ray_tree
{
  using Index = Surface::Index;

public:
  static constexpr Index no_face = Surface::none;

  struct Hit
  {
    Index face;
    double distance; // in units of the surface; of no face: infinite
  };

  /// \param origin of the boxes, whose coordinates are rounded: the centroid of the surface
  Ray_tree(const Surface& surface, const Surface_patches& patches, const Double_3& origin)
    : m_surface(surface)
    , m_origin(origin)
  {
    constexpr std::size_t few_faces = std::size_t(1) << 17;
    const Partition &fine = patches.fine.of_elements(), &coarse = patches.coarse.of_elements();
    const bool are_few = surface.number_of_faces() <= few_faces;
    const auto leaf_of = [&](std::size_t f) { return are_few ? coarse[fine[f]] : fine[f]; };
    std::vector<Axis_box> boxes((are_few ? coarse : fine).number_of_parts());
    m_faces = Grouped_items<Index>(boxes.size(), [&](const auto& add) {
      for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
        if (!surface.is_crumb(f))
          add(leaf_of(f), Index(f));
    });
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for (const Index v : surface.corners(f))
        boxes[leaf_of(f)].add_point(surface.point(v) - origin);
    Axis_box all;
    for (const Axis_box& box : boxes)
      all.add(box);
    // covers what rounding changes
    const float margin = 5e-7f *
                         (std::max)(all.extent(all.longest_axis()), float(surface.length_unit()));
    m_boxes = Box_tree(boxes.size(), [&](Index leaf) {
      Axis_box box = boxes[leaf];
      for (std::size_t i = 0; i < 3; ++i) {
        box.low[i] -= margin;
        box.high[i] += margin;
      }
      return box;
    });
  }

  /// The first face that a ray hits from inside, in front of its source, of several the lowest one,
  /// other than `skipped`; the first one found, if more boxes than `most_visits` would be visited,
  /// as where thousands of triangles overlap.
  Hit first_hit(const Double_3& source, const Double_3& direction, Index skipped,
                std::size_t most_visits = (std::numeric_limits<std::size_t>::max)()) const
  {
    Ray ray(source, direction, skipped, m_origin);
    std::size_t visits = 0;
    const auto entry = [&](Index node) {
      return visits++ < most_visits ? ray.entry(m_boxes.box(node)) : Ray::infinity;
    };
    m_boxes.search(entry, ray.distance, [&](Index node) {
      for (const Index face : m_faces[m_boxes.item(node)]) {
        if (!(dot(direction, m_surface.normal(face)) > 0))
          continue;
        const auto corners = m_surface.corners(face);
        for (const Index* v = corners.begin() + 1; v + 1 < corners.end(); ++v)
          ray.intersect(m_surface.point(*corners.begin()), m_surface.point(v[0]),
                        m_surface.point(v[1]), face);
      }
    });
    return {ray.face, ray.distance};
  }

private:
  const Surface& m_surface;
  Double_3 m_origin;
  Box_tree m_boxes;
  Grouped_items<Index> m_faces; // by item of the tree
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_RAY_TREE_H
