# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The component god_rays of PyVista's plotters; PyVista 0.48 and later find it by themselves.

    plotter = pyvista.Plotter()
    plotter.add_mesh(mesh)
    plotter.god_rays.enable(light=(1, 2, 1), density=0.9)

Before PyVista 0.48, godrays.enable(plotter, ...) does the same.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pyvista

import godrays

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._typing import Lights, Props

if not hasattr(pyvista, "register_plotter_component"):
    raise ImportError(
        f"plotter.god_rays needs PyVista 0.48 or newer, this is {pyvista.__version__}: use "
        "godrays.enable(plotter)"
    )


@pyvista.register_plotter_component("god_rays")
class GodRays:
    """God rays and a sky in a plotter's active subplot. They are taken off as the plotter closes."""

    def __init__(self, plotter: Any) -> None:
        self._plotter = plotter

    def enable(
        self,
        light: Lights | None = None,
        occluders: Props | None = (),
        ignored: Props | None = (),
        preset: str | None = None,
        **parameters: Any,
    ) -> godrays.vtkGodRaysPass:
        """Put god rays into the active subplot, or change those that it has, as godrays.enable()."""
        return godrays.enable(self._plotter, light, occluders, ignored, preset, **parameters)

    def sky(
        self,
        sun: Sequence[float] | None = None,
        light: Any = None,
        atmosphere: godrays.vtkGodRaysAtmosphere | str | None = None,
        **parameters: Any,
    ) -> godrays.vtkGodRaysSkyPass:
        """Put the physical sky behind the active subplot, as godrays.sky()."""
        return godrays.sky(self._plotter, sun, light, atmosphere, **parameters)

    def disable(self) -> None:
        """Take the god rays off the active subplot. A sky stays."""
        godrays.disable(self._plotter)

    @property
    def rays(self) -> godrays.vtkGodRaysPass | None:
        """The pass of the active subplot, None if it has no god rays."""
        return godrays.vtkGodRaysPass.Find(self._plotter.renderer)

    def __plotter_close__(self) -> None:
        for renderer in self._plotter.renderers:
            godrays.disable(renderer)
            godrays.vtkGodRaysSkyPass.Detach(renderer)

    __plotter_deep_clean__ = __plotter_close__
