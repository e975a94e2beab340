// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_CURVATURES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_CURVATURES_H

#include <CGAL/Region_segmentation/internal/part_faces/Face_neighbors.h>
#include <CGAL/Region_segmentation/internal/part_faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/part_faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The normals of a smooth surface at the vertices of some faces of its tessellation, from the
/// positions of the vertices alone.
///
/// Between two vertices of one face of the part the surface is nearly an arc, and its normals m and
/// n at them make equal angles with the chord d: (m + n) d = 0. Edges do not cross borders of
/// faces, so these equations hold, up to third order, beside borders across which the curvature
/// jumps, too; a fit to a neighborhood mixes both sides there. They are solved in the sense of
/// least squares, with a small weight on the first estimate: along a polyline they determine the
/// normals but for one that alternates.
///
/// A vertex has a normal for each *fan*, the faces around it that go on smoothly.
class Chord_normals
{
public:
  using Index = Surface::Index;

  /// \param is_free by face: those whose normals are wanted. Where they meet others smoothly, these
  ///        have a surface, and its normals hold.
  Chord_normals(const Face_search& search, const std::vector<std::uint8_t>& is_free)
    : m_surface(search.surface)
    , m_first(m_surface.number_of_faces(), Face_search::none)
  {
    find_fans(search, is_free);
    estimate(search.neighbors, is_free);
    take_from_surfaces(search);
    collect_chords(is_free);
    constexpr int steps = 2; // of Newton's method
    for (int i = 0; i < steps; ++i)
      improve();
  }

  const Double_3& operator()(std::size_t face, std::size_t corner) const
  {
    return m_normals[m_fans[m_first[face] + corner]];
  }

private:
  struct Chord
  {
    Index ends[2];        // fans
    Double_3 direction;   // of length 1
    Double_3 tangents[2]; // the direction, projected along the normals at the ends
  };
  struct Contact
  {
    Index adjacency, corner, face; // the corner of a free face, and a face that is not
    friend bool operator<(const Contact& a, const Contact& b)
    {
      return std::tie(a.adjacency, a.corner) < std::tie(b.adjacency, b.corner);
    }
  };

  void find_fans(const Face_search& search, const std::vector<std::uint8_t>& is_free)
  {
    Index corners = 0;
    for (std::size_t f = 0; f < m_first.size(); ++f)
      if (is_free[f]) {
        m_first[f] = corners;
        corners += Index(m_surface.number_of_corners(f));
      }
    Lowest_root_forest fans(corners);
    std::vector<Index> corner_at(m_surface.number_of_vertices(), Face_search::none);
    for (Index f = 0; f < m_first.size(); ++f) {
      const std::size_t n = m_surface.number_of_corners(f);
      for (Index i = 0; i < n; ++i)
        corner_at[m_surface.corner(f, i)] = i;
      for (const Face_neighbors::Neighbor& neighbor : search.neighbors[f])
        if (const Index g = neighbor.face;
            std::pair(m_surface.number_of_corners(g), g) < std::pair(n, f) &&
            (is_free[f] || is_free[g]) && search.neighbors.may_be_smooth(neighbor.adjacency)) {
          for (Index j = 0; j < m_surface.number_of_corners(g); ++j) {
            const Index i = corner_at[m_surface.corner(g, j)];
            if (i == Face_search::none)
              continue;
            if (is_free[f] && is_free[g])
              fans.unite(m_first[f] + i, m_first[g] + j);
            else if (is_free[f])
              m_contacts.push_back({neighbor.adjacency, m_first[f] + i, g});
            else
              m_contacts.push_back({neighbor.adjacency, m_first[g] + j, f});
          }
        }
      for (Index i = 0; i < n; ++i)
        corner_at[m_surface.corner(f, i)] = Face_search::none;
    }
    std::sort(m_contacts.begin(), m_contacts.end());
    m_fans = fans.take_partition();
    m_normals.assign(m_fans.number_of_parts(), Double_3{0, 0, 0});
    m_points.resize(m_normals.size());
    m_is_known.assign(m_normals.size(), 0);
  }

