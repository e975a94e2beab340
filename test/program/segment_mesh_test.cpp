// SPDX-License-Identifier: GPL-3.0-or-later

// The program as its users meet it: what it prints, writes and returns.

#include "Program.h"
#include "read/read_mesh.h"
#include "sample_files.h"

#include <cmath>
#include <sstream>

#include <sys/stat.h>

namespace segment_mesh_test {

using segment_mesh::Point;
using segment_mesh::Polygon_soup;
using segment_mesh::read_mesh;

const std::string time_at_end = ", [0-9]+\\.[0-9]{3} s\n";

TEST_F(Program, segments_its_own_model)
{
  const Outcome outcome = run("--demo -o '{stem}.seg'");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(std::regex_match(
    outcome.out,
    std::regex("figure: [0-9]+ faces, [0-9]+ regions, 10 segments" + time_at_end +
               "  true parts: Rand index distance 0\\.0[0-9]{3}, cut discrepancy .*\n")))
    << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder.names(), Names{"figure.seg"});
}

TEST_F(Program, prints_a_line_for_an_input)
{
  folder.write("a.off", sample::off());
  const Outcome outcome = run("a.off -k 1 --method two-step");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(std::regex_match(outcome.out,
                               std::regex("a\\.off: 4 faces, 1 region, 1 segment" + time_at_end)))
    << outcome.out;
  EXPECT_EQ(outcome.err, "Nothing is written. A page to view and rotate the segments: -o a.html; a "
                         "mesh in their colors: -o "
                         "a_segments.ply\n");
  EXPECT_EQ(run("a.off -k 1 -o a.seg").err, "");
  const Outcome quiet = run("a.off -k 1 -q");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Program, says_why_it_gives_fewer_or_more_segments)
{
  folder.write("a.off", sample::off());
  EXPECT_TRUE(std::regex_match(
    run("a.off -k 3 --method two-step").out,
    std::regex("a\\.off: 4 faces, 1 region, 1 segment of 3 \\(growing gave 1 region\\)" +
               time_at_end)));
  EXPECT_TRUE(std::regex_match(
    run("a.off -k 5").out,
    std::regex("a\\.off: 4 faces, 4 regions, 4 segments of 5 \\(the mesh has 4 faces\\)" +
               time_at_end)));

  folder.write("b.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  EXPECT_TRUE(std::regex_match(
    run("b.off -k 1 --no-links").out,
    std::regex(
      "b\\.off: 2 faces, 2 regions, 2 segments of 1 \\(the mesh has 2 connected pieces\\)" +
      time_at_end)));
}

TEST_F(Program, gives_all_regions_of_two_step_without_a_number)
{
  folder.write("a.off", sample::off());
  EXPECT_EQ(without_times(run("a.off --method two-step --features all -o a.seg").out),
            "a.off: 4 faces, 4 regions, 4 segments\n");
  EXPECT_EQ(folder.read("a.seg"), "0\n1\n2\n3\n");
  for (const char* without_features : {"", "--features all --max-angle 130"})
    EXPECT_EQ(without_times(run("a.off --method two-step " + std::string(without_features)).out),
              "a.off: 4 faces, 1 region, 1 segment\n");
}

TEST_F(Program, chooses_the_number_of_segments)
{
  ASSERT_EQ(run("--demo -o a.off").status, 0);
  const Outcome outcome = run("a.off -o a.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::regex_match(
    outcome.out,
    std::regex("a\\.off: [0-9]+ faces, [0-9]+ regions, [0-9]+ segments" + time_at_end)))
    << outcome.out;
  EXPECT_NE(folder.read("a.json").find("\"method\":\"learned\",\"segments\":null"),
            std::string::npos);
}

TEST_F(Program, takes_the_largest_number_of_segments)
{
  folder.write("a.off", sample::off());
  const std::string number = std::to_string(std::size_t(-1));
  const Outcome outcome = run("a.off -k " + number);
  EXPECT_EQ(without_times(outcome.out),
            "a.off: 4 faces, 4 regions, 4 segments of " + number + " (the mesh has 4 faces)\n");
}

TEST_F(Program, runs_all_methods)
{
  const Outcome visibility = run("--demo --method visibility"),
                two_step = run("--demo --method two-step"),
                learned = run("--demo --method learned"), standard = run("--demo");
  const auto line_without_time = [](const Outcome& o) {
    return o.out.substr(0, o.out.find(" segments"));
  };
  EXPECT_EQ(line_without_time(learned), line_without_time(standard));
  EXPECT_NE(line_without_time(two_step), line_without_time(standard));
  EXPECT_EQ(visibility.status, 0) << visibility.err;
}

TEST_F(Program, writes_every_format)
{
  folder.write("a.off", sample::off());
  const Outcome outcome = run(
    "a.off -k 4 --method two-step --features all --max-angle 20 -o a.seg -o b.ply -o b.off "
    "-o b.obj -o b.vtp -o b.stl -o b.3mf -o b.json -o b.csv -o b.png --borders c.obj --borders "
    "c.vtp");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.names(), (Names{"a.off", "a.seg", "b.3mf", "b.csv", "b.json", "b.mtl", "b.obj",
                                   "b.off", "b.ply", "b.png", "b.stl", "b.vtp", "c.obj", "c.vtp"}));
  EXPECT_EQ(folder.read("a.seg"), "0\n1\n2\n3\n");
}

