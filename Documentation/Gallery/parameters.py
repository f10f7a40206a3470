# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of parameters: what each is, in the words of its header, and a strip of pictures from low to high.

Usage: parameters.py <folder>

Writes Parameters.md and Parameters/*.jpg there. The scenes are those of the cookbook.
"""

import pathlib
import re
import sys
import textwrap

import godrays
import numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = (200, 150)
LOOK = {"light": (-0.5, 0.87, -0.14)}
SHADOWS = {"light": (-0.7, -0.4, 0.8), "intensity": 0, "shadows": True}
HALL = {"preset": "dust", "light": (-0.5, 1, 0.5), "intensity": 4}

# heading, the class that has it, its parameters: name, pictures' values, what else they have
SECTIONS = (
    ("Looks", godrays.vtkGodRaysRadialModel, LOOK, (
        ("density", (0.2, 0.5, 0.8, 1.0, 1.5), {}),
        ("decay", (0.9, 0.95, 0.98, 0.99, 1.0), {}),
        ("weight", (0.005, 0.01, 0.02, 0.04, 0.08), {}),
        ("exposure", (0.1, 0.2, 0.4, 0.8, 1.6), {}),
        ("reach", (0.2, 0.4, 0.75, 1.5, 4.0), {}),
        ("streaks", (0.0, 0.1, 0.22, 0.35, 0.5), {}),
    )),
    ("How strong, how large", godrays.vtkGodRaysPass, LOOK, (
        ("intensity", (0.1, 0.3, 1.0, 2.0, 4.0), {}),
        ("most_data_lightness", (1, 3, 10, 20, 40), {"data_first": True, "intensity": 4}),
        ("source_radius", (0.02, 0.05, 0.1, 0.2, 0.4), {"light": "lamp"}),
        ("background_glow", (0.0, 0.1, 0.2, 0.4, 0.8), {"automatic_exposure": False}),
        ("background_glow_radius", (1, 3, 6, 12, 24), {}),
        ("background_glow_falloff", (2, 5, 10, 20, 40), {}),
    )),
    ("Shadows on surfaces", godrays.vtkGodRaysPass, SHADOWS, (
        ("sun_angular_radius", (0.25, 1, 2, 4, 8), {"most_data_shadow": 1}),
        ("most_data_shadow", (0.0, 0.25, 0.5, 0.75, 1.0), {}),
    )),
    ("Media", godrays.vtkGodRaysHomogeneousModel, HALL, (
        ("optical_depth", (0.05, 0.1, 0.3, 0.6, 1.2), {"automatic_exposure": False}),
        ("visibility", (10, 20, 40, 80, 160), {"world_unit_in_meters": 4}),
        ("scattering_coefficient", ((0.002,) * 3, (0.01,) * 3, (0.03,) * 3, (0.03, 0.02, 0.01), (0.01, 0.02, 0.03)),
            {"world_unit_in_meters": 4}),
        ("absorption_coefficient", ((0.0,) * 3, (0.02,) * 3, (0.06,) * 3, (0.06, 0.03, 0.0), (0.0, 0.03, 0.06)),
            {"world_unit_in_meters": 4, "scattering_coefficient": (0.02,) * 3}),
        ("asymmetry", (-0.6, 0.0, 0.4, 0.7, 0.9), {"automatic_exposure": False}),
        ("second_weight", (0.0, 0.25, 0.5, 0.75, 1.0), {"automatic_exposure": False, "asymmetry": 0.85}),
    )),
    ("Media whose density falls with height", godrays.vtkGodRaysAtmosphereModel, HALL, (
        ("mie_scattering", ((0.003,) * 3, (0.01,) * 3, (0.03,) * 3, (0.03, 0.02, 0.01), (0.01, 0.02, 0.03)), {}),
        ("mie_scale_height", (0.5, 1, 2, 4, 16), {"mie_scattering": (0.03,) * 3}),
        ("mie_asymmetry", (-0.6, 0.0, 0.4, 0.7, 0.9),
            {"automatic_exposure": False, "mie_scattering": (0.02,) * 3}),
        ("ground_level", (-2, -1, 0, 1, 2), {"mie_scattering": (0.01,) * 3, "mie_scale_height": 4}),
    )),
)


def describe(cls, name):
    """What the header of a class, or of one of its bases, says of a setter."""
    for each in cls.__mro__:
        for header in ROOT.glob(f"Rendering/**/{each.__name__}.h"):
            text = header.read_text(encoding="utf-8")
            for words, code in re.findall(r"/\*\*\n(.*?)\*/\n(.*?)(?=\n *///|\n *\n)", text, re.S):
                if re.search(rf"\bSet{name}\(|Macro\({name},", code):
                    return re.sub(r"^ *\* ?", "", words, flags=re.M)
    raise LookupError(f"no header has Set{name}()")


