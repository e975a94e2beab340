// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_neighbors.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What the phases of finding faces share: the tolerance, and the faces found so far, by their
/// labels, with their surfaces.
class Face_search
{
public:
  using Index = Surface::Index;
  static constexpr Index none = Index(-1);

  const Surface& surface;
  const bool is_exact; ///< whether vertices lie on their surfaces, to rounding
  const Face_neighbors neighbors;
  Face_set patch; ///< some faces around a face
  const Face_test test;
  Face_grower grower;
  std::vector<Index> labels;              ///< by face of the mesh; none: not found yet
  std::vector<Fitted_surface<>> surfaces; ///< by label
  std::vector<std::uint8_t> is_tried;     ///< by face of the mesh: no seed in this phase
  std::vector<std::uint8_t> is_on_found;  ///< by vertex: a face that is found has it
  Element_marks is_tried_whole;           ///< faces: see `find_whole_beside()`

  /// \param resolution of the coordinates
  Face_search(const Surface& s, double tolerance, double resolution)
    : surface(s)
    , is_exact(tolerance <= 20 * (std::max)(1e-6 * s.length_unit(), resolution))
    , neighbors(s, resolution)
    , patch(s)
    , test(s, neighbors, tolerance)
    , grower(s, neighbors, test, !is_exact, (std::max)(1e-3 * tolerance, 0.3 * resolution))
    , labels(s.number_of_faces(), none)
    , is_on_found(s.number_of_vertices(), 0)
    , is_tried_whole(s.number_of_faces())
    , m_resolution(resolution)
  {}

  /// The root mean square distance below which a fit is good enough.
  double goal() const
  {
    return is_exact ? (std::max)(1e-2 * test.tolerance(), 0.3 * m_resolution)
                    : 0.1 * test.tolerance();
  }

  bool is_found(Index face) const { return labels[face] != none; }
  const Fitted_surface<>& surface_of(Index face) const { return surfaces[labels[face]]; }

  /// Adds a face of the part that was just grown.
  void add(const Fitted_surface<>& s, const std::vector<Index>& faces)
  {
    const Index label = Index(surfaces.size());
    surfaces.push_back(s);
    m_largest_deviations.push_back(grower.largest_deviation());
    for (const Index f : faces) {
      labels[f] = label;
      for (const Index v : surface.corners(f))
        is_on_found[v] = 1;
    }
  }

  /// Whether a facet deviates much more from a surface that is found than the facets of its face.
  bool is_flat(Index label, Index face) const
  {
    return test.deviation_of_facet(surfaces[label], face) > m_largest_deviations[label];
  }

