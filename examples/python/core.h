// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PYTHON_CORE_H
#define CGAL_REGION_SEGMENTATION_PYTHON_CORE_H

#include "soup/Polygon_soup.h"

#include <pybind11/numpy.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <chrono>
#include <cstdint>
#include <vector>

namespace py = pybind11;

using Soup = segment_mesh::Polygon_soup;
template <typename T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;
using Labels = std::vector<std::int32_t>;

template <typename T>
std::vector<T> to_vector(const Array<T>& array)
{
  return {array.data(), array.data() + array.size()};
}

template <typename T>
Array<T> to_array(const std::vector<T>& values)
{
  return Array<T>(py::ssize_t(values.size()), values.data());
}

/// A visitor that lets Python handle signals, such as that of Ctrl-C, and calls `progress(stage,
/// fraction)`, unless that is None: at the begin of each stage, and 20 times a second. It cancels
/// if the value that is returned is false, but not None.
class Visitor
{
public:
  explicit Visitor(py::object progress)
    : m_progress(std::move(progress))
  {}

  bool on_progress(const char* stage, double fraction)
  {
    const auto now = std::chrono::steady_clock::now();
    if (stage == m_stage && now - m_time < std::chrono::milliseconds(50))
      return true;
    m_stage = stage;
    m_time = now;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (m_progress.is_none())
      return true;
    const py::object result = m_progress(stage, fraction);
    return result.is_none() || py::bool_(result);
  }

private:
  const py::object m_progress;
  const char* m_stage = nullptr;
  std::chrono::steady_clock::time_point m_time;
};

/// Calls `f(visitor)` without the lock of the interpreter, on a number of threads, 0 for as many as
/// there are cores; without TBB on one.
template <typename F>
auto run([[maybe_unused]] int threads, const py::object& progress, const F& f)
{
  Visitor visitor(progress);
  const py::gil_scoped_release release;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  return arena.execute([&] { return f(visitor); });
#else
  return f(visitor);
#endif
}

/// The functions that need an oriented 2-manifold; their results are described by the module's
/// functions in Python that call them.
void define_functions_of_segments(py::module_& module);

#endif // CGAL_REGION_SEGMENTATION_PYTHON_CORE_H
