// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Box_partition.h>
#include <CGAL/Region_segmentation/internal/rays/Box_tree_builder.h>
#include <CGAL/Region_segmentation/internal/rays/Float_4.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/rays/Patch_boxes.h>
#include <CGAL/Region_segmentation/internal/rays/Patch_triangles.h>
#include <CGAL/Region_segmentation/internal/rays/Ray_leaves.h>
#include <CGAL/Region_segmentation/internal/support/Float_key.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the face that a ray hits first: a tree of bounding boxes over the patches of a mesh, or slices of them (see
/// `Patch_boxes`), whose triangles (polygons as fans) are the leaves. In float, relative to the centroid of the surface:
/// distances are needed to a few digits only. (CGAL's AABB tree is exact, and GPL.)
///
/// A node has up to four children, which are tested together, and so are four triangles of a leaf: so there are few
/// unpredictable branches. A leaf is a patch, a coarse one on meshes of few faces (see `Ray_leaves`). The result does not depend
/// on the shape of the tree, and neither on the patches.
///
/// About 60 bytes per triangle, or 5 on large meshes (see `Ray_leaves`), and construction in O(T + P log P) for T triangles in
/// P patches; a ray takes O(log P + T / P) in practice.
class Ray_tree
{
  using Index = Flat_mesh::Index;

public:
  struct Hit
  {
    Index face;
    double distance; // in units of the mesh
  };
  static constexpr Index no_face = Ray::no_face;

  /// `origin`: the centroid of the surface; `most_stored_faces`: see `Ray_leaves`
  /// \pre the mesh was read with its points and patches
  template <typename ConcurrencyTag>
  Ray_tree(const Flat_mesh& mesh, const Double_3& origin, const Execution<ConcurrencyTag>& execution,
           std::size_t most_stored_faces = Ray_leaves::most_stored_faces)
    : m_unit(unit_of(mesh, origin))
    , m_leaves(mesh, origin, 1 / m_unit, most_stored_faces)
  {
    if (mesh.number_of_faces() == 0)
      return;
    Box_partition boxes = Patch_boxes::make<ConcurrencyTag>(mesh, m_leaves.triangles());
    execution.report(0.4);
    m_nodes = Box_tree_builder(boxes, execution.step(0.4, 0.8)).take_nodes();
    m_leaves.store(mesh, execution.step(0.8, 1));
    execution.report(1);
  }

  /// A ray whose first hit is not known yet; `direction` has length 1.
  Ray make_ray(const Double_3& source, const Double_3& direction, Index skipped) const
  {
    return {m_leaves.triangles().relative(source), m_leaves.triangles().direction(direction), skipped};
  }

  /// Finds the first face of the mesh of the tree that each ray hits in front of its source, other than the one it skips.
  ///
  /// Up to `bundle_size` rays go from leaf to leaf together, so that the memory that they need next is fetched for all of them at a
  /// time: .81 of the time of one ray after the other at 830,000 faces, .91 at 50,000.
  void trace(const Flat_mesh& mesh, Ray* begin, Ray* end) const
  {
    for (; begin != end; begin += (std::min)(end - begin, std::ptrdiff_t(bundle_size)))
      trace_bundle(mesh, begin, (std::min)(std::size_t(end - begin), bundle_size));
  }

  /// \pre the ray was traced
  Hit hit(const Ray& ray) const { return {ray.face, ray.face == no_face ? 0.0 : double(ray.distance) * m_unit}; }

private:
  using Node = Box_node;
  using Child = Node::Child;
  static constexpr std::size_t width = Node::width;
  static constexpr std::size_t bundle_size = 12;

  /// Of the surface alone: so rounding to float does not depend on the unit of the mesh.
  static double unit_of(const Flat_mesh& mesh, const Double_3& origin)
  {
    const Mesh_patches& patches = mesh.patches();
    double largest = 0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      largest = (std::max)(largest, squared_norm(patches[p].centroid - origin));
    return (std::max)(std::sqrt(largest), mesh.relative_unit());
  }

