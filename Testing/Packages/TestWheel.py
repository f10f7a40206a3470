# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wheels by pyproject.toml, without a network: built against an SDK as VTK publishes it, repaired, installed, run.

The SDK is made of the system's VTK: a package for Python in which scikit-build-core finds CMake's files. cvista,
PyVista's fork of VTK, is the same VTK under that name. Needs scikit-build-core, auditwheel and PyVista 0.48.
"""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import time
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ["GODRAYS_BUILD"]) / "Testing" / "Wheel"
TREE = ROOT / "build-wheel"  # beside build: the compiler's cache has what was compiled there
VTK_DIR = pathlib.Path(os.environ["GODRAYS_VTK_DIR"])
BUILD_TYPE = os.environ["GODRAYS_BUILD_TYPE"]
FLAGS = os.environ["GODRAYS_CXX_FLAGS"]
ENVIRONMENT = {name: value for name, value in os.environ.items()
    if name not in ("PYTHONPATH", "LD_LIBRARY_PATH", "CMAKE_PREFIX_PATH")}

for module in ("scikit_build_core", "auditwheel", "pyvista"):
    if not importlib.util.find_spec(module):
        print(f"SKIPPED: these tests need {module}")
        sys.exit(77)

CVISTA = '''
import importlib, importlib.abc, importlib.util, sys
class Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    def find_spec(self, name, path=None, target=None):
        return importlib.util.spec_from_loader(name, self) if name.startswith("cvista.") else None
    def create_module(self, spec):
        return importlib.import_module("vtkmodules" + spec.name[len("cvista"):])
    def exec_module(self, module):
        pass
sys.meta_path.insert(0, Finder())
'''
PYVISTA = "import pyvista; pyvista.vtk_backend = lambda: {!r}; "  # as PyVista 0.49 has it


def run(*command, fails=False):
    """Run a command, which has to end as it should, and return what it printed."""
    ran = subprocess.run(list(map(str, command)), cwd="/", env=ENVIRONMENT, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if bool(ran.returncode) != fails:
        raise AssertionError(f"{' '.join(map(str, command))} returned {ran.returncode}:\n{ran.stdout}")
    return ran.stdout


def make_environment(name):
    """Make a virtual environment that sees the system's packages; its Python and its own packages' folder."""
    run(sys.executable, "-m", "venv", "--system-site-packages", FOLDER / name)
    (packages,) = (FOLDER / name).glob("lib/python3*/site-packages")
    return FOLDER / name / "bin" / "python", packages


def make_sdk(packages, distribution, root):
    """Install the SDK of a distribution of VTK, whose package for Python is root."""
    sdk = packages / f"{distribution}_sdk"
    folder = sdk / VTK_DIR.relative_to("/usr")
    shutil.copytree(VTK_DIR, folder)
    (sdk / "__init__.py").touch()
    (sdk / "include").symlink_to("/usr/include")
    for path in VTK_DIR.parents[1].iterdir():  # libraries
        if path.name != "cmake":
            (folder.parents[1] / path.name).symlink_to(path)
    for path in folder.glob("*.cmake"):
        text = path.read_text(encoding="utf-8")
        text = re.sub(r"(?m)^get_filename_component\((_IMPORT_PREFIX|_vtk_module_import_prefix) .*\n", "", text)
        text = text.replace('set(_vtk_module_import_prefix "${CMAKE_CURRENT_LIST_DIR}")',
            'set(_vtk_module_import_prefix "/usr")')
        if path.name.endswith("-targets.cmake"):
            text = f'set(_IMPORT_PREFIX "/usr")\n{text}'
        text = text.replace('vtk_module_python_package" "vtkmodules"', f'vtk_module_python_package" "{root}"')
        path.write_text(text, encoding="utf-8")
    info = packages / f"{distribution}_sdk-1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {distribution}-sdk\nVersion: 1\n")
    (info / "entry_points.txt").write_text(f"[cmake.prefix]\n{distribution}_sdk = {distribution}_sdk\n")


def repair(wheel, folder):
    """Have auditwheel repair a wheel. It knows no C library as new as Debian's, so a copy of it is told of that."""
    copy = FOLDER / "auditwheel"
    if not copy.exists():
        shutil.copytree(pathlib.Path(importlib.util.find_spec("auditwheel").origin).parent, copy)
        policies = copy / "policy" / "manylinux-policy.json"
        newest = ", ".join(f'"2.{minor}"' for minor in range(42, 60))
        policies.write_text(policies.read_text(encoding="utf-8").replace('"2.41"', f'"2.41", {newest}'), encoding="utf-8")
    run("env", f"PYTHONPATH={FOLDER}", sys.executable, "-m", "auditwheel", "repair", "-w", folder, wheel,
        "--exclude", "libvtk*", "--exclude", "libtiff*")  # an SDK has a libvtktiff


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        cls.wheels = {}
        for distribution, root in (("vtk", "vtkmodules"), ("cvista", "cvista")):
            shutil.rmtree(TREE, ignore_errors=True)
            shutil.rmtree(FOLDER / "build", ignore_errors=True)  # one path for both: the compiler's cache has the first's
            python, packages = make_environment("build")
            make_sdk(packages, distribution, root)
            dist = FOLDER / distribution
            log = run(python, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation", "-w", dist, ROOT, "-v",
                "-C", f"build-dir={TREE}", "-C", f"cmake.build-type={BUILD_TYPE}",
                "-C", f"cmake.define.CMAKE_CXX_FLAGS_{BUILD_TYPE.upper()}={FLAGS}",
                "-C", "cmake.define.CMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON",  # where wheels are published, there is none
                "-C", "install.strip=true",  # as published wheels, which have no debug information
                "-C", "cmake.define.CMAKE_INSTALL_RPATH_USE_LINK_PATH=OFF")
            (FOLDER / f"{distribution}.log").write_text(log, encoding="utf-8")
            (wheel,) = dist.glob("*.whl")
            repair(wheel, dist / "repaired")
            (cls.wheels[distribution],) = (dist / "repaired").glob("*.whl")

    def install(self, distribution):
        python, packages = make_environment(f"run-{distribution}")
        run(python, "-m", "pip", "install", "--no-index", "--no-deps", self.wheels[distribution])
        if distribution == "cvista":
            (packages / "cvista").mkdir()
            (packages / "cvista" / "__init__.py").write_text(CVISTA, encoding="utf-8")
        return python, packages

    def test_what_a_wheel_holds(self):
        version = re.search(r"project\(GodRays VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        wheel = self.wheels["vtk"]
        self.assertRegex(wheel.name, rf"^godrays-{re.escape(version)}-cp3\d+-cp3\d+-\w+\.whl$")
        with zipfile.ZipFile(wheel) as held:
            names = held.namelist()
            (entries,) = [held.read(name).decode() for name in names if name.endswith("entry_points.txt")]
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB, {len(names)} files")
        self.assertLess(wheel.stat().st_size, 4e6)
        for needed in (r"godrays/__init__\.py", r"godrays/libvtkGodRaysFilters\.so", r"godrays/vtkGodRaysRendering\.so",
                r"godrays/vtkGodRaysRendering\.pyi", r"godrays/godrays", r"godrays-[\d.]+\.dist-info/licenses/LICENSE"):
            self.assertTrue(any(re.fullmatch(needed, name) for name in names), needed)
        self.assertFalse([name for name in names if not name.startswith(("godrays/", "godrays-", "godrays.libs/"))
            or re.search(r"libvtk[A-F]|\.(in|h|cmake)$", name)])
        for line in (ROOT / "Rendering/Python/entry_points.txt").read_text(encoding="utf-8").splitlines():
            self.assertIn(line, entries)  # CMake's installation tells the same

    def test_a_clean_environment_makes_a_picture(self):
        begun = time.monotonic()
        python, packages = self.install("vtk")
        print(run(python, ROOT / "Testing/Packages/wheel_picture.py", FOLDER / "picture.png"))
        print(f"installed, and a picture made, in {time.monotonic() - begun:.0f} s")
        self.assertLess(time.monotonic() - begun, 60)
        for program in ((python, "-m", "godrays"), (FOLDER / "run-vtk" / "bin" / "godrays",)):
            self.assertRegex(run(*program, "--version"), r"godrays \d")
        # Where VTK's wheel has its libraries, they are found there
        for library in pathlib.Path("/usr/lib").glob("*/libvtk*.so.*"):
            (packages / "vtkmodules").mkdir(exist_ok=True)
            (packages / "vtkmodules" / library.name).symlink_to(library)
        found = re.findall(r"libvtk(?!GodRays)\S+ => (\S+)", run("ldd", packages / "godrays" / "vtkGodRaysRendering.so"))
        ours = [path for path in found if pathlib.Path(path).is_relative_to(packages)]
        self.assertGreater(len(ours), 5, found)

    def test_pyvista_on_another_vtk_is_told_in_one_line(self):
        for distribution, other in (("vtk", "cvista"), ("cvista", "vtk")):
            with self.subTest(distribution):
                python, _ = self.install(distribution)
                own = PYVISTA.format(distribution)
                code = "import godrays; from vtkmodules.vtkFiltersSources import vtkConeSource; " \
                    "print(godrays.render(vtkConeSource(), (80, 60)).std() > 5)"
                self.assertIn("True", run(python, "-c", own + code))
                told = run(python, "-c", PYVISTA.format(other) + "import godrays", fails=True).splitlines()
                self.assertRegex(told[-1], f"ImportError: godrays .* is built for {distribution} .*PyVista runs on {other}: ")
                self.assertNotIn("During handling", "".join(told))

    def test_the_source_distribution_is_whole(self):
        name = run(FOLDER / "build/bin/python", "-c", f"import os; os.chdir({str(ROOT)!r})\n"
            f"import scikit_build_core.build as build; print(build.build_sdist({str(FOLDER)!r}))").splitlines()[-1]
        with tarfile.open(FOLDER / name) as held:
            held.extractall(FOLDER, filter="data")
        source = FOLDER / name.removesuffix(".tar.gz")
        run("cmake", "-G", "Ninja", "-S", source, "-B", FOLDER / "source-tree", "-DSKBUILD=ON", "-DGODRAYS_BUILD_TESTING=OFF",
            "-DGODRAYS_WRAP_PYTHON=ON", "-DGODRAYS_BUILD_PARAVIEW_PLUGIN=OFF", f"-DVTK_DIR={VTK_DIR}",
            f"-DPython3_EXECUTABLE={sys.executable}")
        print(f"{name}: {(FOLDER / name).stat().st_size / 1e6:.1f} MB")
        self.assertLess((FOLDER / name).stat().st_size, 5e6)

    def test_the_variant_of_a_published_wheel(self):
        for distribution, needs in (("vtk", "vtk=="), ("cvista", "cvista-rendering==")):
            tree = FOLDER / f"variant-{distribution}"
            (tree / "CMake").mkdir(parents=True)
            shutil.copy(ROOT / "CMake/wheel_variant.py", tree / "CMake")
            shutil.copy(ROOT / "pyproject.toml", tree)
            run("env", f"GODRAYS_VARIANT={distribution}", sys.executable, tree / "CMake/wheel_variant.py")
            text = (tree / "pyproject.toml").read_text(encoding="utf-8")
            self.assertIn('\nname = "godrays"' if distribution == "vtk" else '\nname = "godrays-cvista"', text)
            self.assertIn(f'\ndependencies = ["numpy", "{needs}', text)


if __name__ == "__main__":
    unittest.main()
