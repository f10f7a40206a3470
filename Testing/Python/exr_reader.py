# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the OpenEXR files of tests: scan lines of 32-bit floats, plain or ZIP; shares no code with the writer."""

import struct
import zlib

import numpy


def _text(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def read(path):
    """(channels by name, rows from the bottom up; attributes by name, texts and floats)."""
    data = path.read_bytes()
    assert data[:4] == b"\x76\x2f\x31\x01", "no OpenEXR file"
    at, attributes = 8, {}
    while data[at]:
        name, at = _text(data, at)
        kind, at = _text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = kind, data[at + 4 : at + 4 + size]
        at += 4 + size
    names, place = [], 0
    channels = attributes["channels"][1]
    while channels[place]:
        name, place = _text(channels, place)
        assert struct.unpack_from("<i", channels, place) == (2,), "not of 32-bit floats"
        names.append(name)
        place += 16
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    width, height = right - left + 1, bottom - top + 1
    compression = attributes["compression"][1][0]
    lines = {0: 1, 2: 1, 3: 16}[compression]
    count = -(-height // lines)
    rows = numpy.zeros((height, len(names), width), numpy.float32)
    for offset in struct.unpack_from(f"<{count}q", data, at + 1):
        y, size = struct.unpack_from("<2i", data, offset)
        block = data[offset + 8 : offset + 8 + size]
        here = rows[y - top : y - top + lines]
        if size < here.nbytes:  # differences of bytes, of which every second one was put first
            deltas = numpy.frombuffer(zlib.decompress(block), numpy.uint8).astype(int)
            deltas[1:] -= 128
            mixed = (numpy.cumsum(deltas) % 256).astype(numpy.uint8)
            plain = numpy.empty_like(mixed)
            plain[0::2], plain[1::2] = mixed[: (len(mixed) + 1) // 2], mixed[(len(mixed) + 1) // 2 :]
            block = plain.tobytes()
        here[:] = numpy.frombuffer(block, "<f4").reshape(here.shape)
    found = {}
    for name, (kind, value) in attributes.items():
        if kind == "string":
            found[name] = value.decode()
        elif kind == "float":
            found[name] = struct.unpack("<f", value)[0]
    return {name: rows[::-1, i] for i, name in enumerate(names)}, found
