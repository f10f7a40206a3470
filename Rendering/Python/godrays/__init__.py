# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""God rays for VTK scenes.

    import godrays
    rays = godrays.enable(renderer, light=(1, 2, 1), occluders=[actor], density=0.9)
    rays.intensity = 0.5
    godrays.sky(renderer, sun=(250, 8), light=rays.GetLight(0))
    godrays.shadows(renderer)  # of its lights on surfaces, with rays and without
    godrays.disable(renderer)

    with godrays.enable(renderer):  # rays while the block is executed
        window.Render()
    picture = godrays.render("model.ply", preset="low-sun")  # an array, without a window
    shafts = godrays.scatter(array, light=(0.5, 0.7))        # of an array, without OpenGL

The classes are those of C++, vtkGodRaysPass first of all; their documentation is theirs. Each GetName() is
a property, too: rays.intensity for GetIntensity() and SetIntensity(). Properties and functions raise errors
as godrays.Error.
"""

from __future__ import annotations

import re
import warnings
from numbers import Real
from typing import TYPE_CHECKING, Any

from ._vtk import name_type as _name_type
from ._vtk import vtkImageData, vtkLight

# After _vtk, which sees to it that they can be loaded.
from .vtkGodRaysFilters import *
from .vtkGodRaysSources import *
from .vtkGodRaysRendering import *

from . import _arrays, _browser, _errors
from . import _properties as _property
from ._arrays import apply as apply
from ._arrays import scatter as scatter
from ._arrays import to_array as to_array
from ._arrays import to_image as to_image
from ._arrays import tone_map as tone_map
from ._errors import Error as Error
from ._errors import GodRaysWarning as GodRaysWarning
from ._errors import raising as raising
from ._errors import tell_names as _tell_names
from ._errors import to_numbers as _to_numbers
from ._measure import measure as measure
from ._migration import from_babylon as from_babylon
from ._migration import from_blender as from_blender
from ._migration import from_good_godrays as from_good_godrays
from ._migration import from_pmndrs as from_pmndrs
from ._migration import from_threejs as from_threejs
from ._migration import from_unity as from_unity
from ._migration import from_unreal as from_unreal
from ._parameters import MODELS as _MODELS
from ._parameters import add_model as _add_model
from ._parameters import find_names as _find_names
from ._parameters import find_settings as _find_settings
from ._parameters import forward as _forward
from ._parameters import get_names as _get_names
from ._parameters import make_model as _make_model
from ._properties import set_value as _set_value
from ._render import render as render
from ._render import show as show
from ._targets import find_angles as _find_angles
from ._targets import find_direction as _find_direction
from ._targets import find_renderer as _find_renderer
from ._targets import find_shining as _find_shining
from ._targets import is_closed as _is_closed
from ._targets import rebuild as _rebuild
from ._targets import refer as _refer
from ._targets import to_color as _to_color
from ._targets import to_lights as _to_lights
from ._targets import to_list as _to_list
from ._targets import to_prop as _to_prop
from ._turntable import turntable as turntable
from ._version import __version__ as __version__

if TYPE_CHECKING:
    import datetime
    from collections.abc import Sequence

    from ._typing import Lights, Model, Prop, Props, Role, Target

_ROLES = {
    "automatic": vtkGodRaysPass.AUTOMATIC,
    "occluder": vtkGodRaysPass.OCCLUDER,
    "light": vtkGodRaysPass.LIGHT,
    "ignored": vtkGodRaysPass.IGNORED,
    "medium": vtkGodRaysPass.MEDIUM,
}


def enable(
    target: Target,
    light: Lights | None = None,
    occluders: Props | None = (),
    ignored: Props | None = (),
    preset: str | None = None,
    sun_at: Sequence[float] | None = None,
    *,
    light_color: str | Sequence[float] | None = None,
    medium: Props | None = (),
    shadows: bool | None = None,
    ambient_occlusion: bool | None = None,
    # of the pass
    intensity: float | None = None,
    model: vtkGodRaysModel | Model | None = None,
    integrator: vtkGodRaysIntegrator | None = None,
    automatic_exposure: bool | None = None,
    highlight_shoulder: bool | None = None,
    darken_light_background: bool | None = None,
    data_first: bool | None = None,
    light_data: bool | None = None,
    surface_shadows: bool | None = None,
    soft_shadows: bool | None = None,
    most_data_shadow: float | None = None,
    most_data_lightness: float | None = None,
    error_tolerance: float | None = None,
    interactive_error_tolerance: float | None = None,
    untagged_props_occlude: bool | None = None,
    source_radius: float | None = None,
    sun: vtkGodRaysSun | Sequence[float] | None = None,
    sun_angular_radius: float | None = None,
    sun_placement: str | int | None = None,
    background_glow: float | None = None,
    background_glow_radius: float | None = None,
    background_glow_falloff: float | None = None,
    layer_margin: float | None = None,
    blend: str | int | None = None,
    display_transfer: str | int | None = None,
    output: str | int | None = None,
    precision: str | int | None = None,
    measure_times: bool | None = None,
    # of looks: "radial" and "published"
    density: float | None = None,
    decay: float | None = None,
    reach: float | None = None,
    streaks: float | None = None,
    weight: float | None = None,
    exposure: float | None = None,
    number_of_samples: int | None = None,
    formulation: str | int | None = None,
    clamp_maximum: float | None = None,
    # of media: "homogeneous", "atmosphere" and "volume"
    scattering_coefficient: Sequence[float] | None = None,
    absorption_coefficient: Sequence[float] | None = None,
    phase_function: str | int | None = None,
    asymmetry: float | None = None,
    second_phase_function: str | int | None = None,
    second_asymmetry: float | None = None,
    second_weight: float | None = None,
    visibility: float | None = None,
    optical_depth: float | None = None,
    attenuate_scene: bool | None = None,
    scattering_orders: str | int | None = None,
    far_limit: float | None = None,
    data_scale: float | None = None,
    data_albedo: Sequence[float] | None = None,
    data_phase_function: str | int | None = None,
    data_asymmetry: float | None = None,
    data_resolution: int | None = None,
    world_unit_in_meters: float | None = None,
    rayleigh_scattering: Sequence[float] | None = None,
    rayleigh_scale_height: float | None = None,
    mie_scattering: Sequence[float] | None = None,
    mie_absorption: Sequence[float] | None = None,
    mie_asymmetry: float | None = None,
    mie_scale_height: float | None = None,
    ground_level: float | None = None,
    planet_radius: float | None = None,
    up: Sequence[float] | None = None,
    # of integrators, and in the spelling of C++
    **parameters: Any,
) -> vtkGodRaysPass:
    """Put god rays into a scene and return their vtkGodRaysPass, attached to the renderer.

    target: a vtkRenderer, a vtkRenderWindow (its first renderer counts), a plotter with a
        ``renderer``, such as PyVista's and vedo's (that of the active subplot counts), or a render view
        of paraview.simple in built-in mode; representations and lights of ParaView can then be given
        as props and lights. Effects of a plotter can be put on before and after.
    light: what shines. A vtkLight; a prop, which shines in the colours in which it is drawn; three
        numbers, the direction from which sunlight comes, such as sun() gives; or a list of these. None
        takes the props tagged "light", or else the renderer's own lights that stand in the scene; if these
        cannot reach the picture, or there are none, a sun is placed behind it, where it makes the most
        shafts; it moves when its place becomes poor in another view, but for sun_placement="sun_once". The
        scene is lit as before. See vtkGodRaysPass.PlaceSun().
    light_color: the colour of the lights: a name of vtkNamedColors, "#rrggbb", or three numbers in [0, 1].
    occluders, ignored: props to tag. Props without a tag block light unless
        untagged_props_occlude=False.
    medium: volumes whose data scatter light, as smoke does, in place of being drawn by their mappers. They
        do so in the medium of the model or preset; where neither is given and the model is a look, alone,
        as by model="volume".
    shadows: a short name of surface_shadows; both given must be the same. Without rays, see shadows().
    ambient_occlusion: darken what is narrow, by VTK's vtkSSAOPass with a radius for the scene that is there;
        call enable() again when its size changes. VTK shows the first colour of a gradient behind it.
    preset: the name of a look or of a medium, see vtkGodRaysPresets.ListNames. It chooses the model that
        has it, unless one is given.
    sun_at: a place in the picture, from (0, 0) at its lower left to (1, 1), at which a sun is put with the
        camera as it is. Valid range: [-1, 2].
    sun: a light by two numbers, (azimuth clockwise from north, elevation) [degrees], as of sky(); without a
        sky, z is up and y is north. Or the vtkGodRaysSun whose angular radius the rays take.
    model: an object, or one of "radial", "published", "homogeneous", "atmosphere" and "volume".
    parameters: every other property of the pass, its model and its integrator; also in the spelling
        ``SunAngularRadius``.

    Constants can be given by name: output="occlusion". What is None stays as it is. Parameters come after the
    preset. Where a model's strength is given, exposure or weight, it is taken as it is, unless
    automatic_exposure=True.

    Enabling a renderer again changes the pass that it has; a light given then replaces the lights
    and the tagged props that shone before. ``with godrays.enable(renderer) as rays:`` takes the rays off at
    the end of the block. What a frame has to tell is a GodRaysWarning.

    TypeError: there is no such parameter of this model and integrator; ValueError: no such name; Error: a
    number is refused. Nothing is attached then.

    The parameters of the pass, of looks and of media, as C++ has them:
    """
    given = locals()
    keywords = enable.__kwdefaults__ or {}
    own = ("ambient_occlusion", "light_color", "medium", "shadows")
    parameters.update(
        {name: given[name] for name in keywords if name not in own and given[name] is not None})
    if shadows is not None:
        names = {name.replace("_", "").lower(): name for name in parameters}
        name = names.get("surfaceshadows", "surface_shadows")
        if parameters.setdefault(name, shadows) != shadows:
            raise ValueError(f"shadows={shadows} and {name}={parameters[name]} differ; give one of them")
    renderer = _find_renderer(target)
    rays = vtkGodRaysPass.Find(renderer)
    known = rays is not None
    rays = rays or vtkGodRaysPass()
    if sun is not None and not isinstance(sun, vtkGodRaysSun):
        if light is not None or sun_at is not None:
            raise ValueError("sun, light and sun_at each say where the light is; give one of them")
        light = _find_direction("sun", parameters.pop("sun"), renderer)

    # Look at everything before anything is changed.
    medium = [_to_prop(prop) for prop in _to_list(medium)]
    simple = {name.replace("_", "").lower() for name in parameters}
    if medium and preset is None and "model" not in simple and not rays.GetModel().IsA(
        "vtkGodRaysMediumModel"
    ):
        parameters = {**parameters, "model": "volume"}
    parameters = _add_model(rays, preset, parameters)
    others = (*own, "ignored", "light", "occluders", "preset", "sun_at")
    settings = _find_settings(rays, parameters, others)
    if getattr(rays, "_has_shadows_alone", False) and rays.GetIntensity() == 0:  # by shadows()
        settings.setdefault("Intensity", 1.0)
    lights = _to_lights(light)
    occluders = [_to_prop(prop) for prop in _to_list(occluders)]
    ignored = [_to_prop(prop) for prop in _to_list(ignored)]
    tagged = _find_shining(renderer)
    if sun_at is not None:
        meaning = "a place in the picture, such as (0.7, 0.8), from (0, 0) at its lower left to (1, 1)"
        sun_at = _to_numbers("sun_at", sun_at, (2,), meaning, (-1, 2))
    elif not lights and not tagged and rays.GetNumberOfLights() == 0:
        lights = [each for each in renderer.GetLights() if each.LightTypeIsSceneLight()]
        needed, placed = vtkGodRaysPass.SUN_IF_NO_LIGHT, vtkGodRaysPass.SUN_EVERY_VIEW
        settings.setdefault("SunPlacement", needed if lights else placed)

    if light_color is not None:
        light_color = _to_color("light_color", light_color)
        if not any(isinstance(each, vtkLight) for each in lights) and (lights or tagged):
            raise ValueError("light_color is for lights: props shine in the colours in which they are drawn")

    if known and (light is not None or sun_at is not None):
        rays.SetSunPlacement(vtkGodRaysPass.SUN_BY_HAND)
        rays.RemoveAllLights()
        for prop in tagged:
            tag(prop, "automatic")
    for each in lights:
        if isinstance(each, vtkLight):
            rays.AddLight(each)
        else:
            tag(each, "light")
    for prop in occluders:
        tag(prop, "occluder")
    for prop in ignored:
        tag(prop, "ignored")
    for prop in medium:
        tag(prop, "medium")

    for name in ("Model", "Integrator"):  # they hold what the others set
        if name in settings:
            getattr(rays, "Set" + name)(settings.pop(name))
    if preset is not None:
        rays.ApplyPreset(preset)
    owners = (rays, rays.GetModel(), rays.GetIntegrator())
    for name, value in settings.items():
        owner = next(owner for owner in owners if name in _get_names(owner))
        _set_value(owner, name, value)

    if sun_at is not None:
        rays.PlaceSun(renderer, *sun_at)
    if light_color is not None:
        if not rays.GetNumberOfLights():
            rays.PlaceSun(renderer)
        for each in map(rays.GetLight, range(rays.GetNumberOfLights())):
            each.SetDiffuseColor(light_color)
    if ambient_occlusion is not None:
        _occlude(renderer, ambient_occlusion)
    rays._has_shadows_alone = False
    return _attach(rays, renderer, target)


def _occlude(renderer: Any, on: bool) -> None:
    """Switch VTK's ambient occlusion, for a scene of this size, as the program has it."""
    bounds = renderer.ComputeVisiblePropBounds()
    diagonal = sum((high - low) ** 2 for low, high in zip(bounds[::2], bounds[1::2])) ** 0.5
    renderer.SetUseSSAO(on)
    if on and bounds[0] <= bounds[1]:
        renderer.SetSSAORadius(0.05 * diagonal)
        renderer.SetSSAOBias(0.002 * diagonal)
        renderer.SetSSAOBlur(True)