def cookbook_scene():
    """The names that the first code block of the cookbook defines."""
    names = {}
    text = (ROOT / "Documentation" / "Cookbook.md").read_text(encoding="utf-8")
    exec(compile(re.search(r"```python\n(.*?)```", text, re.S)[1], "Cookbook.md", "exec"), names)
    lamp = names["vtk"].vtkLight()
    lamp.SetPositional(True)
    lamp.SetPosition(-0.25, 0.3, 0.1)
    names["lamp"] = lamp
    slope = names["vtk"].vtkPlaneSource()  # coloured by its heights
    slope.SetOrigin(-3, -3, -1)
    slope.SetPoint1(3, -3, -1)
    slope.SetPoint2(-3, 4, -0.3)
    slope.SetResolution(40, 40)
    above = names["vtk"].vtkCamera()
    above.SetPosition(0.6, -2.6, 1.7)
    above.SetFocalPoint(0.25, 0.1, -0.2)
    above.SetViewUp(0, 0, 1)
    names.update(slope=names["actor"](slope), above=above)
    return names


def picture(scene, cls, base, name, value, more, size=SIZE):
    settings = {**base, **more, name: value}
    if settings.get("light") == "lamp":
        settings["light"] = scene["lamp"]
    if cls is godrays.vtkGodRaysAtmosphereModel:
        del settings["preset"]
        settings = {"model": "atmosphere", "rayleigh_scattering": (0,) * 3, "mie_absorption": (0,) * 3,
            "ground_level": -0.6, "mie_scale_height": 20, "world_unit_in_meters": 4, **settings}
    if base is HALL:
        data, settings["camera"] = [*scene["hall"], scene["shell"]], scene["inside"]
        settings["background"] = "#8fa6bd"
    elif base is SHADOWS:
        data, settings["camera"] = [scene["shell"], scene["slope"]], scene["above"]
    else:
        data = scene["shell"]
    return numpy.asarray(godrays.render(data, size, **settings))


def shown(value):
    return "(" + ", ".join(f"{each:g}" for each in value) + ")" if isinstance(value, tuple) else f"{value:g}"


def make_page():
    """The text of the page: the words are those of the headers."""
    def fill(text):
        return textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False)

    parts = ["# Parameters", fill(
        "What each parameter does, from low to high, in the words of its header. The strips are of the scenes of the "
        "[cookbook](Cookbook.md). `Documentation/Gallery/parameters.py` writes this page whole. The same words are a "
        "keyword of `godrays.enable()`, a property in Python, a setter in C++, and a line of ParaView's panel: "
        "`most_data_lightness`, `SetMostDataLightness()`, Most Data Lightness.")]
    for heading, cls, _, parameters in SECTIONS:
        parts += [f"## {heading}", f"Of `{cls.__name__}`."]
        for name, values, more in parameters:
            words = " ".join(describe(cls, "".join(part.capitalize() for part in name.split("_"))).split())
            words = re.sub(r"^Set/Get ", "", words)
            words = (words[:1].upper() + words[1:]).replace("<", "&lt;").replace("*", "\\*")
            others = [f"{key} {each if isinstance(each, (str, bool)) else shown(each)}" for key, each in more.items()]
            parts += [f"### {name}", fill(words), f"![](Parameters/{name}.jpg)",
                fill(" · ".join(map(shown, values)) + (f"; with {', '.join(others)}" if others else ""))]
    return "\n\n".join(parts) + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    (folder / "Parameters").mkdir(exist_ok=True)
    (folder / "Parameters.md").write_text(make_page(), encoding="utf-8")
    scene = cookbook_scene()
    for _, cls, base, parameters in SECTIONS:
        for name, values, more in parameters:
            strip = numpy.concatenate([picture(scene, cls, base, name, value, more) for value in values], axis=1)
            writer = vtkJPEGWriter()
            writer.SetQuality(82)
            writer.SetInputData(godrays.to_image(numpy.ascontiguousarray(strip)))
            writer.SetFileName(str(folder / "Parameters" / f"{name}.jpg"))
            writer.Write()
            print(name, [f"{each.mean():.0f}" for each in numpy.split(strip, 5, axis=1)], flush=True)


if __name__ == "__main__":
    main()
