// SPDX-License-Identifier: GPL-3.0-or-later

#include "Subject.h"

namespace speed_benchmark {

std::unique_ptr<Subject> make_openmesh_subject(const Triangles&)
{
  return nullptr;
}

} // namespace speed_benchmark