def _attach(rays: Any, renderer: Any, target: Any) -> vtkGodRaysPass:
    if vtkGodRaysPass.Find(renderer) is not rays:
        _errors.watch(rays)
        rays.Attach(renderer)
        _rebuild(renderer)
    if hasattr(target, "export_html"):
        _browser.watch(target)
    rays._target = _refer(target) or _refer(renderer)
    return rays


def shadows(
    target: Target,
    *,
    soft_shadows: bool | None = None,
    most_data_shadow: float | None = None,
    untagged_props_occlude: bool | None = None,
) -> vtkGodRaysPass:
    """Have lights cast shadows on surfaces, without rays, and return their vtkGodRaysPass.

    target: as of enable(). Rays that its renderer has stay, and their lights cast shadows, too.

    The pass is attached to the renderer. Without rays, the renderer's own lights cast shadows; headlights do
    not, and where there is no other light, a GodRaysWarning says what to do. enable() adds rays to the
    shadows; disable() takes both off. What is None stays as it is. Error: a number is refused.

    The parameters of the pass, as C++ has them:
    """
    renderer = _find_renderer(target)
    rays = vtkGodRaysPass.Find(renderer)
    if rays is None:
        rays = vtkGodRaysPass()
        rays.SetIntensity(0)
        rays._has_shadows_alone = True
    given = {
        "SoftShadows": soft_shadows, "MostDataShadow": most_data_shadow,
        "UntaggedPropsOcclude": untagged_props_occlude}
    for name, value in given.items():
        if value is not None:
            _set_value(rays, name, value)
    rays.SetSurfaceShadows(True)
    own = [each for each in renderer.GetLights() if each.GetSwitch() and not each.LightTypeIsHeadlight()]
    if not own and not rays.GetNumberOfLights() and rays.GetSunPlacement() == vtkGodRaysPass.SUN_BY_HAND:
        warnings.warn(
            "No light of the renderer casts shadows: headlights do not, and no other one is switched on. Add "
            "a vtkLight with SetLightTypeToSceneLight(), or rays with enable().",
            GodRaysWarning,
            stacklevel=2)
    return _attach(rays, renderer, target)


