#!/usr/bin/env python3
"""tables.py FILE.csv...: prints the tables of doc/accuracy.md and doc/performance.md in Markdown.

The files are those of princeton_benchmark, train_merge_cost --scores, label_stability and
speed_benchmark, in any number; their first lines tell which.
"""
import collections
import csv
import math
import statistics
import sys

MEASURES = ["rand_index_distance", "cut_discrepancy", "hamming_distance", "gce", "lce"]


def table(title, head, rows):
    """A table in Markdown; the first column holds names."""
    lines = [head, ["---"] + ["---:"] * (len(head) - 1)] + rows
    return f"{title}\n\n" + "".join("| " + " | ".join(line) + " |\n" for line in lines)


def score(value, digits=4):
    """As in the documents, .0815; empty for nothing."""
    return "" if value is None or math.isnan(value) else f"{value:.{digits}f}".removeprefix("0")


def grouped(rows, *columns):
    """The rows by the values of the columns, in the order of the rows."""
    groups = collections.defaultdict(list)
    for row in rows:
        key = tuple(row[column] for column in columns)
        groups[key[0] if len(columns) == 1 else key].append(row)
    return groups


def mean(values):
    """Of those that are defined; nothing where there are none."""
    values = [value for value in values if value is not None and not math.isnan(value)]
    return statistics.fmean(values) if values else None


# Scores


def value(row, measure):
    return float(row[measure] or "nan")


def against_all(rows, measure):
    """The standard protocol: the mean over the people."""
    return mean(value(row, measure) for row in rows)


def results_and_truths(rows):
    """The paper's protocol: people of the number k alone are the truth. People are results, too,
    each of which is compared with the others: yields the rows of each result, in the order of the
    people."""
    for result, group in grouped(rows, "number").items():
        truths = [row for row in group if row["person_segments"] == row["k"]]
        yield result, sorted(truths, key=lambda row: int(row["person"]))


def against_first(rows, measure):
    """The first of these people is no result."""
    truths = {int(row["person"]) for row in rows if row["person_segments"] == row["k"]}
    first = str(min(truths)) if truths else None
    return mean(value(group[0], measure) for result, group in results_and_truths(rows)
                if group and result != first)


def against_nearest(rows, measure):
    return mean(min(value(row, measure) for row in group)
                for _, group in results_and_truths(rows) if group)


def model_scores(rows, protocol=against_all, measure=MEASURES[0]):
    """The score of each model in a protocol, by category and model."""
    scores = {key: protocol(group, measure)
              for key, group in grouped(rows, "category", "model").items()}
    return {key: s for key, s in scores.items() if s is not None}


def category_scores(scores):
    categories = collections.defaultdict(list)
    for (category, _), s in scores.items():
        categories[category].append(s)
    return {category: mean(values) for category, values in categories.items()}


def overall(rows, *arguments):
    """The mean over categories; of furniture, whose kinds have one to many pieces, over pieces."""
    scores = model_scores(rows, *arguments)
    if rows and rows[0]["collection"] == "benchmark":
        scores = category_scores(scores)
    return mean(scores.values())


def with_error(rows):
    """The score of a way, and its standard error over models."""
    values = list(model_scores(rows).values())
    if len(values) < 2:
        return score(overall(rows))
    return f"{score(overall(rows))} ± {score(statistics.stdev(values) / math.sqrt(len(values)))}"


def ways_of(rows):
    """The rows of each way by where its number of segments comes from; people's own are given."""
    ways = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        ways[row["way"]]["given" if row["way"] == "people" else row["number"]].append(row)
    return ways


def score_tables(rows):
    for collection, part in grouped(rows, "collection").items():
        ways = ways_of(part)
        yield table(f"1 - Rand index, {collection}, {len(grouped(part, 'model'))} models",
                    ["", "k given", "k chosen", "best k in hindsight"],
                    [[way] + [with_error(by[n]) if by[n] else "" for n in ("given", "chosen", "best")]
                     for way, by in ways.items()])
        columns = [(way, n) for way, by in ways.items() for n in ("given", "chosen")
                   if by[n] and "(" not in way]
        by_category = [category_scores(model_scores(ways[way][n])) for way, n in columns]
        yield table(f"1 - Rand index by category, {collection}",
                    [""] + [f"{way}, {n}" for way, n in columns],
                    [[category] + [score(scores.get(category), 3) for scores in by_category]
                     for category in grouped(part, "category")])
        if collection == "benchmark":
            yield paper_table(ways)
            yield measures_table(ways)
        yield from times_table(ways)


