# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways in which projects look for the installed package, and what they are told where that cannot be.

GODRAYS_PREFIX is where it is installed, GODRAYS_VTK_DIR its VTK, GODRAYS_CMAKE cmake.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PREFIX = pathlib.Path(os.environ["GODRAYS_PREFIX"])
VTK = os.environ["GODRAYS_VTK_DIR"]
CMAKE = os.environ["GODRAYS_CMAKE"]
ENVIRONMENT = {**os.environ, "LC_ALL": "C"}
ENVIRONMENT.pop("CMAKE_PREFIX_PATH", None)
FLAGS = "-Wall -Wextra -Wpedantic -Werror"
# A class of each target
PROGRAM = """
#include <vtkGodRaysPass.h>
#include <vtkGodRaysSkySource.h>
#include <vtkGodRaysTerrainSource.h>
#include <vtkNew.h>
int main()
{
  vtkNew<vtkGodRaysPass> pass;
  vtkNew<vtkGodRaysSkySource> sky;
  vtkNew<vtkGodRaysTerrainSource> terrain;
  return pass->GetClassName() && sky->GetClassName() && terrain->GetClassName() ? 0 : 1;
}
"""
TARGET = """
add_executable(program {folder}main.cxx)
target_link_libraries(program PRIVATE GodRays::Rendering GodRays::Filters GodRays::Sources)
"""


