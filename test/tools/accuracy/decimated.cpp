// SPDX-License-Identifier: GPL-3.0-or-later

#include "decimated.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace princeton_benchmark {

namespace {

using segment_mesh::Labelled_model;
using segment_mesh::Polygon_soup;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Mesh mesh_of(const Polygon_soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Mesh::Point> points;
  for (const segment_mesh::Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& corners = soup.polygons[f];
    polygons.emplace_back(corners.begin(), corners.end());
  }
  PMP::orient_polygon_soup(points, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  return mesh;
}

Polygon_soup soup_of(const Mesh& mesh)
{
  Polygon_soup soup;
  for (const Mesh::Vertex_index v : mesh.vertices())
    soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (const Mesh::Face_index f : mesh.faces()) {
    std::vector<std::size_t> corners;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(std::size_t(v));
    soup.polygons.push_back(corners);
  }
  return soup;
}

/// The centroids of faces, to find the nearest.
class Centroids
{
public:
  explicit Centroids(const Polygon_soup& soup)
  {
    std::vector<Item> items;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      items.push_back({place(soup, f), f});
    m_tree = Tree(items);
  }

  std::size_t nearest(const Polygon_soup& soup, std::size_t face) const
  {
    return m_tree.qbegin(boost::geometry::index::nearest(place(soup, face), 1))->second;
  }

private:
  using Place = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Item = std::pair<Place, std::size_t>;
  using Tree = boost::geometry::index::rtree<Item, boost::geometry::index::quadratic<16>>;

  static Place place(const Polygon_soup& soup, std::size_t face)
  {
    const segment_mesh::Point p = centroid(soup, soup.polygons[face]);
    return {p[0], p[1], p[2]};
  }

  Tree m_tree;
};

} // namespace

Labelled_model decimated(const Labelled_model& model, double share)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  Mesh mesh = mesh_of(model.soup);
  SMS::edge_collapse(mesh, SMS::Count_ratio_stop_predicate<Mesh>(share));
  mesh.collect_garbage();
  Labelled_model result;
  result.name = model.name;
  result.number_of_parts = model.number_of_parts;
  result.soup = soup_of(mesh);
  const Centroids centroids(model.soup);
  for (std::size_t f = 0; f < result.soup.polygons.size(); ++f)
    result.labels.push_back(model.labels[centroids.nearest(result.soup, f)]);
  return result;
}

} // namespace princeton_benchmark
