// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_VISIBILITY_MERGING_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_VISIBILITY_MERGING_H

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Number_from_costs.h>
#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Superfacets/Region_rays.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// The length, the angles and the visibility of a section, filled by `Visibility_annotator`. A
/// model of `SectionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Visibility_section_data
{
  double length = 0;
  double concave = 0;    ///< integral of the deviation of concave edges, at most 0.6 rad each
  double convex = 0;     ///< integral of the deviation of convex edges, at most 2 rad each
  double bend = 0;       ///< integral of the angle between the mean normals of the regions from
                         ///< which merging starts, positive where these face each other
  double visibility = 0; ///< weight of the rays between the two regions
  /// It is 0 if the regions see each other, but are not adjacent.
  std::size_t number_of_adjacencies = 0;

  /// Adds an adjacency of two faces to the section. An edge of a degenerate face counts as flat.
  void add_adjacency(const Surface& surface, std::size_t adjacency)
  {
    add(surface.length(adjacency) / surface.length_unit(), signed_deviation(surface, adjacency));
  }

  /// Adds another section between the same two regions.
  void absorb(const Visibility_section_data& other)
  {
    length += other.length;
    concave += other.concave;
    convex += other.convex;
    bend += other.bend;
    visibility += other.visibility;
    number_of_adjacencies += other.number_of_adjacencies;
  }

protected:
  /// The deviation of an adjacency in radians: positive if it is concave, negative if it is convex.
  /// A link counts as a concave edge of a right angle, since there is a valley where components
  /// touch.
  static double signed_deviation(const Surface& surface, std::size_t adjacency)
  {
    return surface.has_flag(adjacency, Surface::LINK)      ? CGAL_PI / 2
           : surface.has_flag(adjacency, Surface::CONCAVE) ? surface.deviation(adjacency)
           : surface.has_flag(adjacency, Surface::CONVEX)  ? -surface.deviation(adjacency)
                                                           : 0;
  }

  /// Adds an adjacency by its length and its signed deviation.
  void add(double l, double deviation)
  {
    length += l;
    ++number_of_adjacencies;
    if (deviation > 0)
      concave += l * (std::min)(deviation, 0.6);
    else
      convex += l * (std::min)(-deviation, 2.0);
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// The area, the thickness and the visibility of a region, filled by `Visibility_annotator`. A
/// model of `RegionData`.
struct Visibility_region_data
{
  double area = 0;          ///< share of the area of the surface
  double log_thickness = 0; ///< integral over the area of the logarithm of the thickness
  double visibility = 0;    ///< weight of the rays that start in the region, and of those that end

  double mean_log_thickness() const { return area > 0 ? log_thickness / area : 0; }

  void add_face(const Surface&, std::size_t /* face */) {}
  void add_border(const Surface&, std::size_t /* adjacency */) {}

  /// Adds the region on the other side of a section.
  void absorb(const Visibility_region_data& other, const Visibility_section_data& /* between */)
  {
    area += other.area;
    log_thickness += other.log_thickness;
    visibility += other.visibility;
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// The strength of the separation of two regions by a section: the logarithm of a product of
/// powers. A model of `SectionCost`, for graphs annotated by `Visibility_annotator`.
///
/// A section of length \f$L\f$ between regions of areas \f$a_i, a_j\f$, \f$m\f$ the smaller and
/// \f$h\f$ their harmonic mean (all relative, see `Visibility_annotator`), costs \f[ p_d \ln d +
/// p_a ((1 - \eta) \ln m + \eta \ln h) - p_l \ln \frac{L^2}{m}
///    + p_t \ln (t_0 + |t_i - t_j|) - p_s \ln \left(s_0 + \frac{s_{ij}}{\min(s_i, s_j)}\right), \f]
/// \f$d = \max(0, (C - w_x X + w_b B) / L) + d_0\f$: the depth of the valley along the section,
/// from the integrals of concave and convex deviations \f$C, X\f$ and of the bend \f$B\f$; \f$t\f$
/// the mean thickness of a region; \f$s_{ij}\f$ the rays between the regions and \f$s_i\f$ those
/// that end in one. It has no unit.
///
/// The constants were chosen on half of the Princeton benchmark, see `doc/accuracy.md`.
struct Visibility_cost
{
  using RegionData = Visibility_region_data;
  using SectionData = Visibility_section_data;

  double depth_exponent = 4;          ///< p_d
  double depth_offset = 0.022;        ///< d_0, radian
  double area_exponent = 1.74;        ///< p_a
  double harmonic_share = 0.16;       ///< eta
  double length_exponent = 0.95;      ///< p_l
  double thickness_exponent = 1;      ///< p_t: 1 sets the scale of the cost
  double thickness_offset = 0.18;     ///< t_0
  double visibility_exponent = 0.195; ///< p_s
  double visibility_offset = 0.01;    ///< s_0
  double convex_weight = 0.3;         ///< w_x
  double bend_weight = 0.08;          ///< w_b

  /// The constants for the first merges, when regions are many and small: that two regions see each
  /// other counts more, and depth and area count less.
  static Visibility_cost for_many_regions()
  {
    Visibility_cost cost;
    cost.depth_exponent = 3.14;
    cost.depth_offset = 0.055;
    cost.area_exponent = 1.2;
    cost.length_exponent = 0.87;
    cost.visibility_exponent = 0.49;
    return cost;
  }

  /// \throws Invalid_method if a constant is not finite, or an offset not above 0
  void check_constants() const
  {
    for (double c : {depth_exponent, area_exponent, harmonic_share, length_exponent,
                     thickness_exponent, visibility_exponent, convex_weight, bend_weight})
      internal::check_constant("a constant of Visibility_cost", c, -internal::greatest_finite);
    for (double offset : {depth_offset, thickness_offset, visibility_offset})
      internal::check_constant("an offset of Visibility_cost", offset, internal::least_positive);
  }

  /// The depth d of the valley along a section, in radians.
  double depth(const Visibility_section_data& section) const
  {
    const double length = (std::max)(section.length, smallest);
    return (std::max)(
             0.0, (section.concave - convex_weight * section.convex + bend_weight * section.bend) /
                    length) +
           depth_offset;
  }

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Visibility_section_data& section = graph[s];
    const Visibility_region_data &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double length = (std::max)(section.length, smallest);
    const double smaller = (std::max)((std::min)(a.area, b.area), smallest);
    const double larger = (std::max)((std::max)(a.area, b.area), smallest);
    const double harmonic = 2 * smaller * larger / (smaller + larger);
    const double seen = (std::min)(a.visibility, b.visibility);
    const double mutual = seen > 0 ? section.visibility / seen : 0;
    const double log_smaller = std::log(smaller);
    return depth_exponent * std::log(depth(section)) +
           area_exponent *
             ((1 - harmonic_share) * log_smaller + harmonic_share * std::log(harmonic)) -
           length_exponent * (2 * std::log(length) - log_smaller) +
           thickness_exponent * std::log(thickness_offset + std::abs(a.mean_log_thickness() -
                                                                     b.mean_log_thickness())) -
           visibility_exponent * std::log(visibility_offset + mutual);
  }

private:
  // Relative lengths and areas that are smaller count as this one.
  static constexpr double smallest = 1e-12;
};

/// \ingroup PkgRegionSegmentationAnnotators
/// measures by rays into the body its thickness in every region, and which regions see each other:
/// for graphs with `Visibility_region_data` and `Visibility_section_data`.
///
/// Each superfacet of the first draw (see `Superfacet_merging`) casts 12 rays into the body. The
/// candidates to start from are the faces at the centers (`Patch::center`) of its patches (see
/// `Surface_patches`), in the order of the distance of their centroids to that of the superfacet,
/// then of their indices. Of \f$n\f$ candidates those at the places \f$\lfloor 9 k n / (10 m)
/// \rfloor\f$ are used, \f$m = \min(n, 3)\f$, \f$k = 0 .. m - 1\f$, counted from 0: the one nearest
/// to the centroid, and those at 3/10 and 6/10 in the order. Each casts \f$q = 12 / m\f$ rays. A
/// superfacet of less than 1/6400 of the surface casts a single ray, that with \f$k = i = 0\f$; one
/// of less than 1/25600 casts none.
///
/// Ray \f$i\f$ of candidate \f$k\f$ leaves the centroid of the face in the direction
/// \f$-\cos(a) N + \sin(a) (\cos(b) u + \sin(b) v)\f$, with \f$a = 0.9 \sqrt{i / (q - 1)}\f$ and
/// \f$b = 2.399963229728653 \, i + k\f$ radians (a spiral of the golden angle). \f$N\f$ is the unit
/// normal; \f$u\f$ is the direction in the plane of the face that leads away from the centroid of
/// the surface, or, if less than 1/1000 of the vector from there lies in this plane, to the first
/// corner of the face; and \f$v = -N \times u\f$. Degenerate faces cast no rays.
///
/// A ray ends at the first other face that it hits from inside (where its direction and the normal
/// of the face have a positive product), of several the lower one; where thousands of faces
/// overlap, at the first one found in bounded time. It passes faces that it meets from outside:
/// there it has left the body through an opening, or enters another component that crosses the
/// first. A ray that ends at no face, as most below a sheet, has left the body: it tells nothing of
/// thickness, and has no weight. Triangles are intersected as in \cgalCite{MT97}, with a margin of
/// \f$10^{-6}\f$ in the barycentric coordinates; a polygon is a fan of triangles from its first
/// corner.
/// - The *thickness* of a region is the mean of \f$\ln(x / \sqrt{A} + 10^{-4})\f$, \f$x\f$ the
///   lengths of the rays that start in it; that of a region without rays that hit is the mean of
///   the others' thicknesses, or 0 where no ray hits.
/// - Each ray has a weight: the share of its superfacet in the area of the surface, divided by 12,
///   or by 1 if the superfacet casts one. It is added to the visibility of the region where it
///   starts, to that of the region where it ends (so twice if they are the same), and to that of
///   the section between the two. Opposite sides of a limb see each other; two limbs do not. Two
///   regions without a common border that see each other get a section of no edges, which is never
///   merged across, and counts when their unions become adjacent.
/// - The *bend* of a section is its length times the angle between the mean normals of its two
///   regions, positive if these face each other: \f$(n_j - n_i) \cdot (c_j - c_i) < 0\f$, \f$c\f$
///   the centroids of the regions: means over the fine patches, by area.
///
/// Lengths are relative to \f$\sqrt{A}\f$ and areas to \f$A\f$, the area of the surface. If that is
/// 0, all data are 0.
///
/// Complexity: O(P log P + 12 R log P) in practice, P patches, rays included (see `Region_rays`);
/// at worst, where most faces are long and overlap, O(F) for each of at most 102,400 rays.
/// Deterministic. With `Parallel_tag` the rays are traced in
/// parallel, with bitwise equal results.
///
/// Source: thickness \cgalCite{SSC08}.
class Visibility_annotator
{
  using Index = Surface::Index;

public:
  using RegionData = Visibility_region_data;
  using SectionData = Visibility_section_data;

  /// Fills the data of `graph`.
  template <typename Graph>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const
  {
    if (surface.area() == 0)
      return;
    const std::vector<Region_shape>& shapes = rays.shapes.regions;
    for (Index r = 0; r < regions.number_of_parts(); ++r) {
      graph[r].area = shapes[r].moments.weight;
      graph[r].visibility = 0;
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      Visibility_section_data& section = graph[*range.first];
      section.visibility = 0;
      section.bend = section.length * angle_between(shapes[graph.source(*range.first)],
                                                    shapes[graph.target(*range.first)]);
    }
    set_rays(graph, regions, rays, surface.length_unit());
  }

private:
  /// The angle between the normals of two regions, positive where the regions face each other.
  static double angle_between(const Region_shape& a, const Region_shape& b)
  {
    const Double_3 m = a.normal(), n = b.normal();
    const double angle = std::atan2(norm(cross(m, n)), dot(m, n));
    return dot(n - m, b.moments.centroid() - a.moments.centroid()) < 0 ? angle : -angle;
  }

  template <typename Graph>
  static void set_rays(Graph& graph, const Partition& regions, const Region_rays& rays, double unit)
  {
    std::vector<double> sums(regions.number_of_parts()), numbers(sums.size()); // of log thickness
    for (const Inward_ray& ray : rays.rays) {
      const Index r = regions[ray.source];
      sums[r] += std::log(ray.distance / unit + 1e-4);
      ++numbers[r];
      add_ray(graph, r, regions[ray.hit], ray.weight);
    }
    double sum_of_all = 0, number_of_all = 0; // over the regions from which rays hit
    for (Index r = 0; r < sums.size(); ++r)
      if (numbers[r] > 0) {
        sum_of_all += sums[r] / numbers[r];
        ++number_of_all;
      }
    const double mean = number_of_all > 0 ? sum_of_all / number_of_all : 0;
    for (Index r = 0; r < sums.size(); ++r)
      graph[r].log_thickness = graph[r].area * (numbers[r] > 0 ? sums[r] / numbers[r] : mean);
  }

  template <typename Graph>
  static void add_ray(Graph& graph, Index from, Index to, double weight)
  {
    graph[from].visibility += weight;
    graph[to].visibility += weight;
    if (from == to)
      return;
    auto section = graph.section(from, to);
    if (!section)
      section = graph.add_nonadjacent_section(from, to);
    graph[*section].visibility += weight;
  }
};

/// \ingroup PkgRegionSegmentationMethods
/// The method with a hand-crafted cost: it merges superfacets at the lowest `Visibility_cost`
/// first, with different constants while there are more than 150 regions. A model of
/// `SegmentationMethod`.
struct Visibility_merging
  : Superfacet_merging<
      Visibility_annotator,
      Policy_phases<Lowest_cost_first<Visibility_cost>, Lowest_cost_first<Visibility_cost>>,
      Number_from_costs>
{
  static constexpr bool fills_voids = true; ///< see `SegmentationMethod`

  /// The level of `Number_from_costs` for the constants of `Visibility_cost()`.
  static constexpr double default_level = -19.5;

  /// `cost_of_many` determines the order of merges while there are more than `many` regions, `cost`
  /// from then on.
  explicit Visibility_merging(
    const Visibility_cost& cost = Visibility_cost(),
    const Visibility_cost& cost_of_many = Visibility_cost::for_many_regions(),
    std::size_t many = 150)
    : Superfacet_merging{Visibility_annotator(),
                         {{Lowest_cost_first(cost_of_many), many}, {Lowest_cost_first(cost), 1}},
                         Number_from_costs(default_level)}
  {}
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Visibility_merging>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_VISIBILITY_MERGING_H
