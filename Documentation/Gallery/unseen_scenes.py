# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets for which no default was chosen: they were collected when the defaults stood, to see how these do.

A maker adds props to a renderer and may set its background, as its data's users do. Files are of Debian's
packages mricron-data, pymol-data, assimp-testmodels and python-matplotlib-data, and of python3-pyvista.
"""

import gzip
import importlib.util
import math
import os

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import default_scenes
from default_scenes import MODELS, actor, contour, elevation, function, imported, sampled, through, tubes
from default_situations import add, ball


def show(renderer, mapper):
    prop = vtk.vtkActor()
    prop.SetMapper(mapper)
    add(renderer, prop)


def find_pyvista():
    """The folder of PyVista's own data, without importing it; "" without PyVista."""
    found = importlib.util.find_spec("pyvista")
    places = list(found.submodule_search_locations) if found else []
    return os.path.join(places[0], "examples") if places else ""


BRAINS = "/usr/share/mricron/templates"
PROTEINS = "/usr/share/pymol/data/demo"
SAMPLES = "/usr/share/matplotlib/mpl-data/sample_data"
PYVISTA = find_pyvista()

WHITE, LIGHT_GREY = (1, 1, 1), (0.93, 0.93, 0.93)
PARAVIEW = (0.32, 0.34, 0.43)


def scan(name, shrink):
    """A NIfTI image, coarser by a factor."""
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(f"{BRAINS}/{name}.nii.gz")
    coarser = vtk.vtkImageShrink3D()
    coarser.SetShrinkFactors(shrink, shrink, shrink)
    through(reader, coarser).Update()
    return coarser.GetOutput()


def read(reader, path):
    reader.SetFileName(path)
    return reader


def points_of(coordinates, *scalars):
    """A vtkPolyData of vertices."""
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(coordinates, dtype=float), deep=True))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    for each in scalars:
        array = numpy_to_vtk(numpy.ascontiguousarray(each), deep=True)
        array.SetName("values")
        data.GetPointData().SetScalars(array)
    vertices = vtk.vtkVertexGlyphFilter()
    vertices.SetInputData(data)
    return vertices


def curve(coordinates):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(coordinates, dtype=float), deep=True))
    line = vtk.vtkPolyLineSource()
    line.SetPoints(points)
    return line


def parametric(shape, colors=None):
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetScalarModeToU()
    return actor(source, colors)


def add_bar(renderer, prop, title):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(prop.GetMapper().GetLookupTable())
    bar.SetTitle(title)
    add(renderer, bar)


def head(renderer):
    """The skin of a scanned head."""
    skin = contour(scan("ch2", 2), 45)
    add(renderer, actor(through(skin, vtk.vtkPolyDataNormals()), (0.9, 0.75, 0.65)))


def macaque(renderer):
    """A macaque's brain, as a volume."""
    image = scan("inia19-t1-brain", 2)
    high = numpy.percentile(vtk_to_numpy(image.GetPointData().GetScalars()), 99.5)
    add(renderer, default_scenes.volume_of(image, 0.25 * high, high))


def atlas(renderer):
    """Regions of a brain, each in its colour."""
    labels = scan("aal", 3)
    surfaces = vtk.vtkDiscreteFlyingEdges3D()
    surfaces.SetInputData(labels)
    surfaces.GenerateValues(116, 1, 116)
    smooth = vtk.vtkWindowedSincPolyDataFilter()
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(116)
    random = numpy.random.default_rng(8)
    for index in range(116):
        table.SetTableValue(index, *random.uniform(0.2, 1, 3), 1)
    prop = actor(through(surfaces, smooth, vtk.vtkPolyDataNormals()))
    prop.GetMapper().SetLookupTable(table)
    prop.GetMapper().SetColorModeToMapScalars()  # bytes are colours by themselves
    add(renderer, prop)


