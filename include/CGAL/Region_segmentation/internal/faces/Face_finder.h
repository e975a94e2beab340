// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_FINDER_H

#include <CGAL/Region_segmentation/internal/faces/Face_grower.h>
#include <CGAL/Region_segmentation/internal/faces/propose_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

struct Part_options
{
  /// The largest distance of a vertex to the surface of its face; 0: found from the mesh.
  double tolerance = 0;
};

namespace internal {

/// Finds the faces of a machine part: grows surfaces that fit patches, then planes of few vertices; merges and lets compete;
/// what is left is freeform.
class Face_finder
{
public:
  using Index = Surface::Index;
  static constexpr Index none = Index(-1);

  Face_finder(const Surface& surface, const Part_options& options)
    : m_surface(surface), m_neighbors(surface), m_patch(surface, m_neighbors)
    , m_noise(options.tolerance > 0 ? options.tolerance / 5 : estimated_noise())
    , m_test(surface, m_neighbors, (std::max)(5 * m_noise, exact_tolerance()))
    , m_grower(surface, m_neighbors, m_test), m_labels(surface.number_of_faces(), none)
    , m_is_tried(surface.number_of_faces(), 0)
  {}

  double tolerance() const { return m_test.tolerance(); }
  const std::vector<Index>& labels() const { return m_labels; }
  const Fitted_surface& surface_of_label(Index label) const { return m_found[label]; }

  void find()
  {
    const bool exact = m_test.tolerance() < 2e-5 * m_surface.length_unit();
    if (exact) {
      find_from_patches(24, 0, exact);
      find_from_patches(12, 0, exact);
      find_from_patches(8, 0.5, exact);
    } else {
      for (const std::size_t wanted : {80, 40, 20})
        find_from_patches(wanted, 0, exact);
    }
    find_planes();
    merge_equal_surfaces();
    compete();
    join_freeform();
    join_tori_to_freeform();
  }

private:
  static constexpr double smooth_cosine = 0.766; // 40 degrees
  static constexpr Surface_kind kinds[] = {Surface_kind::PLANE, Surface_kind::CYLINDER, Surface_kind::CONE, Surface_kind::SPHERE,
                                           Surface_kind::TORUS};

  bool is_smooth(Index face, const Face_neighbors::Neighbor& n) const
  {
    return m_surface.cosine(n.adjacency) > smooth_cosine || m_neighbors.is_thin(face) || m_neighbors.is_thin(n.face);
  }

  Double_3 mean_normal(const std::vector<Index>& faces) const
  {
    Double_3 sum{0, 0, 0};
    for (const Index f : faces)
      sum = sum + m_surface.area(f) * m_surface.normal(f);
    const double length = norm(sum);
    return length > 0 ? (1 / length) * sum : Double_3{0, 0, 1};
  }

