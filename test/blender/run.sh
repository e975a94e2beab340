#!/bin/sh
# run.sh PYTHON: the add-on in a Blender without a window. PYTHON is that of the virtual environment that has the module.
#
# Exit status 77: there is no Blender, or its Python cannot load the module.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if ! command -v blender >/dev/null; then
  echo "Skipped: there is no blender"
  exit 77
fi
PYTHONPATH=$("$1" -c 'import pathlib, region_segmentation as r; print(pathlib.Path(r.__file__).parent.parent)') || exit 77
export PYTHONPATH
if ! blender --background --python-exit-code 1 --python-expr 'import region_segmentation' >/dev/null 2>&1; then
  echo "Skipped: this blender does not start, or does not load the module for $1"
  exit 77
fi
blender --background --python-exit-code 1 --python "$here/blender_test.py" -- \
  "$here/../../examples/blender/segment_mesh_parts.py"
