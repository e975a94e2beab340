# SPDX-License-Identifier: GPL-3.0-or-later

# blender --background --python blender_test.py -- ADD_ON: the add-on in a Blender without a window. PYTHONPATH has the module.

import importlib.util
import sys
import traceback

import bpy
import numpy
import region_segmentation


def grid(n):
    """n x n squares, bent along the middle to a valley."""
    x, y = numpy.meshgrid(numpy.arange(n + 1.0), numpy.arange(n + 1.0), indexing="ij")
    points = numpy.stack([x, y, abs(x - n / 2)], -1).reshape(-1, 3)
    a = (numpy.arange(n)[:, None] * (n + 1) + numpy.arange(n)[None, :]).reshape(-1)
    return points, numpy.stack([a, a + n + 1, a + n + 2, a + 1], -1)


def add_object(points, faces):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(points.tolist(), [], faces.tolist())
    thing = bpy.data.objects.new("thing", mesh)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    return mesh


def attribute(mesh):
    return [value.value for value in mesh.attributes["segment"].data]


def test():
    points, faces = grid(10)
    mesh = add_object(points, faces)
    mesh.materials.append(bpy.data.materials.new("of a user"))
    assert bpy.ops.object.segment_into_parts(number=5) == {"FINISHED"}
    assert [m.name for m in mesh.materials] == ["of a user"]
    assert bpy.ops.object.segment_into_parts(number=5, make_materials=True) == {"FINISHED"}
    labels = attribute(mesh)
    assert labels == region_segmentation.segment((points, faces), 5).tolist() and max(labels) == 4
    assert [p.material_index for p in mesh.polygons] == labels
    assert [m.name for m in mesh.materials] == [f"segment {i}" for i in range(5)]
    assert len({tuple(m.diffuse_color) for m in mesh.materials}) == 5

    # Again, for fewer: the materials of before stay.
    assert bpy.ops.object.segment_into_parts(number=2) == {"FINISHED"}
    assert max(attribute(mesh)) == 1 and len(mesh.materials) == 5

    # A chosen number.
    assert bpy.ops.object.segment_into_parts() == {"FINISHED"}
    assert attribute(mesh) == region_segmentation.segment((points, faces)).tolist()

    # Sharp edges are borders.
    for edge in mesh.edges:
        edge.use_edge_sharp = all(v // 11 == 5 for v in edge.vertices)
    assert bpy.ops.object.segment_into_parts(number=2, sharp_edges_are_borders=True) == {"FINISHED"}
    assert attribute(mesh) == [0] * 50 + [1] * 50

    # A mesh that cannot be segmented.
    mesh = add_object(points, faces)
    mesh.vertices[5].co.x = float("nan")
    try:
        bpy.ops.object.segment_into_parts()
        raise AssertionError("no error")
    except RuntimeError as error:
        assert "vertex 5 is not finite" in str(error), error
    assert "segment" not in mesh.attributes

    # A Python without the package.
    add_on.region_segmentation = None
    try:
        bpy.ops.object.segment_into_parts()
        raise AssertionError("no error")
    except RuntimeError as error:
        assert "package region_segmentation is missing" in str(error), error


try:
    spec = importlib.util.spec_from_file_location("segment_mesh_parts", sys.argv[-1])
    add_on = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(add_on)
    add_on.register()
    test()
    add_on.unregister()
except BaseException:
    traceback.print_exc()
    sys.exit(1)
print("The add-on passed")
