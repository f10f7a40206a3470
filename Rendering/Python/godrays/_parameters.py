# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Keywords of enable() and sky() as properties of the pass, its model and its integrator."""

from __future__ import annotations

from ._errors import tell_names
from ._properties import constant, snake
from ._vtk import vtkImageProcessingPass, vtkObject
from .vtkGodRaysRendering import (
    vtkGodRaysAtmosphereModel,
    vtkGodRaysHomogeneousModel,
    vtkGodRaysPresets,
    vtkGodRaysPublishedModel,
    vtkGodRaysRadialModel,
    vtkGodRaysVolumeModel,
)

STRENGTHS = {"Exposure", "Weight"}  # of a model

MODELS = {
    "radial": vtkGodRaysRadialModel,
    "published": vtkGodRaysPublishedModel,
    "homogeneous": vtkGodRaysHomogeneousModel,
    "atmosphere": vtkGodRaysAtmosphereModel,
    "volume": vtkGodRaysVolumeModel,
}


def get_names(owner):
    """The names of an object's own properties, as in SetName and GetName."""
    is_pass = isinstance(owner, vtkImageProcessingPass)
    base = vtkImageProcessingPass if is_pass else vtkObject
    names = set(dir(owner)) - set(dir(base))
    return {
        name[3:] for name in names if name.startswith("Set") and "Get" + name[3:] in names
    } - {"Role"}


def forward(name):
    """A property of the pass that is one of its model's, where the model has it."""

    def find(rays):
        if not hasattr(type(rays.GetModel()), name):
            has = [each for each, cls in MODELS.items() if hasattr(cls, name)]
            model = rays.GetModel().GetClassName()
            raise AttributeError(f"{name} is of the model {' or '.join(has)}, not of {model}")
        return rays.GetModel()

    text = next(getattr(each, name).__doc__ for each in MODELS.values() if hasattr(each, name))
    return property(
        lambda rays: getattr(find(rays), name), lambda rays, value: setattr(find(rays), name, value), None,
        f"{text} Of the model that has it.")


def make_model(model):
    """A model by its name; others as they are."""
    if not isinstance(model, str):
        return model
    if model not in MODELS:
        raise ValueError(f"there is no model {model!r}" + tell_names(model, MODELS))
    return MODELS[model]()


def add_model(rays, preset, parameters):
    """The parameters of enable() with the model that they and the preset ask for, as an object."""
    names = {name.replace("_", "").lower(): name for name in parameters}
    model = make_model(parameters.get(names.get("model")))
    if model is not None:
        parameters = {**parameters, names["model"]: model}
    if preset is None:
        return parameters
    has = vtkGodRaysPresets.NewModel(preset) if isinstance(preset, str) else None
    if has is None:
        listed = vtkGodRaysPresets.ListNames().split(", ")
        raise ValueError(f"there is no preset {preset!r}" + tell_names(preset, listed))
    if (model or rays.GetModel()).IsA(has.GetClassName()):
        return parameters
    if model is not None:
        raise ValueError(
            f"the preset {preset!r} is one of {has.GetClassName()}, not of {model.GetClassName()}"
        )
    return {**parameters, "model": has}


def find_names(parameters, properties, others=()):
    """The parameters under these names of properties, or a TypeError, which names the others, too."""
    names = {name.lower(): name for name in properties}
    unknown = [name for name in parameters if name.replace("_", "").lower() not in names]
    if unknown:
        has = [each for each, cls in MODELS.items() if hasattr(cls, unknown[0]) and "model" in names]
        if has:
            raise TypeError(
                f"{unknown[0]} is a parameter of the model {' or '.join(has)}; give model={has[0]!r}, or one "
                "of its presets")
        valid = sorted([*map(snake, properties), *others])
        raise TypeError(f"there is no parameter {', '.join(unknown)}" + tell_names(unknown[0], valid))
    return {names[name.replace("_", "").lower()]: value for name, value in parameters.items()}


def find_settings(rays, parameters, others):
    """The parameters of enable() under their properties' names, or a TypeError, which names others, too."""
    simple = {name.replace("_", "").lower(): value for name, value in parameters.items()}
    owners = (
        rays,
        simple.get("model") or rays.GetModel(),
        simple.get("integrator") or find_integrator(rays, simple.get("model")),
    )
    settings = find_names(parameters, set().union(*map(get_names, owners)), others)
    for name, value in settings.items():
        owner = next(owner for owner in owners if name in get_names(owner))
        if isinstance(value, str):
            settings[name] = constant(owner, name, value)
    if not settings.keys().isdisjoint(STRENGTHS):
        settings.setdefault("AutomaticExposure", False)
    return settings


def find_integrator(rays, model):
    """The integrator that the rays will have with a model."""
    if model is None or rays.GetIntegrator().Supports(model):
        return rays.GetIntegrator()
    return model.MakeIntegrator()
