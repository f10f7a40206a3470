# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a target, a prop or a light of the module's functions may be: VTK's, PyVista's, vedo's, ParaView's."""

from __future__ import annotations

import math
import numbers
import os
import pathlib
import re
import sys
import weakref

from ._errors import to_numbers
from ._vtk import load, name_type, vtkLight, vtkProp, vtkRenderer, vtkRenderWindow
from .vtkGodRaysFilters import vtkGodRaysSun, vtkGodRaysSunPosition
from .vtkGodRaysRendering import vtkGodRaysPass, vtkGodRaysSkyPass


def find_renderer(target):
    if hasattr(target, "GetClientSideObject"):
        target = find_renderer_of_view(target)
    if isinstance(target, vtkRenderWindow):
        target = target.GetRenderers().GetFirstRenderer()
        if target is None:
            raise ValueError("the render window has no renderer; call AddRenderer() first")
    if not isinstance(target, vtkRenderer):
        if is_closed(target):
            raise ValueError(f"the {type(target).__name__} has no renderer: it is closed; make another one")
        target = getattr(target, "renderer", target)
    if not isinstance(target, vtkRenderer):
        raise TypeError(
            "god rays need a vtkRenderer, a vtkRenderWindow or a plotter with a renderer, not "
            f"{name_type(target)}"
        )
    return target


def is_closed(target):
    """Whether it is a plotter that has been closed: vedo drops its renderer, PyVista notes it."""
    return hasattr(target, "renderer") and (
        target.renderer is None or getattr(target, "_closed", None) is True)


def find_renderer_of_view(view):
    """The renderer of a render view of paraview.simple."""
    client = view.GetClientSideObject()
    if not hasattr(client, "GetRenderer"):
        raise TypeError(f"god rays need a render view of ParaView, not a {view.GetXMLLabel()}")
    if client.IsA("vtkGodRaysRenderView"):
        raise ValueError(
            "a Render View (God Rays) has its rays: set its properties, such as view.Preset and "
            "view.SunElevation"
        )
    from paraview import servermanager

    parts = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    if servermanager.ActiveConnection.IsRemote() or parts > 1:
        raise ValueError(
            "ParaView's own render view can have god rays in built-in mode alone, not with a "
            "server or in parallel; use CreateView('GodRaysRenderView') of the plugin"
        )
    if client.GetRenderWindow().GetNeverRendered():
        view.SMProxy.StillRender()  # in which ParaView sets the renderer's pass
    return client.GetRenderer()


def unwrap(thing):
    """The VTK object behind a representation or light of paraview.simple; others as they are."""
    if not hasattr(thing, "GetClientSideObject"):
        return thing
    client = thing.GetClientSideObject()
    if hasattr(client, "GetActiveRepresentation"):
        client = client.GetActiveRepresentation()
    if hasattr(client, "GetActor"):
        client = client.GetActor()
    return client


def rebuild(renderer):
    """Have pyvista-render-passes, if a renderer's passes are its, build them anew. False if not."""
    provider = sys.modules.get("godrays.pyvista_provider")
    return provider is not None and provider.rebuild(renderer)


def find_shining(renderer):
    """The renderer's props that are tagged "light"."""
    props = renderer.GetViewProps()
    return [prop for prop in props if vtkGodRaysPass.GetRole(prop) == vtkGodRaysPass.LIGHT]


def is_prop(thing):
    thing = unwrap(thing)
    return isinstance(thing, vtkProp) or isinstance(getattr(thing, "actor", None), vtkProp)


def is_list(thing):
    if hasattr(thing, "GetClientSideObject"):  # a proxy of ParaView iterates over its properties
        return False
    return hasattr(thing, "__iter__") and not isinstance(thing, str) and not is_prop(thing)


def to_list(things):
    if things is None:
        return []
    return list(things) if is_list(things) else [things]


