// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_PATCH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_PATCH_BUILDER_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The partition that joins elements along the trees of `parents`, in which a root is its own
/// parent. Whole trees would join the patches of a graded mesh in chains without bound; so the
/// trees are cut below the elements of even depth, and a leaf of even depth joins its grandparent:
///
///     depth  0  1  2  3  4
///            o--o  o--o--o      the last one is a leaf
///
/// O(size).
inline Partition join_every_second_level(const Large_array<Partition::Index>& parents)
{
  using Index = Partition::Index;
  constexpr std::uint8_t unknown = 2;
  std::vector<std::uint8_t> parities(parents.size(), unknown), has_child(parents.size(), 0);
  for (Index i = 0; i < parents.size(); ++i) {
    has_child[parents[i]] = 1; // The mark of a root without children has no effect.
    std::size_t depth = 0;     // below the first element whose parity is known, or the root
    Index j = i;
    for (; parities[j] == unknown && parents[j] != j; j = parents[j])
      ++depth;
    depth += parities[j] == 1;
    for (j = i; parities[j] == unknown; j = parents[j])
      parities[j] = depth-- % 2;
  }
  Lowest_root_forest joined(parents.size());
  for (Index i = 0; i < parents.size(); ++i)
    if (parities[i] == 1 || !has_child[i])
      joined.unite(i, parities[i] == 1 ? parents[i] : parents[parents[i]]);
  return joined.take_partition();
}

/// Makes the patches of a surface, the fine ones and the coarse ones, see
/// `Surface_patches`.
class Patch_builder
{
  using Index = Surface::Index;
  using Adjacency = Patches::Adjacency;

public:
  /// Each face is a patch if otherwise there were fewer than `least_number` fine patches, those of
  /// degenerate faces alone not counted.
  static Surface_patches build(const Surface& surface, std::size_t least_number,
                               const Execution& execution)
  {
    Patch_builder joining(surface, execution);
    joining.replace_faces(joining.join_faces());
    joining.join_patches(Surface_patches::maximum_area);
    Patches fine = joining.finish_fine();
    std::size_t number = 0;
    for (std::size_t p = 0; p < fine.size(); ++p)
      number += !surface.is_degenerate(fine[p].center);
    if (number >= least_number)
      return joining.with_coarse(std::move(fine));
    Patch_builder keeping(surface, execution);
    keeping.replace_faces(Partition::into_single_elements(surface.number_of_faces()));
    return keeping.with_coarse(keeping.finish_fine());
  }

  /// Divides patches by the borders of regions of the faces, into connected patches.
  static Patches divided(const Surface& surface, const Patches& patches, const Partition& regions)
  {
    Patch_builder builder(surface, Execution());
    const Partition& patch_of = patches.of_elements();
    builder.replace_faces(label_components(
      surface,
      [&](std::size_t a) {
        const Index f = surface.lower_face(a), g = surface.higher_face(a);
        return patch_of[f] == patch_of[g] && regions[f] == regions[g] &&
               !surface.has_flag(a, Surface::barrier);
      },
      Execution()));
    return builder.finish_fine();
  }

private:
  /// A face or a patch that is to be joined to others.
  struct Element
  {
    Double_3 centroid, normal; // the normal has length 1, or is zero
    double area;
    double projected_area; // the area of its projection along the normal
  };

  Patch_builder(const Surface& surface, const Execution& execution)
    : m_surface(surface)
    , m_execution(execution)
  {}

  /// Makes the coarse patches of the fine ones.
  Surface_patches with_coarse(Patches fine)
  {
    for (const Adjacency& a : fine.adjacencies())
      m_neighbors.push_back({a.lower, a.higher});
    join_patches(Surface_patches::maximum_coarse_area);
    Patches coarse = finish();
    for (const Adjacency& a : fine.adjacencies())
      if (const auto [p, q] = std::minmax(
            {coarse.m_of_elements[a.lower], coarse.m_of_elements[a.higher]});
          p != q)
        coarse.m_adjacencies.push_back({p, q, a.length});
    unite(coarse.m_adjacencies);
    set_centers(
      coarse, [&](std::size_t p) { return fine[p].centroid; },
      [&](std::size_t p) { return squared_norm(fine[p].normal) == 0; });
    return {std::move(fine), std::move(coarse)};
  }

  Element face(std::size_t f) const
  {
    return {m_surface.centroid(f), m_surface.normal(f), m_surface.weight(f), m_surface.weight(f)};
  }

