#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the library, the program or the Python module at sites drawn by a seed and says which tests notice.

One build serves all: in a copy of the sources each site is `(::mutant(17) ? broken : original)`, and an environment variable
selects the mutant of a run. What can only change the running time (reserving, progress) is not broken, nor what the compiler
evaluates. Survivors that change no result are listed in equivalent.txt, with the reason.

    python3 test/mutation/mutate.py --work DIR [--of library|program|python] [--seed 1] [--sites 300] [--files PART...]
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Nothing of these is executed, or only to say what is wrong.
NOT_BROKEN = ("Superfacets/internal/learned_merge_model.h", "Support/parameters.h", "Support/version.h",
              "Support/exceptions.h")
# They affect time and progress alone.
TIME_ONLY = re.compile(r"reserve\(|\.advance\(|report|shrink_to_fit|madvise")
SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "&&": "||", "||": "&&",
         "+=": "-=", "-=": "+=", "min": "max", "max": "min", "true": "false", "false": "true", "|=": "&=", "&=": "|=",
         "min_element": "max_element", "max_element": "min_element", "floor": "ceil", "ceil": "floor"}
ASSIGNMENTS = ("=", "+=", "-=", "*=", "/=", "|=", "&=", "^=")
NO_STATEMENT = set("break continue throw using typedef static_assert case default delete try static constexpr goto public private "
                   "friend struct class enum template do if for while switch else static_cast CGAL_precondition "
                   "CGAL_precondition_msg CGAL_assertion CGAL_assertion_msg".split())
