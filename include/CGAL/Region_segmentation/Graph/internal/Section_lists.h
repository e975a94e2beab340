// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_SECTION_LISTS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_SECTION_LISTS_H

#include <CGAL/Iterator_range.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Lists of sections, each at a *place* that one region owns. Section s has two *halves*, 2s and
/// 2s + 1, one in the list of each of its two regions. The lists of two places can be united. A
/// list is in the order of insertion. Removed sections leave a list when they are more than half of
/// it.
///
/// Lists of up to 12 sections are stored inside the places: with `std::vector`, graph and merging
/// take 1.3 and 1.36 times as long on a noisy mesh of 1 million faces.
///
/// Bytes: 80 per place and 8 per section, without its data; more for lists of more than 12.
///
/// \tparam Data the data of a section, stored with its two places, since they are accessed together
template <typename Data>
class Section_lists
{
public:
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// Makes places without sections. Place p is owned by region p.
  explicit Section_lists(std::size_t number_of_places)
    : m_places(number_of_places)
  {
    for (Index p = 0; p < number_of_places; ++p)
      set_owner(p, p);
  }

  /// Adds a place without sections. Places are numbered in order.
  void add_place(Index owner)
  {
    m_places.emplace_back();
    m_places.back().owner = owner;
  }

  Index owner(Index place) const { return m_places[place].owner; }
  void set_owner(Index place, Index owner) { m_places[place].owner = owner; }
  /// The place of a half; `none` if its section was removed.
  Index place(Index half) const { return m_sections[half / 2].places[half % 2]; }
  Data& data(Index section) { return m_sections[section].data; }
  const Data& data(Index section) const { return m_sections[section].data; }
  /// The number of sections at a place.
  std::size_t degree(Index place) const { return m_places[place].degree; }

  /// Adds a section; sections are numbered in order.
  /// \pre there is none between the two places
  void add_section(Index p, Index q, Data data)
  {
    const Index s = Index(m_sections.size());
    m_sections.push_back({{p, q}, std::move(data)});
    append(p, 2 * s);
    append(q, 2 * s + 1);
  }

  /// The halves in the list of a place; some of them can be of removed sections.
  Iterator_range<const Index*> halves(Index place) const
  {
    const Halves& list = m_places[place].halves;
    return {list.data(), list.data() + list.size()};
  }

  /// The half at p of the section between p and q, or `none`. Linear in the shorter list.
  Index find(Index p, Index q) const
  {
    const bool is_shorter = m_places[p].halves.size() <= m_places[q].halves.size();
    for (const Index half : m_places[is_shorter ? p : q].halves)
      if (place(half ^ 1) == (is_shorter ? q : p))
        return is_shorter ? half : half ^ 1;
    return none;
  }

  /// Removes the section s between two places and unites these: the place with more sections (`to`
  /// if both have as many) takes over those of the other one. If both have a section to a third
  /// place, calls `absorb(kept, removed)`. Returns the remaining place. Each section of the removed
  /// place is looked up by `find()`.
  template <typename Absorb>
  Index unite(Index s, Index from, Index to, const Absorb& absorb)
  {
    if (degree(from) > degree(to))
      std::swap(from, to);
    m_sections[s].places = {none, none};
    erase(to);
    for (const Index half : m_places[from].halves) {
      const Index other = place(half ^ 1);
      if (other == none)
        continue;
      const Index twin = find(to, other);
      if (twin == none) {
        m_sections[half / 2].places[half % 2] = to;
        append(to, half);
      } else {
        absorb(twin / 2, half / 2);
        m_sections[half / 2].places = {none, none};
        erase(other);
      }
    }
    m_places[from].halves = Halves();
    m_places[from].degree = 0;
    return to;
  }

private:
  using Halves = boost::container::small_vector<Index, 12>;

  struct Place
  {
    Index owner = none, degree = 0;
    Halves halves; // at most half of them of removed sections
  };
  struct Section
  {
    std::array<Index, 2> places;
    Data data;
  };

  void append(Index p, Index half)
  {
    m_places[p].halves.push_back(half);
    ++m_places[p].degree;
  }

  /// Counts one section less at a place, and shortens its list if half of it is removed.
  void erase(Index p)
  {
    Place& place = m_places[p];
    if (2 * --place.degree < place.halves.size())
      place.halves.erase(std::remove_if(place.halves.begin(), place.halves.end(),
                                        [this](Index half) { return this->place(half) == none; }),
                         place.halves.end());
  }

  std::vector<Place> m_places;
  std::vector<Section> m_sections;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_SECTION_LISTS_H
