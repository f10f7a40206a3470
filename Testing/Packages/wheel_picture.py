# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Usage: wheel_picture.py [<file.png>]

Draw README's scene in PyVista with an installed wheel, and check that it has rays.
"""

import sys

import numpy
import pyvista


def draw(file, has_rays):
    plotter = pyvista.Plotter(off_screen=True, window_size=(640, 360))
    plotter.background_color = "#060a14"
    plotter.add_mesh(pyvista.Icosphere(nsub=2).elevation().explode(0.3), show_scalar_bar=False)
    if has_rays:
        plotter.god_rays.enable()
    picture = plotter.screenshot(file if has_rays else None)
    plotter.close()
    return picture.astype(float)


def main():
    changed = numpy.abs(draw(sys.argv[1] if len(sys.argv) > 1 else None, True) - draw(None, False)).mean()
    print(f"rays change a pixel by {changed:.1f} of 255 on average")
    return 0 if changed > 2 else 1


if __name__ == "__main__":
    sys.exit(main())
