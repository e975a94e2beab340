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

/// Makes the patches of a surface, the fine ones and the coarse ones, in rounds, see
/// `Surface_patches`.
///
/// In parallel, sums over elements are made by one thread for each patch, in the order of the
/// elements: so they are the same.
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
    const bool is_worth_another = joining.join_faces();
    joining.report();
    if (is_worth_another)
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
    , m_progress(execution)
    , m_execution(execution.silent())
  {}

  /// A round takes a time proportional to the number of patches before it.
  void report() const
  {
    const double faces = double((std::max)(m_surface.number_of_faces(), std::size_t(1)));
    m_progress.report(1 - double(m_patches.size()) / faces);
  }

  /// Makes the coarse patches of the fine ones.
  Surface_patches with_coarse(Patches fine)
  {
    join_patches(Surface_patches::maximum_coarse_area);
    Patches coarse = finish();
    set_centers(
      coarse, [&](std::size_t p) { return fine[p].centroid; },
      [&](std::size_t p) { return squared_norm(fine[p].normal) == 0; });
    return {std::move(fine), std::move(coarse)};
  }

  Element face(std::size_t f, const Double_3& centroid) const
  {
    return {centroid, m_surface.normal(f), m_surface.weight(f), m_surface.weight(f)};
  }

  /// Joins faces in the first round. Returns whether another round is worth its time.
  bool join_faces()
  {
    // The first round of 3 million faces whose neighbors are far apart in memory takes .75 of the
    // time with an array of the centroids.
    Large_array<Double_3> centroids(m_surface.number_of_faces());
    for_each_index(m_execution, centroids.size(),
                   [&](std::size_t f) { centroids[f] = m_surface.centroid(f); });
    const auto for_each_adjacency = [&](const auto& f) {
      for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
        if (!m_surface.has_flag(a, Surface::barrier))
          f(m_surface.lower_face(a), m_surface.higher_face(a));
    };
    Large_array<Index> parents = select(
      centroids.size(), [&](std::size_t f) { return face(f, centroids[f]); }, for_each_adjacency,
      Surface_patches::maximum_area);
    centroids = Large_array<Double_3>(); // Its memory is needed.
    replace_faces(join_every_second_level(parents));
    return has_joined_enough(m_rounds.back());
  }

  void join_patches(double maximum_area)
  {
    const auto patch = [&](std::size_t p) -> const Element& { return m_patches[p]; };
    const auto for_each_adjacency = [&](const auto& f) {
      for (const Adjacency& a : m_adjacencies)
        f(a.lower, a.higher);
    };
    for (bool is_worth_another = true; is_worth_another;) {
      Partition joined = join_every_second_level(
        select(m_patches.size(), patch, for_each_adjacency, maximum_area));
      is_worth_another = has_joined_enough(joined);
      if (joined.number_of_parts() == joined.size())
        return;
      sum_up(joined, patch);
      std::size_t n = 0;
      for (const Adjacency& a : m_adjacencies) {
        const Index p = joined[a.lower], q = joined[a.higher];
        m_adjacencies[n] = {(std::min)(p, q), (std::max)(p, q), a.length};
        n += p != q;
      }
      m_adjacencies.resize(n);
      m_rounds.push_back(std::move(joined));
      report();
    }
  }

  /// Replaces the faces by the patches of a partition.
  void replace_faces(Partition joined)
  {
    m_patches.resize(joined.number_of_parts());
    sum_up(joined, [&](std::size_t f) { return face(f, m_surface.centroid(f)); });
    const auto is_between = [&](std::size_t a) {
      return joined[m_surface.lower_face(a)] != joined[m_surface.higher_face(a)] &&
             !m_surface.has_flag(a, Surface::barrier);
    };
    std::size_t number = 0;
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      number += is_between(a);
    m_adjacencies.reserve(number);
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (is_between(a)) {
        const auto [p, q] = std::minmax(
          {joined[m_surface.lower_face(a)], joined[m_surface.higher_face(a)]});
        m_adjacencies.push_back({p, q, m_surface.length(a)});
      }
    m_rounds.push_back(std::move(joined));
  }

  static bool has_joined_enough(const Partition& joined)
  {
    const std::size_t fewer = joined.size() - joined.number_of_parts();
    return fewer > 0 && fewer >= joined.size() / 32;
  }

  /// Returns for each element the element that it selects, or itself. `maximum_area`: the bound of
  /// the area of both together, as a share of the surface
  template <typename ElementOf, typename ForEachAdjacency>
  Large_array<Index> select(std::size_t size, const ElementOf& element_of,
                            const ForEachAdjacency& for_each_adjacency, double maximum_area) const
  {
    const double largest = maximum_area * m_surface.area(), scale = 1 / m_surface.length_unit();
    Large_array<Float_key> selected(size); // the smallest steps, and the elements at their ends
    for (std::size_t i = 0; i < size; ++i)
      selected[i] = make_float_key(std::numeric_limits<float>::infinity(), Index(i));
    const auto offer = [&](Index i, Float_key key) { // branch-free: the order of steps is random
      const Float_key lowest = selected[i];
      selected[i] = key < lowest ? key : lowest;
    };
    for_each_adjacency([&](Index i, Index j) {
      const Element &a = element_of(i), &b = element_of(j);
      if (!(a.area + b.area <= largest))
        return;
      const float step = float(scale * norm(a.centroid - b.centroid) +
                               Surface_patches::deviation_weight * norm(a.normal - b.normal));
      offer(i, make_float_key(step, j));
      offer(j, make_float_key(step, i));
    });
    // Of two that select each other, the larger one is a root; of equal ones, the lower one.
    Large_array<Index> parents(size);
    for (Index i = 0; i < size; ++i) {
      const Index j = index_of(selected[i]);
      const bool is_larger = i < j ? !(element_of(j).area > element_of(i).area)
                                   : element_of(i).area > element_of(j).area;
      parents[i] = index_of(selected[j]) == i && is_larger ? i : j;
    }
    return parents;
  }

  /// Makes the patches of joined elements. Centroids are summed relative to that of the first
  /// element, to avoid cancellation far from the origin. The elements may be the patches so far:
  /// the number of a part is at most that of its first element, so that what is overwritten was
  /// read before.
  template <typename ElementOf>
  void sum_up(const Partition& joined, const ElementOf& element_of)
  {
    std::vector<Double_3> firsts; // the centroids of the first elements
    firsts.reserve(joined.number_of_parts());
    for (std::size_t i = 0; i < joined.size(); ++i) {
      const Element e = element_of(i);
      Element& sum = m_patches[joined[i]];
      if (joined[i] == firsts.size()) {
        firsts.push_back(e.centroid);
        sum = Element{};
      }
      sum.centroid = sum.centroid + e.area * (e.centroid - firsts[joined[i]]);
      sum.normal = sum.normal + e.projected_area * e.normal;
      sum.area += e.area;
    }
    m_patches.resize(firsts.size());
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
    Patches result = finish();
    set_centers(
      result, [&](std::size_t f) { return m_surface.centroid(f); },
      [&](std::size_t f) { return m_surface.is_degenerate(f); });
    if (!m_surface.has_seams_or_links())
      return result;
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a) {
      const Index p = result.m_of_elements[m_surface.lower_face(a)],
                  q = result.m_of_elements[m_surface.higher_face(a)];
      if (m_surface.has_flag(a, Surface::SEAM | Surface::LINK) && p != q &&
          !m_surface.has_flag(a, Surface::CONSTRAINED))
        result.m_contacts.push_back({(std::min)(p, q), (std::max)(p, q), m_surface.length(a)});
    }
    unite(result.m_contacts);
    return result;
  }

  /// The patches of the rounds since the last call, without centers; their elements are the faces,
  /// or the patches of the last call.
  Patches finish()
  {
    m_patches.shrink_to_fit(); // The first round leaves room for most of the faces.
    Patches result;
    // Composed from the last round on, so that the faces are relabelled once.
    result.m_of_elements = Partition::into_single_elements(m_patches.size());
    for (; !m_rounds.empty(); m_rounds.pop_back())
      result.m_of_elements = composed(m_rounds.back(), result.m_of_elements);
    unite(m_adjacencies);
    result.m_adjacencies = m_adjacencies;
    for (const Element& e : m_patches)
      result.m_patches.push_back({e.centroid, e.normal, e.area, 0});
    return result;
  }

  /// Sorts adjacencies by both patches, and adds up the lengths of those of the same two.
  void unite(Large_array<Adjacency>& adjacencies) const
  {
    // A radix sort of two digits: it keeps the order of the lengths to be added.
    const Grouped_items<Adjacency> by_higher(m_patches.size(), [&](const auto& add) {
      for (const Adjacency& a : adjacencies)
        add(a.higher, a);
    });
    const Grouped_items<Adjacency> by_lower(m_patches.size(), [&](const auto& add) {
      for (const Adjacency& a : by_higher.all())
        add(a.lower, a);
    });
    adjacencies.clear();
    for (const Adjacency& a : by_lower.all())
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
    for_each_in_part(m_execution, patches.m_of_elements, [&](std::size_t p, std::size_t i) {
      const double distance = is_degenerate(i) ? last_choice
                                               : squared_norm(centroid_of(i) - patches[p].centroid);
      if (distance < distances[p]) {
        distances[p] = distance;
        patches.m_patches[p].center = Index(i);
      }
    });
  }

  const Surface& m_surface;
  const Execution m_progress, m_execution; // the latter is silent
  std::vector<Partition> m_rounds; // of the faces or the fine patches, then of the patches of the
                                   // round before
  Large_array<Element> m_patches;
  Large_array<Adjacency> m_adjacencies; // of the patches; until the end several of the same two
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_PATCH_BUILDER_H
