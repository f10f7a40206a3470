# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m godrays FILE ...: the program godrays, with the same options."""

from __future__ import annotations

import os
import pathlib
import shutil
import sys


def find_program() -> str | None:
    """The program of the tree that this package is in, or that of the path."""
    package = pathlib.Path(__file__).resolve().parent
    places = [package / "godrays", *(folder / "bin" / "godrays" for folder in package.parents)]
    found = shutil.which("godrays")
    for program in [*places, *([pathlib.Path(found)] if found else [])]:
        if program.is_file() and os.access(program, os.X_OK):
            with program.open("rb") as file:
                if file.read(2) != b"#!":  # a wheel's script, which starts this
                    return str(program)
    return None


def main() -> None:
    program = find_program()
    if program is None:
        sys.exit(
            "python3 -m godrays starts the program godrays, which is neither in the tree of this package nor "
            "in PATH. Build it with -DGODRAYS_BUILD_EXAMPLES=ON, or install it."
        )
    sys.stdout.flush()
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    main()