  /// The mean of the normals of the faces, with the weights by which it is that of a sphere through
  /// the vertices: area over the squared lengths of both edges.
  void estimate(const Face_neighbors& neighbors, const std::vector<std::uint8_t>& is_free)
  {
    constexpr double of_thin = 1e-3;
    for (std::size_t f = 0; f < m_first.size(); ++f)
      if (is_free[f])
        for (std::size_t i = 0, n = m_surface.number_of_corners(f); i < n; ++i) {
          const Index fan = m_fans[m_first[f] + i];
          const Double_3 p = m_surface.point(m_surface.corner(f, i));
          const double edges = squared_norm(m_surface.point(m_surface.corner(f, (i + 1) % n)) - p) *
                               squared_norm(m_surface.point(m_surface.corner(f, (i + n - 1) % n)) -
                                            p);
          m_points[fan] = p;
          if (edges > 0 && !m_surface.is_degenerate(f))
            m_normals[fan] = m_normals[fan] +
                             (m_surface.area(f) / edges * (neighbors.is_thin(f) ? of_thin : 1)) *
                               m_surface.normal(f);
        }
    for (Double_3& n : m_normals)
      normalize(n);
  }

  void take_from_surfaces(const Face_search& search)
  {
    constexpr double is_tangent = 0.9; // cosine
    for (const Contact& contact : m_contacts) {
      const Index fan = m_fans[contact.corner];
      const Double_3 n = surface_normal(search.surface_of(contact.face), m_points[fan]);
      if (!m_is_known[fan] && dot(n, m_normals[fan]) > is_tangent) {
        m_normals[fan] = n;
        m_is_known[fan] = 1;
      }
    }
  }

  void collect_chords(const std::vector<std::uint8_t>& is_free)
  {
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t f = 0; f < m_first.size(); ++f)
      if (is_free[f])
        for (std::size_t i = 0, n = m_surface.number_of_corners(f); i < n; ++i) {
          const Index a = m_fans[m_first[f] + i], b = m_fans[m_first[f] + (i + 1) % n];
          pairs.push_back({(std::min)(a, b), (std::max)(a, b)});
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& pair : pairs) {
      const Double_3 d = m_points[pair.second] - m_points[pair.first];
      const double length = norm(d);
      if (length > 0)
        m_chords.push_back({{pair.first, pair.second}, (1 / length) * d, {}});
    }
  }

  /// Tilts the normals: conjugate gradients for the linear equations.
  void improve()
  {
    constexpr int iterations = 30;
    constexpr double of_estimate = 0.01; // weight, the equation of a chord has 1
    const std::size_t n = m_normals.size();
    std::vector<Double_3> tilt(n), residual(n), product(n); // zeros
    const auto add = [&](std::vector<Double_3>& to, const Chord& c, double x) {
      for (int i = 0; i < 2; ++i)
        to[c.ends[i]] = to[c.ends[i]] + x * c.tangents[i];
    };
    for (Chord& c : m_chords) {
      double sum = 0;
      for (int i = 0; i < 2; ++i) {
        const Double_3& m = m_normals[c.ends[i]];
        const double along = dot(m, c.direction);
        c.tangents[i] = m_is_known[c.ends[i]] ? Double_3{0, 0, 0} : c.direction - along * m;
        sum += along;
      }
      add(residual, c, -sum);
    }
    std::vector<Double_3> direction = residual;
    double squared = squared_norm_of(residual);
    const double negligible = 1e-12 * squared;
    for (int i = 0; i < iterations && squared > negligible; ++i) {
      for (std::size_t k = 0; k < n; ++k)
        product[k] = of_estimate * direction[k];
      double denominator = of_estimate * squared_norm_of(direction);
      for (const Chord& c : m_chords) {
        const double x = dot(c.tangents[0], direction[c.ends[0]]) +
                         dot(c.tangents[1], direction[c.ends[1]]);
        denominator += x * x;
        add(product, c, x);
      }
      const double step = squared / denominator;
      for (std::size_t k = 0; k < n; ++k) {
        tilt[k] = tilt[k] + step * direction[k];
        residual[k] = residual[k] - step * product[k];
      }
      const double next = squared_norm_of(residual);
      for (std::size_t k = 0; k < n; ++k)
        direction[k] = residual[k] + (next / squared) * direction[k];
      squared = next;
    }
    for (std::size_t k = 0; k < n; ++k) {
      m_normals[k] = m_normals[k] + tilt[k];
      normalize(m_normals[k]);
    }
  }

  static double squared_norm_of(const std::vector<Double_3>& v)
  {
    double sum = 0;
    for (const Double_3& x : v)
      sum += squared_norm(x);
    return sum;
  }

  static void normalize(Double_3& v)
  {
    const double length = norm(v);
    v = length > 0 ? (1 / length) * v : Double_3{0, 0, 1};
  }

  const Surface& m_surface;
  std::vector<Index> m_first; // by face: its first corner among those of free faces
  Partition m_fans;           // of corners
  std::vector<Double_3> m_points, m_normals;
  std::vector<std::uint8_t> m_is_known;
  std::vector<Contact> m_contacts;
  std::vector<Chord> m_chords;
};

