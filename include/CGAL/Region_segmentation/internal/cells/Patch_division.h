// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CELLS_PATCH_DIVISION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CELLS_PATCH_DIVISION_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/cells/patch_data.h>
#include <CGAL/Region_segmentation/internal/support/divide_parts.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Divides patches of the faces of a surface by regions and constraints: into the connected pieces
/// of each patch in each region, across adjacencies that are not constrained. Pieces on both sides
/// of constrained edges are not adjacent there. None if each patch is in one region: then
/// constrained edges are on borders of regions, or have no effect.
///
/// Patches of one region and without constrained edges stay as they are; the data of the others, of
/// their pieces, are summed over the faces and adjacencies of these in order.
class Patch_division
{
  using Index = Surface::Index;
  using Adjacency = Patches::Adjacency;

public:
  Patch_division(const Surface& surface, const Patches& patches, const Partition& regions,
                 const Constraints& constraints)
    : m_surface(surface)
    , m_patches(patches)
    , m_regions(regions)
    , m_constraints(constraints)
    , m_is_changed(patches.size())
  {
    std::vector<Index> region_of;
    for (std::size_t p = 0; p < patches.size(); ++p)
      region_of.push_back(regions[patches[p].center]);
    for (std::size_t f = 0; f < regions.size(); ++f) {
      const Index patch = patches.of_elements()[f];
      m_is_changed[patch] |= regions[f] != region_of[patch];
    }
  }

  /// The pieces; none if each patch is in one region.
  std::optional<Patches> divided()
  {
    if (std::find(m_is_changed.begin(), m_is_changed.end(), 1) == m_is_changed.end())
      return std::nullopt;
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (m_constraints[a])
        for (const Index f : {m_surface.lower_face(a), m_surface.higher_face(a)})
          m_is_changed[m_patches.of_elements()[f]] = 1;
    const std::vector<Index> adjacencies = adjacencies_of_parts(m_surface, m_patches.of_elements(),
                                                                m_is_changed);
    m_pieces.m_of_elements = divide_parts(
      m_surface, m_patches.of_elements(), m_is_changed, adjacencies, [&](std::size_t a) {
        return !m_constraints[a] &&
               m_regions[m_surface.lower_face(a)] == m_regions[m_surface.higher_face(a)];
      });
    set_patches();
    set_adjacencies(adjacencies);
    return std::move(m_pieces);
  }

private:
  void set_patches()
  {
    m_pieces.m_patches.resize(m_pieces.m_of_elements.number_of_parts());
    for (std::size_t p = 0; p < m_patches.size(); ++p) {
      m_piece_of.push_back(m_pieces.m_of_elements[m_patches[p].center]);
      if (!m_is_changed[p])
        m_pieces.m_patches[m_piece_of[p]] = m_patches[p];
    }
    std::vector<Index> faces;
    for (std::size_t f = 0; f < m_regions.size(); ++f)
      if (m_is_changed[m_patches.of_elements()[f]])
        faces.push_back(Index(f));
    sum_up(faces);
    Patch_centers centers(m_pieces.m_patches);
    const auto is_degenerate = [&](std::size_t f) { return m_surface.is_degenerate(f); };
    for (const Index f : faces)
      centers.offer(m_pieces.m_of_elements[f], f, m_surface.centroid(f), is_degenerate);
  }

  void sum_up(const std::vector<Index>& faces)
  {
    std::vector<Patch_place> places(m_pieces.size());
    std::vector<Patch_direction> directions(m_pieces.size());
    std::vector<Index> first_of(m_pieces.size(), no_center);
    for (const Index f : faces) {
      const Index piece = m_pieces.m_of_elements[f];
      if (first_of[piece] == no_center)
        first_of[piece] = f;
      const double area = m_surface.weight(f);
      places[piece].add(area, m_surface.centroid(f) - m_surface.centroid(first_of[piece]));
      directions[piece].add(area * m_surface.normal(f));
    }
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (first_of[i] != no_center) {
        places[i].end(m_surface.centroid(first_of[i]));
        directions[i].end();
        m_pieces.m_patches[i] = {places[i].centroid, directions[i].normal, places[i].area,
                                 no_center};
      }
  }

  /// `changed`: those of the patches that are changed
  void set_adjacencies(const std::vector<Index>& changed)
  {
    Large_array<Adjacency> across_edges, contacts;
    for (const Index a : changed) {
      const Index p = m_pieces.m_of_elements[m_surface.lower_face(a)],
                  q = m_pieces.m_of_elements[m_surface.higher_face(a)];
      const bool is_contact = m_surface.has_flag(a, Surface::SEAM | Surface::LINK);
      if (p != q && !m_constraints[a])
        (is_contact ? contacts : across_edges)
          .push_back({(std::min)(p, q), (std::max)(p, q), m_surface.length(a)});
    }
    m_pieces.m_adjacencies = with_unchanged(m_patches.adjacencies(), std::move(across_edges));
    m_pieces.m_contacts = with_unchanged(m_patches.contacts(), std::move(contacts));
    m_pieces.m_concave_deviations = concave_deviations(m_pieces.m_patches, m_pieces.m_adjacencies,
                                                       Execution());
  }

  /// Those of changed patches, and those between two others.
  Large_array<Adjacency> with_unchanged(const Large_array<Adjacency>& former,
                                        Large_array<Adjacency> changed) const
  {
    sort_and_unite(changed);
    Large_array<Adjacency> unchanged, result; // pieces are in the order of patches
    for (const Adjacency& a : former)
      if (!m_is_changed[a.lower] && !m_is_changed[a.higher])
        unchanged.push_back({m_piece_of[a.lower], m_piece_of[a.higher], a.length});
    result.reserve(unchanged.size() + changed.size());
    std::merge(unchanged.begin(), unchanged.end(), changed.begin(), changed.end(),
               std::back_inserter(result), is_before);
    return result;
  }

  const Surface& m_surface;
  const Patches& m_patches;
  const Partition& m_regions; // of the faces
  const Constraints& m_constraints;
  std::vector<std::uint8_t> m_is_changed; // by patch
  std::vector<Index> m_piece_of;          // by patch, for those that are not changed
  Patches m_pieces;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CELLS_PATCH_DIVISION_H
