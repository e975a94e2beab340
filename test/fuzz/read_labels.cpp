// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes, read as a file of labels, of a large and of a small type.

#include "require.h"

#include <CGAL/Region_segmentation/Evaluation/labels.h>

#include <cstdint>
#include <sstream>

namespace RS = CGAL::Region_segmentation;

namespace {

/// What was read is read again from what is written of it.
template <typename Label>
void read(const std::string& text)
{
  try {
    std::istringstream in(text);
    const std::vector<Label> labels = RS::IO::read_labels<Label>(in);
    std::stringstream copy;
    for (const Label label : labels)
      copy << +label << '\n';
    require(labels.empty() || RS::IO::read_labels<Label>(copy) == labels, "labels are read back");
  } catch (const RS::Invalid_input& error) {
    require(std::string(error.what()).rfind("line ", 0) == 0, error.what());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  read<long long>(text);
  read<std::size_t>(text);
  read<std::int16_t>(text);
  return 0;
}
