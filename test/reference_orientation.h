// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H

// Closed components that are inside out are turned: slow and obvious, for the reference implementations.

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace reference {

/// Whether there are no borders and the signed volume of the whole is below 0.
template <typename Point>
bool is_closed_and_negative(const std::vector<Point>& points, const std::vector<std::vector<std::size_t>>& faces)
{
  std::map<std::pair<std::size_t, std::size_t>, bool> halfedges;
  double volume = 0;
  for (const auto& face : faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      halfedges[{face[i], face[(i + 1) % face.size()]}] = true;
      const Point &p = points[face[0]], &q = points[face[i]], &r = points[face[(i + 1) % face.size()]];
      volume += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
  return volume < 0 && std::all_of(halfedges.begin(), halfedges.end(), [&](const auto& h) {
    return halfedges.count({h.first.second, h.first.first}) > 0;
  });
}

/// Reverses the faces of each component without borders whose signed volume is below 0.
template <typename Point>
void turn_outward(const std::vector<Point>& points, std::vector<std::vector<std::size_t>>& faces)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      face_of[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}] = f;
  std::vector<bool> is_seen(faces.size(), false);
  for (std::size_t start = 0; start < faces.size(); ++start) {
    if (is_seen[start])
      continue;
    std::vector<std::size_t> component = {start};
    is_seen[start] = true;
    bool is_closed = true;
    double volume = 0;
    const Point origin = points[faces[start][0]];
    for (std::size_t k = 0; k < component.size(); ++k) {
      const auto& face = faces[component[k]];
      const std::size_t n = face.size();
      for (std::size_t i = 0; i < n; ++i) {
        const auto across = face_of.find({face[(i + 1) % n], face[i]});
        is_closed = is_closed && across != face_of.end();
        if (across != face_of.end() && !is_seen[across->second]) {
          is_seen[across->second] = true;
          component.push_back(across->second);
        }
        const Point &p = points[face[0]], &q = points[face[i]], &r = points[face[(i + 1) % n]];
        double a[3], b[3], c[3];
        for (int x = 0; x < 3; ++x) {
          a[x] = p[x] - origin[x];
          b[x] = q[x] - origin[x];
          c[x] = r[x] - origin[x];
        }
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]);
      }
    }
    if (is_closed && volume < 0)
      for (const std::size_t f : component)
        std::reverse(faces[f].begin(), faces[f].end());
  }
}

} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_ORIENTATION_H
