// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_BUILDER_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/reading/Face_block.h>
#include <CGAL/Region_segmentation/internal/reading/Joining_edges.h>
#include <CGAL/Region_segmentation/internal/reading/Patch_builder.h>
#include <CGAL/Region_segmentation/internal/reading/Signed_volumes.h>
#include <CGAL/Region_segmentation/internal/reading/normals.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fills the arrays of a `Flat_mesh`: faces, dual edges and corners, each of them in any order, but an edge
/// after its two faces.
class Flat_mesh_builder
{
  using Index = Flat_mesh::Index;

public:
  /// `unit`: the unit of length of the data, in units of the mesh
  Flat_mesh_builder(std::size_t number_of_faces, std::size_t maximum_number_of_edges, Mesh_data data, double unit)
    : m_volumes(number_of_faces), m_closed_edges(number_of_blocks(number_of_faces))
  {
    m_flat.m_data = data;
    m_flat.m_unit = unit;
    m_flat.m_normals.resize(number_of_faces);
    m_flat.m_areas.resize(number_of_faces);
    m_flat.m_lower_faces.resize(maximum_number_of_edges);
    m_flat.m_higher_faces.resize(maximum_number_of_edges);
    m_flat.m_squared_lengths.resize(maximum_number_of_edges);
    m_flat.m_flags.resize(maximum_number_of_edges);
    if (includes(data, Mesh_data::CENTROIDS))
      m_flat.m_centroids.resize(number_of_faces);
  }

  /// `point`: a corner
  void set_face(std::size_t face, const Double_3& point, const Double_3& area_vector, double squared_longest_edge)
  {
    m_volumes.set(face, dot(point, area_vector));
    const double area = norm(area_vector);
    m_flat.m_areas[face] = area;
    m_flat.m_normals[face] = unit_normal(area_vector, area, squared_longest_edge, Double_3{});
  }

  /// Marks a face with a side at a border of the mesh.
  void set_open(std::size_t face) { m_volumes.set_open(face); }

  /// A dual edge whose lower face was not known when it was set.
  struct Late_edge
  {
    std::size_t edge;
    Double_3 direction;
  };

  /// Stores the dual edges of a block from place `first` on. Those that lead to faces below
  /// `first_known_face` are also added to `late_edges`.
  void set_edges(std::size_t first, const Face_block& block, std::size_t first_known_face,
                 std::vector<Late_edge>& late_edges)
  {
    const Side_edge* const edges = block.edges().data();
    const std::size_t n = block.edges().size();
    const Double_3* const normals = m_flat.m_normals.data();
    Index* const lower_faces = m_flat.m_lower_faces.data() + first;
    Index* const higher_faces = m_flat.m_higher_faces.data() + first;
    double* const squared_lengths = m_flat.m_squared_lengths.data() + first;
    std::uint8_t* const flags = m_flat.m_flags.data() + first;
    for (std::size_t i = 0; i < n; ++i) {
      const Index lower = edges[i].lower(), higher = edges[i].higher;
      const Double_3 direction = block.direction(edges[i].side());
      lower_faces[i] = lower;
      higher_faces[i] = higher;
      squared_lengths[i] = squared_norm(direction);
      if (lower < first_known_face) {
        flags[i] = 0;
        late_edges.push_back({first + i, direction});
        continue;
      }
      const Double_3 a = normals[higher], b = normals[lower];
      const double cosine = dot(a, b);
      flags[i] = flags_of(a, b, cosine, direction);
      if (cosine == 0)
        close_at_degenerate_face(first + i);
    }
  }

  void set_late_edge(const Late_edge& late)
  {
    const Double_3 a = m_flat.normal(m_flat.higher_face(late.edge)), b = m_flat.normal(m_flat.lower_face(late.edge));
    const double cosine = dot(a, b);
    m_flat.m_flags[late.edge] |= flags_of(a, b, cosine, late.direction);
    if (cosine == 0)
      close_at_degenerate_face(late.edge);
  }

  /// Its dual edges are there after `set_number_of_edges()`.
  const Flat_mesh& flat() const { return m_flat; }

  void set_constrained(std::size_t edge) { m_flat.m_flags[edge] |= Flat_mesh::CONSTRAINED; }

  /// \name Points
  /// Only with `Mesh_data::POINTS`.
  /// @{
  /// There may be fewer corners in the end.
  void resize_points(std::size_t number_of_points, std::size_t number_of_corners)
  {
    m_flat.m_points.m_points.resize(number_of_points);
    m_flat.m_points.m_first_corners.resize(m_flat.number_of_faces() + 1);
    m_flat.m_points.m_corners.resize(number_of_corners);
    m_flat.m_points.m_first_corners.front() = 0;
  }
  void set_point(std::size_t vertex, const Double_3& point) { m_flat.m_points.m_points[vertex] = point; }
  /// Stores the corners of a block of faces from place `first` on.
  void set_corners(std::size_t first, const Face_block& block)
  {
    for (std::size_t i = 0; i < block.number_of_faces(); ++i) {
      for (std::size_t j = 0; j < block.number_of_corners(i); ++j)
        m_flat.m_points.m_corners[first++] = block.corners(i)[j].vertex;
      m_flat.m_points.m_first_corners[block.first_face() + i + 1] = Index(first);
    }
  }
  /// @}

