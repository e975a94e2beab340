// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_SEGMENTATION_H

#include "soup/Polygon_soup.h"

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

/// The seed of a face that has none.
constexpr std::size_t no_seed = std::size_t(-1);

/// Edges and faces of the mesh to be segmented that a user marked.
struct Marks
{
  std::vector<Vertex_pair> constrained_edges; ///< sorted, each with the lower point first
  std::vector<std::size_t> seed_of_face;      ///< or `no_seed`; empty if no face has one
};

enum class Method { TWO_STEP, VISIBILITY, LEARNED, SMOOTH_FACES };

/// The names of the methods, in their order.
constexpr const char* method_names[] = {"two-step", "visibility", "learned", "smooth-faces"};

/// The names of `Feature_convexity`, in their order.
constexpr const char* feature_names[] = {"convex", "concave", "all"};

/// What becomes of the borders that a method gives.
enum class Border_treatment { NONE, SMOOTHING };

/// Whether components that touch or are near each other are adjacent.
enum class Component_links { NONE, FOUND };

struct Segmentation_settings
{
  Method method = Method::LEARNED;
  std::optional<std::size_t> number_of_segments; ///< if empty, the method chooses; `TWO_STEP`
                                                 ///< gives all regions between the features
  /// Which edges can be features, of a method that has them.
  CGAL::Region_segmentation::Feature_convexity
    features = CGAL::Region_segmentation::Feature_convexity::CONCAVE;
  double maximum_angle = CGAL::Region_segmentation::default_maximum_angle; ///< the same, in degrees
  double tolerance = 0; ///< of `SMOOTH_FACES`, in units of the mesh; 0: found from the mesh
  Border_treatment borders = Border_treatment::NONE;
  Component_links links = Component_links::FOUND;
};

/// Faces have the indices that they have in the soup.
struct Segmentation
{
  std::size_t number_of_regions = 0;
  std::size_t number_of_segments = 0;
  /// Where the method chose the largest number that it chooses: there may be more parts.
  std::optional<std::size_t> largest_number;
  std::vector<std::size_t> segment_of_face; ///< `no_segment` for faces of none
  std::vector<std::string> names;           ///< of segments that a file names, else empty
  std::vector<std::size_t> region_of_face;  ///< a region lies in one segment
  /// Of the regions. Its partition into `number_of_segments` is `segment_of_face`; it has no merges
  /// where the segments are the regions.
  CGAL::Region_segmentation::Merge_tree tree{0};
  /// Those that `SMOOTH_FACES` found; null for other methods.
  std::shared_ptr<const CGAL::Region_segmentation::Surface_faces> part_faces;
  double seconds = 0; ///< from the mesh in memory to the labels
};

/// Hears of a stage and of how much of it is done, from 0 to 1; false cancels.
using Progress_listener = std::function<bool(const char* stage, double fraction)>;

/// Segments a soup.
Segmentation run_segmentation(const Polygon_soup& soup, const Marks& marks,
                              const Segmentation_settings& settings,
                              const Progress_listener& listener);

/// A segmentation that exists: a segment for each label, in their order. No other regions, but for
/// a last one of the faces with the label -1, which are in no segment.
Segmentation segmentation_from_labels(const std::vector<std::int64_t>& labels);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_SEGMENTATION_H
