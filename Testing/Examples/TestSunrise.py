# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sunrise: sky, sunlight and shafts agree; a film and its frames, of any terrain; errors.

Usage: TestSunrise.py example.py program
"""

import os
import runpy
import struct
import subprocess
import sys

import numpy
import vtkmodules.all as vtk
from example_testing import check, end, read
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def run(*arguments):
    command = [sys.executable, example, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True)


def packets_of(data):
    """The packets of an Ogg stream of one logical stream; a broken page is an AssertionError."""
    packets, rest, place, number = [], b"", 0, 0
    while place < len(data):
        header = data[place : place + 27]
        magic, _, _, _, _, sequence, checksum, count = struct.unpack("<4sBBqIIIB", header)
        assert magic == b"OggS" and sequence == number, f"page {number} at byte {place}"
        lengths = data[place + 27 : place + 27 + count]
        end = place + 27 + count + sum(lengths)
        page = data[place : place + 22] + bytes(4) + data[place + 26 : end]
        assert checksum_of(page) == checksum, f"checksum of page {number}"
        place += 27 + count
        for length in lengths:
            rest += data[place : place + length]
            place += length
            if length < 255:
                packets.append(rest)
                rest = b""
        number += 1
    return packets


def shifted(value):
    """What the checksum's polynomial makes of eight bits."""
    for _ in range(8):
        value = (value << 1) ^ (0x104C11DB7 if value & 0x80000000 else 0)
    return value


SHIFTED = [shifted(byte << 24) for byte in range(256)]


def checksum_of(page):
    """As Ogg has it: the polynomial 0x04c11db7, highest bit first, from 0."""
    value = 0
    for byte in page:
        value = (value << 8 & 0xFFFFFFFF) ^ SHIFTED[value >> 24 ^ byte]
    return value


def check_film():
    count = 25
    film = os.path.join(folder, "Sunrise.ogv")
    done = run(film, "400x300", count)
    check("a film is made", done.returncode == 0, done.stderr)
    check("its progress is told", done.stdout.count("frame ") == count, done.stdout.split("\r")[-1].strip())
    frames = [read(f"{film[:-4]}-{i:04}.png") for i in range(count)]
    bright = numpy.array([frame.mean() for frame in frames])
    morning, evening = bright[:4], bright[-4:]
    check("it gets brighter in the morning", (numpy.diff(morning) > 5).all(), morning.round(1))
    check("and darker in the evening", (numpy.diff(evening) < -5).all(), evening.round(1))
    check("by day it is bright", bright[4:-4].min() > 100, f"{bright[4:-4].min():.1f} at least")
    difference = [numpy.abs(a - b).mean() for a, b in zip(frames, frames[1:])]
    check("frames differ", min(difference) > 1, f"by {min(difference):.1f} levels at least")

    with open(film, "rb") as file:
        header, *packets = packets_of(file.read())
    name, *_, columns, rows, width, height, _, rate, seconds = struct.unpack(
        ">7s3BHH3s3sHII", header[:30]
    )
    size = [int.from_bytes(each, "big") for each in (width, height)]
    check("the film is Theora", name == b"\x80theora")
    check("of the frames' size", size == [400, 300] and (columns, rows) == (25, 19), str(size))
    check("at 25 frames a second", (rate, seconds) == (25, 1))
    pictures = [packet for packet in packets if not packet or packet[0] < 0x80]
    check("with all frames", len(pictures) == count, f"{len(pictures)} of {count}")
    check("the first of which is whole", pictures[0][0] & 0x40 == 0)


def check_program():
    """The film of the program in C++ is that of the script."""
    frames = []
    for name, command in ("a", [program]), ("b", [sys.executable, example]):
        film = os.path.join(folder, f"Sunrise_{name}.ogv")
        done = subprocess.run([*command, film, "400x300", "3"], capture_output=True, text=True)
        check(f"{command[-1]} makes a film", done.returncode == 0, done.stdout.splitlines()[-1])
        frames.append(numpy.array([read(f"{film[:-4]}-{i:04}.png") for i in range(3)]))
    difference = numpy.abs(frames[0] - frames[1]).max()
    check("both are the same", difference <= 2, f"to {difference:.0f} levels")


def check_light():
    sys.argv = [example, os.path.join(folder, "Sunrise_checks.png"), "400x300"]
    scene = runpy.run_path(example)
    colors = []
    for hours in scene["day"].GetSunrise() + 0.2, 12:
        scene["set_time"](hours)
        scene["window"].Render()
        image = vtk.vtkImageData()
        assert scene["rays"].GetScatteringImage(image), scene["rays"].GetPlan()
        shafts = vtk_to_numpy(image.GetPointData().GetScalars()).mean(axis=0)
        light = [0.0, 0.0, 0.0]
        scene["sky"].GetSunColor(light)
        colors.append(numpy.array(light) / light[0])
        error = numpy.abs(shafts / shafts[0] - colors[-1]).max()
        figures = ", ".join(f"{each:.3f}" for each in colors[-1])
        check(f"at {hours:.1f} h shafts have the sun's colour", error < 2e-3, f"{figures}; {error:.1e}")
    check("the low sun is redder", colors[0][2] < 0.3 * colors[1][2])


def check_elevations():
    x, y = numpy.meshgrid(numpy.arange(30), numpy.arange(20))
    heights = 300 + 20 * numpy.sin(0.4 * x) * numpy.cos(0.3 * y)
    image = vtk.vtkImageData()
    image.SetDimensions(30, 20, 1)
    image.SetSpacing(90, 90, 1)
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetInputData(image)
    empty = os.path.join(folder, "Sunrise_empty.vti")
    writer.SetFileName(empty)
    writer.Write()
    image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel(), deep=True))
    pictures = []
    for base in 0, 500:
        image.SetOrigin(0, 0, base)
        elevations = os.path.join(folder, f"Sunrise_{base}.vti")
        writer.SetFileName(elevations)
        writer.Write()
        picture = os.path.join(folder, f"Sunrise_{base}.png")
        done = run(picture, "400x300", elevations)
        check("elevations are read", done.returncode == 0, done.stderr)
        pictures.append(read(picture))
    ground, sky = pictures[0][:20].mean(), pictures[0][-20:].mean()
    check("the sky is over the ground", sky > 3 * ground, f"{ground:.1f} and {sky:.1f} levels")
    difference = numpy.abs(pictures[0] - pictures[1]).max()
    check("a terrain that lies higher is as bright", difference <= 3, f"to {difference} levels")
    faults = ("nowhere.vti", "make_terrain.py"), (empty, "make_terrain.py"), ("-1", "Usage"), ("9s", "Usage")
    for command in [program], [sys.executable, example]:
        for argument, word in faults:
            done = subprocess.run([*command, argument], capture_output=True, text=True)
            told = argument in done.stderr and word in done.stderr and "Traceback" not in done.stderr
            check(f"{argument} is an error that says what to do", done.returncode == 1 and told)


folder = os.getcwd()
example, program = sys.argv[1:]
check_film()
check_program()
check_light()
check_elevations()
end()
