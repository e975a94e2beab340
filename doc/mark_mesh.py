#!/usr/bin/env python3
"""mark_mesh.py ring MESH.off AXIS VALUE X Y Z RADIUS: edges for --constraints, between the faces on both sides of a plane
across an axis (0, 1 or 2), of the faces around a point.
mark_mesh.py dabs MESH.off RADIUS SEED X Y Z [SEED X Y Z]...: faces for --seeds, those around the one nearest to each point.
mark_mesh.py rays MESH.off SUPERFACETS.seg LABELS.seg X Y Z A B C: the mesh without what is beyond the plane through the
point with the normal (A, B, C), and the 12 rays of the superfacet at the point. Writes labels for it: 1 of this superfacet,
others of those that it sees, 0 of the rest, -1 of rays.
mark_mesh.py boxes X Y Z X Y Z [X Y Z X Y Z]...: the surface of the union of boxes with integer corners, in unit squares."""

import itertools
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


def write_off(points, faces):
    print("OFF", len(points), len(faces), 0)
    for p in points:
        print(*p)
    for face in faces:
        print(len(face), *face)


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def plus(p, factor, q):
    return [a + factor * b for a, b in zip(p, q)]


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def unit(p):
    return [a / math.hypot(*p) for a in p]


def mean(points):
    return [sum(c) / len(points) for c in zip(*points)]


def centroid(points, face):
    return mean([points[i] for i in face])


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


def distance_to(triangle, source, direction):
    """That at which a ray meets a triangle, infinite if it does not."""
    p, q, r = triangle
    e, f = minus(q, p), minus(r, p)
    across = cross(direction, f)
    determinant = dot(e, across)
    if abs(determinant) < 1e-30:
        return math.inf
    from_p = minus(source, p)
    s, aside = dot(from_p, across) / determinant, cross(from_p, e)
    t, x = dot(direction, aside) / determinant, dot(f, aside) / determinant
    return x if min(s, t) >= 0 and s + t <= 1 and x > 0 else math.inf


def rays_of(points, faces, superfacet):
    """The rays that the documentation of Visibility_annotator describes, with the points at both ends and the face that is hit."""
    triangles = [[points[i] for i in face] for face in faces]
    middle = mean([mean(triangles[f]) for f in superfacet])
    order = sorted(superfacet, key=lambda f: math.dist(mean(triangles[f]), middle))
    for k in range(3):
        face = order[9 * k * len(order) // 30]
        p, q, r = triangles[face]
        source, inward = mean(triangles[face]), unit(cross(minus(r, p), minus(q, p)))
        u = unit(minus(q, p))
        v = cross(inward, u)
        for i in range(4):
            away, around = .9 * math.sqrt(i / 3), 2.399963229728653 * i + k
            aside = plus([math.cos(around) * c for c in u], math.sin(around), v)
            direction = plus([math.cos(away) * c for c in inward], math.sin(away), aside)
            distance, hit = min((distance_to(t, source, direction), f) for f, t in enumerate(triangles) if f != face)
            if distance < math.inf:
                yield source, plus(source, distance, direction), hit


def rays(points, faces, superfacet_file, label_file, point, normal):
    with open(superfacet_file, encoding="ascii") as file:
        superfacets = [int(line) for line in file]
    nearest = min(range(len(faces)), key=lambda f: math.dist(centroid(points, faces[f]), point))
    superfacet = [f for f, s in enumerate(superfacets) if s == superfacets[nearest]]
    lines = list(rays_of(points, faces, superfacet))
    seen = {superfacets[nearest]: 1}
    for _, _, hit in lines:
        seen.setdefault(superfacets[hit], len(seen) + 1)
    labels = [seen.get(s, 0) for s in superfacets]
    kept = [f for f, face in enumerate(faces) if dot(minus(centroid(points, face), point), normal) <= 0 or f in superfacet]
    points, faces = list(points), [faces[f] for f in kept]
    labels = [labels[f] for f in kept]
    width = .002 * math.dist(*([c(axis) for axis in zip(*points)] for c in (min, max)))
    for source, end, _ in lines:  # prisms
        u = unit(cross(minus(end, source), [.1, .2, .3]))
        v = unit(cross(minus(end, source), u))
        at = len(points)
        for p in (source, end):
            points += [plus(plus(p, width * math.cos(a), u), width * math.sin(a), v) for a in (0, 2.1, 4.2)]
        faces += [[at + i, at + (i + 1) % 3, at + 3 + (i + 1) % 3, at + 3 + i] for i in range(3)]
        labels += [-1] * 3
    with open(label_file, "w", encoding="ascii") as file:
        print(*labels, sep="\n", file=file)
    write_off(points, faces)


def boxes(corners):
    """Each box has its lower and its upper corner."""
    cubes = {cube for i in range(0, len(corners), 6)
             for cube in itertools.product(*(range(corners[i + c], corners[i + 3 + c]) for c in range(3)))}
    points, faces = {}, []
    for cube in sorted(cubes):
        for axis, side in itertools.product(range(3), (0, 1)):
            neighbor = [x + (2 * side - 1) * (c == axis) for c, x in enumerate(cube)]
            if tuple(neighbor) in cubes:
                continue
            square = []
            for step in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cube)
                corner[axis] += side
                corner[(axis + 1) % 3] += step[0]
                corner[(axis + 2) % 3] += step[1]
                square.append(points.setdefault(tuple(corner), len(points)))
            faces.append(square if side else square[::-1])
    write_off(points, faces)


def main(what, *words):
    if what == "boxes":
        boxes(list(map(int, words)))
        return
    mesh, words = read_off(words[0]), words[1:]
    if what == "rays":
        numbers = list(map(float, words[2:]))
        rays(*mesh, *words[:2], numbers[:3], numbers[3:])
        return
    values = list(map(float, words))
    if what == "ring":
        ring(*mesh, int(values[0]), values[1], values[2:5], values[5])
    else:
        dabs(*mesh, values[0], [(int(values[i]), values[i + 1:i + 4]) for i in range(1, len(values), 4)])


if __name__ == "__main__":
    main(*sys.argv[1:])
