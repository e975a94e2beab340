// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ANY_SEGMENTER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ANY_SEGMENTER_H

#include "soup/Polygon_soup.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

namespace segment_mesh {

/// A soup that is prepared by the method of a name, for the modules of other languages.
class Any_segmenter
{
  template <typename Method>
  using Segmenter = CGAL::Region_segmentation::Polygon_soup_segmenter<Method>;
  using Variant = std::variant<Segmenter<CGAL::Region_segmentation::Learned_merging>,
                               Segmenter<CGAL::Region_segmentation::Visibility_merging>,
                               Segmenter<CGAL::Region_segmentation::Two_step>,
                               Segmenter<CGAL::Region_segmentation::Smooth_faces>>;

public:
  /// `tolerance`: of smooth-faces; `np`: named parameters of the segmenter, without its method
  template <typename NamedParameters>
  Any_segmenter(const std::string& method, double tolerance, const Polygon_soup& soup,
                const NamedParameters& np)
    : m_segmenter(prepare(method, tolerance, soup, np))
  {}

  /// Writes the labels of a number of segments, or of one that the method chooses.
  template <typename Labels, typename NamedParameters>
  void segment(std::optional<std::size_t> number, Labels& labels, const NamedParameters& np) const
  {
    if (number)
      std::visit([&](const auto& s) { s.segment(labels, *number, np); }, m_segmenter);
    else
      with_tree("needs the number of segments", [&](const auto& s) { s.segment(labels); });
  }

  /// Calls `f(segmenter)`, unless the method merges anew for each number.
  /// \throws std::invalid_argument that says `why_not`
  template <typename F>
  void with_tree(const char* why_not, const F& f) const
  {
    std::visit(
      [&](const auto& segmenter) {
        if constexpr (std::decay_t<decltype(segmenter)>::needs_number)
          throw std::invalid_argument(std::string("method two-step ") + why_not);
        else
          f(segmenter);
      },
      m_segmenter);
  }

private:
  template <typename NamedParameters>
  static Variant prepare(const std::string& method, double tolerance, const Polygon_soup& soup,
                         const NamedParameters& np)
  {
    namespace RS = CGAL::Region_segmentation;
    const auto by = [&](const auto& m) -> Variant {
      return RS::Polygon_soup_segmenter(soup.points, soup.polygons, np.method(m),
                                        CGAL::Parallel_if_available_tag());
    };
    if (method == "learned")
      return by(RS::Learned_merging());
    if (method == "visibility")
      return by(RS::Visibility_merging());
    if (method == "two-step")
      return by(RS::Two_step());
    if (method == "smooth-faces") {
      RS::Smooth_faces smooth_faces;
      smooth_faces.tolerance = tolerance;
      return by(smooth_faces);
    }
    throw std::invalid_argument("method: not learned, visibility, two-step or smooth-faces");
  }

  Variant m_segmenter;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_ANY_SEGMENTER_H
