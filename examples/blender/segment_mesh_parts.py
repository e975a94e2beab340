# SPDX-License-Identifier: GPL-3.0-or-later

"""An add-on of Blender: the parts of the active mesh as an integer attribute of its faces, and, if
asked for, as material slots.

It needs the Python package region_segmentation (examples/python) where Blender's Python finds it.
Edges that are marked sharp can be borders.
"""

import colorsys
import sys

import bpy
import numpy

try:
    import region_segmentation
except ImportError:
    region_segmentation = None

bl_info = {
    "name": "Segment into Parts",
    "author": "the contributors of CGAL_Region_segmentation",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Object > Segment into Parts",
    "description": "Finds the parts of a mesh",
    "category": "Mesh",
}

METHODS = [
    ("learned", "Parts, learned", "Parts as people see them"),
    ("visibility", "Parts, by visibility", "The same, by a formula without training"),
    ("smooth-faces", "Faces of a machine part", "Planes, cylinders and other smooth surfaces"),
]


def array_of(collection, name, shape, dtype):
    array = numpy.empty(shape, dtype)
    collection.foreach_get(name, array.reshape(-1))
    return array


def segment(mesh, **options):
    """The segment of each face of a bpy.types.Mesh; options as of region_segmentation.segment()."""
    corners = array_of(mesh.loops, "vertex_index", len(mesh.loops), "i4")
    starts = array_of(mesh.polygons, "loop_start", len(mesh.polygons), "i4")
    sizes = array_of(mesh.polygons, "loop_total", len(mesh.polygons), "i4")
    points = array_of(mesh.vertices, "co", (len(mesh.vertices), 3), "f4")
    return region_segmentation.segment((points, numpy.insert(corners, starts, sizes)), **options)


def sharp_edges(mesh):
    ends = array_of(mesh.edges, "vertices", (len(mesh.edges), 2), "i4")
    return ends[array_of(mesh.edges, "use_edge_sharp", len(mesh.edges), bool)]


def write_attribute(mesh, labels):
    attribute = mesh.attributes.get("segment") or mesh.attributes.new("segment", "INT", "FACE")
    attribute.data.foreach_set("value", labels)


def write_materials(mesh, labels):
    """A material slot for each segment, in place of those of the mesh."""
    mesh.materials.clear()
    for i in range(int(labels.max()) + 1):
        material = bpy.data.materials.get(f"segment {i}") or bpy.data.materials.new(f"segment {i}")
        # Hues that differ by the golden section are far from those before.
        material.diffuse_color = (*colorsys.hsv_to_rgb(i * 0.618034 % 1, 0.6, 0.9), 1)
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", labels)


class SegmentIntoParts(bpy.types.Operator):
    """Find the parts of the active mesh"""

    bl_idname = "object.segment_into_parts"
    bl_label = "Segment into Parts"
    bl_options = {"REGISTER", "UNDO"}

    number: bpy.props.IntProperty(name="Number", description="0 lets the method choose it", min=0)
    method: bpy.props.EnumProperty(name="Method", items=METHODS)
    sharp_edges_are_borders: bpy.props.BoolProperty(name="Sharp edges are borders")
    make_materials: bpy.props.BoolProperty(name="Replace the materials", description="A material for each part")

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        if region_segmentation is None:
            python, folder = "%d.%d" % sys.version_info[:2], bpy.utils.user_resource("SCRIPTS", path="modules")
            self.report({"ERROR"}, f"The Python package region_segmentation is missing: install it for Python {python} by pip install --target {folder}")
            return {"CANCELLED"}
        mesh = context.object.data
        options = {"method": self.method, "number_of_segments": self.number or None}
        if self.sharp_edges_are_borders:
            options["constrained_edges"] = sharp_edges(mesh)
        try:
            labels = segment(mesh, **options)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        write_attribute(mesh, labels)
        if self.make_materials and len(labels) > 0:
            write_materials(mesh, labels)
        mesh.update()
        return {"FINISHED"}


def draw_menu_item(menu, context):
    menu.layout.operator(SegmentIntoParts.bl_idname)


def register():
    bpy.utils.register_class(SegmentIntoParts)
    bpy.types.VIEW3D_MT_object.append(draw_menu_item)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_menu_item)
    bpy.utils.unregister_class(SegmentIntoParts)
