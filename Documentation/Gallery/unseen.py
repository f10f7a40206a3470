# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures default pictures of data for which no default was chosen, as defaults.py does for its own.

Usage: unseen.py <folder> <program> [<name>...]

Writes Unseen.md, Unseen.csv and unseen/*.jpg into the folder. With names, it measures these data sets alone and writes
their pictures only.
"""

import os
import sys

import defaults
import unseen_scenes
from unseen_scenes import MODELS, PYVISTA

FILES = (
    f"{MODELS}/STL/3DSMaxExport.STL",
    f"{MODELS}/STL/sphereWithHole.stl",
    f"{MODELS}/3DS/fels.3ds",
    f"{MODELS}/glTF2/textureTransform/TextureTransformTest.gltf",
    f"{PYVISTA}/airplane.ply",
    f"{PYVISTA}/ant.ply",
    f"{PYVISTA}/nut.ply",
    f"{PYVISTA}/globe.vtk",
    f"{PYVISTA}/hexbeam.vtk",
    f"{PYVISTA}/frog_tissues.vti",
    f"{PYVISTA}/channels.vti",
)
SAVED = ("superquadrics", "lorenz", "forest", "triangulation", "ribbon")  # scenes that are written to files


def main(folder, program, *names):
    files = {os.path.basename(path): path for path in FILES} | dict.fromkeys(SAVED)
    scenes = [name for name in unseen_scenes.SCENES if not names or name in names]
    files = {name: path for name, path in files.items() if not names or name in names}
    if missing := [path for path in files.values() if path and not os.path.exists(path)]:
        sys.exit(f"unseen.py: missing {', '.join(missing)}; see unseen_scenes.py for the packages")
    found = defaults.measure_all(scenes, program, os.path.join(folder, "unseen"), unseen_scenes.make, files)
    print("\n" + defaults.make_means(found))
    if names:
        return
    defaults.write_csv(found, os.path.join(folder, "Unseen.csv"))
    what = "".join(
        f"- {name}: {' '.join((make.__doc__ or make.__name__).split()).rstrip('.')}\n"
        for name, (make, *_) in unseen_scenes.SCENES.items()
    )
    with open(os.path.join(folder, "Unseen.md"), "w", encoding="utf-8") as page:
        page.write(PAGE.format(
            promises=defaults.make_promises(found)[0], means=defaults.make_means(found), what=what,
            files=defaults.make_table("file", found["program"])))


PAGE = """# Unseen data

No default was chosen for these data sets: they were collected when the defaults stood. The numbers are those of
[Defaults.md](Defaults.md), whose promises are not made for these data sets. One command measures all of it:

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \\
      /usr/bin/python3 Documentation/Gallery/unseen.py Documentation/Evidence build/bin/godrays

## Summary

{means}
The bounds of Defaults.md; bold numbers are beyond them:

{promises}
[Unseen.csv](Unseen.csv) has the numbers of each data set. Some of the scenes have a white or grey background.

## Files, as the program draws them

{files}
## Scenes

{what}"""

if __name__ == "__main__":
    main(*sys.argv[1:])