  /// Joins faces to the first patches. Each adjacency is visited once, in order.
  Partition join_faces() const
  {
    const double largest = Surface_patches::maximum_area * m_surface.area(),
                 radius = Surface_patches::maximum_radius * m_surface.length_unit();
    Large_array<std::pair<Index, double>> firsts; // by patch: its first face, and its area so far
    Partition::Numbers patch_of(m_surface.number_of_faces());
    for (Index f = 0, a = 0; f < patch_of.size(); ++f) {
      const Element e = face(f);
      double least = radius * radius;
      Index nearest = Index(firsts.size());
      for (; a < m_surface.number_of_adjacencies() && m_surface.higher_face(a) == f; ++a) {
        const Index p = patch_of[m_surface.lower_face(a)];
        const auto& [first, area] = firsts[p];
        if (m_surface.has_flag(a, Surface::barrier) || !(area + e.area <= largest) ||
            !(norm(e.normal - m_surface.normal(first)) <= Surface_patches::maximum_deviation))
          continue;
        const double distance = squared_norm(e.centroid - m_surface.centroid(first));
        nearest = distance < least ? p : nearest;
        least = (std::min)(least, distance);
      }
      if (nearest == firsts.size())
        firsts.push_back({f, 0});
      firsts[nearest].second += e.area;
      patch_of[f] = nearest;
    }
    return Partition(std::move(patch_of), firsts.size());
  }

  void join_patches(double maximum_area)
  {
    for (bool is_worth_another = true; is_worth_another;) {
      Partition joined = join_every_second_level(select(maximum_area));
      const std::size_t fewer = joined.size() - joined.number_of_parts();
      if (fewer == 0)
        return;
      is_worth_another = fewer >= joined.size() / 32;
      sum_up(joined, [&](std::size_t p) { return m_patches[p]; });
      std::size_t n = 0;
      for (const auto& [i, j] : m_neighbors) {
        const Index p = joined[i], q = joined[j];
        m_neighbors[n] = {p, q};
        n += p != q;
      }
      m_neighbors.resize(n);
      m_rounds.push_back(std::move(joined));
      // A round takes a time proportional to the number of patches before it.
      m_execution.report(1 - double(m_patches.size()) / double(m_surface.number_of_faces()));
    }
  }