TEST_F(Program, chooses_the_number_of_smooth_faces)
{
  folder.write("a.off", sample::off());
  EXPECT_NE(run("a.off --method smooth-faces -o a.json").out.find(" 4 segments"),
            std::string::npos);
  EXPECT_NE(folder.read("a.json").find("\"method\":\"smooth-faces\",\"segments\":null"),
            std::string::npos);
  EXPECT_NE(run("a.off -k 2 --method smooth-faces").out.find(" 2 segments"), std::string::npos);
}

TEST_F(Program, colors_by_kind)
{
  folder.write("a.off", sample::off());
  EXPECT_EQ(run("a.off --method smooth-faces --color kind -o a.png").status, 0);
  EXPECT_EQ(run("a.off --method smooth-faces -o b.png").status, 0);
  EXPECT_NE(folder.read("a.png"), folder.read("b.png"));
  const Outcome outcome = run("a.off --color kind -o c.png");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("--color kind: --method smooth-faces alone"), std::string::npos);
}

TEST_F(Program, goes_on_after_a_bad_input)
{
  folder.write("a.off", sample::off());
  folder.write("c.obj", sample::obj());
  folder.write("b.off", sample::with(sample::off(), "3 1 2 3", "3 1 2 9"));
  folder.write("d.foo", sample::off());
  const Outcome outcome = run("a.off b.off d.foo none.off c.obj -k 1 -o '{stem}.seg'");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "b.off:9: index 9 is out of range: there are 4 vertices, from 0\n"
            "d.foo: unknown extension '.foo', not .off, .obj, .ply, .stl, .glb or .gltf\n"
            "none.off: no such file\n");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
  EXPECT_EQ(folder.names(), (Names{"a.off", "a.seg", "b.off", "c.obj", "c.seg", "d.foo"}));
}

TEST_F(Program, is_quiet_about_remarks_if_asked)
{
  folder.write("a.obj", "hello\n" + sample::obj());
  const Outcome loud = run("a.obj -k 1 -o a.seg -o a.json");
  EXPECT_EQ(loud.status, 0);
  EXPECT_NE(folder.read("a.json").find("unknown statement 'hello' skipped"), std::string::npos);
  EXPECT_EQ(loud.err.rfind("a.obj:1: unknown statement 'hello' skipped", 0), 0u) << loud.err;
  EXPECT_EQ(folder.read("a.seg"), "0\n0\n0\n0\n");
  const Outcome quiet = run("a.obj -k 1 --quiet");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

/// Two tetrahedra a little apart, each face with points of its own, some of them turned.
TEST_F(Program, segments_what_is_no_manifold)
{
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 3, 2}, {0, 3, 2}};
  std::ostringstream points, polygons;
  for (int body = 0; body < 2; ++body)
    for (int f = 0; f < 4; ++f) {
      for (int i : faces[f])
        points << corners[i][0] + 1.1 * body << " " << corners[i][1] << " " << corners[i][2]
               << "\n";
      const int first = 12 * body + 3 * f;
      polygons << "3 " << first << " " << first + 1 << " " << first + 2 << "\n";
    }
  folder.write("a.off", "OFF\n24 8 0\n" + points.str() + polygons.str());
  const Outcome linked = run("a.off -k 1 -o a.seg -o a.json -o a.csv");
  EXPECT_EQ(linked.status, 0) << linked.err;
  EXPECT_NE(linked.out.find("8 faces, "), std::string::npos);
  EXPECT_NE(linked.out.find(", 1 segment, "), std::string::npos) << linked.out;
  EXPECT_EQ(folder.read("a.seg"), "0\n0\n0\n0\n0\n0\n0\n0\n");
  const Outcome apart = run("a.off -k 1 --no-links -o a.seg");
  EXPECT_NE(apart.out.find("2 segments of 1 (the mesh has 2 connected pieces)"), std::string::npos)
    << apart.out;
  EXPECT_EQ(folder.read("a.seg"), "0\n0\n0\n0\n1\n1\n1\n1\n");
}

TEST_F(Program, compares_with_truths)
{
  folder.write("a.off", sample::off());
  folder.write("a.seg", "7\n7\n7\n7\n");
  folder.write("b.seg", "0\n1\n2\n3\n");
  const Outcome outcome = run("a.off -k 1 --truth '{stem}.seg' --truth b.seg");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(
    outcome.out.substr(outcome.out.find('\n') + 1),
    "  a.seg: Rand index distance 0.0000, cut discrepancy undefined, Hamming distance 0.0000, "
    "global consistency error 0.0000, local consistency error 0.0000\n"
    "  b.seg: Rand index distance 1.0000, cut discrepancy undefined, Hamming distance 0.3170, "
    "global consistency error 0.0000, local consistency error 0.0000\n"
    "  mean: Rand index distance 0.5000, cut discrepancy undefined, Hamming distance 0.1585, "
    "global consistency error 0.0000, local consistency error 0.0000\n");
  EXPECT_EQ(run("a.off -k 1 -q --truth '{stem}.seg' --truth b.seg").out,
            outcome.out.substr(outcome.out.find('\n') + 1));
  folder.write("b.seg", "0\nx\n");
  EXPECT_EQ(run("a.off -k 1 --truth b.seg").err, "b.seg:2: 'x' is not a label\n");
  folder.write("b.seg", "0\n1\n");
  const Outcome short_truth = run("a.off -k 1 --truth b.seg");
  EXPECT_EQ(short_truth.err, "b.seg: 2 labels for 4 faces\n");
  EXPECT_EQ(short_truth.status, 1);
  folder.write("b.seg", "0\n1 1\n2\n3\n");
  EXPECT_EQ(run("a.off -k 1 --truth b.seg").err, "b.seg:2: more than one label on a line\n");
}