def slices(renderer):
    """Three planes through a scan, as radiologists look at it."""
    image = scan("ch2bet", 1)
    for axis in range(3):
        mapper = vtk.vtkImageSliceMapper()
        mapper.SetInputData(image)
        mapper.SetOrientation(axis)
        mapper.SetSliceNumber(image.GetDimensions()[axis] // 2)
        prop = vtk.vtkImageSlice()
        prop.SetMapper(mapper)
        prop.GetProperty().SetColorWindow(140)
        prop.GetProperty().SetColorLevel(70)
        add(renderer, prop)


def ribbon(renderer):
    """A protein as a ribbon, before white."""
    reader = read(vtk.vtkPDBReader(), f"{PROTEINS}/1tii.pdb")
    add(renderer, actor(through(reader, vtk.vtkProteinRibbonFilter())))
    renderer.SetBackground(WHITE)


def peptide(renderer):
    """A peptide's atoms at their van der Waals radii."""
    reader = read(vtk.vtkPDBReader(), f"{PROTEINS}/pept.pdb")
    mapper = vtk.vtkMoleculeMapper()
    mapper.UseVDWSpheresSettings()
    mapper.SetInputConnection(reader.GetOutputPort(1))
    show(renderer, mapper)


def rock(renderer):
    """A rock of a 3DS file."""
    add(renderer, *imported(vtk.vtk3DSImporter(), f"{MODELS}/3DS/fels.3ds"))


def part(renderer):
    """An STL file of a modeller, with its edges."""
    prop = actor(read(vtk.vtkSTLReader(), f"{MODELS}/STL/3DSMaxExport.STL"), (0.7, 0.7, 0.75))
    prop.GetProperty().EdgeVisibilityOn()
    add(renderer, prop)


def clear_coats(renderer):
    """glTF: spheres of many materials."""
    add(renderer, *imported(vtk.vtkGLTFImporter(), f"{MODELS}/glTF2/ClearCoat-glTF/ClearCoatTest.gltf"))


def slice_as_relief(renderer):
    """A slice of a head's scan, its values as heights."""
    with gzip.open(f"{SAMPLES}/s1045.ima.gz") as file:
        values = numpy.frombuffer(file.read(), numpy.uint16).reshape(256, 256).astype(float)
    add(renderer, actor(default_scenes.relief(values, 1.0, 60 / values.max())))


def photograph(renderer):
    """A picture on a plane, as it is drawn by a vtkImageActor."""
    prop = vtk.vtkImageActor()
    reader = read(vtk.vtkJPEGReader(), f"{SAMPLES}/grace_hopper.jpg")
    prop.GetMapper().SetInputConnection(reader.GetOutputPort())
    add(renderer, prop)


def airplane(renderer):
    add(renderer, actor(read(vtk.vtkPLYReader(), f"{PYVISTA}/airplane.ply"), (0.4, 0.55, 0.8)))
    renderer.SetBackground(LIGHT_GREY)


def ant(renderer):
    add(renderer, actor(read(vtk.vtkPLYReader(), f"{PYVISTA}/ant.ply"), (0.6, 0.3, 0.2)))
    renderer.SetBackground(0.3, 0.3, 0.3)


def nut(renderer):
    add(renderer, actor(read(vtk.vtkPLYReader(), f"{PYVISTA}/nut.ply"), (0.8, 0.8, 0.8)))
    default_scenes.set_gradient(renderer, (1, 1, 1), (0.35, 0.5, 0.8))


def frog(renderer):
    """A frog's organs, from labels."""
    reader = read(vtk.vtkXMLImageDataReader(), f"{PYVISTA}/frog_tissues.vti")
    surfaces = vtk.vtkDiscreteFlyingEdges3D()
    surfaces.SetInputConnection(reader.GetOutputPort())
    surfaces.GenerateValues(29, 1, 29)
    prop = actor(through(surfaces, vtk.vtkWindowedSincPolyDataFilter(), vtk.vtkPolyDataNormals()))
    prop.GetMapper().SetColorModeToMapScalars()
    add(renderer, prop)


def channels(renderer):
    """The channels of a river's delta, within an outline."""
    reader = read(vtk.vtkXMLImageDataReader(), f"{PYVISTA}/channels.vti")
    keep = vtk.vtkThreshold()
    keep.SetInputConnection(reader.GetOutputPort())
    keep.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    keep.SetUpperThreshold(0.9)
    add(renderer, actor(elevation(keep)))
    box = vtk.vtkOutlineFilter()
    box.SetInputConnection(reader.GetOutputPort())
    add(renderer, actor(box, (1, 1, 1)))


def beam(renderer):
    """Finite elements, bent, with edges and a scalar bar, before ParaView's background."""
    source = vtk.vtkCellTypeSource()
    source.SetCellType(vtk.VTK_HEXAHEDRON)
    source.SetBlocksDimensions(24, 3, 3)
    bend = vtk.vtkProgrammableFilter()
    bend.SetInputConnection(source.GetOutputPort())

    def run():
        bend.GetOutput().ShallowCopy(bend.GetInput())
        old = vtk_to_numpy(bend.GetInput().GetPoints().GetData())
        new = old.copy()
        new[:, 1] -= 0.012 * old[:, 0] ** 2
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(new, deep=True))
        bend.GetOutput().SetPoints(points)
        strain = numpy_to_vtk(numpy.abs(old[:, 1] - 1.5) * (24 - old[:, 0]), deep=True)
        strain.SetName("strain")
        bend.GetOutput().GetPointData().SetScalars(strain)

    bend.SetExecuteMethod(run)
    bend.Update()
    prop = actor(bend.GetOutput())
    prop.GetProperty().EdgeVisibilityOn()
    add(renderer, prop)
    add_bar(renderer, prop, "strain")
    renderer.SetBackground(PARAVIEW)


