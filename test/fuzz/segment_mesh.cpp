// SPDX-License-Identifier: GPL-3.0-or-later

// Any valid half-edge mesh with any coordinates: every method gives connected segments, numbered by
// their first faces.

#include "Bytes.h"
#include "mesh_from.h"
#include "require.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacets.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

/// The faces that can be reached from `start` without leaving its label; marks them as seen.
void visit(const Mesh& mesh, const Labels& labels, Mesh::Face_index start,
           std::vector<bool>& is_seen)
{
  std::vector<Mesh::Face_index> todo = {start};
  is_seen[start] = true;
  while (!todo.empty()) {
    const Mesh::Face_index face = todo.back();
    todo.pop_back();
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(face))) {
      const Mesh::Face_index other = mesh.face(mesh.opposite(h));
      if (other != Mesh::null_face() && !is_seen[other] && labels[other] == labels[face]) {
        is_seen[other] = true;
        todo.push_back(other);
      }
    }
  }
}

/// Labels are 0 to n - 1 in the order of their first faces, each of one connected part.
void check_labels(const Mesh& mesh, const Labels& labels, std::size_t n)
{
  std::vector<bool> is_seen(mesh.number_of_faces());
  std::size_t number_of_parts = 0;
  for (const auto face : mesh.faces()) {
    if (is_seen[face])
      continue;
    require(labels[face] == number_of_parts, "parts are numbered by first face");
    ++number_of_parts;
    visit(mesh, labels, face, is_seen);
  }
  require(number_of_parts == n, "as many parts as said");
}

std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<bool> is_seen(mesh.number_of_faces());
  const Labels one(mesh.number_of_faces());
  std::size_t number = 0;
  for (const auto face : mesh.faces())
    if (!is_seen[face]) {
      ++number;
      visit(mesh, one, face, is_seen);
    }
  return number;
}

/// The number of faces that are neither degenerate nor doubled.
std::size_t number_of_proper_faces(const RS::Surface& surface)
{
  std::size_t number = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    number += !surface.is_degenerate(f);
  return number;
}

template <typename Method>
void check_method(const Mesh& mesh, const Method& method, std::size_t k)
{
  constexpr bool gives_any_number = !std::is_same<Method, RS::Two_step>::value &&
                                    !std::is_same<Method, RS::Smooth_faces>::value;
  Labels labels(mesh.number_of_faces()), again(labels);
  const auto np = RS::parameters::method(method).component_links(false);
  try {
    const std::size_t n = RS::segment(mesh, face_map(mesh, labels), np.number_of_segments(k));
    check_labels(mesh, labels, n);
    require(n <= (std::max)(k, number_of_components(mesh)), "no more segments than asked for");
    if (gives_any_number)
      require(n >= (std::min)(k, number_of_proper_faces(RS::make_surface(mesh))),
              "no fewer segments than asked for, or than there are proper faces");
    require(RS::segment(mesh, face_map(mesh, again), np.number_of_segments(k)) == n &&
              again == labels,
            "twice the same");
    if constexpr (!std::is_same<Method, RS::Two_step>::value) // the others choose a number
      check_labels(mesh, labels, RS::segment(mesh, face_map(mesh, labels), np));
    require(has_only_finite_points(mesh), "a point that is not finite is refused");
  } catch (const RS::Invalid_input& error) {
    require(!has_only_finite_points(mesh), error.what());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const std::size_t k = 1 + bytes.below(16);
  const Mesh mesh = mesh_from(bytes);
  check_method(mesh, RS::Two_step(), k);
  check_method(mesh, RS::Visibility_merging(), k);
  check_method(mesh, RS::Learned_merging(), k);
  check_method(mesh, RS::Smooth_faces(), k);
  return 0;
}
