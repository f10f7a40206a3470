# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what god rays look like by default: how clear the shafts are, and how far they change data.

Usage: defaults.py <folder> <program> [<name>...]

Writes Defaults.md, Defaults.csv and defaults/*.jpg into the folder. With names, it measures these data sets alone and
writes their pictures only. Ends with 1 if a promise is broken. Cameras and lights are VTK's own.
"""

import csv
import math
import os
import re
import subprocess
import sys
import tempfile
import typing

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import default_scenes
import default_situations
import godrays

SIZE = (480, 300)
COLUMNS = {"look": {}, "medium": {"preset": "haze"}}
NEARLY_GREY = 10  # chroma below which hue and a change of chroma by 10 % are not seen
LIT = 20  # [L*] below which data count as dark
DIRECTIONS = 192
RING = 2  # [pixels]

# The program reads these as they are; other scenes are written to a file first.
FILES = {
    "engine": f"{default_scenes.MODELS}/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
    "textured-box": f"{default_scenes.MODELS}/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb",
    "spider": f"{default_scenes.MODELS}/OBJ/spider.obj",
    "boar": f"{default_scenes.MODELS}/PLY/Wuson.ply",
}
WITHOUT_FILE = {"molecule"}  # VTK writes no surface of a vtkMolecule


class Numbers(typing.NamedTuple):
    """How clear the shafts of a picture are, and how far rays change data. None: no pixel to measure."""

    shafts: int  # that stand out by 3 L*
    clear_shafts: int  # that stand out by 8 L*
    area: float | None  # of the background [%]
    difference: float | None  # mean CIE 1976 distance of lit data
    hue: float | None  # mean change of lit data with a chroma [degrees]
    clipped: float  # of the data, newly [%]
    lightness: float  # mean change of data [L*]
    mud: float | None  # of the background [%]
    ground: float | None  # median lightness of the background [L*]
    chroma: float | None  # part of the data's mean that is left; None: they are nearly grey
    tint: float  # growth of the data's mean chroma


class Promise(typing.NamedTuple):
    what: str
    number: str
    reduce: typing.Callable
    bound: float
    is_least: bool = False

    def measure(self, numbers):
        """Returns the value that is bounded, and whether the bound holds."""
        values = [value for each in numbers if (value := getattr(each, self.number)) is not None]
        value = self.reduce(values)
        return value, value >= self.bound if self.is_least else value <= self.bound


PROMISES = (
    Promise("shafts of 3 L\\*, in each picture", "shafts", min, 4, True),
    Promise("shafts of 3 L\\*, on average", "shafts", numpy.mean, 6, True),
    Promise("shafts of 8 L\\*, on average", "clear_shafts", numpy.mean, 3, True),
    Promise("area of the shafts, on average [%]", "area", numpy.mean, 35, True),
    Promise("dE of lit data, on average", "difference", numpy.mean, 6),
    Promise("dE of lit data, in each picture", "difference", max, 9),
    Promise("change of hue, on average [degrees]", "hue", numpy.mean, 3),
    Promise("clipped data, in each picture [%]", "clipped", max, 0.5),
    Promise("mud, in each picture [%]", "mud", max, 15),
)
BEFORE_WHITE = (
    Promise("before white: shafts of 3 L\\*, in each picture", "shafts", min, 3, True),
    Promise("before white: dE of lit data, in each picture", "difference", max, 1),
)


def read(window, buffer):
    """Returns the window's pixels [row, column, channel] from the lower left."""
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    if buffer == "depth":
        reader.SetInputBufferTypeToZBuffer()
    elif buffer == "alpha":
        reader.SetInputBufferTypeToRGBA()
    return to_array(reader)


def to_array(source):
    """Returns the pixels [row, column, channel] of an image source, from the lower left."""
    source.Update()
    image = source.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1).astype(float)


def to_light(picture):
    """Converts sRGB from 0 to 255 to linear light."""
    shown = picture / 255
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def to_lab(picture):
    """Converts sRGB from 0 to 255 to CIE 1976 L*a*b*."""
    light = to_light(picture)
    matrix = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    xyz = light @ numpy.transpose(matrix) / (0.9505, 1.0, 1.089)
    x, y, z = numpy.moveaxis(
        numpy.where(xyz > 216 / 24389, numpy.cbrt(xyz), xyz * 841 / 108 + 4 / 29), -1, 0
    )
    return numpy.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], -1)


def to_polar(values, place, where):
    """Sums values over bins [ring, direction] about a place of the picture, and counts the pixels of each bin."""
    height, width = values.shape
    y, x = numpy.mgrid[0:height, 0:width] + 0.5
    x, y = x - place[0] * width, y - place[1] * height
    ring = (numpy.hypot(x, y) / RING).astype(int)
    direction = ((numpy.arctan2(y, x) / (2 * math.pi) + 0.5) * DIRECTIONS).astype(int) % DIRECTIONS
    bins = (ring * DIRECTIONS + direction)[where]
    count = (ring.max() + 1) * DIRECTIONS
    return (
        numpy.bincount(bins, values[where], count).reshape(-1, DIRECTIONS),
        numpy.bincount(bins, minlength=count).reshape(-1, DIRECTIONS),
    )


def get_profile(change, place, ground):
    """Returns the lightness of the background by direction from the sun [L*], its mean from 0.2 to 0.8 heights.

    Data and the picture's border hide parts of the ring. A plain mean would vary with these parts: a round glow behind
    streamlines would have 15 "shafts". So the lightness is fitted by a product of a function of distance and a function
    of direction, by alternating least squares over the visible bins. Directions with less than a quarter of their
    weight visible are left out.
    """
    sums, counts = to_polar(change, place, ground)
    rings = slice(int(0.2 * len(change) / RING), int(0.8 * len(change) / RING))
    known = counts[rings] > 0
    if not known.any():
        return numpy.zeros(0)
    values = sums[rings] / numpy.maximum(counts[rings], 1)
    values = (values - numpy.percentile(values[known], 1)) * known  # where rays darken, from the deepest shadow
    by_distance = numpy.ones((len(values), 1))
    for _ in range(8):
        weights = (by_distance**2 * known).sum(0)
        profile = (by_distance * values).sum(0) / numpy.maximum(weights, 1e-9)
        by_distance = (profile * values).sum(1, keepdims=True)
        by_distance /= numpy.maximum((profile**2 * known).sum(1, keepdims=True), 1e-9)
        by_distance /= max(by_distance.mean(), 1e-9)
    return profile[(by_distance**2 * known).sum(0) >= 0.25 * max((by_distance**2).sum(), 1e-9)]


def count_shafts(profile, prominence):
    """Counts the maxima of a closed profile that stand out from the minima on both sides."""
    if not len(profile):
        return 0
    start = profile.argmin()
    count, rising, last = 0, True, profile[start]
    for value in numpy.append(numpy.roll(profile, -start), profile[start]):
        last = min(last, value) if rising else max(last, value)
        if abs(value - last) >= prominence:
            count += not rising
            rising, last = not rising, value
    return count


def get_area(change, place, ground):
    """Returns the part of the background that differs by 2 L* from its mean over 30 degrees about the sun [%]."""
    sums, counts = to_polar(change, place, ground)
    shifts = range(-(DIRECTIONS // 24), DIRECTIONS // 24 + 1)
    means = sum(numpy.roll(sums, shift, 1) for shift in shifts) / numpy.maximum(
        sum(numpy.roll(counts, shift, 1) for shift in shifts), 1
    )
    differs = abs(sums / numpy.maximum(counts, 1) - means) > 2
    return 100 * counts[differs].sum() / counts.sum()


def measure(before, after, opacity, place):
    """Returns the Numbers of a picture before and after rays, from the data's opacity or mask and the sun's place."""
    data, ground = opacity > 0.9 * opacity.max(), opacity < 0.1  # edges are neither
    old, new = to_lab(before), to_lab(after)
    lit = data & (old[..., 0] >= LIT)
    old_chroma, new_chroma = (numpy.hypot(each[..., 1], each[..., 2]) for each in (old, new))
    colored = lit & (old_chroma > NEARLY_GREY)
    turn = numpy.degrees(numpy.arctan2(new[..., 2], new[..., 1]) - numpy.arctan2(old[..., 2], old[..., 1]))
    clipped = (after.max(-1) == 255) & (before.max(-1) < 255)
    mud = (new[..., 0] > 12) & (new[..., 0] < 60) & (new_chroma < 6)
    change = new[..., 0] - old[..., 0]
    profile = get_profile(change, place, ground)
    chroma = old_chroma[data].mean()

    def mean(values, where):  # a few pixels tell nothing of data
        return values[where].mean() if where.sum() > 0.05 * data.sum() else None

    return Numbers(
        count_shafts(profile, 3),
        count_shafts(profile, 8),
        get_area(change, place, ground) if ground.any() else None,
        mean(numpy.linalg.norm(new - old, axis=-1), lit),
        mean(abs((turn + 180) % 360 - 180), colored),
        100 * clipped[data].mean(),
        change[data].mean(),
        100 * mud[ground].mean() if ground.any() else None,
        numpy.median(new[..., 0][ground]) if ground.any() else None,
        new_chroma[data].mean() / chroma if chroma > NEARLY_GREY else None,
        new_chroma[data].mean() - chroma,
    )


def expect_colors(test, numbers, least_chroma=0.9):
    """Asserts that data keep their colours, in a unittest.TestCase."""
    test.assertLess(numbers.difference, 10)
    test.assertLess(numbers.clipped, 0.5)
    if numbers.chroma is None:
        test.assertGreater(numbers.tint, -2.5)
    else:
        test.assertGreater(numbers.chroma, least_chroma)
    if numbers.chroma is None or numbers.chroma > 1.1:
        test.assertLess(numbers.tint, 2.5)  # just visible


def project(camera, point):
    """Projects a point (x, y, z, 1) or a direction (x, y, z, 0) into the picture, from (0, 0) to (1, 1)."""
    matrix = camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    x, y, _, w = matrix.MultiplyPoint(point)
    return 0.5 + 0.5 * x / w, 0.5 + 0.5 * y / w


def get_place(renderer, light):
    """Returns the place of a lamp or a sun in the picture."""
    camera = renderer.GetActiveCamera()
    place = numpy.array(light.GetTransformedPosition())
    if not light.GetPositional():
        direction = place - light.GetTransformedFocalPoint()
        far = camera.GetClippingRange()[1] * direction / numpy.linalg.norm(direction)
        place = camera.GetPosition() + far
    return project(camera, (*place, 1))


def write(pictures, name):
    """Writes pictures side by side, as a JPEG."""
    joined = numpy.concatenate(pictures, axis=1).astype(numpy.uint8)
    image = vtk.vtkImageData()
    image.SetDimensions(joined.shape[1], joined.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(joined.reshape(-1, 3), deep=True))
    writer = vtk.vtkJPEGWriter()
    writer.SetQuality(85)
    writer.SetInputData(image)
    writer.SetFileName(name)
    writer.Write()


def write_sheet(pictures, name, columns=6):
    """Writes pictures at half their size in rows, as a JPEG."""
    halves = [sum(each[i::2, j::2] for i in (0, 1) for j in (0, 1)) / 4 for each in pictures]
    halves += [numpy.zeros_like(halves[0])] * (-len(halves) % columns)
    rows = [numpy.concatenate(halves[i : i + columns], axis=1) for i in range(0, len(halves), columns)]
    write([numpy.concatenate(rows[::-1], axis=0)], name)


def draw(name, background=None, samples=0, columns=COLUMNS, make=default_scenes.make):
    """Draws a scene without rays and with those of each column.

    Returns the pictures, a mask of the pixels that show data, and the place of each column's sun.
    """
    window, renderer = make(name, SIZE)
    window.SetMultiSamples(samples)
    overlays = [
        prop for prop in renderer.GetViewProps() if prop.IsA("vtkActor2D") or prop.IsA("vtkContextActor")
    ]
    for prop in overlays:
        prop.VisibilityOff()
    window.Render()
    # a skybox is drawn at the far end of the depth; before a gradient alpha is 1 everywhere
    data, alpha = read(window, "depth")[..., 0] < 1, read(window, "alpha")[..., 3]
    if alpha.min() == 0:
        data |= alpha > 127
    for prop in overlays:
        prop.VisibilityOn()
    window.Render()
    if background:
        default_scenes.BACKGROUNDS[background](renderer)
        window.Render()
    shown, places = [read(window, "colour")], []
    for parameters in columns.values():
        rays = godrays.enable(renderer, **parameters)
        window.Render()
        shown.append(read(window, "colour"))
        places.append(get_place(renderer, rays.GetLight(0)))
        godrays.disable(renderer)
    window.Finalize()
    return shown, data, places


def measure_scene(name, background=None, columns=COLUMNS, make=default_scenes.make):
    """Returns the Numbers of each column, without anti-aliasing: a pixel shows data or the background."""
    (before, *with_rays), data, places = draw(name, background, columns=columns, make=make)
    numbers = [measure(before, after, data, place) for after, place in zip(with_rays, places)]
    for column, each in zip(columns, numbers):
        report(name, f"{column} before {background}" if background else column, each)
    return numbers


def draw_look(name, background=None, make=default_scenes.make):
    """Returns the picture of a look and its Numbers."""
    (before, after), data, places = draw(name, background, columns={"look": {}}, make=make)
    numbers = measure(before, after, data, places[0])
    report(name, f"look before {background}" if background else "look", numbers)
    return after, numbers


def save(name, make, folder):
    """Writes the volume of a scene, or its surfaces with their scalars, to a file. Returns its path.

    Surfaces are turned so that Z is up, as the program expects of VTK's files.
    """
    window, renderer = make(name, (100, 100))
    append, writer = vtk.vtkAppendPolyData(), vtk.vtkXMLPolyDataWriter()
    for prop in renderer.GetActors():
        if not prop.GetMapper() or not prop.GetVisibility() or prop.IsA("vtkCubeAxesActor"):
            continue
        prop.GetMapper().Update()
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputData(prop.GetMapper().GetInput())
        transform = vtk.vtkTransform()
        transform.SetMatrix(prop.GetMatrix())
        if renderer.GetActiveCamera().GetViewUp()[1] == 1:
            transform.PostMultiply()
            transform.RotateX(90)
        place = vtk.vtkTransformFilter()
        place.SetTransform(transform)
        append.AddInputConnection(default_scenes.through(surface, place).GetOutputPort())
    for prop in renderer.GetVolumes():
        writer = vtk.vtkXMLImageDataWriter()
        writer.SetInputData(prop.GetMapper().GetInput())
    if not writer.GetNumberOfInputConnections(0):
        default_scenes.through(append, writer)
    path = os.path.join(folder, f"{name}.{writer.GetDefaultFileExtension()}")
    writer.SetFileName(path)
    writer.Write()
    window.Finalize()
    return path


def run(program, file, folder, *options):
    """Runs the program. Returns its picture [row, column, channel] from the lower left, and what it printed."""
    path = os.path.join(folder, "picture.png")
    size = "x".join(map(str, SIZE))
    done = subprocess.run([program, "--no-config", file, "--size", size, "--output", path, *options],
        capture_output=True, text=True, check=True)
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    return to_array(reader), done.stdout


def find_light(stats):
    """Returns the place of the program's sun or lamp in the picture, from what --stats prints."""
    options = {name: value.split(",") for name, value in re.findall(r"--([a-z-]+) ([-+.,e\d]+)", stats)}
    camera = vtk.vtkCamera()
    camera.SetPosition(*map(float, options["camera-position"]))
    camera.SetFocalPoint(*map(float, options["focal-point"]))
    camera.SetViewUp(*map(float, options["view-up"]))
    camera.SetViewAngle(*map(float, options["view-angle"]))
    if "light" in options:
        return project(camera, (*map(float, options["light"]), 1))
    azimuth, elevation = (math.radians(float(angle)) for angle in options["sun"])
    east, north = (turn(azimuth) * math.cos(elevation) for turn in (math.sin, math.cos))
    is_y_up = abs(camera.GetViewUp()[1]) > abs(camera.GetViewUp()[2])
    up = math.sin(elevation)
    return project(camera, (east, up, -north, 0) if is_y_up else (east, north, up, 0))


def draw_file(program, file, folder):
    """Draws a file by the program.

    Returns the pictures without and with rays, the opacity of data, and the place of the sun or lamp.
    """
    opacity = run(program, file, folder, "--no-rays", "--transparent")[0][..., 3] / 255
    before = run(program, file, folder, "--no-rays", "--fill", "1", "--no-ambient-occlusion")[0][..., :3]
    after, stats = run(program, file, folder, "--stats")
    return (before, after[..., :3]), opacity, find_light(stats)


def measure_all(names, program, folder, make=default_scenes.make, files=None, is_white=False):
    """Measures data sets and writes their pictures into a folder.

    Draws the COLUMNS of all names, their look before white if is_white, and by the program the files: paths by name, or
    None to write the scene to a file. Returns {column: {name: Numbers}}.
    """
    os.makedirs(folder, exist_ok=True)
    found = {column: {} for column in (*COLUMNS, "look before white", "program")}
    sheets = {"look before white": [], "program": []}
    for name in names:
        write(draw(name, samples=8, make=make)[0], os.path.join(folder, f"{name}.jpg".replace(" ", "-")))
        for column, numbers in zip(COLUMNS, measure_scene(name, make=make)):
            found[column][name] = numbers
        if is_white:
            picture, found["look before white"][name] = draw_look(name, "white", make)
            sheets["look before white"].append(picture)
    with tempfile.TemporaryDirectory() as here:
        for name, path in (files or {}).items():
            (before, after), opacity, place = draw_file(program, path or save(name, make, here), here)
            found["program"][name] = measure(before, after, opacity, place)
            sheets["program"].append(after)
            report(name, "program", found["program"][name])
    for column, pictures in sheets.items():
        if pictures:
            write_sheet(pictures, os.path.join(folder, column.replace(" ", "-") + ".jpg"))
    return {column: numbers for column, numbers in found.items() if numbers}


HEADS = ("shafts", "of 8 L\\*", "area", "dE", "hue", "clipped", "dL\\*", "mud", "ground")
FORMATS = ("g", "g", ".0f", ".1f", ".1f", ".2f", "+.1f", ".0f", ".0f")


def format_row(name, numbers):
    cells = ["" if value is None else format(value, form) for value, form in zip(numbers, FORMATS)]
    return f"| {name} | " + " | ".join(cells) + " |\n"


def report(name, column, numbers):
    print(f"{name}, {column}", format_row("", numbers), end="", flush=True)


def get_mean(rows):
    """Returns the mean of each number over the rows that have it."""
    columns = [[value for value in values if value is not None] for values in zip(*rows)]
    return Numbers(*(round(numpy.mean(values), 2) if values else None for values in columns))


def make_table(first, rows):
    """Returns a table of Numbers by name."""
    lines = [f"| {first} | " + " | ".join(HEADS) + " |\n", "|---" * (len(HEADS) + 1) + "|\n"]
    return "".join(lines + [format_row(name, numbers) for name, numbers in rows.items()])


def make_means(found):
    return make_table("mean of", {column: get_mean(rows.values()) for column, rows in found.items()})


def make_promises(found):
    """Returns a table of promised and measured values, and whether all promises hold."""
    looks = [column for column in ("look", "program") if column in found]
    lines = ["| | promised | " + " | ".join(looks) + " |\n", "|---" * (len(looks) + 2) + "|\n"]
    all_hold = True
    for promise in (*PROMISES, *(BEFORE_WHITE if "look before white" in found else ())):
        columns = looks if promise in PROMISES else ["look before white"]
        cells = []
        for column in columns:
            value, holds = promise.measure(found[column].values())
            cells.append(f"{value:.2g}" if holds else f"**{value:.2g}**")
            all_hold &= bool(holds)
        cells += [""] * (len(looks) - len(cells))
        word = "at least" if promise.is_least else "at most"
        lines.append(f"| {promise.what} | {word} {promise.bound:g} | " + " | ".join(cells) + " |\n")
    return "".join(lines), all_hold


def write_csv(found, path):
    """Writes the Numbers of all data sets and columns."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("data set", "drawn as", *Numbers._fields))
        for column, rows in found.items():
            for name, numbers in rows.items():
                writer.writerow((name, column, *("" if each is None else f"{each:.4g}" for each in numbers)))


def main(folder, program, *names):
    pictures = os.path.join(folder, "defaults")
    chosen = names or tuple(default_scenes.SCENES)
    files = {name: FILES.get(name) for name in chosen if name not in WITHOUT_FILE}
    found = measure_all(chosen, program, pictures, files=files, is_white=True)
    promises, all_hold = make_promises(found)
    print(promises + "\n" + make_means(found))
    if names:
        return 0 if all_hold else 1

    backgrounds = {name: draw_look("cones", name) for name in default_scenes.BACKGROUNDS}
    situations = {name: draw_look(name, make=default_situations.make) for name in default_situations.SITUATIONS}
    tables = []
    for first, file, looks in ("cones before", "backgrounds", backgrounds), ("look of", "situations", situations):
        write_sheet([picture for picture, _ in looks.values()], os.path.join(pictures, f"{file}.jpg"))
        tables.append(make_table(first, {name: numbers for name, (_, numbers) in looks.items()}))
    write_csv(found, os.path.join(folder, "Defaults.csv"))
    captions = "".join(
        f"\n![{what}](defaults/{name}.jpg)\n\n`{name}`: {what}\n"
        for name, (what, *_) in default_scenes.SCENES.items()
    )
    with open(os.path.join(folder, "Defaults.md"), "w", encoding="utf-8") as page:
        page.write(PAGE.format(
            count=len(found["look"]), promises=promises, means=make_means(found),
            table=make_table("look of", found["look"]), captions=captions,
            backgrounds=tables[0], situations=tables[1]))
    return 0 if all_hold else 1


PAGE = """# Default pictures

This page shows {count} data sets with god rays and measures them. Nothing is set beside the call that is named: no
camera, light or background. One command draws, measures and writes all of it:

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \\
      /usr/bin/python3 Documentation/Gallery/defaults.py Documentation/Evidence build/bin/godrays

## Promises

The script ends with 1 if a promise is broken. Broken promises are bold. A test holds the promises for 12 of the data
sets, `test_promises` of `TestGodRaysDefaults`.

{promises}
`look` is `godrays.enable(renderer)` before VTK's black background, `program` is `godrays FILE`. The program draws all
data sets that can be written to a file.

## Numbers

{means}
`medium` is `godrays.enable(renderer, preset="haze")`.

{table}
[Defaults.csv](Defaults.csv) has the numbers of each data set and each way to draw it.

- **shafts**: maxima of the background's lightness by direction from the sun that stand out by 3 L\\* on both sides. The
  lightness is the mean from 0.2 to 0.8 picture heights from the sun. Hidden parts do not change it: a round glow
  without shafts behind any data counts 0.
- **of 8 L\\***: those that stand out by 8 L\\*.
- **area**: part of the background that differs by 2 L\\* from its mean over 30 degrees about the sun [%].
- **dE**: mean CIE 1976 distance between data without and with rays, where they have at least 20 L\\* without. A
  distance of 2 to 3 is just visible.
- **hue**: mean change of the hue of these data, where their chroma is above 10 [degrees].
- **clipped**: part of the data of which a channel became 255 [%].
- **dL\\***: mean change of the lightness of data. Without rays VTK's headlight is the only light. The program has
  lights of its own.
- **mud**: part of the background between 12 and 60 L\\* with a chroma below 6 [%].
- **ground**: median lightness of the background [L\\*].

The numbers are of pictures without anti-aliasing: a pixel shows data or the background. The program's pictures are
anti-aliased; there, the edges of data are left out, where these cover 10 to 90 % of a pixel.

## Pictures

Each row shows a data set without rays, with `godrays.enable(renderer)`, and with
`godrays.enable(renderer, preset="haze")`. The command above draws one of them if its name follows as the last argument.
{captions}
## The program

![data sets as the program draws them](defaults/program.jpg)

`godrays FILE --size 480x300 --output picture.png`, in the order above, without the molecule.

## Light backgrounds

![data sets before white](defaults/look-before-white.jpg)

`renderer.SetBackground(1, 1, 1)` and `godrays.enable(renderer)`, in the order above.

## Other backgrounds

![cones before nine backgrounds](defaults/backgrounds.jpg)

The table's rows are in the order of the pictures.

{backgrounds}
## Other situations

![scenes that are lit and made in other ways](defaults/situations.jpg)

The scenes of `default_situations.py` have other lights, sizes, materials and kinds of props. A look has no shafts if
the sun is wholly hidden, and `GetAdvice()` says so. Light before dark data is not limited, since a silhouette has no
colours to keep.

{situations}"""

if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
