// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The mean distance of the midpoints of the sides of a face from a surface: how much the face
/// deviates from it.
inline double deviation_of_face(const Surface& surface, const Fitted_surface<>& s,
                                Surface::Index face)
{
  const Surface_distance distance(s);
  double sum = 0;
  for_each_side(surface, face, [&](Surface::Index v, Surface::Index w) {
    sum += std::fabs(distance(0.5 * (surface.point(v) + surface.point(w))));
  });
  return sum / double(surface.number_of_corners(face));
}

/// The largest deviation of the faces of the mesh on a surface, of which some are known. Those of
/// one tessellation deviate alike, but a cap, or the flat of a shaft, deviates more though its
/// vertices lie on the surface.
inline double largest_deviation(const Tessellation& mesh, const Fitted_surface<>& s,
                                const std::vector<Surface::Index>& faces)
{
  // Of the radius: 1 - cos of 8 degrees; what half a facet of 46 by 46 degrees deviates on average.
  constexpr double much = 10, least = 0.01, most = 0.105;
  std::vector<double> deviations;
  for (const Surface::Index f : faces)
    deviations.push_back(deviation_of_face(mesh.surface, s, f));
  const auto upper = deviations.begin() + std::ptrdiff_t(deviations.size() * 3 / 4);
  std::nth_element(deviations.begin(), upper, deviations.end());
  const double radius = s.radius + s.minor_radius,
               typical = (std::max)({much * *upper, least * radius, mesh.tolerance()});
  return s.kind == Surface_kind::SPHERE ? (std::min)(typical, most * radius) : typical;
}

/// Grows a face of the part over all faces that lie on its surface: their vertices are within the
/// prediction interval of its fit. Fits the surface again whenever the face has doubled, and at the
/// end: then those that did not lie on the former surface are tested again.
class Face_grower
{
public:
  using Index = Surface::Index;

  explicit Face_grower(const Tessellation& mesh)
    : m_mesh(mesh)
    , m_taken(mesh.surface)
    , m_visited(mesh.surface.number_of_faces())
  {}

  /// From those of the faces of a patch that lie on `s`, over faces that `is_free(face)`. Improves
  /// `s`. At the end all vertices are within the tolerance.
  /// \pre `s` is fitted to the patch
  template <typename IsFree>
  void grow(Fitted_surface<>& s, const Face_set& patch, const IsFree& is_free)
  {
    constexpr int most_rounds = 6;
    m_taken.clear();
    m_visited.clear();
    m_largest_deviation = largest_deviation(m_mesh, s, patch.faces());
    predict(s, patch.points());
    std::vector<Index> untested = patch.faces();
    for (const Index f : untested)
      m_visited.mark(f);
    std::size_t next = 0, next_fit = 2 * patch.points().size();
    for (int round = 0; round < most_rounds; ++round) {
      m_rejected.clear();
      const std::size_t before = faces().size();
      for (const Index f : untested)
        take_if_on(s, f);
      for (; next < faces().size(); ++next) {
        if (points().size() >= next_fit) {
          fit(s);
          next_fit = 2 * points().size();
        }
        for_each_neighbor(m_mesh.surface, faces()[next], [&](Index other, Index, Index) {
          if (!m_visited.has(other) && is_free(other) && m_mesh.is_smooth(faces()[next], other) &&
              m_visited.mark(other))
            take_if_on(s, other);
        });
      }
      if (faces().size() == before)
        break;
      fit(s);
      untested.swap(m_rejected);
    }
    drop_distant_faces(s);
  }

  const std::vector<Index>& faces() const { return m_taken.faces(); }
  bool is_taken(Index face) const { return m_taken.has(face); }
  const std::vector<Double_3>& points() const { return m_taken.points(); }

private:
  void take_if_on(const Fitted_surface<>& s, Index face)
  {
    bool is_on = m_mesh.has_normal_of(s, face);
    for (const Index v : m_mesh.surface.corners(face))
      is_on = is_on && (*m_predicts)(m_mesh.surface.point(v));
    if (is_on && deviation_of_face(m_mesh.surface, s, face) <= m_largest_deviation)
      m_taken.add(face);
    else
      m_rejected.push_back(face);
  }

  void predict(const Fitted_surface<>& s, const std::vector<Double_3>& points)
  {
    const std::vector<Double_3> sample = evenly_spread(points, most_fitted_points);
    m_predicts.emplace(s, Surface_fitter(sample, 0), m_mesh.tolerance());
  }

  void fit(Fitted_surface<>& s)
  {
    if (int(points().size()) < degrees_of_freedom(s.kind))
      return;
    const std::vector<Double_3> sample = evenly_spread(points(), most_fitted_points);
    const Surface_fitter fitter(sample, m_mesh.good_fit());
    Fitted_surface<> better = s;
    const double allowed = (std::max)(2 * m_mesh.sigma, 1.2 * fitter.root_mean_square(s));
    if (fitter(better, few_iterations) <= allowed)
      s = better;
    m_predicts.emplace(s, fitter, m_mesh.tolerance());
  }

  void drop_distant_faces(const Fitted_surface<>& s)
  {
    if (largest_distance(s, points()) <= m_mesh.tolerance())
      return;
    const std::vector<Index> all = faces();
    m_taken.clear();
    for (const Index f : all)
      if (m_mesh.has_vertices_on(s, f))
        m_taken.add(f);
  }

  const Tessellation& m_mesh;
  Face_set m_taken;
  Element_marks m_visited;
  std::vector<Index> m_rejected;
  std::optional<Surface_prediction> m_predicts;
  double m_largest_deviation = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H
