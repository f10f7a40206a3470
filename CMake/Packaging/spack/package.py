# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spack's recipe: `spack dev-build godrays@0.2.0` in the top folder, if Spack has this file."""

from spack.package import *


class Godrays(CMakePackage):
    """God rays and light-scattering media for VTK scenes: libraries, a Python package and a program."""

    license("BSD-3-Clause")

    version("0.2.0")

    variant("python", default=True, description="Build the Python package")
    variant("program", default=True, description="Build the program godrays")
    variant("exr", default=True, description="Write OpenEXR files")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("vtk@9.1:+opengl2")
    depends_on("vtk+python", when="+python")
    depends_on("python", type=("build", "link", "run"), when="+python")
    depends_on("py-numpy", type="run", when="+python")
    depends_on("glm")
    depends_on("highway")
    depends_on("cli11", when="+program")
    depends_on("openexr@3:", when="+exr")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("GODRAYS_BUILD_TESTING", False),
            self.define("GODRAYS_BUILD_PARAVIEW_PLUGIN", False),
            self.define("CMAKE_DISABLE_FIND_PACKAGE_OpenEXR", not self.spec.satisfies("+exr")),
            self.define_from_variant("GODRAYS_WRAP_PYTHON", "python"),
            self.define_from_variant("GODRAYS_BUILD_EXAMPLES", "program"),
        ]

    def setup_run_environment(self, env):
        if self.spec.satisfies("+python"):
            env.prepend_path("PYTHONPATH", join_path(self.prefix, "lib", "python3", "dist-packages"))
