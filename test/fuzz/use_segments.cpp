// SPDX-License-Identifier: GPL-3.0-or-later

// Any 2-manifold with any labels: what comes after a segmentation agrees with a look at every edge.
// And a `Segmenter` that is given constraints and seeds in any order.

#include "Bytes.h"
#include "mesh_from.h"
#include "require.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/region_segmentation.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

using Edges = std::vector<char>;

auto edge_map(const Mesh& mesh, Edges& edges)
{
  return boost::make_iterator_property_map(edges.begin(), get(boost::edge_index, mesh));
}

bool is_between_segments(const Mesh& mesh, const Labels& labels, Mesh::Edge_index e)
{
  const auto h = mesh.halfedge(e);
  const Mesh::Face_index a = mesh.face(h), b = mesh.face(mesh.opposite(h));
  return a != Mesh::null_face() && b != Mesh::null_face() && labels[a] != labels[b];
}

void check_borders(const Mesh& mesh, Labels& labels)
{
  Edges marked(mesh.number_of_edges());
  const std::size_t n = RS::mark_segment_borders(mesh, face_map(mesh, labels),
                                                 edge_map(mesh, marked));
  std::size_t expected = 0;
  for (const auto e : mesh.edges()) {
    require(bool(marked[e]) == is_between_segments(mesh, labels, e),
            "edges between segments are marked");
    expected += marked[e] != 0;
  }
  require(n == expected, "marked edges are counted");

  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, face_map(mesh, labels), std::back_inserter(borders));
  std::set<Mesh::Edge_index> seen;
  for (const auto& border : borders)
    for (const auto h : border.halfedges) {
      require(marked[mesh.edge(h)] && seen.insert(mesh.edge(h)).second,
              "each marked edge is in one polyline");
      require(labels[mesh.face(h)] == border.segment &&
                labels[mesh.face(mesh.opposite(h))] == border.opposite_segment,
              "a polyline has one segment on each side");
    }
  require(seen.size() == n, "all marked edges are in polylines");
}

void check_pieces(const Mesh& mesh, Labels& labels)
{
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_map(mesh, labels), std::back_inserter(pieces));
  std::vector<RS::Segment_topology<std::size_t>> topologies;
  RS::compute_segment_topology(mesh, face_map(mesh, labels), std::back_inserter(topologies));
  require(pieces.size() == topologies.size(), "as many topologies as pieces");
  std::size_t number_of_faces = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Mesh& piece = pieces[i].mesh;
    number_of_faces += piece.number_of_faces();
    require(piece.is_valid(false), "a piece is a 2-manifold");
    require(pieces[i].segment == topologies[i].segment, "the same order");
    const long euler = long(piece.number_of_vertices()) - long(piece.number_of_edges()) +
                       long(piece.number_of_faces());
    require(euler == topologies[i].euler_characteristic,
            "the Euler characteristic is that of the piece");
  }
  require(number_of_faces == mesh.number_of_faces(), "every face is in one piece");
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> solids;
  RS::close_segments(mesh, face_map(mesh, labels), std::back_inserter(solids));
  for (const auto& solid : solids)
    require(solid.mesh.is_valid(false) && CGAL::is_closed(solid.mesh),
            "a solid is a closed 2-manifold");
}

void check_cut_pieces(const Mesh& mesh, Labels& labels)
{
  Edges cut(mesh.number_of_edges());
  for (std::size_t e = 0; e < cut.size(); ++e)
    cut[e] = e * e / 5 % 3 == 0;
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_map(mesh, labels), std::back_inserter(pieces),
                          RS::parameters::edge_is_constrained_map(edge_map(mesh, cut)));
  for (const auto& piece : pieces)
    require(piece.mesh.is_valid(false), "a piece that is cut open is a 2-manifold");
  try {
    RS::smooth_borders(mesh, face_map(mesh, labels));
    require(has_only_finite_points(mesh), "a point that is not finite is refused");
  } catch (const RS::Invalid_input& error) {
    require(!has_only_finite_points(mesh), error.what());
  }
}

template <typename Method>
void check_segmenter(const Mesh& mesh, const Method& method, Bytes& bytes)
{
  Labels labels(mesh.number_of_faces()), fresh(labels), seeds(labels.size(), std::size_t(-1));
  Edges constrained(mesh.number_of_edges());
  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  for (std::size_t change = bytes.below(4); change-- > 0;)
    try {
      if (bytes.below(2) == 0) {
        for (std::size_t i = bytes.below(8); i-- > 0 && !constrained.empty();)
          constrained[bytes.byte() % constrained.size()] = 1;
        segmenter.add_constraints(edge_map(mesh, constrained));
      } else {
        for (std::size_t i = bytes.below(4); i-- > 0 && !seeds.empty();)
          seeds[bytes.byte() % seeds.size()] = bytes.below(3);
        segmenter.set_seeds(face_map(mesh, seeds));
      }
    } catch (const RS::Invalid_input&) { // seeds that cannot be joined
      std::fill(seeds.begin(), seeds.end(), std::size_t(-1));
      segmenter.set_seeds(face_map(mesh, seeds));
    }
  const std::size_t k = 1 + bytes.below(8);
  segmenter.segment(face_map(mesh, labels), k);
  segmenter.segment(face_map(mesh, fresh), 1 + bytes.below(8));
  segmenter.segment(face_map(mesh, fresh), k);
  require(fresh == labels, "the same number, the same labels");
  std::map<std::size_t, std::size_t> segment_of_seed;
  for (std::size_t f = 0; f < seeds.size(); ++f)
    if (seeds[f] != std::size_t(-1))
      require(segment_of_seed.emplace(seeds[f], labels[f]).first->second == labels[f],
              "equal seeds are in one segment");
  std::set<std::size_t> segments;
  for (const auto& [seed, segment] : segment_of_seed)
    require(segments.insert(segment).second, "different seeds are in different segments");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const std::size_t choice = bytes.byte(), number_of_labels = 1 + choice % 6; // one byte, as in
                                                                              // segment_mesh.cpp
  Bytes changes(data, (std::min)(size, std::size_t(32)));
  const Mesh mesh = mesh_from(bytes);
  if (!has_only_manifold_vertices(mesh))
    return 0;
  Labels labels(mesh.number_of_faces());
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = (f * f + choice) / 7 % number_of_labels;
  check_borders(mesh, labels);
  check_pieces(mesh, labels);
  check_cut_pieces(mesh, labels);
  if (has_only_finite_points(mesh)) {
    check_segmenter(mesh, RS::Learned_merging(), changes);
    check_segmenter(mesh, RS::Smooth_faces(), changes);
  }
  return 0;
}
