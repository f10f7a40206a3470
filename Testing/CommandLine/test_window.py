# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The window of the program godrays (its path is in GODRAYS_PROGRAM), and its keys, on an X server."""

import ctypes
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from program_testing import ProgramTest


class KeyEvent(ctypes.Structure):
    """XKeyEvent of Xlib, with the room that the library takes for any event."""

    _fields_ = [
        ("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("root", ctypes.c_ulong),
        ("subwindow", ctypes.c_ulong), ("time", ctypes.c_ulong), ("x", ctypes.c_int),
        ("y", ctypes.c_int), ("x_root", ctypes.c_int), ("y_root", ctypes.c_int),
        ("state", ctypes.c_uint), ("keycode", ctypes.c_uint), ("same_screen", ctypes.c_int),
        ("room", ctypes.c_long * 24),
    ]


class ClientMessage(ctypes.Structure):
    """XClientMessageEvent of Xlib."""

    _fields_ = [
        ("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
        ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("room", ctypes.c_long * 24),
    ]


class SelectionEvent(ctypes.Structure):
    """XSelectionEvent of Xlib."""

    _fields_ = [
        ("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), ("requestor", ctypes.c_ulong), ("selection", ctypes.c_ulong),
        ("target", ctypes.c_ulong), ("property", ctypes.c_ulong), ("time", ctypes.c_ulong),
        ("room", ctypes.c_long * 24),
    ]


class WindowAttributes(ctypes.Structure):
    """XWindowAttributes of Xlib."""

    _fields_ = [
        ("numbers", ctypes.c_int * 6), ("visual", ctypes.c_void_p), ("root", ctypes.c_ulong),
        ("kinds", ctypes.c_int * 4), ("planes", ctypes.c_ulong * 2), ("save_under", ctypes.c_int),
        ("colormap", ctypes.c_ulong), ("installed", ctypes.c_int), ("map_state", ctypes.c_int),
        ("all_event_masks", ctypes.c_long), ("others", ctypes.c_long * 8),
    ]


class Screen:
    """The X server of DISPLAY, as far as windows are found and keys are pressed there."""

    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.root = self.x.XDefaultRootWindow(self.display)
        # Windows of other programs may go while they are looked at: that is no error here.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(lambda *_: 0)
        self.x.XSetErrorHandler(self.ignore)

    def close(self):
        self.x.XCloseDisplay(self.display)

    def find_window(self, size):
        """The window of the program that has this size, and its title; None if there is none."""
        root, parent, windows = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.POINTER(ctypes.c_ulong)()
        numbers = [ctypes.c_uint() for _ in range(6)]
        to = ctypes.byref
        self.x.XQueryTree(
            self.display, ctypes.c_ulong(self.root), to(root), to(parent), to(windows),
            to(numbers[0]))
        for window in windows[: numbers[0].value]:
            title = ctypes.c_char_p()
            self.x.XFetchName(self.display, ctypes.c_ulong(window), to(title))
            is_there = self.x.XGetGeometry(
                self.display, ctypes.c_ulong(window), to(root), *map(to, numbers))
            is_size = (numbers[2].value, numbers[3].value) == size
            if is_there and is_size and (title.value or b"").startswith(b"godrays"):
                return window, title.value.decode()
        return None

    def look(self, window, size):
        """What the window shows, as rows of RGB from the top."""
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        image = self.x.XGetImage(
            self.display, ctypes.c_ulong(window), 0, 0, *size, ctypes.c_ulong(0xFFFFFFFF), 2)
        if not image:
            return numpy.zeros((*size[::-1], 3), int)  # it is not on the screen yet
        length = image.contents.bytes_per_line * size[1]
        data = numpy.ctypeslib.as_array(image.contents.data, (length,)).copy()
        self.x.XDestroyImage(image)
        return data.reshape(size[1], -1, 4)[:, : size[0], 2::-1].astype(int)

    def takes_keys(self, window):
        """Whether a program has asked for the window's keys. Those that are pressed before are lost."""
        attributes = WindowAttributes()
        return (self.x.XGetWindowAttributes(self.display, ctypes.c_ulong(window), ctypes.byref(attributes)) and
            bool(attributes.all_event_masks & 1))

    def send(self, window, kind, mask, **values):
        event = KeyEvent(type=kind, window=window, root=self.root, same_screen=1, **values)
        self.x.XSendEvent(
            self.display, ctypes.c_ulong(window), 0, ctypes.c_long(mask), ctypes.byref(event))
        self.x.XFlush(self.display)

    def press(self, window, name):
        """A key by its X name, after "shift+" with that one held."""
        shift = name.startswith("shift+")
        symbol = ctypes.c_ulong(self.x.XStringToKeysym(name.removeprefix("shift+").encode()))
        code = self.x.XKeysymToKeycode(self.display, symbol)
        for kind, mask in ((2, 1), (3, 2)):  # pressed and released
            self.send(window, kind, mask, keycode=code, state=1 if shift else 0)

    def drop(self, window, files):
        """Files from a program that holds them, which is the screen here: as XDND has it."""
        def atom(name):
            self.x.XInternAtom.restype = ctypes.c_ulong
            return self.x.XInternAtom(self.display, name.encode(), 0)
        text = "".join(f"file://{file}\r\n" for file in files).encode()
        kinds = atom("XdndSelection"), atom("text/uri-list")
        self.x.XChangeProperty(
            self.display, ctypes.c_ulong(window), *map(ctypes.c_ulong, kinds), 8, 0, text, len(text))
        for name in "XdndEnter", "XdndPosition":
            event = ClientMessage(
                type=33, window=window, message_type=atom(name), format=32,
                data=(self.root, 5 << 24, 0, 0, 0))
            self.x.XSendEvent(
                self.display, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(event))
        event = SelectionEvent(
            type=31, requestor=window, selection=kinds[0], target=kinds[1], property=kinds[0])
        self.x.XSendEvent(
            self.display, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(event))
        self.x.XFlush(self.display)

    def drag(self, window, start, end, before_release=lambda: None):
        """With the left button from a place of the window, from its upper left, to another one."""
        steps = 5
        places = [[a + (b - a) * i // steps for a, b in zip(start, end)] for i in range(steps + 1)]
        self.x.XWarpPointer(
            self.display, ctypes.c_ulong(0), ctypes.c_ulong(window), 0, 0, 0, 0, *start)
        self.send(window, 6, 1 << 6, x=start[0], y=start[1])
        time.sleep(0.5)  # until it is over the handle
        self.send(window, 4, 1 << 2, x=start[0], y=start[1], keycode=1)
        for x, y in places[1:]:
            time.sleep(0.1)  # VTK skips all but the last of those that are there
            # It asks where the pointer is.
            self.x.XWarpPointer(
                self.display, ctypes.c_ulong(0), ctypes.c_ulong(window), 0, 0, 0, 0, x, y)
            self.send(window, 6, 1 << 6, x=x, y=y, state=1 << 8)
        before_release()
        self.send(window, 5, 1 << 3, x=end[0], y=end[1], keycode=1, state=1 << 8)


class Image(ctypes.Structure):
    """The beginning of XImage of Xlib."""

    _fields_ = [
        ("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int),
        ("format", ctypes.c_int), ("data", ctypes.POINTER(ctypes.c_ubyte)),
        ("byte_order", ctypes.c_int), ("bitmap_unit", ctypes.c_int), ("bitmap_bit_order", ctypes.c_int),
        ("bitmap_pad", ctypes.c_int), ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int),
    ]


class Window(ProgramTest):
    SIZE = (123, 77)  # that no other program on the screen has

    def draw_and_press(self, *keys):
        """From the last look or medium of ours press N, which brings the first one, then these keys, then Q; the
        picture written at the end."""
        screen = Screen()
        self.addCleanup(screen.close)
        path = self.folder / "window.png"
        path.unlink(missing_ok=True)
        program = subprocess.Popen(
            [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", "{}x{}".format(*self.SIZE),
             "--preset", "sea-water", "--interactive", "--output", path],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.kill)
        end = time.monotonic() + 60
        window, title = None, ""
        while title != "godrays: default":
            self.assertLess(time.monotonic(), end, "the window did not take N")
            self.assertIsNone(program.poll(), "the program ended")
            time.sleep(0.2)
            is_new = window is None
            window, title = screen.find_window(self.SIZE) or (None, "")
            window = window if window and screen.takes_keys(window) else None
            if window and is_new:
                screen.press(window, "n")
        for key in *keys, "q":
            screen.press(window, key)
        self.assertEqual((*program.communicate(timeout=60), program.returncode), ("", "", 0))
        return self.read(path, self.SIZE)

    def test_keys(self):
        usual = self.draw(self.mesh, "--preset", "default", size=self.SIZE)
        for key, arguments in (("g", ["--no-rays"]), ("o", ["--show", "rays"])):
            with self.subTest(key):
                expected = self.draw(
                    self.mesh, "--preset", "default", *arguments, size=self.SIZE)
                picture = self.draw_and_press(key)
                self.assertGreater(abs(usual - expected).max(), 20)
                self.assertLess(abs(picture - expected).max(), 3)


class Viewer(ProgramTest):
    """Each test opens one window."""

    SIZE = (301, 203)  # that no other program on the screen has

    def open(self, *arguments):
        self.screen = Screen()
        self.addCleanup(self.screen.close)
        self.output = self.folder / "viewer.png"
        self.output.unlink(missing_ok=True)
        self.program = subprocess.Popen(
            [os.environ["GODRAYS_PROGRAM"], *map(str, arguments), "--size",
             "{}x{}".format(*self.SIZE), "--interactive", "--output", self.output],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        self.addCleanup(self.program.kill)
        self.wait(lambda: self.screen.find_window(self.SIZE) is not None)
        self.window = self.screen.find_window(self.SIZE)[0]
        self.wait(lambda: self.screen.takes_keys(self.window))
        self.screen.press(self.window, "c")
        self.program.stdout.readline()  # it answers keys, and has drawn the status line
        self.press("z")  # without that, whose numbers change

    def wait(self, condition, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "nothing happened")
            self.assertIsNone(self.program.poll(), "the program ended")
            time.sleep(0.1)

    def look(self):
        return self.screen.look(self.window, self.SIZE)

    def work(self):
        """What the program has used of the processors, and whether it waits for them: a picture may stay for
        long on a busy machine while a key is not yet answered."""
        states = [file.read_text().rpartition(")")[2].split()
            for file in pathlib.Path(f"/proc/{self.program.pid}/task").glob("*/stat")]
        return [each[11:13] for each in states], any(each[0] != "S" for each in states)

    def steady(self):
        """What is shown when nothing has changed for a while, and the program waits for events."""
        former, (used, waits) = self.look(), self.work()
        while True:
            time.sleep(0.3)
            picture, now = self.look(), self.work()
            if (former == picture).all() and not waits and now == (used, False):
                return picture
            former, (used, waits) = picture, now

    def press(self, key, expected=None):
        """Press a key, and wait until the window has changed. Returns what it shows then."""
        before = self.steady()
        self.screen.press(self.window, key)
        self.wait(lambda: (expected or (lambda now: abs(now - before).max() > 20))(self.look()))
        return self.steady()

    def drag(self, start, end, before_release=lambda: None):
        self.screen.drag(self.window, start, end, before_release)
        time.sleep(0.5)
        return self.steady()

    def end(self):
        """The picture written at the end, as rows of RGB from the foot, and what was printed."""
        self.screen.press(self.window, "q")
        printed = self.program.communicate(timeout=60)
        self.assertEqual((self.program.returncode, printed[1]), (0, ""))
        return self.read(self.output, self.SIZE), printed[0]

    def assert_same(self, picture, other):
        """But for a hundredth of the pixels: the text of a message, or single lines of the rays, which
        frames after the first work out otherwise."""
        self.assertLess((abs(picture - other).max(axis=2) > 3).mean(), 0.01)

    def disc(self, picture, color=(255, 204, 51)):
        """The place of what has a colour of the handle of the light, from the upper left."""
        rows, columns = numpy.nonzero(abs(picture - color).max(axis=2) < 40)
        self.assertGreater(len(rows), 5, "there is no handle")
        return columns.mean(), rows.mean()

    def test_keys_that_lay_something_over_the_picture(self):
        self.open(self.mesh)
        plain = self.steady()
        for key in "h", "shift+question", "x", "b", "m", "z":
            with self.subTest(key):
                shown = self.press(key)
                again = self.press(key)
                self.assertGreater((abs(shown - plain).max(axis=2) > 20).sum(), 50)
                self.assert_same(again, plain)
        self.press("h")
        picture, _ = self.end()
        self.assert_same(picture, self.draw(self.mesh, size=self.SIZE))

    def test_vtks_own_keys_do_nothing(self):
        self.open(self.mesh)
        plain = self.steady()
        for key in "3", "p", "w", "e", "j", "f":
            self.screen.press(self.window, key)
        time.sleep(1)
        self.assert_same(self.steady(), plain)
        self.end()

    def test_the_light_is_moved_by_keys_and_by_its_handle(self):
        self.open(self.mesh, "--camera", "180,0", "--sun", "5,10", "--intensity", "0.2")
        before = self.disc(self.press("l"))
        right = self.disc(self.press("shift+Right"))
        self.assertGreater(right[0], before[0] + 10)
        above = self.disc(self.press("Up"))
        self.assertLess(above[1], right[1] - 2)
        place = 60, 60
        discs = []
        self.drag([round(each) for each in above], place,
            lambda: discs.append(self.disc(self.steady(), (255, 255, 255))))  # white while it is held
        discs.append(self.disc(self.steady()))
        for disc in discs:
            self.assertLess(max(abs(a - b) for a, b in zip(disc, place)), 8)
        self.screen.press(self.window, "c")
        picture, printed = self.end()
        again = self.draw(self.mesh, *printed.split(), size=self.SIZE, told=None)
        self.assertLess(abs(picture - again).mean(), 1)
        self.assertIn("--preset default", printed)
        self.assertIn("--view-up", printed)

    def test_the_divider(self):
        """What is right of it has rays."""
        self.open(self.mesh)
        rays = self.steady()
        half = self.press("d")
        without = self.draw(self.mesh, "--no-rays", size=self.SIZE)[::-1]
        middle = self.SIZE[0] // 2
        self.assert_same(half[:, : middle - 10], without[:, : middle - 10])
        self.assert_same(half[:, middle + 10 :], rays[:, middle + 10 :])
        self.assertGreater(abs(rays - without)[:, : middle - 10].max(), 20)
        moved = self.drag((middle, self.SIZE[1] // 2), (middle - 70, self.SIZE[1] // 2))
        self.assert_same(moved[:, : middle - 80], without[:, : middle - 80])
        self.assert_same(moved[:, middle - 60 :], rays[:, middle - 60 :])
        picture, _ = self.end()
        self.assert_same(picture[::-1], rays)

    def test_sliders(self):
        self.open(self.mesh, "--intensity", "0.5")
        plain = self.steady()
        shown = self.press("t")
        is_knob = (abs(shown - (255, 204, 51)).max(axis=2) < 40) & (abs(shown - plain).max(axis=2) > 40)
        rows, columns = numpy.nonzero(is_knob)
        self.assertGreater(len(rows), 100, "there are no sliders")
        self.assertEqual((numpy.diff(numpy.unique(rows)) > 5).sum() + 1, 4, "one for each number")
        top = rows < rows.min() + 12
        place = round(columns[top].mean()), round(rows[top].mean())
        moved = self.drag(place, (place[0] - 25, place[1]))
        self.assertLess(moved.mean(), shown.mean() - 0.5, "the rays are as strong")
        again = self.press("t")
        self.screen.press(self.window, "c")
        picture, printed = self.end()
        self.assertRegex(printed, r"--intensity 0\.[01]")
        self.assertGreater(abs(again - plain).max(), 20)
        self.assert_same(picture, self.draw(self.mesh, *printed.split(), size=self.SIZE, told=None))

    def test_files_that_are_dropped(self):
        self.open(self.mesh, "--quiet")
        plain = self.steady()
        for with_key in (True, False):
            self.screen.drop(self.window, [self.folder / "none.vtp"])
            self.wait(lambda: abs(self.look() - plain).max() > 20)  # the message
            if with_key:
                self.press("z")  # a key takes it away, as does another drop
                self.assert_same(self.press("z"), plain)
        self.screen.drop(self.window, [self.folder / "a.gltf"])
        self.wait(lambda: (abs(self.look() - plain).max(axis=2) > 20).mean() > 0.05)
        picture, _ = self.end()
        self.assert_same(picture, self.draw(self.folder / "a.gltf", size=self.SIZE, told=None))

    def test_a_file_that_was_dropped_is_not_written_over(self):
        numbers = self.folder / "dropped.vti"
        for option, file, arguments in (
            ("--output", self.folder / "viewer.png", []),
            ("--numbers", numbers, ["--preset", "haze", "--numbers", numbers]),
        ):
            with self.subTest(option):
                self.open(self.mesh, "--quiet", *arguments)
                shutil.copy(self.folder / f"a{file.suffix}", file)
                held = file.read_bytes()
                plain = self.steady()
                self.screen.drop(self.window, [file])
                self.wait(lambda: (abs(self.look() - plain).max(axis=2) > 20).mean() > 0.05)
                self.screen.press(self.window, "q")
                _, told = self.program.communicate(timeout=60)
                self.assertEqual(self.program.returncode, 3, told)
                for word in option, str(file), "file to be read", "another name":
                    self.assertIn(word, told)
                self.assertEqual(file.read_bytes(), held)

    def test_views_presets_and_strength(self):
        self.open(self.mesh)
        plain = self.steady()
        self.press("shift+plus", lambda now: now.mean() > plain.mean() + 0.5)
        self.press("minus", lambda now: now.mean() < plain.mean() + 0.2)
        views = [self.press("v") for _ in range(4)]
        depth = views[2]
        self.assertEqual(abs(depth[40:, :, :1] - depth[40:]).max(), 0, "depths are grey")
        covered = (depth[40:, :, 0] > 40).mean()
        self.assertTrue(0.2 < covered < 0.5, covered)
        self.assertLess(views[3].mean(), 20)  # the error
        self.press("v")
        self.press("n")
        self.assertEqual(self.screen.find_window(self.SIZE)[1], "godrays: low-sun")
        self.press("shift+N")
        self.assertEqual(self.screen.find_window(self.SIZE)[1], "godrays: default")
        self.press("u")
        picture, _ = self.end()
        black = self.draw(self.mesh, "--background", "black", size=self.SIZE)
        self.assert_same(picture, black)

    def test_home_and_the_screenshot(self):
        self.open(self.mesh)
        plain = self.steady()
        moved = self.drag((150, 150), (210, 120))
        self.assertGreater(abs(moved - plain).max(), 20)
        self.assert_same(self.press("Home"), plain)
        self.press("s")
        shot = self.read(self.folder / "a-1.png", self.SIZE)
        picture, _ = self.end()
        self.assert_same(picture, shot)

    def test_the_view_turns_about_the_data(self):
        """Whatever the camera looks at beyond them, half a turn leaves them in the window, as large."""
        ball, writer = vtkSphereSource(), vtkXMLPolyDataWriter()
        ball.SetRadius(0.57)
        writer.SetInputConnection(ball.GetOutputPort())
        writer.SetFileName(str(self.folder / "ball.vtp"))
        writer.Write()
        self.open(self.folder / "ball.vtp", "--color", "white", "--background", "black")
        before = self.press("g").max(axis=2) > 60
        for start, end in (((20, 100), (220, 100)), ((150, 30), (150, 150))):
            after = self.drag(start, end).max(axis=2) > 60
            self.assertGreater(after.sum(), 0.5 * before.sum())
            self.assertLess(after.sum(), 2 * before.sum())
            for edge in after[0], after[-1], after[:, 0], after[:, -1]:
                self.assertFalse(edge.any(), "the data leave the window")
        self.end()

    def test_the_status_line_fits(self):
        self.open(self.mesh)
        self.press("h")
        plain = self.press("h")
        shown = self.press("z")
        is_text = abs(shown - plain).max(axis=2) > 20
        self.assertGreater(is_text.sum(), 300)
        self.assertFalse(is_text[:, -4:].any(), "it goes on beyond the window")
        self.end()

    def test_files_one_after_another_and_again(self):
        changing = self.folder / "changing.obj"
        corners = "v {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nf 1 2 3\n"
        changing.write_text(corners.format(1))
        camera = ["--camera-position", "3,3,3", "--focal-point", "0,0,0", "--sun", "225,20"]
        self.open("--each", "--watch", "--quiet", self.mesh, changing, *camera)
        plain = self.steady()
        second = self.press("Next")
        changing.write_text(corners.format(2))
        self.wait(lambda: abs(self.look() - second).max() > 20)
        self.assertLess((abs(self.press("Prior") - plain).max(axis=2) > 20).mean(), 0.02)
        self.end()


if __name__ == "__main__":
    unittest.main()