def sky(
    target: Target,
    sun: vtkGodRaysSun | Sequence[float] | None = None,
    light: vtkLight | None = None,
    atmosphere: vtkGodRaysAtmosphere | str | None = None,
    *,
    exposure: float | None = None,
    aerial_perspective: bool | None = None,
    surface_light: bool | None = None,
    multiple_scattering: bool | None = None,
    sun_disc: bool | None = None,
    white_balance: float | None = None,
    world_unit_in_meters: float | None = None,
    up: Sequence[float] | None = None,
    north: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
    display_transfer: str | int | None = None,
    **parameters: Any,
) -> vtkGodRaysSkyPass:
    """Put the physical sky behind a scene and return its vtkGodRaysSkyPass, attached to the renderer.

    target: as of enable(). God rays and sky can be put on in any order.
    sun: a vtkGodRaysSun; or where it stands, two numbers, (azimuth from north by east, elevation)
        [degrees], or three, the direction from which its light comes, such as sun() gives. None leaves it.
    light: a vtkLight that is given the sun's direction and colour, e.g. that of enable(). It is so once:
        call its UpdateLight() after a change of the sun.
    atmosphere: a vtkGodRaysAtmosphere, or the name of one, such as "earth-hazy"; see its LoadPreset().
    parameters: every other property of the pass; also in the spelling ``WorldUnitInMeters``.

    A renderer that has a sky keeps it, changed. vtkGodRaysSkyPass.Detach(renderer) takes it off. What is None
    stays as it is. Error: a number is refused.

    The parameters of the pass, as C++ has them:
    """
    given = locals()
    keywords = sky.__kwdefaults__ or {}
    parameters.update({name: given[name] for name in keywords if given[name] is not None})
    if isinstance(display_transfer, str):  # the constants are the pass's
        transfer = _property.constant(vtkGodRaysPass, "DisplayTransfer", display_transfer)
        parameters["display_transfer"] = transfer
    renderer = _find_renderer(target)
    own = {"Atmosphere", "Sun", "SunElevation", "SunAzimuth"}
    settings = _find_names(parameters, _get_names(vtkGodRaysSkyPass()) - own)
    if sun is not None and not isinstance(sun, vtkGodRaysSun):
        meaning = "a vtkGodRaysSun, (azimuth, elevation) or a direction (x, y, z)"
        sun = _to_numbers("sun", sun, (2, 3), meaning)
        if len(sun) == 3 and not any(sun):
            raise ValueError(f"sun={sun} should be {meaning}")
    if light is not None and not isinstance(light, vtkLight):
        raise TypeError(f"light should be a vtkLight, not {_name_type(light)}")
    if isinstance(atmosphere, str):
        name, atmosphere = atmosphere, vtkGodRaysAtmosphere()
        atmosphere.AddObserver("ErrorEvent", lambda *_: None)  # told as an exception
        if not atmosphere.LoadPreset(name):
            constants = [each.lower().replace("_", "-") for each in dir(atmosphere) if each.isupper()]
            listed = [each for each in constants if atmosphere.LoadPreset(each)]
            raise ValueError(f"there is no atmosphere {name!r}" + _tell_names(name, listed))

    found = vtkGodRaysSkyPass.Attach(renderer)
    for name, value in settings.items():
        _set_value(found, name, value)
    if atmosphere is not None:
        found.SetAtmosphere(atmosphere)
    if isinstance(sun, vtkGodRaysSun):
        found.SetSun(sun)
    elif sun is not None:
        angles = sun if len(sun) == 2 else _find_angles(sun, found.GetSun(), renderer)
        found.SetSunAzimuth(angles[0])
        found.SetSunElevation(angles[1])
    if light is not None:
        found.UpdateLight(light)
    return found


