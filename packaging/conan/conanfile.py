"""Canvoy for Conan 2, from a checkout of the sources: conan create packaging/conan -s compiler.cppstd=20"""

import pathlib
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load
from conan.tools.gnu import PkgConfigDeps

SOURCES = ("CMakeLists.txt", "LICENSE", "cmake/*", "canvoy/*")


class Canvoy(ConanFile):
    name = "canvoy"
    description = "CANopen application layer and device profiles in C++20: a library, a simulator and tools"
    license = "Apache-2.0"
    url = homepage = "https://github.com/canvoy/canvoy"
    topics = ("canopen", "can", "cia-301", "embedded", "simulation")
    settings = "os", "arch", "compiler", "build_type"
    package_type = "static-library"
    options = {"formats": [True, False]}  # data sheets, logs and words: built on libraries of others
    default_options = {"formats": False}

    def _root(self):
        return pathlib.Path(self.recipe_folder).resolve().parents[1]

    def set_version(self):
        self.version = re.search(r"project\(canvoy VERSION ([\d.]+)", load(self, self._root() / "CMakeLists.txt"))[1]

    def export_sources(self):
        for pattern in SOURCES:
            copy(self, pattern, src=self._root(), dst=self.export_sources_folder, excludes="*/node_modules/*")

    def requirements(self):
        if self.options.formats:
            for each in ("fmt/[>=9 <12]", "libzip/[>=1.7 <2]", "nlohmann_json/[>=3.11 <4]", "pugixml/[>=1.13 <2]", "sqlite3/[>=3.36 <4]",
                         "zlib/[>=1.2.11 <2]"):
                self.requires(each, transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({"CANVOY_TESTS": False, "CANVOY_TOOLS": False, "CANVOY_FORMATS": bool(self.options.formats),
                                          "CANVOY_WARNINGS_AS_ERRORS": False})  # fmt: skip
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # canvoyConfig.cmake is that of the package itself.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/canvoy"]
