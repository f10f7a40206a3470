# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own window: what window.xml does in it, as a user would, is shown.

Plain Python, which starts GODRAYS_PARAVIEW on an X server of its own (GODRAYS_XVFB), of whose
screen it takes a picture.
"""

import contextlib
import math
import os
import pathlib
import signal
import struct
import subprocess
import tempfile
import time
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

HERE = pathlib.Path(__file__).parent
PLUGINS = pathlib.Path(os.environ["GODRAYS_PLUGIN"]).parents[1]
TEMPORARY = pathlib.Path(os.environ["GODRAYS_TEMPORARY"])
WIDTH, HEIGHT = 1400, 1040
VIEW = slice(250, 980), slice(320, 1380)  # rows and columns of the view's inside
PANEL = slice(600, 980), slice(10, 260)  # of the properties of the view
ICON = 36, 48  # rows and columns of a preset's picture in the panel
LANTERN = 495  # its column in the view
LIMIT = 400  # seconds, on a busy machine


@contextlib.contextmanager
def running(*command, **options):
    """A process, which is ended with all that it has started.

    It shares no pipe with this one: what it leaves behind would keep the pipe open, and whoever
    waits for its end, such as ctest, waiting.
    """
    process = subprocess.Popen(
        command, start_new_session=True, stdin=subprocess.DEVNULL, **options
    )
    try:
        yield process
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def until(done, what):
    """Wait until done() is true."""
    end = time.monotonic() + LIMIT
    while not done():
        if time.monotonic() > end:
            raise AssertionError(f"{what} took more than {LIMIT} s")
        time.sleep(0.2)


def read_screen(file):
    """The screen of Xvfb, a file in the format XWD: rows from the top, red, green and blue."""
    data = file.read_bytes()
    header = struct.unpack(">25I", data[:100])
    width, height, row, colors = header[4], header[5], header[12], header[19]
    begin = header[0] + 12 * colors
    values = numpy.frombuffer(data[begin : begin + row * height], numpy.uint8)
    return values.reshape(height, row)[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1]


def write_png(pixels, file):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    values = numpy.ascontiguousarray(pixels[::-1]).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()


def read_icon(file):
    """A picture as it is shown in the panel: rows from the top, each pixel the mean of those it covers."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    for axis, size in enumerate(ICON):
        values = values.repeat(size // math.gcd(size, values.shape[axis]), axis)
    rows, columns, _ = values.shape
    cells = values[::-1, :, :3].reshape(ICON[0], rows // ICON[0], ICON[1], columns // ICON[1], 3)
    return cells.mean((1, 3))


def to_light(picture):
    shown = picture / 255
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


class Window(unittest.TestCase):
    def assert_icon(self, shown, preset):
        """The panel has the picture of a preset: some place is like it, and like no other preset's."""
        if not os.environ["GODRAYS_PANEL"]:
            return  # built without Qt
        pictures = {
            file.stem.removeprefix("Preset-"): read_icon(file)
            for file in (HERE.parent / "Baseline").glob("Preset-*.png")
        }
        # a column of labels is before it, as wide as the font has it; every fourth pixel is enough
        places = numpy.lib.stride_tricks.sliding_window_view(shown[PANEL], (*ICON, 3))[:, :, 0, ::4, ::4]
        away = {}
        for name, picture in pictures.items():
            away[name] = min(abs(row - picture[::4, ::4]).mean((1, 2, 3)).min() for row in places)
        others = min(value for name, value in away.items() if name != preset)
        self.assertLess(away[preset], others / 2, "the panel lacks the preset's picture")

    def play(self, name, script=HERE / "window_scene.py", events="window.xml", **environment):
        """The screen after script and events; its picture is left in GODRAYS_TEMPORARY."""
        with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as ends:
            folder = pathlib.Path(folder)
            folder.chmod(0o700)
            reader, writer = os.pipe()
            ends.enter_context(
                running(
                    os.environ["GODRAYS_XVFB"], "-displayfd", str(writer), "-noreset",
                    "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", str(folder),
                    pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                )  # fmt: skip
            )
            os.close(writer)
            with os.fdopen(reader) as pipe:
                display = ":" + pipe.readline().strip()
            log = folder / "log"
            window = ends.enter_context(
                running(
                    os.environ["GODRAYS_PARAVIEW"],
                    "--dr",  # with the settings of a first start
                    "-qwindowgeometry", f"{WIDTH}x{HEIGHT}+0+0",
                    f"--script={script}",
                    f"--test-script={HERE / events}",
                    stdout=ends.enter_context(open(log, "w", encoding="utf-8")),
                    stderr=subprocess.STDOUT,
                    env={
                        **os.environ,
                        "DISPLAY": display,
                        "HOME": str(folder),
                        "XDG_RUNTIME_DIR": str(folder),
                        "DBUS_SESSION_BUS_ADDRESS": "disabled:",  # else one is started
                        "QT_QPA_PLATFORM": "xcb",
                        "PV_PLUGIN_CONFIG_FILE": str(PLUGINS / "godrays.xml"),
                        **environment,
                    },
                )  # fmt: skip
            )

            def played():
                said = log.read_text(errors="replace")
                # after a step that fails ParaView waits
                return window.poll() is not None or "is finished" in said or "critical:" in said

            until(played, "the script")
            said = log.read_text(errors="replace")
            self.assertRegex(said, "Success = *true", said)

            last = [None] * 5

            def steady():
                last.append(read_screen(folder / "Xvfb_screen0").copy())
                last.pop(0)
                return last[0] is not None and all(
                    numpy.array_equal(each[VIEW], last[0][VIEW]) for each in last
                )

            until(steady, "drawing")
        write_png(last[0], TEMPORARY / f"{name}.png")
        return last[0].astype(int)

    def test_it_shows_the_rays_and_their_properties(self):
        lit = self.play("window")
        plain = self.play("window-plain", GODRAYS_DISABLE="1")
        change = (lit - plain)[VIEW]
        # in linear light: versions of ParaView have grounds of another grey, where the same light is fewer levels
        light = (to_light(lit) - to_light(plain))[VIEW]
        self.assertGreater((light.max(2) > 0.05).mean(), 0.5)
        self.assertLess((change.min(2) < -3).mean(), 1e-4, "light was taken away")
        above = change[:60].mean((0, 2))  # over the columns, from left to right
        self.assertLess(abs(above.argmax() - LANTERN), 60, "no shaft above the lantern")
        self.assertGreater(above.max() - above.min(), 15)
        # towards the lantern, which is below, light grows: LightSource has left no sun over the columns
        over = change[:150, LANTERN - 100 : LANTERN + 100].max((1, 2))
        self.assertGreater(over[-10:].max(), over[:-30].max(), "a sun shines, too")
        for shown in (lit, plain):
            # text, in its lines, on what is light
            dark = shown[PANEL].max(2) < 100
            self.assertGreater(numpy.median(shown[PANEL]), 200)
            self.assertGreater(dark.mean(), 0.005)
            self.assertLess(dark.mean(), 0.2)
        # Alike, but for the sun: only a frame with rays places it.
        self.assertLess((abs(lit - plain)[PANEL].max(2) > 3).mean(), 0.02, "the panels differ")
        self.assert_icon(lit, "long-shafts")

    def test_the_tutorial(self):
        script = HERE.parents[1] / "Examples" / "ParaView" / "contours.py"
        shown = self.play("tutorial", script, "window_tutorial.xml")
        self.assert_icon(shown, "low-sun")
        lit = shown[VIEW]
        plain = self.play("tutorial-plain", script, "window_tutorial.xml", GODRAYS_DISABLE="1")[VIEW]
        light = (lit - plain).mean(2)
        dark = plain.max(2) < 30  # the background
        self.assertGreater(dark.mean(), 0.5)
        low, high = numpy.percentile(light[dark], (10, 90))
        self.assertGreater(high - low, 25, "no shafts beside the data")
        hues = [(each - each.mean(2, keepdims=True))[~dark].ravel() for each in (lit, plain)]
        self.assertGreater(numpy.corrcoef(*hues)[0, 1], 0.7, "the data's colours are lost")


unittest.main(verbosity=2)
