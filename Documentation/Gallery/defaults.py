# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What god rays do to data by themselves: data sets without and with them, with defaults alone, and
numbers for what became of the data's colours.

Usage: defaults.py <folder>

Writes Defaults.md and its pictures there. VTK's own renderers and cameras are as they come.
"""

import math
import os
import sys
import typing

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import default_scenes
import default_situations
import godrays

SIZE = (400, 280)
COLUMNS = {"a look": {}, "a medium": {"preset": "haze"}}
# as rays were before the picture said how strong they are: whose shafts' contrast is to be kept by half
PLAIN = {
    "background_glow": 0.4,
    "background_glow_falloff": 18,
    "automatic_exposure": False,
    "highlight_shoulder": False,
    "darken_light_background": False,
}
FIRST = {"data first": {"data_first": True}}
NEARLY_GREY = 10  # mean chroma, of which 10 % are not seen


class Numbers(typing.NamedTuple):
    """What rays change of data and of what is beside them."""

    difference: float  # mean distance in L*a*b*
    chroma: float | None  # part of the data's mean that is left; None where they are nearly grey
    tint: float  # by how much the data's mean chroma grows
    clipped: float  # percent of the data
    contrast: float  # of the shafts [L*]


def read(window, buffer):
    """The window's pixels [row, column, channel] from the lower left."""
    reader = vtk.vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    if buffer == "depth":
        reader.SetInputBufferTypeToZBuffer()
    elif buffer == "alpha":
        reader.SetInputBufferTypeToRGBA()
    reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1).astype(float)


def to_light(picture):
    """Linear light of what sRGB shows, from 0 to 255."""
    shown = picture / 255
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def to_lab(picture):
    """CIE 1976 L*a*b* of what sRGB shows, from 0 to 255."""
    light = to_light(picture)
    matrix = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    xyz = light @ numpy.transpose(matrix) / (0.9505, 1.0, 1.089)
    x, y, z = numpy.moveaxis(
        numpy.where(xyz > 216 / 24389, numpy.cbrt(xyz), xyz * 841 / 108 + 4 / 29), -1, 0
    )
    return numpy.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], -1)