def disable(target: Target) -> None:
    """Take the god rays off a renderer, window or plotter; nothing happens if it has none.

    target: as of enable().

    ValueError: another pass was given them for its delegate by hand, and has to be given another one.
    """
    if _is_closed(target):
        return
    renderer = _find_renderer(target)
    rays = vtkGodRaysPass.Find(renderer)
    if rays is None:
        return
    rays.Detach(renderer)
    if not _rebuild(renderer) and vtkGodRaysPass.Find(renderer) is rays:
        raise ValueError(
            f"the god rays are a delegate of the renderer's {renderer.GetPass().GetClassName()}: "
            "take them out of it with SetDelegatePass()"
        )
    if hasattr(target, "export_html"):
        _browser.unwatch(target)


def presets() -> dict[str, str]:
    """The names of all looks and media, and what each is in a few words; see vtkGodRaysPresets."""
    table = vtkGodRaysPresets
    return {
        table.GetPresetName(i): table.GetPresetDescription(i) for i in range(table.GetNumberOfPresets())
    }


def tag(prop: Prop, role: Role | int) -> None:
    """Say what a prop does to light.

    prop: a vtkProp, such as a vtkActor, or what stands for one in vedo and ParaView.
    role: "occluder" blocks light, "light" shines, "ignored" does neither, "medium" scatters light, as a
        volume of smoke does; "automatic", the default, blocks light unless untagged_props_occlude=False.
        Or a constant of vtkGodRaysPass.

    TypeError: it is no prop; ValueError: there is no such role.
    """
    if isinstance(role, str):
        if role not in _ROLES:
            raise ValueError(f"there is no role {role!r}" + _tell_names(role, _ROLES))
        role = _ROLES[role]
    vtkGodRaysPass.SetRole(_to_prop(prop), role)


