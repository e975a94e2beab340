#!/usr/bin/env python3
"""transcripts.py PROGRAM TRANSCRIPT...: runs the commands of each transcript, and compares what they print with what it states.

In a transcript a line `  $ COMMAND` is a command of the shell, continued by lines `  > MORE`. The indented lines after it are its
output: that on stdout, that on stderr after `2> `, and the exit status in brackets if it is not 0. Other lines are comments. The
commands run in one shell, in a new folder with a copy of the files beside the transcript, where `segment_mesh` is PROGRAM. Times
are compared as 0.000 s. If the shell ends with status 77, the test is skipped. With RECORD=1 in the environment the output is
written into the transcript: RECORD=1 ctest -R transcript; the difference is read in review."""

import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

END, SKIPPED = "<end of a command>", 77


def run(program, commands, folder):
    """The shell's exit status, and the lines of output of each command that ended."""
    (folder / "bin").mkdir()
    (folder / "bin/segment_mesh").symlink_to(program)
    (folder / "script").write_text("".join(f"{command}\necho '{END}'$?; echo '{END}' >&2\n" for command in commands))
    environment = dict(os.environ, PATH=f"{folder}/bin:{os.environ['PATH']}", LC_ALL="C", TMP=str(folder))
    with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
        status = subprocess.run(["sh", "../script"], cwd=folder / "work", env=environment, stdin=subprocess.DEVNULL,
                                stdout=out, stderr=err, timeout=600).returncode
    out, err = ((folder / name).read_text(encoding="utf-8", errors="backslashreplace") for name in ("out", "err"))
    results = []
    for (text, code), errors in zip(re.findall(f"(.*?){END}(\\d+)\n", out, re.S), err.split(END + "\n")):
        lines = text.splitlines() + [f"2> {line}" for line in errors.splitlines()] + ([f"[{code}]"] if code != "0" else [])
        results.append([re.sub(r"\b\d+\.\d{3} s$", "0.000 s", line) for line in lines])
    return status, results


def check(program, transcript):
    """The exit status of the test."""
    before = transcript.read_text().splitlines()
    lines = [line for line in before if not line.startswith("  ") or line.startswith(("  $ ", "  > "))]
    starts = [i for i, line in enumerate(lines) if line.startswith("  $ ")]
    ends = [next((j for j in range(i + 1, len(lines)) if not lines[j].startswith("  > ")), len(lines)) for i in starts]
    commands = ["\n".join(line[4:] for line in lines[i:j]) for i, j in zip(starts, ends)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(transcript.parent, folder / "work", ignore=shutil.ignore_patterns("*.txt"))
        status, results = run(program, commands, folder)
    if status == SKIPPED:
        print(f"{transcript}: skipped", *results[-1:])
        return SKIPPED
    for end, result in reversed(list(zip(ends, results))):
        lines[end:end] = [f"  {line}" for line in result]
    if lines != before and "RECORD" in os.environ:
        transcript.write_text("\n".join(lines) + "\n")
    difference = list(difflib.unified_diff(before, lines, str(transcript), "what the program prints", lineterm=""))
    print("\n".join(difference))
    return 1 if difference and "RECORD" not in os.environ or status else 0


if __name__ == "__main__":
    outcomes = [check(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(name)) for name in sys.argv[2:]]
    sys.exit(1 if 1 in outcomes else max(outcomes))
