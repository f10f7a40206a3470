# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets as people have them, shown as VTK shows them without further ado: no light, no background and
no material is chosen here, but where the data ask for colours."""

import glob
import math
import os

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import godrays

MODELS = "/usr/share/assimp/models"


def actor(source, colors=None, opacity=1.0):
    """An actor of an algorithm or a data set, coloured by its scalars or by three numbers."""
    mapper = vtk.vtkDataSetMapper()
    if isinstance(source, vtk.vtkAlgorithm):
        source.Update()
        mapper.SetInputConnection(source.GetOutputPort())
        source = source.GetOutput()
    else:
        mapper.SetInputData(source)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetOpacity(opacity)
    if colors is not None:
        mapper.ScalarVisibilityOff()
        result.GetProperty().SetColor(colors)
    else:
        mapper.SetScalarRange(source.GetScalarRange())
    return result


def through(source, *filters):
    """The last of filters, connected in a row."""
    for each in filters:
        each.SetInputConnection(source.GetOutputPort())
        source = each
    return source


def elevation(source, axis=2):
    """The source, coloured by its heights."""
    source.Update()
    bounds = source.GetOutput().GetBounds()
    filter = vtk.vtkElevationFilter()
    low, high = [0.0] * 3, [0.0] * 3
    low[axis], high[axis] = bounds[2 * axis], bounds[2 * axis + 1]
    filter.SetLowPoint(low)
    filter.SetHighPoint(high)
    return through(source, filter)


def tubes(source, radius):
    filter = vtk.vtkTubeFilter()
    filter.SetRadius(radius)
    filter.SetNumberOfSides(12)
    return through(source, filter)


def function(implicit, cells=60, size=1.0):
    sample = vtk.vtkSampleFunction()
    sample.SetImplicitFunction(implicit)
    sample.SetModelBounds(-size, size, -size, size, -size, size)
    sample.SetSampleDimensions(cells, cells, cells)
    sample.ComputeNormalsOff()
    return sample


def sampled(values, spacing=1.0):
    """A vtkImageData of an array [z, y, x]."""
    image = vtk.vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing, spacing, spacing)
    array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32).ravel(), deep=True)
    array.SetName("values")
    image.GetPointData().SetScalars(array)
    return image


def contour(image, *values):
    filter = vtk.vtkContourFilter()
    filter.SetInputData(image)
    for index, value in enumerate(values):
        filter.SetValue(index, value)
    return filter


def relief(heights, spacing, scale, steps=1):
    """Heights [y, x] as a surface."""
    image = sampled(heights[None, ::steps, ::steps], spacing * steps)
    warp = vtk.vtkWarpScalar()
    warp.SetScaleFactor(scale)
    surface = vtk.vtkImageDataGeometryFilter()
    surface.SetInputData(image)
    normals = vtk.vtkPolyDataNormals()
    normals.SplittingOff()
    return through(surface, warp, normals)


def gradient_field():
    wavelet = vtk.vtkRTAnalyticSource()
    gradient = vtk.vtkGradientFilter()
    gradient.SetInputConnection(wavelet.GetOutputPort())
    gradient.SetInputScalars(vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "RTData")
    gradient.SetResultArrayName("v")
    gradient.Update()
    gradient.GetOutput().GetPointData().SetActiveVectors("v")
    return gradient


def cones():
    """Cones in a ring, with the camera in the ring's plane."""
    props = []
    for index in range(6):
        angle = math.radians(60 * index)
        cone = vtk.vtkConeSource()
        cone.SetResolution(32)
        cone.SetCenter(2 * math.cos(angle), 0, 2 * math.sin(angle))
        cone.SetDirection(0, 1, 0)
        cone.SetHeight(1.6)
        props.append(actor(cone, (0.9, 0.4 + 0.1 * index, 0.2)))
    return props


def exploded_sphere():
    sphere = vtk.vtkSphereSource()
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    shrink = vtk.vtkShrinkPolyData()
    shrink.SetShrinkFactor(0.7)
    return [actor(elevation(through(sphere, shrink), 1))]


