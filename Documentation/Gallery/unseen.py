# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What defaults do to data for which they were not chosen: the scenes of unseen_scenes.py by the Python module,
and files by the program.

Usage: unseen.py <folder> <program> [<scene or file>...]

Writes Unseen.md and unseen/*.jpg into the folder; with names it prints the numbers of these alone.
"""

import os
import subprocess
import sys
import tempfile

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import default_scenes
import defaults
import unseen_scenes
from unseen_scenes import MODELS, PYVISTA

SIZE = (480, 320)

# what the program is given, with nothing else
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
# and scenes of Python as files
SAVED = ("superquadrics", "lorenz", "forest", "triangulation", "ribbon")


def save(name, folder):
    """The surfaces of a scene, with their colours, as a file."""
    window, renderer = unseen_scenes.make(name, (100, 100))
    window.Render()
    append = vtk.vtkAppendPolyData()
    for prop in renderer.GetActors():
        if not prop.GetMapper() or not prop.GetVisibility() or prop.IsA("vtkCubeAxesActor"):
            continue
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(prop.GetMapper().GetInput())
        place = vtk.vtkTransformFilter()
        transform = vtk.vtkTransform()
        transform.SetMatrix(prop.GetMatrix())
        place.SetTransform(transform)
        default_scenes.through(surface, place).Update()
        append.AddInputData(place.GetOutput())
    path = os.path.join(folder, f"{name}.vtp")
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    default_scenes.through(append, writer).Write()
    window.Finalize()
    return path


def run(program, file, folder, *options):
    """The picture [row, column, channel] from the lower left, and what was printed."""
    path = os.path.join(folder, "picture.png")
    size = "x".join(map(str, SIZE))
    done = subprocess.run([program, "--no-config", file, "--size", size, "--output", path, *options],
        capture_output=True, text=True, check=True)
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1).astype(float), done.stderr


def measure_file(program, file, folder):
    """The pictures without and with rays, their numbers and how much of the picture data are."""
    data = run(program, file, folder, "--no-rays", "--transparent")[0][..., 3] > 127
    before = run(program, file, folder, "--no-rays")[0][..., :3]
    after, said = run(program, file, folder)
    rays = run(program, file, folder, "--show", "rays")[0].sum(-1)
    y, x = numpy.nonzero(rays >= numpy.quantile(rays, 0.999))  # about the sun
    place = (x.mean() / SIZE[0], y.mean() / SIZE[1])
    return (before, after[..., :3]), defaults.measure(before, after[..., :3], data, place), data.mean(), said


def get_contrast_beside(before, after, data, place):
    """The contrast of the shafts beside data alone."""
    change = defaults.to_lab(after)[..., 0] - defaults.to_lab(before)[..., 0]
    return defaults.get_contrast(change, place, ~data)


def format_numbers(numbers):
    kept = f"grey {numbers.tint:+.1f}" if numbers.chroma is None else f"{100 * numbers.chroma:.0f} %"
    return f"{numbers.difference:.1f} | {kept} | {numbers.clipped:.2f} % | {numbers.contrast:.1f}"


def halve(picture):
    """The picture at half its size, its pixels averaged."""
    rows = picture[0::2] + picture[1::2]
    return (rows[:, 0::2] + rows[:, 1::2]) / 4


def describe(make):
    return " ".join((make.__doc__ or make.__name__).split()).rstrip(".")


def main(folder, program, names):
    pictures = os.path.join(folder, "unseen")
    os.makedirs(pictures, exist_ok=True)
    rows, sheet = [], []
    for name, (make, *_) in unseen_scenes.SCENES.items():
        if names and name not in names:
            continue
        columns = defaults.COLUMNS | {"plain": defaults.PLAIN}
        (before, *after), data, places = defaults.draw(name, columns=columns, make=unseen_scenes.make)
        look, medium, plain = (
            defaults.measure(before, each, data, place) for each, place in zip(after, places))
        beside, plain_beside = (
            get_contrast_beside(before, after[i], data, places[i]) for i in (0, 2))
        fill = 100 * data.mean()
        shown = [before, *after[:2]]
        sheet.append(halve(numpy.concatenate(shown, axis=1)))
        if names:
            defaults.write(shown, os.path.join(pictures, name.replace(" ", "-") + ".jpg"))
        rows.append(f"| {name}: {describe(make)} | {fill:.0f} % | {format_numbers(look)} | {plain.contrast:.1f} "
            f"| {beside:.1f} | {plain_beside:.1f} | {format_numbers(medium)} |\n")
        print(rows[-1], end="", flush=True)
    files, file_sheet = [], []
    with tempfile.TemporaryDirectory() as here:
        for each in (*FILES, *SAVED):
            if names and os.path.basename(each) not in names:
                continue
            path = save(each, here) if each in SAVED else each
            shown, numbers, fill, said = measure_file(program, path, here)
            file_sheet.append(halve(numpy.concatenate(shown, axis=1)))
            if names:
                defaults.write(shown, os.path.join(pictures, os.path.basename(path) + ".jpg"))
            files.append(f"| `{os.path.basename(path)}` | {100 * fill:.0f} % | {format_numbers(numbers)} |\n")
            print(files[-1], said, end="", flush=True)
    if sheet:
        defaults.write_sheet(sheet, os.path.join(pictures, "scenes.jpg"), 2)
    if file_sheet:
        defaults.write_sheet(file_sheet, os.path.join(pictures, "files.jpg"), 3)
    if names:
        return
    with open(os.path.join(folder, "Unseen.md"), "w", encoding="utf-8") as page:
        page.write(PAGE)
        page.writelines(rows)
        page.write(FILES_PAGE if files else "")
        page.writelines(files)


PAGE = """# Unseen data

No default was chosen for these data sets: they were collected when the defaults stood, and are tried as they are.
Made by

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \\
      /usr/bin/python3 Documentation/Gallery/unseen.py Documentation/Gallery build/bin/godrays

The numbers are those of [Defaults.md](Defaults.md): dE is to be below 10, 90 to 110 % of the chroma are to be
left, or 2.5 more of it where data are grey, and 0.5 % may be clipped. Where most data are dark, as a silhouette is,
light before them is what one sees, and dE is above that. Plain is the contrast of a sum of which nobody chooses the
strength. Before white, that sum changes data alone: beside them, where one looks for shafts, its contrast is 0.

One default was mended for them: slices of images had no place in the silhouette beside which the sun is put. Three
slices through a scan had a dE of 16.1 and a contrast of 2.7 before; a photograph on a plane, a contrast of 2.7.

## With `godrays.enable(renderer)`

Each without rays, with a look, and with `preset="haze"`.

| | of the picture | dE of a look | chroma | clipped | contrast | plain | beside data | plain | dE of a medium | chroma | clipped | contrast |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
"""

FILES_PAGE = """
## With `godrays FILE`

Each with `--no-rays`, and as it is. The program's camera is to have data on a quarter to a third of the picture, or
as near to that as the data's shape lets them, at most 84 % of its width and 80 % of its height. The two volumes
had a dE of 23 and 22 before the program's sky, when alpha alone told where volumes are.

These pictures are anti-aliased, and a pixel counts that is half covered by data. Of `ribbon.vtp` and `lorenz.vtp` 22
and 31 % of them have the background in them as well; pixels that data fill keep 90 and 92 % of their chroma.

| | of the picture | dE | chroma | clipped | contrast |
|---|---|---|---|---|---|
"""

if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
