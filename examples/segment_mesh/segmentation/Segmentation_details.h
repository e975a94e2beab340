// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_DETAILS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_DETAILS_H

#include "segmentation/run_segmentation.h"
#include "soup/Polygon_soup.h"
#include "view/segment_colors.h"

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Simple_cartesian.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

struct Manifold;

using Kernel = CGAL::Simple_cartesian<double>;

/// A segment that is a face of a machine part.
struct Surface_face
{
  CGAL::Region_segmentation::Fitted_surface<Kernel> surface; ///< in units of the mesh
  CGAL::Region_segmentation::Face_role role = CGAL::Region_segmentation::Face_role::NONE;
  std::size_t same_surface = 0; ///< the first segment on the same surface
  std::size_t same_axis = 0;    ///< the first segment with the same axis
};

/// The name of a segment of which nothing more is known; -1 for faces of none.
inline std::string name_of_segment(std::size_t segment)
{
  return "segment_" + std::to_string(std::int64_t(segment));
}

/// A name as all formats and their readers can have it: with `_` in place of each character that is
/// not a letter of ASCII, a digit, or one of `_ . + -`; at most 100 characters.
std::string clean_name(const std::string& name);

/// The last two of the method smooth-faces alone.
struct Segment_description : CGAL::Region_segmentation::Segment_description<std::size_t, Kernel>
{
  std::optional<Surface_face> face; ///< unless faces were merged
  std::optional<std::vector<std::size_t>> smooth_neighbors;
};

/// The shape of a segment as an object, see doc/Region_segmentation/Program.txt; values that are
/// not finite are null.
nlohmann::ordered_json segment_json(const Segment_description& segment);

/// Points by their indices.
using Polyline = std::vector<std::size_t>;

/// A region that merging started from.
struct Region
{
  std::size_t number_of_faces = 0;
  double area = 0;      ///< in squared units of `Surface::unit()`
  double perimeter = 0; ///< edges and seams shared with other regions, in units of
                        ///< `Surface::unit()`
  std::size_t segment = 0;
};

/// All adjacencies of two regions.
struct Section
{
  std::size_t regions[2];
  std::size_t number_of_adjacencies = 0; ///< edges, seams and links
  double length = 0;                     ///< in units of `Surface::unit()`
  double mean_angle = 0;                 ///< the dihedral angle, in radians; pi is flat
};

/// A polyline between two segments; the first and the last point of a closed one are the same.
struct Border
{
  std::array<std::size_t, 2> segments; ///< to the left and to the right, seen from outside
  Polyline points;
};

/// Closed meshes, each with the faces of a segment and caps, which are of the same segment.
struct Solids
{
  Polygon_soup soup; ///< different solids have no common point
  std::vector<std::size_t> segment_of_face;
};

/// What outputs contain beside the labels; computed from them when it is asked for. Lines and
/// shapes are those of `make_manifold()`.
class Segmentation_details
{
public:
  /// Refers to all.
  Segmentation_details(const Polygon_soup& soup, const Segmentation_settings& settings,
                       const Segmentation& segmentation);
  Segmentation_details(const Segmentation_details&) = delete;
  Segmentation_details& operator=(const Segmentation_details&) = delete;
  ~Segmentation_details();

  std::vector<Region> regions() const;
  std::vector<Section> sections() const;
  /// By segment.
  std::vector<Segment_description> segments() const;
  /// Of the segments, for outputs, all different: `segment_I` for the segment I, or, if it is a
  /// face of a machine part, what the face is for, else the kind of its surface, and of a cylinder
  /// that is a hole or boss the radius: `hole_3_r2.5`, `fillet_7`, `plane_0`.
  std::vector<std::string> names() const;
  std::vector<Border> borders() const;
  /// See `close_segments()`.
  Solids solids() const;
  /// The number of the color of each of n labels of the faces of the soup: the label itself, or
  /// that of the kind of its surface.
  std::vector<std::size_t> colors(Coloring coloring, const std::vector<std::size_t>& labels,
                                  std::size_t n) const;
  /// Of the segments of all partitions into at most `number_of_segments`. Their numbers are those
  /// of nodes of the merge tree: the regions, then the result of each merge.
  std::vector<Segment_description> nodes(std::size_t number_of_segments) const;
  /// Of any labels of the faces, except of `no_segment`; of each that `make_manifold()` leaves a
  /// face.
  std::vector<Segment_description> describe(const std::vector<std::size_t>& labels) const;

private:
  class Machine_part;
  struct Region_graph;

  const Manifold& manifold() const;
  const Machine_part* machine_part() const; ///< null if the method is not smooth-faces
  const Region_graph& region_graph() const;

  const Polygon_soup& m_soup;
  const Segmentation_settings& m_settings;
  const Segmentation& m_segmentation;
  mutable std::unique_ptr<const Manifold> m_manifold;
  mutable std::unique_ptr<const Machine_part> m_machine_part;
  mutable std::unique_ptr<const Region_graph> m_region_graph;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_DETAILS_H
