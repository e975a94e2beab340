// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_segmentation.h"

#include "page/page.h"
#include "read/errors.h"
#include "view/render_view.h"
#include "write/Text_buffer.h"
#include "write/Whole_file.h"
#include "write/write_mesh.h"

#include <boost/iostreams/compose.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

namespace segment_mesh {

namespace {

/// With no other points than those of borders.
void write_borders(std::ostream& out, const Result& result)
{
  constexpr std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> new_index(result.input.soup.points.size(), unused);
  std::vector<Point> points;
  std::vector<Border> borders = result.details.borders();
  for (Border& border : borders)
    for (std::size_t& i : border.points) {
      if (new_index[i] == unused) {
        new_index[i] = points.size();
        points.push_back(result.input.soup.points[i]);
      }
      i = new_index[i];
    }
  write_borders_obj(out, points, borders);
}

std::string folder_of(const Output& output)
{
  return is_written_directly(output.file)
           ? ""
           : std::filesystem::path(output.file).parent_path().string();
}

/// A mesh, the whole or a part of `result`; or, in a format that is not of meshes, all of `result`.
/// `materials`: the names of the files of those of .obj, of images of .ply
void write_segments(std::ostream& out, const Output& output, const Result& result,
                    const Labelled_mesh& mesh, const std::vector<std::string>& materials)
{
  switch (output.format) {
  case Output_format::SEG:
    return write_seg(out, result);
  case Output_format::PLY:
    return write_ply(out, mesh, materials);
  case Output_format::OFF:
    return write_off(out, mesh);
  case Output_format::OBJ:
    return write_obj(out, mesh, materials);
  case Output_format::VTP:
    return write_vtp(out, mesh);
  case Output_format::JSON:
    return write_json(out, result);
  case Output_format::CSV:
    return write_csv(out, result);
  case Output_format::PNG:
    return write_view(out, result);
  case Output_format::HTML:
    return write_html(out, result);
  case Output_format::GLB:
    return write_glb(out, mesh, folder_of(output));
  case Output_format::THREE_MF:
    return output.content == Output_content::PAINTED ? write_painted_3mf(out, mesh)
                                                     : write_3mf(out, mesh);
  case Output_format::STL:
    return write_stl(out, mesh);
  case Output_format::MSH:
    return write_msh(out, mesh);
  case Output_format::STEP: // by write_solid()
    break;
  }
}

/// Writes the text of `write(stream)`, and compresses it if wanted. The compressed text is written
/// at the end: a filter before a stream would not see that this fails.
template <typename Write>
void write_stream(std::ostream& out, Compression compression, const Write& write)
{
  if (compression == Compression::NONE) {
    write(out);
    return;
  }
  std::string compressed;
  boost::iostreams::filtering_ostream compressor(boost::iostreams::gzip_compressor() |
                                                 boost::iostreams::back_inserter(compressed));
  write(compressor);
  compressor.reset(); // it is complete
  out.write(compressed.data(), std::streamsize(compressed.size()));
}

/// The names of files of materials or images of the input, as seen from an output.
std::vector<std::string>
files_of_input(const Output& output, const Mesh_properties& properties,
               std::vector<std::string> Material_library::*files = &Material_library::files)
{
  std::vector<std::string> names;
  if (properties.library)
    for (const std::string& name : properties.library.get()->*files)
      names.push_back(one_line(relative_name(properties.library->folder, name, folder_of(output))));
  return names;
}

/// \throws Output_error if the materials of segments would take the place of those of the input
void check_library(const std::string& library, const Output& output, const Result& result)
{
  const std::string name = relative_name("", library, folder_of(output));
  for (const std::string& file : files_of_input(output, result.input.properties))
    if (name == file)
      throw Output_error(output.file, "its .mtl would replace the materials of the input");
}

/// A file, of .obj with its materials. `mesh` as of `write_segments()`
void write_file(const Output& output, const Result& result, const Labelled_mesh& mesh)
{
  Whole_file file(output.file);
  std::optional<Whole_file> materials;
  std::vector<std::string> names;
  if (output.format == Output_format::PLY)
    names = files_of_input(output, mesh.properties, &Material_library::textures);
  else if (has_obj_materials(mesh.properties))
    names = files_of_input(output, mesh.properties);
  else if (const std::string library = material_library(output); !library.empty()) {
    check_library(library, output, result);
    materials.emplace(library);
    write_mtl(materials->stream(), mesh);
    names.push_back(one_line(std::filesystem::path(library).filename().string()));
  }
  write_stream(file.stream(), output.compression, [&](std::ostream& out) {
    if (output.content == Output_content::BORDERS)
      write_borders(out, result);
    else
      write_segments(out, output, result, mesh, names);
  });
  file.commit();
  if (materials)
    materials->commit();
}

Remarks write_solid(const Output& output, const Result& result)
{
  const Step_text step = make_step(output, result);
  Whole_file file(output.file);
  write_stream(file.stream(), output.compression, [&](std::ostream& out) { out << step.text; });
  file.commit();
  return step.remarks;
}

/// \throws Output_error if the coordinates are none of float, as .glb has them
void check_coordinates(const Output& output, const Polygon_soup& soup)
{
  for (const std::size_t i : soup.polygons.corners())
    for (const double x : soup.points[i])
      if (std::fabs(x) > double((std::numeric_limits<float>::max)()))
        throw Output_error(output.file, "coordinates above 3.4e38, which .glb cannot have");
}

void write_each_segment(const Output& output, const Result& result, const Labelled_mesh& mesh)
{
  const auto faces = faces_of_segments(mesh.segment_of_face);
  std::vector<Output> files;
  for (std::size_t segment = 0; segment + 1 < faces.size(); ++segment) {
    files.push_back(output);
    files.back().file = with_segment(output.file, std::to_string(segment));
    if (resolve_links(files.back().file) == resolve_links(result.name))
      throw Output_error(files.back().file, "would replace the input");
  }
  for (std::size_t segment = 0; segment < files.size(); ++segment) {
    const Mesh_part part = extract_faces(mesh, faces[segment]);
    write_file(files[segment], result,
               {part.soup, std::vector<std::size_t>(part.soup.polygons.size(), segment), mesh.names,
                part.properties});
  }
}

} // namespace

Remarks write_segmentation(const Output& output, const Result& result)
{
  if (output.format == Output_format::STEP)
    return write_solid(output, result);
  if (output.format == Output_format::HTML && !can_write_pages())
    throw Output_error(output.file,
                       "pages need three.js (Debian: libjs-three), and this program was "
                       "built without it");
  if (output.format == Output_format::GLB)
    check_coordinates(output, result.input.soup);
  std::optional<Solids> solids;
  if (output.content == Output_content::SOLIDS)
    solids = result.details.solids();
  std::vector<std::string> names;
  if (has_names(output.format) && output.content != Output_content::BORDERS)
    names = result.details.names(); // those of smooth faces take time
  const Labelled_mesh mesh = solids ? Labelled_mesh{solids->soup, solids->segment_of_face, names}
                                    : Labelled_mesh{result.input.soup,
                                                    result.segmentation.segment_of_face, names,
                                                    result.input.properties};
  if (output.is_for_each_segment())
    write_each_segment(output, result, mesh);
  else
    write_file(output, result, mesh);
  return {};
}

void write_seg(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  for (std::size_t label : result.segmentation.segment_of_face)
    text << std::int64_t(label) << "\n";
}

void write_view(std::ostream& out, const Result& result)
{
  View_options options = result.view;
  options.colors = result.details.colors(result.coloring, result.segmentation.segment_of_face,
                                         result.segmentation.number_of_segments);
  write_png(render_view(result.input.soup, result.segmentation.segment_of_face, options), out);
}

void write_html(std::ostream& out, const Result& result)
{
  write_page(out, {result.name, result.input.soup, result.segmentation, result.details,
                   result.coloring, result.view.up});
}

} // namespace segment_mesh
