// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_CONCEPTS_FACE_GRAPH_ARCHETYPE_H
#define CGAL_REGION_SEGMENTATION_TEST_CONCEPTS_FACE_GRAPH_ARCHETYPE_H

// Meshes with what the concepts ask for and nothing more: a map of points, descriptors that can be
// compared, no function of another concept.

#include "meshes.h"

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace graph_archetypes {

template <typename Kind>
struct Descriptor
{
  std::size_t number = (std::numeric_limits<std::size_t>::max)();

  friend bool operator==(Descriptor a, Descriptor b) { return a.number == b.number; }
  friend bool operator!=(Descriptor a, Descriptor b) { return a.number != b.number; }
  friend bool operator<(Descriptor a, Descriptor b) { return a.number < b.number; }
};
using Vertex = Descriptor<struct Vertex_kind>;
using Halfedge = Descriptor<struct Halfedge_kind>;
using Edge = Descriptor<struct Edge_kind>;
using Face = Descriptor<struct Face_kind>;

template <typename Key>
struct Make_key
{
  Key operator()(std::size_t number) const { return {number}; }
};
template <typename Key>
using Iterator = boost::transform_iterator<Make_key<Key>, boost::counting_iterator<std::size_t>>;

template <typename Key>
CGAL::Iterator_range<Iterator<Key>> first_keys(std::size_t n)
{
  return {Iterator<Key>(boost::counting_iterator<std::size_t>(0)),
          Iterator<Key>(boost::counting_iterator<std::size_t>(n))};
}

/// A model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`.
class Graph
{
public:
  explicit Graph(const test::Surface_mesh& mesh)
    : mesh(mesh)
  {}
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  const test::Surface_mesh& mesh;
};

/// One of `EdgeListGraph`, too.
class Graph_with_edges : public Graph
{
  using Graph::Graph;
};

using Mesh = test::Surface_mesh;
inline Mesh::Halfedge_index of(Halfedge h)
{
  return Mesh::Halfedge_index(Mesh::size_type(h.number));
}
inline Halfedge of(Mesh::Halfedge_index h)
{
  return h == Mesh::null_halfedge() ? Halfedge() : Halfedge{std::size_t(h)};
}

inline Vertex target(Halfedge h, const Graph& g)
{
  return {std::size_t(target(of(h), g.mesh))};
}
inline Vertex source(Halfedge h, const Graph& g)
{
  return {std::size_t(source(of(h), g.mesh))};
}
inline Halfedge opposite(Halfedge h, const Graph&)
{
  return {h.number ^ 1};
}
inline Halfedge next(Halfedge h, const Graph& g)
{
  return of(next(of(h), g.mesh));
}
inline Halfedge prev(Halfedge h, const Graph& g)
{
  return of(prev(of(h), g.mesh));
}
inline Edge edge(Halfedge h, const Graph&)
{
  return {h.number / 2};
}
inline Halfedge halfedge(Edge e, const Graph&)
{
  return {2 * e.number};
}
inline Vertex source(Edge e, const Graph& g)
{
  return source(halfedge(e, g), g);
}
inline Vertex target(Edge e, const Graph& g)
{
  return target(halfedge(e, g), g);
}
inline Halfedge halfedge(Vertex v, const Graph& g)
{
  return of(halfedge(Mesh::Vertex_index(Mesh::size_type(v.number)), g.mesh));
}
inline Halfedge halfedge(Face f, const Graph& g)
{
  return of(halfedge(Mesh::Face_index(Mesh::size_type(f.number)), g.mesh));
}
inline Face face(Halfedge h, const Graph& g)
{
  const auto f = face(of(h), g.mesh);
  return f == Mesh::null_face() ? Face() : Face{std::size_t(f)};
}

inline auto vertices(const Graph& g)
{
  return first_keys<Vertex>(num_vertices(g.mesh));
}
inline std::size_t num_vertices(const Graph& g)
{
  return num_vertices(g.mesh);
}
inline auto halfedges(const Graph& g)
{
  return first_keys<Halfedge>(num_halfedges(g.mesh));
}
inline std::size_t num_halfedges(const Graph& g)
{
  return num_halfedges(g.mesh);
}
inline auto faces(const Graph& g)
{
  return first_keys<Face>(num_faces(g.mesh));
}
inline std::size_t num_faces(const Graph& g)
{
  return num_faces(g.mesh);
}
inline auto edges(const Graph_with_edges& g)
{
  return first_keys<Edge>(num_edges(g.mesh));
}
inline std::size_t num_edges(const Graph_with_edges& g)
{
  return num_edges(g.mesh);
}

/// The points of the vertices.
struct Point_map
{
  using key_type = Vertex;
  using value_type = Mesh::Point;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Mesh* mesh;

  friend value_type get(const Point_map& map, Vertex v)
  {
    return map.mesh->point(Mesh::Vertex_index(Mesh::size_type(v.number)));
  }
};

inline Point_map get(CGAL::vertex_point_t, const Graph& g)
{
  return {&g.mesh};
}

/// An index map that is only read.
template <typename Key>
struct Index_map
{
  using key_type = Key;
  using value_type = std::size_t;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(Index_map, Key key) { return key.number; }
};

/// Values in a vector; a map that can be read, or one that can be written, has no more.
template <typename Key, typename Value>
struct Values
{
  explicit Values(std::size_t n, Value value = Value())
    : values(std::make_shared<std::vector<Value>>(n, value))
  {}
  std::shared_ptr<std::vector<Value>> values;

  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  friend Value get(const Values& map, Key key) { return (*map.values)[key.number]; }
  friend void put(const Values& map, Key key, const Value& value)
  {
    (*map.values)[key.number] = value;
  }
};

} // namespace graph_archetypes

namespace boost {

template <>
struct graph_traits<graph_archetypes::Graph>
{
  using vertex_descriptor = graph_archetypes::Vertex;
  using halfedge_descriptor = graph_archetypes::Halfedge;
  using edge_descriptor = graph_archetypes::Edge;
  using face_descriptor = graph_archetypes::Face;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = boost::vertex_list_graph_tag;
  using vertex_iterator = graph_archetypes::Iterator<vertex_descriptor>;
  using halfedge_iterator = graph_archetypes::Iterator<halfedge_descriptor>;
  using face_iterator = graph_archetypes::Iterator<face_descriptor>;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct graph_traits<graph_archetypes::Graph_with_edges> : graph_traits<graph_archetypes::Graph>
{
  using edge_iterator = graph_archetypes::Iterator<edge_descriptor>;
  using edges_size_type = std::size_t;
};

template <>
struct property_map<graph_archetypes::Graph, CGAL::vertex_point_t>
{
  using type = graph_archetypes::Point_map;
  using const_type = type;
};
template <>
struct property_map<graph_archetypes::Graph_with_edges, CGAL::vertex_point_t>
  : property_map<graph_archetypes::Graph, CGAL::vertex_point_t>
{};

} // namespace boost

namespace CGAL {
template <>
struct graph_has_property<graph_archetypes::Graph, vertex_point_t> : CGAL::Tag_true
{};
template <>
struct graph_has_property<graph_archetypes::Graph_with_edges, vertex_point_t> : CGAL::Tag_true
{};
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TEST_CONCEPTS_FACE_GRAPH_ARCHETYPE_H
