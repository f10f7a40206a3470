# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A provider for the package pyvista-render-passes, which finds it by itself.

That package builds all passes of a plotter of PyVista. The provider has it put god rays where they
belong: over what draws the scene, and under its anti-aliasing and its texts. There is nothing to call:
rays come and go by godrays.enable() and godrays.disable().
"""

from __future__ import annotations

import weakref
from collections.abc import Callable, Mapping
from typing import Any

from .vtkGodRaysRendering import vtkGodRaysPass

# What has the package build the passes of a renderer anew.
_rebuilds: weakref.WeakKeyDictionary[Any, Callable[[], object]] = weakref.WeakKeyDictionary()


def rebuild(renderer: Any) -> bool:
    """Have the package build a renderer's passes anew. False if it does not build them."""
    if renderer not in _rebuilds:
        return False
    _rebuilds[renderer]()
    return True


class GodRaysProvider:
    """The god rays that a renderer has been given, for one renderer's passes."""

    name = "god_rays"
    _renderer: Any = None

    @property
    def stages(self) -> tuple[str, ...]:
        """The seat over the scene, which only one provider can have, while there are god rays."""
        if self._renderer is None or vtkGodRaysPass.Find(self._renderer) is None:
            return ()
        return ("post",)

    def build_pass(
        self, stage: str, renderer: Any, chain: Any, delegate: Any
    ) -> vtkGodRaysPass | None:
        """The renderer's god rays.

        None if depth of field or a blur is on: the seat is over these, which leave no depth to find
        what blocks light. The rays then put themselves under them.
        """
        if chain.GetDepthOfField() or chain.GetBlur():
            return None
        return vtkGodRaysPass.Find(renderer)

    def bind(self, invalidate: Callable[[], object] | None) -> None:
        """Learn the renderer from the component whose method `invalidate` is; None: it is over."""
        if invalidate is None:
            _rebuilds.pop(self._renderer, None)
            self._renderer = None
        else:
            self._renderer = invalidate.__self__.renderer  # type: ignore[attr-defined]
            _rebuilds[self._renderer] = invalidate

    def default_state(self) -> dict[str, Any]:
        """Nothing: lights and props, which rays are made of, are no JSON."""
        return {}

    get_state = default_state

    def set_state(self, state: Mapping[str, Any]) -> None:
        """Nothing is restored."""

    def veto(self, settings: Mapping[str, Any]) -> str | None:
        """Everything goes."""
        return None
