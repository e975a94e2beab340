// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FUNCTION_REF_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FUNCTION_REF_H

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Signature>
class Function_ref;

/// A function object by reference, as parameter of functions that are not templates of it: they
/// are compiled once, and each call is indirect.
template <typename Result, typename... Arguments>
class Function_ref<Result(Arguments...)>
{
public:
  template <typename F>
  Function_ref(const F& f)
    : m_function(&f)
    , m_call([](const void* function, Arguments... arguments) -> Result {
      return (*static_cast<const F*>(function))(arguments...);
    })
  {}

  Result operator()(Arguments... arguments) const { return m_call(m_function, arguments...); }

private:
  const void* m_function;
  Result (*m_call)(const void*, Arguments...);
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FUNCTION_REF_H
