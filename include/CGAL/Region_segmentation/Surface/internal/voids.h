// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_VOIDS_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_VOIDS_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/find_links.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The face of a component that is nearest to a point, of several the first one found.
///
/// `components`: by node of the tree that of its faces; `Surface::none`, if it has several
inline Surface::Index nearest_face(const Double_3& p, Surface::Index component,
                                   const Face_tree& tree,
                                   const std::vector<Surface::Index>& components)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Axis_box at = box_of(std::array{p - tree.origin()});
  Surface::Index result = Surface::none;
  double least = infinity; // squared distance
  tree.boxes().search(
    [&](Surface::Index node) {
      return components[node] == component || components[node] == Surface::none
               ? squared_gap(tree.boxes().box(node), at)
               : infinity;
    },
    least,
    [&](Surface::Index leaf) {
      if (const double d = squared_distance(p, tree.triangle(leaf)); d < least) {
        least = d;
        result = tree.face(leaf);
      }
    });
  return result;
}

/// By face of a void the nearest face of its body; else `Surface::none`. Faces of a void that are
/// close together, up to 1/16,384 of all faces, have the face nearest to the mean of their
/// centroids: so each has its own where there are fewer faces. (Where a wall is thick, hundreds of
/// its faces are nearly as near as the nearest one, and are all looked at.)
///
/// `bodies`: by component
inline std::vector<Surface::Index> faces_around_voids(const Surface& surface, const Face_tree& tree,
                                                      const std::vector<Surface::Index>& bodies,
                                                      const Execution& execution)
{
  using Index = Surface::Index;
  const Box_tree& boxes = tree.boxes();
  const Index most_leaves = Index(surface.number_of_faces() >> 14) + 1;
  const std::vector<Index> components = boxes.values(
    [&](Index leaf) { return surface.components()[tree.face(leaf)]; },
    [](Index c, Index d) { return c == d ? c : Surface::none; });
  const std::vector<Index> numbers = boxes.values([](Index) { return Index(1); },
                                                  std::plus<Index>()); // of leaves, by node
  const auto is_cell = [&](Index node) {
    return components[node] != Surface::none && bodies[components[node]] != Surface::none &&
           numbers[node] <= most_leaves;
  };
  std::vector<Index> result(surface.number_of_faces(), Surface::none);
  Step_counter counter(execution, result.size());
  boxes.for_each_topmost(is_cell, [&](Index cell) {
    counter.advance();
    const Index past = cell + 2 * numbers[cell] - 1;
    Double_3 sum{};
    for (Index node = cell; node < past; ++node)
      if (boxes.is_leaf(node))
        sum = sum + surface.centroid(tree.face(node));
    const Index nearest = nearest_face((1 / double(numbers[cell])) * sum, bodies[components[cell]],
                                       tree, components);
    for (Index node = cell; node < past; ++node)
      if (boxes.is_leaf(node))
        result[tree.face(node)] = nearest;
  });
  return result;
}

/// Links each face of a void with the nearest face of the body around it.
inline void Surface_builder::link_voids(const Voids& voids, const Execution& execution)
{
  if (std::size_t(std::count(voids.bodies.begin(), voids.bodies.end(), none)) ==
      voids.bodies.size())
    return;
  m_bodies = voids.bodies;
  const std::vector<Index> around = faces_around_voids(*this, voids.tree, m_bodies, execution);
  std::vector<Added_adjacency> links;
  for (Index f = 0; f < around.size(); ++f)
    if (around[f] != none)
      links.push_back(link_of(f, around[f], 0));
  insert_adjacencies(links);
}

/// A surface without the faces of its voids.
struct Filled_surface
{
  Surface surface;
  /// By face of the surface with voids: the face of `surface` that it is; if it bounds a void, the
  /// nearest face of the body around it.
  std::vector<Surface::Index> faces;
};

/// The surface without its voids, but those with constrained edges: what is read of a mesh without
/// their faces. O(F), and that of the links if there are bodies apart.
inline Filled_surface fill_voids(const Surface& surface, const Execution& execution)
{
  using Index = Surface::Index;
  std::vector<bool> is_constrained(surface.number_of_components()), is_removed;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, Surface::CONSTRAINED))
      is_constrained[surface.components()[surface.lower_face(a)]] = true;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    is_removed.push_back(surface.body_around(f) != Surface::none &&
                         !is_constrained[surface.components()[f]]);
  Surface_builder builder(surface);
  Filled_surface result{Surface(), builder.remove_faces(is_removed)};
  builder.link_components(execution);
  result.surface = builder.finish();
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Index lower = surface.lower_face(a), higher = surface.higher_face(a);
    for (const auto& [f, g] : {std::pair(lower, higher), std::pair(higher, lower)})
      if (is_removed[f] && surface.has_flag(a, Surface::LINK) &&
          surface.body_around(f) == surface.components()[g])
        result.faces[f] = result.faces[g];
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_VOIDS_H
