# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters, sources of data and the program compile for Windows, with Debian's cross compiler.

Nothing is linked: the headers are those of the system's VTK. The shaders' modules need OpenGL's headers of Windows.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["GODRAYS_BUILD"])
COMPILER = [each for each in (os.environ.get("GODRAYS_LAUNCHER"), os.environ["GODRAYS_WINDOWS_COMPILER"]) if each]
HEADERS = (  # of libraries, among those of Linux
    "CLI", "GL", "KHR", "X11", "glm", "hwy", "oneapi", "tbb",
    *(f"x86_64-linux-gnu/tiff{part}.h" for part in ("", "conf", "io", "vers")))
FOLDERS = ("Filters", "Examples/godrays")
POSIX = re.compile(r"^#\s*include <(unistd|fcntl|fnmatch|glob|dlfcn|poll|pwd|termios|sys/\w+)\.h>", re.M)


def is_checked(file):
    needs_python = file.parent.name == "Python"  # whose headers are those of Linux here
    return not needs_python and any(file.is_relative_to(ROOT / folder) for folder in FOLDERS)


class Windows(unittest.TestCase):
    def test_one_file_calls_posix(self):
        found = [str(path.relative_to(ROOT)) for folder in ("Filters", "Rendering", "Plugin", "Examples")
            for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".cxx", ".h", ".inl", ".txx")
            and POSIX.search(path.read_text(encoding="utf-8"))]
        self.assertEqual(found, ["Examples/godrays/System.cxx"])

    def test_sources_compile(self):
        folder = BUILD / "Testing" / "Windows"
        (folder / "include").mkdir(parents=True, exist_ok=True)
        for name in HEADERS:
            link = folder / "include" / pathlib.Path(name).name
            if not link.exists() and pathlib.Path("/usr/include", name).exists():
                link.symlink_to(f"/usr/include/{name}")

        def compile_it(entry):
            words = shlex.split(entry["command"])
            flags = [word for word in words if word.startswith(("-D", "-I", "-std"))]
            for flag, path in zip(words, words[1:]):
                if flag == "-isystem" and path != "/usr/include":
                    flags += [flag, path]
            target = folder / (pathlib.Path(entry["file"]).stem + ".obj")
            command = [*COMPILER, "-O0", "-w", *flags, "-isystem", folder / "include", "-o", target, "-c", entry["file"]]
            ran = subprocess.run(list(map(str, command)), cwd=BUILD, check=False, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            return entry["file"], ran.stdout if ran.returncode else ""

        commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
        files = [entry for entry in commands if is_checked(pathlib.Path(entry["file"]))]
        self.assertGreater(len(files), 80)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for file, told in pool.map(compile_it, files):
                with self.subTest(file):
                    self.assertEqual(told, "")
        print(f"{len(files)} files compile")


if __name__ == "__main__":
    unittest.main()
