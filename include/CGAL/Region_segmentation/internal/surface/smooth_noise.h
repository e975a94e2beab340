// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_SMOOTH_NOISE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_SMOOTH_NOISE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// How far the neighbors of vertices lie above them on average, along the normal: what noise
/// changes most.
class Vertex_heights
{
public:
  /// Of the vertices of every `stride`th face.
  Vertex_heights(const Surface& surface, std::size_t stride)
    : m_surface(surface)
    , m_stride(stride)
    , m_vertices(surface.number_of_vertices())
  {
    for (std::size_t f = 0; f < surface.number_of_faces(); f += stride)
      for_each_side(m_surface, f, [&](Index p, Index) { m_vertices[p].is_wanted = true; });
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      add_face(f);
    for (Vertex& v : m_vertices)
      set_height(v);
  }

  /// Whether noise exceeds curvature: then so many edges join heights of opposite signs.
  /// Independent noise of the points makes it 4/7 of the edges; of 190 models of the Princeton
  /// benchmark none has more than 2/5.
  bool are_noise() const
  {
    double all = 0, opposite = 0;
    for (std::size_t f = 0; f < m_surface.number_of_faces(); f += m_stride)
      for_each_side(m_surface, f, [&](Index p, Index q) {
        const double product = m_vertices[p].height * m_vertices[q].height;
        all += product != 0;
        opposite += product < 0;
      });
    return opposite > share_of_noise * all + std::sqrt(all); // not by chance
  }

  /// Larger heights stand out of the noise: they are those of creases. 3 times the median of those
  /// that are not 0.
  double largest_of_noise() const
  {
    std::vector<double> heights;
    for (const Vertex& v : m_vertices)
      if (v.height != 0)
        heights.push_back(std::fabs(v.height));
    if (heights.empty())
      return 0;
    const auto median = heights.begin() + std::ptrdiff_t(heights.size() / 2);
    std::nth_element(heights.begin(), median, heights.end());
    return 3 * *median;
  }

  /// The points, moved along the normals to the heights of their neighbors, but at creases.
  Large_array<Double_3> smoothed() const
  {
    const double largest = largest_of_noise();
    Large_array<Double_3> result(m_vertices.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
      const double height = m_vertices[v].height;
      result[v] = m_surface.point(v) +
                  (std::fabs(height) <= largest ? height : 0) * m_vertices[v].normal;
    }
    return result;
  }

private:
  using Index = Surface::Index;
  static constexpr double flat = 1e-5; // height^2 / area of the faces around: smaller heights are 0
  static constexpr double share_of_noise = 0.42;

  struct Vertex
  {
    Double_3 to_neighbors{0, 0, 0}; // the sum over the faces, to the next and the previous corner
    Double_3 normal{0, 0, 0};
    double height = 0;
    std::uint32_t number_of_faces = 0;
    bool is_wanted = false;
  };

  void add_face(std::size_t face)
  {
    bool is_wanted = false;
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      is_wanted |= m_vertices[m_surface.corner(face, i)].is_wanted;
    if (!is_wanted)
      return;
    const Double_3 area_vector = m_surface.area(face) * m_surface.normal(face);
    for_each_side(m_surface, face, [&](Index p, Index q) {
      Vertex &a = m_vertices[p], &b = m_vertices[q];
      const Double_3 side = m_surface.point(q) - m_surface.point(p);
      a.to_neighbors = a.to_neighbors + side;
      b.to_neighbors = b.to_neighbors - side;
      a.normal = a.normal + area_vector;
      ++a.number_of_faces;
    });
  }

  static void set_height(Vertex& v)
  {
    const double area = norm(v.normal);
    if (!v.is_wanted || area == 0)
      return;
    v.normal = (1 / area) * v.normal;
    const double height = dot(v.to_neighbors, v.normal) / (2 * v.number_of_faces);
    if (height * height > flat * area)
      v.height = height;
  }

  const Surface& m_surface;
  const std::size_t m_stride;
  std::vector<Vertex> m_vertices;
};

/// The sign of the edges between two faces of a surface together: its flag.
inline std::uint8_t sign_of_adjacency(const Surface& surface, std::size_t adjacency)
{
  const std::size_t lower = surface.lower_face(adjacency), higher = surface.higher_face(adjacency);
  Double_3 edges{0, 0, 0};
  for_each_side(surface, higher, [&](Surface::Index p, Surface::Index q) {
    if (runs_along(surface, Surface::Index(lower), q, p))
      edges = edges + (surface.point(q) - surface.point(p));
  });
  return sign_of_edge(surface.normal(higher), surface.normal(lower), edges);
}

/// Moves the points of a surface, and with them all but degenerate faces and the lengths of
/// adjacencies.
inline void smooth(Surface& surface)
{
  Surface_arrays& arrays = arrays_of(surface);
  arrays.points = Vertex_heights(surface, 1).smoothed();
  const Large_array<Double_3> former_normals = arrays.normals;
  const Large_array<double> former_areas = arrays.areas;
  compute_normals(surface, Execution());
  arrays.area = 0;
  for (std::size_t f = 0; f < former_normals.size(); ++f) {
    if (squared_norm(former_normals[f]) == 0) {
      arrays.normals[f] = former_normals[f];
      arrays.areas[f] = former_areas[f];
    }
    arrays.area += surface.weight(f);
  }
  arrays.length_unit = arrays.area > 0 ? std::sqrt(arrays.area) : 1;
  constexpr std::uint8_t signs = Surface::CONVEX | Surface::CONCAVE;
  for (std::size_t a = 0; a < arrays.flags.size(); ++a)
    if (surface.has_angle(a))
      arrays.flags[a] = std::uint8_t((arrays.flags[a] & ~signs) | sign_of_adjacency(surface, a));
}

/// The surface with its points moved to the height of their neighbors, but at creases, as often as
/// there is more noise than curvature; none where there is not. So angles are measured over a width
/// that the noise asks for.
///
/// O(F); with a small constant where there is no noise, which is seen from some 20,000 faces.
inline std::optional<Surface> smooth_noise(const Surface& surface)
{
  constexpr std::size_t enough_faces = 20000;
  constexpr int most_rounds = 5;
  const std::size_t stride = (std::max)(surface.number_of_faces() / enough_faces, std::size_t(1));
  std::optional<Surface> result;
  for (int round = 0;
       round < most_rounds && Vertex_heights(result ? *result : surface, stride).are_noise();
       ++round) {
    if (!result)
      result = surface;
    smooth(*result);
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_SMOOTH_NOISE_H
