// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/internal/segments/Primitive_fitter.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/Surface_moments.h>
#include <CGAL/Region_segmentation/internal/segments/border_loops.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Describes all segments of a mesh at once, in units of the flat mesh.
///
/// \tparam Numbers `Segment_numbers` of some type of labels
template <typename FaceGraph, typename Pack, typename Numbers>
class Segment_describer
{
  using Index = Flat_mesh::Index;
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Label = typename decltype(Numbers::labels)::value_type;

public:
  using Description = Segment_description<Label>;

  Segment_describer(const Traversal& traversal, const Pack& np, const Flat_mesh& flat, const Numbers& numbers)
    : m_traversal(traversal), m_np(np), m_flat(flat), m_numbers(numbers), m_faces(numbers.labels.size())
    , m_descriptions(numbers.labels.size())
  {
    for (Index s : numbers.of_face)
      if (s != Numbers::none)
        m_faces.count(s);
    m_faces.end_counting();
    for (std::size_t f = 0; f < numbers.of_face.size(); ++f)
      if (numbers.of_face[f] != Numbers::none)
        m_faces.add(numbers.of_face[f], Index(f));
  }

  std::vector<Description> describe()
  {
    integrate();
    describe_neighbors();
    for (std::size_t s = 0; s < m_descriptions.size(); ++s) {
      Description& d = m_descriptions[s];
      d.segment = m_numbers.labels[s];
      d.number_of_faces = m_faces[s].size();
      d.primitive = Primitive_fitter(m_flat, m_faces[s], d.centroid, d.area).fit();
    }
    return std::move(m_descriptions);
  }

private:
  const Double_3& point(typename Traversal::halfedge_descriptor h) const // of its source
  {
    return m_flat.points()[m_traversal.source_rank(h)];
  }

  void integrate()
  {
    const Mesh_points& points = m_flat.points();
    std::vector<Surface_moments> moments;
    for (std::size_t s = 0; s < m_descriptions.size(); ++s) {
      moments.emplace_back(points[points.corner(*m_faces[s].begin(), 0)]);
      for (Index f : m_faces[s])
        moments.back().add_face(m_flat, f);
    }
    close_borders(moments);
    double sum_of_volumes = 0;
    for (std::size_t s = 0; s < m_descriptions.size(); ++s) {
      Description& d = m_descriptions[s];
      d.area = moments[s].area();
      d.centroid = moments[s].centroid();
      d.volume = moments[s].volume();
      sum_of_volumes += d.volume;
      set_axes(moments[s].covariance(), d);
      set_extents(s, d);
    }
    if (sum_of_volumes > 0)
      for (Description& d : m_descriptions)
        d.volume_share = d.volume / sum_of_volumes;
  }

  void close_borders(std::vector<Surface_moments>& moments)
  {
    const Segmented_mesh<Traversal> segmented(m_traversal, m_numbers.of_face);
    const FaceGraph& mesh = m_traversal.mesh();
    for_each_border_loop(segmented, m_np, [&](Index segment, const auto& loop) {
      Double_3 sum{0, 0, 0};
      for (auto h : loop) {
        const Double_3 from = point(h), to = point(opposite(h, mesh));
        sum = sum + from;
        if (CGAL::is_border(opposite(h, mesh), mesh))
          m_descriptions[segment].boundary_length += norm(to - from);
      }
      const Double_3 mean = 1 / double(loop.size()) * sum;
      const double orientation = orientation_of_loop(loop);
      for (auto h : loop)
        moments[segment].add_cap(mean, point(opposite(h, mesh)), point(h), orientation);
    });
  }

  /// That of the first face which is not degenerate, since all of a loop are in one component.
  template <typename Loop>
  double orientation_of_loop(const Loop& loop) const
  {
    const auto rank = m_traversal.rank_of_face();
    for (auto h : loop) {
      const std::size_t f = rank(face(h, m_traversal.mesh()));
      if (!m_flat.is_degenerate(f))
        return orientation_of_corners(m_flat, f);
    }
    return 1;
  }

  static void set_axes(const Symmetric_3& covariance, Description& d)
  {
    const auto& [xx, xy, xz, yy, yz, zz] = covariance;
    Eigen::Matrix3d matrix;
    matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Eigen::Matrix3d vectors = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors();
    for (std::size_t i = 0; i < 2; ++i) {
      Eigen::Vector3d axis = vectors.col(2 - Eigen::Index(i)); // eigenvalues increase
      Eigen::Index largest;
      axis.cwiseAbs().maxCoeff(&largest);
      if (axis[largest] < 0)
        axis = -axis;
      d.axes[i] = from_eigen(axis);
    }
    d.axes[2] = cross(d.axes[0], d.axes[1]);
  }

  void set_extents(std::size_t segment, Description& d) const
  {
    const Mesh_points& points = m_flat.points();
    for (std::size_t i = 0; i < 3; ++i) {
      double lowest = (std::numeric_limits<double>::max)(), highest = -lowest;
      for (Index f : m_faces[segment])
        for (std::size_t c = 0; c < points.number_of_corners(f); ++c) {
          const double x = dot(points[points.corner(f, c)] - d.centroid, d.axes[i]);
          lowest = (std::min)(lowest, x);
          highest = (std::max)(highest, x);
        }
      d.extents[i] = highest - lowest;
    }
  }

  void describe_neighbors()
  {
    struct Side
    {
      Index segment, neighbor;
      double length, signed_deviation;
    };
    std::vector<Side> sides;
    for (std::size_t e = 0; e < m_flat.number_of_edges(); ++e) {
      const Index lower = m_flat.lower_face(e), a = m_numbers.of_face[lower],
                  b = m_numbers.of_face[m_flat.higher_face(e)];
      if (a == b)
        continue;
      const double sign = m_flat.has_flag(e, Flat_mesh::CONCAVE) ? -1 : 1;
      const double length = m_flat.length(e), deviation = sign * m_flat.deviation(lower, e);
      if (a != Numbers::none)
        sides.push_back({a, b, length, deviation});
      if (b != Numbers::none)
        sides.push_back({b, a, length, deviation});
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
      return std::tie(x.segment, x.neighbor) < std::tie(y.segment, y.neighbor);
    });
    for (auto first = sides.begin(); first != sides.end();) {
      double length = 0, sum = 0;
      auto last = first;
      for (; last != sides.end() && last->segment == first->segment && last->neighbor == first->neighbor; ++last) {
        length += last->length;
        sum += last->length * last->signed_deviation;
      }
      Description& d = m_descriptions[first->segment];
      d.neighbors.push_back({m_numbers.label(first->neighbor), length, length > 0 ? sum / length : 0});
      d.border_length += length;
      first = last;
    }
  }

  const Traversal& m_traversal;
  const Pack& m_np;
  const Flat_mesh& m_flat;
  const Numbers& m_numbers;
  Grouped_items<Index> m_faces; // by segment
  std::vector<Description> m_descriptions;
};

/// Converts lengths in a unit to units of the mesh.
template <typename Label>
void scale_description(Segment_description<Label>& d, double unit)
{
  // One by one: the square of the unit may be infinite, the area 0.
  d.area = d.area * unit * unit;
  d.volume = d.volume * unit * unit * unit;
  d.centroid = unit * d.centroid;
  for (double& extent : d.extents)
    extent *= unit;
  d.border_length *= unit;
  d.boundary_length *= unit;
  for (auto& neighbor : d.neighbors)
    neighbor.border_length *= unit;
  d.primitive.point = unit * d.primitive.point;
  d.primitive.radius *= unit;
  d.primitive.error *= unit;
  for (double& error : d.primitive.errors)
    error *= unit;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
