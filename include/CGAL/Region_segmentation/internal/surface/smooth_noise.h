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
#include <limits>
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
  using Points = Large_array<Double_3>;

  /// Of the vertices of every `stride`th face.
  Vertex_heights(const Surface& surface, std::size_t stride, const Execution& execution)
    : m_surface(surface)
    , m_execution(execution.silent())
  {
    if (stride > 1)
      choose_vertices(stride);
    else
      m_vertices.resize(surface.number_of_vertices());
    update(arrays_of(surface).points);
  }

  /// After the points of the surface moved to these. Each thread has some of the vertices, and
  /// looks at all faces: so sums are in the order of the faces.
  void update(const Points& points)
  {
    const std::size_t ranges = m_execution.number_of_threads();
    const std::size_t size = number_of_blocks(m_vertices.size(), ranges);
    m_execution.for_each(0, ranges, [&](std::size_t range) {
      const std::size_t begin = (std::min)(range * size, m_vertices.size()),
                        end = (std::min)(begin + size, m_vertices.size());
      for (std::size_t p = begin; p < end; ++p)
        m_vertices[p] = Vertex();
      const bool has_all = end - begin == m_surface.number_of_vertices();
      for (std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
        if (has_all || has_vertex_between(f, begin, end))
          add_face(f, points, begin, end);
      for (std::size_t p = begin; p < end; ++p)
        set_height(m_vertices[p]);
    });
  }

  /// Whether more than this share of the edges join heights of opposite signs. Looks at every
  /// `stride`th face.
  /// Independent noise of the points makes it 4/7 of the edges; of 190 models of the Princeton
  /// benchmark, and of 47 of them with faces split into four, none has more than .41.
  bool are_opposite(double share, std::size_t stride) const
  {
    std::size_t all = 0, opposite = 0;
    for (std::size_t f = 0; f < m_surface.number_of_faces(); f += stride)
      for_each_side(m_surface, f, [&](Index p, Index q) {
        const double product = m_vertices[place(p)].height * m_vertices[place(q)].height;
        all += product != 0;
        opposite += product < 0;
      });
    return double(opposite) > share * double(all) + std::sqrt(double(all)); // not by chance
  }

  /// Moves the points along their normals to the heights of their neighbors, but at creases.
  /// \pre these are the heights of all vertices
  void smooth(Points& points) const
  {
    const double largest = largest_of_noise();
    for_each_index(m_execution, points.size(), [&](std::size_t v) {
      if (std::fabs(m_vertices[v].height) <= largest)
        points[v] = points[v] + m_vertices[v].height * m_vertices[v].normal;
    });
  }

private:
  using Index = Surface::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  void choose_vertices(std::size_t stride)
  {
    m_places.assign(m_surface.number_of_vertices(), none);
    Index number = 0;
    for (std::size_t f = 0; f < m_surface.number_of_faces(); f += stride)
      for_each_side(m_surface, f, [&](Index p, Index) {
        if (m_places[p] == none)
          m_places[p] = number++;
      });
    m_vertices.resize(number);
  }

  Index place(Index vertex) const { return m_places.empty() ? vertex : m_places[vertex]; }

  /// Larger heights stand out of the noise: they are those of creases. 3 times the median of those
  /// that are not 0.
  double largest_of_noise() const
  {
    std::vector<double> heights;
    heights.reserve(m_vertices.size());
    for (const Vertex& v : m_vertices)
      if (v.height != 0)
        heights.push_back(std::fabs(v.height));
    if (heights.empty())
      return 0;
    const auto median = heights.begin() + std::ptrdiff_t(heights.size() / 2);
    std::nth_element(heights.begin(), median, heights.end());
    return 3 * *median;
  }

  static constexpr double flat = 1e-5; // height^2 / area of the faces around: smaller heights are 0

  struct Vertex
  {
    Double_3 to_neighbors{0, 0, 0}; // the sum over the faces, to the next and the previous corner
    Double_3 normal{0, 0, 0};
    double height = 0;
    std::uint32_t number_of_faces = 0;
  };

  bool has_vertex_between(std::size_t face, std::size_t begin, std::size_t end) const
  {
    for (const Index corner : corners_of(m_surface, face))
      if (place(corner) - begin < end - begin)
        return true;
    return false;
  }

  /// To its vertices whose places are between `begin` and `end`.
  void add_face(std::size_t face, const Points& points, std::size_t begin, std::size_t end)
  {
    const std::size_t n = m_surface.number_of_corners(face);
    const Index* const corners = corners_of(m_surface, face).begin();
    const auto point = [&](std::size_t i) { return points[corners[i]]; };
    const Double_3 first = point(0);
    Double_3 twice_area{0, 0, 0}; // by Newell's formula
    for (std::size_t i = 2; i < n && !m_surface.is_degenerate(face); ++i)
      twice_area = twice_area + cross(point(i - 1) - first, point(i) - first);
    Double_3 from_previous = first - point(n - 1), at = first;
    for (std::size_t i = 0; i < n; ++i) {
      const Double_3 next = i + 1 < n ? point(i + 1) : first, to_next = next - at;
      if (const std::size_t p = place(corners[i]); p - begin < end - begin) {
        Vertex& v = m_vertices[p];
        v.to_neighbors = i == 0 ? v.to_neighbors + to_next - from_previous
                                : v.to_neighbors - from_previous + to_next;
        v.normal = v.normal + twice_area;
        ++v.number_of_faces;
      }
      from_previous = to_next;
      at = next;
    }
  }

  static void set_height(Vertex& v)
  {
    const double twice_area = norm(v.normal);
    if (twice_area == 0)
      return;
    v.normal = (1 / twice_area) * v.normal;
    const double height = dot(v.to_neighbors, v.normal) / (2 * v.number_of_faces);
    if (2 * (height * height) > flat * twice_area)
      v.height = height;
  }

  const Surface& m_surface;
  const Execution m_execution; // silent
  Large_array<Index> m_places; // by vertex: in the array of those that are chosen; empty: all are
  Large_array<Vertex> m_vertices;
};

