#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""coverage.py ROOT BUILD: sums what gcov says of the headers of the library and the sources of the program.

A line or branch of a template counts as executed if one of its instances executes it. Both branches of a call that may
throw are left out: they are no decision of the source.
"""

import collections
import json
import pathlib
import subprocess
import sys
import tempfile


def main(root, build):
    lines = collections.defaultdict(dict)     # by file: by line: whether it is executed
    branches = collections.defaultdict(dict)  # by file: by line and number
    with tempfile.TemporaryDirectory() as folder:
        for data in build.rglob("*.gcda"):
            output = subprocess.run(["gcov", "--json-format", "--branch-probabilities", "--stdout", str(data)], cwd=folder,
                                    capture_output=True, check=True).stdout
            for text in output.splitlines():
                for file in json.loads(text)["files"]:
                    path = pathlib.Path(file["file"]).resolve()
                    if path.is_relative_to(root / "include") or path.is_relative_to(root / "examples/segment_mesh"):
                        add(file["lines"], lines[path.relative_to(root)], branches[path.relative_to(root)])
    for path in sorted(lines):
        print("%-80s %s" % (path, share(lines[path], branches[path])))
    for part in ("include", "examples"):
        of_part = [p for p in lines if p.parts[0] == part]
        if of_part:
            print("%s: %s" % (part, share({(p, k): v for p in of_part for k, v in lines[p].items()},
                                          {(p, k): v for p in of_part for k, v in branches[p].items()})))


def add(records, lines, branches):
    for record in records:
        number = record["line_number"]
        lines[number] = lines.get(number, False) or record["count"] > 0
        for i, is_taken in enumerate(decisions(record["branches"])):
            branches[number, i] = branches.get((number, i), False) or is_taken


def decisions(branches):
    """Whether each is taken. Of a call that may throw, gcov gives the branch without exception, then that with one."""
    throws = [b["throw"] for b in branches] + [False]
    return [b["count"] > 0 for i, b in enumerate(branches) if not throws[i] and not (b["fallthrough"] and throws[i + 1])]


def share(lines, branches):
    def percent(values):
        return 100 * sum(values) / len(values) if values else 100
    missing = sorted(k for k, v in lines.items() if not v and isinstance(k, int))
    return "%5.1f %% of %d lines, %5.1f %% of %d branches  %s" % (
        percent(lines.values()), len(lines), percent(branches.values()), len(branches), " ".join(map(str, missing[:20])))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