def sun(
    date: datetime.datetime | str,
    latitude: float,
    longitude: float,
    up: Sequence[float] = (0, 0, 1),
    north: Sequence[float] = (0, 1, 0),
) -> tuple[float, float, float]:
    """The direction of the sun at a time and place, as a light of enable().

    date: a datetime of the library with its time zone, or a text like 2024-06-21T19:30+02:00, whose zone is
        an offset from UTC, or Z for UTC.
    latitude, longitude: positive to the north and to the east [degrees].
    up, north: their directions in the scene. Defaults are those of a map.

    ValueError: there is no such date or place, its zone is not said, or the sun is below the horizon.
    """
    position = vtkGodRaysSunPosition()
    text = date.isoformat() if hasattr(date, "isoformat") else date
    position.AddObserver("ErrorEvent", lambda *_: None)  # told as exceptions
    numbers = isinstance(latitude, Real) and isinstance(longitude, Real)
    if not numbers or not abs(latitude) <= 90 or not abs(longitude) <= 180:
        raise ValueError(
            f"there is no place at latitude {latitude!r} and longitude {longitude!r}: they are in "
            "[-90, 90] and [-180, 180]"
        )
    if not isinstance(text, str) or not position.SetDateTime(text):
        raise ValueError(
            f"{text!r} is no date with a time from 1900 to 2100, such as 2024-06-21T19:30+02:00"
        )
    if not re.search("[Z+-]", text[text.find(":") :]):
        raise ValueError(f"{text!r} has no time zone: write {text}+02:00, two hours ahead of UTC, or {text}Z")
    position.SetLatitude(latitude)
    position.SetLongitude(longitude)
    direction = [0.0, 0.0, 0.0]
    if not position.GetDirection(up, north, direction):
        raise ValueError(f"up={up} and north={north} must be finite, not 0 and not parallel")
    if position.GetElevation() < 0:
        hours = f"rises at {position.GetSunrise():.2f} h and sets at {position.GetSunset():.2f} h"
        if position.GetDayType() == position.POLAR_NIGHT:
            hours = "does not rise on that day there"
        raise ValueError(
            f"the sun is {-position.GetElevation():.1f} degrees below the horizon at {text}; it {hours}")
    return direction[0], direction[1], direction[2]