def jacksboro():
    name = sorted(glob.glob("/usr/share/matplotlib/**/jacksboro_fault_dem.npz", recursive=True))[0]
    heights = numpy.load(name)["elevation"]
    return [actor(relief(heights, 90.0, 5.0))]


def topobathy():
    name = sorted(glob.glob("/usr/share/matplotlib/**/topobathy.npz", recursive=True))[0]
    heights = numpy.load(name)["topo"]
    return [actor(relief(heights, 1800.0, 30.0))]


def terrain():
    source = godrays.vtkGodRaysTerrainSource()
    source.Update()
    image = source.GetOutput()
    heights = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[1::-1])
    return [actor(relief(heights, image.GetSpacing()[0], 1.0))]


def streamlines():
    field = gradient_field()
    seeds = vtk.vtkPointSource()
    seeds.SetRadius(8)
    seeds.SetNumberOfPoints(80)
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputConnection(field.GetOutputPort())
    tracer.SetSourceConnection(seeds.GetOutputPort())
    tracer.SetMaximumPropagation(60)
    tracer.SetIntegrationDirectionToBoth()
    return [actor(tubes(tracer, 0.12))]


def contours():
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.Update()
    return [actor(contour(wavelet.GetOutput(), 130, 160, 200))]


def translucent_contours():
    wavelet = vtk.vtkRTAnalyticSource()
    wavelet.Update()
    return [
        actor(contour(wavelet.GetOutput(), 220), (0.8, 0.3, 0.2)),
        actor(contour(wavelet.GetOutput(), 140), (0.4, 0.6, 0.9), 0.35),
    ]


def molecule():
    """A ring of carbon in layers, as of graphite."""
    result = vtk.vtkMolecule()
    atoms = {}
    for i in range(-3, 4):
        for j in range(-3, 4):
            if abs(i + j) <= 3:
                centre = numpy.array([2.46 * (i + 0.5 * j), 2.13 * j, 0.0])
                for k in range(6):
                    at = centre + 1.42 * numpy.array(
                        [math.sin(math.radians(60 * k)), math.cos(math.radians(60 * k)), 0])
                    key = tuple(numpy.round(at, 1))
                    if key not in atoms:
                        atoms[key] = result.AppendAtom(6 if (i + j) % 2 else 7, *at)
    keys = list(atoms)
    for a in range(len(keys)):
        for b in range(a):
            if numpy.linalg.norm(numpy.subtract(keys[a], keys[b])) < 1.6:
                result.AppendBond(atoms[keys[a]], atoms[keys[b]], 1)
    mapper = vtk.vtkMoleculeMapper()
    mapper.SetInputData(result)
    mapper.UseBallAndStickSettings()
    prop = vtk.vtkActor()
    prop.SetMapper(mapper)
    return [prop]


def canopy():
    """Points of trees on a ground, as a scanner sees them."""
    random = numpy.random.default_rng(1)
    parts = []
    for _ in range(60):
        x, y = random.uniform(-20, 20, 2)
        height = random.uniform(5, 9)
        crown = random.normal(size=(1200, 3)) * (1.1, 1.1, 1.6) + (x, y, height)
        trunk = numpy.column_stack(
            [random.normal(x, 0.08, 150), random.normal(y, 0.08, 150), random.uniform(0, height, 150)])
        parts += [crown, trunk]
    parts.append(numpy.column_stack([random.uniform(-22, 22, (20000, 2)), random.normal(0, 0.1, 20000)]))
    cloud = numpy.concatenate(parts)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(cloud, deep=True))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    heights = numpy_to_vtk(cloud[:, 2].copy(), deep=True)
    heights.SetName("height")
    data.GetPointData().SetScalars(heights)
    vertices = vtk.vtkVertexGlyphFilter()
    vertices.SetInputData(data)
    prop = actor(vertices)
    prop.GetProperty().SetPointSize(2)
    return [prop]


