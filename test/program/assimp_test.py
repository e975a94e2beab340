#!/usr/bin/env python3
"""assimp_test.py PROGRAM: .glb and .3mf of segment_mesh, read by assimp. Needs Debian's assimp-utils; without it, or where the
program was built without these formats, the test is skipped."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

import numpy

SKIPPED = 77


def run(command, folder):
    return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def parts_of_obj(file):
    """The coordinates of the triangles of each part, and the name of its material."""
    points, parts, materials, name = [], {}, {}, None
    for words in map(str.split, file.read_text().splitlines()):
        if not words:
            continue
        if words[0] == "v":
            points.append([float(x) for x in words[1:4]])
        elif words[0] in "go":
            name = words[1]
        elif words[0] == "usemtl":
            materials[name] = words[1]
        elif words[0] == "f":
            parts.setdefault(name, []).append([points[int(w.split("/")[0]) - 1] for w in words[1:]])
    return {n: numpy.array(p) for n, p in parts.items()}, materials


def colors_of_mtl(file):
    colors, name = {}, None
    for words in map(str.split, file.read_text().splitlines()):
        if words[:1] == ["newmtl"]:
            name = words[1]
        elif words[:1] == ["Kd"]:
            colors[name] = [float(x) for x in words[1:4]]
    return colors


def repack(file):
    """Writes the archive without the 64-bit sizes of lib3mf, which assimp 5.2 does not read."""
    with zipfile.ZipFile(file) as archive:
        contents = {name: archive.read(name) for name in archive.namelist()}
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in contents.items():
            archive.writestr(name, content)
    return contents


def check(program, folder):
    outcome = run([program, "--demo", "-q", "-o", "a.obj", "-o", "a.glb", "-o", "a.3mf"], folder)
    if "built without" in outcome.stdout:
        print("skipped:", outcome.stdout)
        sys.exit(SKIPPED)
    assert outcome.returncode == 0, outcome.stdout
    expected, _ = parts_of_obj(folder / "a.obj")
    expected.pop("feature_lines", None)
    model = repack(folder / "a.3mf")["3D/3dmodel.model"].decode()
    alphas = re.findall('displaycolor="#......(..)?"', model)
    assert len(alphas) == len(expected) and set(alphas) <= {"", "FF"}, alphas
    for kind in "glb", "3mf":
        back = f"{kind}.obj"
        outcome = run(["assimp", "export", f"a.{kind}", back], folder)
        assert (folder / back).exists(), outcome.stdout
        parts, materials = parts_of_obj(folder / back)
        if kind == "glb":
            assert list(parts) == list(expected), list(parts)
        # In a .3mf, assimp 5.2 takes the numbers of objects for their names, and puts that of a group before a material's.
        for part, of_obj in zip(parts.values(), expected.values(), strict=True):
            numpy.testing.assert_allclose(part, of_obj, atol=2e-6)
        names = list(materials.values())
        assert [name.removeprefix("id1_") for name in names] == list(expected), names
        colors = colors_of_mtl(folder / f"{kind}.mtl")
        assert len({tuple(colors[name]) for name in names}) == len(names), colors


if __name__ == "__main__":
    if not shutil.which("assimp"):
        print("skipped: no assimp-utils")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as name:
        check(sys.argv[1], pathlib.Path(name))
