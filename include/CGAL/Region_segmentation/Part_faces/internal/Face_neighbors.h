// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_NEIGHBORS_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_NEIGHBORS_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(adjacency, i, j)` for the adjacencies across edges and seams of faces with different
/// labels i and j: those of the lower and of the higher face.
template <typename Labels, typename F>
void for_each_border(const Surface& surface, const Labels& labels, const F& f)
{
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index i = labels[surface.lower_face(a)], j = labels[surface.higher_face(a)];
    if (i != j && !surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED))
      f(a, i, j);
  }
}

/// The faces adjacent to each face across edges, and whether they go on smoothly there.
///
/// A *thin* face is a sliver, needle or cap, or has no area: its normal tells nothing. It has no
/// neighbors. Its *host* is the face that it belongs to, whatever surface that is on: that neighbor
/// on whose plane its vertices lie best, or the host of a thin one. What is adjacent to it is
/// adjacent to the host.
class Face_neighbors
{
public:
  using Index = Surface::Index;
  struct Neighbor
  {
    Index face, adjacency;
  };
  /// \param resolution faces are coplanar if each has its vertices in the plane of the other, up to
  ///        this
  Face_neighbors(const Surface& surface, double resolution)
    : m_surface(surface)
    , m_resolution(resolution)
  {
    find_hosts();
    m_neighbors = Grouped_items<Neighbor>(surface.number_of_faces(), [&](const auto& add) {
      for (Index a = 0; a < surface.number_of_adjacencies(); ++a) {
        const Index f = m_hosts[surface.lower_face(a)], g = m_hosts[surface.higher_face(a)];
        if (f != g && !surface.has_flag(a, Surface::barrier)) {
          add(f, {g, a});
          add(g, {f, a});
        }
      }
    });
    m_around = Grouped_items<Index>(surface.number_of_vertices(), [&](const auto& add) {
      for (Index f = 0; f < surface.number_of_faces(); ++f)
        if (m_hosts[f] == f)
          for (const Index v : surface.corners(f))
            add(v, f);
    });
    find_facets();
  }

  /// The faces around a vertex that are not thin.
  Iterator_range<const Index*> around(std::size_t vertex) const { return m_around[vertex]; }

  Iterator_range<const Neighbor*> operator[](std::size_t face) const { return m_neighbors[face]; }

  /// The face itself unless it is thin and beside others.
  Index host(std::size_t face) const { return m_hosts[face]; }

  /// The host of what is across the i-th side of a face, or none.
  Index across(std::size_t face, std::size_t i) const
  {
    const Index a = m_surface.adjacency(face, i);
    if (a == Surface::none)
      return Surface::none;
    const Index f = m_surface.lower_face(a);
    return m_hosts[f == face ? m_surface.higher_face(a) : f];
  }

  /// That of the normals of the two hosts.
  double cosine(std::size_t adjacency) const
  {
    return dot(m_surface.normal(m_hosts[m_surface.lower_face(adjacency)]),
               m_surface.normal(m_hosts[m_surface.higher_face(adjacency)]));
  }
  /// Whether the deviation of an adjacency may be that of two facets of a curved face. Others are
  /// creases, which no face crosses.
  bool is_smooth(std::size_t adjacency) const { return cosine(adjacency) > smooth_cosine; }
  bool are_smooth(Index f, Index g) const
  {
    return dot(m_surface.normal(f), m_surface.normal(g)) > smooth_cosine;
  }
  /// Whether its two faces are parts of one plane facet.
  bool is_coplanar(std::size_t adjacency) const
  {
    const Index f = m_hosts[m_surface.lower_face(adjacency)],
                g = m_hosts[m_surface.higher_face(adjacency)];
    return cosine(adjacency) > flat_cosine ||
           (m_resolution > 0 && (std::max)(height_over(f, g), height_over(g, f)) <= m_resolution);
  }