def volume_of(image, low, high):
    opacity = vtk.vtkPiecewiseFunction()
    colors = vtk.vtkColorTransferFunction()
    opacity.AddPoint(low, 0.0)
    opacity.AddPoint(high, 0.6)
    colors.AddRGBPoint(low, 0.3, 0.4, 0.7)
    colors.AddRGBPoint(high, 1.0, 0.9, 0.7)
    mapper = vtk.vtkSmartVolumeMapper()
    mapper.SetInputData(image)
    prop = vtk.vtkVolume()
    prop.SetMapper(mapper)
    prop.GetProperty().SetScalarOpacity(opacity)
    prop.GetProperty().SetColor(colors)
    prop.GetProperty().SetInterpolationTypeToLinear()
    prop.GetProperty().ShadeOn()
    return prop


def volume():
    """A skull-like body: shells of two densities with holes."""
    n = 80
    z, y, x = numpy.mgrid[-1 : 1 : n * 1j, -1 : 1 : n * 1j, -1 : 1 : n * 1j]
    r = numpy.sqrt((x / 0.75) ** 2 + (y / 0.9) ** 2 + (z / 0.8) ** 2)
    bone = numpy.exp(-(((r - 0.85) / 0.06) ** 2))
    for at in (-0.3, 0.3):
        bone[(x - at) ** 2 + (z - 0.1) ** 2 + (y + 0.7) ** 2 < 0.06] = 0
    brain = 0.35 * (r < 0.7) * (1 + 0.3 * numpy.sin(14 * x) * numpy.sin(13 * y) * numpy.sin(15 * z))
    return [volume_of(sampled(numpy.maximum(bone, brain)), 0.3, 1.0)]


def smoke():
    source = godrays.vtkGodRaysSmokeSource()
    source.SetDimensions(48, 48, 96)
    source.SetSpacing(1 / 24)
    source.SetSourceCenter(0, 0, 0.3)
    source.SetSourceRadius(0.2)
    source.SetSourceRate(4)
    source.SetRiseSpeed(0.7)
    source.SetTurbulence(0.7)
    source.SetTimeStep(0.99 * source.GetLargestTimeStep())
    source.UpdateTimeStep(5)
    image = source.GetOutput()
    prop = volume_of(image, 0.05, 0.8)
    prop.GetProperty().SetScalarOpacityUnitDistance(image.GetLength() / 30)
    return [prop]


def imported(importer, name):
    """The actors of a file with a scene."""
    importer.SetFileName(name)
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.AddRenderer(renderer)
    window.SetOffScreenRendering(True)
    importer.SetRenderWindow(window)
    importer.Update()
    props = list(renderer.GetActors())
    for prop in props:
        renderer.RemoveActor(prop)
    window.Finalize()
    return props


def engine():
    return imported(
        vtk.vtkGLTFImporter(), f"{MODELS}/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb")


def textured_box():
    return imported(
        vtk.vtkGLTFImporter(), f"{MODELS}/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb")


def spider():
    reader = vtk.vtkOBJReader()
    reader.SetFileName(f"{MODELS}/OBJ/spider.obj")
    return [actor(through(reader, vtk.vtkPolyDataNormals()), (0.75, 0.7, 0.6))]


def boar():
    reader = vtk.vtkPLYReader()
    reader.SetFileName(f"{MODELS}/PLY/Wuson.ply")
    return [actor(reader, (0.8, 0.8, 0.8))]


def unstructured():
    source = vtk.vtkCellTypeSource()
    source.SetCellType(vtk.VTK_TETRA)
    source.SetBlocksDimensions(6, 6, 6)
    source.Update()
    shrink = vtk.vtkShrinkFilter()
    shrink.SetShrinkFactor(0.75)
    return [actor(through(source, shrink))]


def arrows():
    mask = vtk.vtkMaskPoints()
    mask.SetOnRatio(23)
    glyphs = vtk.vtkGlyph3D()
    arrow = vtk.vtkArrowSource()
    arrow.Update()
    glyphs.SetSourceData(arrow.GetOutput())
    glyphs.SetScaleModeToDataScalingOff()
    glyphs.SetScaleFactor(1.8)
    glyphs.SetColorModeToColorByVector()
    return [actor(through(gradient_field(), mask, glyphs))]