def paper_table(ways):
    return table("1 - Rand index in the protocol of Yang et al. 2014, k given, means over models",
                 ["", "first person", "nearest person"],
                 [[way] + [score(mean(model_scores(by["given"], p).values()), 3)
                           for p in (against_first, against_nearest)]
                  for way, by in ways.items() if by["given"]])


def measures_table(ways):
    return table("All measures, k given where it can be", [""] + MEASURES,
                 [[way] + [score(overall(by["given"] or by["chosen"], against_all, m))
                           for m in MEASURES]
                  for way, by in ways.items() if by["given"][:1] + by["chosen"][:1]
                  and (by["given"] or by["chosen"])[0]["lce"]])


def times_table(ways):
    lines = []
    for way, by in ways.items():
        for number in ("given", "chosen"):
            seconds = [float(group[0]["seconds"]) for group in grouped(by[number], "model").values()]
            if any(seconds):
                lines.append([f"{way}, {number}"] + [f"{1000 * s:.1f}" for s in (
                    statistics.fmean(seconds), statistics.median(seconds), max(seconds))])
    if lines:
        yield table("Processor time, ms a model", ["", "mean", "median", "slowest"], lines)


# Copies of meshes


def copy_tables(rows):
    for draws, part in grouped(rows, "draws").items():
        lines = []
        for kind, group in grouped(part, "copy").items():
            line = [kind]
            for column in ("given", "chosen"):
                values = [float(row[column]) for row in group]
                line.append(f"{score(statistics.fmean(values))}, {score(statistics.median(values))}, "
                            f"{score(max(values), 2)}")
            others = sum(row["number"] != row["number_of_copy"] for row in group)
            lines.append(line + [str(others)])
        yield table(f"1 - Rand index between the labels of a mesh and of its copy, {draws} draws, "
                    f"{len(grouped(part, 'model'))} models",
                    ["copy", "k given: mean, median, largest", "chosen: mean, median, largest",
                     "other numbers"], lines)


# Speed


def median_of(rows, quantity):
    """The median over the rounds of a case; nothing where it was not measured."""
    values = [float(row["value"]) for row in rows if row["quantity"] == quantity]
    return statistics.median(values) if values else None


def ratio_to_floor(rows):
    """Ratios are taken in each round: what disturbs a round disturbs both."""
    ratios = [float(part["all"]) / float(part["floor"])
              for part in ({row["quantity"]: row["value"] for row in group}
                           for group in grouped(rows, "round").values()) if "floor" in part]
    return statistics.median(ratios) if ratios else None


def number(value, digits=0):
    return "" if value is None else f"{value:.{digits}f}"


def speed_tables(rows):
    cases = grouped(rows, "mesh", "faces", "threads", "what")
    yield table("ns a face, times the floor, bytes a face",
                ["mesh", "faces", "threads", "what", "ns", "/ floor", "bytes"],
                [list(case) + [number(median_of(group, "all")), number(ratio_to_floor(group), 1),
                               number(median_of(group, "bytes"))]
                 for case, group in cases.items()])
    staged = {case: [q for q in dict.fromkeys(row["quantity"] for row in group)
                     if q not in ("all", "floor", "bytes")] for case, group in cases.items()}
    for what in dict.fromkeys(case[3] for case in cases if staged[case]):
        columns = [case for case in cases if case[3] == what]
        stages = dict.fromkeys(stage for case in columns for stage in staged[case])
        yield table(f"Stages of {what}, ns a face",
                    ["stage"] + [f"{mesh}, {faces} faces" + (f", {threads} threads" if threads != "1"
                                                            else "")
                                 for mesh, faces, threads, _ in columns],
                    [[stage] + [number(median_of(cases[case], stage)) for case in columns]
                     for stage in stages])


def main(files):
    tables_of = {"way": score_tables, "copy": copy_tables, "mesh": speed_tables}
    rows = collections.defaultdict(list)
    for file in files:
        with open(file, newline="") as lines:
            reader = csv.DictReader(lines)
            rows[reader.fieldnames[0]] += reader
    for first_column, tables in tables_of.items():
        if rows[first_column]:
            print("\n".join(tables(rows[first_column])))


if __name__ == "__main__":
    main(sys.argv[1:])