def _enter(rays):
    """with godrays.enable(renderer) as rays: they are taken off at the end of the block."""
    if getattr(rays, "_target", None) is None:
        raise Error("the rays are on no renderer; write: with godrays.enable(renderer) as rays:")
    return rays


def _exit(rays, *_):
    target = rays._target() if rays._target else None
    rays._target = None
    if target is not None:
        disable(target)


def _layer(name):
    def get(rays):
        image = vtkImageData()
        return to_array(image) if getattr(rays, f"Get{name}Image")(image) else None

    return property(get, None, None, f"""The {name.lower()} layer of the last frame, a copy, for NumPy.

        float32 [row, column, channel] with red, green and blue, the top row first; None if the last frame
        had no rays. See Get{name}Image().""")


def _get_light(rays):
    """The first light of the rays, None if there is none; set, it is what `light` of enable() is.

    Default is none: enable() takes the renderer's, or a sun is placed.
    """
    return rays.GetLight(0)


def _put_light(rays, light):
    if light is None:
        rays.RemoveAllLights()
        rays.SetSunPlacement(rays.SUN_EVERY_VIEW)
    else:
        enable(_enter(rays)._target(), light)


def _get_preset(rays):
    """The preset that the model's parameters are, None if they are none; set, it is that of enable().

    Default is "default".
    """
    said = rays.GetModel().Describe()
    return next((name for name in presets() if vtkGodRaysPresets.NewModel(name).Describe() == said), None)