def city():
    random = numpy.random.default_rng(4)
    append = vtk.vtkAppendPolyData()
    for i in range(9):
        for j in range(9):
            box = vtk.vtkCubeSource()
            height = random.uniform(0.6, 1.6) + 2.2 * math.exp(-((i - 4) ** 2 + (j - 4) ** 2) / 6)
            box.SetBounds(i - 0.33, i + 0.33, j - 0.33, j + 0.33, 0, height)
            append.AddInputConnection(box.GetOutputPort())
    ground = vtk.vtkCubeSource()
    ground.SetBounds(-1.5, 9.5, -1.5, 9.5, -0.1, 0)
    return [actor(elevation(append)), actor(ground, (0.5, 0.5, 0.5))]


def gyroid():
    n = 90
    z, y, x = numpy.mgrid[0 : 4 * math.pi : n * 1j, 0 : 4 * math.pi : n * 1j, 0 : 4 * math.pi : n * 1j]
    values = numpy.sin(x) * numpy.cos(y) + numpy.sin(y) * numpy.cos(z) + numpy.sin(z) * numpy.cos(x)
    return [actor(contour(sampled(values), 0.0), (0.85, 0.75, 0.6))]


def lettering():
    text = vtk.vtkVectorText()
    text.SetText("VTK")
    extrude = vtk.vtkLinearExtrusionFilter()
    extrude.SetExtrusionTypeToNormalExtrusion()
    extrude.SetVector(0, 0, 1)
    extrude.SetScaleFactor(0.4)
    return [actor(through(text, vtk.vtkTriangleFilter(), extrude), (0.9, 0.75, 0.3))]


def bars():
    random = numpy.random.default_rng(2)
    append = vtk.vtkAppendPolyData()
    for i in range(12):
        for j in range(4):
            box = vtk.vtkCubeSource()
            box.SetBounds(i, i + 0.6, j, j + 0.6, 0, 1 + 3 * random.random())
            append.AddInputConnection(box.GetOutputPort())
    return [actor(elevation(append))]


def network():
    source = vtk.vtkRandomGraphSource()
    source.SetNumberOfVertices(60)
    source.SetNumberOfEdges(120)
    source.SetStartWithTree(True)
    layout = vtk.vtkGraphLayout()
    strategy = vtk.vtkForceDirectedLayoutStrategy()
    strategy.ThreeDimensionalLayoutOn()
    layout.SetLayoutStrategy(strategy)
    edges = vtk.vtkGraphToPolyData()
    through(source, layout, edges)
    edges.Update()
    length = edges.GetOutput().GetLength()
    nodes = vtk.vtkGlyph3D()
    sphere = vtk.vtkSphereSource()
    nodes.SetSourceConnection(sphere.GetOutputPort())
    nodes.SetScaleFactor(length / 30)
    nodes.ScalingOff()
    return [
        actor(tubes(edges, length / 400), (0.6, 0.6, 0.6)),
        actor(through(edges, nodes), (0.9, 0.5, 0.2)),
    ]


def klein_bottle():
    bottle = vtk.vtkParametricFigure8Klein()
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(bottle)
    source.SetScalarModeToU()
    return [actor(source)]


def pond():
    reader = vtk.vtkPLYReader()
    reader.SetFileName(f"{MODELS}/PLY/pond.0.ply")
    return [actor(elevation(reader, 2))]


def lattice():
    append = vtk.vtkAppendPolyData()
    for a in range(5):
        for b in range(5):
            for axis in range(3):
                line = vtk.vtkLineSource()
                start = [a, b]
                start.insert(axis, 0)
                end = [a, b]
                end.insert(axis, 4)
                line.SetPoint1(start)
                line.SetPoint2(end)
                append.AddInputConnection(line.GetOutputPort())
    return [actor(elevation(tubes(append, 0.12)))]


