// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "3D Manufacturing Format", core specification and extensions for materials and for
// production (components in files of their own), https://3mf.io/specification

#include "read/Face_set_builder.h"
#include "read/Text_scanner.h"
#include "read/Xml_archive.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "soup/vector_algebra.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace segment_mesh {

namespace {

constexpr std::string_view
  core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
  material_extension = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";

constexpr Polygons::Index none = Polygons::Index(-1);

struct Triangle
{
  std::array<Polygons::Index, 3> points;
  Polygons::Index material = none;
  Polygons::Index extruder = 0;
};

struct Component
{
  std::size_t object;
  Eigen::Affine3d to_parent;
};

struct Object
{
  std::string name;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Component> components;
};

/// What the files of an archive hold together.
struct Package
{
  std::deque<Object> objects;
  std::map<std::pair<std::string, std::int64_t>, std::size_t> object_of_id; ///< by file and id
  std::vector<Component> items;                                             ///< of the build
  std::vector<std::string> material_names;                                  ///< or colors
  std::size_t number_of_divided = 0; ///< triangles painted in several colors
  bool has_wrong_materials = false;
};

/// How much of a triangle is painted for each extruder, 0 for none, by the code of PrusaSlicer.
///
/// Its hexadecimal digits, from the last to the first, are a tree: in the lower two bits is the
/// number of parts less one, if there are several, which follow; else in the upper two the
/// extruder, 3 for that of the next digit and 3 more. The parts of a triangle count as equal.
/// \throws Value_error
std::array<double, 19> shares_of_paint(std::string_view code)
{
  const auto next_digit = [&code] {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const std::size_t digit = code.empty() ? digits.npos : digits.find(code.back());
    if (digit == digits.npos)
      throw Value_error("a code of paint that is cut off or not hexadecimal");
    code.remove_suffix(1);
    return digit;
  };
  std::array<double, 19> shares{};
  std::vector<double> open = {1};
  while (!open.empty()) {
    const double share = open.back();
    open.pop_back();
    const std::size_t digit = next_digit(), cuts = digit % 4;
    if (cuts > 0)
      open.insert(open.end(), cuts + 1, share / double(cuts + 1));
    else
      shares[digit < 12 ? digit / 4 : 3 + next_digit()] += share;
  }
  return shares;
}

Eigen::Affine3d transformation(const Xml_element& element)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  Text_scanner words("", element.find("transform").value_or("1 0 0 0 1 0 0 0 1 0 0 0"),
                     Text_scanner::no_comments);
  for (int i = 0; i < 12; ++i) {
    const std::string_view word = words.word_of_any_line();
    if (word.empty())
      throw Value_error("a transform of " + counted(std::size_t(i), "number") + ", not 12");
    result(i % 3, i / 3) = finite_number(word);
  }
  return result;
}

/// Reads a file of an archive, and those that its components are in.
class Model_reader
{
public:
  /// The root has the build, and alone names other files.
  enum class Role { ROOT, PART };

  Model_reader(Xml_archive& archive, Package& package, const std::string& entry, Role role)
    : m_archive(archive)
    , m_package(package)
    , m_entry(entry)
    , m_role(role)
  {}

  void read()
  {
    m_archive.read(m_entry, [this](const Xml_element& element) { take(element); });
  }

private:
  using Group = std::vector<Polygons::Index>; // of names

  void take(const Xml_element& element)
  {
    if (element.name_space() != core && element.name_space() != material_extension)
      return;
    const std::string_view name = element.name();
    if (!element.is_start()) {
      if (name == "object")
        end_object();
    } else if (name == "object")
      start_object(element);
    else if (name == "vertex")
      m_object.points.push_back({finite_number(element.at("x")), finite_number(element.at("y")),
                                 finite_number(element.at("z"))});
    else if (name == "triangle")
      add_triangle(element);
    else if (name == "component")
      m_object.components.push_back(component(element));
    else if (name == "item" && m_role == Role::ROOT)
      m_package.items.push_back(component(element));
    else if (name == "basematerials" || name == "colorgroup")
      m_group = &m_groups[integer(element.at("id"), "an id")];
    else if (m_group && (name == "base" || name == "color"))
      add_material(element);
  }

