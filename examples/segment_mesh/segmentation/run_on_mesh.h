// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H

#include "segmentation/run_method.h"

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Whether an edge is one of a sorted list of pairs of points.
template <typename Mesh>
struct Edge_is_constrained_map
{
  using key_type = typename boost::graph_traits<Mesh>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  friend bool get(const Edge_is_constrained_map& map, const key_type& e)
  {
    if (map.edges->empty())
      return false;
    const auto index = get(boost::vertex_index, *map.mesh);
    Vertex_pair edge = {get(index, source(e, *map.mesh)), get(index, target(e, *map.mesh))};
    std::sort(edge.begin(), edge.end());
    return std::binary_search(map.edges->begin(), map.edges->end(), edge);
  }

  const Mesh* mesh;
  const std::vector<Vertex_pair>* edges;
};

/// The seeds of faces; none if the list is empty.
template <typename Mesh>
struct Face_seed_map
{
  using key_type = typename boost::graph_traits<Mesh>::face_descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Face_seed_map& map, const key_type& f)
  {
    return map.seeds->empty() ? no_seed : (*map.seeds)[get(boost::face_index, *map.mesh, f)];
  }

  const Mesh* mesh;
  const std::vector<std::size_t>* seeds;
};

/// \pre the indices of faces and vertices are those of the soup that the mesh was made of
template <typename Mesh>
Segmentation run_on_mesh(const Mesh& mesh, const Marks& marks,
                         const Segmentation_settings& settings, const Progress_listener& listener)
{
  const auto face_map = [&](std::vector<std::size_t>& labels) {
    return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
  };
  const auto segment = [&](const auto& np, Segmentation& result) {
    return RS::segment<CGAL::Parallel_tag>(
      mesh, face_map(result.segment_of_face),
      np.region_map(face_map(result.region_of_face))
        .edge_is_constrained_map(Edge_is_constrained_map<Mesh>{&mesh, &marks.constrained_edges})
        .face_seed_map(Face_seed_map<Mesh>{&mesh, &marks.seed_of_face}));
  };
  return run_method(num_faces(mesh), segment, settings, listener);
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
