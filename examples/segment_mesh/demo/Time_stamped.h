// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TIME_STAMPED_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TIME_STAMPED_H

#include <CGAL/tags.h>

#include <cstddef>

namespace segment_mesh {

/// A vertex or cell of a triangulation that knows when it was made. \cgal orders and hashes handles
/// by that then, and by addresses else, which differ from run to run.
template <typename Base>
class Time_stamped : public Base
{
public:
  using Has_timestamp = CGAL::Tag_true;

  template <typename Triangulation_data_structure>
  struct Rebind_TDS
  {
    using Other =
      Time_stamped<typename Base::template Rebind_TDS<Triangulation_data_structure>::Other>;
  };

  using Base::Base;
  Time_stamped() = default;

  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(std::size_t time_stamp) { m_time_stamp = time_stamp; }

private:
  std::size_t m_time_stamp = std::size_t(-1);
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TIME_STAMPED_H
