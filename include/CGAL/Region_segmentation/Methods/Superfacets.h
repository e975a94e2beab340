// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H
#define CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Methods/Border_straightening.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/Border_shortening.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/regions/Farthest_point_seeding.h>
#include <CGAL/Region_segmentation/internal/regions/Region_shapes.h>
#include <CGAL/Region_segmentation/internal/regions/border_costs.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/grid.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// makes regions of bounded size whose borders are short and follow concave edges: each patch of the mesh (see
/// `Mesh_patches`) belongs to the nearest seed. A model of `RegionInitializer`. Constrained edges are never crossed.
///
/// A step between two adjacent patches has the length \f$|c_i - c_j| / \sqrt{A} + w \, \min(\delta^+, m)\f$, rounded to
/// multiples of \f$2^{-20}\f$ (see `internal::on_grid()`) and to `float`, at least \f$2^{-20}\f$ and at most \f$10^{28}\f$, \f$c\f$ the centroids, \f$A\f$ the area of the surface, \f$\delta^+\f$ the
/// angle of their normals if they face each other, \f$(n_j - n_i) \cdot (c_j - c_i) < 0\f$, else 0 (and 0 if one has no normal). Distances are sums
/// of steps in `double`. The first seeds are placed in the connected components without one, each at the patch of them that is farthest from the
/// centroid of the surface, even if this exceeds the number; then each further one at the patch farthest from all seeds so far; of
/// several, at the lower one.
///
/// Seeds are placed like this on the coarse patches, if there are at least four for each region, and moved to their centers: a patch belongs
/// to the nearest of these. It is reached through a neighbor; of several through which its distance is the same, through that with the smallest
/// distance, rounded to `float`, then the lowest one; and belongs to the seed of this neighbor. If there are fewer coarse patches, seeds
/// are placed on the patches, and a patch belongs to the nearest seed, of several to the one placed first.
/// Regions are connected, and are numbered by their lowest patch, so by positions (see `Mesh_patches`).
///
/// Then borders are shortened. A border of length \f$l\f$ (that of the edges that are not constrained) between two
/// patches costs \f$l / (\sqrt{A} (1 + g \, \min(\delta^+, m)))\f$, rounded to multiples of \f$2^{-24}\f$ and to `float`, so it is drawn into valleys. A
/// patch that is adjacent to exactly one patch of its own region can move to an adjacent region; its gain is the cost
/// of its borders to that region minus that of the border to the one patch. The move with the largest gain is made
/// first (of equal ones that of the lowest patch, and to the lowest region), as long as there is one whose gain is
/// above 1/1000 of the cost of all borders of its patch. Finally regions are numbered by their lowest patch.
///
/// When it is known which regions are merged, the borders of segments are moved to minimum cuts, see
/// `Border_straightening`.
///
/// Since concavity is added to a step, not multiplied, and angles are those between patches, the regions of a surface
/// depend little on the resolution of its mesh.
///
/// Complexity: O(F + P log P) in practice, P the number of patches, at most some 60,000, with a small constant: seeds are placed
/// on some 4,000 coarse patches, each of which is reached by a few seeds. Deterministic.
///
/// Source: farthest-point seeding \cgalCite{G85}, in images \cgalCite{ELPZ97}.
class Superfacets
{
public:
  static constexpr Mesh_data required_mesh_data = Mesh_data::PATCHES;

  std::size_t number;       ///< of regions, at least 1
  double concave_weight;    ///< w, relative length per radian, at least 0: the lengthening of steps into valleys
  double maximum_deviation; ///< m, radian, at least 0: deviations above it count as this one
  double concave_gain = 10; ///< g, 1/radian, at least 0: how much cheaper a border in a valley is
  Border_straightening straightening; ///< of the segments' borders

  explicit Superfacets(std::size_t number_ = 480, double concave_weight_ = 0.4, double maximum_deviation_ = 0.6)
    : number(number_), concave_weight(concave_weight_), maximum_deviation(maximum_deviation_)
  {}

  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Partition operator()(const Flat_mesh& mesh,
                       const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>()) const
  {
    if (mesh.number_of_faces() == 0)
      return Partition();
    check_constants();
    return composed(mesh.patches().of_faces(), regions_of_patches(mesh, execution));
  }

  /// The partition into `number_of_segments` that splits connected regions further: the face farthest from that
  /// nearest to the centroid of its region is separated first, with the faces that were reached through it. Steps
  /// between faces are measured as those between patches. O(F log F).
  /// \pre `number_of_segments` is at least the number of regions
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Partition split(const Flat_mesh& mesh, const Partition& regions, std::size_t number_of_segments,
                  const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>()) const
  {
    if (mesh.number_of_faces() == 0)
      return Partition();
    internal::Dual_graph graph(
      mesh, [&](std::size_t e) { return regions[mesh.lower_face(e)] == regions[mesh.higher_face(e)]; },
      [&](std::size_t f, std::size_t e) {
        const double concavity = mesh.has_flag(e, Flat_mesh::CONCAVE) ? mesh.deviation(f, e) : 0;
        return step(mesh, norm(mesh.centroid(f) - mesh.centroid(mesh.higher_face(e))), concavity);
      });
    internal::Farthest_point_seeding seeding(std::move(graph), execution);
    seeding.run(central_faces(mesh, regions));
    return seeding.split_regions(number_of_segments);
  }