# name: (what it is, its props, camera's azimuth and elevation [degrees], what is up)
SCENES = {
    "cones": ("cones in a ring", cones, 0, 10, "y"),
    "exploded-sphere": ("a mesh taken apart", exploded_sphere, 20, 15, "y"),
    "jacksboro": ("measured terrain", jacksboro, 160, 25, "z"),
    "topobathy": ("measured terrain with the sea's floor", topobathy, 200, 25, "z"),
    "terrain": ("made terrain", terrain, 30, 20, "z"),
    "streamlines": ("streamlines", streamlines, 30, 20, "z"),
    "contours": ("contours", contours, 40, 25, "z"),
    "translucent-contours": ("translucent contours", translucent_contours, 40, 25, "z"),
    "molecule": ("a molecule", molecule, 25, 60, "z"),
    "canopy": ("points of a scanner", canopy, 30, 8, "z"),
    "volume": ("a volume like a CT", volume, 30, 15, "z"),
    "smoke": ("a volume of smoke", smoke, 20, 10, "z"),
    "engine": ("glTF: an engine", engine, 35, 20, "y"),
    "textured-box": ("glTF: a textured box", textured_box, 35, 25, "y"),
    "spider": ("a mesh of an OBJ file", spider, 30, 25, "y"),
    "boar": ("a mesh of a PLY file", boar, 120, 15, "y"),
    "unstructured": ("an unstructured grid", unstructured, 30, 25, "z"),
    "arrows": ("glyphs of a vector field", arrows, 30, 25, "z"),
    "city": ("blocks of a city", city, 30, 25, "z"),
    "gyroid": ("a porous solid", gyroid, 30, 25, "z"),
    "lettering": ("solid text", lettering, 15, 10, "y"),
    "bars": ("bars of a chart", bars, 30, 30, "z"),
    "network": ("a graph", network, 20, 15, "z"),
    "lattice": ("a truss", lattice, 25, 20, "z"),
}


def set_plain(renderer, *color):
    renderer.GradientBackgroundOff()
    renderer.SetBackground(color)


def set_gradient(renderer, lower, upper):
    renderer.SetBackground(lower)
    renderer.SetBackground2(upper)
    renderer.GradientBackgroundOn()


def clouds(color):
    """A texture of bands of a colour."""
    y, x = numpy.mgrid[0:64, 0:128] / 64
    bands = 0.7 + 0.3 * y + 0.06 * numpy.sin(12 * x + 9 * y)
    values = numpy.multiply.outer(bands, 255 * numpy.array(color)).clip(0, 255).astype(numpy.uint8)
    image = vtk.vtkImageData()
    image.SetDimensions(128, 64, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, 3), deep=True))
    texture = vtk.vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    return texture


def set_texture(renderer, color):
    renderer.SetBackgroundTexture(clouds(color))
    renderer.TexturedBackgroundOn()


def set_skybox(renderer, color):
    skybox = vtk.vtkSkybox()
    skybox.SetTexture(clouds(color))
    skybox.SetProjectionToSphere()
    renderer.AddActor(skybox)


LIGHT, DARK = (0.75, 0.85, 0.97), (0.1, 0.14, 0.25)

# what a renderer has behind its props
BACKGROUNDS = {
    "white": lambda renderer: set_plain(renderer, 1, 1, 1),
    "light grey": lambda renderer: set_plain(renderer, 0.85, 0.85, 0.85),
    "grey": lambda renderer: set_plain(renderer, 0.5, 0.5, 0.5),
    "light gradient": lambda renderer: set_gradient(renderer, (1, 1, 1), (0.6, 0.75, 0.95)),
    "dark gradient": lambda renderer: set_gradient(renderer, (0.32, 0.34, 0.43), (0, 0, 0.17)),
    "light texture": lambda renderer: set_texture(renderer, LIGHT),
    "dark texture": lambda renderer: set_texture(renderer, DARK),
    "light skybox": lambda renderer: set_skybox(renderer, LIGHT),
    "dark skybox": lambda renderer: set_skybox(renderer, DARK),
}


def open_window(size):
    """A window with one renderer, as a first script has it."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(size)
    renderer = vtk.vtkRenderer()
    window.AddRenderer(renderer)
    return window, renderer


def aim(renderer, azimuth, height, up):
    """See all, from the front turned by two angles [degrees]."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition((0, 0, 1) if up == "y" else (0, -1, 0))
    camera.SetViewUp((0, 1, 0) if up == "y" else (0, 0, 1))
    camera.Azimuth(azimuth)
    camera.Elevation(height)
    renderer.ResetCamera()


def make(name, size):
    """A window that shows a scene."""
    _, props, *view = SCENES[name]
    window, renderer = open_window(size)
    for prop in props():
        renderer.AddViewProp(prop)
    aim(renderer, *view)
    return window, renderer
