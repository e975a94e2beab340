// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/write_page.h"

namespace segment_mesh {

bool can_write_pages()
{
  return false;
}

void write_page(std::ostream&, const Page_content&) {}

} // namespace segment_mesh