  /// Only with `Mesh_data::CENTROIDS`.
  void set_centroids(const Face_block& block)
  {
    for (std::size_t i = 0; i < block.number_of_faces(); ++i) {
      const std::size_t n = block.number_of_corners(i);
      Double_3 sum{};
      for (std::size_t j = 0; j < n; ++j)
        sum = sum + block.corners(i)[j].point;
      m_flat.m_centroids[block.first_face() + i] = (1.0 / double(n)) * sum;
    }
  }

  /// \name After all faces and edges
  /// @{
  void set_number_of_edges(std::size_t number_of_edges)
  {
    m_flat.m_lower_faces.resize(number_of_edges);
    m_flat.m_higher_faces.resize(number_of_edges);
    m_flat.m_squared_lengths.resize(number_of_edges);
    m_flat.m_flags.resize(number_of_edges);
  }

  /// The signed volume of a closed surface.
  double volume() const { return m_volumes.sum(); }

  /// Turns the closed components that are inside out; faces at borders are marked.
  template <typename ConcurrencyTag>
  void turn_components()
  {
    turn(m_volumes.faces_inside_out(
      label_components(m_flat, [](std::size_t) { return true; }, Execution<ConcurrencyTag>())));
  }

  /// All but the faces of patches. `releases_centroids`: when patches are made of the faces; points follow, of which centroids
  /// are computed; `execution`: for the patches, if they are wanted
  template <typename ConcurrencyTag>
  void finish(bool releases_centroids, const Execution<ConcurrencyTag>& execution)
  {
    join_degenerate_faces();
    m_volumes = Signed_volumes(0); // patches need the memory
    if (includes(m_flat.m_data, Mesh_data::SURFACE_AREA))
      for (const double area : m_flat.m_areas)
        m_flat.m_surface_area += area;
    if (includes(m_flat.m_data, Mesh_data::PATCHES))
      m_flat.m_patches = Patch_builder<ConcurrencyTag>::build(
        m_flat,
        [&] {
          if (releases_centroids)
            m_flat.m_centroids = Large_array<Double_3>();
        },
        execution);
  }

  /// After the points.
  template <typename ConcurrencyTag>
  void set_centers_of_patches()
  {
    if (includes(m_flat.m_data, Mesh_data::PATCHES))
      Patch_builder<ConcurrencyTag>::set_centers(m_flat.m_patches, m_flat);
  }

  Flat_mesh take() { return std::move(m_flat); }
  /// @}

private:
  /// Of the normals of the higher and the lower face, and the halfedge of the higher one.
  static std::uint8_t flags_of(const Double_3& a, const Double_3& b, double cosine, const Double_3& direction)
  {
    return std::uint8_t(sign_of_edge(a, b, direction) +
                        (cosine > Flat_mesh::nearly_flat) * Flat_mesh::NEARLY_FLAT +
                        (cosine < Flat_mesh::not_flat) * Flat_mesh::NOT_FLAT);
  }

  /// The normal of a degenerate face is zero, and so is the computed cosine of its edges.
  void close_at_degenerate_face(std::size_t edge)
  {
    const Index lower = m_flat.lower_face(edge), higher = m_flat.higher_face(edge);
    if (!m_flat.is_degenerate(lower) && !m_flat.is_degenerate(higher))
      return;
    m_flat.m_flags[edge] |= Flat_mesh::CLOSED;
    m_closed_edges[higher / block_size].push_back(Index(edge));
  }

  /// Reverses the orientation of whole components.
  void turn(const std::vector<Index>& faces)
  {
    constexpr std::uint8_t signs = Flat_mesh::CONVEX | Flat_mesh::CONCAVE;
    if (faces.empty())
      return;
    std::vector<bool> is_turned(m_flat.number_of_faces());
    for (const Index f : faces) {
      is_turned[f] = true;
      m_flat.m_normals[f] = -1.0 * m_flat.m_normals[f];
    }
    for (std::size_t e = 0; e < m_flat.number_of_edges(); ++e)
      if (is_turned[m_flat.lower_face(e)] && m_flat.has_flag(e, signs))
        m_flat.m_flags[e] ^= signs;
  }

  void join_degenerate_faces()
  {
    Joining_edges joining;
    for (const auto& block : m_closed_edges)
      for (Index edge : block) {
        if (m_flat.has_flag(edge, Flat_mesh::CONSTRAINED))
          continue;
        const Index lower = m_flat.lower_face(edge), higher = m_flat.higher_face(edge);
        if (m_flat.is_degenerate(lower))
          joining.add(lower, higher, m_flat.length(edge), edge);
        if (m_flat.is_degenerate(higher))
          joining.add(higher, lower, m_flat.length(edge), edge);
      }
    joining.for_each([this](Index edge) {
      std::uint8_t& flags = m_flat.m_flags[edge];
      flags = std::uint8_t((flags & ~Flat_mesh::CLOSED) | Flat_mesh::JOINING);
    });
  }

  Flat_mesh m_flat;
  Signed_volumes m_volumes;
  std::vector<std::vector<Index>> m_closed_edges; // by the block of their higher face
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_BUILDER_H