  /// The faces around it that are coplanar are one facet.
  Index facet(std::size_t face) const { return m_facets[face]; }
  const Double_3& center_of_facet(std::size_t face) const { return m_centers[m_facets[face]]; }
  /// Two vertices of the facet of a face, far from each other: 0 and 1.
  const Double_3& end_of_facet(std::size_t face, int i) const
  {
    return m_surface.point(m_ends[i][m_facets[face]]);
  }

private:
  static constexpr double flat_cosine = 1 - 1e-9;
  static constexpr double smooth_cosine = 0.694; // 46 degrees: a cylinder has at least 8 facets

  /// From the faces that are not thin outwards.
  void find_hosts()
  {
    const std::size_t n = m_surface.number_of_faces();
    m_hosts.assign(n, Surface::none);
    for (Index f = 0; f < n; ++f)
      if (!is_thin(f))
        m_hosts[f] = f;
    // First across long sides: what is on both sides of a thin face is adjacent there.
    for (const double share : {0.5, 0.0}) {
      std::vector<Index> front;
      for (Index f = 0; f < n; ++f)
        if (m_hosts[f] == Surface::none)
          front.push_back(f);
      if (front.empty())
        return;
      const Grouped_items<Index> around_thin(n, [&](const auto& add) {
        for (Index a = 0; a < m_surface.number_of_adjacencies(); ++a)
          if (!m_surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED))
            for (const auto& [f, g] :
                 {std::pair(m_surface.lower_face(a), m_surface.higher_face(a)),
                  std::pair(m_surface.higher_face(a), m_surface.lower_face(a))})
              if (m_hosts[f] == Surface::none &&
                  m_surface.length(a) >= share * range_of_sides(f).second)
                add(f, g);
      });
      while (!front.empty())
        front = find_hosts(front, around_thin);
    }
    for (Index f = 0; f < n; ++f)
      if (m_hosts[f] == Surface::none)
        m_hosts[f] = f;
  }

  /// Returns the thin faces without a host beside those that were found.
  std::vector<Index> find_hosts(const std::vector<Index>& front,
                                const Grouped_items<Index>& around_thin)
  {
    std::vector<std::pair<Index, Index>> found; // thin faces and their hosts
    for (const Index f : front)
      if (const Index host = nearest_host(f, around_thin[f]); host != Surface::none)
        found.push_back({f, host});
    for (const auto& [f, host] : found)
      m_hosts[f] = host;
    std::vector<Index> next;
    for (const auto& pair : found)
      for (const Index g : around_thin[pair.first])
        if (m_hosts[g] == Surface::none)
          next.push_back(g);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  void find_facets()
  {
    Lowest_root_forest facets(Index(m_surface.number_of_faces()));
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      for (const Neighbor& n : m_neighbors[f])
        if (n.face < f && is_coplanar(n.adjacency))
          facets.unite(f, n.face);
    m_facets = facets.take_partition();
    m_centers.assign(m_facets.number_of_parts(), Double_3{0, 0, 0});
    std::vector<double> areas(m_centers.size(), 0);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f) {
      m_centers[m_facets[f]] = m_centers[m_facets[f]] + m_surface.area(f) * m_surface.centroid(f);
      areas[m_facets[f]] += m_surface.area(f);
    }
    for (std::size_t i = 0; i < areas.size(); ++i)
      m_centers[i] = areas[i] > 0 ? (1 / areas[i]) * m_centers[i] : m_centers[i];
    m_ends[0] = farthest_vertices([&](Index facet) { return m_centers[facet]; });
    m_ends[1] = farthest_vertices([&](Index facet) { return m_surface.point(m_ends[0][facet]); });
  }

  /// By facet: the vertex that is farthest from a point.
  template <typename Point>
  std::vector<Index> farthest_vertices(const Point& point) const
  {
    std::vector<Index> result(m_centers.size(), 0);
    std::vector<double> farthest(m_centers.size(), -1);
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      for (const Index v : m_surface.corners(f)) {
        const Index facet = m_facets[f];
        const double d = squared_norm(m_surface.point(v) - point(facet));
        if (d > farthest[facet]) {
          farthest[facet] = d;
          result[facet] = v;
        }
      }
    return result;
  }

  template <typename Range>
  Index nearest_host(Index face, const Range& around) const
  {
    Index best = Surface::none;
    double least = std::numeric_limits<double>::infinity();
    for (const Index g : around)
      if (const Index host = m_hosts[g]; host != Surface::none) {
        const double distance = height_over(host, face);
        if (distance < least) {
          least = distance;
          best = host;
        }
      }
    return best;
  }

  /// The largest distance of the vertices of a face from the plane of another one.
  double height_over(Index plane, Index face) const
  {
    const Double_3 origin = m_surface.point(m_surface.corner(plane, 0));
    double height = 0;
    for (const Index v : m_surface.corners(face))
      height = (std::max)(height,
                          std::fabs(dot(m_surface.normal(plane), m_surface.point(v) - origin)));
    return height;
  }

  std::pair<double, double> range_of_sides(std::size_t face) const
  {
    std::pair<double, double> range{std::numeric_limits<double>::infinity(), 0};
    for_each_side(m_surface, face, [&](Index v, Index w) {
      const double length = norm(m_surface.point(w) - m_surface.point(v));
      range = {(std::min)(range.first, length), (std::max)(range.second, length)};
    });
    return range;
  }

  /// Half of a narrow strip, which has an edge about as short as its height, is not thin.
  bool is_thin(std::size_t face) const
  {
    constexpr double thin = 0.002, // height over the longest edge
      of_strip = 0.5,              // height over the shortest edge
      rounding = 1e-5;             // height over the size of the surface
    const auto [shortest, longest] = range_of_sides(face);
    const double height = 2 * m_surface.area(face) / longest;
    return m_surface.is_degenerate(face) ||
           (height < thin * longest &&
            (height < of_strip * shortest || height < rounding * m_surface.length_unit()));
  }

  const Surface& m_surface;
  double m_resolution;
  std::vector<Index> m_hosts; // by face
  Grouped_items<Neighbor> m_neighbors;
  Grouped_items<Index> m_around;
  Partition m_facets;
  std::vector<Double_3> m_centers; // by facet
  std::vector<Index> m_ends[2];
};