def superquadrics(renderer):
    for i in range(4):
        for j in range(4):
            source = vtk.vtkSuperquadricSource()
            source.SetToroidal((i + j) % 2)
            source.SetPhiRoundness(0.2 + 0.6 * i)
            source.SetThetaRoundness(0.2 + 0.6 * j)
            source.SetScale(0.8, 0.8, 0.8)
            prop = actor(source, (0.3 + 0.2 * i, 0.4, 0.3 + 0.2 * j))
            prop.SetPosition(1.3 * i, 1.3 * j, 0)
            add(renderer, prop)


def boy(renderer):
    """Boy's surface, before a light grey."""
    add(renderer, parametric(vtk.vtkParametricBoy()))
    renderer.SetBackground(LIGHT_GREY)


def shell(renderer):
    """A shell of a snail, unshaded."""
    prop = parametric(vtk.vtkParametricConicSpiral())
    prop.GetProperty().SetInterpolationToFlat()
    add(renderer, prop)


def lorenz(renderer):
    """A path of Lorenz's system as a tube, before white, with a scalar bar."""
    place = numpy.array([1.0, 1.0, 1.0])
    path = []
    for _ in range(4000):
        x, y, z = place
        place = place + 0.006 * numpy.array([10 * (y - x), x * (28 - z) - y, x * y - 8 * z / 3])
        path.append(place)
    prop = actor(elevation(tubes(curve(path), 0.25)))
    add(renderer, prop)
    add_bar(renderer, prop, "z")
    renderer.SetBackground(WHITE)


def orbital(renderer):
    """An orbital of hydrogen, its signs in two colours, one translucent and peeled."""
    n = 60
    z, y, x = numpy.mgrid[-9 : 9 : n * 1j, -9 : 9 : n * 1j, -9 : 9 : n * 1j]
    r = numpy.sqrt(x * x + y * y + z * z)
    values = (3 * z * z - r * r) * numpy.exp(-r / 1.5)
    add(renderer, actor(contour(sampled(values), 1.0), (0.85, 0.3, 0.2)))
    add(renderer, actor(contour(sampled(values), -1.0), (0.2, 0.45, 0.85), 0.5))
    renderer.UseDepthPeelingOn()


