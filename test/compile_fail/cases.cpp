// SPDX-License-Identifier: GPL-3.0-or-later

// Code that must not compile: each case compiles without WITH_FAULT, so that it is the fault that
// is refused, and with it fails with the message of its line `expect:`. An error in a template is
// told once for the same arguments: no two faults may share them.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;
using Graph = RS::Region_adjacency_graph<>;
using Visibility_graph = RS::Region_adjacency_graph<RS::Visibility_region_data,
                                                    RS::Visibility_section_data>;

// expect: the constraints of polygons are a range of pairs of indices of points
namespace constraints_of_polygons {
#ifdef WITH_FAULT
using Drawn = Mesh::Property_map<Mesh::Edge_index, bool>;
#else
using Drawn = std::vector<std::pair<int, int>>;
#endif
using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
void test(const Points& points, const std::vector<std::vector<int>>& polygons,
          std::vector<int>& labels, const Drawn& drawn)
{
  RS::segment_polygon_soup(points, polygons, labels, RS::parameters::constrained_edges(drawn));
}
} // namespace constraints_of_polygons

// expect: the SectionCost names RegionData or SectionData that are not those of the graph
namespace cost_without_its_data {
// A cost that reads the data of another graph.
#ifdef WITH_FAULT
void test(Graph& graph)
#else
void test(Visibility_graph& graph)
#endif
{
  RS::merge_regions(graph, RS::Lowest_cost_first<RS::Visibility_cost>(), 3);
}
} // namespace cost_without_its_data

// expect: a property map of the edges is needed
namespace face_map_as_constraints {
#ifdef WITH_FAULT
using Key = Mesh::Face_index;
#else
using Key = Mesh::Edge_index;
#endif
void test(const Mesh& mesh, Labels labels, Mesh::Property_map<Key, bool> drawn)
{
  RS::segment(mesh, labels, RS::parameters::edge_is_constrained_map(drawn).number_of_segments(8));
}
} // namespace face_map_as_constraints

// expect: labels of polygons are a range or a property map of an integral type other than bool
namespace labels_of_polygons {
void test(const std::vector<std::array<double, 3>>& points,
          const std::vector<std::vector<std::size_t>>& polygons)
{
#ifdef WITH_FAULT
  std::vector<bool> labels(polygons.size());
#else
  std::vector<int> labels(polygons.size());
#endif
  RS::segment_polygon_soup(points, polygons, labels);
}
} // namespace labels_of_polygons

// expect: a SegmentationMethod needs: Prepared prepare(const Surface&, std::size_t
// number_of_segments
namespace method {
struct Method
{
  int prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return 0; }
#ifdef WITH_FAULT
  RS::Hierarchy merge(const RS::Surface&, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#else
  RS::Hierarchy merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(Method()));
}
} // namespace method

// expect: this argument is a pack of named parameters: pass a method by parameters::method()
namespace method_as_parameters_of_a_segmenter {
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  RS::Segmenter segmenter(mesh, RS::Learned_merging());
#else
  RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Learned_merging()));
#endif
}
} // namespace method_as_parameters_of_a_segmenter

// expect: this argument is a pack of named parameters: pass a method by parameters::method()
namespace method_without_its_name {
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::Visibility_merging());
#else
  RS::segment(mesh, labels, RS::parameters::method(RS::Visibility_merging()));
#endif
}
} // namespace method_without_its_name

// expect: a NumberChooser needs: std::size_t operator()(const Merge_tree&, const Surface&) const
namespace number_chooser {
struct Chooser
{
#ifdef WITH_FAULT
  std::size_t operator()(const RS::Merge_tree&) const
  {
    return 3;
  }
#else
  std::size_t operator()(const RS::Merge_tree&, const RS::Surface&) const
  {
    return 3;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  const RS::Visibility_merging visibility;
  const RS::Superfacet_merging method{visibility.annotator, visibility.policy, Chooser()};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
} // namespace number_chooser

// expect: Parallel_tag needs TBB
namespace parallel_tag {
#ifdef WITH_FAULT
using Tag = CGAL::Parallel_tag;
#else
using Tag = CGAL::Sequential_tag;
#endif

void test(const Mesh& mesh, Labels labels)
{
  RS::segment<Tag>(mesh, labels, RS::parameters::number_of_segments(3));
}
} // namespace parallel_tag

// expect: one of the named parameters is not taken by this function (constants of a method are
namespace parameter_of_a_part {
// members of its parts)
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).clearance(5));
#else
  RS::Two_step method;
  method.maximum_angle = 5;
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
#endif
}
} // namespace parameter_of_a_part

