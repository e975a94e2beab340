// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_SCALAR_COST_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_SCALAR_COST_H

#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Extends the data of a region by the mean of a scalar of its faces. A model of `RegionData`.
///
/// \tparam Base a model of `RegionData` that is a class
template <typename Base>
struct Scalar_region_data : Base
{
  double scalar = 0;         ///< integral over the area of the faces
  double area_of_scalar = 0; ///< the area of the faces, in squared units of `Surface::unit()`

  /// The mean over the area, or 0 if the area is 0.
  double mean_scalar() const { return area_of_scalar > 0 ? scalar / area_of_scalar : 0; }

  /// Adds the region on the other side of a section.
  template <typename SectionData>
  void absorb(const Scalar_region_data& other, const SectionData& between)
  {
    Base::absorb(other, between);
    scalar += other.scalar;
    area_of_scalar += other.area_of_scalar;
  }
};

/// \ingroup PkgRegionSegmentationAnnotators
/// adds a scalar of the user's faces, such as curvature, color or temperature, to the data of
/// another annotator, for `Scalar_cost` or a cost of the user's: for graphs with
/// `Scalar_region_data`.
///
/// \code
/// const RS::Superfacet_merging method{RS::Scalar_annotator(RS::face_values(mesh, temperature)),
///                                     RS::Lowest_cost_first(RS::Scalar_cost(2)),
///                                     RS::Number_from_costs(-19.5)};
/// RS::segment(mesh, segment_id, RS::parameters::number_of_segments(8).method(method));
/// \endcode
///
/// Complexity: that of `Base`, and O(F). Copies share the values, 8 bytes per face.
///
/// \tparam Base the other annotator
template <typename Base = Visibility_annotator>
class Scalar_annotator : public Base
{
public:
  using RegionData = Scalar_region_data<typename Base::RegionData>;
  using SectionData = typename Base::SectionData;

  /// `values`: by face in iteration order, as `face_values()` gives them
  template <typename Number>
  explicit Scalar_annotator(const std::vector<Number>& values, Base annotator = Base())
    : Base(std::move(annotator))
    , m_values(std::make_shared<const std::vector<double>>(values.begin(), values.end()))
  {
    static_assert(std::is_arithmetic<Number>::value, "the scalar of a face is a number");
  }

  /// Fills the scalar of each region, and calls the annotator `Base` with the same arguments.
  /// \throws Invalid_input if there is not one value for each face, or one is not finite
  template <typename Graph, typename... Rest>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Rest&... rest) const
  {
    check_values(surface);
    for (std::uint32_t r = 0; r < regions.number_of_parts(); ++r)
      graph[r].scalar = graph[r].area_of_scalar = 0;
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      graph[regions[f]].scalar += surface.area(f) * (*m_values)[f];
      graph[regions[f]].area_of_scalar += surface.area(f);
    }
    Base::operator()(graph, surface, regions, rest...);
  }

private:
  void check_values(const Surface& mesh) const
  {
    if (m_values->size() != mesh.number_of_faces())
      throw Invalid_input("the Scalar_annotator has " + std::to_string(m_values->size()) +
                          " values for " + std::to_string(mesh.number_of_faces()) + " faces");
    for (std::size_t f = 0; f < m_values->size(); ++f)
      if (!std::isfinite((*m_values)[f]))
        throw Invalid_input("the scalar of face " + std::to_string(f) + " is not finite");
  }

  std::shared_ptr<const std::vector<double>> m_values;
};

/// \ingroup PkgRegionSegmentationPolicies
/// The sum of another cost and of the difference of the mean scalars of the two regions times a
/// weight. A model of `SectionCost`, for graphs annotated by `Scalar_annotator`.
///
/// \tparam Cost the other cost, a model of `SectionCost` that names its data
template <typename Cost = Visibility_cost>
struct Scalar_cost
{
  using RegionData = Scalar_region_data<typename Cost::RegionData>;
  using SectionData = typename Cost::SectionData;

  double weight; ///< the cost of a difference of 1, in the units of `cost`; with `Visibility_cost`,
                 ///< 2 is a large weight
  Cost cost;

  explicit Scalar_cost(double weight_ = 1, Cost cost_ = Cost())
    : weight(weight_)
    , cost(std::move(cost_))
  {}

  /// \throws Invalid_method if a constant is not finite
  void check_constants() const
  {
    internal::check_constant("Scalar_cost: weight", weight, -internal::greatest_finite);
    internal::check_constants(cost);
  }

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return cost(graph, s) + weight * std::abs(graph[graph.source(s)].mean_scalar() -
                                              graph[graph.target(s)].mean_scalar());
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_SCALAR_COST_H