def tensors(renderer):
    """Ellipsoids of the stress beneath a load."""
    load = vtk.vtkPointLoad()
    load.SetLoadValue(100)
    load.SetSampleDimensions(6, 6, 6)
    load.SetModelBounds(-10, 10, -10, 10, -10, 10)
    sphere = vtk.vtkSphereSource()
    sphere.SetThetaResolution(12)
    glyphs = vtk.vtkTensorGlyph()
    glyphs.SetInputConnection(load.GetOutputPort())
    glyphs.SetSourceConnection(sphere.GetOutputPort())
    glyphs.SetScaleFactor(10)
    glyphs.ClampScalingOn()
    glyphs.SetMaxScaleFactor(1.5)
    add(renderer, actor(through(glyphs, vtk.vtkPolyDataNormals())))


def galaxy(renderer):
    """Stars as splats that add their light."""
    random = numpy.random.default_rng(5)
    count = 6000
    radius = random.exponential(1.0, count)
    turn = 2.2 * numpy.log(radius + 0.2) + math.pi * random.integers(0, 2, count)
    turn = turn + random.normal(0, 0.25, count)
    stars = numpy.stack(
        [radius * numpy.cos(turn), radius * numpy.sin(turn), random.normal(0, 0.05, count)], -1)
    mapper = vtk.vtkPointGaussianMapper()
    points = points_of(stars, radius)
    mapper.SetInputConnection(points.GetOutputPort())
    mapper.SetScaleFactor(0.03)
    mapper.EmissiveOn()
    mapper.SetScalarRange(0, 4)
    show(renderer, mapper)


def spheres(renderer):
    """Points, drawn as spheres."""
    random = numpy.random.default_rng(1)
    stars = random.normal(size=(1500, 3))
    prop = actor(points_of(stars, stars[:, 2].copy()))
    prop.GetProperty().SetPointSize(7)
    prop.GetProperty().RenderPointsAsSpheresOn()
    add(renderer, prop)


def balls_by_a_mapper(renderer):
    """Balls of many sizes, which a vtkGlyph3DMapper draws."""
    random = numpy.random.default_rng(6)
    sizes = random.uniform(0.2, 1.2, 40)
    points = points_of(random.uniform(-3, 3, (40, 3)), sizes)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    sphere = ball(0.5)
    mapper.SetSourceConnection(sphere.GetOutputPort())
    mapper.SetScaleArray("values")
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.SetScalarRange(0.2, 1.2)
    show(renderer, mapper)


def tetrahedra(renderer):
    """A Delaunay tetrahedralization, shrunk, with edges."""
    random = numpy.random.default_rng(7)
    points = points_of(random.uniform(-1, 1, (60, 3)))
    mesh = vtk.vtkDelaunay3D()
    mesh.SetInputConnection(points.GetOutputPort())
    shrink = vtk.vtkShrinkFilter()
    shrink.SetShrinkFactor(0.7)
    prop = actor(elevation(through(mesh, shrink)))
    prop.GetProperty().EdgeVisibilityOn()
    add(renderer, prop)
    default_scenes.set_gradient(renderer, (0, 0, 0.17), PARAVIEW)


def triangulation(renderer):
    """A terrain of scattered points, triangulated, with axes about it."""
    random = numpy.random.default_rng(9)
    place = random.uniform(-3, 3, (600, 2))
    height = numpy.exp(-(place**2).sum(1) / 3) + 0.3 * numpy.sin(2 * place[:, 0])
    points = points_of(numpy.column_stack([place, height]), height)
    mesh = vtk.vtkDelaunay2D()
    mesh.SetInputConnection(points.GetOutputPort())
    mesh.Update()
    add(renderer, actor(mesh))
    axes = vtk.vtkCubeAxesActor()
    axes.SetBounds(mesh.GetOutput().GetBounds())
    axes.SetCamera(renderer.GetActiveCamera())
    add(renderer, axes)


