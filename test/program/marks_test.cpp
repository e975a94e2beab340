// SPDX-License-Identifier: GPL-3.0-or-later

// Edges and faces that a user marked: --constraints and --seeds.

#include "Program.h"

#include <sstream>

namespace marks_test {

/// A grid of 4 by 2 squares in a plane: point i + 5 j is at (i, j), square i + 4 j at its upper
/// right.
std::string grid()
{
  std::ostringstream out;
  out << "OFF\n15 8 0\n";
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 5; ++i)
      out << i << " " << j << " 0\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i)
      out << "4 " << i + 5 * j << " " << i + 1 + 5 * j << " " << i + 6 + 5 * j << " "
          << i + 5 + 5 * j << "\n";
  return out.str();
}

TEST_F(Program, makes_borders_of_drawn_edges)
{
  folder.write("a.off", grid());
  folder.write("a.txt", "# from side to side\n\n3 8 13 # a line of two edges\n");
  for (const std::string method : {"learned", "visibility", "two-step", "smooth-faces"}) {
    EXPECT_EQ(run("a.off -k 2 --constraints '{stem}.txt' -o a.seg --method " + method).status, 0);
    EXPECT_EQ(folder.read("a.seg"), "0\n0\n0\n1\n0\n0\n0\n1\n") << method;
  }
  const Outcome one = run("a.off -k 1 --constraints a.txt -o a.json");
  EXPECT_NE(one.out.find("2 segments of 1 (constraints and seeds give no fewer)"),
            std::string::npos)
    << one.out;
  EXPECT_NE(folder.read("a.json").find("\"constraints\":\"a.txt\""), std::string::npos);

  // They are drawn.
  EXPECT_EQ(run("a.off -k 2 --constraints a.txt -o a.png").status, 0);
  EXPECT_EQ(run("a.off --labels a.seg -o b.png").status, 0);
  EXPECT_NE(folder.read("a.png"), folder.read("b.png"));

  // An edge at a time, in any order and direction.
  folder.write("b.txt", "13 8\n3 8\n3 8\n");
  EXPECT_EQ(run("a.off -k 2 --constraints b.txt -o b.seg").status, 0);
  EXPECT_EQ(folder.read("b.seg"), "0\n0\n0\n1\n0\n0\n0\n1\n");
}

TEST_F(Program, keeps_faces_together_and_apart_by_seeds)
{
  folder.write("a.off", grid());
  folder.write("a.txt", "0 7 # a face and its seed\n4 7\n3 2\n7 2\n");
  EXPECT_EQ(run("a.off -k 2 --seeds a.txt -o a.seg").status, 0);
  const std::string labels = folder.read("a.seg");
  EXPECT_EQ(labels[0], '0');
  EXPECT_EQ(labels[2 * 4], '0');
  EXPECT_EQ(labels[2 * 3], '1');
  EXPECT_EQ(labels[2 * 7], '1');
  EXPECT_EQ(labels.size(), 16u);
  EXPECT_NE(run("a.off -k 1 --seeds a.txt -o a.seg").out.find("2 segments of 1 (constraints"),
            std::string::npos);
  EXPECT_EQ(run("a.off -k 2 --seeds a.txt -o a.png").status, 0);
  const std::string marked = folder.read("a.png");
  EXPECT_EQ(run("a.off -k 2 --labels a.seg -o b.png").status, 2);
  EXPECT_EQ(run("a.off --labels a.seg -o b.png").status, 0);
  EXPECT_NE(marked, folder.read("b.png")); // faces with a seed have an outline
}

