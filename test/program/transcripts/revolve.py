"""revolve.py SIDES R,Z...: the surface that a profile makes around the z axis, as OFF."""

import math
import sys

n, points, faces, last = int(sys.argv[1]), [], [], None
for word in sys.argv[2:]:
    r, z = map(float, word.split(","))
    ring = [len(points) + i for i in range(n if r else 1)] * (1 if r else n)
    angles = [2 * math.pi * i / n for i in range(n if r else 1)]
    points += [(r * math.cos(angle), r * math.sin(angle), z) for angle in angles]
    for i in range(n if last else 0):
        j = (i + 1) % n
        corners = dict.fromkeys((last[i], ring[i], ring[j], last[j]))
        faces.append(f"{len(corners)} " + " ".join(map(str, reversed(corners))))
    last = ring
print("OFF", f"{len(points)} {len(faces)} 0", *("%.17g %.17g %.17g" % p for p in points), *faces, sep="\n")
