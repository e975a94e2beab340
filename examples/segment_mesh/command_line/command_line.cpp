// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "command_line/format_help.h"
#include "read/errors.h"
#include "view/choose_viewpoint.h"

#include <CGAL/Region_segmentation/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace segment_mesh {

namespace {

using CGAL::Region_segmentation::Feature_convexity;

const std::map<std::string, Method> methods = {{"learned", Method::LEARNED},
                                               {"visibility", Method::VISIBILITY},
                                               {"two-step", Method::TWO_STEP},
                                               {"smooth-faces", Method::SMOOTH_FACES}};

const std::map<std::string, Feature_convexity> features = {{"concave", Feature_convexity::CONCAVE},
                                                           {"convex", Feature_convexity::CONVEX},
                                                           {"all", Feature_convexity::ALL}};

const std::map<std::string, Coloring> colorings = {{"segment", Coloring::SEGMENTS},
                                                   {"kind", Coloring::KINDS}};

const std::map<std::string, Mesh_format> formats(mesh_formats().begin(), mesh_formats().end());

/// More would be a slip of the hand.
constexpr std::size_t most_threads = 1024;

/// The options as CLI11 fills them.
struct Raw_options
{
  Options options;
  std::vector<std::string> outputs, borders;
  std::string output_format;
  double maximum_angle = 0, tolerance = 0;
  std::string number_of_segments, number_of_threads = "0"; ///< CLI11 would cut off large numbers
  std::string method = "learned", features = "concave";
  std::string coloring = "segment";
  std::string input_format;
  std::pair<double, double> view; ///< azimuth and elevation, in degrees
};

template <typename Value>
CLI::IsMember one_of(const std::map<std::string, Value>& names)
{
  std::vector<std::string> list;
  for (const auto& entry : names)
    list.push_back(entry.first);
  return CLI::IsMember(list);
}

/// Adds options to one group of the help.
class Option_group
{
public:
  Option_group(CLI::App& app, const char* name)
    : m_app(app)
    , m_name(name)
  {}

  template <typename Value>
  CLI::Option* add(const char* names, Value& value, const char* type, const std::string& text) const
  {
    CLI::Option* const
      option = m_app.add_option(names, value, text)->type_name(type)->group(m_name);
    if (std::string_view(type).substr(0, 4) == "FILE") // a script's unset variable is no name
      option->check(CLI::Validator(
        [](const std::string& word) { return word.empty() ? "the name of a file is empty" : ""; },
        ""));
    return option;
  }

  /// An option that may be given several times, with one word each time.
  CLI::Option* add_repeatable(const char* names, std::vector<std::string>& values, const char* type,
                              const char* text) const
  {
    return add(names, values, type, text)->allow_extra_args(false);
  }

