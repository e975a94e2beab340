// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_LISTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_LISTS_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Lists_in_blocks.h>
#include <CGAL/Region_segmentation/internal/Pair_index.h>
#include <CGAL/Region_segmentation/internal/touch.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which sections meet at which place: section s has the halves 2s and 2s + 1, each in the list of one place.
/// Two places can be made one.
///
/// What is looked for at a place with a short list is found by reading it. A hash table finds the sections
/// between two long lists; so a hub of any number of sections costs no more than another place.
///
/// Bytes: 24 a place, 20 a section beside its data (8 more while lists are written anew), and 6 to 12 for a section
/// between two long lists.
///
/// \tparam Data what is kept of a section, beside its two places: they are looked at together
template <typename Data>
class Section_lists
{
public:
  using Index = std::uint32_t;
  using Ends = std::pair<Index, Index>;
  static constexpr Index none = Pair_index::none;

  void reserve(std::size_t places, std::size_t sections)
  {
    m_lists.reserve(places);
    m_sections.reserve(sections);
  }

  /// A place without sections; places are numbered in order. Its owner is a number of the user's.
  void add_place(Index owner) { m_lists.add(owner); }

  Index owner(Index place) const { return m_lists[place].owner; }
  void set_owner(Index place, Index owner) { m_lists[place].owner = owner; }
  /// The place of a half; `none` if its section was removed.
  Index place(Index half) const { return m_sections[half / 2].places[half % 2]; }
  Data& data(Index section) { return m_sections[section].data; }
  const Data& data(Index section) const { return m_sections[section].data; }
  /// The number of sections at a place.
  std::size_t degree(Index place) const { return m_lists[place].number; }

  /// Adds a section; sections are numbered in order.
  /// \pre there is none between the two places
  void add_section(Index p, Index q, Data data)
  {
    const Index s = Index(m_sections.size());
    m_sections.push_back({{p, q}, std::move(data)});
    const bool were_long = is_long(p) && is_long(q);
    append(p, 1, [=](Index) { return 2 * s; });
    append(q, 1, [=](Index) { return 2 * s + 1; });
    if (were_long)
      m_index.insert(s, ends());
  }

  /// The same as adding them one by one, in O(the places and the sections).
  /// \pre no section was added before
  template <typename Pairs>
  void add_sections(const Pairs& all)
  {
    m_sections.reserve(all.size());
    for (const auto& [p, q] : all) {
      m_sections.push_back({{p, q}, Data()});
      ++m_lists[p].capacity;
      ++m_lists[q].capacity;
    }
    m_lists.lay_out();
    for (Index s = 0; s < all.size(); ++s) {
      m_lists.push_back(all[s].first, 2 * s);
      m_lists.push_back(all[s].second, 2 * s + 1);
      if (is_long(all[s].first) && is_long(all[s].second))
        m_index.insert(s, ends());
    }
  }

  /// \name The list of a place
  /// Positions of its halves. \pre there is one left
  /// @{
  std::size_t first(Index place) const { return not_erased(m_lists[place].begin); }
  std::size_t following(std::size_t position) const { return not_erased(position + 1); }
  Index half(std::size_t position) const { return m_lists.at(position); }
  /// @}

  /// \name Touching
  /// See `touch()`.
  /// @{
  void touch_place(Index place) const { touch(&m_lists[place]); }
  void touch_list(Index place) const
  {
    if (degree(place) > 0)
      touch(&m_lists.at(m_lists[place].begin));
  }
  void touch_section(Index section) const
  {
    touch(&m_sections[section]);
    touch(reinterpret_cast<const char*>(&m_sections[section] + 1) - 1);
  }
  /// @}

  /// Calls `f(half)` for the halves in a list, unless it is long.
  template <typename F>
  void for_each_of_short(Index place, const F& f) const
  {
    if (!is_long(place))
      for (std::size_t i = m_lists[place].begin, end = m_lists[place].end(); i < end; ++i)
        f(m_lists.at(i));
  }

  /// The half at p of the section between p and q, or `none`. O(1) expected.
  Index find(Index p, Index q) const
  {
    if (is_long(p) && is_long(q)) {
      const Index s = m_index.find({p, q}, ends());
      return s == none ? none : place(2 * s) == p ? 2 * s : 2 * s + 1;
    }
    if (!is_long(p))
      return find_in_short(p, q);
    const Index half = find_in_short(q, p);
    return half == none ? none : half ^ 1;
  }

