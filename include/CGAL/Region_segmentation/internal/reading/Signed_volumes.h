// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/reading/Face_block.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The signed volumes between an origin and the faces of a mesh: they tell which closed components are inside out, those
/// whose sum is below 0.
///
/// With them two-step takes 4 % more instructions on a smooth mesh, and 2 % on a noisy one. Bytes: 8 per face, and 4 per
/// face while components are found.
class Signed_volumes
{
  using Index = Flat_mesh::Index;

public:
  /// `origin`: near the mesh, to avoid cancellation
  Signed_volumes(std::size_t number_of_faces, const Double_3& origin) : m_origin(origin), m_volumes(number_of_faces) {}

  /// The volume of a face of a block; not a number at a border, so that no open component has a sum.
  void set(const Face_block& block, std::size_t face, const Double_3& area_vector)
  {
    const std::size_t i = face - block.first_face();
    const Corner* const corners = block.corners(i);
    bool is_open = false;
    for (std::size_t j = 0; j < block.number_of_corners(i); ++j)
      is_open |= corners[j].neighbor == Corner::no_neighbor;
    m_volumes[face] =
      is_open ? std::numeric_limits<double>::quiet_NaN() : dot(corners[0].point - m_origin, area_vector);
  }

  /// The faces of the closed components that are inside out, in order.
  std::vector<Index> faces_inside_out(const Flat_mesh& mesh)
  {
    std::vector<Index> faces;
    const Large_array<Index> component = lowest_faces_of_components(mesh);
    if (add_up(component))
      for (std::size_t f = 0; f < component.size(); ++f)
        if (m_volumes[component[f]] < 0)
          faces.push_back(Index(f));
    return faces;
  }

private:
  /// The lowest face of the component of each face. First each face takes over the face of a lower neighbor, which is known since
  /// edges are sorted by their higher face; a forest joins what meets later.
  static Large_array<Index> lowest_faces_of_components(const Flat_mesh& mesh)
  {
    Large_array<Index> component(mesh.number_of_faces());
    for (std::size_t f = 0; f < component.size(); ++f)
      component[f] = Index(f);
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      component[mesh.higher_face(e)] = component[mesh.lower_face(e)];
    std::optional<Lowest_root_forest> forest;
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      if (const Index a = component[mesh.lower_face(e)], b = component[mesh.higher_face(e)]; a != b) {
        if (!forest)
          forest.emplace(component.size());
        forest->unite(a, b);
      }
    if (forest)
      for (Index& c : component)
        c = forest->root(c);
    return component;
  }

  /// Adds the volumes of the faces of each component to that of its lowest face. Returns whether one is below 0.
  bool add_up(const Large_array<Index>& component)
  {
    for (std::size_t f = 0; f < component.size();) {
      const Index c = component[f];
      double sum = f == c ? 0 : m_volumes[c];
      for (; f < component.size() && component[f] == c; ++f)
        sum += m_volumes[f];
      m_volumes[c] = sum;
    }
    bool is_any_below_0 = false;
    for (std::size_t f = 0; f < component.size(); ++f)
      is_any_below_0 |= component[f] == f && m_volumes[f] < 0;
    return is_any_below_0;
  }

  const Double_3 m_origin;
  Large_array<double> m_volumes; // by face, times 3; in the end that of a lowest face is that of its component
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H
