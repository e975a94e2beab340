#!/bin/sh
# run.sh DIR SOURCE: makes a source distribution of the Python package from SOURCE in DIR, installs it into
# a virtual environment there, without a network, and tests it.
#
# Exit status 77: something that it needs is missing (Debian: python3-dev python3-hypothesis python3-numpy
# python3-pip python3-pybind11 python3-pytest python3-setuptools).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-/usr/bin/python3}
if ! "$python" -c 'import setuptools, pip, pybind11, numpy, pytest, hypothesis' 2>/dev/null; then
  echo "Skipped: $python lacks one of setuptools, pip, pybind11, numpy, pytest, hypothesis"
  exit 77
fi
rm -rf "$1"
mkdir -p "$1"
cd "$2/examples/python"
"$python" setup.py --quiet egg_info --egg-base "$1" sdist --dist-dir "$1"
"$python" -m venv --without-pip --system-site-packages "$1/venv"
# -O1: it takes longer to compile than to run. GCC appends the headers that it reads to a file.
SUNPRO_DEPENDENCIES="$1/headers" CFLAGS="-O1 -g0" "$python" -m pip --python "$1/venv/bin/python" install --quiet --no-build-isolation \
  --no-deps --no-index "$1"/region-segmentation-*.tar.gz
cd "$1"
if tr -s ' \\' '\n' <headers | grep '^/.*/CGAL/' | grep -v Region_segmentation | sort -u | xargs grep -l 'SPDX-License-Identifier: GPL'; then
  echo "The package is LGPL, and these headers are GPL" >&2
  exit 1
fi
PYTHONDONTWRITEBYTECODE=1 "$1/venv/bin/python" -m pytest -q -p no:cacheprovider "$here"
