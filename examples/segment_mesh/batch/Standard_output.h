// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_OUTPUT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_OUTPUT_H

#include <cerrno>
#include <iostream>
#include <string>

namespace segment_mesh {

/// Prints on stdout until it fails. That its reader goes early, as `head` does, is no failure.
/// \pre SIGPIPE is ignored; else it ends the program
class Standard_output
{
public:
  void print(const std::string& text)
  {
    errno = 0;
    if (std::cout && !(std::cout << text << std::flush))
      m_has_failed = errno != EPIPE;
  }

  bool has_failed() const { return m_has_failed; }

private:
  bool m_has_failed = false;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_OUTPUT_H
