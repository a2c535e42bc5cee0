# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The libraries of taut for Conan 2, from the tree that this file lies in:

conan create packaging/conan -s compiler.cppstd=20 --build=missing
"""
import re
from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir
from conan.tools.gnu import PkgConfigDeps
from conan.tools.scm import Version

required_conan_version = ">=2.0"

# What docs/compatibility.md promises.
LEAST_COMPILERS = {"gcc": "12", "clang": "14"}


class Taut(ConanFile):
    name = "taut"
    description = "Unstressed lengths of a tensioned cable net from one survey"
    license = "MIT"
    author = "The taut authors"
    topics = ("cable-nets", "parameter-identification", "gaussian-processes", "surveying")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {
        "shared": [True, False],
        "fPIC": [True, False],
        "with_conic": [True, False],  # Clarabel: takes cargo 1.71 or later, and its crates
    }
    default_options = {
        "shared": False,
        "fPIC": True,
        "with_conic": False,
        "boost/*:header_only": True,
        "hdf5/*:enable_cxx": False,
        "hdf5/*:hl": False,
        "openblas/*:build_lapack": True,
    }
    implements = ["auto_shared_fpic"]

    @property
    def _root(self):
        return Path(self.recipe_folder).parent.parent

    def set_version(self):
        lists = load(self, self._root / "CMakeLists.txt")
        self.version = re.search(r"project\(taut VERSION ([0-9.]+)", lists).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "extern/*", "include/*", "packaging/*", "src/*"):
            copy(self, pattern, self._root, self.export_sources_folder, excludes="*/target/*")

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("eigen/[>=3.4 <6]", transitive_headers=True)
        self.requires("hdf5/[>=1.10 <2]")
        self.requires("nlopt/[>=2.7 <3]")
        self.requires("onetbb/[>=2021 <2023]")
        self.requires("openblas/[>=0.3.20 <1]")
        self.requires("pugixml/[>=1.13 <2]")
        # Headers that only the sources include: nobody who links taut needs them.
        self.requires("boost/[>=1.74 <2]", visible=False)
        self.requires("fmt/[>=9 <12]")
        self.requires("fast_float/[>=3.9 <9]", visible=False)
        self.requires("nlohmann_json/[>=3.11 <4]", visible=False)
        self.requires("valijson/[>=1.0 <2]", visible=False)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25 <5]")
        if not self.conf.get("tools.gnu:pkg_config", check_type=str):
            self.tool_requires("pkgconf/[>=2 <3]")

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration("taut is built and tested on Linux alone")
        check_min_cppstd(self, 20)
        compiler = str(self.settings.compiler)
        least = LEAST_COMPILERS.get(compiler)
        if least and Version(self.settings.compiler.version) < least:
            raise ConanInvalidConfiguration(f"taut needs {compiler} {least} or later")

    def generate(self):
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["TAUT_INSTALL"] = True
        toolchain.cache_variables["TAUT_WITH_METIS"] = False
        toolchain.cache_variables["TAUT_WITH_XLSX"] = False
        toolchain.cache_variables["TAUT_WITH_CLARABEL"] = "ON" if self.options.with_conic else "OFF"
        for part in ("APP", "BENCHMARKS", "C", "EXAMPLES", "TESTS", "VIEWER"):
            toolchain.cache_variables[f"TAUT_BUILD_{part}"] = False
        # CMake finds BLAS and LAPACK by modules of its own, which ask pkg-config for Conan's.
        toolchain.cache_variables["BLA_PREFER_PKGCONFIG"] = True
        toolchain.cache_variables["BLA_PKGCONFIG_BLAS"] = "openblas"
        toolchain.cache_variables["BLA_PKGCONFIG_LAPACK"] = "openblas"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")
        # Conan makes files of its own for CMake and pkg-config.
        rmdir(self, Path(self.package_folder) / "lib" / "cmake")
        rmdir(self, Path(self.package_folder) / "lib" / "pkgconfig")

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "taut")
        self.cpp_info.set_property("cmake_target_name", "taut::taut")
        self.cpp_info.set_property("pkg_config_name", "taut")

        # Each library with the one before it, and what its own sources are linked with.
        before = None
        for name, own in {
            "core": ["fmt::fmt", "nlopt::nlopt", "onetbb::onetbb", "openblas::openblas"],
            "adjustment": ["onetbb::onetbb"],
            "io": ["hdf5::hdf5", "pugixml::pugixml"],
            "report": [],
        }.items():
            component = self.cpp_info.components[name]
            component.set_property("cmake_target_name", f"taut::{name}")
            component.set_property("pkg_config_name", f"taut-{name}")
            component.libs = [f"taut_{name}"]
            component.requires = ([before] if before else ["eigen::eigen"]) + own
            if not self.options.shared:
                component.defines = [f"TAUT_{name.upper()}_STATIC_DEFINE"]
                component.system_libs = ["m", "pthread"]
            before = name

        # As src/CMakeLists.txt has them: docs/linking.md, "What may differ between the program and taut".
        self.cpp_info.components["core"].defines += [
            "EIGEN_MAX_ALIGN_BYTES=16",
            "EIGEN_MAX_STATIC_ALIGN_BYTES=16",
            "EIGEN_MALLOC_ALREADY_ALIGNED=1",
        ]
        if self.options.with_conic and not self.options.shared:
            self.cpp_info.components["adjustment"].libs.append("clarabel_c")
            self.cpp_info.components["adjustment"].system_libs.append("dl")