/// The curvature of the surface in each of some faces of its tessellation, and how much it jumps
/// from one face to the next.
class Face_curvatures
{
public:
  using Index = Surface::Index;

  struct Jump
  {
    double difference; ///< of the normal curvatures orthogonal to the edge, lower face - higher one
    double scale;      ///< that a difference between two faces of the part is compared with
  };

  Face_curvatures(const Face_search& search, const std::vector<std::uint8_t>& is_free)
    : m_surface(search.surface)
    , m_numbers(m_surface.number_of_faces(), 0)
  {
    const Chord_normals normals(search, is_free);
    for (std::size_t f = 0; f < m_numbers.size(); ++f)
      if (is_free[f]) {
        m_numbers[f] = Index(m_tensors.size());
        m_tensors.push_back(m_surface.is_degenerate(f) ? Tensor() : tensor(normals, f));
      }
  }

  /// Across an adjacency of two of the faces.
  Jump operator()(std::size_t adjacency) const
  {
    constexpr double of_norm = 0.05, of_error = 25, of_size = 1;
    const Index f = m_surface.lower_face(adjacency), g = m_surface.higher_face(adjacency);
    const Tensor &s = m_tensors[m_numbers[f]], &t = m_tensors[m_numbers[g]];
    const Double_3 along = Shared_side(m_surface, f, g).along;
    const double cf = s.across(along), cg = t.across(along);
    return {cf - cg, (std::max)(std::fabs(cf), std::fabs(cg)) +
                       of_norm * (std::max)(s.norm(), t.norm()) + of_error * (s.error + t.error) +
                       of_size / m_surface.length_unit()};
  }

private:
  /// The symmetric tensor whose product with a step is the change of the normal, in a frame of the
  /// tangent plane.
  struct Tensor
  {
    Double_3 axes[2] = {{0, 0, 0}, {0, 0, 0}};
    double xx = 0, xy = 0, yy = 0;
    double error = 0; ///< of the curvature along edges

    double norm() const { return std::sqrt(xx * xx + 2 * xy * xy + yy * yy); }
    /// The normal curvature orthogonal to a direction in the tangent plane.
    double across(const Double_3& along) const
    {
      const double x = dot(along, axes[0]), y = dot(along, axes[1]), squared = x * x + y * y;
      return squared > 0 ? (xx * y * y - 2 * xy * x * y + yy * x * x) / squared : 0;
    }
  };

  /// Least squares over the edges.
  Tensor tensor(const Chord_normals& normals, std::size_t f) const
  {
    using Vector = Eigen::Matrix<double, 3, 1, Eigen::DontAlign>;
    constexpr double regular = 1e-6;
    const std::size_t n = m_surface.number_of_corners(f);
    Double_3 normal{0, 0, 0};
    for (std::size_t i = 0; i < n; ++i)
      normal = normal + normals(f, i);
    const double length = Region_segmentation::norm(normal);
    Tensor t;
    if (!(length > 0))
      return t;
    t.axes[0] = any_perpendicular((1 / length) * normal);
    t.axes[1] = cross((1 / length) * normal, t.axes[0]);
    Eigen::Matrix<double, 3, 3, Eigen::DontAlign> a = Eigen::Matrix3d::Zero();
    Vector b = Vector::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Double_3 d = m_surface.point(m_surface.corner(f, j)) -
                         m_surface.point(m_surface.corner(f, i));
      const Double_3 turn = normals(f, j) - normals(f, i);
      const double squared = squared_norm(d);
      if (!(squared > 0))
        continue;
      t.error = (std::max)(t.error, std::fabs(dot(normals(f, i) + normals(f, j), d)) / squared);
      const double x = dot(d, t.axes[0]), y = dot(d, t.axes[1]);
      const Vector rows[] = {Vector(x, y, 0), Vector(0, x, y)};
      for (int k = 0; k < 2; ++k) {
        a += rows[k] * rows[k].transpose();
        b += dot(turn, t.axes[k]) * rows[k];
      }
    }
    const double trace = a(0, 0) + a(1, 1) + a(2, 2);
    for (int k = 0; k < 3; ++k)
      a(k, k) += regular * trace;
    const Vector c = solve_positive_definite(a, b);
    t.xx = c[0];
    t.xy = c[1];
    t.yy = c[2];
    return t;
  }

  const Surface& m_surface;
  std::vector<Index> m_numbers; // of the faces, from 0
  std::vector<Tensor> m_tensors;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_CURVATURES_H