// expect: polygons are ranges of indices of points: of an integral type
namespace polygons_of_numbers {
#ifdef WITH_FAULT
using Index = double;
#else
using Index = int;
#endif
using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
void test(const Points& points, const std::vector<std::vector<Index>>& polygons,
          std::vector<int>& labels)
{
  RS::segment_polygon_soup(points, polygons, labels);
}
} // namespace polygons_of_numbers

// expect: a SectionCost needs: double operator()
namespace section_cost {
struct Cost
{
#ifdef WITH_FAULT
  double operator()(Graph::section_descriptor) const
  {
    return 0;
  }
#else
  double operator()(const Graph&, Graph::section_descriptor) const
  {
    return 0;
  }
#endif
};
void test(Graph& graph)
{
  RS::Lowest_cost_first<Cost> policy;
  RS::merge_regions(graph, policy, 3);
}
} // namespace section_cost

// expect: face_seed_map has an integral value type
namespace seed_type {
#ifdef WITH_FAULT
using Seed = double;
#else
using Seed = int;
#endif
void test(const Mesh& mesh, Labels labels, Mesh::Property_map<Mesh::Face_index, Seed> seeds)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).face_seed_map(seeds));
}
} // namespace seed_type

// expect: segment() with this method needs the named parameter number_of_segments
namespace segment_without_a_number {
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::method(RS::Two_step()));
#else
  RS::segment(mesh, labels, RS::parameters::method(RS::Two_step()).number_of_segments(3));
#endif
}
} // namespace segment_without_a_number

// expect: it has no tree for all numbers, use segment(segment_map, number_of_segments)
namespace segmenter_merge_tree {
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  const RS::Two_step method;
#else
  const RS::Visibility_merging method;
#endif
  const RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  segmenter.merge_tree();
}
} // namespace segmenter_merge_tree

// expect: use of deleted function
namespace segmenter_of_a_temporary {
Mesh make_mesh();
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  const RS::Segmenter segmenter(make_mesh());
#else
  const RS::Segmenter segmenter(mesh);
#endif
}
} // namespace segmenter_of_a_temporary

// expect: the Segmenter is of another type than the method: omit its template arguments
namespace segmenter_of_another_method {
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  using Segmenter = decltype(RS::Segmenter(mesh)); // of the default method
  const Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#else
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#endif
}
} // namespace segmenter_of_another_method

// expect: this method merges for each number: give it to segment(segment_map, number_of_segments)
namespace segmenter_with_a_number {
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()).number_of_segments(5));
#else
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#endif
  segmenter.segment(labels, 5);
}
} // namespace segmenter_with_a_number

// expect: this method needs the number of segments: use segment(segment_map, number_of_segments)
namespace segmenter_without_a_number {
void test(const Mesh& mesh, Labels labels)
{
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#ifdef WITH_FAULT
  segmenter.segment(labels);
#else
  segmenter.segment(labels, 3);
#endif
}
} // namespace segmenter_without_a_number

// expect: labels are written to a map or range of an integral type
namespace string_map_as_segment_map {
#ifdef WITH_FAULT
using Value = std::string;
#else
using Value = int;
#endif
void test(const Mesh& mesh, Mesh::Property_map<Mesh::Face_index, Value> map)
{
  RS::segment(mesh, map, RS::parameters::number_of_segments(8));
}
} // namespace string_map_as_segment_map

// expect: a property map of the faces is needed
namespace vertex_map_as_segment_map {
#ifdef WITH_FAULT
using Map = Mesh::Property_map<Mesh::Vertex_index, std::size_t>;
#else
using Map = Labels;
#endif
void test(const Mesh& mesh, Map map)
{
  RS::segment(mesh, map);
}
} // namespace vertex_map_as_segment_map

// expect: a SegmentationVisitor needs: bool on_progress
namespace visitor {
struct Visitor
{
#ifdef WITH_FAULT
  void operator()(double) {}
#else
  bool on_progress(const char*, double)
  {
    return true;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  Visitor visitor;
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(std::ref(visitor)));
}
} // namespace visitor

// expect: a SegmentationVisitor is not copied: pass it as visitor(std::ref(v))
namespace visitor_by_value {
struct Visitor_by_value
{
  bool on_progress(const char*, double) { return true; }
};
void test(const Mesh& mesh, Labels labels)
{
  Visitor_by_value visitor;
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(visitor));
#else
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(std::ref(visitor)));
#endif
}
} // namespace visitor_by_value
