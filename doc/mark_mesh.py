#!/usr/bin/env python3
"""mark_mesh.py ring MESH.off AXIS VALUE X Y Z RADIUS: edges for --constraints, between the faces on both sides of a plane
across an axis (0, 1 or 2), of the faces around a point.
mark_mesh.py dabs MESH.off RADIUS SEED X Y Z [SEED X Y Z]...: faces for --seeds, those around the one nearest to each point."""

import math
import sys


def read_off(file):
    with open(file, encoding="latin-1") as lines:
        words = " ".join(line.split("#")[0] for line in lines).split()
    n, m = int(words[1]), int(words[2])
    points = [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(n)]
    faces, at = [], 4 + 3 * n
    for _ in range(m):
        size = int(words[at])
        faces.append(list(map(int, words[at + 1:at + 1 + size])))
        at += 1 + size
    return points, faces


def centroid(points, face):
    return [sum(points[i][c] for i in face) / len(face) for c in range(3)]


def ring(points, faces, axis, value, center, radius):
    side = {}
    for face in faces:
        middle = centroid(points, face)
        if math.dist(middle, center) > radius:
            continue
        for a, b in zip(face, face[1:] + face[:1]):
            side.setdefault((min(a, b), max(a, b)), []).append(middle[axis] < value)
    for edge, sides in sorted(side.items()):
        if sides in ([True, False], [False, True]):
            print(*edge)


def dabs(points, faces, radius, seeds):
    middles = [centroid(points, face) for face in faces]
    for seed, point in seeds:
        center = min(middles, key=lambda middle: math.dist(middle, point))
        for f, middle in enumerate(middles):
            if math.dist(middle, center) <= radius:
                print(f, seed)


def main(what, file, *numbers):
    mesh = read_off(file)
    values = list(map(float, numbers))
    if what == "ring":
        ring(*mesh, int(values[0]), values[1], values[2:5], values[5])
    else:
        dabs(*mesh, values[0], [(int(values[i]), values[i + 1:i + 4]) for i in range(1, len(values), 4)])


if __name__ == "__main__":
    main(*sys.argv[1:])
