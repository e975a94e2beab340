#!/bin/sh
# run.sh DIR SOURCE: makes a wheel of the Python module from SOURCE in DIR, installs it into a
# virtual environment there, without a network, and tests it.
#
# Exit status 77: something that it needs is missing (Debian: python3-dev python3-numpy python3-pip
# python3-pybind11 python3-pytest python3-setuptools).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-/usr/bin/python3}
if ! "$python" -c 'import setuptools, pip, pybind11, numpy, pytest' 2>/dev/null; then
  echo "Skipped: $python lacks one of setuptools, pip, pybind11, numpy, pytest"
  exit 77
fi
# Built in a copy, since setuptools writes beside its sources. It takes longer to compile than to run.
rm -rf "$1"
mkdir -p "$1/source/examples/segment_mesh"
cp -r "$2/include" "$1/source/"
cp -r "$2/examples/python" "$1/source/examples/"
cp -r "$2/examples/segment_mesh/soup" "$2/examples/segment_mesh/segmentation" "$1/source/examples/segment_mesh/"
CFLAGS="-O1 -g0" "$python" -m pip wheel --quiet --no-build-isolation --no-deps --no-index -w "$1" \
  "$1/source/examples/python"
"$python" -m venv --without-pip --system-site-packages "$1/venv"
"$python" -m pip --python "$1/venv/bin/python" install --quiet --no-deps --no-index \
  "$1"/region_segmentation-*.whl
PYTHONDONTWRITEBYTECODE=1 "$1/venv/bin/python" -m pytest -q -p no:cacheprovider "$here"
