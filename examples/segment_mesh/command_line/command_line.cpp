// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "read/errors.h"
#include "view/choose_viewpoint.h"

#include <CGAL/Region_segmentation/Support/version.h>

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>

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

namespace embedded {
extern const char* const help_txt;
} // namespace embedded

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

/// An option with a value of the kind that `type` names in messages.
template <typename Value>
CLI::Option* add_option(CLI::App& app, const char* names, Value& value, const char* type)
{
  CLI::Option* const option = app.add_option(names, value)->type_name(type);
  if (type == std::string_view("FILE")) // a script's unset variable is no name
    option->check(CLI::Validator(
      [](const std::string& word) { return word.empty() ? "the name of a file is empty" : ""; },
      ""));
  return option;
}

/// An option that may be given several times, with one file each time.
void add_repeatable(CLI::App& app, const char* names, std::vector<std::string>& files)
{
  add_option(app, names, files, "FILE")->allow_extra_args(false);
}

/// An option whose words stand for values.
template <typename Value, typename Target>
void add_choice(CLI::App& app, const char* names, Target& target,
                const std::map<std::string, Value>& values)
{
  std::vector<std::string> words;
  for (const auto& entry : values)
    words.push_back(entry.first);
  app
    .add_option_function<std::string>(
      names, [&target, &values](const std::string& word) { target = values.at(word); })
    ->check(CLI::IsMember(words));
}

void add_inputs(CLI::App& app, Raw_options& raw)
{
  app.add_option("INPUT", raw.options.inputs);
  add_choice(app, "--input-format", raw.options.input_format, formats);
  app.add_flag("--demo");
  add_option(app, "--labels", raw.options.side_files.labels, "FILE");
  add_choice(app, "--labels-from", raw.options.side_files.labels_from, set_kinds);
}

void add_segmentation(CLI::App& app, Raw_options& raw)
{
  add_option(app, "-k,--segments", raw.number_of_segments, "N");
  add_choice(app, "--method", raw.options.settings.method, methods);
  add_option(app, "--constraints", raw.options.side_files.constraints, "FILE");
  add_choice(app, "--constraints-from", raw.options.side_files.constraints_from, set_kinds);
  add_option(app, "--seeds", raw.options.side_files.seeds, "FILE");
  app.add_flag("--no-links");
  app.add_flag("--smooth-borders");
  add_choice(app, "--features", raw.options.settings.features, features);
  add_option(app, "--max-angle", raw.options.settings.maximum_angle, "DEGREES");
  add_option(app, "--tolerance", raw.options.settings.tolerance, "DISTANCE");
}

void add_outputs(CLI::App& app, Raw_options& raw)
{
  add_repeatable(app, "-o,--output", raw.outputs);
  app.add_flag("--solids");
  app.add_flag("--painted");
  add_repeatable(app, "--borders", raw.borders);
  add_choice(app, "--up", raw.options.view.up, up_directions);
  add_option(app, "--view", raw.view, "AZIMUTH ELEVATION");
  add_option(app, "--size", raw.size, "WIDTHxHEIGHT");
  add_choice(app, "--color", raw.options.coloring, colorings);
  add_repeatable(app, "--truth", raw.options.truths);
}

void add_run_options(CLI::App& app, Raw_options& raw)
{
  add_option(app, "--threads", raw.number_of_threads, "N")->take_last();
  app.add_flag("-q,--quiet");
  app.set_version_flag("--version", "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION);
}

/// That there is no such option, but maybe one that begins with the same two letters.
Usage_error unknown_option(const CLI::App& app, const std::string& word)
{
  std::size_t longest = 3; // of "--" and a letter
  std::string nearest;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& long_name : option->get_lnames()) {
      const std::string name = "--" + long_name;
      const auto differs = std::mismatch(name.begin(), name.end(), word.begin(), word.end());
      if (const auto length = std::size_t(differs.first - name.begin()); length > longest) {
        longest = length;
        nearest = "; did you mean " + name + "?";
      }
    }
  return Usage_error(word + ": no such option" + nearest);
}

/// The lines of help.txt on one option, all of them (`all`), or the table without further lines on
/// each option, if no option is given.
/// \throws Usage_error for an option that is not there
std::string help(const CLI::App& app, const std::string& option)
{
  const std::string indentation(27, ' '); // of further lines
  if (option == "all")
    return embedded::help_txt;
  std::string result;
  bool is_of_option = false;
  std::istringstream lines(embedded::help_txt);
  for (std::string line; std::getline(lines, line);) {
    const bool is_further_line = line.substr(0, indentation.size()) == indentation;
    if (!is_further_line) {
      const std::string names = line.size() < 3 ? "" : line.substr(2, line.find(' ', 2) - 2);
      is_of_option = ("," + names + ",").find("," + option + ",") != std::string::npos;
    }
    if (option.empty() ? !is_further_line : is_of_option)
      result += line + "\n";
  }
  if (result.empty())
    throw unknown_option(app, option);
  return result;
}

/// The greatest number of a range that the mesh limits.
constexpr std::size_t number_of_faces = (std::numeric_limits<std::size_t>::max)();

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
    throw Usage_error(
      option + " " + word + ": not a whole number from " + std::to_string(range.least) + " to " +
      (range.greatest == number_of_faces ? "the number of faces" : std::to_string(range.greatest)));
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
    options.settings.number_of_segments = whole_number("-k", raw.number_of_segments,
                                                       {1, number_of_faces});
  options.number_of_threads = whole_number("--threads", raw.number_of_threads, {0, most_threads});
  const double angle = options.settings.maximum_angle, tolerance = options.settings.tolerance;
  if (!(angle >= 0 && angle <= 180))
    throw Usage_error("--max-angle: an angle from 0 to 180 degrees");
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    throw Usage_error("--tolerance: a finite distance, not negative");
  options.settings.links = app.count("--no-links") > 0 ? Component_links::NONE
                                                       : Component_links::FOUND;
  options.settings.borders = app.count("--smooth-borders") > 0 ? Border_treatment::SMOOTHING
                                                               : Border_treatment::NONE;
  options.view = checked_view(app, raw);
  options.verbosity = app.count("--quiet") > 0 ? Verbosity::QUIET : Verbosity::NORMAL;
  return options;
}

} // namespace

std::optional<Options> parse_command_line(int argc, const char* const* argv)
{
  CLI::App app;
  Raw_options raw;
  add_inputs(app, raw);
  add_segmentation(app, raw);
  add_outputs(app, raw);
  add_run_options(app, raw);
  const char* const* const end = argv + argc;
  const char* const* const asked = std::find_if(
    argv, end, [](std::string_view word) { return word == "-h" || word == "--help"; });
  try {
    if (argc > 1 && asked == end)
      app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << "\n";
    return std::nullopt;
  } catch (const CLI::CallForHelp&) { // among other letters: -qh
    std::cout << help(app, "");
    return std::nullopt;
  } catch (const CLI::ExtrasError&) {
    throw unknown_option(app, app.remaining().front());
  } catch (const CLI::ParseError& error) {
    throw Usage_error(boost::replace_all_copy(std::string(error.what()),
                                              "At Most 1 required but received", "one value, not"));
  }
  if (argc <= 1 || asked != end) {
    std::cout << help(app, asked + 1 < end ? asked[1] : "");
    return std::nullopt;
  }
  return checked(app, raw);
}

} // namespace segment_mesh