  CLI::Option* add_flag(const char* names, const char* text) const
  {
    return m_app.add_flag(names)->description(text)->group(m_name);
  }

private:
  CLI::App& m_app;
  const char* m_name;
};

void add_inputs(CLI::App& app, Raw_options& raw)
{
  const Option_group input(app, "Input");
  input.add("INPUT", raw.options.inputs, "",
            "Meshes: " + endings_of_meshes() +
              ", also compressed as .gz; - is standard input. Several inputs are processed one "
              "after the other.");
  input
    .add("--input-format", raw.input_format, "FORMAT",
         "For all inputs, whatever their extensions: the extension that they would "
         "have, without the dot. Needed for standard input.")
    ->check(one_of(formats));
  input.add_flag(
    "--demo",
    "Instead of an INPUT: a figure that the program builds, of which it knows the parts. Their "
    "number is the default of -k, and the score against them is printed.");
  input.add("--labels", raw.options.side_files.labels, "FILE.seg",
            "Instead of segmenting: take the segments from this file, a label for each face, to "
            "draw, describe and compare them; faces of label -1 are of no segment. {stem} as in "
            "-o.");
}

void add_outputs(CLI::App& app, Raw_options& raw)
{
  const Option_group output(app, "Output");
  output.add_repeatable("-o,--output", raw.outputs, "FILE",
                        "Repeatable. {stem} in FILE is the name of the input. The file name "
                        "extension selects the format: .html (a page to view "
                        "and rotate the mesh, with every number of segments), .png (a picture), "
                        ".ply, .off, .obj, .vtp (the mesh with its "
                        "segments in colors or groups; .vtp is for ParaView; the faces of .obj are "
                        "ordered by segment, and a .mtl beside it has the colors, unless it is "
                        "a pipe), .glb, .3mf, .stl (a part "
                        "for each segment, to be shown or printed), "
                        ".seg (the label of each face on a line), .csv (a table: area, volume, "
                        "shape ... of each segment), .json (all of it). "
                        "With .gz after it a file is compressed. {segment} in FILE: a mesh for "
                        "each segment. - is stdout. A file appears whole or not at all; stdout, a "
                        "device or a pipe can be left half written.");
  output.add_flag("--solids",
                  "Each segment of a mesh that -o writes is a closed solid, to be printed: "
                  "caps close its borders.");
  output.add_repeatable("--borders", raw.borders, "FILE",
                        "Repeatable. The borders between segments as polylines: .obj or .vtp.");
  output.add("--view", raw.view, "AZIMUTH ELEVATION",
             "For .png: where the viewer stands, in degrees: around the y axis from the z axis, "
             "and above. Default: where most "
             "segments are seen.");
  output
    .add("--color", raw.coloring, "BY",
         "For .png and .html: what colors tell apart: segment (default), or kind, of the surfaces "
         "of --method smooth-faces: plane (blue), cylinder (red), cone (green), sphere (yellow), "
         "torus (light blue), freeform (purple), several faces (grey).")
    ->check(one_of(colorings));
  output
    .add("--output-format", raw.output_format, "FORMAT",
         "For every -o, instead of what its extension selects: seg, ply, ...")
    ->check(CLI::IsMember(output_format_names()));
}

void add_segmentation(CLI::App& app, Raw_options& raw)
{
  const Option_group segmentation(app, "Segmentation");
  segmentation.add("-k,--segments", raw.number_of_segments, "N",
                   "Number of segments. Default: chosen automatically.");
  segmentation
    .add("--method", raw.method, "METHOD",
         "learned (parts as people see them; default), visibility (the same by a formula), "
         "smooth-faces (the faces of a "
         "machine part), or two-step (Yang et al. 2014; needs -k).")
    ->check(one_of(methods));
  segmentation.add("--constraints", raw.options.side_files.constraints, "FILE",
                   "Edges that are borders between segments, whatever the method. A line of the "
                   "file is a sequence of points "
                   "of the mesh, consecutive ones joined by edges; points are given by index, "
                   "starting from 0. {stem} as in -o.");
  segmentation.add("--seeds", raw.options.side_files.seeds, "FILE",
                   "Faces that belong together, and faces that do not. A line of the file is the "
                   "index of a face and its "
                   "seed, both starting from 0: equal seeds end in one segment, different ones in "
                   "different segments. {stem} as "
                   "in -o.");
  segmentation.add_flag(
    "--no-links",
    "Components stay apart. Default: those that touch or are near each other are adjacent, and "
    "-k counts parts, not components.");
  segmentation.add_flag(
    "--smooth-borders",
    "Move the borders to where they are shorter and lie in valleys, by minimum cuts. "
    "Segments of different numbers are no longer nested.");
  segmentation
    .add("--features", raw.features, "KIND",
         "For two-step: edges that can be features: concave (default), convex or all.")
    ->check(one_of(features));
  segmentation.add("--max-angle", raw.maximum_angle, "DEGREES",
                   "For two-step: the angle between the normals of two faces above which their "
                   "edge is a feature. Default: "
                   "1.2372.");
  segmentation.add("--tolerance", raw.tolerance, "DISTANCE",
                   "For smooth-faces: the largest distance of a vertex from the surface of its "
                   "face, in units of the mesh; for a scan, some times its noise. Default: 0, "
                   "found from the mesh.");
}

void add_run_options(CLI::App& app, Raw_options& raw)
{
  Option_group(app, "Comparison")
    .add_repeatable("--truth", raw.options.truths, "FILE.seg",
                    "Repeatable. {stem} as in -o. Print five measures of the distance to this "
                    "segmentation, and their means.");
  const Option_group run(app, "Run");
  run
    .add("--threads", raw.number_of_threads, "N",
         "Most threads for a mesh. Default: 0, one for each core.")
    ->take_last();
  run.add_flag("-q,--quiet", "No progress and remarks on stderr.");
  app.set_help_flag("-h,--help", "Print this and exit.")->group("Run");
  app
    .set_version_flag("--version", "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION,
                      "Print the version and exit.")
    ->group("Run");
}

struct Range
{
  std::size_t least, greatest;
};

/// \throws Usage_error unless `word` is a whole number within the range
std::size_t whole_number(const std::string& option, const std::string& word, const Range& range)
{
  std::size_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || rest != end || value < range.least || value > range.greatest)
    throw Usage_error(option + " " + word + ": not a whole number from " +
                      std::to_string(range.least) + " to " + std::to_string(range.greatest));
  return value;
}

/// \throws Usage_error unless both angles are within their ranges, in degrees
Viewpoint checked_viewpoint(double azimuth, double elevation)
{
  if (!(azimuth >= -360 && azimuth <= 360))
    throw Usage_error("--view: an azimuth from -360 to 360 degrees");
  if (!(elevation >= -90 && elevation <= 90))
    throw Usage_error("--view: an elevation from -90 to 90 degrees");
  return viewpoint_from(azimuth, elevation);
}

