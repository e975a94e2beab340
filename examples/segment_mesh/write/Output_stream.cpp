// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Output_stream.h"

#include "read/errors.h"

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>

#include <cerrno>
#include <iostream>

namespace segment_mesh {

Output_stream::Output_stream(const std::string& file, Compression compression)
  : m_name(file == "-" ? "standard output" : file)
{
  if (file != "-")
    m_file.emplace(file);
  errno = 0;
  if (compression == Compression::NONE)
    return;
  m_compressor.emplace();
  m_compressor->push(boost::iostreams::gzip_compressor());
  m_compressor->push(boost::iostreams::back_inserter(m_compressed));
}

std::ostream& Output_stream::target()
{
  return m_file ? m_file->stream() : std::cout;
}

std::ostream& Output_stream::stream()
{
  return m_compressor ? *m_compressor : target();
}

void Output_stream::commit()
{
  if (m_compressor) {
    m_compressor->reset(); // it is complete
    target().write(m_compressed.data(), std::streamsize(m_compressed.size()));
  }
  if (m_file)
    m_file->commit();
  else if (!std::cout.flush() && errno != EPIPE) // that its reader goes early, as `head` does, is
                                                 // no failure
    throw Output_error(m_name, "cannot be written");
}

} // namespace segment_mesh
