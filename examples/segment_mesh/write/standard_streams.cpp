// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/standard_streams.h"

#include <initializer_list>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace segment_mesh {

void occupy_closed_standard_streams()
{
#if defined(__unix__) || defined(__APPLE__)
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0) // an opened file gets the lowest free descriptor: this one
      static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
#endif
}

} // namespace segment_mesh
