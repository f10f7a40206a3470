# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small files of every type that the program godrays reads."""

import base64
import json
import os
import struct
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
    vtkRectilinearGrid, vtkStructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkElevationFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkBYUWriter, vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import (
    vtkBMPWriter, vtkJPEGWriter, vtkMetaImageWriter, vtkNIFTIImageWriter, vtkPNGWriter,
    vtkPNMWriter, vtkTIFFWriter)
from vtkmodules.vtkIOLegacy import (
    vtkPolyDataWriter, vtkStructuredPointsWriter, vtkUnstructuredGridWriter)
from vtkmodules.vtkIOParallelXML import (
    vtkXMLPartitionedDataSetCollectionWriter, vtkXMLPartitionedDataSetWriter,
    vtkXMLPImageDataWriter, vtkXMLPPolyDataWriter, vtkXMLPRectilinearGridWriter,
    vtkXMLPStructuredGridWriter, vtkXMLPUnstructuredGridWriter)
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter,
    vtkXMLRectilinearGridWriter, vtkXMLStructuredGridWriter, vtkXMLUnstructuredGridWriter)


def filtered(filter, data):
    filter.SetInputData(data)
    filter.Update()
    return filter.GetOutput()


def surface(scalars=True):
    """A sphere, coloured by height."""
    source = vtkSphereSource()
    source.SetThetaResolution(12)
    source.SetPhiResolution(12)
    source.Update()
    return filtered(vtkElevationFilter(), source.GetOutput()) if scalars else source.GetOutput()


def heights(size=24, type=numpy.float32, top=200.0):
    """Hills, as rows from south to north."""
    x, y = numpy.meshgrid(numpy.linspace(0, 9, size), numpy.linspace(0, 9, size))
    return (top * (0.5 + 0.25 * numpy.sin(x) + 0.25 * numpy.cos(1.3 * y))).astype(type)


def image(values, spacing=1.0, name="Values"):
    """A picture or a volume of an array."""
    data = vtkImageData()
    size = list(values.shape[::-1]) + [1]
    data.SetDimensions(size[:3])
    data.SetSpacing(spacing, spacing, spacing)
    array = numpy_to_vtk(values.ravel(), deep=1)
    array.SetName(name)
    data.GetPointData().SetScalars(array)
    return data


def volume():
    x, y, z = numpy.mgrid[-1:1:16j, -1:1:16j, -1:1:16j]
    return image((1.5 - numpy.sqrt(x * x + y * y + z * z)).astype(numpy.float32), 0.1)


def color_picture():
    values = numpy.zeros((16, 16, 3), numpy.uint8)
    values[..., 0] = heights(16, numpy.uint8)
    values[..., 2] = 90
    data = vtkImageData()
    data.SetDimensions(16, 16, 1)
    data.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, 3), deep=1))
    return data


def structured_grid():
    grid = vtkStructuredGrid()
    source = image(heights(), 10.0)
    points = numpy.array([source.GetPoint(i) for i in range(source.GetNumberOfPoints())])
    points[:, 2] = heights().ravel()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=1))
    grid.SetDimensions(24, 24, 1)
    grid.SetPoints(vtk_points)
    grid.GetPointData().SetScalars(source.GetPointData().GetScalars())
    return grid


def rectilinear_grid():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(4, 5, 6)
    for set_coordinates, count in (
        (grid.SetXCoordinates, 4), (grid.SetYCoordinates, 5), (grid.SetZCoordinates, 6)
    ):
        coordinates = vtkFloatArray()
        for i in range(count):
            coordinates.InsertNextValue(i * i * 0.5)
        set_coordinates(coordinates)
    return grid


def unstructured_grid():
    return filtered(vtkAppendFilter(), surface())


def composite(kind):
    """Two shapes in a multi-block data set, partitioned data set or collection of these."""
    other = vtkCylinderSource()
    other.SetCenter(1.5, 0, 0)
    other.Update()
    data = kind()
    if kind is vtkPartitionedDataSetCollection:
        data.SetPartition(0, 0, surface())
        data.SetPartition(1, 0, other.GetOutput())
    elif kind is vtkPartitionedDataSet:
        data.SetPartition(0, surface())
        data.SetPartition(1, other.GetOutput())
    else:
        data.SetBlock(0, surface())
        data.SetBlock(1, other.GetOutput())
    return data