def quadric(renderer):
    """Isosurfaces of a quadric, cut open."""
    shape = vtk.vtkQuadric()
    shape.SetCoefficients(0.5, 1, 0.2, 0, 0.1, 0, 0, 0.2, 0, 0)
    field = function(shape)
    surfaces = vtk.vtkContourFilter()
    surfaces.SetInputConnection(field.GetOutputPort())
    surfaces.GenerateValues(5, 0.05, 0.6)
    cut = vtk.vtkClipPolyData()
    plane = vtk.vtkPlane()
    plane.SetNormal(0, 1, 0)
    cut.SetClipFunction(plane)
    prop = actor(through(surfaces, cut))
    add(renderer, prop)
    add_bar(renderer, prop, "value")


def cuts(renderer):
    """Three planes through a field, in an outline, seen in parallel."""
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    for axis in range(3):
        normal = [0, 0, 0]
        normal[axis] = 1
        plane = vtk.vtkPlane()
        plane.SetNormal(normal)
        cutter = vtk.vtkCutter()
        cutter.SetCutFunction(plane)
        add(renderer, actor(through(wavelet, cutter)))
    add(renderer, actor(through(wavelet, vtk.vtkOutlineFilter()), (1, 1, 1)))
    renderer.GetActiveCamera().ParallelProjectionOn()


def map_of_values(renderer):
    """A colour map on a plane, seen from above, before white, with contour lines."""
    y, x = numpy.mgrid[-3:3:80j, -3:3:80j]
    values = 3 * (1 - x) ** 2 * numpy.exp(-(x**2) - (y + 1) ** 2) - 10 * (x / 5 - x**3 - y**5) * numpy.exp(
        -(x**2) - y**2)
    image = sampled(values[None])
    surface = vtk.vtkImageDataGeometryFilter()
    surface.SetInputData(image)
    prop = actor(surface)
    prop.GetProperty().LightingOff()
    lines = contour(image, *range(-6, 9))
    add(renderer, prop, actor(lines, (0, 0, 0)))
    add_bar(renderer, prop, "peaks")
    renderer.SetBackground(WHITE)


def brightest(renderer):
    """A volume of which the greatest value along the line of sight is shown."""
    n = 60
    random = numpy.random.default_rng(4)
    z, y, x = numpy.mgrid[-1 : 1 : n * 1j, -1 : 1 : n * 1j, -1 : 1 : n * 1j]
    values = numpy.zeros_like(x)
    for _ in range(25):
        at = random.uniform(-0.7, 0.7, 3)
        values += numpy.exp(-((x - at[0]) ** 2 + (y - at[1]) ** 2 + (z - at[2]) ** 2) / 0.012)
    prop = default_scenes.volume_of(sampled(values), 0.1, 1.0)
    prop.GetMapper().SetBlendModeToMaximumIntensity()
    add(renderer, prop)


def globe(renderer):
    """The coasts of the Earth on a ball."""
    coasts = vtk.vtkEarthSource()
    coasts.OutlineOn()
    add(renderer, actor(coasts, (1, 1, 1)), actor(ball(0.98), (0.1, 0.3, 0.6)))


def forest(renderer):
    random = numpy.random.default_rng(3)
    for _ in range(60):
        cone = vtk.vtkConeSource()
        cone.SetDirection(0, 0, 1)
        cone.SetHeight(2)
        cone.SetRadius(0.4)
        cone.SetCenter(*random.uniform(-6, 6, 2), 1)
        cone.SetResolution(12)
        add(renderer, actor(cone, (0.1, 0.35, 0.15)))
    ground = vtk.vtkPlaneSource()
    ground.SetOrigin(-7, -7, 0)
    ground.SetPoint1(7, -7, 0)
    ground.SetPoint2(-7, 7, 0)
    add(renderer, actor(ground, (0.4, 0.35, 0.25)))


