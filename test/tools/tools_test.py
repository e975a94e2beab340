#!/usr/bin/env python3
"""tools_test.py PROGRAMS FIGURE: the programs that measure, in the folder PROGRAMS, and tables.py,
on a small benchmark that is written here. FIGURE is a mesh in the format OFF."""
import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

programs, figure = (pathlib.Path(argument) for argument in sys.argv[1:3])
tables = pathlib.Path(__file__).with_name("tables.py")

# Two tetrahedra on one face: six faces.
BIPYRAMID = """OFF
5 6 0
0 0 1
1 0 0
0 1 0
-1 -1 0
0 0 -1
3 0 1 2
3 0 2 3
3 0 3 1
3 4 2 1
3 4 3 2
3 4 1 3
"""
# Of 15 pairs of faces 4, 6 and 10 are within a segment, always the same 4 in two of the three:
# 2 pairs differ between the first and the second, 6 and 8 between these and the third.
PEOPLE = ["0 0 0 1 1 2", "0 0 0 1 1 1", "0 0 0 0 0 1"]


def read(text):
    return list(csv.DictReader(io.StringIO(text)))


def cells(markdown, name):
    """The cells of the lines of the tables that begin with a name."""
    return [[cell.strip() for cell in line.split("|")[2:-1]] for line in markdown.splitlines()
            if line.startswith(f"| {name} |")]


