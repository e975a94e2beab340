// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_BUILDER_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Mesh_patches.h>
#include <CGAL/Region_segmentation/internal/reading/Patch_selection.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Makes the patches of a mesh, in rounds, see `Mesh_patches`.
class Patch_builder
{
  using Index = Flat_mesh::Index;
  using Patch = Mesh_patches::Patch;
  using Adjacency = Mesh_patches::Adjacency;

public:
  /// \pre the mesh was read with its centroids and the area of its surface
  template <typename ConcurrencyTag>
  static Mesh_patches build(const Flat_mesh& mesh, const Execution<ConcurrencyTag>& execution)
  {
    Patch_builder builder(mesh);
    // A round takes a time proportional to the number of patches before it.
    const auto report = [&] {
      execution.report(1 - double(builder.m_patches.size()) / double((std::max)(mesh.number_of_faces(), std::size_t(1))));
    };
    builder.join_faces();
    for (report(); builder.join_patches();)
      report();
    return builder.finish();
  }

  /// The parts of a partition as patches.
  static Mesh_patches build(const Flat_mesh& mesh, Partition of_faces)
  {
    Patch_builder builder(mesh);
    builder.m_rounds.push_back(std::move(of_faces));
    builder.replace_patches(Faces(mesh), builder.m_rounds.back());
    return builder.finish();
  }

private:
  explicit Patch_builder(const Flat_mesh& mesh)
    : m_mesh(mesh)
    , m_maximum_area(Mesh_patches::maximum_area * mesh.surface_area())
    , m_unit(mesh.relative_unit())
  {}

  /// The faces as the patches of the first round.
  class Faces
  {
  public:
    explicit Faces(const Flat_mesh& mesh) : m_mesh(mesh) {}
    std::size_t size() const { return m_mesh.number_of_faces(); }
    double area(std::size_t f) const { return m_mesh.area(f); }
    const Double_3& centroid(std::size_t f) const { return m_mesh.centroid(f); }
    const Double_3& normal(std::size_t f) const { return m_mesh.normal(f); }
    template <typename F>
    void for_each_adjacency(const F& f) const
    {
      for (std::size_t e = 0; e < m_mesh.number_of_edges(); ++e)
        if (!m_mesh.has_flag(e, Flat_mesh::CONSTRAINED))
          f(m_mesh.lower_face(e), m_mesh.higher_face(e), e);
    }
    double length(std::size_t e) const { return m_mesh.length(e); }
    Double_3 area_vector(std::size_t f) const { return m_mesh.area(f) * m_mesh.normal(f); }

  private:
    const Flat_mesh& m_mesh;
  };

  /// The patches of a later round. Before the second one their adjacencies are those of their faces: to store them would take
  /// more memory than all else at that time.
  class Joined
  {
  public:
    explicit Joined(const Patch_builder& builder) : m_builder(builder) {}
    std::size_t size() const { return m_builder.m_patches.size(); }
    double area(std::size_t p) const { return m_builder.m_patches[p].area; }
    const Double_3& centroid(std::size_t p) const { return m_builder.m_patches[p].centroid; }
    const Double_3& normal(std::size_t p) const { return m_builder.m_patches[p].normal; }
    template <typename F>
    void for_each_adjacency(const F& f) const
    {
      if (m_builder.m_rounds.size() > 1) {
        const Large_array<Adjacency>& adjacencies = m_builder.m_adjacencies;
        for (std::size_t i = 0; i < adjacencies.size(); ++i)
          f(adjacencies[i].lower, adjacencies[i].higher, i);
        return;
      }
      const Partition& patch_of = m_builder.m_rounds.front();
      Faces(m_builder.m_mesh).for_each_adjacency([&](Index lower, Index higher, std::size_t e) {
        const Index a = patch_of[lower], b = patch_of[higher];
        if (a != b)
          f((std::min)(a, b), (std::max)(a, b), e);
      });
    }
    double length(std::size_t i) const
    {
      return m_builder.m_rounds.size() > 1 ? m_builder.m_adjacencies[i].length : m_builder.m_mesh.length(i);
    }
    Double_3 area_vector(std::size_t p) const
    {
      return m_builder.m_projected_areas[p] * m_builder.m_patches[p].normal;
    }

  private:
    const Patch_builder& m_builder;
  };

  void join_faces()
  {
    const Faces faces(m_mesh);
    m_rounds.push_back(select(faces));
    replace_patches(faces, m_rounds.back());
  }

  /// Returns whether it is worth another round.
  bool join_patches()
  {
    const Joined patches(*this);
    const std::size_t before = patches.size();
    Partition joined = select(patches);
    if (joined.number_of_parts() == before)
      return false;
    replace_patches(patches, joined); // first, since it frees most memory
    replace_adjacencies(joined.number_of_parts(), [&](Index patch) { return joined[patch]; });
    m_rounds.push_back(std::move(joined));
    return before - m_patches.size() >= before / 32;
  }

  template <typename Patches>
  Partition select(const Patches& patches) const
  {
    return Patch_selection(patches, m_maximum_area, m_unit, Mesh_patches::deviation_weight).joined();
  }