/// The side that two faces share, from one vertex to another; of several, one of them. `along` is 0
/// if they share no vertices. Linear time in the corners of the face that has fewer.
struct Shared_side
{
  Double_3 middle{0, 0, 0}, along{0, 0, 0};

  Shared_side(const Surface& surface, std::size_t face, std::size_t other)
  {
    if (surface.number_of_corners(face) > surface.number_of_corners(other))
      std::swap(face, other);
    const std::size_t n = surface.number_of_corners(face);
    double least = none;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p = surface.corner(face, i), q = surface.corner(face, (i + 1) % n);
      const double distance = (std::max)(this->distance(surface, p, other),
                                         this->distance(surface, q, other));
      if (distance < least) {
        least = distance;
        set(surface.point(p), surface.point(q));
      }
    }
    if (least == none)
      middle = 0.5 * (surface.centroid(face) + surface.centroid(other));
  }

private:
  static constexpr std::size_t many = 64; // corners, among which a vertex is not searched
  static constexpr double none = (std::numeric_limits<double>::max)();

  /// 0 for a vertex of a face, else none; that from its plane where the face has many corners.
  static double distance(const Surface& surface, std::size_t vertex, std::size_t face)
  {
    const std::size_t n = surface.number_of_corners(face);
    if (n > many)
      return std::fabs(
        dot(surface.normal(face), surface.point(vertex) - surface.point(surface.corner(face, 0))));
    for (std::size_t i = 0; i < n; ++i)
      if (surface.corner(face, i) == vertex)
        return 0;
    return none;
  }

  void set(const Double_3& from, const Double_3& to)
  {
    const Double_3 d = to - from;
    middle = 0.5 * (from + to);
    along = norm(d) > 0 ? (1 / norm(d)) * d : d;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_NEIGHBORS_H