def write(writer, data, path, **settings):
    if "GeometryFileName" not in settings:
        writer.SetFileName(str(path))
    writer.SetInputDataObject(0, data)
    for name, value in settings.items():
        getattr(writer, "Set" + name)(value)
    if os.environ.get("GODRAYS_INLINE_DATA") and hasattr(writer, "SetDataModeToBinary"):
        writer.SetDataModeToBinary()
    writer.Write()


def write_dem(path):
    """A Digital Elevation Model of the US Geological Survey: 100 profiles of 100 elevations."""
    def real(value):
        return f"{value:24.15E}".replace("E", "D")

    head = f"{'SAMPLE HILLS':144s}" + "".join(f"{n:6d}" for n in (1, 1, 1, 16))
    head += "".join(real(0) for _ in range(15)) + "".join(f"{n:6d}" for n in (2, 2, 4))
    head += "".join(real(v) for v in (0, 0, 0, 2970, 2970, 2970, 2970, 0))  # the corners
    head += real(0) + real(200) + real(0) + f"{0:6d}"
    head += "".join(f"{v:12.6E}" for v in (30, 30, 1)) + f"{1:6d}{100:6d}"
    records = f"{head:1024s}"
    for column in range(100):
        record = "".join(f"{n:6d}" for n in (1, column + 1, 100, 1))
        record += real(30 * column) + real(0) + real(0) + real(0) + real(200)
        record += "".join(f"{int(v):6d}" for v in heights(100)[:, column])
        records += f"{record:1024s}"
    path.write_text(records)


def write_geotiff(path, order="<", spacing=(0.001, 0.001), geographic=True, no_data="-9999.0", values=None,
        matrix=None, keys=(), metadata=""):
    """A picture of one strip of floats, from north to south, with the tags of a GeoTIFF. matrix: in place of the
    spacing; keys: of units; metadata: of GDAL."""
    if values is None:
        values = heights()[::-1].copy()
        values[:4, :4] = float(no_data)
    pixels = values.astype(order + "f4").tobytes()
    keys = {1024: 2 if geographic else 1, **dict(keys)}
    # Tag, type (2 text, 3 short, 4 long, 12 double), values
    tags = [
        (256, 3, (24,)), (257, 3, (24,)), (258, 3, (32,)), (259, 3, (1,)), (262, 3, (1,)),
        (273, 4, (8,)), (277, 3, (1,)), (278, 3, (24,)), (279, 4, (len(pixels),)), (339, 3, (3,)),
        (34264, 12, matrix) if matrix else (33550, 12, (*spacing, 0.0)),
        (33922, 12, (0.0, 0.0, 0.0, -84.0, 60.0, 0.0)),
        (34735, 3, (1, 1, 0, len(keys), *(n for key in keys.items() for n in (key[0], 0, 1, key[1])))),
        *[(tag, 2, text.encode() + b"\0") for tag, text in ((42112, metadata), (42113, no_data)) if text]]
    tags.sort()
    start = 8 + len(pixels)
    more_at = start + 2 + 12 * len(tags) + 4
    directory, more = struct.pack(order + "H", len(tags)), b""
    for tag, kind, contents in tags:
        letters = {2: "c", 3: "H", 4: "I", 12: "d"}[kind]
        data = contents if kind == 2 else struct.pack(f"{order}{len(contents)}{letters}", *contents)
        directory += struct.pack(order + "HHI", tag, kind, len(contents))
        if len(data) <= 4:
            directory += data.ljust(4, b"\0")
        else:
            directory += struct.pack(order + "I", more_at + len(more))
            more += data + b"\0" * (len(data) % 2)
    head = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", start)
    path.write_bytes(head + pixels + directory + struct.pack(order + "I", 0) + more)


def gltf(embed):
    """The parts of a glTF file with two triangles in two materials; embed: whether as one file."""
    positions = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    indices = struct.pack("<3H", 0, 1, 2) + b"\0\0"
    buffer = positions + indices
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [0.4, 0.3, -1]}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": m}]}
            for m in (0, 1)],
        "materials": [
            {"doubleSided": True, "pbrMetallicRoughness": {"baseColorFactor": [*color, 1]}}
            for color in ((1, 0.2, 0.1), (0.1, 0.3, 1))],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": len(buffer)}]}
    if not embed:
        document["buffers"][0]["uri"] = "triangles.bin"
    return json.dumps(document).encode(), buffer


