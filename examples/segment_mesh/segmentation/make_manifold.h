// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_MANIFOLD_H

#include "soup/Polygon_soup.h"

#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace segment_mesh {

/// A soup as an oriented 2-manifold, for what is described by borders and volumes. Faces whose
/// corners are not different are left out, the others are turned, and torn where more than two
/// meet.
template <typename FaceGraph>
struct Manifold_of
{
  using Mesh = FaceGraph;

  Mesh mesh;
  std::vector<std::size_t> face_of_mesh_face;   ///< of the soup
  std::vector<std::size_t> point_of_mesh_point; ///< of the soup

  /// The values of faces of the soup for those of the mesh.
  template <typename Value>
  std::vector<Value> values_of_mesh_faces(const std::vector<Value>& values) const
  {
    std::vector<Value> result;
    result.reserve(face_of_mesh_face.size());
    for (std::size_t f : face_of_mesh_face)
      result.push_back(values[f]);
    return result;
  }
};

/// The halfedges of the polygons of a soup, all in one segment. Their sources are points of the
/// soup.
class Halfedges_of_soup : public CGAL::Region_segmentation::internal::Segmented_halfedges
{
public:
  explicit Halfedges_of_soup(const Polygon_soup& soup)
  {
    namespace RS = CGAL::Region_segmentation;
    const RS::Surface surface = RS::make_surface_of_polygon_soup(
      soup.points, soup.polygons, RS::parameters::component_links(false));
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      if (const std::vector<Index> corners = corners_of(soup.polygons[f], surface);
          std::set<Index>(corners.begin(), corners.end()).size() > 2) {
        source.insert(source.end(), corners.begin(), corners.end());
        add_face();
        faces.push_back(f);
      }
    number_of_vertices = soup.points.size();
    number_of_segments = 1;
    segment_of_face.assign(faces.size(), 0);
    opposite = halfedges_across();
    turn_faces(turned_faces());
    close_slits();
  }

  std::vector<int> labels = {0};  ///< of the segment
  std::vector<std::size_t> faces; ///< of the soup

  std::size_t face_at(Index f) const { return faces[f]; }
  std::size_t vertex_at(Index v) const { return v; }

private:
  /// The merged points at the corners of a polygon, without sides that are points.
  template <typename Surface>
  static std::vector<Index> corners_of(const Polygon_soup::Polygon& polygon, const Surface& surface)
  {
    std::vector<Index> corners;
    for (const std::size_t i : polygon)
      if (const Index v = surface.merged_vertex(i); corners.empty() || corners.back() != v)
        corners.push_back(v);
    while (corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    return corners;
  }

  /// By halfedge, the one of another face with the same ends, in whatever direction, where there is
  /// exactly one.
  std::vector<Index> halfedges_across() const
  {
    std::vector<std::tuple<Index, Index, Index>> sides; // ends, halfedge
    sides.reserve(size());
    for (Index h = 0; h < size(); ++h)
      sides.emplace_back(std::min(source[h], target(h)), std::max(source[h], target(h)), h);
    std::sort(sides.begin(), sides.end());
    std::vector<Index> across(size(), none);
    for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
      const auto [a, b, h] = *begin;
      end = std::find_if(begin, sides.end(), [a = a, b = b](const auto& side) {
        return std::get<0>(side) != a || std::get<1>(side) != b;
      });
      if (const Index g = std::get<2>(*(end - 1)); end - begin == 2 && face[g] != face[h]) {
        across[g] = h;
        across[h] = g;
      }
    }
    return across;
  }

  /// The faces to be turned, so that neighbors have one orientation, that of the first face. Where
  /// this is not possible, they are torn.
  std::vector<char> turned_faces()
  {
    constexpr char unknown = 2;
    std::vector<char> is_turned(number_of_faces(), unknown);
    std::vector<Index> front;
    for (Index seed = 0; seed < number_of_faces(); ++seed) {
      if (is_turned[seed] != unknown)
        continue;
      is_turned[seed] = false;
      for (front = {seed}; !front.empty();) {
        const Index f = front.back();
        front.pop_back();
        for (Index h = first[f]; h < first[f + 1]; ++h) {
          const Index g = opposite[h];
          if (g == none)
            continue;
          const bool wanted = is_turned[f] != (source[g] == source[h]);
          if (is_turned[face[g]] == unknown) {
            is_turned[face[g]] = wanted;
            front.push_back(face[g]);
          } else if (is_turned[face[g]] != wanted)
            opposite[g] = opposite[h] = none;
        }
      }
    }
    return is_turned;
  }

  void turn_faces(const std::vector<char>& is_turned)
  {
    const auto turned = [&](Index h) { // from the last corner to the first
      const Index f = face[h], n = first[f + 1] - first[f];
      return is_turned[f] ? first[f] + (2 * n - 2 - (h - first[f])) % n : h;
    };
    const std::vector<Index> across = opposite;
    for (Index h = 0; h < size(); ++h)
      opposite[turned(h)] = across[h] == none ? none : turned(across[h]);
    for (Index f = 0; f < number_of_faces(); ++f)
      if (is_turned[f])
        std::reverse(source.begin() + first[f], source.begin() + first[f + 1]);
  }

  /// Joins sides that are left alone between the same two fans of faces: where faces that were at
  /// their edge are torn off, and at a bridge from the boundary of a face to that of a hole in it.
  void close_slits()
  {
    const CGAL::Region_segmentation::Partition fan = fans();
    std::map<std::pair<Index, Index>, Index> alone; // by the fans at its ends
    for (Index h = 0; h < size(); ++h)
      if (opposite[h] == none)
        alone.emplace(std::pair<Index, Index>(fan[h], fan[next(h)]), h);
    for (const auto& [ends, h] : alone)
      if (const auto g = alone.find({ends.second, ends.first}); g != alone.end())
        opposite[h] = g->second;
  }
};

template <typename Mesh>
Manifold_of<Mesh> make_manifold_of(const Polygon_soup& soup)
{
  struct Piece
  {
    int segment;
    Mesh mesh;
    std::vector<std::size_t> faces, vertices;
  };
  const Halfedges_of_soup halfedges(soup);
  std::vector<Piece> pieces; // one
  CGAL::Region_segmentation::internal::Piece_builder<Piece, Halfedges_of_soup>(halfedges, halfedges)
    .build(std::back_inserter(pieces), [&](auto h, auto, const auto& put_point) {
      put_point(soup.points[halfedges.source[h]]);
    });
  Piece& piece = pieces.front();
  return {std::move(piece.mesh), std::move(piece.faces), std::move(piece.vertices)};
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_MANIFOLD_H
