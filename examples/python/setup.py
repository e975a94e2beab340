# SPDX-License-Identifier: GPL-3.0-or-later

import os
import shutil

from pybind11.setup_helpers import Pybind11Extension
from setuptools import setup
from setuptools.command.sdist import sdist

here = os.path.dirname(os.path.abspath(__file__))
# What lies outside this folder in a checkout, and in it in a source distribution.
outside = ["include", "examples/segment_mesh/segmentation", "examples/segment_mesh/soup", "LICENSE"]
root = here if os.path.exists(os.path.join(here, "include")) else os.path.join(here, "..", "..")


class Sdist(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for path in outside:
            copy = shutil.copytree if os.path.isdir(os.path.join(root, path)) else shutil.copy
            copy(os.path.join(root, path), os.path.join(base_dir, path))


setup(
    cmdclass={"sdist": Sdist},
    packages=["region_segmentation"],
    package_data={"region_segmentation": ["py.typed"]},
    ext_modules=[
        Pybind11Extension(
            "region_segmentation._core",
            ["core.cpp", "segments.cpp"],
            depends=["core.h"],
            include_dirs=[
                os.path.join(root, "include"),
                os.path.join(root, "examples", "segment_mesh"),
                "/usr/include/eigen3",
            ],
            libraries=["gmp", "mpfr", "tbb"],
            define_macros=[("NDEBUG", None), ("CGAL_LINKED_WITH_TBB", None)],
            extra_compile_args=["-ffp-contract=off"],
            cxx_std=17,
        )
    ],
)