TEST_F(Program, leaves_nothing_half_written)
{
  folder.write("a.off", sample::off());
  folder.write("figure.ply", "old");
  const Outcome outcome = run("--demo -o figure.ply", without_counts() + "ulimit -f 8 &&");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "figure.ply: cannot be written: File too large\n");
  EXPECT_EQ(folder.read("figure.ply"), "old");
  EXPECT_EQ(folder.names(), (Names{"a.off", "figure.ply"}));
}

TEST_F(Program, writes_no_message_into_an_output_where_a_stream_is_closed)
{
  std::string inputs;
  for (int i = 0; i < 40; ++i) // a face is turned: a remark for each
    inputs += " '" +
              folder.write("a" + std::to_string(i) + ".off",
                           "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n") +
              "'";
  for (const char* closed : {">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    const std::string command = "'" SEGMENT_MESH "'" + inputs + " -k 1 --threads 4 -o '" +
                                folder.path("{stem}.seg") + "' >/dev/null 2>/dev/null " + closed;
    static_cast<void>(std::system(command.c_str()));
    for (int i = 0; i < 40; ++i)
      EXPECT_EQ(folder.read("a" + std::to_string(i) + ".seg"), "0\n0\n") << closed;
  }
}

TEST_F(Program, tells_of_outputs_that_cannot_be_written)
{
  folder.write("a.off", sample::off());
  folder.write("b.off", sample::off());
  std::filesystem::create_directory(folder.path("b"));
  const Outcome outcome = run("a.off b.off -k 1 -o '{stem}/c.seg' -o '{stem}.seg'");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "a/c.seg: cannot be written: No such file or directory\n");
  EXPECT_EQ(folder.names(), (Names{"a.off", "a.seg", "b", "b.off", "b.seg"}));
  EXPECT_TRUE(folder.has("b/c.seg"));
  EXPECT_EQ(run("a.off -k 1 -o a.off/c.seg").err,
            "a.off/c.seg: cannot be written: Not a directory\n");
  EXPECT_EQ(run("a.off -k 1 -o b/../b.seg/../b").status, 2); // without an extension
}

TEST_F(Program, tells_of_a_folder_where_it_may_not_write)
{
  folder.write("a.off", sample::off());
  std::filesystem::create_directory(folder.path("b"));
  std::filesystem::permissions(folder.path("b"), std::filesystem::perms::owner_read |
                                                   std::filesystem::perms::owner_exec);
  if (std::ofstream(folder.path("b/probe")))
    GTEST_SKIP() << "whoever runs this may write everywhere";
  const Outcome outcome = run("a.off -k 1 -o b/a.seg");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "b/a.seg: cannot be written: Permission denied\n");
}

