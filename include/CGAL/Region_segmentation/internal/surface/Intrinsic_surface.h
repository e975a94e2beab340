// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_SURFACE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_SURFACE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/surface/Intrinsic_frame.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>
#include <CGAL/Region_segmentation/internal/surface/move_points.h>
#include <CGAL/Region_segmentation/internal/surface/Original_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A surface in its `Intrinsic_frame`, its points on a grid of 2^-28 of its size or area, far above
/// rounding and far below what matters; vertices and faces in the order of their positions along a
/// generic direction. So the same shape in another frame, unit or numbering is bitwise the same
/// surface, and candidates that are equal but for rounding are decided between alike. (A point is
/// within rounding of the border of two cells with a probability of one in a million or less: then
/// it moves to the next cell.) Faces that are given twice or lie on others are one.
///
/// A surface of more than `most_faces` faces stays as it is: the copy would take half as much
/// memory again.
class Intrinsic_surface
{
  using Index = Surface::Index;

public:
  static constexpr std::size_t most_faces = std::size_t(1) << 19;

  Intrinsic_surface() = default;
  explicit Intrinsic_surface(const Surface& given)
  {
    if (given.number_of_faces() == 0 || given.number_of_faces() > most_faces)
      return;
    Original_faces originals(given);
    m_frame = Intrinsic_frame(
      given, [&](std::size_t f) { return originals.is_original(f) && !given.is_crumb(f); });
    const double steps = steps_of_grid(given);
    Large_array<Double_3> points(given.number_of_vertices());
    for (std::size_t v = 0; v < points.size(); ++v)
      points[v] = on_grid(m_frame(given.point(v)), steps);
    number_faces(given, originals.of, points);
    Surface_arrays& arrays = arrays_of(*m_surface);
    arrays.unit = given.unit() * m_frame.unit();
    arrays.has_seams_or_links = given.has_seams_or_links();
    arrays.number_of_input_faces = given.number_of_input_faces();
    set_corners(given, points, arrays);
    set_faces(given);
    m_is_left_out = std::move(originals.is_left_out);
    set_adjacencies(given);
  }

  /// The surface that is made of the given one.
  const Surface& of(const Surface& given) const { return m_surface ? *m_surface : given; }
  const Intrinsic_frame& frame() const { return m_frame; }
  /// With its points moved to these.
  void move_points(const Surface& given, Large_array<Double_3> points, const Execution& execution)
  {
    if (!m_surface)
      m_surface = given;
    internal::move_points(*m_surface, std::move(points), execution);
  }

  /// What is asked of the given surface.
  /// \throws Invalid_input if faces that are one have different seeds
  Request request(const Surface& given, const Request& request) const
  {
    Request result = request;
    if (!request.constraints.empty() && !m_faces.empty()) {
      result.constraints = Constraints();
      const Large_array<Adjacency> adjacencies = sorted_adjacencies(given).all();
      for (std::size_t a = 0; a < adjacencies.size(); ++a)
        if (request.constraints[adjacencies[a].second])
          result.constraints.add(a, adjacencies.size());
    }
    if (!request.seeds.empty() && !m_faces.empty()) {
      result.seeds.of.assign(m_surface->number_of_faces(), Seeds::Index(Seeds::none));
      for (std::size_t f = 0; f < m_faces.size(); ++f) {
        Seeds::Index& seed = result.seeds.of[m_faces[f]];
        const Seeds::Index other = request.seeds.of[f];
        if (seed != Seeds::none && other != Seeds::none && other != seed)
          throw Invalid_input("face " + std::to_string(f) +
                              " is given twice, or lies on another one, with two different seeds");
        if (other != Seeds::none)
          seed = other;
      }
    }
    return result;
  }