/// The points of a surface moved to the height of their neighbors, but at creases, until little
/// noise is left; none where there is not more noise than curvature. So angles are measured over a
/// width that the noise asks for.
///
/// O(F); with a small constant where there is no noise, which is seen from some 20,000 faces.
inline std::optional<Large_array<Double_3>> points_without_noise(const Surface& surface,
                                                                 const Execution& execution)
{
  constexpr std::size_t enough_faces = 20000;
  constexpr int most_rounds = 5;
  constexpr double share_of_noise = 0.42, share_left = 0.2; // of edges
  const std::size_t stride = (std::max)(surface.number_of_faces() / enough_faces, std::size_t(1));
  std::optional<Vertex_heights> heights(std::in_place, surface, stride, execution);
  if (!heights->are_opposite(share_of_noise, stride))
    return std::nullopt;
  if (stride > 1)
    heights.emplace(surface, 1, execution);
  Large_array<Double_3> points = arrays_of(surface).points;
  for (int round = 1;; ++round) {
    heights->smooth(points);
    if (round == most_rounds)
      break;
    heights->update(points);
    if (!heights->are_opposite(share_left, stride))
      break;
  }
  return points;
}

/// Moves the points of a surface, and with them normals, areas and the signs of angles. Degenerate
/// faces and the lengths of adjacencies remain as they are.
inline void move_points(Surface& surface, Large_array<Double_3> points, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(surface);
  arrays.points = std::move(points);
  std::vector<std::pair<std::size_t, double>> degenerate; // faces and their areas
  for (std::size_t f = 0; f < arrays.areas.size(); ++f)
    if (surface.is_degenerate(f))
      degenerate.push_back({f, arrays.areas[f]});
  compute_normals(surface, execution);
  for (const auto& [face, area] : degenerate) {
    arrays.normals[face] = {0, 0, 0};
    arrays.areas[face] = area;
  }
  sum_up(surface);
  for_each_index(execution, arrays.flags.size(), [&](std::size_t a) {
    if (!surface.has_angle(a))
      return;
    const Surface::Index lower = surface.lower_face(a), higher = surface.higher_face(a);
    const auto [direction, number] = common_edges(surface, lower, higher);
    if (number > 0)
      arrays.flags[a] = with_sign(
        arrays.flags[a], sign_of_edge(surface.normal(higher), surface.normal(lower), direction));
  });
}

/// The surface with less noise; none if it has no more noise than curvature.
inline std::optional<Surface> without_noise(const Surface& surface, const Execution& execution)
{
  auto points = points_without_noise(surface, execution);
  if (!points)
    return std::nullopt;
  Surface result = surface;
  move_points(result, std::move(*points), execution);
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_SMOOTH_NOISE_H
