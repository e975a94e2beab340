// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SIGHT_H
#define CGAL_REGION_SEGMENTATION_SIGHT_H

#include <CGAL/Region_segmentation/internal/Inward_rays.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/part_and_cut_data.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// looks from every region inwards: how thick the body is there, and which regions the rays end in. A
/// model of `GraphAnnotator`, for graphs with `Part_data` and `Cut_data`.
///
/// From three faces of each region, that at its centroid, and those at 3/10 and 6/10 in the order of
/// the distance to it, six rays go into the body: one against the normal, and five on a spiral in a
/// cone of 0.9 rad around it. A region of one or two faces sends as many rays, from those.
/// - The *thickness* of a region is the mean of \f$\ln(x / \sqrt{A} + 10^{-4})\f$, \f$x\f$ the lengths of
///   its rays; that of a region whose rays all leave the body is the mean of the others.
/// - Each ray joins the region where it starts to the one where it ends, with the share of the area
///   that it stands for. Opposite sides of a limb see each other; two limbs do not. Two regions
///   without a common border that see each other get a section of no edges, which is never merged
///   across, and counts when their unions meet.
///
/// It makes all lengths relative to \f$\sqrt{A}\f$ and areas to \f$A\f$, the area of the surface.
///
/// Complexity: O(F log F + 18 R log F) in practice. Deterministic.
///
/// Source: thickness, Shapira, Shamir, Cohen-Or 2008.
class Sight
{
  using Index = Flat_mesh::Index;
  using Vector_3 = internal::Vector_3;

public:
  static constexpr Flat_mesh::Content content = Flat_mesh::Content::ANGLES_AND_POINTS;

  /// With `Parallel_tag` the rays are traced in parallel.
  template <typename Graph, typename ConcurrencyTag = CGAL::Sequential_tag>
  void operator()(Graph& graph, const Flat_mesh& mesh, const Region_labels& regions,
                  ConcurrencyTag = ConcurrencyTag()) const
  {
    const Shapes shapes(mesh, regions);
    if (shapes.total_area == 0)
      return;
    make_relative(graph, shapes.total_area);
    add_bends(graph, shapes);
    internal::Inward_rays rays(mesh, regions, shapes.centroids);
    add_rays(graph, regions, rays.trace<ConcurrencyTag>(), shapes);
  }

private:
  /// Area, area vector and centroid of every region.
  struct Shapes
  {
    double total_area = 0;
    std::vector<double> areas;
    std::vector<Vector_3> normals, centroids;

    Shapes(const Flat_mesh& mesh, const Region_labels& regions)
      : areas(regions.number_of_regions)
      , normals(regions.number_of_regions)
      , centroids(regions.number_of_regions)
    {
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
        const Index r = regions.of_face[f];
        const double area = mesh.area(f);
        total_area += area;
        areas[r] += area;
        normals[r] = normals[r] + area * mesh.normal(f);
        centroids[r] = centroids[r] + area * (mesh.centroid(f) - mesh.point(0));
      }
      for (std::size_t r = 0; r < areas.size(); ++r) {
        const double length = norm(normals[r]);
        normals[r] = length > 0 ? (1 / length) * normals[r] : Vector_3{};
        centroids[r] = areas[r] > 0 ? mesh.point(0) + (1 / areas[r]) * centroids[r] : mesh.point(0);
      }
    }
  };

  template <typename Graph>
  static void make_relative(Graph& graph, double total_area)
  {
    const double unit = std::sqrt(total_area);
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      graph[*range.first].area /= total_area;
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      Cut_data& cut = graph[*range.first];
      cut.length /= unit;
      cut.concave /= unit;
      cut.convex /= unit;
    }
  }

  template <typename Graph>
  static void add_bends(Graph& graph, const Shapes& shapes)
  {
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      const Index i = graph.source(*range.first), j = graph.target(*range.first);
      const Vector_3 &n = shapes.normals[i], &m = shapes.normals[j];
      const double angle = std::atan2(norm(cross(n, m)), dot(n, m));
      const bool is_concave = dot(m - n, shapes.centroids[j] - shapes.centroids[i]) < 0;
      Cut_data& cut = graph[*range.first];
      cut.bend = cut.length * (is_concave ? angle : -angle);
    }
  }

  template <typename Graph>
  static void add_rays(Graph& graph, const Region_labels& regions,
                       const std::vector<internal::Inward_rays::Hits>& hits, const Shapes& shapes)
  {
    const double unit = std::sqrt(shapes.total_area);
    std::vector<std::pair<double, std::size_t>> thickness(regions.number_of_regions); // sum, hits
    for (std::size_t r = 0; r < regions.number_of_regions; ++r)
      for (const internal::Ray_tree::Hit& hit : hits[r])
        if (hit.face != internal::Ray_tree::no_face) {
          thickness[r].first += std::log(hit.distance / unit + 1e-4);
          ++thickness[r].second;
          add_ray(graph, Index(r), regions.of_face[hit.face],
                  graph[Index(r)].area / double(internal::Inward_rays::rays_per_region));
        }
    set_thickness(graph, thickness);
  }

  template <typename Graph>
  static void add_ray(Graph& graph, Index from, Index to, double weight)
  {
    graph[from].sight += weight;
    graph[to].sight += weight;
    if (from == to)
      return;
    auto section = graph.section(from, to);
    if (!section)
      section = graph.add_section(from, to);
    graph[*section].sight += weight;
  }

  template <typename Graph>
  static void set_thickness(Graph& graph,
                            const std::vector<std::pair<double, std::size_t>>& thickness)
  {
    double sum = 0;
    std::size_t count = 0;
    for (const auto& [of_region, hits] : thickness)
      if (hits > 0) {
        sum += of_region / double(hits);
        ++count;
      }
    const double mean = count > 0 ? sum / double(count) : 0;
    for (std::size_t r = 0; r < thickness.size(); ++r) {
      const auto& [of_region, hits] = thickness[r];
      Part_data& part = graph[Index(r)];
      part.thickness = part.area * (hits > 0 ? of_region / double(hits) : mean);
    }
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SIGHT_H