  /// Moves the borders of the regions after they are merged, see `RegionInitializer::straighten_borders()`.
  template <typename IsFixed, typename ConcurrencyTag = CGAL::Sequential_tag>
  std::vector<Flat_mesh::Index> straighten_borders(
    const Flat_mesh& mesh, const Partition& regions, const Merge_tree& tree, const IsFixed& is_fixed,
    const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>(),
    std::size_t number_of_segments = (std::numeric_limits<std::size_t>::max)()) const
  {
    return straightening(mesh, regions, tree, is_fixed, execution, number_of_segments);
  }

private:
  using Index = Flat_mesh::Index;

  void check_constants() const
  {
    CGAL_precondition_msg(number >= 1 && concave_weight >= 0 && maximum_deviation >= 0 && concave_gain >= 0,
                          "Superfacets: number is at least 1, the other constants at least 0");
  }

  template <typename ConcurrencyTag>
  Partition regions_of_patches(const Flat_mesh& mesh, const Execution<ConcurrencyTag>& execution) const
  {
    const internal::Dual_graph costs =
      internal::border_costs(mesh, mesh.patches(), concave_gain, maximum_deviation);
    return internal::Border_shortening(costs, nearest_seeds(mesh, execution.step(0, 0.9))).take_regions();
  }

  /// The partition of the patches by the seed to which each belongs.
  template <typename ConcurrencyTag>
  Partition nearest_seeds(const Flat_mesh& mesh, const Execution<ConcurrencyTag>& execution) const
  {
    const Mesh_patches& patches = mesh.patches();
    const Patches& coarse = patches.coarse();
    internal::Farthest_point_seeding from_patches(steps(mesh, patches), execution.step(0.5, 1));
    if (coarse.size() / coarse_patches_of_region < number)
      from_patches.run(distances_from_centroid(patches, mesh.relative_unit()), number);
    else {
      internal::Farthest_point_seeding from_coarse(steps(mesh, coarse), execution.step(0, 0.5));
      from_coarse.run(distances_from_centroid(coarse, mesh.relative_unit()), number);
      std::vector<Index> seeds;
      for (const Index seed : from_coarse.seeds())
        seeds.push_back(coarse[seed].center);
      from_patches.run(seeds);
    }
    return from_patches.regions();
  }

  internal::Dual_graph steps(const Flat_mesh& mesh, const Patches& patches) const
  {
    return internal::Dual_graph(patches, [&](std::size_t i) {
      const Patches::Adjacency& a = patches.adjacencies()[i];
      return step(mesh, norm(patches[a.lower].centroid - patches[a.higher].centroid), patches.concave_deviation(i));
    });
  }

  /// At least a step of the grid, so that only seeds have the distance 0; and so short that a path along all faces is
  /// finite in float, so that every face of a component is reached.
  double step(const Flat_mesh& mesh, double distance, double concavity) const
  {
    const double length = distance / mesh.relative_unit() + concave_weight * (std::min)(concavity, maximum_deviation);
    return (std::min)((std::max)(internal::on_grid(length), shortest_step), longest_step);
  }

  /// The face of each region nearest to its centroid.
  static std::vector<Index> central_faces(const Flat_mesh& mesh, const Partition& regions)
  {
    const internal::Region_shapes shapes(mesh, regions);
    std::vector<Index> faces(regions.number_of_parts());
    std::vector<double> distances(faces.size(), (std::numeric_limits<double>::max)());
    for (std::size_t f = 0; f < regions.size(); ++f) {
      const Index r = regions[f];
      const double distance = internal::on_grid(norm(mesh.centroid(f) - shapes.centroids[r]) / mesh.relative_unit());
      if (distance < distances[r]) {
        distances[r] = distance;
        faces[r] = Index(f);
      }
    }
    return faces;
  }

  /// From that of the surface.
  static std::vector<double> distances_from_centroid(const Patches& patches, double unit)
  {
    // Relative to a point of the mesh, to avoid cancellation far from the origin.
    const Double_3 origin = patches[0].centroid;
    Double_3 center{0, 0, 0};
    double area = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      center = center + patches[p].area * (patches[p].centroid - origin);
      area += patches[p].area;
    }
    center = origin + (area > 0 ? 1 / area : 0) * center;
    std::vector<double> distances;
    distances.reserve(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
      distances.push_back(internal::on_grid(norm(patches[p].centroid - center) / unit));
    return distances;
  }

  static constexpr std::size_t coarse_patches_of_region = 4; // at least, on average: fewer give no choice of seeds
  static constexpr double shortest_step = 1. / (1 << 20), longest_step = 1e28;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H