def to_prop(thing):
    if not is_prop(thing):
        raise TypeError(f"a vtkProp, such as a vtkActor, is needed, not {name_type(thing)}")
    thing = unwrap(thing)
    return thing if isinstance(thing, vtkProp) else thing.actor


def to_lights(light):
    """What `light` of enable() means, as a list of vtkLights and props."""
    light = unwrap(light)
    if light is None:
        return []
    if is_list(light):
        light = list(light)
        if light and all(isinstance(number, numbers.Real) for number in light):
            return [make_sun(light)]
        return [each for member in light for each in to_lights(member)]
    if isinstance(light, vtkLight):
        return [light]
    if is_prop(light):
        return [to_prop(light)]
    raise TypeError(
        "a light is a vtkLight, a vtkProp, three numbers (the direction from which it comes) or a "
        f"list of these, not {name_type(light)}"
    )


def make_sun(direction):
    if len(direction) != 3 or not any(direction) or not all(map(math.isfinite, direction)):
        raise ValueError(
            f"light={tuple(direction)} is no direction; say in three numbers where the light comes from")
    sun = vtkLight()
    sun.SetPosition(*direction)
    sun.SetFocalPoint(0, 0, 0)
    return sun


def find_direction(name, angles, renderer, up="z"):
    """The direction of a sun at these angles: of the renderer's sky or, without one, with this axis up."""
    meaning = "(azimuth, elevation) in degrees, with an elevation in [-90, 90]"
    azimuth, elevation = to_numbers(name, angles, (2,), meaning)
    if abs(elevation) > 90:
        raise ValueError(f"{name}={angles!r} should be {meaning}")
    sky = vtkGodRaysSkyPass.Find(renderer)
    sun = sky.GetSun() if sky else vtkGodRaysSun()
    if not sky:
        sun.SetFrame(getattr(sun, f"{up.upper()}_UP"))
    upwards, north, direction = [0.0] * 3, [0.0] * 3, [0.0] * 3
    sun.GetAxes(renderer.GetActiveCamera(), upwards, north)
    vtkGodRaysSunPosition.ComputeDirection(azimuth, elevation, upwards, north, direction)
    return direction


def to_color(name, color):
    """Three numbers in [0, 1] for a color, which is these, "#rrggbb", "#rgb" or a name of vtkNamedColors."""
    if not isinstance(color, str):
        meaning = 'three numbers in [0, 1], "#rrggbb" or a name of vtkNamedColors'
        return to_numbers(name, color, (3,), meaning, (0, 1))
    text = color.strip()
    if re.fullmatch("#([0-9a-fA-F]{3}){1,2}", text):
        digits = len(text) // 3
        return [int(text[i : i + digits], 16) / (16**digits - 1) for i in range(1, len(text), digits)]
    colors = load("vtkCommonColor").vtkNamedColors()
    if not colors.ColorExists(text):
        raise ValueError(f"there is no color {color!r}; give #rrggbb or a name of vtkNamedColors")
    return list(colors.GetColor3d(text))


def find_angles(direction, sun, renderer):
    """Azimuth and elevation of a direction in the frame of a vtkGodRaysSun [degrees]."""
    camera = renderer.GetActiveCamera() if sun.GetFrame() == vtkGodRaysSun.CAMERA else None
    up, north, angles = [0.0] * 3, [0.0] * 3, [0.0] * 2
    sun.GetAxes(camera, up, north)
    if not vtkGodRaysSunPosition.ComputeAngles(direction, up, north, angles):
        raise ValueError("up and north should be directions that are not parallel")
    return angles


def write_whole(file, write):
    """Have write(path) write a file beside the one of this name, which takes its place once it is whole."""
    path = pathlib.Path(os.path.realpath(file))
    part = path.with_name(f".{os.getpid()}-part{path.suffix}")
    try:
        write(part)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def refer(thing):
    try:
        return weakref.ref(thing)
    except TypeError:
        return None
