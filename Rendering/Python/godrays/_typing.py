# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the functions of godrays take, for type checkers.

VTK's own classes are told by a method that they alone have: VTK is often installed without its types.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal, Protocol, Union


class Renderer(Protocol):
    """A vtkRenderer."""

    def GetActiveCamera(self) -> Any: ...


class Window(Protocol):
    """A vtkRenderWindow."""

    def GetRenderers(self) -> Any: ...


class Plotter(Protocol):
    """A plotter of PyVista or vedo."""

    @property
    def renderer(self) -> Any: ...


class Proxy(Protocol):
    """A view, a representation or a light of paraview.simple."""

    def GetClientSideObject(self) -> Any: ...


class VtkProp(Protocol):
    """A vtkProp, such as a vtkActor."""

    def GetPropertyKeys(self) -> Any: ...


class HasActor(Protocol):
    """An object of vedo."""

    @property
    def actor(self) -> Any: ...


class Light(Protocol):
    """A vtkLight."""

    def GetLightType(self) -> Any: ...


Target = Union[Renderer, Window, Plotter, Proxy]
Prop = Union[VtkProp, HasActor, Proxy]
Props = Union[Prop, Iterable[Prop]]
Lights = Union[Light, Prop, Iterable[float], Iterable[Union[Light, Prop, Iterable[float]]]]
Role = Literal["automatic", "occluder", "light", "ignored", "medium"]
Model = Literal["radial", "published", "homogeneous", "atmosphere", "volume"]
