// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/light_corners.h"

#include "soup/vector_algebra.h"

#include <cmath>

namespace segment_mesh {

namespace {

/// The faces round each point, in their order.
class Incidence
{
public:
  explicit Incidence(const Scene& scene)
    : m_starts(scene.points.size() + 2)
    , m_faces(scene.corners.size())
  {
    // m_starts[p + 2] counts the faces of p, then holds their end; filling moves m_starts[p + 1]
    // from the start of p to its end, which is the start of the next one.
    for (Scene::Index p : scene.corners)
      ++m_starts[p + 2];
    for (std::size_t i = 2; i < m_starts.size(); ++i)
      m_starts[i] += m_starts[i - 1];
    for (std::size_t f = 0; f < scene.number_of_faces(); ++f)
      for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c)
        m_faces[m_starts[scene.corners[c] + 1]++] = Scene::Index(f);
  }

  const Scene::Index* begin(std::size_t point) const { return m_faces.data() + m_starts[point]; }
  const Scene::Index* end(std::size_t point) const { return m_faces.data() + m_starts[point + 1]; }

private:
  std::vector<Scene::Index> m_starts, m_faces;
};

/// The mean of the normals round a point that are near that of one of the faces there; these are
/// turned to its side, should they be turned the wrong way. A unit vector, or zero.
Point corner_normal(const Scene& scene, const Incidence& faces, std::size_t face, std::size_t point)
{
  constexpr double cosine_of_sharp = 0.77; // 40 degrees
  constexpr std::ptrdiff_t many = 64;      // a fan of n faces would take n * n steps
  const Point& flat = scene.normals[face];
  if (faces.end(point) - faces.begin(point) > many)
    return flat;
  Point sum = {0, 0, 0};
  for (const Scene::Index* g = faces.begin(point); g != faces.end(point); ++g) {
    const double cosine = inner_product(flat, scene.normals[*g]);
    if (std::abs(cosine) > cosine_of_sharp)
      sum = plus(sum, times(cosine < 0 ? -1 : 1, scene.normals[*g]));
  }
  return unit_vector(sum);
}

/// A soft key light from the upper left, a fill light from the viewer, and a narrow highlight.
class Lamp
{
public:
  explicit Lamp(const Viewpoint& v)
    : m_key(unit_vector(plus(plus(times(-0.5, v.right), times(0.8, v.up)), v.toward_viewer)))
    , m_fill(v.toward_viewer)
    , m_half_way(unit_vector(plus(m_key, m_fill)))
  {}

  double operator()(const Point& normal) const
  {
    const double wrapped = 0.5 + 0.5 * inner_product(normal, m_key); // no hard edge of the shadow
    const double facing = std::fmax(0.0, inner_product(normal, m_fill));
    const double highlight = std::pow(std::fmax(0.0, inner_product(normal, m_half_way)), 24);
    return 0.42 + 0.47 * wrapped * wrapped + 0.27 * facing + 0.14 * highlight;
  }

private:
  Point m_key, m_fill, m_half_way;
};

} // namespace

std::vector<float> light_corners(const Scene& scene, const Viewpoint& viewpoint)
{
  const Incidence faces(scene);
  const Lamp lamp(viewpoint);
  std::vector<float> light(scene.corners.size());
  for (std::size_t f = 0; f < scene.number_of_faces(); ++f) {
    const double side = inner_product(scene.normals[f], viewpoint.toward_viewer) < 0 ? -1 : 1;
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c)
      light[c] = float(lamp(times(side, corner_normal(scene, faces, f, scene.corners[c]))));
  }
  return light;
}

} // namespace segment_mesh
