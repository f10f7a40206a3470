# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The build backend of pyproject.toml (PEP 517): a wheel of what CMake builds and installs.

Settings, as pip's --config-settings NAME=VALUE:
  build-dir   the absolute path of a build tree to use and keep; without it, one is made in a temporary folder
  cmake-args  arguments for the configuration, such as -DVTK_DIR=<folder>

The wheel holds the module, the libraries beside it, and the program godrays if it is built. It is for the
VTK for which it was built, and has none in it.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPONENTS = ("runtime", "python", "program")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """The metadata alone, which pip asks for first: without this it would build twice."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    project = re.search(r'project\(GodRays VERSION (\S+)\s+DESCRIPTION "([^"]*)"', text)
    metadata = (ROOT / "Rendering/Python/METADATA.in").read_text(encoding="utf-8")
    for name, value in (("VERSION", project[1]), ("DESCRIPTION", project[2])):
        metadata = metadata.replace(f"@PROJECT_{name}@", value)
    info = pathlib.Path(metadata_directory) / f"godrays-{project[1]}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(metadata, encoding="utf-8")
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        tree = pathlib.Path(settings.get("build-dir") or folder / "build").resolve()
        if not (tree / "CMakeCache.txt").exists():
            cmake("-S", ROOT, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                "-DGODRAYS_BUILD_TESTING=OFF", "-DGODRAYS_WRAP_PYTHON=ON",
                "-DGODRAYS_BUILD_PARAVIEW_PLUGIN=OFF",
                f"-DPython3_EXECUTABLE={os.path.realpath(sys.executable)}",
                *shlex.split(settings.get("cmake-args", "")))
        cmake("--build", tree)
        for component in COMPONENTS:
            cmake("--install", tree, "--prefix", folder / "prefix", "--strip", "--component", component)
        return write_wheel(pathlib.Path(wheel_directory), folder)


def cmake(*arguments):
    command = ["cmake", *map(str, arguments)]
    if subprocess.run(command, check=False, stdout=sys.stderr).returncode:
        raise SystemExit(f"{shlex.join(command)} failed: see its messages above.")


def write_wheel(wheels, folder):
    """Lay the installed files out as a wheel; its name."""
    (packages,) = (folder / "prefix").glob("lib/python3/dist-packages")
    package = packages / "godrays"
    for library in sorted((folder / "prefix").rglob("libvtkGodRays*.so.*")):
        if not library.is_symlink():  # under the name that the loader asks for, where the modules look first
            shutil.copy2(library, package / library.name.rsplit(".", 1)[0])
    program = folder / "prefix" / "bin" / "godrays"
    if program.exists():
        shutil.copy2(program, package / "godrays")
    (info,) = packages.glob("godrays-*.dist-info")
    version = info.name[len("godrays-") : -len(".dist-info")]
    python = "cp{}{}".format(*sys.version_info)
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    (info / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: godrays\nRoot-Is-Purelib: false\nTag: {tag}\n", encoding="utf-8")
    shutil.copy2(ROOT / "LICENSE", info / "LICENSE")
    if program.exists():
        with (info / "entry_points.txt").open("a", encoding="utf-8") as entries:
            entries.write("\n[console_scripts]\ngodrays = godrays.__main__:main\n")

    name = f"godrays-{version}-{tag}.whl"
    record = []
    with zipfile.ZipFile(wheels / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path in sorted(packages.rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                inside = path.relative_to(packages).as_posix()
                wheel.write(path, inside)
                digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest()).decode()
                record.append(f"{inside},sha256={digest.rstrip('=')},{path.stat().st_size}\n")
        record.append(f"{info.name}/RECORD,,\n")
        wheel.writestr(f"{info.name}/RECORD", "".join(record))
    return name