def get_contrast(change, place, where=True):
    """How much light changes along circles about the sun, apart from slow changes: the root mean square
    of the lightness less its mean over 30 degrees [L*], of the pixels where a mask is."""
    height, width = change.shape
    y, x = numpy.mgrid[0:height, 0:width] + 0.5
    x, y = x - place[0] * width, y - place[1] * height
    count = 192
    ring = (numpy.hypot(x, y) / 2).astype(int)
    angle = ((numpy.arctan2(y, x) / (2 * math.pi) + 0.5) * count).astype(int) % count
    sums = numpy.zeros((ring.max() + 1, count))
    counts = numpy.zeros_like(sums)
    numpy.add.at(sums, (ring, angle), change * where)
    numpy.add.at(counts, (ring, angle), where)
    window = count // 12
    squares = []
    for values, known in zip(sums[5:], counts[5:]):
        mean = numpy.zeros(count)
        weight = numpy.zeros(count)
        for shift in range(-(window // 2), window // 2 + 1):
            mean += numpy.roll(values, shift)
            weight += numpy.roll(known, shift)
        some = known > 0
        squares.extend((values[some] / known[some] - mean[some] / weight[some]) ** 2)
    return math.sqrt(numpy.mean(squares))


def get_place(renderer, light):
    """Where a lamp or a sun stands in the picture, from (0, 0) to (1, 1)."""
    camera = renderer.GetActiveCamera()
    place = numpy.array(light.GetTransformedPosition())
    if not light.GetPositional():
        direction = place - light.GetTransformedFocalPoint()
        far = camera.GetClippingRange()[1] * direction / numpy.linalg.norm(direction)
        place = camera.GetPosition() + far
    renderer.SetWorldPoint(*place, 1)
    renderer.WorldToView()
    return [(each + 1) / 2 for each in renderer.GetViewPoint()[:2]]


def measure(before, after, data, place):
    lab, changed = to_lab(before), to_lab(after)
    difference = numpy.linalg.norm(changed - lab, axis=-1)
    chroma = [numpy.hypot(each[..., 1], each[..., 2])[data].mean() for each in (lab, changed)]
    clipped = (after.max(-1) == 255) & (before.max(-1) < 255)
    return Numbers(
        difference[data].mean(),
        chroma[1] / chroma[0] if chroma[0] > NEARLY_GREY else None,
        chroma[1] - chroma[0],
        100 * clipped[data].mean(),
        get_contrast(changed[..., 0] - lab[..., 0], place),
    )


def expect_colors(test, numbers, least_chroma=0.9):
    """Expect what is promised of data's colours, in a unittest.TestCase."""
    test.assertLess(numbers.difference, 10)
    test.assertLess(numbers.clipped, 0.5)
    if numbers.chroma is None:
        test.assertGreater(numbers.tint, -2.5)
    else:
        test.assertGreater(numbers.chroma, least_chroma)
    if numbers.chroma is None or numbers.chroma > 1.1:
        test.assertLess(numbers.tint, 2.5)  # just visible


def write(pictures, name):
    """Pictures side by side, as a JPEG."""
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
    """Pictures in rows, as a JPEG."""
    pictures = pictures + [numpy.zeros_like(pictures[0])] * (-len(pictures) % columns)
    rows = [numpy.concatenate(pictures[i : i + columns], axis=1) for i in range(0, len(pictures), columns)]
    write([numpy.concatenate(rows[::-1], axis=0)], name)


def draw(name, background=None, samples=0, columns=None, make=default_scenes.make):
    """Pictures of a scene without rays and with each of some columns, by default COLUMNS; what of them shows
    data; where the sun of each stands."""
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
    for parameters in (columns or COLUMNS).values():
        rays = godrays.enable(renderer, **parameters)
        window.Render()
        shown.append(read(window, "colour"))
        places.append(get_place(renderer, rays.GetLight(0)))
        godrays.disable(renderer)
    window.Finalize()
    return shown, data, places


def measure_all(name, background=None, more=None, make=default_scenes.make):
    """The numbers of each of COLUMNS, and of more of them, by default PLAIN, where a pixel shows either data
    or a background; and how much of the picture data are."""
    columns = COLUMNS | (more or {"plain": PLAIN})
    (before, *with_rays), data, places = draw(name, background, columns=columns, make=make)
    numbers = [measure(before, after, data, place) for after, place in zip(with_rays, places)]
    print(name, background or "", numbers, flush=True)
    return numbers, 100 * data.mean()


def main(folder):
    pictures = os.path.join(folder, "defaults")
    os.makedirs(pictures, exist_ok=True)
    rows = []
    for name, (what, *_) in default_scenes.SCENES.items():
        shown, _, _ = draw(name, samples=8)
        write(shown, os.path.join(pictures, f"{name}.jpg"))
        numbers, fill = measure_all(name)
        rows.append((name, what, fill, numbers))
    before_others = []
    for background in default_scenes.BACKGROUNDS:
        file = "before-" + background.replace(" ", "-") + ".jpg"
        shown, _, _ = draw("cones", background, samples=8)
        write(shown, os.path.join(pictures, file))
        before_others.append((background, file, measure_all("cones", background)[0]))
    situations = []
    sheet = []
    for name in default_situations.SITUATIONS:
        shown, _, _ = draw(name, make=default_situations.make)
        sheet.append(shown[1][::2, ::2])
        situations.append((name, *measure_all(name, more=FIRST, make=default_situations.make)))
    write_sheet(sheet, os.path.join(pictures, "situations.jpg"))

    def format_numbers(numbers):
        is_grey = numbers.chroma is None
        kept = f"grey {numbers.tint:+.1f}" if is_grey else f"{100 * numbers.chroma:.0f} %"
        return f"{numbers.difference:.1f} | {kept} | {numbers.clipped:.2f} % | {numbers.contrast:.1f}"

    with open(os.path.join(folder, "Defaults.md"), "w", encoding="utf-8") as page:
        page.write(PAGE.format(count=len(rows)))
        for name, what, fill, numbers in rows:
            page.write(f"\n![{what}](defaults/{name}.jpg)\n\n**{what}**, {fill:.0f} % of the picture\n\n")
            page.write("| | dE | chroma | clipped | contrast |\n|---|---|---|---|---|\n")
            for column, each in zip(COLUMNS, numbers):
                page.write(f"| {column} | {format_numbers(each)} |\n")
        page.write("\n## Before other backgrounds\n")
        for background, file, numbers in before_others:
            page.write(f"\n![cones before a background: {background}](defaults/{file})\n\n")
            page.write(f"**{background}**\n\n")
            page.write("| | dE | chroma | clipped | contrast |\n|---|---|---|---|---|\n")
            for column, each in zip(COLUMNS, numbers):
                page.write(f"| {column} | {format_numbers(each)} |\n")
        page.write("\n## All of them\n\n")
        page.write("| | dE of a look | chroma | clipped | contrast | plain ")
        page.write("| dE of a medium | chroma | clipped | contrast |\n")
        page.write("|---|---|---|---|---|---|---|---|---|---|\n")
        for name, what, fill, (look, medium, plain) in rows:
            page.write(f"| {what} | {format_numbers(look)} | {plain.contrast:.1f} ")
            page.write(f"| {format_numbers(medium)} |\n")
        page.write(SITUATIONS)
        page.write("| | dE of a look | chroma | clipped | contrast ")
        page.write("| dE of a medium | chroma | clipped | contrast | dE, data first | chroma |\n")
        page.write("|---|---|---|---|---|---|---|---|---|---|---|\n")
        for name, (look, medium, first), fill in situations:
            page.write(f"| {name} | {format_numbers(look)} | {format_numbers(medium)} ")
            page.write("| " + " | ".join(format_numbers(first).split(" | ")[:2]) + " |\n")


PAGE = """# What happens by itself

{count} data sets, each without rays, with `godrays.enable(renderer)`, and with
`godrays.enable(renderer, preset="haze")`: nothing else is set, neither camera nor lights nor background, so
this is what a first script shows. Made by

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \\
      /usr/bin/python3 Documentation/Gallery/defaults.py Documentation/Gallery

The numbers are of pictures without anti-aliasing, in which a pixel shows either data or the background:

- dE: how far data change on average, as a distance in CIE 1976 L\\*a\\*b\\*; 2 to 3 are just visible. It is
  to be below 10, in a medium, too, whose data have the light back that it takes of them on average, up to
  twofold.
- chroma: how much of the data's there is with rays, 90 to 110 %; of data that are nearly grey, with a chroma
  below 10, how much more or less, of which 2.5 are allowed.
- clipped: data of which a channel became 255, in percent of the data.
- contrast of the shafts: the root mean square of their lightness along circles about the sun, less its mean
  over 30 degrees [L\\*]; plain, that of the sum as it is, with the wider glow of former versions and no
  choice of a strength, of which at least half is to be kept.
"""

SITUATIONS = """
## Other situations

Scenes that are lit, made or seen in other ways, in `default_situations.py`; data first is
`godrays.enable(renderer, data_first=True)`. Where all of the sun is hidden, a look has no shafts,
and `GetAdvice()` says so. Where most data are dark, as a silhouette is, light before them is what one sees, and is
not held back for their sake.

![the look of each, in the table's order](defaults/situations.jpg)

"""

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    main(sys.argv[1])