  void start_object(const Xml_element& element)
  {
    m_object = {};
    m_id = integer(element.at("id"), "an id");
    m_object.name = element.find("name").value_or("object_" + std::to_string(m_id));
    m_group_of_object = element.find("pid");
    m_material_of_object = material(m_group_of_object, element.find("pindex").value_or("0"));
  }

  void end_object()
  {
    if (!m_package.object_of_id.emplace(std::pair(m_entry, m_id), m_package.objects.size()).second)
      throw Value_error("a second object " + std::to_string(m_id));
    m_package.objects.push_back(std::move(m_object));
    m_object = {};
  }

  void add_triangle(const Xml_element& element)
  {
    constexpr const char* corners[] = {"v1", "v2", "v3"};
    Triangle& t = m_object.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t v = integer(element.at(corners[i]), "an index of a vertex");
      if (v < 0 || v >= std::int64_t(m_object.points.size()))
        throw Value_error(out_of_range(v, m_object.points.size(), "vertex", 0));
      t.points[i] = Polygons::Index(v);
    }
    const auto first = element.find("p1");
    const auto group = element.find("pid");
    t.material = first ? material(group ? group : m_group_of_object, *first) : m_material_of_object;
    for (const char* paint : {"mmu_segmentation", "paint_color"})
      if (const auto code = element.find(paint); code && !code->empty() && t.extruder == 0)
        t.extruder = extruder(*code);
  }

  Polygons::Index extruder(std::string_view code)
  {
    try {
      const auto shares = shares_of_paint(code);
      const auto most = std::max_element(shares.begin(), shares.end());
      m_package.number_of_divided += *most < 1;
      return Polygons::Index(most - shares.begin());
    } catch (const Value_error&) {
      m_package.has_wrong_materials = true;
      return 0;
    }
  }

  /// The object of this file, or of another one, that stands before; an object thus never holds
  /// itself.
  Component component(const Xml_element& element)
  {
    const std::int64_t id = integer(element.at("objectid"), "an id");
    std::string entry = m_entry;
    if (const auto path = element.find("path")) {
      entry = path->substr(path->substr(0, 1) == "/");
      if (m_role == Role::PART)
        throw Value_error("a component in another file, which the root alone can have");
      if (entry != m_entry && m_files.insert(entry).second)
        Model_reader(m_archive, m_package, entry, Role::PART).read();
    }
    const auto found = m_package.object_of_id.find({entry, id});
    if (found == m_package.object_of_id.end())
      throw Value_error("object " + std::to_string(id) + " does not come before it");
    return {found->second, transformation(element)};
  }

  /// The name of a color is its code, without that of how opaque it is.
  void add_material(const Xml_element& element)
  {
    const bool is_color = element.name() == "color";
    m_group->push_back(Polygons::Index(m_package.material_names.size()));
    m_package.material_names.emplace_back(is_color ? element.at("color").substr(0, 7)
                                                   : element.at("name"));
  }

  /// Of a group by the index in it; none without a group, or of one that is not read, as of
  /// textures.
  Polygons::Index material(std::optional<std::string_view> group, std::string_view index)
  {
    const auto found = group ? m_groups.find(integer(*group, "an id")) : m_groups.end();
    if (found == m_groups.end())
      return none;
    const std::int64_t i = integer(index, "an index of a material");
    if (i >= 0 && i < std::int64_t(found->second.size()))
      return found->second[std::size_t(i)];
    m_package.has_wrong_materials = true;
    return none;
  }

  Xml_archive& m_archive;
  Package& m_package;
  std::string m_entry;
  Role m_role;
  std::set<std::string> m_files; // that were read for components
  std::map<std::int64_t, Group> m_groups;
  Group* m_group = nullptr; // that is read
  Object m_object;          // that is read, and what its triangles have by default
  std::int64_t m_id = 0;
  std::optional<std::string> m_group_of_object;
  Polygons::Index m_material_of_object = none;
};

/// The mesh of the items of a build.
class Build
{
public:
  Build(const std::string& file, Package& package, std::size_t most_elements)
    : m_file(file)
    , m_package(package)
    , m_most_elements(most_elements)
  {}

