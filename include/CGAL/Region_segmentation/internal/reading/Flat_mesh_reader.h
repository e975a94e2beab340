// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_READER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_READER_H

#include <CGAL/Region_segmentation/internal/reading/Edge_constraints.h>
#include <CGAL/Region_segmentation/internal/reading/Face_reader.h>
#include <CGAL/Region_segmentation/internal/reading/Flat_mesh_builder.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Vertex_points.h>
#include <CGAL/Region_segmentation/internal/reading/find_unit.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reads a face graph into a `Flat_mesh`: once, and the corners of a large one again if the points are wanted.
///
/// The dual edges of a face, those to lower faces, require the normals of these faces and an offset. Sequentially both
/// are known. In parallel the edges are counted first; each thread reads ranges of blocks, and if an edge leads to a
/// face below the range, values that require its normal are computed at the end.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
class Flat_mesh_reader
{
  using Faces = Face_reader<FaceGraph, Pack>;
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using halfedge_descriptor = typename Traversal::halfedge_descriptor;
  using Constraints = Edge_constraints<FaceGraph, Pack>;

public:
  /// While the patches of a large mesh are made, there is more in memory than in any later stage: its points and corners are
  /// stored afterwards, and centroids computed from them, not stored. Reading the corners again takes 137 instructions per
  /// face, the centroids some 260.
  static constexpr std::size_t most_faces_with_early_corners = std::size_t(3) << 19;

  /// \throws Invalid_input if a point is not finite
  Flat_mesh_reader(const Traversal& traversal, const Pack& np, Mesh_data data,
                   const Execution<ConcurrencyTag>& execution,
                   std::size_t most_with_early_corners = most_faces_with_early_corners)
    : m_traversal(traversal)
    , m_execution(execution)
    , m_data(data)
    , m_corners(!includes(data, Mesh_data::POINTS)                        ? Corners::NOT_WANTED
                : traversal.number_of_faces() <= most_with_early_corners ? Corners::WITH_FACES
                                                                         : Corners::AFTER_PATCHES)
    , m_unit(find_unit<ConcurrencyTag>(traversal, np))
    , m_points(traversal.mesh(), np, 1 / m_unit)
    , m_faces(traversal, m_points)
    , m_is_constrained(np)
    , m_builder(traversal.number_of_faces(), num_halfedges(traversal.mesh()) / 2, data, m_unit)
  {}

  Flat_mesh read()
  {
    const bool with_patches = includes(m_data, Mesh_data::PATCHES);
    const double after_patches = m_corners == Corners::AFTER_PATCHES ? 0.9 : 1; // of the time
    const double after_faces = with_patches ? 0.4 : after_patches;
    std::vector<Place> places(number_of_blocks(m_traversal.number_of_faces()));
    if (m_corners == Corners::WITH_FACES) {
      m_builder.resize_points(m_traversal.number_of_vertices(), num_halfedges(m_traversal.mesh()));
      read_points(Execution<ConcurrencyTag>());
    }
    Place end;
    if constexpr (Execution<ConcurrencyTag>::is_parallel)
      end = read_in_parallel(places, m_execution.step(0, after_faces));
    else
      end = read_in_sequence(places, m_execution.step(0, after_faces));
    m_builder.set_number_of_edges(end.edge);
    set_constraints();
    turn_components(2 * end.edge == end.corner);
    m_builder.finish(m_corners == Corners::AFTER_PATCHES, m_execution.step(after_faces, after_patches));
    if (m_corners == Corners::AFTER_PATCHES) {
      m_builder.resize_points(m_traversal.number_of_vertices(), end.corner);
      read_points(m_execution.step(after_patches, after_patches + 0.03));
      read_corners(places, m_execution.step(after_patches + 0.03, 1));
    }
    m_builder.template set_centers_of_patches<ConcurrencyTag>();
    m_execution.report(1);
    return m_builder.take();
  }

private:
  /// When points and corners are stored.
  enum class Corners { NOT_WANTED, WITH_FACES, AFTER_PATCHES };

  /// Offsets of the data of the faces of a block in the arrays.
  struct Place
  {
    std::size_t edge, corner;
  };

  using Late_edges = std::vector<Flat_mesh_builder::Late_edge>;

  /// Sets the place of every block. Returns the numbers of dual edges and of corners.
  Place read_in_sequence(std::vector<Place>& places, const Execution<ConcurrencyTag>& execution)
  {
    Place end = {0, 0};
    Face_block faces;
    Late_edges none;
    Step_counter<ConcurrencyTag> blocks(execution, places.size());
    for (std::size_t block = 0; block < places.size(); ++block) {
      places[block] = end;
      const std::size_t edges = read_block(block, end, 0, faces, none);
      end = {end.edge + edges, end.corner + faces.number_of_corners()};
      blocks.advance();
    }
    return end;
  }