TOKEN = re.compile(r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
  |(?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  |(?P<number>(?:0x[0-9a-fA-F]+|\d+\.?\d*(?:e[+-]?\d+)?|\.\d+)[fuUlL]*)
  |(?P<name>[A-Za-z_]\w*)
  |(?P<op><<=|>>=|->|\+\+|--|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|\|=|&=|\^=|::|<<|.)""", re.X | re.S | re.M)
DECLARATION = re.compile(r"(const\s+)?(typename\s+)?[\w:]+(<[^;=]*>)?(::\w+)?(\s+const)?\s*([*&]+\s*|\s)(const\s+)?\w+\s*([;({=,]|$)")
DECLARED_CONDITION = re.compile(r"(const\s+)?[\w:<>]+(\s*[&*])?\s+\w+\s*=[^=]")

Token = collections.namedtuple("Token", "kind text start end")


class Site:
    """A piece of a file and what replaces it, where NUMBER becomes that of the mutant."""

    def __init__(self, file, line, start, end, original, broken, replacement):
        self.file, self.line, self.start, self.end = file, line, start, end
        self.original, self.broken, self.replacement = original, broken, replacement
        self.last_line = line + original.count("\n")
        self.key = str(file), " ".join(original.split()), " ".join(broken.split())


class Header:
    """The sites of a file: expressions in which one token is changed, and statements that are removed."""

    def __init__(self, file, text):
        self.file, self.text, self.sites = file, text, []
        self.tokens = [Token(m.lastgroup, m.group(), m.start(), m.end()) for m in TOKEN.finditer(text) if m.lastgroup != "skip"]
        self.words = [t.text for t in self.tokens]
        self.not_executed = self.find_constants()
        self.walk()

    def matching(self, i):
        """The index of the bracket that closes the one at i."""
        depth = 0
        for i in range(i, len(self.words)):
            depth += (self.words[i] in "([{") - (self.words[i] in ")]}")
            if depth == 0:
                break
        return i

    def outside_brackets(self, begin, end):
        """The indices of the tokens that are in no brackets of their own."""
        depth = 0
        for i in range(begin, end):
            if depth == 0:
                yield i
            depth += (self.words[i] in "([{") - (self.words[i] in ")]}")

    def find(self, characters, i):
        """The index of the first of some tokens from i on."""
        while self.words[i] not in characters and i + 1 < len(self.words):
            i += 1
        return i

    def end_of_constexpr(self, i):
        begin = self.find(";{(", i)
        if self.words[begin] == "(":
            begin = self.matching(begin)
            if self.words[i - 1] == "if":
                return begin
            begin = self.find(";{", begin)
        elif self.words[i - 1] == "if":
            return begin
        if self.words[begin] == "{":
            begin = self.matching(begin)
        return self.find(";}", begin)

    def find_constants(self):
        """The tokens of constant expressions, and of declarations of types."""
        result, i = set(), 0
        while i < len(self.words):
            word, end = self.words[i], None
            if word == "constexpr":
                end = self.end_of_constexpr(i)
            elif word == "enum":
                end = self.find(";", i)
            elif word in ("static_assert", "using", "case"):
                end = self.find((";", ":"), i)
            if end is not None:
                result.update(range(i, end + 1))
                i = end
            i += 1
        return result

    def walk(self):
        """Finds the statements of function bodies."""
        kinds = []  # of open braces: "scope", "code" or "value"
        begin = i = 0  # of a statement, and the token
        while i < len(self.words):
            word = self.words[i]
            if word == "{":
                kinds.append(self.kind_of_brace(begin, i, kinds))
                if kinds[-1] != "value":
                    begin = i + 1
            elif word == "}":
                if kinds and kinds.pop() != "value":
                    begin = i + 1
            elif word == ";":
                if kinds and kinds[-1] == "code":
                    self.add_statement(begin, i)
                begin = i + 1
            elif word in ("if", "for", "while", "switch", "catch") and "code" in kinds and self.words[i + 1] == "(":
                close = self.matching(i + 1)
                self.add_condition(word, i + 2, close)
                begin = i = close + 1
                continue
            elif word in ("else", "do"):
                begin = i + 1
            elif word == "(" and self.words[i - 1] == "constexpr":
                begin = self.matching(i) + 1
            i += 1

    def kind_of_brace(self, begin, i, kinds):
        words, previous, outer = set(self.words[begin:i]), self.tokens[i - 1], kinds[-1] if kinds else "scope"
        if outer == "scope" and words & {"namespace", "class", "struct", "union", "enum"} and \
                "(" not in self.words[max(begin, i - 2):i]:
            return "scope"
        if previous.text in (")", "const", "noexcept", "override", "else", "do", "try", "mutable", "]", "{", "}", ";"):
            return "code"
        if kinds and outer == "scope" and "(" in words and \
                ("->" in words or (":" in words and previous.text not in ",(=" and previous.kind != "name")):
            return "code"
        return "value"

    def text_of(self, begin, end):
        return self.text[self.tokens[begin].start:self.tokens[end - 1].end]

    def broken(self, i):
        """What a token becomes, or None."""
        t, before, after = self.tokens[i], self.text[self.tokens[i].start - 1], self.text[self.tokens[i].end]
        if t.text in SWAPS and (t.kind == "name" or (before.isspace() and after.isspace())):
            is_limit = t.text in ("min", "max") and (self.words[i + 1] != ")" or self.words[i + 2:i + 4] == ["(", ")"])
            return None if is_limit else SWAPS[t.text]
        if t.kind == "number" and "x" not in t.text:
            is_template_argument = self.words[i - 1] == "<" and not before.isspace()
            return None if is_template_argument else {"0": "1", "1": "2"}.get(t.text, "(2 * " + t.text + ")")
        return "" if t.text == "!" and self.words[i + 1] != "=" else None

    def add(self, begin, end, broken, replacement):
        original = self.text_of(begin, end)
        if not TIME_ONLY.search(original) and self.not_executed.isdisjoint(range(begin, end)):
            start = self.tokens[begin].start
            self.sites.append(Site(self.file, self.text.count("\n", 0, start) + 1, start, self.tokens[end - 1].end, original,
                                   broken, replacement))

    def add_expression(self, begin, end):
        if end <= begin or not {"{", "}"}.isdisjoint(self.words[begin:end]):
            return
        original = self.text_of(begin, end)
        for i in range(begin, end):
            change = self.broken(i)
            if change is not None:
                broken = self.text[self.tokens[begin].start:self.tokens[i].start] + change + \
                    self.text[self.tokens[i].end:self.tokens[end - 1].end]
                self.add(begin, end, broken, "(::mutant(NUMBER) ? (%s) : (%s))" % (broken, original))

    def add_condition(self, keyword, begin, end):
        semicolons = [i for i in self.outside_brackets(begin, end) if self.words[i] == ";"]
        if keyword == "for":
            if len(semicolons) == 2:
                self.add_expression(semicolons[0] + 1, semicolons[1])
        elif keyword in ("if", "while"):
            begin = semicolons[-1] + 1 if semicolons else begin
            if not DECLARED_CONDITION.match(self.text_of(begin, end)):
                self.add_expression(begin, end)

    def add_statement(self, begin, end):
        words = self.words[begin:end]
        if not words or not {"{", "}"}.isdisjoint(words) or words[0] in NO_STATEMENT:
            return
        if words[0] == "return":
            return self.add_expression(begin + 1, end)
        text, outside = self.text_of(begin, end), list(self.outside_brackets(begin, end))
        assignment = next((i for i in outside if self.words[i] in ASSIGNMENTS), None)
        has_commas = any(self.words[i] == "," for i in outside)
        if DECLARATION.match(text) or words[0] in ("const", "auto", "unsigned", "std"):
            if assignment and not has_commas and "&" not in self.words[begin:assignment] and words[0] != "std":
                self.add_expression(assignment + 1, end)
            return
        if assignment:
            self.add_expression(assignment + 1, end)
            operator = self.tokens[assignment]
            if operator.text in SWAPS and not has_commas:
                broken = self.text[self.tokens[begin].start:operator.start] + SWAPS[operator.text] + \
                    self.text[operator.end:self.tokens[end - 1].end]
                self.add(begin, end + 1, broken, "{ if (::mutant(NUMBER)) %s; else %s; }" % (broken, text))
        if assignment or "(" in words or words[0] in ("++", "--"):
            self.add(begin, end + 1, "(removed)", "{ if (!::mutant(NUMBER)) { %s; } }" % text)


def draw(headers, number, seed):
    """Sites that do not overlap, at most one a statement."""
    everything = [s for h in headers for s in h.sites]
    random.Random(seed).shuffle(everything)
    drawn, taken = [], collections.defaultdict(list)
    for site in everything:
        if len(drawn) < number and all(site.end <= a or b <= site.start for a, b in taken[site.file]):
            taken[site.file].append((site.start, site.end))
            drawn.append(site)
    return len(everything), drawn


def write(folder, headers, sites):
    """Writes the headers that have changed."""
    for header in headers:
        text = header.text
        for site in sorted((s for s in sites if s.file == header.file), key=lambda s: -s.start):
            text = text[:site.start] + site.replacement.replace("NUMBER", str(site.number)) + text[site.end:]
        if (folder / header.file).read_text() != text:
            (folder / header.file).write_text(text)


def sites_in_lines_with_errors(messages, sites):
    def places(pattern):
        for file, line in re.findall(r"([\w/.]+?):(\d+):\d+:" + pattern, messages, re.M):
            yield int(line), [s for s in sites if ("/" + file).endswith("/" + str(s.file))]

    for pattern in " error", "":  # if the errors are elsewhere, what leads there is a site
        found = {s for line, there in places(pattern) for s in there if s.line <= line <= s.last_line}
        if found:
            return found
    # What a declaration lacks shows further down.
    above = [[s for s in there if s.line <= line] for line, there in places(" error")]
    return {max(some, key=lambda s: s.line) for some in above if some} or sys.exit(
        "does not compile: " + "\n".join(sorted(messages.splitlines(), key=lambda line: " error" not in line))[:3000])


MUTANT_H = """#pragma once
#include <cstdlib>
inline bool mutant(int number)
{
  static const int active = std::getenv("MUTANT") ? std::atoi(std::getenv("MUTANT")) : 0;
  return number == active;
}
"""


class Library:
    """What is broken: the library, whose tests are compiled here in units of up to nine files (see test/CMakeLists.txt). The
    others have the same members."""

    folder = "include/CGAL/Region_segmentation"
    # They need other flags or libraries.
    not_run = {"mesh_types_test.cpp", "segments_mesh_types_test.cpp", "parallel_test.cpp", "debug_checks_test.cpp"}

    def __init__(self, work, jobs):
        self.work, self.jobs, self.program = work, jobs, work / "tests"
        listed = (ROOT / "test/CMakeLists.txt").read_text().split("if(NOT REGION_SEGMENTATION_ALL_TESTS)")[0]
        tests = sorted(set(re.findall(r"[\w/]+_test\.cpp", listed)) - self.not_run) + ["meshes.cpp", "oracles.cpp"]
        number = -(-len(tests) // 9)
        self.units = [work / ("unit_%d.cpp" % i) for i in range(number)]
        for i, unit in enumerate(self.units):
            unit.write_text("".join('#include "%s"\n' % (ROOT / "test" / name) for name in tests[i::number]))
            unit.with_suffix(".o").unlink(missing_ok=True)

    def compile_unit(self, unit):
        command = [os.environ.get("CXX", "g++"), "-std=c++17", "-O1", "-w", "-fmax-errors=200", "-DTEST_EIGEN", "-I",
                   self.work / "copy/include", "-I", ROOT / "test", "-I", "/usr/include/eigen3", "-include",
                   self.work / "mutant.h", "-c", unit, "-o", unit.with_suffix(".o")]
        if unit.with_suffix(".o").exists():
            return ""
        result = subprocess.run(command, capture_output=True, text=True)
        return result.stderr if result.returncode else ""  # GCC has notes on the ABI even with -w

    def compile(self):
        """The messages of each unit that does not compile; all is linked if there are none."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            errors = [text for text in pool.map(self.compile_unit, self.units) if text]
        if not errors:
            subprocess.run(["g++", *(u.with_suffix(".o") for u in self.units), "-o", self.program, "-lgtest", "-lgtest_main",
                            "-lrapidcheck", "-lgmp", "-lmpfr", "-lpthread"], check=True)
        return errors

    def run(self, number, tests, seconds):
        """How the tests of a filter of GoogleTest end: the output, and the first that fails, or another end, or None."""
        return run([self.program, "--gtest_fail_fast", "--gtest_filter=" + tests], self.work, number, seconds,
                   r"\[  FAILED  \] ([^,\s]+)")

    def groups(self):
        """The tests in groups with a bound of time for each, which doubles: most mutants are noticed in less than a second."""
        output, failed = self.run(0, "-*Real_meshes*", 3600)
        if failed:
            sys.exit("the tests fail without a mutant: " + failed)
        times = re.findall(r"^\[       OK \] ([^,\s]+).*\((\d+) ms\)$", output, re.M)
        groups, seconds = [[[], 0]], 0.3
        for time, name in sorted((int(ms) / 1000, name) for name, ms in times):
            if groups[-1][1] > seconds:
                groups.append([[], 0])
                seconds *= 2
            groups[-1][0].append(name)
            groups[-1][1] += time
        return [(":".join(names), 20 + 6 * total) for names, total in groups]


class Program(Library):
    folder = "examples/segment_mesh"
    transcripts = "^transcript\\."

    def __init__(self, work, jobs):
        self.work, self.jobs, self.program = work, jobs, work / "build/bin/program_test"

    def compile(self):
        flags = "-O1 -w -fmax-errors=200 -include %s" % (self.work / "mutant.h")
        subprocess.run(["cmake", "-S", self.work / "copy", "-B", self.work / "build", "-DCMAKE_BUILD_TYPE=None",
                        "-DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF", "-DCMAKE_CXX_FLAGS=" + flags],
                       check=True, stdout=subprocess.DEVNULL)
        result = subprocess.run(["cmake", "--build", self.work / "build", "-j", str(self.jobs), "--target", "program_test",
                                 "segment_mesh", "--", "-k"], capture_output=True, text=True)
        return [result.stderr] if result.returncode else []

    def run(self, number, tests, seconds):
        if tests != self.transcripts:
            return super().run(number, tests, seconds)
        return run(["ctest", "--test-dir", self.work / "build", "--stop-on-failure", "-R", tests], self.work, number, seconds,
                   r"Test +#\d+: (\S+) .*\*\*\*")

    def groups(self):
        if self.run(0, self.transcripts, 3600)[1]:
            sys.exit("the transcripts differ without a mutant")
        return [*super().groups(), (self.transcripts, 600)]


class Python(Library):
    folder = "examples/python"

    def __init__(self, work, jobs):
        self.work = work

    def compile(self):
        flags = "-O1 -g0 -w -fmax-errors=200 -include %s" % (self.work / "mutant.h")
        result = subprocess.run([sys.executable, "setup.py", "build", "--build-lib", self.work / "module"], capture_output=True,
                                cwd=self.work / "copy" / self.folder, text=True, env=dict(os.environ, CFLAGS=flags))
        return [result.stderr] if result.returncode else []

    def run(self, number, tests, seconds):
        # The package is not installed.
        return run([sys.executable, "-m", "pytest", "-x", "-q", "-k", "not test_package", "-p", "no:cacheprovider", tests], self.work,
                   number, seconds, r"FAILED \S*?::(\S+)")

    def groups(self):
        return [(str(ROOT / "test/python"), 600)]


def run(command, work, number, seconds, failure):
    environment = dict(os.environ, MUTANT=str(number), PYTHONPATH=str(work / "module"), RC_PARAMS="seed=1 noshrink=1")
    try:
        result = subprocess.run(command, capture_output=True, text=True, errors="replace", env=environment,
                                timeout=seconds, cwd=work)
    except subprocess.TimeoutExpired:
        return "", "(no end)"
    failed = re.search(failure, result.stdout)
    return result.stdout, None if result.returncode == 0 else failed.group(1) if failed else "(ends with %d)" % result.returncode


def draw_sites(folder, options):
    headers = []
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.suffix in (".h", ".cpp") and name.startswith(tuple(options.files)) and not name.startswith(NOT_BROKEN):
            headers.append(Header(pathlib.PurePath(name), path.read_text()))
    possible, sites = draw(headers, options.sites, options.seed)
    for number, site in enumerate(sites, 1):
        site.number = number
    print("seed %d: %d of %d possible sites" % (options.seed, len(sites), possible), flush=True)
    return headers, sites


def compile_sites(subject, headers, sites):
    """Those of the sites that compile."""
    while True:
        write(subject.work / "copy" / subject.folder, headers, sites)
        errors = subject.compile()
        if not errors:
            return sites
        bad = set().union(*(sites_in_lines_with_errors(messages, sites) for messages in errors))
        print("%d sites do not compile and are left out" % len(bad), flush=True)
        sites = [s for s in sites if s not in bad]


def find_survivors(subject, sites, jobs):
    groups, survivors = subject.groups(), []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        def result_of(site):
            ends = (subject.run(site.number, tests, seconds)[1] for tests, seconds in groups)
            return site, next((end for end in ends if end), None)

        for site, failed in pool.map(result_of, sites):
            print("%3d %-60s %s" % (site.number, "%s:%d" % (site.file, site.line), failed or "SURVIVES"), flush=True)
            if failed is None:
                survivors.append(site)
    return survivors


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder of the copy and the build")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sites", type=int, default=300)
    parser.add_argument("--of", choices=("library", "program", "python"), default="library")
    parser.add_argument("--files", nargs="*", default=[""], help="beginnings of paths in the folder of what is broken")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--at-least", type=float, default=0,
                        help="percent to be noticed of those that are not equivalent, else the exit status is 1")
    options = parser.parse_args()
    work = options.work.resolve()
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    shutil.rmtree(work / "copy", ignore_errors=True)
    for name in subprocess.check_output(["git", "ls-files"], cwd=ROOT, text=True).splitlines():
        (work / "copy" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, work / "copy" / name)
    (work / "mutant.h").write_text(MUTANT_H)

    subject = {"library": Library, "program": Program, "python": Python}[options.of](work, options.jobs)
    headers, sites = draw_sites(ROOT / subject.folder, options)
    sites = compile_sites(subject, headers, sites)
    survivors = find_survivors(subject, sites, options.jobs)

    text = (pathlib.Path(__file__).parent / "equivalent.txt").read_text()
    blocks = [[line.strip() for line in block.splitlines() if not line.startswith("#")] for block in text.split("\n\n")]
    reasons = {tuple(block[:3]): block[3] for block in blocks if len(block) == 4}
    print("\nSurvivors:")
    for site in survivors:
        print("%3d %s:%d\n      %s\n   -> %s" % (site.number, site.file, site.line, *site.key[1:]))
        print("      " + reasons.get(site.key, "A HOLE IN THE TESTS"))
    noticed, equivalent = len(sites) - len(survivors), sum(s.key in reasons for s in survivors)
    percent = 100 * noticed / (len(sites) - equivalent)
    print("\nseed %d: %d of %d noticed, %.1f %%; %d that survive are equivalent, of the others %.1f %% noticed" %
          (options.seed, noticed, len(sites), 100 * noticed / len(sites), equivalent, percent))
    return 0 if percent >= options.at_least else 1


if __name__ == "__main__":
    sys.exit(main())