  /// The direction to which the normals of faces are most orthogonal.
  Double_3 axis_of_normals(const std::vector<Index>& faces) const
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Index f : faces) {
      const Double_3& n = m_surface.normal(f);
      const Eigen::Vector3d v(n.x, n.y, n.z);
      sum += m_surface.area(f) * v * v.transpose();
    }
    const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
    return {axis[0], axis[1], axis[2]};
  }

  /// The share of the area of faces that have a coplanar neighbor, to rounding: there is none if vertices are noisy.
  double share_of_plane_area() const
  {
    double plane = 0;
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      for (const Face_neighbors::Neighbor& n : m_neighbors[f])
        if (!m_neighbors.is_thin(f) && !m_neighbors.is_thin(n.face) && m_surface.cosine(n.adjacency) > 0.9
            && height(n.face, f) <= exact_tolerance()) {
          plane += m_surface.area(f);
          break;
        }
    return plane / m_surface.area();
  }

  double exact_tolerance() const { return 1e-6 * m_surface.length_unit(); }

  /// The largest distance of a corner of a face to the plane of another.
  double height(Index face, Index of_plane) const
  {
    const Double_3 point = m_surface.point(m_surface.corner(of_plane, 0));
    double largest = 0;
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      largest = (std::max)(largest, std::fabs(dot(m_surface.normal(of_plane),
                                                  m_surface.point(m_surface.corner(face, i)) - point)));
    return largest;
  }

  /// The standard deviation of vertices from the surfaces on which they lie. Freeform faces and patches across borders fit no
  /// surface, so this is a low quantile over patches that are spread evenly over the area.
  double estimated_noise()
  {
    if (share_of_plane_area() > 0.05)
      return 0;
    constexpr int samples = 300;
    const double size = m_surface.length_unit(), step = m_surface.area() / samples;
    std::vector<double> errors;
    double next = step / 2, sum = 0;
    for (Index f = 0; f < m_surface.number_of_faces(); ++f) {
      sum += m_surface.area(f);
      if (sum < next)
        continue;
      const double weight = std::ceil((sum - next) / step);
      next += weight * step;
      const double error = error_of_patch(f);
      errors.insert(errors.end(), error < size ? std::size_t(weight) : 0, error);
    }
    if (errors.empty())
      return 0;
    std::sort(errors.begin(), errors.end());
    return (std::min)(1.4 * errors[errors.size() / 16], 2e-3 * size);
  }

  /// The standard deviation of the points around a face from the surface that fits them best; infinite if there are too few.
  double error_of_patch(Index seed)
  {
    const double size = m_surface.length_unit();
    double least = 1e300;
    if (m_neighbors.is_thin(seed))
      return least;
    m_patch.collect(seed, 24, [&](Index f, const Face_neighbors::Neighbor& n) { return is_smooth(f, n); });
    const std::vector<Double_3>& points = m_patch.points();
    if (points.size() < 8)
      return least;
    const Surface_proposer propose(points, m_surface.centroid(seed), m_surface.normal(seed), Double_3{0, 0, 0}, 1e-9 * size);
    Fitted_surface s;
    for (const Surface_kind kind : kinds) {
      const int redundant = int(points.size()) - degrees_of_freedom(kind);
      if (least > 1e-7 * size && redundant > 4)
        least = (std::min)(least, propose(kind, s) * std::sqrt(double(points.size()) / double(redundant)));
    }
    return least;
  }

  /// Seeds patches at faces that are not taken. `least_length`: of the edges that a patch crosses, as a multiple of the longest one
  /// of the seed; so patches stay on narrow strips of long triangles.
  void find_from_patches(std::size_t wanted, double least_length, bool exact)
  {
    std::fill(m_is_tried.begin(), m_is_tried.end(), 0);
    for (Index seed = 0; seed < m_labels.size(); ++seed)
      if (m_labels[seed] == none && !m_is_tried[seed] && !m_neighbors.is_thin(seed)) {
        const double shortest = least_length * longest_edge(seed);
        m_patch.collect(seed, wanted, [&](Index f, const Face_neighbors::Neighbor& n) {
          return m_labels[n.face] == none && m_surface.length(n.adjacency) >= shortest && is_smooth(f, n)
                 && m_surface.area(n.face) < 8 * m_surface.area(seed);
        });
        if (!try_patch(seed, exact))
          for (std::size_t i = 0; i < (std::max)(m_patch.faces().size() / (wanted > 12 ? 4 : 2), std::size_t(1)); ++i)
            m_is_tried[m_patch.faces()[i]] = 1;
      }
  }

  double longest_edge(Index face) const
  {
    double longest = 0;
    for (const Face_neighbors::Neighbor& n : m_neighbors[face])
      longest = (std::max)(longest, m_surface.length(n.adjacency));
    return longest;
  }

  bool try_patch(Index seed, bool exact)
  {
    const double tolerance = m_test.tolerance();
    const std::vector<Double_3>& points = m_patch.points();
    const Surface_proposer propose(points, m_surface.centroid(seed), mean_normal(m_patch.faces()), axis_of_normals(m_patch.faces()),
                                    exact ? 1e-2 * tolerance : 0.5 * m_noise);
    Fitted_surface best;
    std::vector<Index> best_faces;
    double best_area = 0;
    for (const Surface_kind kind : kinds) {
      Fitted_surface s;
      if (propose(kind, s) > tolerance || largest_distance(s, points) > tolerance)
        continue;
      orient(s, seed);
      m_grower.grow(s, m_patch.faces(), [&](Index f) { return m_labels[f] == none; });
      if (!is_face(s, exact)) {
        mark_as_tried_if_many();
        continue;
      }
      if (m_grower.area() > 1.1 * best_area) {
        best = s;
        best_area = m_grower.area();
        best_faces = m_grower.faces();
      }
      if (exact)
        break;
    }
    if (best_area == 0)
      return false;
    accept(best, best_faces);
    return true;
  }

  /// Whether what was grown is a face, and not only osculated or crossed by its surface.
  bool is_face(const Fitted_surface& s, bool exact) const
  {
    const std::size_t points = m_grower.points().size();
    if (int(points) < degrees_of_freedom(s.kind) + 2 || m_grower.faces().size() < m_patch.faces().size() * 3 / 4)
      return false;
    if (s.kind == Surface_kind::PLANE ? points < 8 : is_chain_of_planes())
      return false;
    return !(exact && m_grower.gradual_border(s) > 0.1);
  }

  /// Seeds in a large set of faces that was grown in vain would grow it again: so the time of all growing stays near linear.
  void mark_as_tried_if_many()
  {
    if (m_grower.faces().size() > 4 * m_patch.faces().size())
      for (const Index f : m_grower.faces())
        m_is_tried[f] = 1;
  }

  /// Whether the faces are two or three planes of several triangles, such as chamfers, rather than facets of a curved face; or mostly
  /// one plane, with the first facets of the fillets beside it.
  bool is_chain_of_planes() const
  {
    if (m_grower.share_of_largest_facet() > 0.6)
      return true;
    const std::size_t facets = m_grower.number_of_facets();
    return facets <= 3 && m_grower.faces().size() > 2 * facets && !m_grower.is_tangent_to_neighbors(smooth_cosine);
  }

  void orient(Fitted_surface& s, Index seed) const
  {
    s.side = 1;
    if (dot(surface_normal(s, m_surface.centroid(seed)), m_surface.normal(seed)) < 0) {
      if (s.kind == Surface_kind::PLANE)
        s.direction = -1.0 * s.direction;
      else
        s.side = -1;
    }
  }

  void accept(const Fitted_surface& s, const std::vector<Index>& faces)
  {
    for (const Index f : faces)
      m_labels[f] = Index(m_found.size());
    m_found.push_back(s);
    m_found.back().deviation = 0;
  }

  /// Plane faces of few vertices: those whose perimeter is mostly not smooth, or meets faces that are found.
  void find_planes()
  {
    std::fill(m_is_tried.begin(), m_is_tried.end(), 0);
    std::vector<Index> order;
    for (Index f = 0; f < m_labels.size(); ++f)
      if (m_labels[f] == none && !m_neighbors.is_thin(f))
        order.push_back(f);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return m_surface.area(a) > m_surface.area(b); });
    for (const Index seed : order) {
      if (m_labels[seed] != none || m_is_tried[seed])
        continue;
      Fitted_surface s = surface_of_kind(Surface_kind::PLANE, m_surface.centroid(seed), m_surface.normal(seed));
      m_grower.grow(s, {seed}, [&](Index f) { return m_labels[f] == none; });
      if (m_grower.faces().empty())
        continue;
      if (share_of_smooth_border(m_grower.faces()) < (m_grower.points().size() < 8 ? 0.1 : 0.5))
        accept(s, m_grower.faces());
      else
        for (const Index f : m_grower.faces())
          m_is_tried[f] = 1;
    }
  }

  double share_of_smooth_border(const std::vector<Index>& faces)
  {
    std::vector<Index> sorted = faces;
    std::sort(sorted.begin(), sorted.end());
    double smooth = 0, all = 0;
    for (const Index f : faces)
      for (const Face_neighbors::Neighbor& n : m_neighbors[f])
        if (!std::binary_search(sorted.begin(), sorted.end(), n.face)) {
          const double length = m_surface.length(n.adjacency);
          all += length;
          if (m_labels[n.face] == none && is_smooth(f, n) && m_surface.area(n.face) > 0.2 * m_grower.area())
            smooth += length;
        }
    return all > 0 ? smooth / all : 0;
  }

  /// Merges neighbors of which one's surface is also that of the other.
  void merge_equal_surfaces()
  {
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a) {
      const Index i = m_labels[m_surface.lower_face(a)], j = m_labels[m_surface.higher_face(a)];
      if (i != j && i != none && j != none && m_surface.cosine(a) > smooth_cosine)
        pairs.push_back({(std::min)(i, j), (std::max)(i, j)});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<std::vector<Index>> faces(m_found.size());
    for (Index f = 0; f < m_labels.size(); ++f)
      if (m_labels[f] != none)
        faces[m_labels[f]].push_back(f);
    std::vector<Index> now(m_found.size());
    for (Index i = 0; i < now.size(); ++i)
      now[i] = i;
    const auto current = [&](Index i) {
      while (now[i] != i)
        i = now[i];
      return i;
    };
    for (const auto& pair : pairs) {
      Index i = current(pair.first), j = current(pair.second);
      if (i == j)
        continue;
      if (degrees_of_freedom(m_found[j].kind) < degrees_of_freedom(m_found[i].kind))
        std::swap(i, j);
      // Tori that are nearly equal osculate one fillet along a line that is nearly an arc.
      const bool alike = m_found[i].kind == m_found[j].kind && m_found[i].kind == Surface_kind::TORUS;
      const Face_test test(m_surface, m_neighbors, (alike ? 30 : 1) * m_test.tolerance());
      if (!has_all(test, m_found[i], faces[j])) {
        std::swap(i, j);
        if (!has_all(test, m_found[i], faces[j]))
          continue;
      }
      now[j] = i;
      faces[i].insert(faces[i].end(), faces[j].begin(), faces[j].end());
      faces[j].clear();
    }
    for (Index& label : m_labels)
      if (label != none)
        label = current(label);
  }

  static bool has_all(const Face_test& test, const Fitted_surface& s, const std::vector<Index>& faces)
  {
    return std::all_of(faces.begin(), faces.end(), [&](Index f) { return test(s, f); });
  }

  /// Whether an edge between freeform faces is a crease: its deviation stands out among those of the edges near it.
  bool is_crease(Index face, const Face_neighbors::Neighbor& n) const
  {
    if (!is_smooth(face, n))
      return true;
    const double deviation = m_surface.deviation(n.adjacency);
    if (deviation < 0.5)
      return false;
    double largest = 0;
    for (const Index f : {face, n.face})
      for (const Face_neighbors::Neighbor& other : m_neighbors[f])
        if (other.adjacency != n.adjacency && is_smooth(f, other))
          largest = (std::max)(largest, m_surface.deviation(other.adjacency));
    return deviation > 2.5 * largest;
  }

  /// Faces at borders go to the neighboring surface from which they deviate least.
  void compete()
  {
    for (int round = 0; round < 4; ++round) {
      bool changed = false;
      for (Index f = 0; f < m_labels.size(); ++f) {
        Index best = m_labels[f];
        double least = best == none ? 1e300 : m_test.deviation(m_found[best], f);
        for (const Face_neighbors::Neighbor& n : m_neighbors[f]) {
          const Index label = m_labels[n.face];
          if (label == none || label == m_labels[f] || label == best || !m_test(m_found[label], f))
            continue;
          const double deviation = m_test.deviation(m_found[label], f);
          if (deviation < 0.9 * least - 1e-3 * m_test.tolerance()) {
            least = deviation;
            best = label;
          }
        }
        if (best != m_labels[f]) {
          m_labels[f] = best;
          changed = true;
        }
      }
      if (!changed)
        break;
    }
  }

  /// What is left: components across smooth edges.
  void join_freeform()
  {
    std::vector<Index> component;
    for (Index seed = 0; seed < m_labels.size(); ++seed) {
      if (m_labels[seed] != none)
        continue;
      const Index label = Index(m_found.size());
      m_found.push_back(Fitted_surface());
      component.assign(1, seed);
      m_labels[seed] = label;
      double area = 0;
      for (std::size_t i = 0; i < component.size(); ++i) {
        area += m_surface.area(component[i]);
        for (const Face_neighbors::Neighbor& n : m_neighbors[component[i]])
          if (m_labels[n.face] == none && !is_crease(component[i], n)) {
            m_labels[n.face] = label;
            component.push_back(n.face);
          }
      }
      if (area < 1e-6 * m_surface.area())
        absorb(component);
    }
  }

  /// A fillet along a curve is freeform, but osculated by tori; where one of them was found, the freeform face beside it goes on with
  /// nearly the same curvature, and is the same face.
  void join_tori_to_freeform()
  {
    struct Border
    {
      Index torus, freeform;
      double length, gradual;
    };
    std::vector<Border> borders;
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      for (const bool reversed : {false, true}) {
        const Index f = reversed ? m_surface.higher_face(a) : m_surface.lower_face(a);
        const Index g = reversed ? m_surface.lower_face(a) : m_surface.higher_face(a);
        const Index i = m_labels[f], j = m_labels[g];
        if (m_found[i].kind != Surface_kind::TORUS || m_found[j].kind != Surface_kind::FREEFORM)
          continue;
        const double length = m_surface.length(a);
        borders.push_back({i, j, length, departs_gradually(m_found[i], g, a) ? length : 0});
      }
    std::vector<double> areas(m_found.size(), 0);
    for (Index f = 0; f < m_labels.size(); ++f)
      areas[m_labels[f]] += m_surface.area(f);
    std::stable_sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) {
      return a.torus != b.torus ? a.torus < b.torus : a.freeform < b.freeform;
    });
    std::vector<Index> now(m_found.size());
    for (Index i = 0; i < now.size(); ++i)
      now[i] = i;
    for (std::size_t first = 0, last; first < borders.size(); first = last) {
      double length = 0, gradual = 0;
      for (last = first; last < borders.size() && borders[last].torus == borders[first].torus
                         && borders[last].freeform == borders[first].freeform; ++last) {
        length += borders[last].length;
        gradual += borders[last].gradual;
      }
      if (gradual > 0.7 * length && areas[borders[first].freeform] > 0.3 * areas[borders[first].torus]
          && now[borders[first].torus] == borders[first].torus)
        now[borders[first].torus] = borders[first].freeform;
    }
    for (Index& label : m_labels)
      label = now[label];
  }

  /// Whether a face beside a torus departs from it much less than a plane that is tangent to its tube.
  bool departs_gradually(const Fitted_surface& s, Index face, std::size_t adjacency) const
  {
    double distance = 0;
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      distance = (std::max)(distance, std::fabs(signed_distance(s, m_surface.point(m_surface.corner(face, i)))));
    const double height = 2 * m_surface.area(face) / m_surface.length(adjacency);
    return distance < 0.02 * height * height / s.minor_radius && m_test.has_normal_of(s, face);
  }

  /// Gives a tiny component to the neighbor with the longest border.
  void absorb(const std::vector<Index>& component)
  {
    const Index own = m_labels[component[0]];
    std::vector<std::pair<Index, double>> borders;
    for (const Index f : component)
      for (const Face_neighbors::Neighbor& n : m_neighbors[f])
        if (m_labels[n.face] != own && m_labels[n.face] != none)
          borders.push_back({m_labels[n.face], m_surface.length(n.adjacency)});
    std::stable_sort(borders.begin(), borders.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Index best = none;
    double longest = 0;
    for (std::size_t i = 0; i < borders.size();) {
      double length = 0;
      std::size_t j = i;
      for (; j < borders.size() && borders[j].first == borders[i].first; ++j)
        length += borders[j].second;
      if (length > longest) {
        longest = length;
        best = borders[i].first;
      }
      i = j;
    }
    if (best != none)
      for (const Index f : component)
        m_labels[f] = best;
  }

  const Surface& m_surface;
  Face_neighbors m_neighbors;
  Patch m_patch;
  double m_noise;
  Face_test m_test;
  Face_grower m_grower;
  std::vector<Index> m_labels;
  std::vector<Fitted_surface> m_found;
  std::vector<std::uint8_t> m_is_tried;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_FINDER_H