/// \throws Usage_error if an option is given that another one makes meaningless
void check_combinations(const CLI::App& app, const Raw_options& raw)
{
  if (app.count("--demo") > 0 && !raw.options.inputs.empty())
    throw Usage_error("--demo: there is an INPUT, too");
  if (app.count("--demo") == 0 && raw.options.inputs.empty())
    throw Usage_error("no INPUT; --demo segments a model of the program");
  for (const char* option : {"--features", "--max-angle"})
    if (raw.method != "two-step" && app.count(option) > 0)
      throw Usage_error(std::string(option) + ": --method " + raw.method + " has no feature edges");
  if (methods.at(raw.method) != Method::SMOOTH_FACES && app.count("--tolerance") > 0)
    throw Usage_error("--tolerance: --method " + raw.method + " fits no surfaces to faces");
  if (colorings.at(raw.coloring) == Coloring::KINDS &&
      methods.at(raw.method) != Method::SMOOTH_FACES)
    throw Usage_error("--color kind: --method smooth-faces alone finds kinds of surfaces");
  for (const char* option :
       {"--segments", "--method", "--no-links", "--smooth-borders", "--constraints", "--seeds"})
    if (app.count("--labels") > 0 && app.count(option) > 0)
      throw Usage_error(std::string(option) + ": with --labels nothing is segmented");
  if (app.count("--seeds") > 0 && app.count("--smooth-borders") > 0)
    throw Usage_error("--smooth-borders: borders would move across faces with seeds");
}

std::vector<Output> make_outputs(const CLI::App& app, const Raw_options& raw)
{
  std::optional<Output_format> format;
  if (app.count("--output-format") > 0) {
    const std::vector<std::string>& names = output_format_names();
    format = Output_format(std::find(names.begin(), names.end(), raw.output_format) -
                           names.begin());
  }
  std::vector<Output> outputs;
  for (const std::string& file : raw.outputs)
    outputs.push_back(make_output(
      file, app.count("--solids") > 0 ? Output_content::SOLIDS : Output_content::SEGMENTS, format));
  if (app.count("--solids") > 0 &&
      std::none_of(outputs.begin(), outputs.end(),
                   [](const Output& output) { return output.content == Output_content::SOLIDS; }))
    throw Usage_error("--solids: no -o is a mesh");
  for (const std::string& file : raw.borders)
    outputs.push_back(make_output(file, Output_content::BORDERS));
  return outputs;
}

Options checked(const CLI::App& app, const Raw_options& raw)
{
  check_combinations(app, raw);
  Options options = raw.options;
  options.is_demo = app.count("--demo") > 0;
  options.outputs = make_outputs(app, raw);
  if (app.count("--segments") > 0)
    options.settings.number_of_segments = whole_number(
      "-k", raw.number_of_segments, {1, (std::numeric_limits<std::size_t>::max)()});
  options.number_of_threads = whole_number("--threads", raw.number_of_threads, {0, most_threads});
  if (app.count("--max-angle") > 0) {
    if (!(raw.maximum_angle >= 0 && raw.maximum_angle <= 180))
      throw Usage_error("--max-angle: an angle from 0 to 180 degrees");
    options.settings.maximum_angle = raw.maximum_angle;
  }
  if (!(raw.tolerance >= 0 && std::isfinite(raw.tolerance)))
    throw Usage_error("--tolerance: a finite distance, not negative");
  options.settings.tolerance = raw.tolerance;
  if (!raw.input_format.empty())
    options.input_format = formats.at(raw.input_format);
  options.settings.method = methods.at(raw.method);
  options.settings.features = features.at(raw.features);
  options.settings.borders = app.count("--smooth-borders") > 0 ? Border_treatment::SMOOTHING
                                                               : Border_treatment::NONE;
  options.settings.links = app.count("--no-links") > 0 ? Component_links::NONE
                                                       : Component_links::FOUND;
  if (app.count("--view") > 0)
    options.viewpoint = checked_viewpoint(raw.view.first, raw.view.second);
  options.coloring = colorings.at(raw.coloring);
  options.verbosity = app.count("--quiet") > 0 ? Verbosity::QUIET : Verbosity::NORMAL;
  return options;
}

} // namespace

std::optional<Options> parse_command_line(int argc, const char* const* argv)
{
  if (argc <= 1) {
    std::cout << short_help();
    return std::nullopt;
  }
  CLI::App app("", "segment_mesh");
  Raw_options raw;
  add_inputs(app, raw);
  add_segmentation(app, raw);
  add_outputs(app, raw);
  add_run_options(app, raw);
  app.formatter_fn(
    [](const CLI::App* a, const std::string&, CLI::AppFormatMode) { return format_help(*a); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Usage_error(error.what());
  }
  return checked(app, raw);
}

} // namespace segment_mesh
