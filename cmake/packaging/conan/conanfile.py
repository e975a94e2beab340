# SPDX-License-Identifier: GPL-3.0-or-later
"""The headers as a Conan 2 package, from the tree that this file lies in."""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy
from conan.tools.layout import basic_layout

required_conan_version = ">=2.0"


class RegionSegmentationConan(ConanFile):
    name = "cgal-region-segmentation"
    version = "1.0.0"
    description = "Segments surface meshes into the parts that people see, or the faces of a machine part"
    license = "LGPL-3.0-or-later"
    topics = ("mesh", "segmentation", "geometry", "cgal", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..", "..")
        copy(self, "include/*", root, self.export_sources_folder)
        copy(self, "LICENSE", root, self.export_sources_folder)

    def layout(self):
        basic_layout(self)

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)
        self.requires("boost/[>=1.74]", transitive_headers=True)
        self.requires("eigen/[>=3.4]", transitive_headers=True)

    def package_id(self):
        self.info.clear()

    def validate(self):
        check_min_cppstd(self, 17)

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "include/*", self.source_folder, self.package_folder)

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "CGAL_Region_segmentation")
        self.cpp_info.set_property("cmake_target_name", "CGAL::Region_segmentation")
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        if str(self.settings.compiler) in ("gcc", "clang", "apple-clang"):
            self.cpp_info.cxxflags = ["-ffp-contract=off"]  # labels do not depend on the processor
