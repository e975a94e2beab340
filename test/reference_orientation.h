// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H

// Closed components that are inside out are turned: slow and obvious, for the reference
// implementations.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace reference {

/// What turns the faces of a soup.
template <typename Point>
class Components
{
public:
  using Faces = std::vector<std::vector<std::size_t>>;

  Components(const std::vector<Point>& points, const Faces& faces)
    : m_points(points)
    , m_faces(faces)
    , m_component_of(faces.size(), none)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < faces[f].size(); ++i)
        face_of[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}] = f;
    for (std::size_t start = 0; start < faces.size(); ++start)
      if (m_component_of[start] == none)
        add_component(start, face_of);
  }

  /// The faces that are inside out: of closed components whose outermost container, or they
  /// themselves without one, have a negative volume.
  std::vector<std::size_t> faces_inside_out() const
  {
    std::vector<std::size_t> result;
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      if (const std::size_t c = m_component_of[f]; m_is_closed[c] && m_volumes[outermost(c)] < 0)
        result.push_back(f);
    return result;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  template <typename Face_of>
  void add_component(std::size_t start, const Face_of& face_of)
  {
    const std::size_t number = m_members.size();
    std::vector<std::size_t> members = {start};
    m_component_of[start] = number;
    bool is_closed = true;
    double volume = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto& face = m_faces[members[k]];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t next = face[(i + 1) % face.size()];
        const auto across = face_of.find({next, face[i]});
        is_closed = is_closed && across != face_of.end();
        if (across != face_of.end() && m_component_of[across->second] == none) {
          m_component_of[across->second] = number;
          members.push_back(across->second);
        }
        volume += determinant(from(m_faces[start][0], face[0]), from(m_faces[start][0], face[i]),
                              from(m_faces[start][0], next));
      }
    }
    m_members.push_back(members);
    m_is_closed.push_back(is_closed);
    m_volumes.push_back(volume);
  }

  std::size_t outermost(std::size_t component) const
  {
    for (std::size_t d = 0; d < m_members.size(); ++d)
      if (d != component && m_is_closed[d] && contains(d, component))
        return outermost(d);
    return component;
  }

  /// By the solid angle of the faces, seen from a vertex of the other component.
  bool contains(std::size_t component, std::size_t other) const
  {
    const std::size_t eye = m_faces[m_members[other][0]][0];
    double angle = 0;
    for (std::size_t f : m_members[component])
      for (std::size_t i = 2; i < m_faces[f].size(); ++i) {
        const Vector a = from(eye, m_faces[f][0]), b = from(eye, m_faces[f][i - 1]),
                     c = from(eye, m_faces[f][i]);
        const double x = length(a), y = length(b), z = length(c);
        angle += 2 * std::atan2(determinant(a, b, c),
                                x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
      }
    return std::abs(angle) > 6; // 4 pi, or 0
  }

  using Vector = std::array<double, 3>;

  Vector from(std::size_t origin, std::size_t vertex) const
  {
    const Point &o = m_points[origin], &p = m_points[vertex];
    return {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
  }
  static double dot(const Vector& a, const Vector& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static double length(const Vector& a) { return std::sqrt(dot(a, a)); }
  static double determinant(const Vector& a, const Vector& b, const Vector& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  const std::vector<Point>& m_points;
  const Faces& m_faces;
  std::vector<std::size_t> m_component_of;         // by face
  std::vector<std::vector<std::size_t>> m_members; // faces, by component
  std::vector<bool> m_is_closed;
  std::vector<double> m_volumes;
};

/// Reverses the faces of each outermost closed component whose signed volume is below 0, and of the
/// closed components in it.
template <typename Point>
void turn_outward(const std::vector<Point>& points, std::vector<std::vector<std::size_t>>& faces)
{
  for (const std::size_t f : Components<Point>(points, faces).faces_inside_out())
    std::reverse(faces[f].begin(), faces[f].end());
}

} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H
