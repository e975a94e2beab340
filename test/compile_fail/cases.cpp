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
#include <optional>
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

// expect: a GraphAnnotator needs the nested types RegionData and SectionData, and: void operator()
namespace annotator {
struct Annotator
{
  using RegionData = RS::Visibility_region_data;
  using SectionData = RS::Visibility_section_data;
#ifdef WITH_FAULT
  void operator()(Visibility_graph&, const RS::Surface&) const {}
#else
  void operator()(Visibility_graph&, const RS::Surface&, const RS::Partition&,
                  const RS::Region_rays&) const
  {}
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  const RS::Superfacet_merging method{Annotator(), RS::Visibility_merging().policy,
                                      RS::Visibility_merging().chooser};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
} // namespace annotator

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
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  auto graph = RS::build_region_adjacency_graph(mesh, labels);
#else
  auto graph = RS::build_region_adjacency_graph<RS::Visibility_region_data,
                                                RS::Visibility_section_data>(mesh, labels);
#endif
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

// expect: a MergingPolicy is copy constructible, and needs: void initialize
namespace merging_policy {
struct Policy
{
  void initialize(const Graph&) {}
#ifdef WITH_FAULT
  std::optional<Graph::section_descriptor> next(const Graph&)
  {
    return std::nullopt;
  }
#else
  std::optional<RS::Merge_candidate> next(const Graph&)
  {
    return std::nullopt;
  }
#endif
  void on_merge(const Graph&, const Graph::Merge&) {}
};
void test(Graph& graph)
{
  Policy policy;
  RS::merge_regions(graph, policy, 3);
}
} // namespace merging_policy

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
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).maximum_angle(5));
#else
  RS::Two_step method;
  method.maximum_angle = 5;
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
#endif
}
} // namespace parameter_of_a_part

// expect: the MergingPolicy names RegionData or SectionData that are not those of the graph
namespace policy_without_its_data {
// A policy that reads the data of another graph.
void test(Visibility_graph& graph)
{
#ifdef WITH_FAULT
  RS::merge_regions(graph, RS::Smallest_region_first(), 3);
#else
  RS::merge_regions(graph, RS::Lowest_cost_first<RS::Visibility_cost>(), 3);
#endif
}
} // namespace policy_without_its_data

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

// expect: a RegionData is default and copy constructible, and needs: void add_face
namespace region_data {
struct Region_data
{
#ifndef WITH_FAULT
  void add_face(const RS::Surface&, std::size_t) {}
#endif
  void add_border(const RS::Surface&, std::size_t) {}
  template <typename Section>
  void absorb(const Region_data&, const Section&)
  {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph<Region_data>(mesh, labels);
}
} // namespace region_data

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

// expect: a SectionData is default and copy constructible, and needs: void add_adjacency
namespace section_data {
struct Section_data
{
  double length = 0;
#ifndef WITH_FAULT
  void add_adjacency(const RS::Surface&, std::size_t) {}
#endif
  void absorb(const Section_data&) {}
};
struct Region_data
{
  void add_face(const RS::Surface&, std::size_t) {}
  void add_border(const RS::Surface&, std::size_t) {}
  void absorb(const Region_data&, const Section_data&) {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph<Region_data, Section_data>(mesh, labels);
}
} // namespace section_data

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