def write_gltf(path):
    document, buffer = gltf(embed=False)
    path.write_bytes(document)
    (path.parent / "triangles.bin").write_bytes(buffer)


def write_glb_parts(path, document, buffer):
    document += b" " * (-len(document) % 4)
    total = 12 + 8 + len(document) + 8 + len(buffer)
    path.write_bytes(
        struct.pack("<4sII", b"glTF", 2, total) +
        struct.pack("<I4s", len(document), b"JSON") + document +
        struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


def write_glb(path):
    write_glb_parts(path, *gltf(embed=True))


def png(pixels):
    """The file of a picture, uint8 [row, column, channel]."""
    height, width, channels = pixels.shape

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">2I5B", width, height, 8, (0, 4, 2, 6)[channels - 1], 0, 0, 0)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write_plates(path, *plates):
    """Write a .gltf or .glb of rectangles that face +z: each has corners, (left, right, bottom, top, z), and maybe a
    factor, colors of its four corners, the pixels of a texture, and other members of its material."""
    buffer, views, accessors, images, materials, meshes = b"", [], [], [], [], []

    def add(data):
        nonlocal buffer
        buffer += b"\0" * (-len(buffer) % 4)
        views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
        buffer += data
        return len(views) - 1

    def add_array(values, kind, **more):
        component = {"f4": 5126, "u1": 5121, "u2": 5123}[values.dtype.str[1:]]
        accessors.append({
            "bufferView": add(values.tobytes()), "componentType": component, "count": len(values), "type": kind,
            "normalized": component != 5126, **more})
        return len(accessors) - 1

    for plate in plates:
        plate = dict(plate)
        left, right, bottom, top, z = plate.pop("corners")
        points = numpy.array(
            [(left, bottom, z), (right, bottom, z), (left, top, z), (right, top, z)], "f4")
        attributes = {
            "POSITION": add_array(points, "VEC3", min=points.min(axis=0).tolist(), max=points.max(axis=0).tolist()),
            "NORMAL": add_array(numpy.array([(0, 0, 1)] * 4, "f4"), "VEC3"),
            "TEXCOORD_0": add_array(numpy.array([(0, 1), (1, 1), (0, 0), (1, 0)], "f4"), "VEC2")}
        colors = plate.pop("colors", None)
        if colors is not None:
            attributes["COLOR_0"] = add_array(colors, f"VEC{colors.shape[1]}")
        surface = {"metallicFactor": 0, "baseColorFactor": list(plate.pop("factor", (1, 1, 1, 1)))}
        texture = plate.pop("texture", None)
        if texture is not None:
            surface["baseColorTexture"] = {"index": len(images), "texCoord": 0}
            data = png(texture)
            images.append(
                {"bufferView": add(data), "mimeType": "image/png"} if path.suffix == ".glb" else
                {"uri": "data:image/png;base64," + base64.b64encode(data).decode()})
        materials.append({"pbrMetallicRoughness": surface, "doubleSided": True, **plate})
        indices = numpy.array([0, 1, 2, 2, 1, 3], "u2")
        meshes.append({"primitives": [{
            "attributes": attributes, "indices": add_array(indices, "SCALAR", normalized=False),
            "material": len(meshes)}]})
    count = range(len(meshes))
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(count)}],
        "nodes": [{"mesh": i} for i in count], "meshes": meshes, "materials": materials, "accessors": accessors,
        "bufferViews": views, "buffers": [{"byteLength": len(buffer)}], "images": images,
        "samplers": [{"magFilter": 9728, "minFilter": 9728}],
        "textures": [{"source": i, "sampler": 0} for i in range(len(images))]}
    if path.suffix == ".glb":
        write_glb_parts(path, json.dumps(document).encode(), buffer + b"\0" * (-len(buffer) % 4))
    else:
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()
        path.write_text(json.dumps(document))


def write_3ds(path):
    def chunk(id, contents):
        return struct.pack("<HI", id, 6 + len(contents)) + contents

    vertices = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
    faces = (0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)
    points = struct.pack("<H", 4) + b"".join(struct.pack("<3f", *v) for v in vertices)
    corners = struct.pack("<H", 4) + b"".join(struct.pack("<4H", *f, 7) for f in faces)
    mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, corners))
    path.write_bytes(chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, b"shape\0" + mesh))))