  using Waiting = Float_key; // where the ray enters a box, and the child
  static constexpr Waiting never = Waiting(0x7f800000) << 32; // infinity

  /// The values of a ray that box tests need.
  struct Slopes
  {
    Float_3 inverse;            // of the direction; infinite for 0
    std::array<std::size_t, 3> entered; // by which of the two bounds the ray enters a box, by axis

    explicit Slopes(const Float_3& direction)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        inverse[k] = 1 / direction[k];
        entered[k] = inverse[k] < 0 ? 1 : 0;
      }
    }
  };

  /// The way of a ray through the tree.
  class Walk
  {
  public:
    static constexpr Index end = (std::numeric_limits<Index>::max)();

    explicit Walk(const Ray& ray) : m_slopes(ray.direction) { m_waiting[0] = make_float_key(0, 0); }

    /// The next leaf that may contain the first hit; or the end.
    Index next_leaf(const std::vector<Node>& nodes, const Ray& ray)
    {
      while (m_size > 0) {
        Waiting nearest = m_waiting[--m_size];
        if (!(value_of(nearest) <= ray.distance))
          continue;
        while (nearest < never) {
          const Child child = index_of(nearest);
          if (child % 2 == 1)
            return child / 2;
          const std::array<Waiting, width> c = children(nodes[child / 2], ray, m_slopes);
          for (std::size_t i = 0; i < width - 1; ++i) {
            m_waiting[m_size] = c[i];
            m_size += std::size_t(c[i] < never);
          }
          nearest = c[width - 1];
        }
      }
      return end;
    }

  private:
    Slopes m_slopes;
    std::size_t m_size = 1;
    // A node adds at most three waiting entries.
    std::array<Waiting, 3 * Box_tree_builder::maximum_depth> m_waiting;
  };

  void trace_bundle(const Flat_mesh& mesh, Ray* rays, std::size_t number) const
  {
    if (m_nodes.empty())
      return;
    boost::container::static_vector<Walk, bundle_size> walks;
    boost::container::static_vector<Ray_leaves::Visit, bundle_size> visits;
    for (std::size_t i = 0; i < number; ++i) {
      walks.emplace_back(rays[i]);
      visits.push_back({rays + i, 0});
    }
    while (!visits.empty()) {
      std::size_t size = 0;
      for (Ray_leaves::Visit visit : visits) {
        visit.leaf = walks[std::size_t(visit.ray - rays)].next_leaf(m_nodes, *visit.ray);
        if (visit.leaf != Walk::end)
          visits[size++] = visit;
      }
      visits.resize(size);
      m_leaves.intersect(mesh, {visits.data(), visits.data() + size});
    }
  }

  /// The children that the ray enters before its best hit, the nearest last; those that it does not enter come first.
  static std::array<Waiting, width> children(const Node& node, const Ray& ray, const Slopes& slopes)
  {
    Float_4 in = all_lanes(0), out = all_lanes(ray.distance);
    for (std::size_t k = 0; k < 3; ++k) {
      const Float_4 source = all_lanes(ray.source[k]), inverse = all_lanes(slopes.inverse[k]);
      const Float_4 near = (node.bounds[slopes.entered[k]][k] - source) * inverse;
      const Float_4 far = (node.bounds[1 - slopes.entered[k]][k] - source) * inverse;
      in = larger(near, in); // a NaN bound (0 * infinity) is ignored
      out = smaller(far, out);
    }
    const Float_4 entries = select(in <= out, in, all_lanes(std::numeric_limits<float>::infinity()));
    std::array<Waiting, width> w;
    for (std::size_t i = 0; i < width; ++i)
      w[i] = make_float_key(entries[i], node.child[i]);
    const auto order = [&](std::size_t i, std::size_t j) {
      const Waiting a = w[i], b = w[j];
      w[i] = a > b ? a : b;
      w[j] = a > b ? b : a;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return w;
  }

  double m_unit; // of relative coordinates
  Ray_leaves m_leaves;
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H
