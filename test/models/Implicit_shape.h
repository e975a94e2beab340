// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_IMPLICIT_SHAPE_H
#define CGAL_REGION_SEGMENTATION_TEST_IMPLICIT_SHAPE_H

#include "models/Labelled_model.h"
#include "soup/Polygon_soup.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace segment_mesh {

/// About the signed distance to a body: negative inside, its gradient about 1 near the surface.
using Distance = std::function<double(const Point&)>;

/// An ellipsoid of revolution with the axis from `a` to `b`, and the given radius around it.
Distance ellipsoid(const Point& a, const Point& b, double radius);

/// A union of bodies with soft creases between them.
class Implicit_shape
{
public:
  /// `blend`: how far from a crease it is rounded, in units of the shape
  explicit Implicit_shape(double blend)
    : m_blend(blend)
  {}

  /// Adds a body that belongs to a part.
  void add(Distance body, std::size_t part);

  double operator()(const Point& p) const;
  /// The part whose body is nearest (ties: the first).
  std::size_t part_at(const Point& p) const;
  std::size_t number_of_parts() const { return m_number_of_parts; }

private:
  struct Body
  {
    Distance distance;
    std::size_t part;
  };

  double m_blend;
  std::vector<Body> m_bodies;
  std::size_t m_number_of_parts = 0;
};

/// The surface of a shape as a triangle mesh: a closed manifold, oriented outwards. Depends on no
/// library, so it is the same everywhere, up to the rounding of mathematical functions. \param
/// inside a point of the shape, which is bounded; the component of the surface that a ray from
/// there along x leaves through is meshed \param edge_length about the mean length of edges, in
/// units of the shape
Polygon_soup mesh_implicit_shape(const Implicit_shape& shape, const Point& inside,
                                 double edge_length);

/// Meshes a shape, and gives each face the part that is nearest to its centroid; a face between two
/// of another part goes to that.
Labelled_model make_labelled_model(const Implicit_shape& shape, const Point& inside,
                                   double edge_length);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_TEST_IMPLICIT_SHAPE_H
