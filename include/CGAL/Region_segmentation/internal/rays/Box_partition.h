// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_PARTITION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_PARTITION_H

#include <CGAL/Region_segmentation/internal/rays/Float_4.h>

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

/// An axis-parallel box in float; the last lane is 0.
struct Box
{
  // Empty until a box or point is added.
  Float_4 low = all_lanes((std::numeric_limits<float>::max)());
  Float_4 high = all_lanes(std::numeric_limits<float>::lowest());

  void add(const Box& other)
  {
    low = smaller(other.low, low);
    high = larger(other.high, high);
  }

  void add(const Float_4& point)
  {
    low = smaller(point, low);
    high = larger(point, high);
  }

  float half_area() const
  {
    const Float_4 side = high - low;
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  }
};

/// Boxes with identifiers, to be split into parts whose boxes are small. 28 bytes each.
class Box_partition
{
public:
  using Name = std::uint32_t;
  static constexpr std::size_t group_size = 4; ///< boxes that are tested together, at the cost of one

  /// The boxes `first` .. `last - 1`.
  struct Range
  {
    std::size_t first, last;

    std::size_t size() const { return last - first; }
  };
  /// And the box around them.
  struct Part : Range
  {
    Box box;
  };

  void reserve(std::size_t number) { m_items.reserve(number); }
  void add(const Box& box, Name name)
  {
    m_items.push_back({{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}, name});
  }
  std::size_t size() const { return m_items.size(); }
  Name name(std::size_t i) const { return m_items[i].name; }

  Part whole() const { return make_part(0, m_items.size()); }
  Part single(std::size_t i) const { return make_part(i, i + 1); }

  /// Splits where a ray is expected to intersect the fewest groups: of the bounds between slices of equal width along
  /// the axis on which the centers differ most, the one with the lowest sum over both sides of surface area times
  /// number of groups (Wald 2007). Splits at the median if no bound separates the boxes.
  /// \pre there is more than one box
  std::pair<Part, Part> split(const Part& part)
  {
    const Slicing slicing(*this, part);
    if (!(slicing.width > smallest_width))
      return split_at_median(part, slicing.axis);
    return part.size() > 32 ? split_cheaply<8>(part, slicing) : split_cheaply<4>(part, slicing);
  }

  /// Splits into halves, so that the depth is logarithmic.
  std::pair<Part, Part> split_at_median(const Part& part)
  {
    return split_at_median(part, Slicing(*this, part).axis);
  }

private:
  static constexpr float smallest_width = 1e-30f; // so that its inverse is finite

  /// Packed, since there is one for each patch.
  struct Item
  {
    std::array<float, 3> low, high;
    Name name;

    Box box() const
    {
      Box box;
      box.low = Float_4{low[0], low[1], low[2], 0};
      box.high = Float_4{high[0], high[1], high[2], 0};
      return box;
    }
    /// Twice the center of the box, along one axis.
    float position(std::size_t axis) const { return low[axis] + high[axis]; }
  };

  /// The axis on which the centers of a part differ most, and their range on it.
  struct Slicing
  {
    std::size_t axis;
    float low, width;

    Slicing(const Box_partition& boxes, const Part& part)
    {
      Box positions;
      for (std::size_t i = part.first; i < part.last; ++i) {
        const Box box = boxes.m_items[i].box();
        positions.add(box.low + box.high);
      }
      const Float_4 side = positions.high - positions.low;
      axis = side[0] >= side[1] && side[0] >= side[2] ? 0 : side[1] >= side[2] ? 1 : 2;
      low = positions.low[axis];
      width = side[axis];
    }
  };

  typename std::vector<Item>::iterator item(std::size_t i) { return m_items.begin() + std::ptrdiff_t(i); }

  Part make_part(std::size_t first, std::size_t last) const
  {
    Part part{{first, last}, Box()};
    for (std::size_t i = first; i < last; ++i)
      part.box.add(m_items[i].box());
    return part;
  }

  struct Slice
  {
    Box box;
    std::size_t size = 0;

    void add(const Slice& other)
    {
      box.add(other.box);
      size += other.size;
    }

    float cost() const
    {
      return size > 0 ? box.half_area() * float((size + group_size - 1) / group_size) : 0;
    }
  };

  template <std::size_t slices>
  std::pair<Part, Part> split_cheaply(const Part& part, const Slicing& slicing)
  {
    const float scale = float(slices) / slicing.width;
    const auto slice_of = [=](const Item& item) {
      const float x = scale * (item.position(slicing.axis) - slicing.low);
      return std::size_t(int((std::min)((std::max)(0.f, x), float(slices - 1)))); // 0 if x is not a number
    };
    std::array<Slice, slices> slice;
    for (std::size_t i = part.first; i < part.last; ++i) {
      Slice& s = slice[slice_of(m_items[i])];
      s.box.add(m_items[i].box());
      ++s.size;
    }
    std::array<Slice, slices> behind = slice; // each bound
    for (std::size_t i = slices - 2; i > 0; --i)
      behind[i].add(behind[i + 1]);
    std::size_t best = 0;
    Slice before, before_best;
    float best_cost = (std::numeric_limits<float>::max)();
    for (std::size_t i = 1; i < slices; ++i) {
      before.add(slice[i - 1]);
      const float cost = before.cost() + behind[i].cost();
      if (cost < best_cost && before.size > 0 && behind[i].size > 0) {
        best_cost = cost;
        best = i;
        before_best = before;
      }
    }
    if (best == 0)
      return split_at_median(part, slicing.axis);
    std::partition(item(part.first), item(part.last),
                   [&](const Item& item) { return slice_of(item) < best; });
    const std::size_t middle = part.first + before_best.size;
    return {{{part.first, middle}, before_best.box}, {{middle, part.last}, behind[best].box}};
  }

  std::pair<Part, Part> split_at_median(const Part& part, std::size_t axis)
  {
    const std::size_t middle = part.first + part.size() / 2;
    std::nth_element(item(part.first), item(middle), item(part.last),
                     [axis](const Item& a, const Item& b) {
                       const float p = a.position(axis), q = b.position(axis);
                       return p != q ? p < q : a.name < b.name;
                     });
    return {make_part(part.first, middle), make_part(middle, part.last)};
  }

  std::vector<Item> m_items;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_PARTITION_H
