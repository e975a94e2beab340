#!/usr/bin/env python3
"""step_readers_test.py PROGRAM MESH: mesh_to_step writes the flange in inches; FreeCAD and gmsh read it in mm: a valid closed solid of
15 faces and of the volume that the report has, which gmsh meshes. Skipped without FreeCAD or gmsh (Debian: freecad-python3
python3-gmsh)."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "program"))
from helpers import need, skip  # noqa: E402

try:
    import gmsh
except ImportError:
    skip("no python3-gmsh")

SCRIPT = """
import Part
solid = Part.Shape()
solid.read("part.step")
print("read:", solid.isValid(), solid.isClosed(), len(solid.Solids), len(solid.Faces), solid.Volume)
"""


def main(program, mesh):
    need("freecadcmd")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([program, mesh, "part.step", "--unit", "inch", "--report", "part.json"], cwd=folder, check=True)
        report = json.loads((folder / "part.json").read_text())
        radii = {round(face["radius"] / 25.4, 6) for face in report["faces"] if "radius" in face}
        assert {8, 25, 50, 100} <= radii, radii
        (folder / "read.py").write_text(SCRIPT)
        said = subprocess.run(["freecadcmd", "read.py"], cwd=folder, capture_output=True, text=True,
                              env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": name}).stdout
        valid, closed, solids, faces, volume = said.split("read:")[1].split()
        assert (valid, closed, solids, faces) == ("True", "True", "1", "15"), said
        numpy.testing.assert_allclose(float(volume), report["volume"], rtol=1e-6)

        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.occ.importShapes(str(folder / "part.step"))
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(3)
        _, points, _ = gmsh.model.mesh.getNodes()
        corners = gmsh.model.mesh.getElementsByType(gmsh.model.mesh.getElementType("tetrahedron", 1))[1]
        tetrahedra = points.reshape(-1, 3)[corners.astype(int).reshape(-1, 4) - 1]
        total = numpy.linalg.det(tetrahedra[:, 1:] - tetrahedra[:, :1]).sum() / 6
        numpy.testing.assert_allclose(abs(total), report["volume"], rtol=0.1)
        gmsh.finalize()


if __name__ == "__main__":
    main(*sys.argv[1:])
