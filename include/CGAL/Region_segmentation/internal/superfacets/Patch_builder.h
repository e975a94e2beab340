// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_BUILDER_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/superfacets/Patch_selection.h>
#include <CGAL/Region_segmentation/internal/superfacets/patch_data.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Makes the patches of a surface, the fine ones and the coarse ones, in rounds, see
/// `Surface_patches`.
///
/// What is summed for a patch or between two of them is summed by one thread, in the order of the
/// elements: so the result is the same in parallel.
class Patch_builder
{
  using Index = Surface::Index;
  using Adjacency = Patches::Adjacency;

public:
  /// \name The patches so far
  /// Their adjacencies in ranges for threads: calls `f(lower, higher, length)`, patches and a
  /// function. Those of the first round are not stored, but found from their faces: they would take
  /// more memory than all else at that time.
  /// @{
  std::size_t size() const { return m_places.size(); }
  double area(std::size_t p) const { return m_places[p].area; }
  const Double_3& centroid(std::size_t p) const { return m_places[p].centroid; }
  const Double_3& normal(std::size_t p) const { return m_directions[p].normal; }
  std::size_t number_of_ranges() const
  {
    return m_adjacencies.empty() ? number_of_edge_ranges() : m_adjacencies.size();
  }
  template <typename F>
  void for_each_adjacency(std::size_t range, const F& f) const
  {
    if (!m_adjacencies.empty()) {
      for (const Adjacency& a : m_adjacencies[range])
        f(a.lower, a.higher, [&] { return a.length; });
      return;
    }
    const Partition& patch_of = m_rounds.front();
    for_each_edge(range, [&](Index lower, Index higher, const auto& length) {
      const Index a = patch_of[lower], b = patch_of[higher];
      if (a != b)
        f((std::min)(a, b), (std::max)(a, b), length);
    });
  }
  /// @}

  static Surface_patches build(const Surface& surface, const Execution& execution)
  {
    Patch_builder builder(surface, execution);
    // A round takes a time proportional to the number of patches before it.
    const auto report = [&] {
      const double faces = double((std::max)(surface.number_of_faces(), std::size_t(1)));
      execution.report(1 - double(builder.m_places.size()) / faces);
    };
    const bool is_worth_another = builder.join_faces(std::nullopt);
    report();
    if (is_worth_another)
      builder.join_patches(Surface_patches::maximum_area * surface.area(), report);
    Surface_patches result;
    result.fine = builder.finish_fine();
    builder.m_adjacencies.push_back(result.fine.m_adjacencies);
    builder.join_patches(Surface_patches::maximum_coarse_area * surface.area(), report);
    result.coarse = builder.finish();
    const Patches& fine = result.fine;
    const auto has_no_normal = [&](std::size_t p) { return squared_norm(fine[p].normal) == 0; };
    Patch_centers coarse_centers(result.coarse.m_patches);
    for (std::size_t p = 0; p < fine.size(); ++p)
      coarse_centers.offer(result.coarse.m_of_elements[p], p, fine[p].centroid, has_no_normal);
    return result;
  }