  /// The number of vertices of some faces that no face that is found has.
  std::size_t number_of_new_vertices(const std::vector<Index>& faces) const
  {
    std::vector<Index> vertices;
    for (const Index f : faces)
      for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
        if (!is_on_found[surface.corner(f, i)])
          vertices.push_back(surface.corner(f, i));
    std::sort(vertices.begin(), vertices.end());
    return std::size_t(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  }

  /// Faces that are not found and have no other host, the largest first: so what is found does not
  /// depend on their order.
  std::vector<Index> seeds() const
  {
    std::vector<Index> result;
    for (Index f = 0; f < labels.size(); ++f)
      if (!is_found(f) && neighbors.host(f) == f)
        result.push_back(f);
    std::stable_sort(result.begin(), result.end(),
                     [&](Index a, Index b) { return surface.area(a) > surface.area(b); });
    return result;
  }

  /// Starts a phase.
  void clear_tried() { is_tried.assign(labels.size(), 0); }

private:
  double m_resolution;
  std::vector<double> m_largest_deviations; // by label
};

/// The share of the border of the faces that were grown where the surface goes on, as facets of a
/// freeform face do, to faces that are not found, and not much smaller than several faces.
inline double share_of_smooth_border(const Face_search& search)
{
  constexpr double least_cosine = 0.94; // 20 degrees
  const bool is_single = search.grower.faces().size() == 1;
  return search.grower.share_of_border([&](Surface::Index, const Face_neighbors::Neighbor& n) {
    return !search.is_found(n.face) && search.neighbors.cosine(n.adjacency) > least_cosine &&
           (is_single || search.surface.area(n.face) > 0.2 * search.grower.area());
  });
}

/// The components of the faces that are not found, of which two are connected where they go on
/// smoothly.
inline Partition smooth_components_left(const Face_search& search, const Execution& execution)
{
  return label_components(
    search.surface,
    [&](std::size_t a) {
      const auto is_left = [&](std::size_t face) {
        return !search.is_found(search.neighbors.host(face));
      };
      return !search.surface.has_flag(a, Surface::barrier) &&
             is_left(search.surface.lower_face(a)) && is_left(search.surface.higher_face(a)) &&
             search.neighbors.is_smooth(a);
    },
    execution);
}

/// By label: whether it is of a curved surface, and no vertex is inside its face.
inline std::vector<std::uint8_t> single_rows(const Face_search& search)
{
  using Index = Surface::Index;
  std::vector<std::uint8_t> result(search.surfaces.size());
  for (std::size_t label = 0; label < result.size(); ++label)
    result[label] = search.surfaces[label].kind != Surface_kind::PLANE;
  for (Index v = 0; v < search.surface.number_of_vertices(); ++v) {
    const auto around = search.neighbors.around(v);
    const Index label = around.empty() ? Face_search::none : search.labels[*around.begin()];
    if (label != Face_search::none && std::all_of(around.begin(), around.end(), [&](Index f) {
          return search.labels[f] == label;
        }))
      result[label] = 0;
  }
  return result;
}

/// Which labels of `among` go on smoothly, at .6 of their border, to faces that are not found,
/// or, by less than 11 degrees, to labels of `uncertain`.
inline std::vector<std::uint8_t> surrounded(const Face_search& search,
                                            const std::vector<std::uint8_t>& among,
                                            const std::vector<std::uint8_t>& uncertain)
{
  constexpr double most = 0.6, cosine = 0.98;
  std::vector<double> smooth(among.size(), 0), all(among.size(), 0);
  for (Surface::Index f = 0; f < search.labels.size(); ++f)
    if (search.is_found(f) && among[search.labels[f]])
      for (const Face_neighbors::Neighbor& n : search.neighbors[f])
        if (search.labels[n.face] != search.labels[f]) {
          const double length = search.surface.length(n.adjacency);
          all[search.labels[f]] += length;
          if (search.is_found(n.face)
                ? uncertain[search.labels[n.face]] && search.neighbors.cosine(n.adjacency) > cosine
                : search.neighbors.is_smooth(n.adjacency))
            smooth[search.labels[f]] += length;
        }
  std::vector<std::uint8_t> result(among.size());
  for (std::size_t label = 0; label < result.size(); ++label)
    result[label] = among[label] && smooth[label] > most * all[label];
  return result;
}

/// Of a freeform face, single rows of facets may lie on cylinders, cones and more. Drops the
/// surfaces of those between others, or beside what is not found. Returns whether there were some.
inline bool drop_uncertain_surfaces(Face_search& search)
{
  const std::vector<std::uint8_t> rows = single_rows(search),
                                  between = surrounded(search, rows, rows),
                                  dropped = surrounded(search, between, between);
  bool some = false;
  for (Surface::Index& label : search.labels)
    if (label != Face_search::none && dropped[label]) {
      label = Face_search::none;
      some = true;
    }
  return some;
}

/// Gives thin faces the label, of those of their hosts and of the faces beside them, on whose
/// surface their vertices lie best.
inline void label_thin_faces(Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  const Face_neighbors& neighbors = search.neighbors;
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    if (neighbors.host(f) == f)
      continue;
    double least = std::numeric_limits<double>::infinity();
    const auto try_label = [&](Index label) {
      if (label == Face_search::none)
        return;
      const Surface_distance distance(search.surfaces[label]);
      double largest = 0;
      for (const Index v : surface.corners(f))
        largest = (std::max)(largest, std::fabs(distance(surface.point(v))));
      if (largest < least - 1e-3 * search.test.tolerance()) {
        least = largest;
        search.labels[f] = label;
      }
    };
    try_label(search.labels[neighbors.host(f)]);
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
      if (const Index across = neighbors.across(f, i); across != Surface::none)
        try_label(search.labels[across]);
  }
}

