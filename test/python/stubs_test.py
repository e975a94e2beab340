# SPDX-License-Identifier: GPL-3.0-or-later

"""The type stubs in the wheel say what the module has."""

import ast
import importlib.metadata
import inspect
import typing

import numpy
import pytest

import region_segmentation

files = importlib.metadata.files("region-segmentation")
(stub,) = [f for f in files if str(f) == "region_segmentation-stubs/__init__.pyi"]
tree = ast.parse(stub.read_text())


def parameters_of_stub(definitions):
    """Names in order, and whether each is required, of the overloads of a function."""
    overloads = []
    for d in definitions:
        a = d.args
        required = len(a.args) - len(a.defaults)
        names = {p.arg: i < required for i, p in enumerate(a.args)}
        overloads.append({**names, **{p.arg: default is None for p, default in zip(a.kwonlyargs, a.kw_defaults)}})
    longest = max(overloads, key=len)
    return [(name, all(o.get(name, False) for o in overloads)) for name in longest]


def parameters_of_docstring(name, text):
    """The same of pybind11's first line; as keywords, since a required one may follow one with a default."""
    signature = text.splitlines()[0].replace(f"{name}(", f"def {name}(*, ", 1)
    (function,) = ast.parse(signature + ": ...").body
    return [(p.arg, default is None) for p, default in zip(function.args.kwonlyargs, function.args.kw_defaults)]


def names_of(scope):
    return {name for name in vars(scope) if not name.startswith("_") or name in ("__version__", "__init__")}


def check(scope, body):
    functions = {}
    for node in body:
        if isinstance(node, ast.FunctionDef):
            functions.setdefault(node.name, []).append(node)
    for name, definitions in functions.items():
        real = inspect.getattr_static(scope, name)
        decorators = {d.id for definition in definitions for d in definition.decorator_list}
        if "property" in decorators:
            assert isinstance(real, property) and real.__doc__
            continue
        text = getattr(scope, name).__doc__
        assert parameters_of_docstring(name, text) == parameters_of_stub(definitions)
        assert len(text.splitlines()) > 1, f"{name} has no description"
    return set(functions)


def test_names_and_parameters():
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    functions = check(region_segmentation, tree.body)
    members = check(region_segmentation.Segmenter, classes["Segmenter"].body)
    assert functions | {"Segmenter", "InvalidInput", "__version__"} == names_of(region_segmentation)
    assert members == names_of(region_segmentation.Segmenter)
    assert issubclass(region_segmentation.InvalidInput, ValueError) and region_segmentation.InvalidInput.__doc__
    assert region_segmentation.__version__ == importlib.metadata.version("region-segmentation")


def test_values_have_the_types_of_the_stubs():
    points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    stubs = {}
    exec(compile(tree, str(stub), "exec"), stubs)
    (description, _) = region_segmentation.describe_segments(points, faces, [0, 0, 0, 1])
    for dictionary, type_name in (
        (description, "Description"),
        (description["primitive"], "Primitive"),
        (description["neighbors"][0], "Neighbor"),
    ):
        hints = typing.get_type_hints(stubs[type_name])
        assert list(dictionary) == list(hints)
        for name, hint in hints.items():
            kind = typing.get_origin(hint) or (dict if typing.is_typeddict(hint) else hint)
            kind = str if kind is typing.Literal else kind
            assert isinstance(dictionary[name], kind), name
    segmenter = region_segmentation.Segmenter(points, faces)
    for labels in segmenter.segment(2), segmenter.regions, region_segmentation.segment_borders(points, faces, [0, 0, 0, 1]):
        assert labels.dtype == numpy.uint64
    assert [[type(x) for x in merge] for merge in segmenter.merges] == [[int, int, float]] * len(segmenter.merges)


def test_methods_of_the_stubs():
    (method,) = [n.value for n in tree.body if isinstance(n, ast.Assign) and n.targets[0].id == "Method"]
    for name in ast.literal_eval(method.slice):
        region_segmentation.Segmenter(numpy.eye(3), [[0, 1, 2]], name)


def test_errors_name_the_place():
    points = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
    points[3] = numpy.nan
    faces = [[0, 1, 2], [1, 3, 2]]
    for function in region_segmentation.segment, lambda *mesh: region_segmentation.describe_segments(*mesh, [0, 0]):
        with pytest.raises(region_segmentation.InvalidInput, match="^the point of vertex 3 is not finite$"):
            function(points, faces)
        function(points, faces[:1] + faces[:1])
