// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_STREAM_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_STREAM_H

#include "write/Whole_file.h"
#include "write/output_format.h"

#include <boost/iostreams/filtering_stream.hpp>

#include <optional>
#include <ostream>
#include <string>

namespace segment_mesh {

/// Where an output is written to: a file that appears whole or not at all, or stdout; compressed or
/// not.
class Output_stream
{
public:
  /// \throws Output_error if no file can be written there
  Output_stream(const std::string& file, Compression compression);

  std::ostream& stream();
  /// \throws Output_error if anything was not written
  void commit();

private:
  std::ostream& target();

  std::string m_name;
  std::optional<Whole_file> m_file; ///< empty for stdout
  std::string m_compressed; ///< written at the end: a filter before a stream would not see that
                            ///< this fails
  std::optional<boost::iostreams::filtering_ostream> m_compressor;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OUTPUT_STREAM_H