class Uses(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "main.cxx").write_text(PROGRAM)

    def run_cmake(self, *arguments):
        return subprocess.run(
            [CMAKE, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            timeout=600, env=ENVIRONMENT)

    def configure(self, text, *options, languages="C CXX", prefix=PREFIX, vtk=VTK):
        head = f"cmake_minimum_required(VERSION 3.16)\nproject(uses LANGUAGES {languages})\n"
        (self.folder / "CMakeLists.txt").write_text(head + text)
        return self.run_cmake(
            "-S", self.folder, "-B", self.folder / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
            f"-DVTK_DIR={vtk}", *options)

    def write_vtk(self, text):
        """A package VTK of any version, which is nothing else than this; its folder."""
        folder = self.folder / "vtk"
        folder.mkdir()
        (folder / "VTKConfig.cmake").write_text(text)
        (folder / "VTKConfigVersion.cmake").write_text(
            "set(PACKAGE_VERSION 9.99.0)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
        return folder

    def builds(self, text, *options, **arguments):
        """Configure without a warning, build and run."""
        done = self.configure(text, *options, **arguments)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotRegex(done.stdout, r"CMake Warning[^\n]*GodRays")
        done = self.run_cmake("--build", self.folder / "build")
        self.assertEqual(done.returncode, 0, done.stdout)
        done = subprocess.run([self.folder / "build" / "program"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def fails(self, text, *options, says, **arguments):
        """Configuring ends with one error that says these words."""
        done = self.configure(text, *options, **arguments)
        self.assertNotEqual(done.returncode, 0, done.stdout)
        self.assertEqual(len(re.findall(r"^CMake Error", done.stdout, re.M)), 1, done.stdout)
        told = " ".join(done.stdout.split())
        for words in says:
            self.assertIn(words, told)

    def test_from_a_subdirectory(self):
        (self.folder / "part").mkdir()
        (self.folder / "part" / "CMakeLists.txt").write_text(
            "find_package(GodRays REQUIRED)\n" + TARGET.format(folder="../")
            + 'set_target_properties(program PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")\n')
        self.builds("add_subdirectory(part)\n")

    def test_twice_and_in_a_subdirectory_as_well(self):
        (self.folder / "part").mkdir()
        (self.folder / "part" / "CMakeLists.txt").write_text("find_package(GodRays REQUIRED)\n")
        self.builds(
            "find_package(GodRays REQUIRED)\nfind_package(GodRays REQUIRED)\nadd_subdirectory(part)\n"
            + TARGET.format(folder=""))

    def test_components(self):
        self.builds(
            "find_package(GodRays REQUIRED COMPONENTS Rendering Filters Sources)\n" + TARGET.format(folder=""))

    def test_a_component_that_is_not_there(self):
        self.fails(
            "find_package(GodRays REQUIRED COMPONENTS Rendering Wings)\n",
            says=["Wings", "Filters", "Rendering", "Sources"])
        done = self.configure(
            "find_package(GodRays REQUIRED COMPONENTS Rendering OPTIONAL_COMPONENTS Wings)\n"
            'message(STATUS "wings: ${GodRays_Wings_FOUND}, rendering: ${GodRays_Rendering_FOUND}")\n')
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("wings: FALSE, rendering: TRUE", done.stdout)

    def test_cxx20_and_static_libraries_of_its_own(self):
        self.builds(
            "find_package(GodRays 0.2 REQUIRED)\n" + TARGET.format(folder=""), "-DCMAKE_CXX_STANDARD=20",
            "-DCMAKE_CXX_STANDARD_REQUIRED=ON", "-DBUILD_SHARED_LIBS=OFF", f"-DCMAKE_CXX_FLAGS={FLAGS}")

    def test_shared_libraries_of_its_own(self):
        self.builds(
            "find_package(GodRays REQUIRED)\nadd_library(own own.cxx)\n"
            "target_link_libraries(own PUBLIC GodRays::Rendering GodRays::Filters GodRays::Sources)\n"
            "add_executable(program main.cxx)\ntarget_link_libraries(program PRIVATE own)\n"
            'file(WRITE "${CMAKE_CURRENT_SOURCE_DIR}/own.cxx" "int own() { return 0; }\\n")\n',
            "-DBUILD_SHARED_LIBS=ON")

    def test_the_standard_is_asked_for(self):
        """A compiler whose default is older has C++17 without a word of the project's."""
        done = self.configure(
            "find_package(GodRays REQUIRED)\nset(CMAKE_CXX_STANDARD 14)\n" + TARGET.format(folder=""),
            "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
        self.assertEqual(done.returncode, 0, done.stdout)
        commands = (self.folder / "build" / "compile_commands.json").read_text()
        self.assertRegex(commands, r"-std=(gnu|c)\+\+17")

    def test_autoinit_of_all_modules(self):
        self.builds(
            "find_package(GodRays REQUIRED)\nfind_package(VTK REQUIRED COMPONENTS RenderingOpenGL2)\n"
            + TARGET.format(folder="")
            + "vtk_module_autoinit(TARGETS program MODULES GodRays::Rendering GodRays::Filters\n"
            "  GodRays::Sources VTK::RenderingOpenGL2)\n")

    def test_vtk_looked_for_before(self):
        self.builds(
            "find_package(VTK REQUIRED COMPONENTS CommonCore)\nfind_package(GodRays REQUIRED)\n"
            + TARGET.format(folder=""))

    def test_a_prefix_that_was_moved(self):
        moved = self.folder / "a b" / "moved"
        shutil.copytree(PREFIX, moved, symlinks=True)
        package = "\n".join(
            path.read_text() for path in (moved / "lib").rglob("cmake/GodRays/*.cmake"))
        self.assertNotIn(str(PREFIX), package)
        self.builds("find_package(GodRays REQUIRED)\n" + TARGET.format(folder=""), prefix=moved)

    def test_as_if_for_another_machine(self):
        """Packages are looked for below two roots alone, and there is no pkg-config."""
        self.builds(
            "find_package(GodRays REQUIRED)\n" + TARGET.format(folder=""), "-DCMAKE_SYSTEM_NAME=Linux",
            f"-DCMAKE_FIND_ROOT_PATH={PREFIX};/", "-DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY",
            "-DPKG_CONFIG_EXECUTABLE=PKG_CONFIG_EXECUTABLE-NOTFOUND", prefix="")

    def test_a_version_that_is_too_new(self):
        self.fails("find_package(GodRays 99 REQUIRED)\n", says=["GodRays", '"99"', "version: 0."])

    def test_no_c(self):
        self.fails("find_package(GodRays REQUIRED)\n", languages="CXX", says=["LANGUAGES C CXX"])

    def test_a_vtk_that_lacks_a_module(self):
        """As one that was built without it says it."""
        other = self.write_vtk(
            'set(VTK_FOUND 0)\nset(VTK_NOT_FOUND_MESSAGE "Could not find the VTK package with the following '
            'required components: RenderingOpenGL2.")\n')
        self.fails(
            "find_package(GodRays REQUIRED)\n", vtk=other, says=["GodRays", "RenderingOpenGL2"])

    def test_a_vtk_of_another_version(self):
        other = self.write_vtk(
            "set(VTK_FOUND 1)\nset(VTK_VERSION 9.99.0)\nset(VTK_MAJOR_VERSION 9)\nset(VTK_MINOR_VERSION 99)\n")
        self.fails("find_package(GodRays REQUIRED)\n", vtk=other, says=["was built for VTK", "9.99.0"])

    def test_each_header_alone(self):
        """Each compiles by itself and twice, with all warnings, not as a header of the system. Those of the
        plugin, if it was built, need ParaView."""
        plugin = {path.name for path in (pathlib.Path(__file__).parents[2] / "Plugin").rglob("*.h")}
        headers = sorted({path.name for path in (PREFIX / "include" / "godrays").glob("*.h")} - plugin)
        self.assertGreater(len(headers), 30)
        for header in headers:
            (self.folder / f"{header}.cxx").write_text(f"#include <{header}>\n#include <{header}>\n")
        done = self.configure(
            "find_package(GodRays REQUIRED)\nset(CMAKE_NO_SYSTEM_FROM_IMPORTED ON)\n"
            f"add_library(headers OBJECT {' '.join(h + '.cxx' for h in headers)})\n"
            "target_link_libraries(headers PRIVATE GodRays::Rendering GodRays::Filters GodRays::Sources)\n",
            f"-DCMAKE_CXX_FLAGS={FLAGS.replace('-Werror', '')}")
        self.assertEqual(done.returncode, 0, done.stdout)
        done = self.run_cmake("--build", self.folder / "build", "--", "-k", "0")
        self.assertEqual(done.returncode, 0, done.stdout[-6000:])
        # VTK's own style: a semicolon after vtkTypeMacro(), which VTK 9.1 ends with a function
        told = [line for line in done.stdout.splitlines() if "warning:" in line and "/godrays/" in line]
        self.assertEqual([line for line in told if "extra ';'" not in line], [])


if __name__ == "__main__":
    unittest.main()
