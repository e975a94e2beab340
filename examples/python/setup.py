# SPDX-License-Identifier: GPL-3.0-or-later

import os

from pybind11.setup_helpers import Pybind11Extension
from setuptools import setup

folder = os.path.dirname(os.path.abspath(__file__))
library = os.path.join(folder, "..", "..", "include")

setup(
    packages=["region_segmentation-stubs"],
    package_data={"region_segmentation-stubs": ["*.pyi"]},
    ext_modules=[
        Pybind11Extension(
            "region_segmentation",
            [
                "region_segmentation.cpp",
                "Soup.cpp",
                "describe.cpp",
                "../segment_mesh/segmentation/make_manifold.cpp",
                "../segment_mesh/soup/link_corners.cpp",
            ],
            include_dirs=[os.path.relpath(library, folder), "../segment_mesh", "/usr/include/eigen3"],
            libraries=["gmp", "mpfr"],
            define_macros=[("NDEBUG", None)],
            extra_compile_args=["-ffp-contract=off"],
            cxx_std=17,
        )
    ]
)
