// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "read/errors.h"
#include "view/choose_viewpoint.h"

#include <CGAL/Region_segmentation/Support/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace segment_mesh {

namespace {

/// The values of an enumeration by their names, which are in their order.
template <typename Value, std::size_t N>
std::map<std::string, Value> by_name(const char* const (&names)[N])
{
  std::map<std::string, Value> values;
  for (std::size_t i = 0; i < N; ++i)
    values.emplace(names[i], Value(i));
  return values;
}

const auto methods = by_name<Method>(method_names);
const auto features = by_name<CGAL::Region_segmentation::Feature_convexity>(feature_names);
const auto set_kinds = by_name<Set_kind>(set_kind_names);

const std::map<std::string, Coloring> colorings = {{"segment", Coloring::SEGMENTS},
                                                   {"kind", Coloring::KINDS}};

const std::map<std::string, Up_direction> up_directions = {
  {"x", {0, 1}}, {"y", {1, 1}}, {"z", {2, 1}}, {"-x", {0, -1}}, {"-y", {1, -1}}, {"-z", {2, -1}}};

const std::map<std::string, Mesh_format> formats(mesh_formats().begin(), mesh_formats().end());

/// More would be a slip of the hand.
constexpr std::size_t most_threads = 1024, most_pixels = 16384;

/// The options as CLI11 fills them.
struct Raw_options
{
  Options options;
  std::vector<std::string> outputs, borders;
  std::string number_of_segments, number_of_threads = "0"; ///< CLI11 would cut off large numbers
  std::pair<double, double> view;                          ///< azimuth and elevation, in degrees
  std::string size;
};

/// The words of a text in lines that the help has room for; a line break of the text stays.
std::string wrapped(const std::string& text)
{
  constexpr std::size_t width = 55;
  std::istringstream lines(text);
  std::string result, line, word;
  while (std::getline(lines, line)) {
    result += result.empty() ? "" : "\n";
    std::size_t used = 0;
    for (std::istringstream words(line); words >> word; used += word.size() + 1) {
      if (used + word.size() > width) {
        result += "\n";
        used = 0;
      }
      result += (used > 0 ? " " : "") + word;
    }
  }
  return result;
}

/// Adds options to one group of the help. The first line of a text says enough for the short help.
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
      option = m_app.add_option(names, value, wrapped(text))->option_text(type)->group(m_name);
    if (std::string_view(type).substr(0, 4) == "FILE") // a script's unset variable is no name
      option->check(CLI::Validator(
        [](const std::string& word) { return word.empty() ? "the name of a file is empty" : ""; },
        ""));
    return option;
  }

  /// An option whose words stand for values.
  template <typename Value, typename Target>
  void add_choice(const char* names, Target& target, const std::map<std::string, Value>& values,
                  const char* type, const char* text) const
  {
    std::vector<std::string> words;
    for (const auto& entry : values)
      words.push_back(entry.first);
    m_app
      .add_option_function<std::string>(
        names, [&target, &values](const std::string& word) { target = values.at(word); },
        wrapped(text))
      ->option_text(type)
      ->group(m_name)
      ->check(CLI::IsMember(words));
  }

  /// An option that may be given several times, with one word each time.
  CLI::Option* add_repeatable(const char* names, std::vector<std::string>& values, const char* type,
                              const char* text) const
  {
    return add(names, values, type, text)->allow_extra_args(false);
  }

  CLI::Option* add_flag(const char* names, const char* text) const
  {
    return m_app.add_flag(names)->description(wrapped(text))->group(m_name);
  }

private:
  CLI::App& m_app;
  const char* m_name;
};

void add_inputs(CLI::App& app, Raw_options& raw)
{
  const Option_group input(app, "Input");
  input.add("INPUT", raw.options.inputs, " ",
            "Meshes: " + endings_of_meshes() +
              ".\n"
              "Also compressed as .gz; - is standard input. Several inputs are processed one "
              "after the other.");
  input.add_choice("--input-format", raw.options.input_format, formats, "FORMAT",
                   "For all inputs, whatever their extensions: the extension that they would "
                   "have, without the dot. Needed for standard input.");
  input.add_flag("--demo",
                 "Instead of an INPUT: a figure that the program has.\n"
                 "It knows the parts: their number is the default of -k, and the score against "
                 "them is printed.");
  input.add("--labels", raw.options.side_files.labels, "FILE.seg",
            "Segments that exist, instead of segmenting.\n"
            "The file has a label for each face. They are drawn, described and compared; "
            "faces of label -1 are of no segment. {stem} as in -o.");
  input.add_choice("--labels-from", raw.options.side_files.labels_from, set_kinds, "SETS",
                   "The same with the groups (.obj; nodes of .gltf), materials (.obj, .gltf) or "
                   "solids (.stl) of the INPUT. Segments have their names.");
}