  /// The partition of the given faces by `part_of(face)` of those of the surface; and the new
  /// numbers of the parts, by the first given faces: the highest number for those without any.
  template <typename PartOf>
  std::pair<Partition, std::vector<Index>>
  of_given(const Surface& given, std::size_t number_of_parts, const PartOf& part_of) const
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    Partition::Numbers result;
    std::vector<Index> numbers(number_of_parts, none);
    result.reserve(given.number_of_faces());
    Index number = 0;
    for (std::size_t f = 0; f < given.number_of_faces(); ++f) {
      Index& n = numbers[part_of(face(f))];
      if (n == none)
        n = number++;
      result.push_back(n);
    }
    return {Partition(std::move(result), number), std::move(numbers)};
  }

  /// The same for a partition of the faces.
  std::pair<Partition, std::vector<Index>> of_given(const Surface& given,
                                                    const Partition& faces) const
  {
    return of_given(given, faces.number_of_parts(), [&](Index f) { return faces[f]; });
  }

  /// The number of a given face.
  Index face(std::size_t given) const { return m_faces.empty() ? Index(given) : m_faces[given]; }

private:
  using Adjacency = std::pair<Index, Index>; // its lower face; its number in the given surface

  /// Of the grid in the unit of the frame: 2^28, and more where that is large for the area, as of a
  /// surface with a part far away.
  double steps_of_grid(const Surface& given) const
  {
    constexpr int finest = -22;
    const int size = std::ilogb(given.length_unit() / m_frame.unit());
    return std::ldexp(1, 28 - (std::max)(finest, (std::min)(size, 0)));
  }

  /// Sums of some of them are exact.
  static Double_3 on_grid(const Double_3& p, double steps)
  {
    const auto round = [=](double x) { return std::floor(x * steps + 0.5) / steps; };
    return {round(p.x), round(p.y), round(p.z)};
  }

  /// By the positions of the means of their corners; those of crumbs last.
  void number_faces(const Surface& given, const std::vector<Index>& originals,
                    const Large_array<Double_3>& points)
  {
    std::vector<Index> faces;
    std::vector<double> positions;
    for (Index f = 0; f < originals.size(); ++f)
      if (originals[f] == f) {
        const double x = position(mean_of_corners(arrays_of(given), points, f)); // sums are exact
        faces.push_back(f);
        positions.push_back(given.is_crumb(f) ? 2 + x / (1 + std::fabs(x)) : x);
      }
    const std::vector<Index> new_numbers = numbers(positions);
    m_faces.resize(originals.size());
    arrays_of(m_surface.emplace()).input_faces.resize(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      m_faces[faces[i]] = new_numbers[i];
      arrays_of(*m_surface).input_faces[new_numbers[i]] = faces[i];
    }
    for (std::size_t f = 0; f < originals.size(); ++f)
      m_faces[f] = m_faces[originals[f]];
  }

  /// Along the generic direction: in [0, 1), but for crumbs.
  static double position(const Double_3& point)
  {
    constexpr double bound = 2.5;
    return 0.5 + dot(point, Intrinsic_frame::direction) / (2 * bound);
  }

  /// The numbers of things in the order of their positions. In slices of these, each sorted: sorted
  /// at once, the surface of 20,000 faces takes 1.2 times as long.
  static std::vector<Index> numbers(const std::vector<double>& positions)
  {
    using Item = std::pair<double, Index>;
    const std::size_t size = positions.size();
    Grouped_items<Item> slices(size, [&](const auto& add) {
      constexpr double last = 0.999999;
      for (Index i = 0; i < size; ++i) {
        const double x = (std::max)(0.0, (std::min)(positions[i], last));
        add(std::size_t(x * double(size)), Item{positions[i], i});
      }
    });
    sort_groups(slices);
    std::vector<Index> result(size);
    Index number = 0;
    for (const Item& item : slices.all())
      result[item.second] = number++;
    return result;
  }

  template <typename Item>
  static void sort_groups(Grouped_items<Item>& items)
  {
    for (std::size_t group = 0; group < items.number_of_groups(); ++group)
      if (const auto range = items[group]; range.size() > 1)
        std::sort(range.begin(), range.end());
  }

  void set_corners(const Surface& given, const Large_array<Double_3>& points,
                   Surface_arrays& arrays)
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    std::vector<Index> vertices, number_of(points.size(), none);
    std::vector<double> positions;
    for (const Index f : arrays.input_faces)
      for_each_side(given, f, [&](Index v, Index) {
        if (std::exchange(number_of[v], 0) == none) {
          vertices.push_back(v);
          positions.push_back(position(points[v]));
        }
      });
    const std::vector<Index> new_numbers = numbers(positions);
    arrays.points.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      number_of[vertices[i]] = new_numbers[i];
      arrays.points[new_numbers[i]] = points[vertices[i]];
    }
    arrays.corners.reserve(arrays_of(given).corners.size());
    arrays.first_corners.reserve(arrays.input_faces.size() + 1);
    arrays.first_corners.push_back(0);
    for (const Index f : arrays.input_faces) {
      for_each_side(given, f, [&](Index v, Index) { arrays.corners.push_back(number_of[v]); });
      const auto first = arrays.corners.begin() + arrays.first_corners.back(),
                 end = arrays.corners.end();
      std::rotate(first, std::min_element(first, end), end);
      arrays.first_corners.push_back(Index(arrays.corners.size()));
    }
  }

  /// Faces that are degenerate remain so.
  void set_faces(const Surface& given)
  {
    const double unit = m_frame.unit();
    Surface_arrays& arrays = arrays_of(*m_surface);
    compute_normals(*m_surface, Execution());
    for (std::size_t i = 0; i < arrays.input_faces.size(); ++i) {
      const Index f = arrays.input_faces[i];
      if (given.is_degenerate(f)) {
        arrays.normals[i] = {0, 0, 0};
        arrays.areas[i] = float(given.area(f) / unit / unit);
      }
      if (given.is_crumb(f)) {
        arrays.is_crumb.resize(arrays.input_faces.size());
        arrays.is_crumb[i] = true;
      }
    }
    sum_up(*m_surface);
  }

  /// Those of the given surface, by their new higher, then lower faces; without those between faces
  /// that are one.
  Grouped_items<Adjacency> sorted_adjacencies(const Surface& given) const
  {
    Grouped_items<Adjacency> by_higher(m_surface->number_of_faces(), [&](const auto& add) {
      for (std::size_t a = 0; a < given.number_of_adjacencies(); ++a)
        if (const Index f = m_faces[given.lower_face(a)], g = m_faces[given.higher_face(a)];
            f != g && (m_is_left_out.empty() || !m_is_left_out[a]))
          add((std::max)(f, g), Adjacency{(std::min)(f, g), Index(a)});
    });
    sort_groups(by_higher);
    return by_higher;
  }

  void set_adjacencies(const Surface& given)
  {
    const double unit = m_frame.unit();
    Surface_arrays& arrays = arrays_of(*m_surface);
    const Grouped_items<Adjacency> adjacencies = sorted_adjacencies(given);
    resize_adjacencies(arrays, adjacencies.all().size());
    std::size_t a = 0;
    for (Index higher = 0; higher < adjacencies.number_of_groups(); ++higher)
      for (const auto& [lower, g] : adjacencies[higher]) {
        const auto [direction, number] = common_edges(*m_surface, lower, higher);
        const std::uint8_t flags = given.flags(g);
        arrays.lower_faces[a] = lower;
        arrays.higher_faces[a] = higher;
        arrays.squared_lengths[a] = number == 1 && !(flags & (Surface::SEAM | Surface::LINK))
                                      ? squared_norm(direction)
                                      : float(given.squared_length(g) / unit / unit);
        arrays.flags[a++] = given.has_angle(g) && number > 0
                              ? with_sign(flags, sign_of_edge(m_surface->normal(higher),
                                                              m_surface->normal(lower), direction))
                              : flags;
      }
    join_degenerate_faces(*m_surface);
  }

  Intrinsic_frame m_frame;
  std::optional<Surface> m_surface; // none: the given one
  std::vector<bool> m_is_left_out;  // by given adjacency; empty: none is
  std::vector<Index> m_faces;       // by given face: its number; empty: the same. Those that
                                    // are one have one
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_SURFACE_H
