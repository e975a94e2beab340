// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_PROPERTIES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_PROPERTIES_H

#include "soup/Polygon_soup.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace segment_mesh {

/// What sets of faces are in a file: groups and objects of OBJ, nodes of glTF, objects of 3MF;
/// their materials; the solids of STL; the extruders that 3MF is painted for.
enum class Set_kind { GROUPS, MATERIALS, SOLIDS, PAINT };

/// The names of the kinds, in their order.
constexpr const char* set_kind_names[] = {"groups", "materials", "solids", "paint"};

/// Sets that share out the faces of a mesh, with their names in the file. A set may be empty, and
/// two may have the same name.
struct Face_sets
{
  std::shared_ptr<const std::vector<std::string>> names; ///< null if there are no sets
  std::vector<Polygons::Index> set_of_face;

  bool empty() const { return set_of_face.empty(); }
  const std::string& name(std::size_t face) const { return (*names)[set_of_face[face]]; }
};

/// Values at the corners of polygons.
template <typename Value>
struct Corner_values
{
  static constexpr Polygons::Index none = Polygons::Index(-1);

  std::vector<Value> values;
  std::vector<Polygons::Index> of_corner; ///< its place in `values`, or `none`

  bool empty() const { return of_corner.empty(); }

  Value at(std::size_t corner, const Value& otherwise) const
  {
    return of_corner[corner] == none ? otherwise : values[of_corner[corner]];
  }

  /// What a reader has left open: as many values as points are those of the points; corners at the
  /// end, and those whose value is not there, have none.
  void finish(const Polygon_soup& soup)
  {
    const std::vector<Polygons::Index>& corners = soup.polygons.corners();
    if (of_corner.empty() && values.size() == soup.points.size())
      of_corner = corners;
    else if (!of_corner.empty())
      of_corner.resize(values.empty() ? 0 : corners.size(), none);
    for (Polygons::Index& i : of_corner)
      i = i < values.size() ? i : none;
  }

  /// Of each point, that at its first corner. \pre not empty
  std::vector<Value> of_points(const Polygon_soup& soup, const Value& otherwise) const
  {
    std::vector<Value> result(soup.points.size(), otherwise);
    for (std::size_t corner = of_corner.size(); corner-- > 0;)
      result[soup.polygons.corners()[corner]] = at(corner, otherwise);
    return result;
  }
};

/// The materials themselves, as their file has them.
struct Material_library
{
  std::string folder;                ///< of the file, which names of files start from
  std::vector<std::string> files;    ///< of OBJ: .mtl
  std::vector<std::string> textures; ///< of PLY: the files of images
  std::string gltf;                  ///< of glTF: `materials` and what they refer to, as JSON; an
                                     ///< image's `bufferView` is its place in `images`
  std::vector<std::string> images;   ///< bytes
};

/// What a file says of a mesh beside its points and faces. What it does not have is empty.
struct Mesh_properties
{
  using Texture_point = std::array<double, 2>;
  using Rgb = std::array<float, 3>;

  static constexpr Rgb white = {1, 1, 1};

  std::array<Face_sets, 4> sets;                   ///< by `Set_kind`
  Corner_values<Rgb> colors;                       ///< from 0 to 1, in sRGB
  Corner_values<Texture_point> texture;            ///< u to the right, v up
  std::shared_ptr<const Material_library> library; ///< null if there is none

  const Face_sets& of(Set_kind kind) const { return sets[std::size_t(kind)]; }
  Face_sets& of(Set_kind kind) { return sets[std::size_t(kind)]; }

  /// Those of which there are sets.
  std::vector<Set_kind> kinds() const
  {
    std::vector<Set_kind> result;
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (!sets[i].empty())
        result.push_back(Set_kind(i));
    return result;
  }
};

/// What is read of a color or texture; 0 for what is not finite as a float, either.
inline double usable_value(double x)
{
  constexpr double most = 1e30;
  return std::fabs(x) <= most ? x : 0;
}

/// \name A channel of a color from 0 to 1
/// @{
inline double linear_from_srgb(double s)
{
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
inline double srgb_from_linear(double x)
{
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MESH_PROPERTIES_H
