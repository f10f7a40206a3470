# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of other programs as keyword parameters of enable() and render()."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING, Any

from ._errors import GodRaysWarning, tell_names, to_numbers

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

_EVERYWHERE = "it costs and looks the same here without"
_NO_COUNTERPART = {
    "from_pmndrs": {
        **dict.fromkeys(("blur", "kernelSize", "resolutionScale", "width", "height"), _EVERYWHERE),
        "blendFunction": "rays are joined by SCREEN, its default",
        "opacity": "give intensity to enable() instead",
    },
    "from_babylon": {
        "ratio": _EVERYWHERE,
        "invert": "a picture's rows are as they should be",
        "mesh": "give it to enable() as light",
        "useDiffuseColor": "what shines does so in the colours in which it is drawn",
    },
    "from_threejs": {
        "bgColor": "the background is that of the renderer",
        "sunColor": "give the light its color",
        "vSunPositionScreenSpace": "the light is projected in each frame",
        "fAspect": "the picture's own is taken",
        "fStepSize": "the published steps are taken",
    },
    "from_good_godrays": {
        **dict.fromkeys(
            ("raymarchSteps", "blur", "edgeStrength", "edgeRadius", "resolutionScale"), _EVERYWHERE),
        "gammaCorrection": "light is added in linear light, and shown by sRGB's transfer",
        "maxDensity": "light goes on to grow with distance, as it does in a medium",
        "distanceAttenuation": "a medium is as dense everywhere",
        "color": "give the light its color",
    },
    "from_unity": {
        "enabled": "rays are on",
        "enableVolumetricFog": "rays are on",
        "maxFogDistance": "give far_limit to enable() instead",
        "depthExtent": "give far_limit to enable() instead",
        "tint": "there is no ambient light in the medium",
        "globalLightProbeDimmer": "there is no ambient light in the medium",
    },
    "from_unreal": {
        "StartDistance": "a medium begins at the eye",
        "VolumetricFogDistance": "give far_limit to enable() instead",
        "FogInscatteringColor": "there is no ambient light in the medium",
        "FogMaxOpacity": "a medium grows dense with distance",
        "DirectionalInscatteringExponent": "the phase function has it",
    },
    "from_blender": {
        "Emission Strength": "the medium does not shine",
        "Emission Color": "the medium does not shine",
        "Blackbody Intensity": "the medium does not shine",
        "Temperature": "the medium does not shine",
        "Density Attribute": "the medium is as dense everywhere; give enable() a volume as medium",
    },
}


