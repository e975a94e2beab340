// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_ANNOTATOR_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Methods/Region_rays.h>
#include <CGAL/Region_segmentation/Methods/Visibility_data.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/Region_shapes.h>

#include <cmath>
#include <cstddef>
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
/// the surface, or, if less than 1/1000 of the vector from there lies in this plane, to the corner
/// farthest from the centroid of the face; and \f$v = -N \times u\f$. Degenerate faces cast none.
///
/// A ray ends at the first other face, whichever side it hits, of several the lower one; where
/// thousands of faces overlap, at the first one found in bounded time. This is computed in `float`,
/// relative to the centroid of the surface (\cgalCite{MT97}, polygons as fans from the corner
/// farthest from their centroid, of several the first, with a margin of \f$10^{-6}\f$ in the
/// barycentric coordinates); so distances have relative errors of about \f$10^{-6}\f$.
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
/// Deterministic. With `Parallel_tag` the tree of the rays is built, and they are traced, in
/// parallel, with bitwise equal results.
///
/// Source: thickness \cgalCite{SSC08}.
class Visibility_annotator
{
  using Index = Surface::Index;
  using Hits = internal::Inward_rays::Hits;

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
    const internal::Region_shapes& shapes = rays.shapes();
    for (std::size_t r = 0; r < regions.number_of_parts(); ++r)
      graph[Index(r)].area = shapes.regions[r].area / surface.area();
    set_bends(graph, shapes);
    set_rays(graph, regions, rays.hits(), surface.length_unit());
  }

private:
  template <typename Graph>
  static void set_bends(Graph& graph, const internal::Region_shapes& shapes)
  {
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      const Index i = graph.source(*range.first), j = graph.target(*range.first);
      const internal::Region_shape &a = shapes.regions[i], &b = shapes.regions[j];
      const Double_3 &n = a.normal, &m = b.normal;
      const double angle = std::atan2(norm(cross(n, m)), dot(n, m));
      const bool is_concave = dot(m - n, b.centroid - a.centroid) < 0;
      Visibility_section_data& section = graph[*range.first];
      section.bend = section.length * (is_concave ? angle : -angle);
    }
  }

  template <typename Graph>
  static void set_rays(Graph& graph, const Partition& regions, const std::vector<Hits>& hits,
                       double unit)
  {
    clear_visibility(graph);
    std::vector<Mean> thickness(regions.number_of_parts());
    for (std::size_t r = 0; r < regions.number_of_parts(); ++r)
      for (const internal::Ray_tree::Hit& hit : hits[r])
        if (hit.face != internal::Ray_tree::no_face) {
          thickness[r].add(std::log(hit.distance / unit + 1e-4));
          add_ray(graph, Index(r), regions[hit.face],
                  graph[Index(r)].area /
                    double(internal::Inward_rays::number_of_rays(graph[Index(r)].area)));
        }
    set_thickness(graph, thickness);
  }

  /// Makes a second annotation of a graph have no effect.
  template <typename Graph>
  static void clear_visibility(Graph& graph)
  {
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      graph[*range.first].visibility = 0;
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      graph[*range.first].visibility = 0;
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

  struct Mean
  {
    double sum = 0;
    std::size_t number = 0;

    void add(double value)
    {
      sum += value;
      ++number;
    }
    double value_or(double otherwise) const
    {
      return number > 0 ? sum / double(number) : otherwise;
    }
  };

  template <typename Graph>
  static void set_thickness(Graph& graph, const std::vector<Mean>& thickness)
  {
    Mean of_regions;
    for (const Mean& of_region : thickness)
      if (of_region.number > 0)
        of_regions.add(of_region.value_or(0));
    for (std::size_t r = 0; r < thickness.size(); ++r) {
      Visibility_region_data& region = graph[Index(r)];
      region.log_thickness = region.area * thickness[r].value_or(of_regions.value_or(0));
    }
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_ANNOTATOR_H
