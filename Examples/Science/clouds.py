# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of a file before the sun, in haze, and their shadows on the ground; and numbers.

cloud_field.py reads the file; without one, it makes clouds. Their water, as extinction, is the medium.
Light is scattered by all orders: once, it would hardly leave clouds whose droplets send most of it on.
"""

import argparse
import sys

import cloud_field
import godrays
import stage
import vtkmodules.all as vtk

ASYMMETRY = 0.85  # of droplets [HansenTravis1974]

parser = argparse.ArgumentParser(description="Clouds of a file before the sun, in haze, and numbers.")
parser.add_argument("picture", nargs="?", help="a PNG; without it a window opens")
parser.add_argument("size", nargs="?", default="1280x720", help="of the picture (1280x720)")
parser.add_argument("--field", metavar="FILE", help="NetCDF, or text of SHDOM; without it clouds are made up")
parser.add_argument("--variable", help="the liquid water of NetCDF, if its name is not customary")
parser.add_argument("--units", help="of that, if the file does not say: kg/m3, g/m3, kg/kg or g/kg")
parser.add_argument("--radius", type=float, help="effective radius of all drops [um]")
parser.add_argument("--time", type=int, default=0, help="which time step of NetCDF, from 0 (0)")
parser.add_argument("--spacing", type=float, default=40.0, help="of the clouds that are made up [m] (40)")
asked = parser.parse_args()
if not 20 <= asked.spacing <= 400:
    parser.error("--spacing is from 20 to 400")
sys.argv[1:] = [asked.picture, asked.size] if asked.picture else []
try:
    if asked.field:
        radius = None if asked.radius is None else asked.radius * 1e-6
        field = cloud_field.read(asked.field, asked.variable, asked.units, radius, asked.time)
    else:
        field = cloud_field.make(asked.spacing)
except cloud_field.FieldError as error:
    sys.exit(f"clouds.py: {error}.")
print(field.describe())
for each in field.supposed:
    print(f"supposed: {each}")

clouds = stage.volume_of(field.to_grid(), field.extinction.max(), (1, 1, 1))

x, y, z = field.axes
middle, width, depth = (x[0] + x[-1]) / 2, x[-1] - x[0], y[-1] - y[0]
wet = z[field.extinction.max((1, 2)) > 0]
reach = max(depth, 2.5 * wet[-1])  # of what is seen: the field, or a single cloud with room about it
renderer = vtk.vtkRenderer()
renderer.AddVolume(clouds)
hills = godrays.vtkGodRaysTerrainSource()
hills.SetDimensions(500, 500)
hills.SetWidth(8 * reach)
hills.SetHeight(0.7 * wet[0])
hills.SetFeatures(16)
flat = vtk.vtkImageDataGeometryFilter()
flat.SetInputConnection(hills.GetOutputPort())
relief = vtk.vtkWarpScalar()
relief.SetInputConnection(flat.GetOutputPort())
ground = stage.add(renderer, relief, (0.42, 0.46, 0.3), normals=True)
ground.SetPosition(middle, y[0] + 3 * reach, 0)
ground.GetProperty().SetAmbient(0.25)

sun = stage.light((-0.3, 1, 0.48), (1, 0.97, 0.9))
skylight = stage.light((0, -0.6, 1), (0.6, 0.75, 1), intensity=0.8)
renderer.AddLight(sun)
renderer.AddLight(skylight)
rays = godrays.enable(renderer, light=[sun, skylight], medium=clouds, model="atmosphere",
    mie_scattering=[0.35 / reach] * 3, mie_asymmetry=0.76, world_unit_in_meters=1, intensity=4,
    data_asymmetry=ASYMMETRY, scattering_orders="all",
    automatic_exposure=False, shadows=True)  # of clouds on the ground
eye = max(1.3 * wet[0], 50)
stage.look(renderer, (middle, y[0] - 0.5 * reach, eye), (middle, y[0] + reach, 0.65 * wet[0]), 50)
renderer.GetActiveCamera().SetClippingRange(20, 30 * reach)
window = stage.show(renderer)