def helices(renderer):
    """Twelve curves as lines, before grey."""
    append = vtk.vtkAppendPolyData()
    t = numpy.linspace(0, 20, 300)
    for k in range(12):
        phase = t + 0.52 * k
        line = curve(numpy.stack([numpy.cos(phase), numpy.sin(phase), 0.12 * t], -1))
        append.AddInputConnection(line.GetOutputPort())
    prop = actor(elevation(append))
    prop.GetProperty().SetLineWidth(2)
    add(renderer, prop)
    renderer.SetBackground(0.5, 0.5, 0.5)


def dodecahedron(renderer):
    """One solid with edges, before PyVista's former background."""
    solid = vtk.vtkPlatonicSolidSource()
    solid.SetSolidTypeToDodecahedron()
    prop = actor(solid, (0.98, 0.92, 0.84))
    prop.GetProperty().EdgeVisibilityOn()
    add(renderer, prop)
    renderer.SetBackground(0.3, 0.3, 0.3)


def far_from_zero(renderer):
    """A mesh in the coordinates of a national grid."""
    mesh = actor(elevation(tubes(curve([(0, 0, 0), (40, 10, 20), (60, 50, 10), (20, 60, 40)]), 4)))
    mesh.SetPosition(4.5e5, 5.2e6, 300)
    add(renderer, mesh)


# name: how it is made, azimuth and elevation of the camera [degrees], what is up
SCENES = {
    "head": (head, 150, 5, "z"),
    "macaque": (macaque, 40, 20, "z"),
    "atlas": (atlas, 140, 20, "z"),
    "slices": (slices, 40, 25, "z"),
    "ribbon": (ribbon, 30, 20, "y"),
    "peptide": (peptide, 30, 20, "y"),
    "rock": (rock, 30, 20, "z"),
    "part": (part, 30, 25, "z"),
    "clear coats": (clear_coats, 0, 0, "y"),
    "slice as relief": (slice_as_relief, 30, 30, "z"),
    "photograph": (photograph, 20, 0, "y"),
    "airplane": (airplane, 30, 25, "z"),
    "ant": (ant, 30, 25, "z"),
    "nut": (nut, 30, 25, "z"),
    "frog": (frog, 30, 40, "z"),
    "channels": (channels, 30, 40, "z"),
    "beam": (beam, 25, 20, "y"),
    "superquadrics": (superquadrics, 25, 40, "z"),
    "boy": (boy, 30, 20, "z"),
    "shell": (shell, 30, 20, "z"),
    "lorenz": (lorenz, 30, 10, "z"),
    "orbital": (orbital, 20, 10, "z"),
    "tensors": (tensors, 30, 15, "z"),
    "galaxy": (galaxy, 20, 50, "z"),
    "spheres": (spheres, 0, 0, "z"),
    "balls by a mapper": (balls_by_a_mapper, 30, 20, "z"),
    "tetrahedra": (tetrahedra, 30, 20, "z"),
    "triangulation": (triangulation, 30, 25, "z"),
    "quadric": (quadric, 150, 20, "z"),
    "cuts": (cuts, 40, 25, "z"),
    "map of values": (map_of_values, 0, 0, "y"),
    "brightest": (brightest, 30, 20, "z"),
    "globe": (globe, 20, 20, "z"),
    "forest": (forest, 20, 8, "z"),
    "helices": (helices, 30, 20, "z"),
    "dodecahedron": (dodecahedron, 30, 20, "y"),
    "far from zero": (far_from_zero, 30, 20, "z"),
}


def make(name, size):
    """A window that shows a scene."""
    fill, *view = SCENES[name]
    window, renderer = default_scenes.open_window(size)
    fill(renderer)
    default_scenes.aim(renderer, *view)
    return window, renderer
