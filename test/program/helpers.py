"""What the tests of the program in Python share: skipping, runs of the program, files of OFF, areas and volumes."""

import csv
import json
import pathlib
import shutil
import subprocess
import sys

import numpy

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
SKIPPED = 77

# A block of six rectangles.
BLOCK = """OFF
8 6 0
0 0 0
2 0 0
2 1 0
0 1 0
0 0 3
2 0 3
2 1 3
0 1 3
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def need(*programs):
    for program in programs:
        if not shutil.which(program):
            skip(f"no {program}")


def run(folder, *command):
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)


def read_off(file):
    """Points, faces, and the words after the corners of each face."""
    lines = [line.split() for line in file.read_text().split("\n") if line]
    n = int(lines[1][0])
    faces = [list(map(int, line[:int(line[0]) + 1])) for line in lines[2 + n:]]
    return ([tuple(map(float, line)) for line in lines[2:2 + n]], [face[1:] for face in faces],
            [tuple(map(int, line[len(face):])) for line, face in zip(lines[2 + n:], faces)])


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *("%.17g %.17g %.17g" % tuple(p) for p in points)]
    file.write_text("\n".join(lines + [" ".join(map(str, [len(face), *face])) for face in faces]) + "\n")


def area(triangles):
    """Of an array of triangles, three points each."""
    a, b, c = numpy.asarray(triangles, dtype=float).transpose(1, 0, 2)
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2


def fan(points, face):
    return [[points[face[0]], points[face[i]], points[face[i + 1]]] for i in range(1, len(face) - 1)]


def rows_of(file):
    with open(file, newline="") as table:
        return list(csv.DictReader(table))


def partition_of(labels):
    return {frozenset(i for i, x in enumerate(labels) if x == label) for label in set(labels)}


class Case:
    """A mesh that segment_mesh segments and writes."""

    def __init__(self, program, folder, mesh, options):
        self.folder, self.command = folder, [program, mesh, *options, "-q"]
        self.write("mesh.off", "labels.seg", "names.csv")
        self.points, self.faces, self.colors = read_off(folder / "mesh.off")
        self.labels = [int(word) for word in (folder / "labels.seg").read_text().split()]
        self.areas = self.areas_by(self.points, self.faces, self.labels)
        self.names = [row["name"] for row in rows_of(folder / "names.csv")]
        self.area_of_name = dict(zip(self.names, self.areas, strict=True))
        self.volume = sum(numpy.linalg.det(t) for face in self.faces for t in fan(self.points, face)) / 6

    def write(self, *names, options=()):
        outputs = [word for name in names for word in ("-o", name)]
        outcome = subprocess.run([*self.command, *outputs, *options], cwd=self.folder, capture_output=True, text=True)
        if "built without" in outcome.stderr:
            skip(outcome.stderr)
        assert outcome.returncode == 0, outcome.stderr

    @staticmethod
    def areas_by(points, faces, keys):
        """Of the faces of each key, in the order of keys."""
        parts = {}
        for face, key in zip(faces, keys, strict=True):
            parts.setdefault(key, []).extend(fan(points, face))
        return [area(parts[key]) for key in sorted(parts)]

    def expect(self, areas):
        numpy.testing.assert_allclose(areas, self.areas, rtol=1e-6)


def meshes_of_glb(file):
    """Name, triangles, and name of the material of each mesh of a binary glTF."""
    data = file.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    document, binary = json.loads(data[20:20 + size]), data[28 + size:]

    def array(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        values = numpy.frombuffer(binary, {5126: "<f4", 5125: "<u4", 5123: "<u2"}[accessor["componentType"]],
                                  accessor["count"] * {"VEC3": 3, "SCALAR": 1}[accessor["type"]],
                                  view.get("byteOffset", 0) + accessor.get("byteOffset", 0))
        return values.reshape(-1, 3) if accessor["type"] == "VEC3" else values

    for node in document["nodes"]:
        if "mesh" in node:
            primitive, = document["meshes"][node["mesh"]]["primitives"]
            corners = array(primitive["indices"])
            attributes = {name: array(index)[corners].reshape(-1, 3, 3) for name, index in primitive["attributes"].items()}
            yield node.get("name"), attributes, document["materials"][primitive.get("material", 0)]
