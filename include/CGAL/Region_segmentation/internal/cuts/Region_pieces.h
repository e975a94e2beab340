// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_PIECES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_PIECES_H

#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The elements that regions still have while they lose some, in pieces: the connected components
/// of each region. Which pieces are adjacent is known, so whether regions are connected together
/// takes a search over their pieces, not over their elements. (Those took half of the instructions
/// of moving borders on meshes of 30,000 and of 270,000 faces.)
class Region_pieces
{
public:
  using Index = Dual_graph::Index;

  /// \pre the regions are connected
  Region_pieces(const Dual_graph& adjacency, const std::vector<Index>& region_of,
                std::size_t number_of_regions)
    : m_adjacency(adjacency)
    , m_region_of(region_of)
    , m_elements(number_of_regions)
    , m_piece_of(region_of)
    , m_pieces(number_of_regions)
    , m_contacts(number_of_regions)
    , m_region_of_piece(number_of_regions)
    , m_is_waiting(region_of.size(), false)
    , m_is_waiting_piece(number_of_regions, false)
  {
    for (const Index region : region_of)
      m_elements.count(region);
    m_elements.end_counting();
    for (std::size_t e = 0; e < region_of.size(); ++e) {
      m_elements.add(region_of[e], Index(e));
      for (const auto& step : adjacency.steps(e))
        if (region_of[step.face] != region_of[e])
          ++m_contacts[region_of[e]][region_of[step.face]];
    }
    for (std::size_t r = 0; r < number_of_regions; ++r) {
      m_region_of_piece[r] = Index(r);
      if (!m_elements[r].empty())
        m_pieces[r].push_back(Index(r));
    }
  }

  /// Whether the region of an element still has it.
  bool has(Index element) const { return m_piece_of[element] != none; }

  /// Whether a region has any left.
  bool has_elements(Index region) const { return !m_pieces[region].empty(); }

  /// Calls `f(element)` for the elements that a region still has, in order.
  template <typename F>
  void for_each_element(Index region, const F& f) const
  {
    for (const Index element : m_elements[region])
      if (has(element))
        f(element);
  }

  /// Takes elements from their regions.
  void remove(const std::vector<Index>& elements)
  {
    std::vector<Index> touched;
    for (const Index element : elements) {
      detach(element);
      touched.push_back(m_region_of[element]);
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const Index region : touched)
      find_pieces(region);
  }

  /// The connected components of the elements that regions have together, each in order; nothing if
  /// there is only one.
  std::vector<std::vector<Index>> components(const std::vector<Index>& regions)
  {
    std::vector<std::vector<Index>> pieces_of;
    for (const Index region : regions)
      for (const Index piece : m_pieces[region])
        m_is_waiting_piece[piece] = true;
    for (const Index region : regions)
      for (const Index piece : m_pieces[region])
        if (m_is_waiting_piece[piece])
          pieces_of.push_back(waiting_pieces(piece));
    if (pieces_of.size() < 2)
      return {};
    std::vector<std::vector<Index>> result;
    for (const std::vector<Index>& pieces : pieces_of)
      result.push_back(elements_of(pieces));
    return result;
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  void detach(Index element)
  {
    const Index piece = m_piece_of[element];
    for (const auto& step : m_adjacency.steps(element))
      if (const Index other = m_piece_of[step.face]; other != none && other != piece) {
        remove_contact(piece, other);
        remove_contact(other, piece);
      }
    m_piece_of[element] = none;
  }

  void remove_contact(Index piece, Index other)
  {
    const auto contact = m_contacts[piece].find(other);
    if (--contact->second == 0)
      m_contacts[piece].erase(contact);
  }

  /// The first component of a piece remains that piece.
  void find_pieces(Index region)
  {
    std::vector<Index> pieces;
    for_each_element(region, [&](Index element) { m_is_waiting[element] = true; });
    for_each_element(region, [&](Index element) {
      if (!m_is_waiting[element])
        return;
      const std::vector<Index> component = waiting_elements(element);
      Index piece = m_piece_of[element];
      if (std::find(pieces.begin(), pieces.end(), piece) != pieces.end())
        piece = make_piece(component);
      pieces.push_back(piece);
    });
    m_pieces[region] = std::move(pieces);
  }

  /// What a search reaches from a waiting element or piece through waiting ones, which do not wait
  /// any more then. `for_each_neighbor(i, f)`: calls `f(neighbor)`
  template <typename ForEachNeighbor>
  static std::vector<Index> waiting_component(Index first, std::vector<char>& is_waiting,
                                              const ForEachNeighbor& for_each_neighbor)
  {
    std::vector<Index> result{first};
    is_waiting[first] = false;
    for (std::size_t i = 0; i < result.size(); ++i)
      for_each_neighbor(result[i], [&](Index neighbor) {
        if (is_waiting[neighbor]) {
          is_waiting[neighbor] = false;
          result.push_back(neighbor);
        }
      });
    return result;
  }

  std::vector<Index> waiting_elements(Index first)
  {
    return waiting_component(first, m_is_waiting, [this](Index element, const auto& f) {
      for (const auto& step : m_adjacency.steps(element))
        f(step.face);
    });
  }

  std::vector<Index> waiting_pieces(Index first)
  {
    return waiting_component(first, m_is_waiting_piece, [this](Index piece, const auto& f) {
      for (const auto& contact : m_contacts[piece])
        f(contact.first);
    });
  }

  /// Of a component of a piece.
  Index make_piece(const std::vector<Index>& elements)
  {
    const Index old = m_piece_of[elements.front()], piece = Index(m_contacts.size());
    m_contacts.emplace_back();
    m_region_of_piece.push_back(m_region_of[elements.front()]);
    m_is_waiting_piece.push_back(false);
    for (const Index element : elements) {
      m_piece_of[element] = piece;
      for (const auto& step : m_adjacency.steps(element))
        if (const Index other = m_piece_of[step.face];
            other != none && other != old && other != piece) {
          remove_contact(old, other);
          remove_contact(other, old);
          ++m_contacts[piece][other];
          ++m_contacts[other][piece];
        }
    }
    return piece;
  }

  /// In order.
  std::vector<Index> elements_of(const std::vector<Index>& pieces) const
  {
    std::vector<Index> result;
    for (const Index piece : pieces)
      for_each_element(m_region_of_piece[piece], [&](Index element) {
        if (m_piece_of[element] == piece)
          result.push_back(element);
      });
    std::sort(result.begin(), result.end());
    return result;
  }

  const Dual_graph& m_adjacency;
  const std::vector<Index>& m_region_of;          // by element
  Grouped_items<Index> m_elements;                // by region
  std::vector<Index> m_piece_of;                  // by element; none if its region lost it
  std::vector<std::vector<Index>> m_pieces;       // by region
  std::vector<std::map<Index, Index>> m_contacts; // by piece: the number of pairs of adjacent
                                                  // elements, by the other piece
  std::vector<Index> m_region_of_piece;
  std::vector<char> m_is_waiting, m_is_waiting_piece; // to be reached by a search
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_REGION_PIECES_H
