#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the library, the program or the Python module at sites drawn by a seed and says which tests notice.

One build serves all: in a copy of the sources each site is `(::mutant(17) ? broken : original)`, and an environment variable
selects the mutant of a run. What can only change the running time (reserving, progress) is not broken, nor
what the compiler evaluates. Survivors that change no result are listed in equivalent.txt, with the reason. What was
compiled and run is kept in DIR: a run that was stopped continues there, as long as neither what is broken nor the tests
change. Beside its own headers, what is broken is not: the program is tested with the library as it is.

    python3 test/mutation/mutate.py --work DIR [--of library|program|python] [--seed 1] [--sites 300] [--files PART...] [--tests FILE...] [--jobs 2]
"""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import random
import re
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
CONTROL = ("if", "for", "while", "switch", "catch")
NO_STATEMENT = ("break", "continue", "throw", "using", "typedef", "static_assert", "case", "default", "delete", "try",
                "static", "constexpr", "goto", "public", "private", "friend", "struct", "class", "enum", "template", "do",
                "if", "for", "while", "switch", "else", "static_cast", "CGAL_precondition", "CGAL_precondition_msg",
                "CGAL_assertion", "CGAL_assertion_msg")

TOKEN = re.compile(r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
  |(?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  |(?P<number>(?:0x[0-9a-fA-F]+|\d+\.?\d*(?:e[+-]?\d+)?|\.\d+)[fuUlL]*)
  |(?P<name>[A-Za-z_]\w*)
  |(?P<op><<=|>>=|->|\+\+|--|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|\|=|&=|\^=|::|<<|.)""", re.X | re.S | re.M)


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


def tokens_of(text):
    return [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(text) if m.lastgroup != "skip"]


def matching(tokens, i, step=1):
    """The index of the bracket that closes (or opens) the one at i."""
    depth = 0
    while 0 <= i < len(tokens):
        depth += (tokens[i].text in "([{") - (tokens[i].text in ")]}")
        if depth == 0:
            return i
        i += step
    return i - step


class Site:
    """A piece of a file and what replaces it; `%d` in it becomes the number of the mutant."""

    def __init__(self, file, line, start, end, original, broken, replacement):
        self.file, self.line, self.start, self.end = file, line, start, end
        self.original, self.broken, self.replacement = original, broken, replacement
        self.last_line = line + original.count("\n")


