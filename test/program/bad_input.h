// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_BAD_INPUT_H
#define CGAL_REGION_SEGMENTATION_TEST_BAD_INPUT_H

#include "Temporary_folder.h"
#include "read/errors.h"
#include "read/read_mesh.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

/// A malformed file, and the expected diagnosis.
struct Malformed
{
  const char* name;
  const char* file;
  std::string bytes;
  std::string message; ///< after the name of the file
};

inline std::ostream& operator<<(std::ostream& out, const Malformed& m)
{
  return out << m.name;
}

inline void expect_message(const Malformed& malformed)
{
  const Temporary_folder folder;
  const std::string file = folder.write(malformed.file, malformed.bytes);
  try {
    segment_mesh::read_mesh(file);
    ADD_FAILURE() << "was read";
  } catch (const segment_mesh::Input_error& error) {
    EXPECT_EQ(error.what(), file + malformed.message);
  }
}

#endif // CGAL_REGION_SEGMENTATION_TEST_BAD_INPUT_H