TEST_F(Program, counts_points_as_the_file_does)
{
  // Points of an STL file: the different ones.
  folder.write(
    "a.stl",
    "solid\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 1 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "endsolid\n");
  folder.write("a.txt", "1 2\n"); // the common edge
  EXPECT_NE(run("a.stl -k 1 --constraints a.txt").out.find("2 segments of 1"), std::string::npos);
  folder.write("b.txt", "0 3\n");
  EXPECT_EQ(run("a.stl -k 1 --constraints b.txt").err,
            "b.txt:1: no edge joins the points 0 and 3\n");

  // A point that no face uses, and a face that is oriented otherwise.
  folder.write("c.off", "OFF\n5 2 0\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n3 1 4 3\n");
  folder.write("c.txt", "3 1\n");
  EXPECT_NE(run("c.off -k 1 --constraints c.txt").out.find("2 segments of 1"), std::string::npos);
  folder.write("d.txt", "0 1\n");
  EXPECT_EQ(run("c.off -k 1 -q --constraints d.txt").err,
            "d.txt:1: no edge joins the points 0 and 1\n");
  folder.write("s.txt", "0 5\n1 6\n");
  EXPECT_EQ(run("c.off -k 1 -q --seeds s.txt -o c.seg").status, 0);
  EXPECT_EQ(folder.read("c.seg"), "0\n1\n");
}

TEST_F(Program, refuses_marks_that_it_cannot_use)
{
  folder.write("a.off", grid());
  const auto error = [&](const std::string& option, const std::string& text) {
    folder.write("a.txt", text);
    const Outcome outcome = run("a.off -k 2 -o a.seg " + option + " a.txt");
    EXPECT_EQ(outcome.status, 1) << text;
    return outcome.err;
  };
  EXPECT_EQ(error("--constraints", "0 1\n\n0 6\n"),
            "a.txt:3: no edge joins the points 0 and 6\n"); // a diagonal
  EXPECT_EQ(error("--constraints", "2 2\n"), "a.txt:1: no edge joins the points 2 and 2\n");
  EXPECT_EQ(error("--constraints", "0 1\n4\n"), "a.txt:2: a line of 1 point\n");
  EXPECT_EQ(error("--constraints", "14 15\n"),
            "a.txt:1: '15' is out of range: there are 15 points\n");
  EXPECT_EQ(error("--constraints", "0 -1\n"),
            "a.txt:1: '-1' is out of range: there are 15 points\n");
  EXPECT_EQ(error("--constraints", "0 x\n"), "a.txt:1: 'x' is not the index of a point\n");
  EXPECT_EQ(error("--seeds", "8 0\n"), "a.txt:1: '8' is out of range: there are 8 faces\n");
  EXPECT_EQ(error("--seeds", "0\n"), "a.txt:1: a face without a seed\n");
  EXPECT_EQ(error("--seeds", "0 -1\n"), "a.txt:1: a seed is at least 0\n");
  EXPECT_EQ(error("--seeds", "0 1 2\n"), "a.txt:1: more than a face and a seed on a line\n");
  EXPECT_EQ(error("--seeds", "0 1\n0 1\n0 2\n"), "a.txt:3: face 0 has the seed 1 already\n");
  EXPECT_EQ(run("a.off -k 2 --seeds none").status, 1);

  // Equal seeds on both sides of a line that must be a border.
  folder.write("line.txt", "2 7 12\n");
  folder.write("a.txt", "0 0\n3 0\n");
  const Outcome outcome = run("a.off -k 2 --constraints line.txt --seeds a.txt");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.rfind("a.off: ", 0), 0u) << outcome.err;

  folder.write("a.seg", "0\n0\n0\n0\n0\n0\n0\n0\n");
  expect_wrong_usage("a.off --labels a.seg --seeds a.txt",
                     "--seeds: with --labels nothing is segmented");
  expect_wrong_usage("a.off --labels a.seg --constraints a.txt",
                     "--constraints: with --labels nothing is segmented");
  expect_wrong_usage("a.off --seeds a.txt --smooth-borders",
                     "--smooth-borders: borders would move across faces with seeds");
  expect_wrong_usage("a.off a.off --seeds a.txt",
                     "--seeds a.txt: with several inputs it holds {stem}");
  expect_wrong_usage("a.off --seeds a.txt -o seg:a.txt", "-o a.txt: would replace the seeds");
}

} // namespace marks_test
