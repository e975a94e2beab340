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
    thing.select_set(True)
    return mesh


def attribute(mesh):
    return [value.value for value in mesh.attributes["segment"].data]


def test():
    points, faces = grid(10)
    mesh = add_object(points, faces)
    mesh.materials.append(bpy.data.materials.new("of a user"))
    assert bpy.ops.object.segment_into_parts(number=5) == {"FINISHED"}
    labels = attribute(mesh)
    assert labels == region_segmentation.segment((points, faces), 5).tolist() and max(labels) == 4
    colors = [[round(255 * x) for x in corner.color_srgb] for corner in mesh.color_attributes.active_color.data]
    assert colors[::4] == [[*color, 255] for color in region_segmentation.colors(labels).tolist()]
    assert [m.name for m in mesh.materials] == ["of a user"]

    # Objects of the segments keep the material, and the rest of the mesh.
    assert bpy.ops.object.separate_segments() == {"FINISHED"}
    parts = [thing for thing in bpy.data.objects if " segment " in thing.name]
    assert sorted(len(part.data.polygons) for part in parts) == sorted(labels.count(i) for i in range(5))
    assert {m.name for part in parts for m in part.data.materials} == {"of a user"}
    assert bpy.context.object.hide_get() and len(mesh.polygons) == 100

    # Again, for fewer.
    assert bpy.ops.object.segment_into_parts(number=2) == {"FINISHED"}
    assert max(attribute(mesh)) == 1

    # Marked faces are in parts of their own.
    bpy.context.object.hide_set(False)
    bpy.context.tool_settings.mesh_select_mode = False, False, True  # of faces
    for marked in [0], [1, 2]:
        for face in mesh.polygons:
            face.select = face.index in marked
        bpy.ops.object.mode_set(mode="EDIT")
        assert bpy.ops.mesh.mark_part() == {"FINISHED"}
        bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.object.segment_into_parts(number=2) == {"FINISHED"}
    assert attribute(mesh)[0] != attribute(mesh)[1] == attribute(mesh)[2]
    mesh.attributes.remove(mesh.attributes["seed"])

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
