# SPDX-License-Identifier: GPL-3.0-or-later

"""An add-on of Blender: the parts of the active mesh, as an integer attribute "segment" of its faces, as a
color attribute, and, if asked for, as objects of their own. Materials stay as they are.

It needs the Python package region_segmentation (examples/python) where Blender's Python finds it.
Edges that are marked sharp can be borders; faces that are marked in edit mode can be in one part.
"""

import sys

import bmesh
import bpy
import numpy

try:
    import region_segmentation
except ImportError:
    region_segmentation = None

bl_info = {
    "name": "Segment into Parts",
    "author": "the contributors of CGAL_Region_segmentation",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Segments",
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


def seeds(mesh):
    """Of the faces: the parts that the user has marked, -1 for none; None if there are no marks."""
    marks = mesh.attributes.get("seed")
    return None if marks is None else array_of(marks.data, "value", len(mesh.polygons), "i4") - 1


def write_labels(mesh, labels):
    attribute = mesh.attributes.get("segment") or mesh.attributes.new("segment", "INT", "FACE")
    attribute.data.foreach_set("value", labels)
    colors = mesh.color_attributes.get("segment color") or mesh.color_attributes.new("segment color", "BYTE_COLOR", "CORNER")
    rgba = numpy.insert(region_segmentation.colors(labels) / 255, 3, 1, axis=1)
    sizes = array_of(mesh.polygons, "loop_total", len(mesh.polygons), "i4")
    colors.data.foreach_set("color_srgb", numpy.repeat(rgba, sizes, axis=0).astype("f4").reshape(-1))
    mesh.color_attributes.active_color = colors
    mesh.update()


class Options:
    number: bpy.props.IntProperty(name="Number (0: chosen)", min=0)
    method: bpy.props.EnumProperty(name="Method", items=METHODS)
    sharp_edges_are_borders: bpy.props.BoolProperty(name="Sharp edges are borders")
    marks_are_parts: bpy.props.BoolProperty(name="Marked faces are parts", default=True)


class Settings(Options, bpy.types.PropertyGroup):
    pass


class OfMeshObject:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.object is not None and context.object.type == "MESH"


class SegmentIntoParts(OfMeshObject, Options, bpy.types.Operator):
    """Find the parts of the active mesh"""

    bl_idname = "object.segment_into_parts"
    bl_label = "Segment into Parts"

    def execute(self, context):
        if region_segmentation is None:
            python, folder = "%d.%d" % sys.version_info[:2], bpy.utils.user_resource("SCRIPTS", path="modules")
            self.report({"ERROR"}, f"The Python package region_segmentation is missing: install it for Python {python} by pip install --target {folder}")
            return {"CANCELLED"}
        mesh = context.object.data
        options = {"method": self.method, "number_of_segments": self.number or None}
        if self.sharp_edges_are_borders:
            options["constrained_edges"] = sharp_edges(mesh)
        if self.marks_are_parts:
            options["seeds"] = seeds(mesh)
        try:
            write_labels(mesh, segment(mesh, **options))
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if context.space_data is not None and context.space_data.type == "VIEW_3D":
            context.space_data.shading.color_type = "VERTEX"
        return {"FINISHED"}


class SeparateSegments(OfMeshObject, bpy.types.Operator):
    """Make an object of each segment; the mesh itself is hidden"""

    bl_idname = "object.separate_segments"
    bl_label = "Separate by Segment"

    def execute(self, context):
        whole = context.object
        if "segment" not in whole.data.attributes:
            self.report({"ERROR"}, "Segment into parts before")
            return {"CANCELLED"}
        for i in numpy.unique(array_of(whole.data.attributes["segment"].data, "value", len(whole.data.polygons), "i4")):
            part = whole.copy()
            part.data, part.name = whole.data.copy(), f"{whole.name} segment {i}"
            faces = bmesh.new()
            faces.from_mesh(part.data)
            label = faces.faces.layers.int["segment"]
            bmesh.ops.delete(faces, geom=[face for face in faces.faces if face[label] != i], context="FACES")
            faces.to_mesh(part.data)
            faces.free()
            context.collection.objects.link(part)
        whole.hide_set(True)
        return {"FINISHED"}


class MarkPart(bpy.types.Operator):
    """The selected faces end in one part, and not in that of faces marked before"""

    bl_idname = "mesh.mark_part"
    bl_label = "Mark Selected Faces as a Part"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "EDIT_MESH"

    def execute(self, context):
        mesh = context.edit_object.data
        faces = bmesh.from_edit_mesh(mesh).faces
        seed = faces.layers.int.get("seed") or faces.layers.int.new("seed")
        number = 1 + max((face[seed] for face in faces), default=0)
        for face in faces:
            if face.select:
                face[seed] = number
        bmesh.update_edit_mesh(mesh)
        return {"FINISHED"}


class SegmentsPanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_segments"
    bl_label = "Segments"
    bl_category = "Segments"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        settings = context.scene.segment_into_parts
        for name in Options.__annotations__:
            self.layout.prop(settings, name)
        self.layout.operator(MarkPart.bl_idname)
        operator = self.layout.operator(SegmentIntoParts.bl_idname)
        for name in Options.__annotations__:
            setattr(operator, name, getattr(settings, name))
        self.layout.operator(SeparateSegments.bl_idname)


CLASSES = Settings, SegmentIntoParts, SeparateSegments, MarkPart, SegmentsPanel


def register():
    for c in CLASSES:
        bpy.utils.register_class(c)
    bpy.types.Scene.segment_into_parts = bpy.props.PointerProperty(type=Settings)


def unregister():
    del bpy.types.Scene.segment_into_parts
    for c in reversed(CLASSES):
        bpy.utils.unregister_class(c)