TEST_F(Program, knows_wrong_usage)
{
  folder.write("a.off", sample::off());
  folder.write("b.off", sample::off());
  const std::string endings = ": unknown extension of an output, not .seg, .ply, .off, .obj, .vtp, "
                              ".json, .csv, .png, .html, .glb, .3mf, .stl, .msh or .step";
  for (const std::string size : {"0", "16385"})
    for (const std::string& sizes : {size, size + "x600", "600x" + size})
      expect_wrong_usage("a.off --size " + sizes,
                         "--size " + size + ": not a whole number from 1 to 16384");
  for (const std::string number : {"0", "-1", "many", "2.5", "18446744073709551616"})
    expect_wrong_usage("a.off -k " + number, "-k " + number + ": not a whole number from 1 to " +
                                               std::to_string(std::size_t(-1)));
  for (const std::string number : {"-1", "all", "1025"})
    expect_wrong_usage("a.off --threads " + number,
                       "--threads " + number + ": not a whole number from 0 to 1024");
  expect_wrong_usage("a.off -o '{stm}.seg'",
                     "-o {stm}.seg: unknown {stm}; there are {stem} and {segment}");
  expect_wrong_usage("a.off -o '{stem}_{}.seg'",
                     "-o {stem}_{}.seg: unknown {}; there are {stem} and {segment}");
  expect_wrong_usage("a.off --truth '{name}.seg'",
                     "--truth {name}.seg: unknown {name}; there is {stem} alone");
  expect_wrong_usage("a.off -k 2 --method two-step --max-angle 181",
                     "--max-angle: an angle from 0 to 180 degrees");
  expect_wrong_usage("a.off -k 2 --max-angle 5",
                     "--max-angle: --method learned has no feature edges");
  expect_wrong_usage("a.off -k 2 --features all",
                     "--features: --method learned has no feature edges");
  expect_wrong_usage("a.off -k 2 --method two-step --max-angle nan",
                     "--max-angle: an angle from 0 to 180 degrees");
  for (const std::string method : {"learned", "visibility", "two-step -k 2"})
    expect_wrong_usage("a.off --tolerance 0 --method " + method,
                       "--tolerance: --method " + method.substr(0, method.find(' ')) +
                         " fits no surfaces to faces");
  for (const std::string distance : {"-0.5", "nan", "inf"})
    expect_wrong_usage("a.off --method smooth-faces --tolerance " + distance,
                       "--tolerance: a finite distance, not negative");
  expect_wrong_usage("a.off -k 2 -o a.xyz", "a.xyz" + endings);
  expect_wrong_usage("a.off -k 2 -o a.gif", "a.gif" + endings);
  expect_wrong_usage("a.off -k 2 -o ./a.off", "-o ./a.off: would replace an input");
  expect_wrong_usage("a.off -k 2 --truth b.seg -o ./b.seg", "-o ./b.seg: would replace a truth");
  expect_wrong_usage("a.off b.off -k 2 --truth '{stem}.seg' -o '{stem}.seg'",
                     "-o a.seg: would replace a truth");
  expect_wrong_usage("a.off b.off -k 2 -o c.seg", "-o c.seg: with several inputs it holds {stem}");
  expect_wrong_usage("a.off b.off -k 2 --truth c.seg",
                     "--truth c.seg: with several inputs it holds {stem}");
  expect_wrong_usage("a.off a.off -k 2 -o '{stem}.seg'", "-o a.seg: would be written twice");
  expect_wrong_usage("a.off -k 2 -o a.seg -o ./a.seg", "-o ./a.seg: would be written twice");
  for (const char* arguments :
       {"a.off -k", "--frobnicate", "--mesh polyhedron", "a.off -k 2 --features some",
        "a.off -k 2 --method magic", "a.off --up w", "a.off --method smooth-faces --tolerance wide",
        "a.off --method smooth-faces --tolerance 1e999"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(Program, knows_wrong_usage_of_any_length)
{
  folder.write("a.off", sample::off());
  const std::string name = "{" + std::string(60000, 'x') + "}";
  expect_wrong_usage("a.off -o '{" + name + ".seg'",
                     "-o {" + name + ".seg: unknown " + name + "; there are {stem} and {segment}");
}

TEST_F(Program, helps)
{
  const Outcome help = run("--help"), short_help = run("-h"), nothing = run(""),
                version = run("--version");
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("\nExamples:\n"), std::string::npos);
  EXPECT_EQ(short_help.status, 0);
  EXPECT_LE(std::count(short_help.out.begin(), short_help.out.end(), '\n'), 30);
  const std::string last = "\nsegment_mesh --help lists all options.\n";
  EXPECT_EQ(short_help.out.find(last), short_help.out.size() - last.size()) << short_help.out;
  EXPECT_EQ(nothing.status, 0);
  EXPECT_EQ(nothing.out, short_help.out);
  EXPECT_EQ(nothing.err, "");
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(std::regex_match(version.out, std::regex("segment_mesh [0-9.]+\n"))) << version.out;
  for (const std::string& text : {help.out, short_help.out}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST_F(Program, has_a_manual_page_of_the_same_options)
{
  const Outcome help = run("--help");
  std::ifstream in(MAN_PAGE);
  const std::string page(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(page.rfind(".TH SEGMENT_MESH 1 ", 0), 0u);
  const std::regex option("\n  (?:-.,)?(--[a-z-]+)");
  std::size_t number = 0;
  for (std::sregex_iterator i(help.out.begin(), help.out.end(), option);
       i != std::sregex_iterator(); ++i, ++number)
    EXPECT_NE(page.find(std::regex_replace((*i)[1].str(), std::regex("-"), "\\-")),
              std::string::npos)
      << (*i)[1];
  EXPECT_GT(number, 14u);
  if (std::system("command -v groff >/dev/null") != 0)
    GTEST_SKIP() << "no groff";
  ASSERT_EQ(
    std::system(("groff -man -ww -z '" MAN_PAGE "' 2>'" + folder.path("warnings") + "'").c_str()),
    0);
  EXPECT_EQ(folder.read("warnings"), "");
}

TEST_F(Program, writes_to_stdout)
{
  folder.write("a.off", sample::off());
  const Outcome outcome = run("a.off -k 4 --method smooth-faces -o seg:-");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "0\n1\n2\n3\n");
  EXPECT_EQ(without_times(outcome.err), "a.off: 4 faces, 4 regions, 4 segments\n");
  const Outcome quiet = run("a.off -q -k 4 -o seg:-");
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, outcome.out);
  for (const std::string name : {"-", "/dev/stdout", "/dev/fd/1"})
    EXPECT_EQ(run("a.off -k 4 -o b.seg -o seg:" + name).out, outcome.out);
  EXPECT_EQ(folder.read("b.seg"), outcome.out);
  EXPECT_EQ(run("--demo -q -o off:- 2>early | head -c 3").out, "OFF"); // the reader
                                                                       // goes early
  EXPECT_EQ(folder.read("early"), "");
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_EQ(run("a.off -q -k 4 -o seg:- > /dev/full; exit $?; true").status, 1);
  }
}

/// Without a file of materials beside a device or a pipe.
TEST_F(Program, writes_to_devices_and_pipes)
{
  folder.write("a.off", sample::off());
  ASSERT_EQ(mkfifo(folder.path("b.obj").c_str(), 0600), 0);
  EXPECT_EQ(run("a.off -q -k 4 -o obj:/dev/null -o obj:/dev/null -o b.obj -o obj:/dev/fd/3 "
                "3> c.obj > /dev/null && wait",
                "{ timeout 20 cat b.obj > d.obj & } &&")
              .status,
            0);
  EXPECT_EQ(folder.names(), (Names{"a.off", "b.obj", "c.obj", "d.obj"}));
  EXPECT_EQ(folder.read("c.obj").substr(0, 2), "v ");
  EXPECT_EQ(folder.read("d.obj"), folder.read("c.obj"));
}

TEST_F(Program, takes_a_format_in_place_of_an_ending)
{
  folder.write("a.off", sample::off());
  EXPECT_EQ(run("a.off -k 4 -o seg:labels.txt").status, 0);
  EXPECT_EQ(folder.read("labels.txt"), "0\n1\n2\n3\n");
  EXPECT_EQ(run("a.off -k 4 -o seg:labels.txt.GZ").status, 0);
  EXPECT_EQ(folder.read("labels.txt.GZ").substr(0, 2), "\x1f\x8b");
}

TEST_F(Program, takes_segments_that_exist)
{
  folder.write("a.off", sample::off());
  folder.write("a.seg", "0\n1\n1\n0\n");
  folder.write("b.seg", "5\n-3\n-3\n5\n");
  const Outcome outcome = run(
    "a.off --labels '{stem}.seg' -o c.seg -o c.csv -o c.json --truth a.seg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(
    outcome.out.rfind("a.off: 4 faces, 2 segments\n  a.seg: Rand index distance 0.0000,", 0), 0u)
    << outcome.out;
  EXPECT_EQ(folder.read("c.seg"), folder.read("a.seg"));
  const std::string table = folder.read("c.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  EXPECT_NE(folder.read("c.json").find("\"settings\": {\"labels\":\"a.seg\"}"), std::string::npos);
  const Outcome numbered = run("a.off --labels b.seg -o c.seg");
  EXPECT_EQ(numbered.err, "b.seg: labels from -3 to 5 are numbered from 0 to 1\n");
  EXPECT_EQ(folder.read("c.seg"), "1\n0\n0\n1\n");
  folder.write("b.seg", "0\n");
  EXPECT_EQ(run("a.off --labels b.seg -o c.seg").err, "b.seg: 1 label for 4 faces\n");
}

TEST_F(Program, takes_faces_of_no_segment)
{
  folder.write("a.off", sample::off());
  folder.write("a.seg", "3\n-1\n2\n-1\n");
  const Outcome outcome = run("a.off --labels a.seg -o b.seg -o b.csv -o b.json -o b.ply -o b.obj "
                              "-o b.png -o b.html -o '{segment}.off' --borders c.obj");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "a.off: 4 faces, 2 segments\n");
  EXPECT_EQ(outcome.err, "a.seg: 2 faces of no segment: the label is -1\n"
                         "a.seg: labels from 2 to 3 are numbered from 0 to 1\n");
  EXPECT_EQ(folder.read("b.seg"), "1\n-1\n0\n-1\n");
  const std::string table = folder.read("b.csv"), json = folder.read("b.json");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  EXPECT_NE(table.find("\n0,1,"), std::string::npos) << table;
  EXPECT_NE(json.find("\"face_segments\": [1,-1,0,-1]"), std::string::npos) << json;
  for (const char* file : {"b.csv", "b.json", "b.obj", "c.obj"})
    EXPECT_EQ(folder.read(file).find("1844"), std::string::npos) << file;
  EXPECT_TRUE(folder.has("0.off") && folder.has("1.off"));
  EXPECT_EQ(folder.names().size(), 13u); // also b.mtl
  folder.write("a.seg", "-1\n-1\n-1\n-1\n");
  EXPECT_EQ(run("a.off --labels a.seg -o b.seg -o b.csv -o b.json -o b.ply -o b.png").out,
            "a.off: 4 faces, 0 segments\n");
  EXPECT_EQ(folder.read("b.seg"), folder.read("a.seg"));
}

