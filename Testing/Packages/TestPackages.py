# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Debian packages as CPack makes them, unpacked into an empty folder: program, module and a project run from there.

The project is that of Documentation/Installation.md, as it stands there. With GODRAYS_LONG in the environment, a
bare Debian of the same suite installs them, too, in a root that CMake/debian-root.sh makes.
"""

import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["GODRAYS_BUILD"])
VERSION = re.search(r"VERSION ([\d.]+)\n", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
LIBRARY = "libgodrays" + VERSION.rpartition(".")[0]
FOLDER = BUILD / "Testing" / "Packages"  # for all that is made here
TREE = FOLDER / "root"
ENVIRONMENT = {name: value for name, value in os.environ.items()
    if name not in ("PYTHONPATH", "LD_LIBRARY_PATH", "CMAKE_PREFIX_PATH")}


def run(*command, cwd=FOLDER, **environment):
    """Run a command, and return what it printed."""
    ran = subprocess.run(list(map(str, command)), cwd=cwd, env={**ENVIRONMENT, **environment}, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if ran.returncode:
        raise AssertionError(f"{' '.join(map(str, command))} returned {ran.returncode}:\n{ran.stdout}")
    return ran.stdout


def read_png(path):
    """(width, height, number of different bytes) of a PNG."""
    data = path.read_bytes()
    width, height = struct.unpack(">II", data[16:24])
    packed = b"".join(data[m.end() : m.end() + struct.unpack(">I", data[m.start() - 4 : m.start()])[0]]
        for m in re.finditer(b"IDAT", data))
    return width, height, len(set(zlib.decompress(packed)))


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        TREE.mkdir(parents=True)
        for old in (BUILD / "packages").glob("*.deb"):
            old.unlink()
        run(os.environ["GODRAYS_CPACK"], "--config", BUILD / "CPackConfig.cmake")
        cls.packages = {path.name.split("_")[0]: path for path in (BUILD / "packages").glob("*.deb")}
        for path in cls.packages.values():
            run("dpkg-deb", "-x", path, TREE)

    def field(self, package, name):
        return run("dpkg-deb", "-f", self.packages[package], name).strip()

    def files(self, package):
        lines = run("dpkg-deb", "-c", self.packages[package]).splitlines()
        return [line.split()[5][2:] for line in lines if not line.startswith("d")]

    def test_names_and_contents(self):
        self.assertEqual(set(self.packages), {LIBRARY, "libgodrays-dev", "python3-godrays", "godrays"})
        holds = {
            LIBRARY: [r"lib/.*libvtkGodRays\w+\.so\.[\d.]+"],
            "libgodrays-dev": [r"include/godrays/\w+\.(h|txx)", r"lib/.*libvtkGodRays\w+\.so",
                r"lib/.*cmake/GodRays/[\w-]+\.cmake", r"lib/.*hierarchy/GodRays/[\w-]+\.txt",
                r"share/doc/GodRays/LICENSE"],
            "python3-godrays": [r"lib/python3/dist-packages/godrays(-[\d.]+\.dist-info)?/[\w.]+"],
            "godrays": [r"bin/godrays", r"share/(?!doc).*"],
        }
        all_files = []
        for package, patterns in holds.items():
            files = [name for name in self.files(package) if name != f"usr/share/doc/{package}/copyright"]
            self.assertEqual(len(files), len(self.files(package)) - 1, "no copyright")
            for name in files:
                self.assertTrue(any(re.fullmatch("usr/" + each, name) for each in patterns), (package, name))
            all_files += files
        self.assertEqual(len(all_files), len(set(all_files)), "a file in two packages")
        for needed in ("vtkGodRaysPass.h", "vtkGodRaysScatteringFilter.h", "GodRaysConfig.cmake", "METADATA",
                "__main__.py", "vtkGodRaysRendering.so", "bin/godrays"):
            self.assertEqual(sum(name.endswith("/" + needed) for name in all_files), 1, needed)

    def test_control_fields(self):
        vtk = re.compile(r"\blibvtk9[.\w]* \(")
        for package in self.packages:
            self.assertEqual(self.field(package, "Version"), f"{VERSION}-1")
            self.assertEqual(self.field(package, "Architecture"), run("dpkg", "--print-architecture").strip())
            self.assertIn("god rays for VTK scenes: ", self.field(package, "Description"))
            depends = self.field(package, "Depends")
            if package == LIBRARY:
                self.assertRegex(depends, vtk)
                self.assertNotIn("python", depends)
                continue
            self.assertRegex(depends, rf"{re.escape(LIBRARY)} \(= {VERSION}-1\)")
            if package == "libgodrays-dev":
                self.assertIn("libvtk9-dev", depends)
            else:
                self.assertRegex(depends, vtk)
        self.assertIn("python3-vtk9", self.field("python3-godrays", "Depends"))
        self.assertNotIn("python", self.field("godrays", "Depends"))

    def test_apt_can_install_them(self):
        done = run("apt-get", "install", "--simulate", "--no-install-recommends", *self.packages.values())
        for package in self.packages:
            self.assertIn(f"Inst {package} ", done)

    @unittest.skipUnless("GODRAYS_LONG" in os.environ, "GODRAYS_LONG is not set")
    def test_a_bare_debian_installs_and_runs_them(self):
        release = pathlib.Path("/etc/os-release").read_text(encoding="utf-8")
        suite = re.search(r"VERSION_CODENAME=(\w+)", release)[1]
        packages = ROOT / f"build-{suite}" / "build" / "packages"  # /godrays/build/packages, in that root
        shutil.rmtree(packages, ignore_errors=True)
        packages.mkdir(parents=True)
        for name, path in self.packages.items():
            if name != "libgodrays-dev":  # which brings some gigabytes of VTK's
                shutil.copy(path, packages)
        said = run("bash", "CMake/debian-root.sh", suite, "bash", "-ec", """
            export DEBIAN_FRONTEND=noninteractive
            apt-get -q update
            apt-get -q install -y --no-install-recommends ./build/packages/*.deb xvfb xauth libgl1-mesa-dri
            cd /
            godrays --version
            xvfb-run -a -s "-screen 0 1280x1024x24" python3 -c "
import godrays
from vtkmodules.vtkFiltersSources import vtkConeSource
picture = godrays.render(vtkConeSource(), (80, 60))
print(godrays.__file__, picture.shape, picture.std() > 5)"
            """, cwd=ROOT)
        self.assertIn(f"godrays {VERSION}", said)
        self.assertIn("/usr/lib/python3/dist-packages/godrays/__init__.py (60, 80, 3) True", said)

    def test_the_program_runs_from_there(self):
        program = TREE / "usr/bin/godrays"
        self.assertIn(VERSION, run(program, "--version", cwd="/"))
        libraries = re.findall(r"libvtkGodRays\S+ => (.+) \(0x", run("ldd", program))
        self.assertEqual(len(libraries), len([each for each in libraries if each.startswith(str(TREE))]))
        self.assertGreaterEqual(len(libraries), 2)
        model = FOLDER / "triangle.obj"
        model.write_text("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n", encoding="utf-8")
        run(program, model, "--size", "120x90", "--output", FOLDER / "program.png", cwd="/")
        width, height, levels = read_png(FOLDER / "program.png")
        self.assertEqual((width, height), (120, 90))
        self.assertGreater(levels, 40)

    def test_the_module_runs_from_there(self):
        python = TREE / "usr/lib/python3/dist-packages"
        code = ("import importlib.metadata, godrays; from vtkmodules.vtkFiltersSources import vtkConeSource\n"
            "picture = godrays.render(vtkConeSource(), (80, 60))\n"
            "print(godrays.__file__, importlib.metadata.version('godrays'), picture.shape, picture.std() > 5)")
        said = run(sys.executable, "-c", code, cwd="/", PYTHONPATH=str(python))
        self.assertRegex(said, rf"{re.escape(str(TREE))}\S* [\d.]+ \(60, 80, 3\) True")
        self.assertIn(VERSION, run(sys.executable, "-m", "godrays", "--version", cwd="/", PYTHONPATH=str(python)))

    def test_a_project_is_built_with_them(self):
        text = (ROOT / "Documentation" / "Installation.md").read_text(encoding="utf-8")
        project = FOLDER / "project"
        project.mkdir()
        for language, name in (("cmake", "CMakeLists.txt"), ("cpp", "main.cxx")):
            (code,) = re.findall(rf"```{language}\n(.*?)```", text, re.S)
            (project / name).write_text(code, encoding="utf-8")
        cmake = os.environ["GODRAYS_CMAKE"]
        run(cmake, "-G", "Ninja", "-S", project, "-B", project / "build",
            f"-DCMAKE_PREFIX_PATH={TREE}/usr", f"-DVTK_DIR={os.environ['GODRAYS_VTK_DIR']}",
            f"-DCMAKE_CXX_COMPILER_LAUNCHER={os.environ.get('GODRAYS_LAUNCHER', '')}")
        run(cmake, "--build", project / "build")
        run(project / "build" / "program", cwd=project)
        width, height, levels = read_png(project / "picture.png")
        self.assertEqual((width, height), (1280, 720))
        self.assertGreater(levels, 40)
        self.assertIn(str(TREE), run("ldd", project / "build" / "program"))


if __name__ == "__main__":
    unittest.main()
