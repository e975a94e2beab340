// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Region_rays.h>
#include <CGAL/Region_segmentation/Methods/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>
#include <CGAL/Region_segmentation/Methods/number_choosers.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segmenting/run_method.h>
#include <CGAL/Region_segmentation/internal/superfacets/Region_shapes.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationAnnotators
/// measures by rays from every region into the body its thickness there, and which regions see each
/// other: for graphs with `Visibility_region_data` and `Visibility_section_data`.
///
/// Each region casts 12 rays into the body. The candidates to start from are the faces at the
/// centers (`Patch::center`) of the patches (see `Surface_patches`) in the region, or, if there is
/// none, all of its faces, in the order of the distance of their centroids to that of the region,
/// then of their indices. Of \f$n\f$ candidates those at the places \f$\lfloor 9 k n / (10 m)
/// \rfloor\f$ are used, \f$m = \min(n, 3)\f$, \f$k = 0 .. m - 1\f$, counted from 0: the one nearest
/// to the centroid, and those at 3/10 and 6/10 in the order. Each casts \f$q = 12 / m\f$ rays. A
/// region of less than 1/6400 of the surface casts a single ray, that with \f$k = i = 0\f$; one of
/// less than 1/25600 casts none.
///
/// Ray \f$i\f$ of candidate \f$k\f$ leaves the centroid of the face in the direction
/// \f$-\cos(a) N + \sin(a) (\cos(b) u + \sin(b) v)\f$, with \f$a = 0.9 \sqrt{i / (q - 1)}\f$ and
/// \f$b = 2.399963229728653 \, i + k\f$ radians (a spiral of the golden angle). \f$N\f$ is the unit
/// normal; \f$u\f$ is the direction in the plane of the face that leads away from the centroid of
/// the surface, or, if less than 1/1000 of the vector from there lies in this plane, to the first
/// corner of the face; and \f$v = -N \times u\f$. Degenerate faces cast no rays.
///
/// A ray ends at the first other face, whichever side it hits, of several the lower one; where
/// thousands of faces overlap, at the first one found in bounded time. Triangles are intersected as
/// in \cgalCite{MT97}, with a margin of \f$10^{-6}\f$ in the barycentric coordinates; a polygon is
/// a fan of triangles from its first corner.
/// - The *thickness* of a region is the mean of \f$\ln(x / \sqrt{A} + 10^{-4})\f$, \f$x\f$ the
/// lengths of
///   its rays; that of a region without rays that hit is the mean of the others' thicknesses.
/// - Each ray has a weight: the share of its region in the area of the surface, divided by 12, or
/// by 1 if the region
///   casts one. It is added to the visibility of the region where it starts, to that of the region
///   where it ends (so twice if they are the same), and to that of the section between the two.
///   Opposite sides of a limb see each other; two limbs do not. Two regions without a common border
///   that see each other get a section of no edges, which is never merged across, and counts when
///   their unions become adjacent.
/// - The *bend* of a section is its length times the angle between the mean normals of its two
///   regions, positive if these face each other: \f$(n_j - n_i) \cdot (c_j - c_i) < 0\f$, \f$c\f$
///   the centroids of the regions.
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

  /// `rays`: of the regions
  template <typename Graph>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const
  {
    if (surface.area() == 0)
      return;
    const std::vector<internal::Region_shape>& shapes = rays.shapes().regions;
    for (Index r = 0; r < regions.number_of_parts(); ++r) {
      graph[r].area = shapes[r].area / surface.area();
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
  /// Of the normals, positive where the regions face each other.
  static double angle_between(const internal::Region_shape& a, const internal::Region_shape& b)
  {
    const double angle = std::atan2(norm(cross(a.normal, b.normal)), dot(a.normal, b.normal));
    return dot(b.normal - a.normal, b.centroid - a.centroid) < 0 ? angle : -angle;
  }

  template <typename Graph>
  static void set_rays(Graph& graph, const Partition& regions, const Region_rays& rays, double unit)
  {
    std::vector<std::optional<double>> thickness(regions.number_of_parts());
    double sum_of_all = 0, number_of_all = 0;
    for (Index r = 0; r < regions.number_of_parts(); ++r) {
      const double area = graph[r].area;
      double sum = 0, number = 0;
      for (const internal::Ray_tree::Hit& hit : rays.hits()[r])
        if (hit.face != internal::Ray_tree::no_face) {
          sum += std::log(hit.distance / unit + 1e-4);
          ++number;
          add_ray(graph, r, regions[hit.face],
                  area / double(internal::Inward_rays::number_of_rays(area)));
        }
      if (number > 0) {
        thickness[r] = sum / number;
        sum_of_all += *thickness[r];
        ++number_of_all;
      }
    }
    const double mean = number_of_all > 0 ? sum_of_all / number_of_all : 0;
    for (Index r = 0; r < regions.number_of_parts(); ++r)
      graph[r].log_thickness = graph[r].area * thickness[r].value_or(mean);
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
/// The method with a hand-crafted cost: superfacets, annotated by `Visibility_annotator`, merged at
/// the lowest `Visibility_cost` first, with different constants while there are more than 150
/// regions. A model of `SegmentationMethod`.
struct Visibility_merging
  : Superfacet_merging<
      Visibility_annotator,
      Policy_phases<Lowest_cost_first<Visibility_cost>, Lowest_cost_first<Visibility_cost>>,
      Number_from_costs>
{
  /// The level of `Number_from_costs` for the constants of `Visibility_cost()`.
  static constexpr double default_level = -19.5;

  /// `cost`: for few regions; `cost_of_many`: while there are more than `many` regions
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

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_MERGING_H
