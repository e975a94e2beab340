// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_INHERITED_DATA_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_INHERITED_DATA_H

#include <CGAL/Region_segmentation/internal/support/satisfies.h>

// RegionData and SectionData that derive from others: an inherited member function knows no added data

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The class that declares a member function; a call finds none for an overloaded one.
template <typename Function, typename Class>
Class declaring_class(Function Class::*);

template <typename T, typename...>
using Declares_absorb = decltype(declaring_class(&T::absorb));
template <typename T, typename... Section>
using Declares_absorb_template = decltype(declaring_class(&T::template absorb<Section...>));
template <typename T>
using Declares_add_face = decltype(declaring_class(&T::add_face));
template <typename T>
using Declares_add_border_edge = decltype(declaring_class(&T::add_border_edge));
template <typename T>
using Declares_add_edge = decltype(declaring_class(&T::add_edge));

/// Whether `T` inherits the member function that `Declares<T, Types...>` names from a class that does not have all of its
/// data members. A type that adds no data may inherit all.
template <typename T, template <typename...> class Declares, typename... Types>
constexpr bool inherits_for_fewer_data()
{
  if constexpr (satisfies<Declares, T, Types...>)
    return sizeof(Declares<T, Types...>) < sizeof(T);
  else
    return false;
}

template <typename Region, typename Section>
constexpr bool check_inherited_absorb()
{
  static_assert(!inherits_for_fewer_data<Region, Declares_absorb>() &&
                  !inherits_for_fewer_data<Region, Declares_absorb_template, Section>(),
                "a RegionData that adds data members to those of its base class needs its own absorb(): the inherited one "
                "does not merge them");
  static_assert(!inherits_for_fewer_data<Section, Declares_absorb>(),
                "a SectionData that adds data members to those of its base class needs its own absorb(): the inherited one "
                "does not merge them");
  return true;
}

/// For data that no annotator fills.
template <typename Region, typename Section>
constexpr bool check_inherited_sums()
{
  static_assert(!inherits_for_fewer_data<Region, Declares_add_face>() ||
                  !inherits_for_fewer_data<Region, Declares_add_border_edge>(),
                "a RegionData of Geometry_annotator that adds data members to those of its base class needs its own "
                "add_face() or add_border_edge(): the inherited ones do not fill them");
  static_assert(!inherits_for_fewer_data<Section, Declares_add_edge>(),
                "a SectionData of Geometry_annotator that adds data members to those of its base class needs its own "
                "add_edge(): the inherited one does not fill them");
  return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_INHERITED_DATA_H
