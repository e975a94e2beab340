// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/output_format.h"

#include "read/errors.h"
#include "read/read_mesh.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>

namespace segment_mesh {

namespace {

/// The formats by the words for them, in the order of `Output_format`.
const std::vector<std::string> format_names = {"seg", "ply",  "off", "obj", "vtp", "json", "csv",
                                               "png", "html", "glb", "3mf", "stl", "msh",  "step"};

/// The names of stdout that systems give it.
bool names_stdout(const std::string& file)
{
  const std::string names[] = {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
  return std::find(std::begin(names), std::end(names), file) != std::end(names);
}

/// The format that a word names, if there is one.
std::optional<Output_format> format_of_word(const std::string& word)
{
  const auto found = std::find(format_names.begin(), format_names.end(), word);
  if (found == format_names.end())
    return std::nullopt;
  return Output_format(found - format_names.begin());
}

bool is_mesh(Output_format format)
{
  return format == Output_format::PLY || format == Output_format::OFF ||
         format == Output_format::OBJ || format == Output_format::VTP ||
         format == Output_format::STL || format == Output_format::GLB ||
         format == Output_format::THREE_MF || format == Output_format::MSH;
}

void check(const Output& output)
{
  if (output.content == Output_content::BORDERS && output.format != Output_format::OBJ)
    throw Usage_error("--borders " + output.file + ": polylines are written as .obj");
  if (output.is_for_each_segment()) {
    if (output.content == Output_content::BORDERS)
      throw Usage_error("--borders " + output.file + ": {segment} is for -o alone");
    if (!is_mesh(output.format))
      throw Usage_error(
        output.file +
        ": a file for each segment is .ply, .off, .obj, .vtp, .stl, .glb, .3mf or .msh");
  }
}

} // namespace

bool has_names(Output_format format)
{
  return format == Output_format::OBJ || format == Output_format::STL ||
         format == Output_format::GLB || format == Output_format::THREE_MF ||
         format == Output_format::MSH;
}

std::string with_segment(const std::string& file, const std::string& number)
{
  return boost::replace_all_copy(file, segment_placeholder, number);
}

std::string material_library(const Output& output)
{
  if (output.format != Output_format::OBJ || output.content == Output_content::BORDERS ||
      is_written_directly(output.file))
    return "";
  std::filesystem::path file = output.file;
  if (output.compression != Compression::NONE)
    file.replace_extension();
  return file.replace_extension(".mtl").string();
}

Output make_output(const std::string& text, Output_content content)
{
  const std::size_t colon = (std::min)(text.find(':'), text.size());
  std::optional<Output_format> format = format_of_word(text.substr(0, colon));
  const std::string file = format && colon < text.size() ? text.substr(colon + 1) : text;
  Output output{names_stdout(file) ? standard_output : file, Output_format::SEG, content,
                Compression::NONE};
  std::filesystem::path name = file;
  if (ending_of(file) == "gz") {
    output.compression = Compression::GZIP;
    name.replace_extension();
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored))
    throw Usage_error(file + ": is a folder; a file in it is named as " +
                      (name / "{stem}.ply").string());
  if (output.is_stdout() && content == Output_content::BORDERS)
    throw Usage_error("--borders -: borders are written to a file");
  if (file == text) // no format before a colon
    format = format_of_word(ending_of(name.string()));
  if (!format && !name.has_extension() && is_written_directly(file))
    throw Usage_error("-o " + file + ": needs a format, as in -o ply:" + file);
  if (!format)
    throw Usage_error(file + ": unknown extension of an output, not " +
                      list_of_endings(format_names));
  output.format = *format;
  if ((content == Output_content::SOLIDS && !is_mesh(output.format)) ||
      (content == Output_content::PAINTED && output.format != Output_format::THREE_MF))
    output.content = Output_content::SEGMENTS;
  check(output);
  return output;
}

} // namespace segment_mesh
