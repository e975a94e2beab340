// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MESH_ORDER_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MESH_ORDER_H

#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Descriptor>
using Has_idx = decltype(std::size_t(std::declval<const Descriptor&>().idx()));
template <typename Descriptor>
using Has_id = decltype(std::size_t(std::declval<const Descriptor&>()->id()));

/// The number of an element of a mesh: from the index map that a pack of named parameters has under
/// a tag, or else the number that the descriptor or the element itself has. Nothing is written to
/// the mesh: the ids of a const polyhedron stay as they are.
template <typename Tag, typename Pack>
class Number_in
{
public:
  explicit Number_in(const Pack& np)
    : m_map(CGAL::parameters::get_parameter(np, Tag()))
  {}

  /// Whether all elements have different numbers, as a map of the user and the descriptors of
  /// `Surface_mesh` and OpenMesh give them; ids of elements can be anything.
  template <typename Descriptor>
  static constexpr bool is_reliable = has_parameter<Pack, Tag> || satisfies<Has_idx, Descriptor>;
  template <typename Descriptor>
  static constexpr bool has_numbers = is_reliable<Descriptor> || satisfies<Has_id, Descriptor>;

  template <typename Descriptor>
  std::size_t operator()(const Descriptor& d) const
  {
    if constexpr (has_parameter<Pack, Tag>)
      return std::size_t(get(m_map, d));
    else if constexpr (satisfies<Has_idx, Descriptor>)
      return std::size_t(d.idx());
    else
      return std::size_t(d->id());
  }

private:
  std::decay_t<decltype(CGAL::parameters::get_parameter(std::declval<const Pack&>(), Tag()))> m_map;
};

/// The elements of a range by position, and the position of each element. It is found by the number
/// of the element where the numbers of all elements are different and not too large, else by a hash
/// table of the descriptors. Beside the descriptors this takes 4 bytes an element, unless each
/// number is the position. (If these were always taken, a mesh of 320,000 faces in random order
/// would be read in twice the time.)
///
/// The descriptors are stored since the latencies of traversing a linked list add up, while those
/// of several handles overlap.
template <typename Descriptor, typename NumberOf>
class Iteration_ranks
{
public:
  static constexpr Surface::Index none = Surface::none;

  template <typename Range>
  Iteration_ranks(const Range& range, NumberOf number_of)
    : m_number_of(number_of)
    , m_elements(range.begin(), range.end())
  {
    if constexpr (NumberOf::template has_numbers<Descriptor>)
      if (use_numbers())
        return;
    if constexpr (NumberOf::template is_reliable<Descriptor>)
      CGAL_precondition_msg(false, "an index map has different values");
    else
      for (std::size_t rank = 0; rank < size(); ++rank)
        m_hashed.emplace(m_elements[rank], Surface::Index(rank));
  }

  std::size_t size() const { return m_elements.size(); }
  const std::vector<Descriptor>& elements() const { return m_elements; }

  /// The position of an element; `none` if it is not in the range.
  Surface::Index operator[](const Descriptor& d) const
  {
    if constexpr (!NumberOf::template is_reliable<Descriptor>)
      if (!m_hashed.empty()) {
        const auto found = m_hashed.find(d);
        return found == m_hashed.end() ? none : found->second;
      }
    if constexpr (NumberOf::template has_numbers<Descriptor>) {
      const std::size_t number = m_number_of(d);
      if (m_ranks.empty())
        return number < size() ? Surface::Index(number) : none;
      return number < m_ranks.size() ? m_ranks[number] : none;
    }
    return none;
  }

private:
  /// Returns whether the elements have different numbers that are not much larger than their count.
  bool use_numbers()
  {
    std::size_t largest = 0;
    bool is_position = true;
    for (std::size_t rank = 0; rank < size(); ++rank) {
      const std::size_t number = m_number_of(m_elements[rank]);
      largest = (std::max)(largest, number);
      is_position &= number == rank;
    }
    if (is_position)
      return true;
    if (!NumberOf::template is_reliable<Descriptor> && largest / 8 > size() + 128)
      return false;
    m_ranks.assign(largest + 1, none);
    for (std::size_t rank = 0; rank < size(); ++rank)
      if (std::exchange(m_ranks[m_number_of(m_elements[rank])], Surface::Index(rank)) != none) {
        m_ranks.clear();
        return false;
      }
    return true;
  }

  NumberOf m_number_of;
  std::vector<Descriptor> m_elements;
  Large_array<Surface::Index> m_ranks; // by number; empty if each number is the position
  std::conditional_t<NumberOf::template is_reliable<Descriptor>, std::monostate,
                     boost::unordered_map<Descriptor, Surface::Index>>
    m_hashed; // empty if numbers are used
};

/// The order of the elements of a face graph, which does not depend on its type: faces and vertices
/// are numbered by iteration, and the boundary of a face begins at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_order
{
  using Traits = boost::graph_traits<FaceGraph>;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  static constexpr Surface::Index none = Surface::none;

  /// \throws Invalid_input if there are too many halfedges
  Mesh_order(const FaceGraph& mesh, const Pack& np)
    : m_mesh(mesh)
    , m_faces(faces(mesh), Number_in<CGAL::internal_np::face_index_t, Pack>(np))
    , m_vertices(vertices(mesh), Number_in<CGAL::internal_np::vertex_index_t, Pack>(np))
  {
    if (num_halfedges(mesh) >= none) // corners are counted in 32 bits
      throw Invalid_input("a mesh has fewer than 2^32 - 1 halfedges");
  }

  const FaceGraph& mesh() const { return m_mesh; }
  std::size_t number_of_faces() const { return m_faces.size(); }
  std::size_t number_of_vertices() const { return m_vertices.size(); }

  Surface::Index vertex_rank(vertex_descriptor v) const { return m_vertices[v]; }
  /// The number of the face of a halfedge; `none` at a border.
  Surface::Index face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    return f == Traits::null_face() ? none : m_faces[f];
  }

  /// The halfedge of a face that leaves its vertex of lowest number.
  halfedge_descriptor first_halfedge(face_descriptor f) const
  {
    halfedge_descriptor first = halfedge(f, m_mesh);
    Surface::Index lowest = none;
    for (halfedge_descriptor h : CGAL::halfedges_around_face(first, m_mesh))
      if (const Surface::Index rank = vertex_rank(source(h, m_mesh)); rank < lowest) {
        lowest = rank;
        first = h;
      }
    return first;
  }

  const auto& ordered_faces() const { return m_faces.elements(); }
  const auto& ordered_vertices() const { return m_vertices.elements(); }

private:
  const FaceGraph& m_mesh;
  Iteration_ranks<face_descriptor, Number_in<CGAL::internal_np::face_index_t, Pack>> m_faces;
  Iteration_ranks<vertex_descriptor, Number_in<CGAL::internal_np::vertex_index_t, Pack>> m_vertices;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MESH_ORDER_H