  /// The connected pieces of patches in regions of the faces.
  static Patches divided(const Surface& surface, const Patches& patches, const Partition& regions)
  {
    Patch_builder builder(surface, Execution());
    const Partition& patch_of = patches.of_elements();
    builder.join_faces(label_components(
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
  Patch_builder(const Surface& surface, const Execution& execution)
    : m_surface(surface)
    , m_execution(execution.silent())
    , m_unit(surface.length_unit())
  {}

  static void set_contacts(Patches& patches, const Surface& surface)
  {
    if (!surface.has_seams_or_links())
      return;
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index p = patches.m_of_elements[surface.lower_face(a)],
                  q = patches.m_of_elements[surface.higher_face(a)];
      if (surface.has_flag(a, Surface::SEAM | Surface::LINK) && p != q &&
          !surface.has_flag(a, Surface::CONSTRAINED))
        patches.m_contacts.push_back({(std::min)(p, q), (std::max)(p, q), surface.length(a)});
    }
    sort_and_unite(patches.m_contacts);
  }

  /// The edges of the mesh that can be crossed, as above.
  template <typename F>
  void for_each_edge(std::size_t range, const F& f) const
  {
    const std::size_t end = (std::min)((range + 1) * edges_in_range(),
                                       m_surface.number_of_adjacencies());
    for (std::size_t e = range * edges_in_range(); e < end; ++e)
      if (!m_surface.has_flag(e, Surface::barrier))
        f(m_surface.lower_face(e), m_surface.higher_face(e), [&] { return m_surface.length(e); });
  }

  std::size_t number_of_edge_ranges() const
  {
    return number_of_blocks(m_surface.number_of_adjacencies(), edges_in_range());
  }

  std::size_t edges_in_range() const
  {
    constexpr std::size_t for_threads = std::size_t(1) << 16;
    return m_execution.is_parallel()
             ? for_threads
             : (std::max)(m_surface.number_of_adjacencies(), std::size_t(1));
  }

  /// The faces as the patches of the first round. Centroids are stored: the first round of 3
  /// million faces whose neighbors are far apart in memory takes .75 of the time without.
  class Faces
  {
  public:
    explicit Faces(const Patch_builder& builder)
      : m_builder(builder)
      , m_mesh(builder.m_surface)
      , m_centroids(size())
    {
      for_each_index(builder.m_execution, size(),
                     [&](std::size_t f) { m_centroids[f] = m_mesh.centroid(f); });
    }

    std::size_t size() const { return m_mesh.number_of_faces(); }
    double area(std::size_t f) const { return m_mesh.weight(f); }
    const Double_3& centroid(std::size_t f) const { return m_centroids[f]; }
    const Double_3& normal(std::size_t f) const { return m_mesh.normal(f); }
    std::size_t number_of_ranges() const { return m_builder.number_of_edge_ranges(); }
    template <typename F>
    void for_each_adjacency(std::size_t range, const F& f) const
    {
      m_builder.for_each_edge(range, f);
    }

  private:
    const Patch_builder& m_builder;
    const Surface& m_mesh;
    Large_array<Double_3> m_centroids;
  };

  /// The first round, which joins the faces of `given` patches, or those that it selects. Returns
  /// whether another one is worth it.
  bool join_faces(std::optional<Partition> given)
  {
    const auto area_of = [this](std::size_t f) { return m_surface.weight(f); };
    {
      const Faces faces(*this);
      m_rounds.push_back(given ? std::move(*given)
                               : select(faces, Surface_patches::maximum_area * m_surface.area()));
      replace_places(m_rounds.back(), area_of, [&](std::size_t f) { return faces.centroid(f); });
    } // the memory of the centroids is needed
    replace_directions(m_rounds.back(),
                       [&](std::size_t f) { return area_of(f) * m_surface.normal(f); });
    return has_joined_enough(m_rounds.back());
  }

  template <typename Report>
  void join_patches(double maximum_area, const Report& report)
  {
    for (bool is_worth_another = true; is_worth_another;) {
      Partition joined = select(*this, maximum_area);
      is_worth_another = has_joined_enough(joined);
      if (joined.number_of_parts() == joined.size())
        return;
      replace_places( // first, since it frees most memory
        joined, [this](std::size_t p) { return area(p); },
        [this](std::size_t p) { return centroid(p); });
      replace_directions(joined, [this](std::size_t p) {
        return m_directions[p].projected_area * m_directions[p].normal;
      });
      replace_adjacencies(joined.number_of_parts(), [&](Index patch) { return joined[patch]; });
      m_rounds.push_back(std::move(joined));
      report();
    }
  }

  static bool has_joined_enough(const Partition& joined)
  {
    const std::size_t fewer = joined.size() - joined.number_of_parts();
    return fewer > 0 && fewer >= joined.size() / 32;
  }

  template <typename Elements>
  Partition select(const Elements& elements, double maximum_area) const
  {
    return Patch_selection(elements, maximum_area, m_unit, Surface_patches::deviation_weight,
                           m_execution)
      .joined();
  }

  template <typename AreaOf, typename CentroidOf>
  void replace_places(const Partition& joined, const AreaOf& area_of, const CentroidOf& centroid_of)
  {
    constexpr Index none = (std::numeric_limits<Index>::max)();
    Large_array<Patch_place> places(joined.number_of_parts());
    Large_array<Index> firsts(places.size());
    for_each_index(m_execution, places.size(), [&](std::size_t p) {
      places[p] = Patch_place{};
      firsts[p] = none;
    });
    for_each_in_part(m_execution, joined, [&](std::size_t part, std::size_t p) {
      firsts[part] = (std::min)(firsts[part], Index(p)); // unpredictable
      places[part].add(area_of(p), centroid_of(p) - centroid_of(firsts[part]));
    });
    for_each_index(m_execution, places.size(),
                   [&](std::size_t p) { places[p].end(centroid_of(firsts[p])); });
    m_places = std::move(places);
  }

  template <typename AreaVector>
  void replace_directions(const Partition& joined, const AreaVector& area_vector)
  {
    Large_array<Patch_direction> directions(joined.number_of_parts());
    for_each_index(m_execution, directions.size(),
                   [&](std::size_t p) { directions[p] = Patch_direction{}; });
    for_each_in_part(m_execution, joined, [&](std::size_t part, std::size_t p) {
      directions[part].add(area_vector(p));
    });
    for_each_index(m_execution, directions.size(), [&](std::size_t p) { directions[p].end(); });
    m_directions = std::move(directions);
  }

  /// By those between the parts `part_of(patch)`; in place, once they are stored.
  template <typename PartOf>
  void replace_adjacencies(std::size_t number_of_parts, const PartOf& part_of)
  {
    if (m_adjacencies.empty()) {
      store_adjacencies(number_of_parts, part_of);
      return;
    }
    m_execution.for_each(0, m_adjacencies.size(), [&](std::size_t range) {
      Large_array<Adjacency>& adjacencies = m_adjacencies[range];
      std::size_t n = 0;
      for (std::size_t i = 0; i < adjacencies.size(); ++i) {
        const Index a = part_of(adjacencies[i].lower), b = part_of(adjacencies[i].higher);
        adjacencies[n] = {(std::min)(a, b), (std::max)(a, b), adjacencies[i].length};
        n += a != b; // unpredictable
      }
      adjacencies.resize(n);
    });
  }

  template <typename PartOf>
  void store_adjacencies(std::size_t number_of_parts, const PartOf& part_of)
  {
    std::vector<Large_array<Adjacency>> result(number_of_ranges());
    m_execution.for_each(0, result.size(), [&](std::size_t range) {
      Large_array<Adjacency>& adjacencies = result[range];
      adjacencies.resize(4 * number_of_parts / result.size() + 1); // usually enough
      std::size_t n = 0;
      for_each_adjacency(range, [&](Index lower, Index higher, const auto& length) {
        const Index a = part_of(lower), b = part_of(higher);
        if (a == b)
          return;
        if (n == adjacencies.size())
          adjacencies.resize(2 * n);
        adjacencies[n++] = {(std::min)(a, b), (std::max)(a, b), length()};
      });
      adjacencies.resize(n);
    });
    m_adjacencies = std::move(result);
  }

  /// The patches of the faces, with their centers and contacts.
  Patches finish_fine()
  {
    Patches result = finish();
    const auto is_degenerate = [&](std::size_t f) { return m_surface.is_degenerate(f); };
    Patch_centers centers(result.m_patches);
    for_each_in_part(m_execution, result.m_of_elements, [&](std::size_t p, std::size_t f) {
      centers.offer(p, f, m_surface.centroid(f), is_degenerate);
    });
    set_contacts(result, m_surface);
    return result;
  }

  /// The patches of the rounds since the last call.
  Patches finish()
  {
    if (m_adjacencies.empty())
      replace_adjacencies(m_places.size(), [](Index patch) { return patch; });
    Patches result;
    result.m_of_elements = take_rounds();
    result.m_adjacencies = united_adjacencies();
    result.m_patches.resize(m_places.size());
    for_each_index(m_execution, m_places.size(), [&](std::size_t p) {
      result.m_patches[p] = {m_places[p].centroid, m_directions[p].normal, m_places[p].area,
                             no_center};
    });
    result.m_concave_deviations = concave_deviations(result.m_patches, result.m_adjacencies,
                                                     m_execution);
    return result;
  }

  /// The partition that the rounds make together: composed from the last one on, so that the faces
  /// are relabelled once.
  Partition take_rounds()
  {
    Partition result = Partition::into_single_elements(m_places.size());
    for (; !m_rounds.empty(); m_rounds.pop_back())
      result = composed(m_rounds.back(), result);
    return result;
  }

  /// One for each two patches, sorted: a radix sort of two digits, since the order of those to be
  /// summed must be kept.
  Large_array<Adjacency> united_adjacencies()
  {
    const Grouped_items<Adjacency> by_higher(m_places.size(), [&](const auto& add) {
      for (const Large_array<Adjacency>& range : m_adjacencies)
        for (const Adjacency& a : range)
          add(a.higher, a);
    });
    m_adjacencies.clear();
    Grouped_items<Adjacency> by_lower(m_places.size(), [&](const auto& add) {
      for (const Adjacency& a : by_higher.all())
        add(a.lower, a);
    });
    Large_array<Adjacency> united = std::move(by_lower).all();
    unite(united);
    return united;
  }

  const Surface& m_surface;
  const Execution m_execution; // silent
  const double m_unit;
  std::vector<Partition> m_rounds; // of the faces or the fine patches, then of the patches of the
                                   // round before
  /// Of the patches, while there are many of them. In two arrays, which are replaced one after the
  /// other: memory is used most then.
  Large_array<Patch_place> m_places;
  Large_array<Patch_direction> m_directions;
  /// By range of edges of the mesh; several between two patches, until the end. Empty before the
  /// second round.
  std::vector<Large_array<Adjacency>> m_adjacencies;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_BUILDER_H