class Header:
    def __init__(self, file, text):
        self.file, self.text, self.tokens, self.sites = file, text, tokens_of(text), []
        self.not_executed = self.find_constants()
        self.walk()

    def find_constants(self):
        """Of tokens of constant expressions, and of declarations of templates."""
        result, i = set(), 0
        while i < len(self.tokens):
            end = None
            word = self.tokens[i].text
            if word == "constexpr":
                j = i
                while self.tokens[j].text not in ";{(" and j + 1 < len(self.tokens):
                    j += 1
                is_condition = self.tokens[i - 1].text == "if"
                if self.tokens[j].text == "(":
                    j = matching(self.tokens, j)
                    while not is_condition and self.tokens[j].text not in ";{":
                        j += 1
                if self.tokens[j].text == "{" and not is_condition:
                    j = matching(self.tokens, j)
                while not is_condition and self.tokens[j].text not in ";}":
                    j += 1
                end = j
            elif word in ("static_assert", "using", "enum", "case"):
                end = next((j for j in range(i, len(self.tokens)) if self.tokens[j].text in (";", ":")), i)
                if word == "enum":
                    end = next(j for j in range(i, len(self.tokens)) if self.tokens[j].text == ";")
            if end is None:
                i += 1
            else:
                result.update(range(i, end + 1))
                i = end + 1
        return result

    def walk(self):
        """Finds the statements of function bodies."""
        kinds = []  # of open braces: "scope", "code" or "value"
        begin = 0   # of a statement
        i = 0
        while i < len(self.tokens):
            text = self.tokens[i].text
            if text == "{":
                kinds.append(self.kind_of_brace(begin, i, kinds))
                if kinds[-1] != "value":
                    begin = i + 1
            elif text == "}":
                if kinds and kinds.pop() != "value":
                    begin = i + 1
            elif text == ";":
                if kinds and kinds[-1] == "code":
                    self.add_statement(begin, i)
                begin = i + 1
            elif text in CONTROL and kinds and "code" in kinds and self.tokens[i + 1].text == "(":
                close = matching(self.tokens, i + 1)
                self.add_condition(text, i + 2, close)
                begin = i = close + 1
                continue
            elif text in ("else", "do") or (text == "(" and self.tokens[i - 1].text == "constexpr"):
                begin = i + 1 if text != "(" else matching(self.tokens, i) + 1
            i += 1

    def kind_of_brace(self, begin, i, kinds):
        before = self.tokens[begin:i]
        words = {t.text for t in before}
        previous = self.tokens[i - 1].text
        if words & {"namespace", "class", "struct", "union", "enum"} and "(" not in {t.text for t in before[-2:]}:
            if not kinds or kinds[-1] == "scope":
                return "scope"
        if previous in (")", "const", "noexcept", "override", "else", "do", "try", "mutable", "]") or \
                previous in ("{", "}", ";"):
            return "code"
        if ("->" in words or ":" in words) and kinds and kinds[-1] == "scope" and "(" in words:
            return "code" if previous not in (",", "(", "=") and self.tokens[i - 1].kind != "name" or "->" in words \
                else "value"
        return "value"

    def text_of(self, begin, end):
        return self.text[self.tokens[begin].start:self.tokens[end - 1].end]

    def broken_expressions(self, begin, end):
        """Texts of an expression in which one token is changed."""
        for i in range(begin, end):
            t, change = self.tokens[i], None
            is_spaced = self.text[t.start - 1:t.start].isspace() and self.text[t.end:t.end + 1].isspace()
            if t.text in SWAPS and (t.kind == "name" or is_spaced):
                if t.text in ("min", "max") and self.tokens[i + 1].text != ")":
                    continue  # of numeric_limits
                if t.text in ("min", "max") and self.tokens[i + 2].text == "(" and self.tokens[i + 3].text == ")":
                    continue
                change = SWAPS[t.text]
            elif t.kind == "number" and "x" not in t.text:
                if self.tokens[i - 1].text == "<" and not self.text[t.start - 1].isspace():
                    continue  # the argument of a template
                change = {"0": "1", "1": "2"}.get(t.text, "(2 * " + t.text + ")")
            elif t.text == "!" and self.tokens[i + 1].text != "=":
                change = ""
            if change is not None:
                yield self.text[self.tokens[begin].start:t.start] + change + self.text[t.end:self.tokens[end - 1].end]

    def add(self, begin, end, broken, replacement):
        if end <= begin or any(i in self.not_executed for i in range(begin, end)):
            return
        original = self.text_of(begin, end)
        if TIME_ONLY.search(original):
            return
        start = self.tokens[begin].start
        line = self.text.count("\n", 0, start) + 1
        self.sites.append(Site(self.file, line, start, self.tokens[end - 1].end, original, broken, replacement))

    def add_expression(self, begin, end):
        if end <= begin or any(self.tokens[i].text in "{}" for i in range(begin, end)) or self.tokens[begin].text == "{":
            return
        original = self.text_of(begin, end)
        for broken in self.broken_expressions(begin, end):
            self.add(begin, end, broken, "(::mutant(%%d) ? (%s) : (%s))" % (broken.replace("%", "%%"),
                                                                            original.replace("%", "%%")))

    def add_condition(self, keyword, begin, end):
        if keyword not in ("if", "while", "for") or end <= begin:
            return
        semicolons = [i for i in range(begin, end) if self.tokens[i].text == ";"
                      and matching_depth(self.tokens, begin, i) == 0]
        if keyword == "for":
            if len(semicolons) == 2:
                self.add_expression(semicolons[0] + 1, semicolons[1])
            return
        if semicolons:
            begin = semicolons[-1] + 1
        if re.match(r"(const\s+)?[\w:<>]+(\s*[&*])?\s+\w+\s*=[^=]", self.text_of(begin, end)):
            return  # a declaration
        self.add_expression(begin, end)

    def add_statement(self, begin, end):
        if end <= begin or any(self.tokens[i].text in "{}" for i in range(begin, end)):
            return
        words = [t.text for t in self.tokens[begin:end]]
        if words[0] == "return":
            return self.add_expression(begin + 1, end)
        if words[0] in NO_STATEMENT:
            return
        text = self.text_of(begin, end)
        depth = [matching_depth(self.tokens, begin, i) for i in range(begin, end)]
        assignments = [begin + k for k, w in enumerate(words) if w in ASSIGNMENTS and depth[k] == 0]
        commas = [k for k, w in enumerate(words) if w == "," and depth[k] == 0]
        declaration = re.match(r"(const\s+)?(typename\s+)?[\w:]+(<[^;=]*>)?(::\w+)?(\s+const)?\s*([*&]+\s*|\s)(const\s+)?\w+\s*([;({=,]|$)", text)
        if declaration or words[0] in ("const", "auto", "unsigned", "std"):
            is_reference = "&" in words[:assignments[0] - begin] if assignments else True
            if assignments and not commas and not is_reference and words[0] != "std":
                self.add_expression(assignments[0] + 1, end)
            return
        if assignments:
            self.add_expression(assignments[0] + 1, end)
            operator = self.tokens[assignments[0]]
            if operator.text in SWAPS and not commas:
                broken = self.text[self.tokens[begin].start:operator.start] + SWAPS[operator.text] + \
                    self.text[operator.end:self.tokens[end - 1].end]
                self.add(begin, end + 1, broken, "{ if (::mutant(%%d)) %s; else %s; }" %
                         (broken.replace("%", "%%"), text.replace("%", "%%")))
        if assignments or "(" in words or words[0] in ("++", "--"):
            self.add(begin, end + 1, "(removed)", "{ if (!::mutant(%%d)) { %s; } }" % text.replace("%", "%%"))


