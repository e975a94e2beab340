// SPDX-License-Identifier: GPL-3.0-or-later

// One target of any_mesh.cpp: INPUT is its function.

#include <cstddef>
#include <cstdint>

extern "C" int INPUT(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  return INPUT(data, size);
}