void add_outputs(CLI::App& app, Raw_options& raw)
{
  const Option_group output(app, "Output");
  output.add_repeatable(
    "-o,--output", raw.outputs, "FILE",
    "Repeatable: .html .png .ply .glb .seg .csv ...\n"
    "{stem} in FILE is the name of the input. The file name extension selects the "
    "format: .html (a page to view and rotate the mesh, with every number of "
    "segments), .png (a picture), .ply, .off, .obj, .vtp (the mesh with its "
    "segments in colors or groups; .vtp is for ParaView; the faces of .obj are "
    "ordered by segment, and a .mtl beside it has the colors, unless it is a "
    "pipe), .glb, .3mf, .stl (a part for each segment, to be shown or printed), "
    ".msh (for gmsh: a physical group a segment), .step (for CAD: a solid of the "
    "faces of a machine part), .seg (the label of each face on a line), .csv (a "
    "table: area, volume, shape ... of each segment), .json (all of it). With .gz "
    "after it a file is compressed. {segment} in FILE: a mesh for each segment. "
    "FORMAT:FILE is a file of any extension in a format, as csv:- is a table on "
    "stdout. A file appears whole or not at all; stdout, a device or a pipe can be "
    "left half written.");
  output.add_flag("--solids",
                  "Each segment of a mesh that -o writes is a closed solid, to be printed: caps "
                  "close its borders.");
  output.add_flag("--painted",
                  "A .3mf that -o writes is the mesh in one piece, its triangles painted for the "
                  "extruders 1 to 15 of a slicer, which can change the colors.");
  output.add_repeatable("--borders", raw.borders, "FILE",
                        "Repeatable. The borders between segments as polylines: .obj or .vtp.");
  output.add_choice("--up", raw.options.view.up, up_directions, "AXIS",
                    "Of pictures and pages: x, y (default), z, -x, -y or -z.");
  output.add("--view", raw.view, "AZIMUTH ELEVATION",
             "Of pictures: where the viewer stands, in degrees: around the axis that is up "
             "(y: from z toward x, z: from x toward y, x: from y toward z), and above. "
             "Default: where most segments are seen.");
  output.add("--size", raw.size, "WIDTHxHEIGHT",
             "Of pictures, in pixels, or N for NxN. Default: 800x600.");
  output.add_choice("--color", raw.options.coloring, colorings, "BY",
                    "Of pictures and pages, what colors tell apart: segment (default), or kind, of "
                    "the surfaces of --method smooth-faces: plane (blue), cylinder (red), cone "
                    "(green), sphere (yellow), torus (light blue), freeform (purple), several "
                    "faces (grey).");
}

void add_segmentation(CLI::App& app, Raw_options& raw)
{
  const Option_group segmentation(app, "Segmentation");
  segmentation.add("-k,--segments", raw.number_of_segments, "N",
                   "Number of segments. Default: chosen automatically.");
  segmentation.add_choice(
    "--method", raw.options.settings.method, methods, "METHOD",
    "learned, smooth-faces, visibility or two-step.\n"
    "learned (default): parts as people see them;\n"
    "smooth-faces: the faces of a machine part;\n"
    "visibility: parts by a formula;\n"
    "two-step: Yang et al. 2014; without -k all regions between the features.");
  segmentation.add("--constraints", raw.options.side_files.constraints, "FILE",
                   "Edges that are borders between segments, whatever the method. A line of the "
                   "file is a sequence of points of the mesh, consecutive ones joined by edges; "
                   "points are given by index, starting from 0. {stem} as in -o.");
  segmentation.add_choice(
    "--constraints-from", raw.options.side_files.constraints_from, set_kinds, "SETS",
    "The borders of groups, materials or solids of the INPUT are borders between "
    "segments, too.");
  segmentation.add("--seeds", raw.options.side_files.seeds, "FILE",
                   "Faces that belong together, and faces that do not. A line of the file is the "
                   "index of a face and its seed, both starting from 0: equal seeds end in one "
                   "segment, different ones in different segments. {stem} as in -o.");
  segmentation.add_flag(
    "--no-links", "Components stay apart. Default: those that touch or are near each other are "
                  "adjacent, and -k counts parts, not components.");
  segmentation.add_flag("--smooth-borders",
                        "Move the borders to where they are shorter and lie in valleys, by minimum "
                        "cuts. Segments of different numbers are no longer nested.");
  segmentation.add_choice(
    "--features", raw.options.settings.features, features, "KIND",
    "For two-step: edges that can be features: concave (default), convex or all.");
  segmentation.add("--max-angle", raw.options.settings.maximum_angle, "DEGREES",
                   "For two-step: the angle between the normals of two faces above which their "
                   "edge is a feature. Default: 1.2372.");
  segmentation.add("--tolerance", raw.options.settings.tolerance, "DISTANCE",
                   "For smooth-faces: the largest distance of a vertex from the surface of its "
                   "face, in units of the mesh; for a scan, five times its noise. Default: 0, "
                   "found from the mesh.");
}