def matching_depth(tokens, begin, i):
    depth = 0
    for t in tokens[begin:i]:
        depth += (t.text in "([{") - (t.text in ")]}")
    return depth


def equivalent_mutants():
    """Why some mutants cannot be noticed, by file, original and replacement: blocks of four lines."""
    text = (pathlib.Path(__file__).parent / "equivalent.txt").read_text()
    blocks = [[line.strip() for line in block.splitlines() if not line.startswith("#")] for block in text.split("\n\n")]
    return {tuple(block[:3]): block[3] for block in blocks if len(block) == 4}


def one_line(text):
    return " ".join(text.split())


def draw(headers, number, seed):
    """Sites that do not overlap, at most one a statement."""
    everything = [s for h in headers for s in h.sites]
    random.Random(seed).shuffle(everything)
    drawn, taken = [], {}
    for site in everything:
        spans = taken.setdefault(site.file, [])
        if len(drawn) < number and all(site.end <= a or b <= site.start for a, b in spans):
            spans.append((site.start, site.end))
            drawn.append(site)
    return len(everything), drawn


def write(folder, headers, sites):
    for header in headers:
        text = header.text
        mine = sorted((s for s in sites if s.file == header.file), key=lambda s: -s.start)
        for site in mine:
            text = text[:site.start] + site.replacement % site.number + text[site.end:]
        if (folder / header.file).read_text() != text:
            (folder / header.file).write_text(text)


MUTANT_H = """#pragma once
#include <cstdlib>
inline bool mutant(int number)
{
  static const int active = std::getenv("MUTANT") ? std::atoi(std::getenv("MUTANT")) : 0;
  return number == active;
}
"""