  /// Replaces the faces by the patches of a partition.
  void replace_faces(Partition joined)
  {
    sum_up(joined, [&](std::size_t f) { return face(f); });
    for (Index a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (joined[m_surface.lower_face(a)] != joined[m_surface.higher_face(a)])
        m_borders.push_back(a);
    m_borders.shrink_to_fit();
    m_neighbors.reserve(m_borders.size());
    for (const Index a : m_borders)
      if (!m_surface.has_flag(a, Surface::barrier))
        m_neighbors.push_back({joined[m_surface.lower_face(a)], joined[m_surface.higher_face(a)]});
    m_rounds.push_back(std::move(joined));
  }

  /// Returns for each patch the one that it selects, or itself. `maximum_area`: the bound of the
  /// area of both together, as a share of the surface
  Large_array<Index> select(double maximum_area) const
  {
    const double largest = maximum_area * m_surface.area(), scale = 1 / m_surface.length_unit();
    // the smallest steps, and the patches at their ends
    Large_array<Float_key> selected(m_patches.size());
    for (std::size_t i = 0; i < selected.size(); ++i)
      selected[i] = make_float_key(std::numeric_limits<float>::infinity(), Index(i));
    const auto offer = [&](Index i, Float_key key) { // branch-free: the order of steps is random
      const Float_key lowest = selected[i];
      selected[i] = key < lowest ? key : lowest;
    };
    for (const auto& [i, j] : m_neighbors) {
      const Element &a = m_patches[i], &b = m_patches[j];
      if (!(a.area + b.area <= largest))
        continue;
      const float step = float(scale * norm(a.centroid - b.centroid) +
                               Surface_patches::deviation_weight * norm(a.normal - b.normal));
      offer(i, make_float_key(step, j));
      offer(j, make_float_key(step, i));
    }
    // Of two that select each other, the larger one is a root; of equal ones, the lower one.
    Large_array<Index> parents(selected.size());
    for (Index i = 0; i < parents.size(); ++i) {
      const Index j = index_of(selected[i]);
      const double area = m_patches[i].area, other = m_patches[j].area;
      const bool is_larger = i < j ? !(other > area) : area > other;
      parents[i] = index_of(selected[j]) == i && is_larger ? i : j;
    }
    return parents;
  }

  /// Makes the patches of joined elements: in place of these, if they are patches, since no part
  /// has a number above that of its first element. Centroids are summed relative to that of the
  /// first element, to avoid cancellation far from the origin.
  template <typename ElementOf>
  void sum_up(const Partition& joined, const ElementOf& element_of)
  {
    Large_array<Double_3> firsts; // the centroids of the first elements
    firsts.reserve(joined.number_of_parts());
    m_patches.resize((std::max)(m_patches.size(), joined.number_of_parts()));
    for (std::size_t i = 0; i < joined.size(); ++i) {
      const Element e = element_of(i);
      if (joined[i] == firsts.size()) {
        firsts.push_back(e.centroid);
        m_patches[joined[i]] = Element{};
      }
      Element& sum = m_patches[joined[i]];
      sum.centroid = sum.centroid + e.area * (e.centroid - firsts[joined[i]]);
      sum.normal = sum.normal + e.projected_area * e.normal;
      sum.area += e.area;
    }
    m_patches.resize(joined.number_of_parts());
    const auto inverse = [](double x) { return x > 0 ? 1 / x : 0; };
    for (std::size_t p = 0; p < m_patches.size(); ++p) {
      Element& e = m_patches[p];
      e.centroid = firsts[p] + inverse(e.area) * e.centroid;
      e.projected_area = norm(e.normal);
      e.normal = inverse(e.projected_area) * e.normal;
    }
  }

  /// The patches of the rounds so far, with their centers among the faces, and contacts.
  Patches finish_fine()
  {
    m_neighbors = Large_array<std::pair<Index, Index>>(); // The next steps need the memory.
    Patches result = finish();
    set_centers(
      result, [&](std::size_t f) { return m_surface.centroid(f); },
      [&](std::size_t f) { return m_surface.is_degenerate(f); });
    for (const Index a : m_borders) {
      const auto [p, q] = std::minmax({result.m_of_elements[m_surface.lower_face(a)],
                                       result.m_of_elements[m_surface.higher_face(a)]});
      auto& adjacencies = m_surface.has_flag(a, Surface::SEAM | Surface::LINK)
                            ? result.m_contacts
                            : result.m_adjacencies;
      if (p != q)
        result.m_borders.push_back(a);
      if (p != q && !m_surface.has_flag(a, Surface::CONSTRAINED))
        adjacencies.push_back({p, q, m_surface.length(a)});
    }
    unite(result.m_adjacencies);
    unite(result.m_contacts);
    return result;
  }

  /// The patches of the rounds since the last call, without centers; their elements are the faces,
  /// or the patches of the last call.
  Patches finish()
  {
    Patches result;
    // Composed from the last round on, so that the faces are relabelled once.
    result.m_of_elements = Partition::into_single_elements(m_patches.size());
    for (; !m_rounds.empty(); m_rounds.pop_back())
      result.m_of_elements = composed(m_rounds.back(), result.m_of_elements);
    m_patches.shrink_to_fit(); // Rounds leave it as large as at first.
    for (const Element& e : m_patches)
      result.m_patches.push_back({e.centroid, e.normal, e.area, 0});
    return result;
  }

  /// Sorts adjacencies by both patches, and adds up the lengths of those of the same two.
  void unite(Large_array<Adjacency>& adjacencies) const
  {
    // A radix sort of two digits: it keeps the order of the lengths to be added.
    Grouped_items<Adjacency> sorted(m_patches.size(), [&](const auto& add) {
      for (const Adjacency& a : adjacencies)
        add(a.higher, a);
    });
    adjacencies = Large_array<Adjacency>(); // The next step needs the memory.
    sorted = Grouped_items<Adjacency>(m_patches.size(), [&](const auto& add) {
      for (const Adjacency& a : sorted.all())
        add(a.lower, a);
    });
    for (const Adjacency& a : sorted.all())
      if (!adjacencies.empty() && adjacencies.back().lower == a.lower &&
          adjacencies.back().higher == a.higher)
        adjacencies.back().length += a.length;
      else
        adjacencies.push_back(a);
    adjacencies.shrink_to_fit();
  }

  template <typename CentroidOf, typename IsDegenerate>
  void set_centers(Patches& patches, const CentroidOf& centroid_of,
                   const IsDegenerate& is_degenerate) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity(),
                     last_choice = (std::numeric_limits<double>::max)();
    std::vector<double> distances(patches.size(), infinity); // of the centers, squared
    for (std::size_t i = 0; i < patches.m_of_elements.size(); ++i) {
      const Index p = patches.m_of_elements[i];
      const double distance = is_degenerate(i) ? last_choice
                                               : squared_norm(centroid_of(i) - patches[p].centroid);
      if (distance < distances[p]) {
        distances[p] = distance;
        patches.m_patches[p].center = Index(i);
      }
    }
  }

  const Surface& m_surface;
  const Execution m_execution;
  std::vector<Partition> m_rounds; // of the faces or the fine patches, then of the patches of the
                                   // round before
  Large_array<Element> m_patches;
  Large_array<Index> m_borders; // adjacencies of the surface between the first patches
  Large_array<std::pair<Index, Index>> m_neighbors; // patches, several times the same two
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_PATCH_BUILDER_H