class Tools_test(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        self.data = self.root / "psb"
        (self.data / "data" / "off").mkdir(parents=True)
        (self.data / "util" / "parameters").mkdir(parents=True)
        (self.data / "util" / "parameters" / "nSeg-ByModel.txt").write_text("2\n" * 42)

    def add_model(self, number, mesh, people):
        (self.data / "data" / "off" / f"{number}.off").write_text(mesh)
        folder = self.data / "data" / "seg" / "Benchmark" / str(number)
        folder.mkdir(parents=True)
        for j, labels in enumerate(people):
            (folder / f"{number}_{j}.seg").write_text("\n".join(labels.split()))

    def add_figure(self, number):
        """By the sign of x, and by that of y."""
        lines = figure.read_text().splitlines()
        points, faces = (int(n) for n in lines[1].split()[:2])
        corner = [lines[2 + int(line.split()[1])].split() for line in lines[2 + points:][:faces]]
        self.add_model(number, figure.read_text(),
                       [" ".join(str(int(float(p[i]) > 0)) for p in corner) for i in (0, 1)])

    def run_program(self, name, *arguments, status=0):
        result = subprocess.run([programs / name, *arguments], capture_output=True, text=True)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def tables_of(self, *texts):
        files = []
        for text in texts:
            files.append(self.root / f"{len(files)}.csv")
            files[-1].write_text(text)
        return subprocess.run([sys.executable, tables, *files], check=True, capture_output=True,
                              text=True).stdout

    def test_people_are_compared_with_each_other(self):
        self.add_model(1, BIPYRAMID, PEOPLE)
        rows = self.run_program("princeton_benchmark", "--data", self.data, "--methods", "people")
        self.assertEqual([round(15 * float(row["rand_index_distance"]))
                          for row in read(rows.stdout)], [2, 6, 2, 8, 6, 8])
        markdown = self.tables_of(rows.stdout)
        self.assertEqual(cells(markdown, "people")[0], [".3556", "", ""])
        # The truths are the second person, who is no result, and the third.
        self.assertEqual(cells(markdown, "people")[1], [".333", ".400"])
        self.assertEqual(cells(markdown, "Human"), [[".356"]])

    def test_a_model_that_fails_is_told_of_and_the_others_are_scored(self):
        self.add_model(1, BIPYRAMID, ["0 0 0 1 1"])
        self.add_model(21, BIPYRAMID, PEOPLE)
        result = self.run_program("princeton_benchmark", "--data", self.data, "--methods",
                                  "learned", status=1)
        self.assertIn("1_0.seg", result.stderr)
        rows = read(result.stdout)
        self.assertEqual([(row["category"], row["number"], row["k"], row["segments"])
                          for row in rows],
                         [("Cup", "given", "2", "2")] * 3 + [("Cup", "chosen", "2", "1")] * 3)

    def test_furniture_has_as_many_segments_as_large_parts(self):
        self.add_model(1, BIPYRAMID, PEOPLE)
        pieces = self.root / "furniture"
        pieces.mkdir()
        shutil.copy(figure, pieces / "Chair_a_1.off")
        faces = int(figure.read_text().split()[2])
        labels = [7] * (faces // 500) + [5] * (faces // 500 + 1) # just below .2 %, just above
        (pieces / "Chair_a_1.seg").write_text("\n".join(
            str(label) for label in labels + [0] * (faces - len(labels))))
        rows = read(self.run_program("princeton_benchmark", "--data", self.data, "--furniture",
                                     pieces, "--methods", "two-step").stdout)
        self.assertEqual([rows[-1][column] for column in
                          ("collection", "category", "model", "k", "segments", "person_segments")],
                         ["furniture", "Chair", "Chair_a_1", "2", "2", "3"])

    def test_methods_have_the_numbers_that_they_can_have(self):
        self.add_figure(2)
        rows = read(self.run_program("princeton_benchmark", "--data", self.data, "--methods",
                                     "learned,visibility,two-step,concave-angles,sdf", "--draws",
                                     "1").stdout)
        numbers = {}
        for row in rows:
            numbers.setdefault(row["way"].split(" ")[0], set()).add(row["number"])
            self.assertGreater(float(row["seconds"]), 0)
            if row["number"] == "given":
                self.assertEqual(row["segments"], row["k"])
        self.assertEqual(numbers, {
            "learned": {"given", "chosen"}, "visibility": {"given", "chosen"},
            "two-step": {"given"}, "concave-angles": {"given"}, "sdf": {"chosen"}})

    def test_copies_have_nearly_the_labels_of_the_mesh(self):
        self.add_figure(2)
        text = self.run_program("label_stability", "--data", self.data).stdout
        rows = read(text)
        self.assertEqual([row["copy"] for row in rows], ["renumbered", "motion", "5 digits",
                                                         "noise of 1e-7", "noise of 1e-5"])
        for row in rows:
            self.assertLess(float(row["chosen"]), .1, row)
        self.assertEqual(len(cells(self.tables_of(text), "motion")[0]), 3)

    def test_training_writes_a_model_and_scores_in_every_way(self):
        self.add_figure(2)
        self.add_figure(22)
        header = self.root / "model.h"
        all_rows = read(self.run_program("train_merge_cost", "--data", self.data, "--output",
                                         header, "--folds", "2", "--scores", "--draws", "1").stdout)
        self.assertEqual(sum(row["collection"] == "sheets" and row["way"] == "out of fold" and
                             row["number"] == "chosen" for row in all_rows), 20)
        rows = [row for row in all_rows if row["collection"] == "benchmark"]
        self.assertIn("from 2 models of the Princeton Segmentation Benchmark, of its even-numbered "
                      "half, number 2 to 22, and 20 sheets of the weight 0.2.\n", header.read_text())
        ways = {row["way"] for row in rows}
        self.assertLessEqual({"in sample", "out of fold", "out of fold (draws: 1)",
                              "out of fold (a tenth of the edges)", "out of fold (closed pieces)",
                              "category left out"}, ways)
        # numbers, models, and people, of whom one judges closed pieces
        self.assertEqual(len(rows), 3 * 2 * (2 * len(ways) - 1))
        for way in ways:
            mean = {number: sum(float(row["rand_index_distance"]) for row in rows
                                if row["way"] == way and row["number"] == number)
                    for number in ("given", "chosen", "best")}
            self.assertLessEqual(mean["best"], min(mean["given"], mean["chosen"]) + 1e-9, way)

    def test_means_are_of_people_then_models_then_categories(self):
        head = "way,number,collection,category,model,k,segments,seconds,person,person_segments," \
               "rand_index_distance,cut_discrepancy,hamming_distance,gce,lce\n"
        scores = [("a", 1, 0, .1), ("a", 1, 1, .3), ("a", 2, 0, .6), ("b", 3, 0, .8)]
        markdown = self.tables_of(head + "".join(
            f"m,given,{collection},{category},{model},2,2,.001,{person},{2 + person},{s},nan,{s},0,0\n"
            for collection in ("benchmark", "furniture") for category, model, person, s in scores))
        self.assertEqual([line[0] for line in cells(markdown, "m") if line[0].startswith(".")],
                         [".6000 ± .1764", ".500", ".6000", ".5333 ± .1764"])
        self.assertEqual(cells(markdown, "m")[2], [".6000", "", ".6000", ".0000", ".0000"])
        self.assertEqual(cells(markdown, "a"), [[".400"], [".400"]])
        self.assertEqual(cells(markdown, "m, given"), [["1.0", "1.0", "1.0"]] * 2)

    def test_copies_are_summed_up_by_number_of_draws(self):
        markdown = self.tables_of("copy,model,draws,given,chosen,number,number_of_copy\n"
                                  "c,1,5,.1,.2,3,3\nc,2,5,0,.4,3,4\nc,3,5,.5,.9,4,4\nc,3,1,0,0,4,4\n")
        self.assertEqual(cells(markdown, "c"), [
            [".2000, .1000, .50", ".5000, .4000, .90", "1"], [".0000, .0000, .00"] * 2 + ["0"]])

    def test_ratios_of_times_are_taken_in_each_round(self):
        rounds = [(100, 10, 30), (400, 80, 50), (900, 100, 40)]
        text = "mesh,faces,threads,what,round,quantity,value\ntorus,8,1,m,0,bytes,64\n" + "".join(
            f"torus,8,1,m,{i},floor,{floor}\ntorus,8,1,m,{i},reading,{reading}\n"
            f"torus,8,1,m,{i},all,{whole}\n"
            for i, (whole, floor, reading) in enumerate(rounds, 1)) + "torus,8,2,m,1,all,7\n"
        markdown = self.tables_of(text)
        self.assertEqual(cells(markdown, "torus"), [["8", "1", "m", "400", "9.0", "64"],
                                                    ["8", "2", "m", "7", "", ""]])
        self.assertEqual(cells(markdown, "reading"), [["40", ""]])

    def test_speed_is_measured_of_every_subject(self):
        if not (programs / "speed_benchmark").exists():
            self.skipTest("speed_benchmark is not built: see test/tools/build.sh")
        text = self.run_program("speed_benchmark", "--shapes", "torus", "--sizes", "2000",
                                "--rounds", "1", "--threads", "2").stdout
        lines = cells(self.tables_of(text), "torus")
        self.assertEqual(len(lines), 16)
        for line in lines:
            self.assertGreater(int(line[3]), 0, line)
        self.assertEqual({line[2] for line in lines if line[1] == "2"}, {"learned", "two-step"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
