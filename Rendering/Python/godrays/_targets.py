# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a target, a prop or a light of the module's functions may be: VTK's, PyVista's, vedo's, ParaView's."""

from __future__ import annotations

import math
import numbers
import sys
import weakref

from vtkmodules.vtkRenderingCore import vtkLight, vtkProp, vtkRenderer, vtkRenderWindow

from .vtkGodRaysFilters import vtkGodRaysSun, vtkGodRaysSunPosition
from .vtkGodRaysRendering import vtkGodRaysPass


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
            f"{type(target).__name__}"
        )
    return target


def is_closed(target):
    """Whether it is a plotter that has been closed."""
    return hasattr(target, "renderer") and target.renderer is None


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
        raise TypeError(f"a vtkProp, such as a vtkActor, is needed, not {type(thing).__name__}")
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
        f"list of these, not {type(light).__name__}"
    )


def make_sun(direction):
    if len(direction) != 3 or not any(direction) or not all(map(math.isfinite, direction)):
        raise ValueError(
            f"light={tuple(direction)} is no direction; say in three numbers where the light comes from")
    sun = vtkLight()
    sun.SetPosition(*direction)
    sun.SetFocalPoint(0, 0, 0)
    return sun


def find_angles(direction, sun, renderer):
    """Azimuth and elevation of a direction in the frame of a vtkGodRaysSun [degrees]."""
    camera = renderer.GetActiveCamera() if sun.GetFrame() == vtkGodRaysSun.CAMERA else None
    up, north, angles = [0.0] * 3, [0.0] * 3, [0.0] * 2
    sun.GetAxes(camera, up, north)
    if not vtkGodRaysSunPosition.ComputeAngles(direction, up, north, angles):
        raise ValueError("up and north should be directions that are not parallel")
    return angles


def refer(thing):
    try:
        return weakref.ref(thing)
    except TypeError:
        return None
