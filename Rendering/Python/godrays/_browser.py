# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A warning before PyVista hands a scene with god rays to a browser, which draws it without them."""

from __future__ import annotations

import functools
import warnings
import weakref
from typing import Any

from .vtkGodRaysRendering import vtkGodRaysPass

_METHODS = ("export_html", "export_vtksz", "show")


def watch(plotter: Any) -> None:
    """Have a plotter warn, once, of the methods that leave the drawing to a browser."""
    for name in _METHODS:
        if hasattr(type(plotter), name):
            setattr(plotter, name, _watched(plotter, name))


def unwatch(plotter: Any) -> None:
    """Give a plotter its own methods back, unless one of its renderers still has rays."""
    if not _has_rays(plotter):
        _restore(plotter)


def _restore(plotter: Any) -> None:
    for name in _METHODS:
        if hasattr(vars(plotter).get(name), "_is_godrays"):
            delattr(plotter, name)


def _has_rays(plotter: Any) -> bool:
    return any(vtkGodRaysPass.Find(renderer) for renderer in plotter.renderers)


def _watched(plotter: Any, name: str) -> Any:
    method = getattr(type(plotter), name)
    owner = weakref.ref(plotter)

    @functools.wraps(method)
    def call(*arguments: Any, **keywords: Any) -> Any:
        plotter = owner()
        if (name != "show" or _shows_in_browser(plotter, keywords)) and _has_rays(plotter):
            _restore(plotter)
            warnings.warn(
                f"{name}() has the browser draw the scene, which cannot draw god rays. "
                "Take a screenshot() instead, or render on the server: "
                "show(jupyter_backend='server').",
                UserWarning,
                stacklevel=2,
            )
        return method(plotter, *arguments, **keywords)

    call._is_godrays = True  # type: ignore[attr-defined]
    return call


def _shows_in_browser(plotter: Any, keywords: dict[str, Any]) -> bool:
    if not getattr(plotter, "notebook", False):
        return False
    return (keywords.get("jupyter_backend") or plotter.theme.jupyter_backend) in ("client", "html")