class Library:
    """What is broken: the library, all whose tests are compiled here. Each of the others has the same members."""

    folder = pathlib.PurePath("include/CGAL/Region_segmentation")
    test_files = ("*.h", "*.cpp", "recorded_labels/*")

    def __init__(self, options):
        self.options = options
        names = options.tests or self.test_names()
        self.tests = [ROOT / "test" / name for name in names + ["meshes.cpp", "oracles.cpp"]]

    @staticmethod
    def test_names():
        """The files of the test programs of methods and of segments, and of what needs Eigen."""
        text = (ROOT / "test/CMakeLists.txt").read_text()
        return [name for start in (r"list\(APPEND optional_tests", r"add_executable\(region_segmentation_tests",
                                   r"add_executable\(region_segmentation_segments_test")
                for name in re.findall(r"[\w/]+_test\.cpp", re.search(start + r"(.*?)\)", text, re.S).group(1))]

    def sources(self):
        """Translation units of up to nine files, which instantiate the same templates (see test/CMakeLists.txt)."""
        number = -(-len(self.tests) // 9)
        sources = [self.options.work / ("unit_%d.cpp" % i) for i in range(number)]
        for i, source in enumerate(sources):
            source.write_text("".join('#include "%s"\n' % path for path in self.tests[i::number]))
        return sources

    def compile(self):
        """The messages of each unit that does not compile; all is linked if there are none."""
        work = self.options.work
        compiler = [os.environ.get("CXX", "g++"), "-std=c++17", "-O1", "-w", "-fmax-errors=200", "-DTEST_EIGEN", "-I",
                    str(work / "copy/include"), "-I", str(ROOT / "test"), "-I", "/usr/include/eigen3", "-include",
                    str(work / "mutant.h")]

        def compile_one(source):
            target = source.with_suffix(".o")
            if target.exists():
                return ""
            part = target.with_suffix(".part")
            result = subprocess.run(compiler + ["-c", str(source), "-o", str(part)], capture_output=True, text=True)
            if result.returncode == 0:
                part.rename(target)
                return ""
            return result.stderr

        sources = self.sources()
        with concurrent.futures.ThreadPoolExecutor(self.options.compile_jobs) as pool:
            errors = [text for text in pool.map(compile_one, sources) if text]
        if not errors:
            subprocess.run(["g++", *(str(s.with_suffix(".o")) for s in sources), "-o", str(work / "tests"), "-lgtest",
                            "-lgtest_main", "-lrapidcheck", "-lgmp", "-lmpfr", "-lpthread"], check=True)
        return errors

    def test_program(self):
        return self.options.work / "tests"

    def run(self, number, tests, seconds):
        """How the tests of a filter of GoogleTest end: the output, and the first that fails, or another end, or None."""
        command = [str(self.test_program()), "--gtest_fail_fast", "--gtest_filter=" + tests]
        return run(self.options, command, number, seconds, r"\[  FAILED  \] ([^,\s]+)")

    def groups(self):
        """The tests in groups with a bound of time for each, which doubles: most mutants are noticed in less than a second."""
        output, failed = self.run(0, self.options.filter, 3600)
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
    folder = pathlib.PurePath("examples/segment_mesh")
    test_files = ("program/*",)

    def compile(self):
        build = self.options.work / "build"
        subprocess.run(["cmake", "-S", str(self.options.work / "copy"), "-B", str(build), "-DCMAKE_BUILD_TYPE=None",
                        "-DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF",
                        "-DCMAKE_CXX_FLAGS=-O1 -w -fmax-errors=200 -include %s" % (self.options.work / "mutant.h")],
                       check=True, stdout=subprocess.DEVNULL)
        result = subprocess.run(["cmake", "--build", str(build), "-j", str(self.options.compile_jobs), "--target",
                                 "program_test", "--", "-k"], capture_output=True, text=True)
        return [result.stderr] if result.returncode else []

    def test_program(self):
        return self.options.work / "build/bin/program_test"


class Python(Library):
    folder = pathlib.PurePath("examples/python")
    test_files = ("python/*",)

    def compile(self):
        flags = "-O1 -g0 -w -fmax-errors=200 -include %s" % (self.options.work / "mutant.h")
        result = subprocess.run([sys.executable, "setup.py", "build", "--build-lib", str(self.options.work / "module")],
                                cwd=self.options.work / "copy" / self.folder, capture_output=True, text=True,
                                env=dict(os.environ, CFLAGS=flags))
        return [result.stderr] if result.returncode else []

    def run(self, number, tests, seconds):
        # The package is not installed.
        command = [sys.executable, "-m", "pytest", "-x", "-q", "-k", "not test_package", "-p", "no:cacheprovider", tests]
        return run(self.options, command, number, seconds, r"FAILED \S*?::(\S+)", str(self.options.work / "module"))

    def groups(self):
        tests = str(ROOT / "test/python")
        if self.run(0, tests, 3600)[1]:
            sys.exit("the tests fail without a mutant")
        return [(tests, 600)]


def sites_in_lines_with_errors(messages, sites):
    def at(pattern):
        found = set()
        for file, line in re.findall(r"([\w/.]+?):(\d+):\d+:" + pattern, messages, re.M):
            found |= {s for s in sites if ("/" + file).endswith("/" + str(s.file)) and s.line <= int(line) <= s.last_line}
        return found

    found = at(" error") or at("")  # if the errors are elsewhere, what leads there is a site
    if not found:  # what a declaration lacks shows further down
        for file, line in re.findall(r"([\w/.]+?):(\d+):\d+: error", messages):
            above = [s for s in sites if ("/" + file).endswith("/" + str(s.file)) and s.line <= int(line)]
            found |= {max(above, key=lambda s: s.line)} if above else set()
    if not found:
        sys.exit("does not compile: " + messages[:3000])
    return found


class Record:
    """What is known of the mutants, in a file: the test that noticed each, or nothing; `not compiled` for some."""

    NOT_COMPILED = "(not compiled)"

    def __init__(self, options, key):
        self.file = options.work / "record.txt"
        self.results = {}
        lines = self.file.read_text().splitlines() if self.file.exists() else []
        if lines[:1] == [key]:
            for line in lines[1:]:
                number, _, result = line.partition(" ")
                self.results[int(number)] = result or None
        else:
            self.file.write_text(key + "\n")
            for old in options.work.glob("*.o"):
                old.unlink()
            shutil.rmtree(options.work / "copy", ignore_errors=True)

    def add(self, site, result):
        self.results[site.number] = result
        with self.file.open("a") as out:
            out.write("%d %s\n" % (site.number, result or ""))


def key_of(options, subject):
    """Of all that the results depend on."""
    digest = hashlib.sha256(repr((options.of, options.seed, options.sites, options.files, options.filter)).encode())
    tests = [path for pattern in subject.test_files for path in (ROOT / "test").glob(pattern) if path.is_file()]
    for path in sorted([*(ROOT / "include").rglob("*.h"), *(p for p in (ROOT / subject.folder).rglob("*.*")), *tests,
                        pathlib.Path(__file__)]):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def run(options, command, number, seconds, failure, python_path=""):
    environment = dict(os.environ, MUTANT=str(number), PYTHONPATH=python_path)
    try:
        result = subprocess.run(command, capture_output=True, text=True, errors="replace", env=environment,
                                timeout=seconds, cwd=options.work)
    except subprocess.TimeoutExpired:
        return "", "(no end)"
    if result.returncode == 0:
        return result.stdout, None
    failed = re.search(failure, result.stdout)
    return result.stdout, failed.group(1) if failed else "(ends with %d)" % result.returncode


def limit_memory():
    import resource
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder of the copy, the build and the list")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--sites", type=int, default=300)
    parser.add_argument("--of", choices=("library", "program", "python"), default="library")
    parser.add_argument("--files", nargs="*", default=[""], help="beginnings of paths in the folder of what is broken")
    parser.add_argument("--tests", nargs="*", default=[], help="of the library, files of test/; if none, all of headers")
    parser.add_argument("--filter", default="-*Real_meshes*", help="of GoogleTest")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--at-least", type=float, default=0, help="percent to be noticed of those that are not equivalent, else the exit status is 1")
    parser.add_argument("--compile-jobs", type=int, default=2)
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    options.work = options.work.resolve()
    limit_memory()
    reasons = equivalent_mutants()

    subject = {"library": Library, "program": Program, "python": Python}[options.of](options)
    record = Record(options, key_of(options, subject))  # of an earlier state: begins anew
    folder = options.work / "copy" / subject.folder
    if not folder.exists():
        for name in subprocess.check_output(["git", "ls-files"], cwd=ROOT, text=True).splitlines():
            (options.work / "copy" / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, options.work / "copy" / name)
    (options.work / "mutant.h").write_text(MUTANT_H)
    headers = []
    for path in sorted((ROOT / subject.folder).rglob("*")):
        name = path.relative_to(ROOT / subject.folder).as_posix()
        if path.suffix in (".h", ".cpp") and name.startswith(tuple(options.files)) and not name.startswith(NOT_BROKEN):
            headers.append(Header(pathlib.PurePath(name), path.read_text()))
    possible, sites = draw(headers, options.sites, options.seed)
    for number, site in enumerate(sites, 1):
        site.number = number
    print("seed %d: %d of %d possible sites" % (options.seed, len(sites), possible), flush=True)

    sites = [s for s in sites if record.results.get(s.number) != Record.NOT_COMPILED]
    while True:
        write(folder, headers, sites)
        errors = subject.compile()
        if not errors:
            break
        bad = set().union(*(sites_in_lines_with_errors(messages, sites) for messages in errors))
        print("%d sites do not compile and are left out" % len(bad), flush=True)
        for site in bad:
            record.add(site, Record.NOT_COMPILED)
        sites = [s for s in sites if s not in bad]

    groups = subject.groups()
    survivors, noticed = [], 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        def result_of(site):
            if site.number in record.results:
                return site, record.results[site.number]
            ends = (subject.run(site.number, tests, seconds)[1] for tests, seconds in groups)
            return site, next((end for end in ends if end), None)

        for site, failed in pool.map(result_of, sites):
            if site.number not in record.results:
                record.add(site, failed)
            where = "%s:%d" % (site.file, site.line)
            print("%3d %-60s %s" % (site.number, where, failed or "SURVIVES"), flush=True)
            noticed += failed is not None
            if failed is None:
                survivors.append(site)
    equivalent = 0
    print("\nSurvivors:")
    for site in survivors:
        header, original, broken = site.file, one_line(site.original), one_line(site.broken)
        reason = reasons.get((header.as_posix(), original, broken), "A HOLE IN THE TESTS")
        equivalent += (header.as_posix(), original, broken) in reasons
        print("%3d %s:%d\n      %s\n   -> %s\n      %s" % (site.number, header, site.line, original, broken, reason))
    percent = 100 * noticed / (len(sites) - equivalent)
    print("\nseed %d: %d of %d noticed, %.1f %%; %d that survive are equivalent, of the others %.1f %% noticed" %
          (options.seed, noticed, len(sites), 100 * noticed / len(sites), equivalent, percent))
    return 0 if percent >= options.at_least else 1


if __name__ == "__main__":
    sys.exit(main())