void add_run_options(CLI::App& app, Raw_options& raw)
{
  Option_group(app, "Comparison")
    .add_repeatable("--truth", raw.options.truths, "FILE.seg",
                    "Print the distance to this segmentation.\n"
                    "Repeatable. {stem} as in -o. There are five measures, and their means if "
                    "there are several files.");
  const Option_group run(app, "Run");
  run
    .add("--threads", raw.number_of_threads, "N",
         "Most threads for a mesh. Default: 0, one for each core.")
    ->take_last();
  run.add_flag("-q,--quiet", "No progress and remarks, and no line for a mesh.");
  app.set_help_flag("-h", "Print the options that are used most, and exit.")->group("Run");
  app.set_help_all_flag("--help", "Print all options, and exit.")->group("Run");
  app
    .set_version_flag("--version", "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION,
                      "Print the version, and exit.")
    ->group("Run");
}

constexpr const char* summary = "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION
                                " segments surface meshes into parts.";

constexpr const char* short_footer = R"(Examples:
  segment_mesh mesh.off                     says how many parts it sees
  segment_mesh mesh.off -o mesh.html        a page to view them in a browser
  segment_mesh mesh.off -k 9 -o parts.ply   nine parts, in colors
  segment_mesh --demo -o demo.png           a picture of a model of its own

segment_mesh --help lists all options.)";

constexpr const char* long_summary =
  R"(Segments surface meshes into parts, and prints a line for each: its faces, the
regions that were merged, the segments, and the time from the mesh in memory to
the labels. Meshes need not be manifold, oriented or connected; labels come back
for each face of the file. Output files are written completely or not at all.
)";

constexpr const char* long_footer = R"(Examples:
  segment_mesh armadillo.off -o armadillo.html
      A page to view and rotate the parts, and to change their number.
  segment_mesh armadillo.off -k 9 -o armadillo.seg -o parts.ply
      Nine parts: labels, and the mesh in colors.
  segment_mesh gear.stl --method smooth-faces -o 'gear_{segment}.obj'
      A file for each face of a machine part.
  segment_mesh *.off -k 7 -o 'parts/{stem}.vtp' --quiet
      A batch, for ParaView.
  segment_mesh a.off --labels a.seg --truth b.seg -o a.csv
      Compare and describe existing segments.
  segment_mesh a.off -q -o csv:- | sort
      A table on stdout.

Exit status:
  0  done
  1  an input could not be read, or an output could not be written; the others
     of a batch are done
  2  wrong usage)";

/// The help on the options that people need first, a line for each.
std::string short_help(CLI::App& app)
{
  const std::string first[] = {"INPUT",    "--demo",   "--labels", "--segments",
                               "--method", "--output", "--truth",  "--up",
                               "--size",   "--quiet",  "-h",       "--help"};
  for (CLI::Option* option : app.get_options())
    option->group("");
  for (const std::string& name : first) {
    CLI::Option* const option = app.get_option(name);
    const std::string text = option->get_description();
    option->description(text.substr(0, text.find('\n')))->group("Options");
  }
  app.description(summary);
  app.footer(short_footer);
  return app.help();
}

