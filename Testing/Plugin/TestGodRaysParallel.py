# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parallel rendering: the picture is that of one process, whoever renders it.

Plain Python, which starts ParaView's programs: GODRAYS_PVBATCH, GODRAYS_PVSERVER, GODRAYS_MPIRUN. Two processes draw
all scenes. Four processes, and a client that renders itself, draw fewer; GODRAYS_LONG takes more.
"""

import os
import socket
import subprocess
import sys
import tempfile
import unittest

from parallel_testing import MPIRUN, difference, draw, on_processes, read

LEVELS = 2
LONG = "GODRAYS_LONG" in os.environ

# What ParaView draws alike without rays; what it joins in order differs by a few levels.
SCENES = [
    "opaque", "gradient", "tagged", "lamp", "bright", "medium", "shadows", "sky", "placed", "one_process",
]  # fmt: skip
ORDERED = ["volume", "translucent", "veil"]


def get_means(picture, size=20):
    """Of squares, from the lower left."""
    rows, columns = picture.shape[0] // size, picture.shape[1] // size
    squares = picture[: rows * size, : columns * size].reshape(rows, size, columns, size, -1)
    return squares.mean(axis=(1, 3))


class Parallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.serial = cls.draw("serial", on_processes(1), SCENES + ORDERED)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def draw(cls, name, program, scenes=(), **environment):
        return draw(os.path.join(cls.folder.name, name), program, scenes, **environment)

    def check(self, folder, scenes=SCENES):
        for name in scenes:
            with self.subTest(name):
                self.assertLessEqual(difference(folder, self.serial, name + "-plain"), LEVELS)
                self.assertLessEqual(difference(folder, self.serial, name), LEVELS)
                # a control: it has rays
                rays = abs(read(folder, name) - read(folder, name + "-plain")).max()
                self.assertGreater(rays, 10 * LEVELS)

    def test_the_scenes_differ(self):
        for name in ("gradient", "tagged", "lamp", "bright", "medium", "sky", "volume", "placed"):
            change = abs(read(self.serial, name) - read(self.serial, "opaque")).max()
            self.assertGreater(change, 10 * LEVELS, name)
        change = abs(read(self.serial, "medium") - read(self.serial, "shadows")).max()
        self.assertGreater(change, 2 * LEVELS)

    def test_two_processes(self):
        folder = self.draw("two", on_processes(2), SCENES + ORDERED)
        self.check(folder)
        self.check_ordered(folder)

    def check_ordered(self, folder):
        """Ordered compositing, which has no depth: as near as ParaView itself comes."""
        for name in ORDERED:
            with self.subTest(name):
                without = difference(folder, self.serial, name + "-plain")
                self.assertLess(without, 20, "ParaView loses data between its processes")
                self.assertLessEqual(difference(folder, self.serial, name), without + LEVELS)
                rays = abs(read(folder, name) - read(folder, name + "-plain")).max()
                self.assertGreater(rays, 10 * LEVELS)

    def test_four_processes(self):
        scenes = ["tagged", "lamp", "shadows", "sky", "placed", "one_process"]
        if LONG:
            scenes += ["opaque", "medium"]
        folder = self.draw("four", on_processes(4), scenes)
        self.check(folder, scenes)

    def test_client_and_server(self):
        every = ["gradient", "tagged", "lamp", "sky", "placed"]
        some = every if LONG else ["tagged", "placed"]
        for count, remote, scenes in (("2", "1", every), ("2", "0", some)):
            with self.subTest(f"{count} processes, remote rendering {remote}"):
                with socket.socket() as free:
                    free.bind(("localhost", 0))
                    port = str(free.getsockname()[1])
                server = subprocess.Popen(
                    [*MPIRUN, count, os.environ["GODRAYS_PVSERVER"], f"--server-port={port}"],
                    stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT,
                    text=True,
                )
                try:
                    said = ""
                    for line in server.stdout:
                        said += line
                        if "Accepting" in line:
                            break
                    self.assertIn("Accepting", said)
                    folder = self.draw(
                        f"server-{count}-{remote}",
                        [sys.executable],
                        scenes,
                        GODRAYS_SERVER_PORT=port,
                        GODRAYS_REMOTE_RENDERING=remote,
                    )
                    self.check(folder, scenes)
                    if remote == "1":
                        self.check_dragged(folder, scenes)
                finally:
                    server.terminate()
                    server.communicate()

    def check_dragged(self, folder, scenes):
        """While the camera is dragged there are the same rays, as strong and in their places, over a coarser
        picture."""
        for name in scenes:
            with self.subTest(name + ", dragged"):
                full, dragged = read(folder, name), read(folder, name + "-dragged")
                still = get_means(full - read(folder, name + "-plain"))
                moving = get_means(dragged - read(folder, name + "-plain-dragged"))
                strength = (still * moving).sum() / (still * still).sum()
                rest = abs(moving - strength * still).mean() / still.mean()
                print(f"{name}, dragged: {strength:.3f} times as strong; {rest:.3f} of them elsewhere")
                self.assertLess(abs(strength - 1), 0.1)
                self.assertLess(rest, 0.2)  # 0.18 measured: a coarser picture blurs narrow shafts
                self.assertGreater(abs(dragged - full).max(), 8 * LEVELS)  # it was reduced


unittest.main(verbosity=2)
