#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""coverage.py ROOT BUILD: sums what gcov says of the headers of the library and the sources of the program.

A line or branch of a template counts as executed if one of its instances executes it. Left out, since they are no decisions
of the source: both branches of a call that may throw; and those of blocks that only exceptions lead to and that were not
executed, on lines that do something else, too (the compiler's loops and flags that destroy what a full expression has made).
What is in a handler of exceptions counts: its lines have no other blocks.
"""

import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def main(root, build):
    lines = collections.defaultdict(dict)     # by file: by line: whether it is executed
    branches = collections.defaultdict(dict)  # by file: by line and number
    with tempfile.TemporaryDirectory() as folder:
        for data in build.rglob("*.gcda"):
            cleanup = branches_of_cleanup(gcov(data, folder, "--all-blocks"))
            for text in gcov(data, folder, "--json-format").splitlines():
                for file in json.loads(text)["files"]:
                    path = pathlib.Path(file["file"]).resolve()
                    if path.is_relative_to(root / "include") or path.is_relative_to(root / "examples/segment_mesh"):
                        add(file["lines"], lines[path.relative_to(root)], branches[path.relative_to(root)],
                            cleanup[file["file"]])
    for path in sorted(lines):
        print("%-80s %s" % (path, share(lines[path], branches[path])))
    for part in ("include", "examples"):
        of_part = [p for p in lines if p.parts[0] == part]
        if of_part:
            print("%s: %s" % (part, share({(p, k): v for p in of_part for k, v in lines[p].items()},
                                          {(p, k): v for p in of_part for k, v in branches[p].items()})))


def gcov(data, folder, form):
    command = ["gcov", form, "--branch-probabilities", "--branch-counts", "--stdout", str(data)]
    return subprocess.run(command, cwd=folder, capture_output=True, check=True, text=True, errors="replace").stdout


def branches_of_cleanup(listing):
    """By file and line: the places, among the line's branches, of those in blocks that only exceptions lead to, not executed, on
    lines that have other blocks. Of templates with several instances none."""
    result = collections.defaultdict(lambda: collections.defaultdict(set))
    file = number = None  # the line; none in an instance of a template
    for text in listing.splitlines():
        if text.startswith("branch"):
            if number and is_cleanup:
                result[file][number].add(place)
            place += 1
        elif text.startswith("-----"):
            number, place = None, 0
        elif match := re.match(r" *(\S+?): *(\d+)(?:-block +\d+|:(.*))$", text):
            count, at, source = match.groups()
            if source is not None and source.startswith("Source:"):
                file = source[len("Source:"):]
            elif source is not None:
                number, place, is_cleanup = (int(at) if count != "=====" else None), 0, False
            else:
                is_cleanup = count == "$$$$$"
    return result


def add(records, lines, branches, cleanup):
    for record in records:
        number = record["line_number"]
        lines[number] = lines.get(number, False) or record["count"] > 0
        for i, (place, is_taken) in enumerate(decisions(record["branches"])):
            if place not in cleanup[number]:
                branches[number, i] = branches.get((number, i), False) or is_taken


def decisions(branches):
    """The place of each and whether it is taken. Of a call that may throw, gcov gives the branch without exception, then that
    with one."""
    throws = [b["throw"] for b in branches] + [False]
    return [(i, b["count"] > 0) for i, b in enumerate(branches)
            if not throws[i] and not (b["fallthrough"] and throws[i + 1])]


def share(lines, branches):
    def percent(values):
        return 100 * sum(values) / len(values) if values else 100
    missing = sorted(k for k, v in lines.items() if not v and isinstance(k, int))
    return "%5.1f %% of %d lines, %5.1f %% of %d branches  %s" % (
        percent(lines.values()), len(lines), percent(branches.values()), len(branches), " ".join(map(str, missing[:20])))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