TEST_F(Program, writes_a_file_for_each_segment)
{
  folder.write("a.off", sample::off());
  const Outcome outcome = run("a.off -k 4 -o '{stem}_{segment}.off' -o b{segment}.obj.gz");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.names(),
            (Names{"a.off", "a_0.off", "a_1.off", "a_2.off", "a_3.off", "b0.mtl", "b0.obj.gz",
                   "b1.mtl", "b1.obj.gz", "b2.mtl", "b2.obj.gz", "b3.mtl", "b3.obj.gz"}));
  EXPECT_EQ(folder.read("a_3.off").substr(0, 30), "OFF\n3 1 0\n0 0 0\n0 1 0\n0 0 1\n3 ");
}

TEST_F(Program, writes_each_segment_as_ply)
{
  folder.write("a.off", sample::off());
  EXPECT_EQ(run("a.off -k 4 -o 'b{segment}.ply'").status, 0);
  const std::vector<Point> corners[4] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                         {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                         {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                         {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
  for (int i = 0; i < 4; ++i) {
    const Polygon_soup soup = read_mesh(folder.path("b" + std::to_string(i) + ".ply")).soup;
    ASSERT_EQ(soup.polygons.size(), 1u);
    std::vector<Point> points;
    for (const std::size_t corner : soup.polygons[0])
      points.push_back(soup.points[corner]);
    EXPECT_EQ(points, corners[i]);
  }
}

TEST_F(Program, writes_faces_of_more_than_255_corners)
{
  // A cylinder of one side and two polygons.
  constexpr std::size_t n = 300;
  std::ostringstream mesh, bottom, top, side;
  mesh << "OFF\n" << 2 * n << " " << n + 2 << " 0\n";
  bottom << n;
  top << n;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * double(i) / n;
    mesh << std::cos(angle) << " " << std::sin(angle) << " 0\n"
         << std::cos(angle) << " " << std::sin(angle) << " 1\n";
    bottom << " " << 2 * (n - 1 - i);
    top << " " << 2 * i + 1;
    const std::size_t next = (i + 1) % n;
    side << "4 " << 2 * i << " " << 2 * next << " " << 2 * next + 1 << " " << 2 * i + 1 << "\n";
  }
  mesh << bottom.str() << "\n" << top.str() << "\n" << side.str();
  const Polygon_soup soup = read_mesh(folder.write("a.off", mesh.str())).soup;
  EXPECT_EQ(run("a.off -k 3 -o a.ply").status, 0);
  EXPECT_EQ(read_mesh(folder.path("a.ply")).soup.polygons, soup.polygons);
  EXPECT_NE(folder.read("a.ply").find("property list uint int vertex_indices"), std::string::npos);
}

TEST_F(Program, describes_a_cone_and_segments_without_neighbors_or_area)
{
  std::ostringstream mesh; // rings of a cone with half an angle of 30 degrees
  constexpr std::size_t sides = 60, rings = 6;
  mesh << "OFF\n" << sides * rings << " " << sides * (rings - 1) << " 0\n";
  for (std::size_t r = 1; r <= rings; ++r)
    for (std::size_t s = 0; s < sides; ++s) {
      const double angle = 2 * std::acos(-1.0) * double(s) / sides;
      mesh << double(r) * std::cos(angle) << " " << double(r) * std::sin(angle) << " "
           << -std::sqrt(3.0) * double(r) << "\n";
    }
  std::string labels;
  for (std::size_t r = 0; r + 1 < rings; ++r)
    for (std::size_t s = 0; s < sides; ++s) {
      const std::size_t t = (s + 1) % sides;
      mesh << "4 " << r * sides + s << " " << (r + 1) * sides + s << " " << (r + 1) * sides + t
           << " " << r * sides + t << "\n";
      labels += "0\n";
    }
  folder.write("a.off", mesh.str());
  folder.write("a.seg", labels);
  EXPECT_EQ(run("a.off --labels a.seg -o a.csv").status, 0);
  const std::string table = folder.read("a.csv");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(table, found, std::regex(",cone,,([0-9.]+),[^,]+,,[-0-9.e]+,")))
    << table; // no radius, no neighbors
  EXPECT_NEAR(std::stod(found[1]), 30, 0.5);

  folder.write("b.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n3 0 1 2\n3 2 1 3\n"); // on a line
  folder.write("b.seg", "0\n0\n");
  EXPECT_EQ(run("b.off --labels b.seg -o b.csv").status, 0);
  EXPECT_NE(folder.read("b.csv").find("\n0,2,0,0,"), std::string::npos)
    << folder.read("b.csv"); // no area, and no share
  EXPECT_EQ(folder.read("b.csv").find("nan"), std::string::npos);
}

TEST_F(Program, writes_a_table_of_finite_numbers_for_coordinates_of_any_size)
{
  for (const std::string size : {"1e308", "1e200", "1e-200", "1e-308"}) {
    folder.write("a.off", "OFF\n4 4 0\n0 0 0\n" + size + " 0 0\n0 " + size + " 0\n0 0 " + size +
                            "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    folder.write("a.seg", "0\n0\n1\n0\n");
    EXPECT_EQ(run("a.off --labels a.seg -o a.csv").status, 0);
    const std::string table = folder.read("a.csv"), lines = table.substr(table.find('\n'));
    EXPECT_EQ(lines.find("inf"), std::string::npos) << lines;
    EXPECT_EQ(lines.find("nan"), std::string::npos) << lines;
    // The shares of the three small faces, and of the large one.
    EXPECT_NE(lines.find(",0.6339745962"), std::string::npos) << lines;
    EXPECT_NE(lines.find(",0.3660254037"), std::string::npos) << lines;
  }
}

TEST_F(Program, tells_its_settings_in_json)
{
  folder.write("a.off", sample::off());
  folder.write("a.txt", "0 1\n1 2\n");
  const auto settings = [&](const std::string& arguments) {
    const Outcome outcome = run("a.off -o a.json " + arguments);
    const std::string json = folder.read("a.json"), name = "\"settings\": ";
    const std::size_t start = json.find(name) + name.size();
    return outcome.status == 0 ? json.substr(start, json.find('\n', start) - start) : outcome.err;
  };
  const auto expected = [](const std::string& method, const std::string& number,
                           const std::string& more) {
    return "{\"method\":\"" + method + "\",\"segments\":" + number +
           ",\"links\":true,\"smooth_borders\":false" + more + "},";
  };
  EXPECT_EQ(settings(""), expected("learned", "null", ""));
  EXPECT_EQ(settings("--method visibility"), expected("visibility", "null", ""));
  EXPECT_EQ(settings("--method smooth-faces -k 2"), expected("smooth-faces", "2", ""));
  EXPECT_EQ(settings("--method smooth-faces --tolerance 0.25"),
            expected("smooth-faces", "null", ",\"tolerance\":0.25"));
  EXPECT_EQ(settings("-k 2 --seeds a.txt"), expected("learned", "2", ",\"seeds\":\"a.txt\""));
  for (const std::string kind : {"concave", "convex", "all"})
    EXPECT_EQ(settings("--method two-step -k 1 --max-angle 20 --features " + kind),
              expected("two-step", "1", ",\"features\":\"" + kind + "\",\"max_angle\":20.0"));
}

TEST_F(Program, draws_a_mesh_as_seen_from_a_place)
{
  const auto write = [&](const std::string& name, const double(&points)[4][3]) {
    std::ostringstream mesh;
    mesh << "OFF\n4 4 0\n";
    for (const auto& p : points)
      mesh << p[0] << " " << p[1] << " " << p[2] << "\n";
    mesh << "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    folder.write(name, mesh.str());
  };
  const double points[4][3] = {{0, 0, 0}, {1.7, 0.1, 0.3}, {0.2, 1.3, 0.1}, {0.4, 0.3, 1.1}};
  double turned[4][3]; // about the y axis, so that the x axis becomes the z axis
  for (int i = 0; i < 4; ++i) {
    turned[i][0] = -points[i][2];
    turned[i][1] = points[i][1];
    turned[i][2] = points[i][0];
  }
  write("a.off", points);
  write("b.off", turned);
  const auto picture = [&](const std::string& arguments) {
    EXPECT_EQ(run(arguments + " -k 4 -o a.png").status, 0);
    return folder.read("a.png");
  };
  EXPECT_EQ(picture("a.off --view 90 20"), picture("b.off --view 0 20"));
  EXPECT_EQ(picture("a.off --view -270 20"), picture("a.off --view 90 20"));
  EXPECT_NE(picture("a.off --view 0 20"), picture("a.off --view 90 20"));
  EXPECT_NE(picture("a.off --view 90 -20"), picture("a.off --view 90 20"));
  expect_wrong_usage("a.off --view 361 0", "--view: an azimuth from -360 to 360 degrees");
  expect_wrong_usage("a.off --view nan 0", "--view: an azimuth from -360 to 360 degrees");
  expect_wrong_usage("a.off --view 0 -91", "--view: an elevation from -90 to 90 degrees");
  EXPECT_EQ(run("a.off --view 0").status, 2);
  EXPECT_EQ(picture("a.off --up y"), picture("a.off"));
  EXPECT_NE(picture("a.off --up z"), picture("a.off"));
  EXPECT_NE(picture("a.off --up -z --view 90 20"), picture("a.off --up z --view 90 20"));
  // Width and height are the first numbers of a PNG file.
  EXPECT_EQ(picture("a.off").substr(16, 8), std::string("\0\0\3\x20\0\0\2\x58", 8));
  EXPECT_EQ(picture("a.off --size 260x1").substr(16, 8), std::string("\0\0\1\4\0\0\0\1", 8));
  EXPECT_EQ(picture("a.off --size 7").substr(16, 8), std::string("\0\0\0\7\0\0\0\7", 8));
}

TEST_F(Program, tells_what_is_no_file)
{
  folder.write("b.off", sample::off());
  ASSERT_EQ(mkfifo(folder.path("a.off").c_str(), 0600), 0);
  std::filesystem::create_directory(folder.path("c.off"));
  const Outcome outcome = run("a.off c.off -k 1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "a.off: is not a regular file\nc.off: is a directory\n");
  const Outcome written = run("b.off -k 1 -o c.off -o none/b.off");
  EXPECT_EQ(written.status, 1);
  EXPECT_EQ(written.err, "c.off: is a directory\nnone/b.off: cannot be written: No such file or "
                         "directory\n");
}

TEST_F(Program, refuses_outputs_that_do_not_fit)
{
  folder.write("a.off", sample::off());
  folder.write("7.off", sample::off());
  folder.write("a.seg", "0\n1\n1\n0\n");
  expect_wrong_usage("-k 2 -o b.ply", "no INPUT; --demo segments a model of the program");
  expect_wrong_usage("a.off --demo", "--demo: there is an INPUT, too");
  expect_wrong_usage("a.off --labels a.seg -k 2", "--segments: with --labels nothing is segmented");
  expect_wrong_usage("a.off --labels a.seg -o a.seg", "-o a.seg: would replace the labels");
  expect_wrong_usage("a.off -o -", "-o -: needs a format, as in -o ply:-");
  expect_wrong_usage("a.off 7.off -k 2 -o ply:-", "-o -: with several inputs outputs are files");
  expect_wrong_usage("a.off -o ply:- -o ply:/dev/stdout", "-o -: would be written twice");
  expect_wrong_usage("a.off -o /dev/null", "-o /dev/null: needs a format, as in -o ply:/dev/null");
  expect_wrong_usage("a.off -o b.seg --solids", "--solids: no -o is a mesh");
  expect_wrong_usage("a.off --labels b.seg --labels-from groups",
                     "--labels-from: there are --labels, too");
  expect_wrong_usage("a.off --labels-from groups --seeds b.txt",
                     "--seeds: with --labels-from nothing is segmented");
  expect_wrong_usage("a.off -o b.ply --painted", "--painted: no -o is a .3mf");
  expect_wrong_usage("a.off -o b.3mf --painted --solids",
                     "--painted: with --solids the mesh is not in one piece");
  folder.write("b.obj", sample::obj());
  expect_wrong_usage("b.obj -o b.obj.gz",
                     "-o b.obj.gz: its .mtl would replace the materials of an input");
  expect_wrong_usage("a.off 7.off -k 2 -o '{segment}.off'",
                     "-o {segment}.off: with several inputs it holds {stem}");
  expect_wrong_usage("7.off -k 2 -o '{segment}.off'", "-o {segment}.off: would replace an input");
  expect_wrong_usage("a.off -k 2 -o 'b{segment}.off' -o b12.off",
                     "-o b12.off: would be written twice");
  expect_wrong_usage("a.off -k 2 -o b12.off -o 'b{segment}.off'",
                     "-o b{segment}.off: would be written twice");
  expect_wrong_usage("a.off -k 2 -o 'b{segment}1.off' -o b121.off",
                     "-o b121.off: would be written twice");
  std::filesystem::create_symlink("c.seg", folder.path("link.seg"));
  expect_wrong_usage("a.off -k 2 -o link.seg -o c.seg", "-o c.seg: would be written twice");
  expect_wrong_usage("'b{segment}.off' -k 2 -o '{stem}.seg'",
                     "-o {stem}.seg: {stem} is b{segment} here, which holds {segment}");
  expect_wrong_usage(
    "a.off -k 2 -o '{segment}.png'",
    "{segment}.png: a file for each segment is .ply, .off, .obj, .vtp, .stl, .glb, .3mf or .msh");
  expect_wrong_usage("a.off -k 2 -o '{segment}/b.ply'",
                     "{segment}/b.ply: {segment} belongs to the name of the file, not of its "
                     "folder");
  expect_wrong_usage("a.off -k 2 --borders -", "--borders -: borders are written to a file");
  expect_wrong_usage("a.off -k 2 --borders b.ply",
                     "--borders b.ply: polylines are written as .obj or .vtp");
  expect_wrong_usage("a.off -k 2 --borders '{segment}.obj'",
                     "--borders {segment}.obj: {segment} is for -o alone");
}

TEST_F(Program, smooths_borders)
{
  ASSERT_EQ(run("--demo -o a.off -o a.seg").status, 0);
  const Outcome outcome = run("a.off -k 10 --smooth-borders -o b.seg -o b.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(folder.read("b.seg"), folder.read("a.seg"));
  EXPECT_NE(folder.read("b.json").find("\"smooth_borders\":true"), std::string::npos);
}

TEST_F(Program, says_if_it_has_no_pages)
{
  const Outcome outcome = run("--demo -k 3 -o a.html -o a.seg");
  EXPECT_TRUE(folder.has("a.seg"));
  if (outcome.status == 1) { // built without
    EXPECT_EQ(
      outcome.err,
      "a.html: pages need three.js (Debian: libjs-three), and this program was built without it\n");
    EXPECT_FALSE(folder.has("a.html"));
    return;
  }
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = folder.read("a.html");
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  for (const char* fetched : {"<script src", "<link", "@import"})
    EXPECT_EQ(page.find(fetched), std::string::npos) << fetched;
}

std::size_t number_of_described(const std::string& page)
{
  const std::string described = "{\"node\":";
  std::size_t number = 0;
  for (std::size_t at = page.find(described); at != std::string::npos;
       at = page.find(described, at + 1))
    ++number;
  return number;
}

/// A strip folded along each of its short edges.
TEST_F(Program, describes_in_a_page_no_segments_that_it_does_not_show_at_first)
{
  constexpr int number = 250;
  std::string points, faces;
  for (int i = 0; i <= number; ++i)
    for (const char* y : {"0", "1"})
      points += std::to_string(i) + " " + y + (i % 2 == 0 ? " 0\n" : " 1\n");
  for (int i = 0; i < 2 * number; i += 2)
    faces += "4 " + std::to_string(i) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) +
             " " + std::to_string(i + 1) + "\n";
  folder.write("a.off", "OFF\n" + std::to_string(2 * number + 2) + " " + std::to_string(number) +
                          " 0\n" + points + faces);
  const Outcome outcome = run("a.off --method smooth-faces -o a.html");
  if (outcome.status == 1)
    GTEST_SKIP() << "built without pages";
  EXPECT_NE(outcome.out.find(" 250 segments"), std::string::npos) << outcome.out;
  EXPECT_EQ(number_of_described(folder.read("a.html")), 2u * 20 - 1);
  EXPECT_EQ(run("a.off -k 30 --method smooth-faces -o a.html").status, 0);
  EXPECT_EQ(number_of_described(folder.read("a.html")), 2u * 30 - 1);
}

/// Otherwise a page of ten thousands of pieces, in a file of 1 MB, takes a minute.
TEST_F(Program, describes_no_more_segments_in_a_page_than_it_can_in_time)
{
  for (const std::size_t number : {30u, 200u, 201u}) {
    std::string points, triangles;
    for (std::size_t i = 0; i < 3 * number; i += 3) {
      const std::string z = std::to_string(i);
      points += "0 0 " + z + "\n1 0 " + z + "\n0 1 " + z + "\n";
      triangles += "3 " + z + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    }
    folder.write("a.off", "OFF\n" + std::to_string(3 * number) + " " + std::to_string(number) +
                            " 0\n" + points + triangles);
    const Outcome outcome = run("a.off --no-links -o a.html");
    if (outcome.status == 1)
      GTEST_SKIP() << "built without pages";
    EXPECT_EQ(number_of_described(folder.read("a.html")), number <= 200 ? number : 0);
  }
}

TEST_F(Program, takes_no_empty_name_of_a_file)
{
  const std::string mesh = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const std::string option :
       {"--labels", "--seeds", "--constraints", "--truth", "-o", "--borders"}) {
    const Outcome outcome = run("a.off -k 1 " + option + " ''");
    EXPECT_EQ(outcome.status, 2) << option;
    EXPECT_NE(outcome.err.find("the name of a file is empty"), std::string::npos)
      << option << ": " << outcome.err;
  }
}

TEST_F(Program, fails_when_stdout_is_full)
{
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP() << "no /dev/full here";
  for (const std::string arguments : {"--demo", "--help", "--version", ""})
    EXPECT_EQ(run(arguments + " > /dev/full; exit $?; true").status, 1) << arguments;
}

} // namespace segment_mesh_test