  template <typename Patches>
  void replace_patches(const Patches& patches, const Partition& joined)
  {
    Large_array<Patch> result(joined.number_of_parts(), Patch{{0, 0, 0}, {0, 0, 0}, 0, none});
    for (std::size_t p = 0; p < joined.size(); ++p) {
      Patch& patch = result[joined[p]];
      const double area = patches.area(p);
      // Relative to the first of them, to avoid cancellation far from the origin.
      if (patch.face == none)
        patch.face = Index(p);
      patch.centroid = patch.centroid + area * (patches.centroid(p) - patches.centroid(patch.face));
      patch.normal = patch.normal + patches.area_vector(p);
      patch.area += area;
    }
    Large_array<double> projected_areas;
    projected_areas.reserve(result.size());
    for (Patch& patch : result) {
      const double length = norm(patch.normal);
      projected_areas.push_back(length);
      patch.normal = length > 0 ? (1 / length) * patch.normal : Double_3{0, 0, 0};
      patch.centroid = patches.centroid(patch.face) + (patch.area > 0 ? 1 / patch.area : 0) * patch.centroid;
    }
    m_patches = std::move(result);
    m_projected_areas = std::move(projected_areas);
  }

  /// By those between the parts `part_of(patch)`.
  template <typename PartOf>
  void replace_adjacencies(std::size_t number_of_parts, const PartOf& part_of)
  {
    const Joined patches(*this);
    Large_array<Adjacency> adjacencies;
    adjacencies.reserve(4 * number_of_parts); // usually enough
    patches.for_each_adjacency([&](Index lower, Index higher, std::size_t i) {
      const Index a = part_of(lower), b = part_of(higher);
      if (a != b)
        adjacencies.push_back({(std::min)(a, b), (std::max)(a, b), patches.length(i)});
    });
    m_adjacencies = std::move(adjacencies);
  }

  Mesh_patches finish()
  {
    if (m_rounds.size() == 1)
      replace_adjacencies(m_patches.size(), [](Index patch) { return patch; });
    compose_rounds();
    unite_adjacencies();
    set_faces();
    Mesh_patches result;
    result.m_of_faces = std::move(m_rounds.front());
    result.m_patches = std::move(m_patches);
    result.m_adjacencies = std::move(m_adjacencies);
    result.m_concave_deviations.reserve(result.m_adjacencies.size());
    for (const Adjacency& a : result.m_adjacencies)
      result.m_concave_deviations.push_back(concave_deviation(result.m_patches[a.lower], result.m_patches[a.higher]));
    return result;
  }

  /// From the last one on, so that the faces are relabelled once.
  void compose_rounds()
  {
    while (m_rounds.size() > 1) {
      const Partition last = std::move(m_rounds.back());
      m_rounds.pop_back();
      m_rounds.back() = composed(m_rounds.back(), last);
    }
  }

  /// One for each two patches, sorted.
  void unite_adjacencies()
  {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(m_adjacencies.size());
    for (const Adjacency& a : m_adjacencies)
      keys.push_back({(std::uint64_t(a.lower) << 32) | a.higher, std::uint32_t(keys.size())});
    boost::sort::spreadsort::integer_sort(
      keys.begin(), keys.end(), [](const auto& key, unsigned offset) { return key.first >> offset; });
    Large_array<Adjacency> united;
    united.reserve(keys.size());
    for (const auto& key : keys) {
      const Adjacency& a = m_adjacencies[key.second];
      if (!united.empty() && united.back().lower == a.lower && united.back().higher == a.higher)
        united.back().length += a.length;
      else
        united.push_back(a);
    }
    m_adjacencies = std::move(united);
  }

  /// The face of each patch nearest to its centroid, a degenerate one only if there is no other.
  void set_faces()
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Partition& patch_of = m_rounds.front();
    std::vector<double> distances(m_patches.size(), infinite);
    for (Patch& patch : m_patches)
      patch.face = none;
    for (std::size_t f = 0; f < m_mesh.number_of_faces(); ++f) {
      Patch& patch = m_patches[patch_of[f]];
      const double distance =
        m_mesh.is_degenerate(f) ? infinite : squared_norm(m_mesh.centroid(f) - patch.centroid);
      if (distance < distances[patch_of[f]] || patch.face == none) {
        distances[patch_of[f]] = distance;
        patch.face = Index(f);
      }
    }
  }

  static double concave_deviation(const Patch& a, const Patch& b)
  {
    if (squared_norm(a.normal) == 0 || squared_norm(b.normal) == 0 ||
        !(dot(b.normal - a.normal, b.centroid - a.centroid) < 0))
      return 0;
    return std::acos((std::max)(-1.0, (std::min)(1.0, dot(a.normal, b.normal))));
  }

  static constexpr Index none = (std::numeric_limits<Index>::max)();

  const Flat_mesh& m_mesh;
  const double m_maximum_area, m_unit;
  std::vector<Partition> m_rounds; // of the faces, then of the patches of the round before
  Large_array<Patch> m_patches;
  Large_array<double> m_projected_areas; // of each patch on the plane of its normal: the length of its area vector
  Large_array<Adjacency> m_adjacencies; // from the second round on; several between two patches, until the end
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_BUILDER_H
