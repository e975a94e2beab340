"""pillars.py N: the surface of a plate of unit cubes with N by N pillars on it, as OFF."""

import sys

n = 3 * int(sys.argv[1]) + 1
cells = {(x, y, z) for x in range(n) for y in range(n) for z in range(7 if x % 3 == y % 3 == 1 else 1)}
points, faces = {}, []
for cell in sorted(cells):
    for axis in range(3):
        for side in (0, 1):
            neighbor = list(cell)
            neighbor[axis] += 2 * side - 1
            if tuple(neighbor) not in cells:
                corners = []
                for step in ((0, 0), (1, 0), (1, 1), (0, 1))[::2 * side - 1]:
                    corner = list(cell)
                    corner[axis] += side
                    corner[axis - 2] += step[0]
                    corner[axis - 1] += step[1]
                    corners.append(points.setdefault(tuple(corner), len(points)))
                faces.append(corners)
print("OFF", f"{len(points)} {len(faces)} 0", *(f"{x} {y} {z}" for x, y, z in points), sep="\n")
print(*("4 " + " ".join(map(str, face)) for face in faces), sep="\n")
