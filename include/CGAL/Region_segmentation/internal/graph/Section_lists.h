// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_LISTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_LISTS_H

#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <CGAL/Iterator_range.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The incidence of sections and places: section s has the halves 2s and 2s + 1, each in the list
/// of one place. Two places can be united. A list is in the order of insertion.
///
/// Short lists are searched linearly. A hash table finds the sections between two long lists; so a
/// hub of any number of sections costs no more than another place.
///
/// Short lists are stored in the places: with `std::vector`, graph and merging take 1.3 and 1.36
/// times as long on a noisy mesh of 1 million faces.
///
/// Bytes: 80 per place and 8 per section, without its data; more for lists of more than 12
/// sections, and for sections between two long lists.
///
/// \tparam Data the data of a section, stored with its two places, since they are accessed together
template <typename Data>
class Section_lists
{
public:
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// Places that own themselves, as those of `add_place()`.
  explicit Section_lists(std::size_t number_of_places)
    : m_places(number_of_places)
  {
    for (Index p = 0; p < number_of_places; ++p)
      set_owner(p, p);
  }

  /// A place without sections; places are numbered in order. Its owner is a number given by the
  /// caller.
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

  /// The halves in the list of a place, and those of removed sections.
  Iterator_range<const Index*> halves(Index place) const
  {
    const Halves& list = m_places[place].halves;
    return {list.data(), list.data() + list.size()};
  }

  /// The half at p of the section between p and q, or `none`. O(1) expected.
  Index find(Index p, Index q) const
  {
    if (!is_long(p))
      return find_in_short(p, q);
    if (!is_long(q)) {
      const Index half = find_in_short(q, p);
      return half == none ? none : half ^ 1;
    }
    const auto found = m_between_long.find(key(p, q));
    if (found == m_between_long.end())
      return none;
    const Index s = found->second;
    return place(2 * s) == p ? 2 * s : 2 * s + 1;
  }

  /// Removes the section s between two places and unites them: the one with more remaining sections
  /// (`to`, of equal ones) takes over those of the other. If both have a section to a third place,
  /// calls `absorb(kept, removed)`. Returns the remaining place, in expected time linear in the
  /// sections of the other.
  template <typename Absorb>
  Index unite(Index s, Index from, Index to, const Absorb& absorb)
  {
    if (degree(from) > degree(to))
      std::swap(from, to);
    const Index half_at_to = place(2 * s) == to ? 2 * s : 2 * s + 1;
    remove_section(s);
    erase(to, half_at_to);
    for (const Index half : m_places[from].halves) {
      const Index other = place(half ^ 1);
      if (other == none)
        continue;
      const Index twin = find(to, other);
      if (twin == none)
        move(half, to);
      else {
        absorb(twin / 2, half / 2);
        remove_section(half / 2);
        erase(other, half ^ 1);
      }
    }
    m_places[from].halves = Halves();
    m_places[from].degree = 0;
    m_places[from].is_long = 0;
    return to;
  }

private:
  using Halves = boost::container::small_vector<Index, 12>;

  struct Place
  {
    Index owner = none;
    Index degree : 31;
    Index is_long : 1; // the list may then hold halves of removed sections, too; it stays long
    Halves halves;

    Place()
      : degree(0)
      , is_long(0)
    {}
  };
  struct Section
  {
    Index places[2];
    Data data;
  };

  /// With 32, merging takes 1.1 times as long on a noisy mesh of 1 million faces, and 1.3 times in
  /// the default method at 10,000 faces.
  static constexpr std::size_t long_length = 128;

  bool is_long(Index place) const { return m_places[place].is_long; }
  bool is_between_long(Index half) const
  {
    return is_long(place(half)) && is_long(place(half ^ 1));
  }
  bool is_removed(Index half) const { return m_sections[half / 2].places[0] == none; }
  static std::uint64_t key(Index p, Index q)
  {
    return (std::uint64_t((std::min)(p, q)) << 32) | (std::max)(p, q);
  }
  std::uint64_t key(Index s) const { return key(m_sections[s].places[0], m_sections[s].places[1]); }

  Index find_in_short(Index p, Index q) const
  {
    for (Index half : m_places[p].halves)
      if (place(half ^ 1) == q)
        return half;
    return none;
  }

  void append(Index p, Index half)
  {
    Place& place = m_places[p];
    place.halves.push_back(half);
    ++place.degree;
    if (place.is_long)
      enter_if_between_long(half);
    else if (place.halves.size() > long_length) {
      place.is_long = 1;
      for (Index each : place.halves)
        enter_if_between_long(each);
    }
  }

  void enter_if_between_long(Index half)
  {
    if (is_between_long(half))
      m_between_long.emplace(key(half / 2), half / 2);
  }

  void move(Index half, Index to)
  {
    if (is_between_long(half))
      m_between_long.erase(key(half / 2));
    m_sections[half / 2].places[half % 2] = to;
    append(to, half);
  }

  /// Its halves are still to be erased from their lists.
  void remove_section(Index s)
  {
    if (is_between_long(2 * s))
      m_between_long.erase(key(s));
    m_sections[s].places[0] = m_sections[s].places[1] = none;
  }

  /// \pre the half is in the list; its section is removed
  void erase(Index p, Index half)
  {
    Place& place = m_places[p];
    --place.degree;
    if (!is_long(p))
      place.halves.erase(std::find(place.halves.begin(), place.halves.end(), half));
    else if (2 * place.degree < place.halves.size())
      place.halves.erase(std::remove_if(place.halves.begin(), place.halves.end(),
                                        [this](Index each) { return is_removed(each); }),
                         place.halves.end());
  }

  Large_array<Place> m_places;
  Large_array<Section> m_sections;
  std::unordered_map<std::uint64_t, Index> m_between_long; // sections, by their two places
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_SECTION_LISTS_H