  Input_mesh mesh()
  {
    std::vector<Component> open(m_package.items.rbegin(), m_package.items.rend());
    for (std::size_t number = 0; !open.empty();) {
      const Component placed = open.back();
      open.pop_back();
      const Object& object = m_package.objects[placed.object];
      number += 1 + object.points.size() + object.triangles.size();
      if (number > m_most_elements)
        throw Input_error(m_file, "repeats its objects too often for its size");
      add(object, placed.to_parent);
      for (auto child = object.components.rbegin(); child != object.components.rend(); ++child)
        open.push_back({child->object, placed.to_parent * child->to_parent});
    }
    finish();
    return std::move(m_input);
  }

private:
  void add(const Object& object, const Eigen::Affine3d& to_world)
  {
    const std::size_t first = m_soup.points.size();
    for (const Point& point : object.points) {
      const Eigen::Vector3d p = to_world * Eigen::Vector3d::Map(point.data());
      m_soup.points.push_back({p.x(), p.y(), p.z()});
      if (!is_finite(m_soup.points.back()))
        throw Input_error(m_file, "object " + in_quotes(object.name) +
                                    ": a transform leads to a number that is not finite");
    }
    if (!object.triangles.empty())
      m_groups.start_new(object.name, m_soup.polygons.size());
    const bool is_mirrored = to_world.linear().determinant() < 0;
    for (const Triangle& t : object.triangles) {
      start_material(t.material);
      m_extruders.push_back(t.extruder);
      const auto [a, b, c] = t.points;
      m_soup.polygons.push_back(
        {first + a, first + (is_mirrored ? c : b), first + (is_mirrored ? b : c)});
    }
  }

  /// The next faces have this material; sets of one name are one set.
  void start_material(Polygons::Index material)
  {
    if (material != m_last_material)
      m_materials.start(material == none ? "" : m_package.material_names[material],
                        m_soup.polygons.size());
    m_last_material = material;
  }

  void finish()
  {
    Mesh_properties& properties = m_input.properties;
    const std::size_t number_of_faces = m_soup.polygons.size();
    properties.of(Set_kind::GROUPS) = m_groups.build(number_of_faces);
    properties.of(Set_kind::MATERIALS) = m_materials.build(number_of_faces);
    const auto last = std::max_element(m_extruders.begin(), m_extruders.end());
    if (last != m_extruders.end() && *last > 0) {
      std::vector<std::string> names = {"unpainted"};
      for (Polygons::Index i = 1; i <= *last; ++i)
        names.push_back("extruder_" + std::to_string(i));
      properties.of(Set_kind::PAINT) = {std::make_shared<const std::vector<std::string>>(names),
                                        std::move(m_extruders)};
    }
    if (m_package.number_of_divided > 0)
      m_input.remarks.push_back(m_file + ": " + counted(m_package.number_of_divided, "triangle") +
                                " painted in several colors: each has that of most of it");
    if (m_package.has_wrong_materials)
      m_input.remarks.push_back(m_file +
                                ": materials or paint that are not as in 3MF are left out");
  }

  const std::string& m_file;
  Package& m_package;
  std::size_t m_most_elements;
  Input_mesh m_input;
  Polygon_soup& m_soup = m_input.soup;
  Face_set_builder m_groups, m_materials;
  Polygons::Index m_last_material = none;
  std::vector<Polygons::Index> m_extruders; // of the faces
};

/// The file with the build, as the archive names it.
std::string root_of(Xml_archive& archive)
{
  const std::string relationships = "_rels/.rels", model = "/3dmodel";
  std::string root = "3D/3dmodel.model";
  if (archive.has(relationships))
    archive.read(relationships, [&](const Xml_element& element) {
      if (!element.is_start() || element.name() != "Relationship")
        return;
      const std::string_view type = element.at("Type"), target = element.at("Target");
      if (type.size() >= model.size() && type.substr(type.size() - model.size()) == model)
        root = target.substr(target.substr(0, 1) == "/");
    });
  return root;
}

} // namespace

Input_mesh read_3mf(const std::string& file, std::string_view bytes)
{
  // An object may be shown many times, as a screw; what is repeated more often was made to exhaust
  // the memory.
  constexpr std::size_t most_elements_per_byte = 10, harmless_number = 100000;
  Xml_archive archive(file, bytes);
  Package package;
  Model_reader(archive, package, root_of(archive), Model_reader::Role::ROOT).read();
  return Build(file, package, harmless_number + most_elements_per_byte * bytes.size()).mesh();
}

} // namespace segment_mesh
