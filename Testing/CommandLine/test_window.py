# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The window of the program godrays (its path is in GODRAYS_PROGRAM), and its keys, on an X server."""

import ctypes
import os
import pathlib
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from test_cli import ProgramTest


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

    def press(self, window, letter):
        symbol = ctypes.c_ulong(self.x.XStringToKeysym(letter.encode()))
        code = self.x.XKeysymToKeycode(self.display, symbol)
        for kind, mask in ((2, 1), (3, 2)):  # pressed and released
            event = KeyEvent(type=kind, window=window, root=self.root, keycode=code, same_screen=1)
            self.x.XSendEvent(
                self.display, ctypes.c_ulong(window), 0, ctypes.c_long(mask), ctypes.byref(event))
        self.x.XFlush(self.display)


class Window(ProgramTest):
    SIZE = (123, 77)  # that no other program on the screen has

    def draw_and_press(self, *keys):
        """From the last look or medium of ours press N until it has an effect, which brings the first one, then
        these keys, then Q; the picture written at the end."""
        screen = Screen()
        self.addCleanup(screen.close)
        path = self.folder / "window.png"
        path.unlink(missing_ok=True)
        program = subprocess.Popen(
            [os.environ["GODRAYS_PROGRAM"], self.mesh, "--size", "{}x{}".format(*self.SIZE),
             "--preset", "sea-water", "--interactive", "--output", path],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.kill)
        end = time.monotonic() + 30
        pressed = []
        while program.poll() is None and time.monotonic() < end:
            time.sleep(0.2)
            window, title = screen.find_window(self.SIZE) or (None, "")
            if window and title == "godrays":
                screen.press(window, "n")
            elif window:
                self.assertEqual(title, "godrays: default")
                for key in [*keys, "q"] if not pressed else "q":
                    screen.press(window, key)
                    pressed.append(key)
        self.assertEqual((program.poll(), *program.communicate()), (0, "", ""))
        self.assertEqual(pressed[: len(keys)], list(keys), "the window did not take N")
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


if __name__ == "__main__":
    unittest.main()