def _take(function: str, settings: Mapping[str, Any], defaults: Mapping[str, Any]) -> dict[str, Any]:
    """The settings over the defaults. Warns of what has no counterpart; ValueError: what there is not."""
    without = _NO_COUNTERPART[function]
    if not hasattr(settings, "items"):
        raise TypeError(f"{function}() needs a dict of parameters, not {type(settings).__name__}")
    unknown = [name for name in settings if name not in defaults and name not in without]
    if unknown:
        raise ValueError(
            f"{function} does not know {', '.join(map(repr, unknown))}"
            + tell_names(unknown[0], [*defaults, *without]))
    for name in settings:
        if name in without:
            warnings.warn(f"{name} has no counterpart: {without[name]}", GodRaysWarning, stacklevel=3)
    found = dict(defaults)
    for name, default in defaults.items():
        if name not in settings:
            continue
        value = settings[name]
        single = isinstance(value, (int, float))
        shape = 3 if isinstance(default, tuple) else 1
        kind = "three finite numbers" if shape == 3 else "a finite number"
        given = to_numbers(name, [value] if single else value, (1, shape), kind)
        if shape == 3:
            found[name] = tuple(given * (3 // len(given)))
        else:
            found[name] = value if single else given[0]
    return found


def from_pmndrs(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for those of GodRaysEffect of pmndrs postprocessing.

    settings: of its constructor; density 0.96, decay 0.9, weight 0.4, exposure 0.6, samples 60 and clampMax 1
        are its defaults. blur, kernelSize, resolutionScale, blendFunction and opacity have no counterpart.

    The sum is the published one, tap by tap: see vtkGodRaysPublishedModel. Strength is as given.
    ValueError: there is no such parameter.
    """
    p = _take("from_pmndrs", settings,
        {"density": 0.96, "decay": 0.9, "weight": 0.4, "exposure": 0.6, "samples": 60, "clampMax": 1.0})
    return {"preset": "published:postprocessing", "density": p["density"], "decay": p["decay"],
        "weight": p["weight"], "exposure": p["exposure"], "number_of_samples": int(p["samples"]),
        "clamp_maximum": p["clampMax"]}


def from_babylon(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for those of VolumetricLightScatteringPostProcess of Babylon.js.

    settings: its properties; density 0.926, decay 0.96815, weight 0.58767, exposure 0.3 and samples 100 are
        its defaults.

    The sum is the published one, tap by tap. ValueError: there is no such parameter.
    """
    p = _take("from_babylon", settings,
        {"density": 0.926, "decay": 0.96815, "weight": 0.58767, "exposure": 0.3, "samples": 100})
    return {"preset": "published:babylon", "density": p["density"], "decay": p["decay"],
        "weight": p["weight"], "exposure": p["exposure"], "number_of_samples": int(p["samples"])}


def from_threejs(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for the uniforms of GodRaysShader of three.js.

    settings: fGodRayIntensity, 0.69 by default; the other uniforms have no counterpart.

    The sum is the published one, three passes of six taps. ValueError: there is no such uniform.
    """
    p = _take("from_threejs", settings, {"fGodRayIntensity": 0.69})
    return {"preset": "published:three.js", "exposure": p["fGodRayIntensity"]}


def from_good_godrays(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for those of three-good-godrays and of GodraysNode of three.js.

    settings: density, 1/128 by default [1/unit of the scene]. maxDensity, distanceAttenuation, color and what
        is about steps and blur have no counterpart.

    It mixes the light's colour into the picture by 1 - e^(-density s), s being how much of the view ray is
    lit [ThreeGoodGodrays]. Here it is a medium of that scattering coefficient that scatters evenly; intensity
    4 makes what is lit all along as bright as there. ValueError: there is no such parameter.
    """
    p = _take("from_good_godrays", settings, {"density": 1 / 128})
    return _medium((p["density"],) * 3, (0.0,) * 3, 0.0, world_unit_in_meters=1.0, intensity=4.0,
        automatic_exposure=False)


def from_unity(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for those of the Fog of Unity's High Definition Render Pipeline.

    settings: of the component in a volume profile; meanFreePath 400 [m], albedo (1, 1, 1), anisotropy 0,
        baseHeight 0 and maximumHeight 50 [m] are its defaults. With baseHeight and maximumHeight equal, the
        fog is as dense everywhere.

    Extinction is 1/meanFreePath at baseHeight and a thousandth of it at maximumHeight, exponential between: a
    scale height of 0.144765 of their difference [HDRP]. Below baseHeight, Unity's fog is even; this one grows
    denser. Up is the scene's z; the scene's unit is the metre. ValueError: there is no such parameter.
    """
    p = _take("from_unity", settings, {"meanFreePath": 400.0, "albedo": (1.0,) * 3, "anisotropy": 0.0,
        "baseHeight": 0.0, "maximumHeight": 50.0})
    if not p["meanFreePath"] > 0:
        raise ValueError(f"meanFreePath={p['meanFreePath']} should be above 0")
    depth = p["maximumHeight"] - p["baseHeight"]
    height = 0.144765 * max(depth, 0.01) if depth else None
    return _medium([albedo / p["meanFreePath"] for albedo in p["albedo"]],
        [(1 - albedo) / p["meanFreePath"] for albedo in p["albedo"]], p["anisotropy"],
        height, p["baseHeight"], phase_function="cornette_shanks", world_unit_in_meters=1.0)


def from_unreal(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for those of the Exponential Height Fog of Unreal Engine, with volumetric fog.

    settings: of the component; FogDensity 0.02, FogHeightFalloff 0.2, FogHeight 0, the component's z [cm],
        VolumetricFogScatteringDistribution 0.2, VolumetricFogAlbedo (1, 1, 1) and
        VolumetricFogExtinctionScale 1 are its defaults. A FogHeightFalloff of 0 makes it as dense everywhere.

    Extinction is FogDensity/2000 times its scale at FogHeight [1/cm], and halves with each
    1000/FogHeightFalloff centimetres of height [UnrealFog]. The phase function is Henyey and Greenstein's
    there; with a falloff it is Cornette and Shanks' here. The scene's unit is the centimetre.
    ValueError: there is no such parameter.
    """
    p = _take("from_unreal", settings, {"FogDensity": 0.02, "FogHeightFalloff": 0.2, "FogHeight": 0.0,
        "VolumetricFogScatteringDistribution": 0.2, "VolumetricFogAlbedo": (1.0,) * 3,
        "VolumetricFogExtinctionScale": 1.0})
    extinction = 100 * 0.5 * p["FogDensity"] / 1000 * p["VolumetricFogExtinctionScale"]  # [1/m]
    falloff = p["FogHeightFalloff"]
    height = 1000 / (falloff * math.log(2)) / 100 if falloff else None  # [m]
    albedo = p["VolumetricFogAlbedo"]
    return _medium([extinction * each for each in albedo], [extinction * (1 - each) for each in albedo],
        p["VolumetricFogScatteringDistribution"], height, p["FogHeight"], world_unit_in_meters=0.01)


def from_blender(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of enable() for the inputs of Principled Volume of Blender, in a world or a large box.

    settings: by the names of the node's inputs; Color (0.5, 0.5, 0.5), Density 1 [1/m], Anisotropy 0 and
        Absorption Color (0, 0, 0) are its defaults.

    As [Cycles] has it, scattering is Density Color and absorption
    Density max(1 - Color, 0) max(1 - sqrt(Absorption Color), 0). The scene's unit is the metre. Cycles
    scatters light many times, this once: dense media are darker. ValueError: there is no such input.
    """
    p = _take("from_blender", settings, {"Color": (0.5,) * 3, "Density": 1.0, "Anisotropy": 0.0,
        "Absorption Color": (0.0,) * 3})
    density = max(p["Density"], 0.0)
    absorbed = [max(1 - color, 0) * max(1 - math.sqrt(max(absorption, 0)), 0)
        for color, absorption in zip(p["Color"], p["Absorption Color"])]
    return _medium([density * color for color in p["Color"]], [density * each for each in absorbed],
        p["Anisotropy"], world_unit_in_meters=1.0)


def _medium(scattering: Sequence[float], absorption: Sequence[float], asymmetry: float,
        height: float | None = None, level: float = 0.0, *, phase_function: str = "henyey_greenstein",
        **others: Any) -> dict[str, Any]:
    """A homogeneous medium, or one whose density falls to 1/e over a height [m] above a level."""
    if height is None:
        return {"model": "homogeneous", "scattering_coefficient": tuple(scattering),
            "absorption_coefficient": tuple(absorption), "phase_function": phase_function,
            "asymmetry": asymmetry, **others}
    return {"model": "atmosphere", "rayleigh_scattering": (0.0, 0.0, 0.0),
        "mie_scattering": tuple(scattering), "mie_absorption": tuple(absorption), "mie_asymmetry": asymmetry,
        "mie_scale_height": height, "ground_level": level, **others}