  /// Removes the section s between two places and makes them one: the one that has more sections left
  /// (`to`, of equal ones) takes in the other's. Where both have a section to a third place, calls
  /// `absorb(that is kept, that is removed)`. Returns the place that is left, in O(the sections of the other)
  /// expected.
  template <typename Absorb>
  Index unite(Index s, Index from, Index to, const Absorb& absorb)
  {
    if (degree(from) > degree(to))
      std::swap(from, to);
    const Index half_at_to = place(2 * s) == to ? 2 * s : 2 * s + 1;
    forget(s);
    m_lists.erase(to, half_at_to, is_erased());
    const Neighbors neighbors = neighbors_of_short(to);
    Lists_in_blocks::List& list = m_lists[from];
    // What goes over to `to` gathers at the front of the block.
    Index kept = 0;
    for (std::size_t i = list.begin, end = list.end(); i < end; ++i) {
      const Index half = m_lists.at(i), other = place(half ^ 1);
      if (other == none)
        continue;
      const Index twin = is_long(to) ? find(to, other) : find_among(neighbors, to, other);
      if (twin == none)
        m_lists.at(list.begin + kept++) = half;
      else {
        absorb(twin / 2, half / 2);
        forget(half / 2);
        m_lists.erase(other, half ^ 1, is_erased());
      }
    }
    list.length = list.number = kept;
    hand_over(from, to);
    return to;
  }

private:
  struct Section
  {
    Index places[2];
    Data data;
  };
  struct Ends_of_section
  {
    const Large_array<Section>& sections;
    Ends operator()(Index s) const { return {sections[s].places[0], sections[s].places[1]}; }
  };
  struct Is_erased
  {
    const Large_array<Section>& sections;
    bool operator()(Index half) const { return sections[half / 2].places[0] == none; }
  };
  using Neighbors = std::array<Index, Lists_in_blocks::long_length>;

  bool is_long(Index place) const { return m_lists[place].is_long(); }
  Ends_of_section ends() const { return {m_sections}; }
  Is_erased is_erased() const { return {m_sections}; }

  std::size_t not_erased(std::size_t position) const
  {
    while (is_erased()(m_lists.at(position)))
      ++position;
    return position;
  }

  Index find_in_short(Index p, Index q) const
  {
    for (std::size_t i = m_lists[p].begin, end = m_lists[p].end(); i < end; ++i)
      if (place(m_lists.at(i) ^ 1) == q)
        return m_lists.at(i);
    return none;
  }

  Neighbors neighbors_of_short(Index p) const
  {
    Neighbors result;
    std::size_t i = 0;
    for_each_of_short(p, [&](Index half) { result[i++] = place(half ^ 1); });
    return result;
  }

  /// `find_in_short(p, q)` without a jump that depends on where it is.
  Index find_among(const Neighbors& neighbors, Index p, Index q) const
  {
    Index found = none;
    for (Index i = 0; i < m_lists[p].length; ++i)
      found = neighbors[i] == q ? i : found;
    return found == none ? none : m_lists.at(m_lists[p].begin + found);
  }

  /// A section that is to be erased from the lists that it is in.
  void forget(Index s)
  {
    if (is_long(place(2 * s)) && is_long(place(2 * s + 1)))
      m_index.erase(s, ends());
    m_sections[s].places[0] = m_sections[s].places[1] = none;
  }

  /// All that `from` has goes to the end of the list of `to`.
  void hand_over(Index from, Index to)
  {
    Lists_in_blocks::List& list = m_lists[from];
    const bool from_long = is_long(from), to_long = is_long(to);
    for (std::size_t i = list.begin, end = list.end(); i < end; ++i) {
      const Index half = m_lists.at(i);
      if (from_long && is_long(place(half ^ 1)))
        m_index.erase(half / 2, ends());
      m_sections[half / 2].places[half % 2] = to;
      if (to_long && is_long(place(half ^ 1)))
        m_index.insert(half / 2, ends());
    }
    append(to, list.number, [&](Index i) { return m_lists.at(list.begin + i); });
    list.length = list.number = list.capacity = 0;
  }

  /// If the list becomes long by it, its sections to long ones are indexed.
  template <typename HalfAt>
  void append(Index p, Index number, const HalfAt& half_at)
  {
    const bool was_long = is_long(p);
    m_lists.append(p, number, half_at, is_erased());
    if (!was_long && is_long(p))
      for (std::size_t i = m_lists[p].begin, end = m_lists[p].end(); i < end; ++i)
        if (is_long(place(m_lists.at(i) ^ 1)))
          m_index.insert(m_lists.at(i) / 2, ends());
  }

  Lists_in_blocks m_lists; // of halves, by place
  Large_array<Section> m_sections;
  Pair_index m_index; // of the sections between two long lists
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SECTION_LISTS_H
