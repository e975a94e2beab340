// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine parts as solids of planes, cylinders, cones, spheres, tori and freeform faces, in a STEP
// file: mesh_to_step PART.stl PART.step [--unit mm|cm|m|inch] [--allow-facets] [--as-found]
// [--report PART.json]. The unit is that of the mesh; both outputs are in mm. What is written is
// read again and compared with the mesh; if it is not right, the program says what is wrong, writes
// no STEP file, and ends with 1.

#include "bodies.h"
#include "step_part.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <Standard_Failure.hxx>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

struct Options
{
  std::vector<std::string> files;
  std::string report;
  double unit = 1; ///< of the mesh, in mm
  mesh_to_step::Facets facets = mesh_to_step::Facets::REFUSED;
  mesh_to_step::Design_intent intent = mesh_to_step::Design_intent::SET;
};

/// In mm.
double unit_of_name(const std::string& name)
{
  const std::map<std::string, double> units{{"mm", 1}, {"cm", 10}, {"m", 1000}, {"inch", 25.4}};
  const auto unit = units.find(name);
  if (unit == units.end())
    throw std::runtime_error("--unit " + name + ": mm, cm, m or inch");
  return unit->second;
}

Options read_options(int argc, char** argv)
{
  Options result;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help") {
      std::cout
        << "mesh_to_step PART.stl PART.step [--unit mm|cm|m|inch] [--allow-facets] [--as-found]"
           " [--report PART.json]\n";
      std::exit(EXIT_SUCCESS);
    }
    if (word == "--allow-facets")
      result.facets = mesh_to_step::Facets::ALLOWED;
    else if (word == "--as-found")
      result.intent = mesh_to_step::Design_intent::AS_FOUND;
    else if (word == "--report" && i + 1 < argc)
      result.report = argv[++i];
    else if (word == "--unit" && i + 1 < argc)
      result.unit = unit_of_name(argv[++i]);
    else if (word.rfind("--", 0) == 0)
      throw std::runtime_error(word + " is no option, or lacks its value");
    else
      result.files.push_back(word);
  }
  if (result.files.empty())
    result.files.push_back(CGAL::data_file_path("flange.off"));
  if (result.files.size() == 1)
    result.files.push_back("mesh_to_step.step");
  if (result.files.size() > 2)
    throw std::runtime_error("a third file: " + result.files[2]);
  for (const std::string& output : {result.files[1], result.report})
    if (std::error_code none; std::filesystem::equivalent(output, result.files[0], none))
      throw std::runtime_error(output + " would replace the mesh");
  if (result.report == result.files[1])
    throw std::runtime_error("--report " + result.report + " would replace the solid");
  return result;
}

mesh_to_step::Mesh read_bodies(const std::string& file, double unit)
{
  std::vector<mesh_to_step::Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error(file + ": there is no such file");
  if (!CGAL::IO::read_polygon_soup(file, points, polygons) || polygons.empty())
    throw std::runtime_error(file +
                             " cannot be read as a mesh; segment_mesh -o PART.step may tell why");
  for (mesh_to_step::Point& p : points)
    p = CGAL::ORIGIN + unit * (p - CGAL::ORIGIN);
  return mesh_to_step::make_bodies(points, polygons);
}

/// Replaces a file, or leaves what is there.
void write(const std::string& file, const std::string& text)
{
  const std::string part = file + ".part";
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream)
    std::filesystem::rename(part, file, error);
  if (!stream || error) {
    std::filesystem::remove(part, error);
    throw std::runtime_error(file + " cannot be written");
  }
}

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  const mesh_to_step::Step_part part = mesh_to_step::make_step_part(
    read_bodies(options.files[0], options.unit), options.facets, options.intent);
  for (const std::string& remark : part.remarks)
    std::cout << remark << '\n';
  if (part.is_solid)
    write(options.files[1], part.text);
  if (!options.report.empty())
    write(options.report, part.report);
  if (!part.is_solid) {
    const bool is_set = options.intent == mesh_to_step::Design_intent::SET;
    std::cerr << "no file is written"
              << (is_set ? "; mesh_to_step --as-found may make one\n" : "\n");
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
} catch (const Standard_Failure& failure) {
  std::cerr << failure.GetMessageString() << '\n';
  return EXIT_FAILURE;
} catch (const std::exception& failure) {
  std::cerr << failure.what() << '\n';
  return EXIT_FAILURE;
}
