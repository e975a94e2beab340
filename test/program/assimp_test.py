#!/usr/bin/env python3
"""assimp_test.py PROGRAM: .glb and .3mf of segment_mesh, read by assimp. Needs Debian's assimp-utils; without it, or where the
program was built without these formats, the test is skipped."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def run(command, folder):
    return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def parts_of_obj(file):
    """The triangles of each part, as sorted triples of rounded points, and the name of its material."""
    points, parts, materials, name = [], {}, {}, None
    for words in map(str.split, file.read_text().splitlines()):
        if not words:
            continue
        if words[0] == "v":
            points.append(tuple(round(float(x), 3) for x in words[1:4]))
        elif words[0] in "go":
            name = words[1]
        elif words[0] == "usemtl":
            materials[name] = words[1]
        elif words[0] == "f":
            corners = [points[int(w.split("/")[0]) - 1] for w in words[1:]]
            parts.setdefault(name, []).append(tuple(sorted(corners)))
    return {n: sorted(p) for n, p in parts.items()}, materials


def colors_of_mtl(file):
    colors, name = {}, None
    for words in map(str.split, file.read_text().splitlines()):
        if words[:1] == ["newmtl"]:
            name = words[1]
        elif words[:1] == ["Kd"]:
            colors[name] = [float(x) for x in words[1:4]]
    return colors


def check(program, folder):
    outcome = run([program, "--demo", "-q", "-o", "a.obj", "-o", "a.glb", "-o", "a.3mf"], folder)
    if "built without" in outcome.stdout:
        print("skipped:", outcome.stdout)
        sys.exit(SKIPPED)
    assert outcome.returncode == 0, outcome.stdout
    expected, _ = parts_of_obj(folder / "a.obj")
    expected.pop("feature_lines", None)
    for kind in "glb", "3mf":
        back = f"{kind}.obj"
        outcome = run(["assimp", "export", f"a.{kind}", back], folder)
        assert (folder / back).exists(), outcome.stdout
        parts, materials = parts_of_obj(folder / back)
        assert parts == expected, f"{kind}: {[(n, len(p)) for n, p in parts.items()]}"
        assert all(materials[name] == name for name in parts), materials
        colors = colors_of_mtl(folder / f"{kind}.mtl")
        assert len({tuple(colors[name]) for name in parts}) == len(parts), colors


if __name__ == "__main__":
    if not shutil.which("assimp"):
        print("skipped: no assimp-utils")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as name:
        check(sys.argv[1], pathlib.Path(name))
