// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes, read as a gzip file.

#include "read/errors.h"
#include "read/inflate.h"
#include "require.h"

#include <algorithm>

using namespace segment_mesh;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (!is_gzip(bytes))
    return -1; // not for the corpus
  try {
    Remarks remarks;
    require(inflate("x", bytes, remarks).size() <=
              (std::max)(harmless_size, largest_inflation * size),
            "growth is bounded");
  } catch (const Input_error& error) {
    require(std::string(error.what()).rfind("x: is a", 0) == 0, error.what());
  }
  return 0;
}