  /// As above.
  Place read_in_parallel(std::vector<Place>& places, const Execution<ConcurrencyTag>& execution)
  {
    const Place end = count_edges_and_corners(places, execution.step(0, 0.2));
    std::vector<Late_edges> late_edges(number_of_blocks(places.size(), blocks_in_range));
    for_each_block(
      execution.step(0.2, 0.9), places.size(),
      [&](std::size_t range, std::size_t first_block, std::size_t last_block) {
        Face_block faces;
        for (std::size_t block = first_block; block < last_block; ++block)
          read_block(block, places[block], first_block * block_size, faces, late_edges[range]);
      },
      blocks_in_range);
    for_each_block(
      execution.step(0.9, 1), late_edges.size(),
      [&](std::size_t range, std::size_t, std::size_t) {
        for (const auto& edge : late_edges[range])
          m_builder.set_late_edge(edge);
      },
      1);
    return end;
  }

  /// Computes the offset of every block, and that past the last one.
  Place count_edges_and_corners(std::vector<Place>& places, const Execution<ConcurrencyTag>& execution) const
  {
    for_each_block(
      execution, m_traversal.number_of_faces(), [&](std::size_t block, std::size_t rank, std::size_t) {
        const FaceGraph& mesh = m_traversal.mesh();
        const auto rank_of_face = m_traversal.rank_of_face();
        Place size = {0, 0};
        for (auto f : m_traversal.faces_of_block(block)) {
          const halfedge_descriptor start = halfedge(f, mesh);
          halfedge_descriptor h = start;
          do {
            const auto across = face(opposite(h, mesh), mesh);
            size.edge += across != boost::graph_traits<FaceGraph>::null_face() && rank_of_face(across) < rank;
            ++size.corner;
            h = next(h, mesh);
          } while (h != start);
          ++rank;
        }
        places[block] = size;
      });
    Place end = {0, 0};
    for (Place& place : places) {
      const Place size = std::exchange(place, end);
      end = {end.edge + size.edge, end.corner + size.corner};
    }
    return end;
  }

  /// Closed components that are inside out are turned. Finding components takes 11 % of the instructions of two-step, so
  /// without patches this is done only if a closed surface has a signed volume below 0.
  void turn_components(bool is_closed)
  {
    if (!includes(m_data, Mesh_data::PATCHES) && !(is_closed && m_builder.volume() < 0))
      return;
    if (!is_closed)
      mark_open_faces();
    m_builder.template turn_components<ConcurrencyTag>();
  }

  void mark_open_faces()
  {
    const FaceGraph& mesh = m_traversal.mesh();
    for_each_block(Execution<ConcurrencyTag>(), m_traversal.number_of_faces(),
                   [&](std::size_t block, std::size_t rank, std::size_t) {
                     for (auto f : m_traversal.faces_of_block(block)) {
                       for (halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
                         if (CGAL::is_border(opposite(h, mesh), mesh))
                           m_builder.set_open(rank);
                       ++rank;
                     }
                   });
  }

  void read_points(const Execution<ConcurrencyTag>& execution)
  {
    for_each_block(execution, m_traversal.number_of_vertices(), [&](std::size_t block, std::size_t rank, std::size_t) {
      for (auto v : m_traversal.vertices_of_block(block))
        m_builder.set_point(rank++, m_points(v));
    });
  }

  void read_corners(const std::vector<Place>& places, const Execution<ConcurrencyTag>& execution)
  {
    for_each_block(
      execution, places.size(),
      [&](std::size_t, std::size_t first_block, std::size_t last_block) {
        Face_block faces;
        for (std::size_t block = first_block; block < last_block; ++block) {
          m_faces.read(block, faces);
          m_builder.set_corners(places[block].corner, faces);
        }
      },
      blocks_in_range);
  }

  /// Reads the faces of a block, and their edges to `place`. Returns the number of edges.
  std::size_t read_block(std::size_t block, const Place& place, std::size_t first_known_face, Face_block& faces,
                         Late_edges& late_edges)
  {
    m_faces.read(block, faces);
    faces.for_each_area_vector([this](std::size_t face, const Double_3& point, const Double_3& area_vector,
                                      double squared_longest_edge) {
      m_builder.set_face(face, point, area_vector, squared_longest_edge);
    });
    if (includes(m_data, Mesh_data::CENTROIDS))
      m_builder.set_centroids(faces);
    if (m_corners == Corners::WITH_FACES)
      m_builder.set_corners(place.corner, faces);
    const std::size_t number = faces.collect_edges();
    m_builder.set_edges(place.edge, faces, first_known_face, late_edges);
    return number;
  }

  /// In a pass of its own, since few edges are constrained: to know the dual edges of all faces takes a third of the reading.
  void set_constraints()
  {
    if constexpr (Constraints::are_possible)
      m_traversal.for_each_dual_edge_if(
        m_builder.flat(), m_is_constrained,
        [this](halfedge_descriptor, std::size_t dual_edge) { m_builder.set_constrained(dual_edge); });
  }

  const Traversal& m_traversal;
  const Execution<ConcurrencyTag>& m_execution;
  const Mesh_data m_data;
  const Corners m_corners;
  const double m_unit;
  const Vertex_points<FaceGraph, Pack> m_points;
  const Faces m_faces;
  const Constraints m_is_constrained;
  Flat_mesh_builder m_builder;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FLAT_MESH_READER_H
