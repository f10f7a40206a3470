# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes images of one body in the storages of medical images: axes in any order, values times a slope."""

import ctypes
import ctypes.util
import gzip
import struct

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

TO_RAS = numpy.diag((-1, -1, 1))  # DICOM's coordinates point to the left and the back


def turned(values, matrix, order, flips):
    """Values [k, j, i] with axes in another order and direction, and the matrix that places them as before."""
    data = values.transpose(2, 1, 0)
    matrix = matrix.copy()
    for axis in range(3):
        if flips[axis]:
            data = numpy.flip(data, axis)
            matrix[:, 3] += (data.shape[axis] - 1) * matrix[:, axis]
            matrix[:, axis] *= -1
    data = data.transpose(order)
    return data.transpose(2, 1, 0).copy(), numpy.column_stack((matrix[:, list(order)], matrix[:, 3]))


def write_vti(path, values, matrix):
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    spacing = numpy.linalg.norm(matrix[:, :3], axis=0)
    image.SetSpacing(*spacing)
    image.SetOrigin(*matrix[:, 3])
    image.SetDirectionMatrix(*(matrix[:, :3] / spacing).ravel())
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    image.GetPointData().GetScalars().SetName("values")
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def write_mha(path, values, matrix, slope=1, intercept=0):
    spacing = numpy.linalg.norm(matrix[:, :3], axis=0)
    kind = {"i2": "MET_SHORT", "u2": "MET_USHORT", "f4": "MET_FLOAT"}[values.dtype.str[1:]]

    def text(numbers):
        return " ".join(map(str, numpy.ravel(numbers)))

    path.write_bytes((
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
        f"TransformMatrix = {text((matrix[:, :3] / spacing).T)}\nOffset = {text(matrix[:, 3])}\n"
        f"ElementSpacing = {text(spacing)}\nDimSize = {text(values.shape[::-1])}\n"
        f"ElementToIntensityFunctionSlope = {slope}\nElementToIntensityFunctionOffset = {intercept}\n"
        f"ElementType = {kind}\nElementDataFile = LOCAL\n").encode() + values.tobytes())


def write_nii(path, values, matrix, slope=1, intercept=0, form="s"):
    """With the matrix as the sform or, if its axes are at right angles, the qform."""
    ras = (TO_RAS @ matrix).astype(float)
    spacing = numpy.linalg.norm(ras[:, :3], axis=0)
    code = {"i2": 4, "u2": 512, "f4": 16}[values.dtype.str[1:]]
    directions = ras[:, :3] / spacing
    side = 1 if numpy.linalg.det(directions) > 0 else -1
    directions[:, 2] *= side
    # The axis of a turn, and the half of its angle: a quaternion with a positive first number
    weights, axes = numpy.linalg.eig(directions)
    axis = numpy.real(axes[:, numpy.argmin(abs(weights - 1))])
    angle = numpy.arccos(numpy.clip((numpy.trace(directions) - 1) / 2, -1, 1))
    skew = numpy.array([directions[2, 1] - directions[1, 2], directions[0, 2] - directions[2, 0],
        directions[1, 0] - directions[0, 1]])
    quaternion = axis * numpy.sin(angle / 2) * (-1 if skew @ axis < 0 else 1)
    head = struct.pack("<i36x8h", 348, 3, *values.shape[::-1], 1, 1, 1, 1)
    head += struct.pack("<3f4h8f", 0, 0, 0, 0, code, 8 * values.itemsize, 0, side, *spacing, 0, 0, 0, 0)
    head += struct.pack("<3fh2b4f", 352, slope, intercept, 0, 0, 2, 0, 0, 0, 0)
    head += struct.pack("<2i80x24x2h", 0, 0, form == "q", form == "s")
    head += struct.pack("<6f12f16x4s4x", *quaternion, *ras[:, 3], *ras.ravel(), b"n+1\0")
    data = head + values.tobytes()
    path.write_bytes(gzip.compress(data) if path.suffix == ".gz" else data)


def write_nrrd(path, values, matrix, space="left-posterior-superior", encoding="raw"):
    sign = {"l": 1, "r": -1}[space[0].lower()], -1 if "ant" in space or space[1:2] == "A" else 1, 1
    rows = (numpy.diag(sign) @ matrix).T
    vectors = ["(" + ",".join(map(str, row)) + ")" for row in rows]
    kind = {"i2": "short", "u2": "ushort", "f4": "float"}[values.dtype.str[1:]]
    data = values.tobytes()
    head = (
        f"NRRD0004\ntype: {kind}\ndimension: 3\nspace: {space}\nsizes: {' '.join(map(str, values.shape[::-1]))}\n"
        f"space directions: {' '.join(vectors[:3])}\nspace origin: {vectors[3]}\nendian: little\n"
        f"encoding: {encoding}\n")
    path.write_bytes(head.encode() + b"\n" + (gzip.compress(data) if encoding == "gzip" else data))


def write_tiff(path, pixels, compression, tiled=False, rows=16):
    """Write uint8 [row, column, channel], whose sides are multiples of 16, with the library that has all compressions."""
    library = ctypes.CDLL(ctypes.util.find_library("tiff") or "libtiff.so.6")
    library.TIFFOpen.restype = ctypes.c_void_p
    height, width, channels = pixels.shape
    file = ctypes.c_void_p(library.TIFFOpen(str(path).encode(), b"w"))
    tags = {
        256: width, 257: height, 258: 8, 259: compression, 262: 2 if channels > 2 else 1, 277: channels, 284: 1,
        **({322: 16, 323: 16} if tiled else {278: rows})}
    if compression == 7 and channels == 3:
        tags[262] = 6  # YCbCr, which the library makes of colours (65538)
        tags[65538] = 1
    for tag, value in tags.items():
        library.TIFFSetField(file, ctypes.c_uint32(tag), ctypes.c_int(value))
    if tiled:
        parts = [pixels[y : y + 16, x : x + 16] for y in range(0, height, 16) for x in range(0, width, 16)]
    else:
        parts = [pixels[y : y + rows] for y in range(0, height, rows)]
    write = library.TIFFWriteEncodedTile if tiled else library.TIFFWriteEncodedStrip
    for i, part in enumerate(parts):
        data = part.tobytes()
        write(file, ctypes.c_uint32(i), data, ctypes.c_ssize_t(len(data)))
    library.TIFFClose(file)
