# SPDX-License-Identifier: LGPL-3.0-or-later

import os
import shutil

from pybind11.setup_helpers import Pybind11Extension
from setuptools import setup
from setuptools.command.sdist import sdist

here = os.path.dirname(os.path.abspath(__file__))
# What lies outside this folder in a checkout, and in it in a source distribution.
program = "examples/segment_mesh/"
outside = ["include", program + "segmentation", program + "soup", program + "view/segment_colors.h", "LICENSE"]
root = here if os.path.exists(os.path.join(here, "include")) else os.path.join(here, "..", "..")
# For other machines than this one: without TBB, and with the C++ library linked in.
portable = os.environ.get("REGION_SEGMENTATION_PORTABLE") == "1"
static_library = ["-static-libstdc++", "-Wl,--exclude-libs,ALL", "-Wl,--gc-sections", "-s"]


class Sdist(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for path in outside:
            copy = shutil.copytree if os.path.isdir(os.path.join(root, path)) else shutil.copy
            os.makedirs(os.path.dirname(os.path.join(base_dir, path)), exist_ok=True)
            copy(os.path.join(root, path), os.path.join(base_dir, path))


setup(
    cmdclass={"sdist": Sdist},
    packages=["region_segmentation"],
    package_data={"region_segmentation": ["py.typed", "_core.pyi"]},
    ext_modules=[
        Pybind11Extension(
            "region_segmentation._core",
            ["core.cpp", "segments.cpp"],
            depends=["core.h"],
            include_dirs=[
                os.path.join(root, "include"),
                os.path.join(root, "examples", "segment_mesh"),
                os.environ.get("EIGEN3_INCLUDE_DIR", "/usr/include/eigen3"),
            ],
            libraries=[] if portable else ["tbb"],
            define_macros=[("NDEBUG", None), ("CGAL_DISABLE_GMP", None), ("CGAL_NO_GMP", None)]
            + ([] if portable else [("CGAL_LINKED_WITH_TBB", None)]),
            extra_link_args=static_library if portable else [],
            extra_compile_args=["-ffp-contract=off"],
            cxx_std=17,
        )
    ],
)