std::string long_help(CLI::App& app)
{
  app.description(long_summary);
  app.footer(long_footer);
  return app.help();
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
Viewpoint checked_viewpoint(double azimuth, double elevation, const Up_direction& up)
{
  if (!(azimuth >= -360 && azimuth <= 360))
    throw Usage_error("--view: an azimuth from -360 to 360 degrees");
  if (!(elevation >= -90 && elevation <= 90))
    throw Usage_error("--view: an elevation from -90 to 90 degrees");
  return viewpoint_from(azimuth, elevation, up);
}

/// The options of pictures. \throws Usage_error unless sizes and angles are within their ranges
View_options checked_view(const CLI::App& app, const Raw_options& raw)
{
  View_options view = raw.options.view;
  if (app.count("--view") > 0)
    view.viewpoint = checked_viewpoint(raw.view.first, raw.view.second, view.up);
  if (app.count("--size") > 0) {
    const std::size_t x = raw.size.find('x');
    const Range pixels = {1, most_pixels};
    view.width = whole_number("--size", raw.size.substr(0, x), pixels);
    view.height = x == std::string::npos ? view.width
                                         : whole_number("--size", raw.size.substr(x + 1), pixels);
  }
  return view;
}

/// \throws Usage_error if an option is given that another one makes meaningless
void check_combinations(const CLI::App& app, const Raw_options& raw)
{
  if (app.count("--demo") > 0 && !raw.options.inputs.empty())
    throw Usage_error("--demo: there is an INPUT, too");
  if (app.count("--demo") == 0 && raw.options.inputs.empty())
    throw Usage_error("no INPUT; --demo segments a model of the program");
  const Method method = raw.options.settings.method;
  const std::string name = method_names[std::size_t(method)];
  for (const char* option : {"--features", "--max-angle"})
    if (method != Method::TWO_STEP && app.count(option) > 0)
      throw Usage_error(std::string(option) + ": --method " + name + " has no feature edges");
  if (method != Method::SMOOTH_FACES && app.count("--tolerance") > 0)
    throw Usage_error("--tolerance: --method " + name + " fits no surfaces to faces");
  if (raw.options.coloring == Coloring::KINDS && method != Method::SMOOTH_FACES)
    throw Usage_error("--color kind: --method smooth-faces alone finds kinds of surfaces");
  if (app.count("--labels") > 0 && app.count("--labels-from") > 0)
    throw Usage_error("--labels-from: there are --labels, too");
  for (const char* labels : {"--labels", "--labels-from"})
    for (const char* option : {"--segments", "--method", "--no-links", "--smooth-borders",
                               "--constraints", "--constraints-from", "--seeds"})
      if (app.count(labels) > 0 && app.count(option) > 0)
        throw Usage_error(std::string(option) + ": with " + labels + " nothing is segmented");
  if (app.count("--seeds") > 0 && app.count("--smooth-borders") > 0)
    throw Usage_error("--smooth-borders: borders would move across faces with seeds");
}

/// What of a segmentation -o writes. \throws Usage_error
Output_content content_of_outputs(const CLI::App& app)
{
  const bool is_solid = app.count("--solids") > 0, is_painted = app.count("--painted") > 0;
  if (is_solid && is_painted)
    throw Usage_error("--painted: with --solids the mesh is not in one piece");
  return is_solid     ? Output_content::SOLIDS
         : is_painted ? Output_content::PAINTED
                      : Output_content::SEGMENTS;
}

std::vector<Output> make_outputs(const CLI::App& app, const Raw_options& raw)
{
  const Output_content content = content_of_outputs(app);
  std::vector<Output> outputs;
  for (const std::string& file : raw.outputs)
    outputs.push_back(make_output(file, content));
  if (std::none_of(outputs.begin(), outputs.end(),
                   [=](const Output& output) { return output.content == content; })) {
    if (content == Output_content::SOLIDS)
      throw Usage_error("--solids: no -o is a mesh");
    if (content == Output_content::PAINTED)
      throw Usage_error("--painted: no -o is a .3mf");
  }
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
  const double angle = options.settings.maximum_angle.value_or(0),
               tolerance = options.settings.tolerance;
  if (!(angle >= 0 && angle <= 180))
    throw Usage_error("--max-angle: an angle from 0 to 180 degrees");
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    throw Usage_error("--tolerance: a finite distance, not negative");
  options.settings.borders = app.count("--smooth-borders") > 0 ? Border_treatment::SMOOTHING
                                                               : Border_treatment::NONE;
  options.settings.links = app.count("--no-links") > 0 ? Component_links::NONE
                                                       : Component_links::FOUND;
  options.view = checked_view(app, raw);
  options.verbosity = app.count("--quiet") > 0 ? Verbosity::QUIET : Verbosity::NORMAL;
  return options;
}

} // namespace

std::optional<Options> parse_command_line(int argc, const char* const* argv)
{
  CLI::App app("", "segment_mesh");
  Raw_options raw;
  add_inputs(app, raw);
  add_segmentation(app, raw);
  add_outputs(app, raw);
  add_run_options(app, raw);
  app.get_formatter()->column_width(25);
  if (argc <= 1) {
    std::cout << short_help(app);
    return std::nullopt;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << short_help(app);
    return std::nullopt;
  } catch (const CLI::CallForAllHelp&) {
    std::cout << long_help(app);
    return std::nullopt;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << "\n";
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Usage_error(error.what());
  }
  return checked(app, raw);
}

} // namespace segment_mesh
