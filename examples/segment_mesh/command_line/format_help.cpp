// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/format_help.h"

#include <CGAL/Region_segmentation/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

namespace segment_mesh {

namespace {

constexpr std::size_t columns = 80;
constexpr std::size_t text_column = 26; ///< where the texts of options begin

constexpr const char* description =
  "Segments surface meshes into parts, and prints a line for each: its faces, the regions that "
  "were merged, the segments, "
  "and the time from the mesh in memory to the labels. Meshes need not be manifold, oriented or "
  "connected; "
  "labels come back for each face of the file. Output files are written completely or not at all.";

struct Example
{
  const char *command, *text;
};

constexpr Example examples[] = {
  {"segment_mesh armadillo.off -o armadillo.html",
   "A page to view and rotate the parts, and to change their number."},
  {"segment_mesh armadillo.off -k 9 -o armadillo.seg -o parts.ply",
   "Nine parts: labels, and the mesh in colors."},
  {"segment_mesh gear.stl --method smooth-faces -o 'gear_{segment}.obj'",
   "A file for each face of a machine part."},
  {"segment_mesh *.off -k 7 -o 'parts/{stem}.vtp' --quiet", "A batch, for ParaView."},
  {"segment_mesh a.off --labels a.seg --truth b.seg -o a.csv",
   "Compare and describe existing segments."},
  {"segment_mesh a.off -q -o - --output-format csv | sort", "A table on stdout."}};

struct Status
{
  const char *number, *text;
};

constexpr Status statuses[] = {
  {"0", "done"},
  {"1",
   "an input could not be read, or an output could not be written; the others of a batch are done"},
  {"2", "wrong usage"}};

constexpr const char* usage = "segment_mesh [INPUT...] [-k N] [-o FILE]... [options]";

std::string repeated(char c, std::size_t number)
{
  return std::string(number, c);
}

/// Words in lines of at most 80 columns that begin in column `indent`; the first line stands at
/// column `at` already.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t at)
{
  std::string result = repeated(' ', at < indent ? indent - at : 0);
  std::size_t column = (std::max)(at, indent);
  const char* separator = "";
  std::istringstream words(text);
  for (std::string word; words >> word; separator = " ") {
    if (*separator != '\0' && column + 1 + word.size() > columns) {
      result += "\n" + repeated(' ', indent);
      column = indent;
      separator = "";
    }
    result += separator + word;
    column += *separator != '\0' ? 1 + word.size() : word.size();
  }
  return result + "\n";
}

/// `-k, --segments N`
std::string title(const CLI::Option& option)
{
  if (option.get_positional())
    return option.get_name() + "...";
  std::string names;
  for (const std::string& name : option.get_snames())
    names += "-" + name + ", ";
  for (const std::string& name : option.get_lnames())
    names += "--" + name;
  const std::string type_and_checks = option.get_type_name(),
                    type = type_and_checks.substr(0, type_and_checks.find(':'));
  return option.get_type_size() == 0 || type.empty() ? names : names + " " + type;
}

constexpr const char* groups[] = {"Input", "Segmentation", "Output", "Comparison", "Run"};

std::vector<const CLI::Option*> options_of(const CLI::App& app, const std::string& group)
{
  return app.get_options([&group](const CLI::Option* o) { return o->get_group() == group; });
}

} // namespace

std::string short_help()
{
  return "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION " segments surface meshes into parts.\n"
         "\n"
         "  segment_mesh mesh.off                     says how many parts it sees\n"
         "  segment_mesh mesh.off -o mesh.html        a page to view them in a browser\n"
         "  segment_mesh mesh.off -k 9 -o parts.ply   nine parts, in colors\n"
         "  segment_mesh --demo -o demo.png           a picture of a model of its own\n"
         "\n"
         "segment_mesh --help lists all options.\n";
}

std::string format_help(const CLI::App& app)
{
  std::string help = std::string("Usage: ") + usage + "\n\n" + wrapped(description, 0, 0);
  for (const std::string group : groups) {
    help += "\n" + group + ":\n";
    for (const CLI::Option* option : options_of(app, group)) {
      const std::string start = "  " + title(*option);
      const bool has_room = start.size() + 2 <= text_column;
      help += has_room ? start : start + "\n";
      help += wrapped(option->get_description(), text_column, has_room ? start.size() : 0);
    }
  }
  help += "\nExamples:\n";
  for (const Example& example : examples)
    help += std::string("  ") + example.command + "\n" + wrapped(example.text, 6, 0);
  help += "\nExit status:\n";
  for (const Status& status : statuses)
    help += wrapped(status.text, 5, 0).replace(2, 1, status.number);
  return help;
}

} // namespace segment_mesh