def write_nrrd(path, detached):
    values = numpy.ascontiguousarray(
        numpy.add.outer(heights(12), numpy.arange(12) * 5).astype("<f4"))
    head = (
        "NRRD0004\ntype: float\ndimension: 3\nsizes: 12 12 12\nspacings: 1 1 1\n"
        "encoding: raw\nendian: little\n")
    if detached:
        path.write_text(head + "data file: values.raw\n")
        (path.parent / "values.raw").write_bytes(values.tobytes())
    else:
        path.write_bytes(head.encode() + b"\n" + values.tobytes())


def write_hdr(path):
    n = 128  # VTK 9.6 loses its place in a file that is shorter than its buffer
    pixels = b"".join(
        bytes((int(v), 128, 200 - int(v) // 2, 128)) for v in heights(n).ravel())
    path.write_bytes(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {n} +X {n}\n".encode() + pixels)


def write_strips_ply(path, order=None, as_triangles=False):
    """A tube of triangle strips, in one list, or of their triangles; order: of a binary file, > or <."""
    around, along = 16, 4
    angles = numpy.linspace(0, 2 * numpy.pi, around, endpoint=False)
    points = [(numpy.cos(a), z, numpy.sin(a)) for z in range(along) for a in angles]
    strips = []
    for z in range(along - 1):
        for i in range(around + 1):
            strips += [(z + 1) * around + i % around, z * around + i % around]
        strips.append(-1)
    kind = {None: "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    head = f"ply\nformat {kind} 1.0\nelement vertex {len(points)}\n" + "".join(
        f"property float {axis}\n" for axis in "xyz")
    if as_triangles:
        faces = []
        for z in range(0, along - 1):
            for i in range(around):
                low, high = z * around + i, (z + 1) * around + i
                next_low, next_high = z * around + (i + 1) % around, (z + 1) * around + (i + 1) % around
                faces += [f"3 {high} {low} {next_high}", f"3 {next_high} {low} {next_low}"]
        head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
        body = "".join("{:.6f} {:.6f} {:.6f}\n".format(*point) for point in points)
        path.write_text(head + body + "\n".join(faces) + "\n")
        return
    head += "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    if order:
        body = b"".join(struct.pack(order + "3f", *point) for point in points)
        body += struct.pack(f"{order}{1 + len(strips)}i", len(strips), *strips)
    else:
        body = "".join("{:.6f} {:.6f} {:.6f}\n".format(*point) for point in points)
        body = (body + " ".join(map(str, [len(strips), *strips])) + "\n").encode()
    path.write_bytes(head.encode() + body)


def write_colored_obj(path):
    (path.parent / "colors.mtl").write_text("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n")
    path.write_text(
        "mtllib colors.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\n"
        "usemtl red\nf 1 2 3\nusemtl blue\nf 2 4 3\n")


def write_exodus(path):
    writer = vtkExodusIIWriter()
    writer.SetInputData(unstructured_grid())
    writer.SetFileName(str(path))
    writer.Write()


def write_pvd(path, radii=(0.5,)):
    """A ball, at the times 0, 0.5 ... of these radii."""
    lines = []
    for i, radius in enumerate(radii):
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(16)
        ball.Update()
        name = f"{path.stem}-pvd-{i}.vtp"
        write(vtkXMLPolyDataWriter(), ball.GetOutput(), path.parent / name)
        lines.append(f'<DataSet timestep="{i * 0.5}" part="0" file="{name}"/>\n')
    path.write_text(
        '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n' +
        "".join(lines) + "</Collection>\n</VTKFile>\n")


def write_series(path):
    """A ball, at the times 0 and 1, as ParaView writes it."""
    write_pvd(path.parent / "series.pvd", (0.5, 0.6))
    files = [{"name": f"series-pvd-{i}.vtp", "time": i} for i in range(2)]
    path.write_text(json.dumps({"file-series-version": "1.0", "files": files}, indent=2))


def write_all(folder):
    """Write the files and return their paths."""
    bytes_picture = image(heights(type=numpy.uint8))
    bare = surface(scalars=False)
    jobs = {
        "a.3ds": write_3ds,
        "a.bmp": lambda p: write(vtkBMPWriter(), color_picture(), p),
        "a.byu": lambda p: write(vtkBYUWriter(), bare, p, GeometryFileName=str(p)),
        "a.dem": write_dem,
        "a.e": write_exodus,
        "a.ex2": write_exodus,
        "a.exo": write_exodus,
        "a.glb": write_glb,
        "a.gltf": write_gltf,
        "a.hdr": write_hdr,
        "a.jpeg": lambda p: write(vtkJPEGWriter(), color_picture(), p),
        "a.jpg": lambda p: write(vtkJPEGWriter(), bytes_picture, p),
        "a.mha": lambda p: write(vtkMetaImageWriter(), volume(), p),
        "a.mhd": lambda p: write(vtkMetaImageWriter(), volume(), p, RAWFileName="a.raw"),
        "a.nhdr": lambda p: write_nrrd(p, detached=True),
        "a.nii": lambda p: write(vtkNIFTIImageWriter(), volume(), p),
        "a.nrrd": lambda p: write_nrrd(p, detached=False),
        "a.obj": lambda p: write(vtkOBJWriter(), bare, p),
        "a.pgm": lambda p: write(vtkPNMWriter(), bytes_picture, p),
        "a.ply": lambda p: write(vtkPLYWriter(), filtered(vtkTriangleFilter(), bare), p),
        "a.png": lambda p: write(vtkPNGWriter(), bytes_picture, p),
        "a.ppm": lambda p: write(vtkPNMWriter(), color_picture(), p),
        "a.pvd": write_pvd,
        "a.pvti": lambda p: write(vtkXMLPImageDataWriter(), volume(), p),
        "a.pvtp": lambda p: write(vtkXMLPPolyDataWriter(), surface(), p),
        "a.pvtr": lambda p: write(vtkXMLPRectilinearGridWriter(), rectilinear_grid(), p),
        "a.pvts": lambda p: write(vtkXMLPStructuredGridWriter(), structured_grid(), p),
        "a.pvtu": lambda p: write(vtkXMLPUnstructuredGridWriter(), unstructured_grid(), p),
        "a.vtp.series": write_series,
        "a.stl": lambda p: write(vtkSTLWriter(), bare, p),
        "a.tif": write_geotiff,
        "a.tiff": lambda p: write(vtkTIFFWriter(), bytes_picture, p),
        "a.vti": lambda p: write(vtkXMLImageDataWriter(), volume(), p),
        "a.vtk": lambda p: write(vtkPolyDataWriter(), surface(), p),
        "a.vtm": lambda p: write(vtkXMLMultiBlockDataWriter(), composite(vtkMultiBlockDataSet), p),
        "a.vtmb": lambda p: write(
            vtkXMLMultiBlockDataWriter(), composite(vtkMultiBlockDataSet), p),
        "a.vtp": lambda p: write(vtkXMLPolyDataWriter(), surface(), p),
        "a.vtpc": lambda p: write(
            vtkXMLPartitionedDataSetCollectionWriter(),
            composite(vtkPartitionedDataSetCollection), p),
        "a.vtpd": lambda p: write(
            vtkXMLPartitionedDataSetWriter(), composite(vtkPartitionedDataSet), p),
        "a.vtr": lambda p: write(vtkXMLRectilinearGridWriter(), rectilinear_grid(), p),
        "a.vts": lambda p: write(vtkXMLStructuredGridWriter(), structured_grid(), p),
        "a.vtu": lambda p: write(vtkXMLUnstructuredGridWriter(), unstructured_grid(), p),
        # The same types, otherwise
        "big-endian.tif": lambda p: write_geotiff(p, order=">", spacing=(90, 90), geographic=False),
        "binary.ply": lambda p: write(
            vtkPLYWriter(), filtered(vtkTriangleFilter(), bare), p, FileType=2),
        "binary.stl": lambda p: write(vtkSTLWriter(), bare, p, FileType=2),
        "binary.vtk": lambda p: write(vtkUnstructuredGridWriter(), unstructured_grid(), p,
            FileType=2),
        "colored.obj": write_colored_obj,
        "elevation.vti": lambda p: write(
            vtkXMLImageDataWriter(), image(heights(), 30.0, "Elevation"), p),
        "strips.ply": write_strips_ply,
        "strips-big.ply": lambda p: write_strips_ply(p, ">"),
        "strips-little.ply": lambda p: write_strips_ply(p, "<"),
        "upper.VTP": lambda p: write(vtkXMLPolyDataWriter(), surface(), p),
        "volume.vtk": lambda p: write(vtkStructuredPointsWriter(), volume(), p),
    }
    for name, job in jobs.items():
        job(folder / name)
    return [folder / name for name in jobs]
