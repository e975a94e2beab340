// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_DUAL_GRAPH_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_DUAL_GRAPH_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_type_config.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The adjacency of faces, or of patches, in both directions, with a length for each step. Lengths
/// are float, since searches over all faces are bound by memory: a face takes 8 bytes, and so does
/// each step.
class Dual_graph
{
public:
  using Index = Surface::Index;

  struct Step
  {
    Index face;
    float length;
  };

  /// Has a step in both directions for each adjacency of faces with `is_step(adjacency)`.
  Dual_graph(const Surface& surface, std::function<bool(std::size_t)> is_step,
             std::function<double(std::size_t)> length)
  {
    std::vector<Edge> edges;
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      if (is_step(a))
        edges.push_back({surface.lower_face(a), surface.higher_face(a), float(length(a))});
    set_steps(surface.number_of_faces(), edges);
  }

  /// Whether patches are adjacent across edges alone, or also across seams and links.
  enum Across { EDGES, EDGES_AND_CONTACTS };

  /// Has patches in place of faces. `length(adjacency, deviation)`: by the concave deviation of the
  /// two patches, which counts as a right angle at a seam or link, where there is a valley
  Dual_graph(const Patches& patches, Across across,
             std::function<double(const Patches::Adjacency&, double)> length)
  {
    std::vector<Edge> edges;
    edges.reserve(patches.adjacencies().size() + patches.contacts().size());
    const auto add = [&](const Patches::Adjacency& a, double deviation) {
      edges.push_back({a.lower, a.higher, float(length(a, deviation))});
    };
    for (const Patches::Adjacency& a : patches.adjacencies())
      add(a, patches.concave_deviation(a));
    if (across == EDGES_AND_CONTACTS)
      for (const Patches::Adjacency& contact : patches.contacts())
        add(contact, CGAL_PI / 2);
    set_steps(patches.size(), edges);
  }

  std::size_t number_of_faces() const { return m_steps.number_of_groups(); }

  /// The steps from a face, those to lower faces first, in order.
  Iterator_range<const Step*> steps(std::size_t face) const { return m_steps[face]; }

private:
  struct Edge
  {
    Index face, other_face;
    float length;
  };

  void set_steps(std::size_t number_of_faces, const std::vector<Edge>& edges)
  {
    m_steps = Grouped_items<Step>(number_of_faces, [&](const auto& add) {
      for (const Edge& e : edges) {
        add(e.face, {e.other_face, e.length});
        add(e.other_face, {e.face, e.length});
      }
    });
  }

  Grouped_items<Step> m_steps; // by face
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_DUAL_GRAPH_H
