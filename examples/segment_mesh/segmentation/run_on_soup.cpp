// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_method.h"

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace segment_mesh {

namespace {

/// The seeds of faces; none if the list is empty.
struct Seeds_of_faces
{
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Seeds_of_faces& map, std::size_t f)
  {
    return map.seeds->empty() ? no_seed : (*map.seeds)[f];
  }

  const std::vector<std::size_t>* seeds;
};

} // namespace

Segmentation run_on_soup(const Polygon_soup& soup, const Marks& marks,
                         const Segmentation_settings& settings, const Progress_listener& listener)
{
  const auto segment = [&](const auto& np, Segmentation& result) {
    return RS::segment_polygon_soup<CGAL::Parallel_if_available_tag>(
      soup.points, soup.polygons, result.segment_of_face,
      np
        .region_map(boost::make_iterator_property_map(
          result.region_of_face.begin(), boost::typed_identity_property_map<std::size_t>()))
        .constrained_edges(marks.constrained_edges)
        .face_seed_map(Seeds_of_faces{&marks.seed_of_face}));
  };
  return run_method(soup.polygons.size(), segment, settings, listener);
}

} // namespace segment_mesh