/// Makes each connected component of a label a face of its own, and those of what was not found
/// freeform faces, which end where the mesh does not go on smoothly.
inline void separate_components(Face_search& search, const Execution& execution)
{
  const Surface& surface = search.surface;
  const Face_neighbors& neighbors = search.neighbors;
  label_thin_faces(search);
  const Partition components = label_components(
    surface,
    [&](std::size_t a) {
      const Surface::Index f = surface.lower_face(a), g = surface.higher_face(a),
                           label = search.labels[f];
      if (label == search.labels[g] && neighbors.host(f) == neighbors.host(g))
        return true;
      return label == search.labels[g] && !surface.has_flag(a, Surface::barrier) &&
             (label != Face_search::none || neighbors.is_smooth(a));
    },
    execution);
  std::vector<Fitted_surface<>> surfaces(components.number_of_parts());
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (search.is_found(f))
      surfaces[components[f]] = search.surface_of(f);
  search.labels.assign(components.begin(), components.end());
  search.surfaces = std::move(surfaces);
}

/// The label of the surface, of those of a face and its neighbors, from which the face deviates
/// least.
inline Surface::Index nearest_label(const Face_search& search, Surface::Index face)
{
  const Surface::Index own = search.labels[face];
  const auto neighbors = search.neighbors[face];
  if (std::all_of(neighbors.begin(), neighbors.end(),
                  [&](const auto& n) { return search.labels[n.face] == own; }))
    return own;
  Surface::Index best = own;
  double least = own == Face_search::none ? std::numeric_limits<double>::infinity()
                                          : search.test.deviation(search.surfaces[own], face);
  for (const Face_neighbors::Neighbor& n : neighbors) {
    const Surface::Index label = search.labels[n.face];
    if (label == Face_search::none || label == own || label == best ||
        !search.test(search.surfaces[label], face))
      continue;
    const double deviation = search.test.deviation(search.surfaces[label], face);
    if (deviation < 0.9 * least - 1e-3 * search.test.tolerance()) {
      least = deviation;
      best = label;
    }
  }
  return best;
}

/// Faces at borders go to the neighboring surface from which they deviate least.
inline void compete_at_borders(Face_search& search)
{
  constexpr int rounds = 4;
  bool is_changed = true;
  for (int round = 0; round < rounds && is_changed; ++round) {
    is_changed = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f) {
      const Surface::Index best = nearest_label(search, f);
      is_changed = is_changed || best != search.labels[f];
      search.labels[f] = best;
    }
  }
}

/// Whether a face of which all vertices are on faces that are found can have the label of one of
/// them: its vertices lie on that surface, and its normal is that of the surface within some 53
/// degrees, as long triangles across a fillet may have it; with a tolerance above rounding always.
inline bool may_join(const Face_search& search, Surface::Index face, Surface::Index label)
{
  constexpr double least_cosine = 0.6;
  const Fitted_surface<>& s = search.surfaces[label];
  return !search.is_exact ||
         (search.test.has_vertices_on(s, face) &&
          search.test.has_normal_of(s, face, least_cosine) && !search.is_flat(label, face));
}

/// Faces of which all vertices are on faces that are found go to that neighbor from whose surface
/// they deviate least, beginning with those that have such a neighbor. Where a mesh does not follow
/// the creases, as after remeshing, faces cross them.
inline void join_remaining_faces(Face_search& search)
{
  using Index = Surface::Index;
  std::vector<Index> left;
  for (Index f = 0; f < search.labels.size(); ++f) {
    bool remains = !search.is_found(f);
    for (std::size_t i = 0; i < search.surface.number_of_corners(f); ++i)
      remains = remains && search.is_on_found[search.surface.corner(f, i)];
    if (remains)
      left.push_back(f);
  }
  std::vector<std::pair<Index, Index>> joined; // faces and their labels
  do {
    joined.clear();
    for (const Index f : left) {
      double least = std::numeric_limits<double>::infinity();
      Index best = Face_search::none;
      if (!search.is_found(f))
        for (const Face_neighbors::Neighbor& n : search.neighbors[f])
          if (search.is_found(n.face) && may_join(search, f, search.labels[n.face])) {
            const double deviation = search.test.deviation(search.surface_of(n.face), f);
            if (deviation < least) {
              least = deviation;
              best = search.labels[n.face];
            }
          }
      if (best != Face_search::none)
        joined.push_back({f, best});
    }
    for (const auto& [face, label] : joined)
      search.labels[face] = label;
  } while (!joined.empty());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H