def _put_preset(rays, name):
    _add_model(rays, name, {})  # tells of a name that there is not
    rays.ApplyPreset(name)


def _represent(rays):
    plan = rays.GetPlan().strip().replace("\n", "; ") or "no frame yet"
    return (f"<{rays.GetClassName()}: {rays.preset or rays.GetModel().GetClassName()}, intensity "
        f"{rays.GetIntensity():g}, {rays.GetNumberOfLights()} lights; {plan}>")


def _model():
    """The property model of a pass, which takes the names that enable() takes, too."""
    own = vars(vtkGodRaysPass)["model"]
    return property(own.fget, lambda rays, model: own.fset(rays, _make_model(model)), None, own.__doc__)


_classes = [
    each
    for name, each in sorted(globals().items())
    if name.startswith("vtkGodRays") and isinstance(each, type)
]
_property.install(_classes)
for _name, _attribute in {
    "scattering": _layer("Scattering"),
    "occlusion": _layer("Occlusion"),
    "model": _model(),
    "light": property(_get_light, _put_light, None, _get_light.__doc__),
    "preset": property(_get_preset, _put_preset, None, _get_preset.__doc__),
    "__repr__": _represent,
    "__enter__": _enter,
    "__exit__": _exit,
}.items():
    _property.add(vtkGodRaysPass, _name, _attribute)
for _name in {_property.snake(each) for cls in _MODELS.values() for each in _get_names(cls())}:
    if not hasattr(vtkGodRaysPass, _name):
        _property.add(vtkGodRaysPass, _name, _forward(_name))
_arrays.document(enable, vtkGodRaysPass, *_MODELS.values())
_arrays.document(shadows, vtkGodRaysPass)
_arrays.document(sky, vtkGodRaysSkyPass)
if not TYPE_CHECKING:
    __all__ = [
        "Error", "GodRaysWarning", "apply", "disable", "enable", "from_babylon", "from_blender",
        "from_good_godrays", "from_pmndrs", "from_threejs", "from_unity", "from_unreal", "measure", "presets",
        "raising", "render", "scatter", "shadows", "show", "sky", "sun", "tag", "to_array", "to_image",
        "tone_map", "turntable",
        *(each.__name__ for each in _classes),
    ]

    def __dir__() -> list[str]:
        return [*__all__, "__all__", "__doc__", "__version__"]
