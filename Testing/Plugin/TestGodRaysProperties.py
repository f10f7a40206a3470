# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The XML against the classes: each property is there, with the class's range and default."""

import math

from plugin_testing import *

# What a class has, and ParaView has in another form: objects, and what is not a parameter.
ELSEWHERE = {
    "vtkGodRaysPass": {"Model", "Integrator", "Role", "DelegatePass", "Compositor"},
    "vtkGodRaysReferenceFilter": set(),
    "vtkGodRaysScatteringFilter": set(),
}

# Base classes, and what needs a camera, which a pipeline in ParaView has not.
NOT_OFFERED = {"vtkGodRaysRadialFilter", "vtkGodRaysMediumFilter", "vtkGodRaysCoverageFilter"}


def parameters(vtk_object):
    """The names of an object's own parameters, those of VTK's base classes left out."""
    bases = {
        name
        for base in type(vtk_object).__mro__
        if not base.__module__.startswith("godrays")
        for name in vars(base)
    }
    names = set(dir(vtk_object)) - bases
    return {
        name[3:]
        for name in names
        if name.startswith("Set") and "Get" + name[3:] in names
    } - ELSEWHERE.get(vtk_object.GetClassName(), set())


def constants(vtk_object, name):
    """The constants of an enumeration, found by trying; for parameters of few whole numbers."""
    setter, getter = getattr(vtk_object, "Set" + name), getattr(vtk_object, "Get" + name)
    default = getter()
    taken = set()
    with Messages():  # those that are refused
        for value in range(-2, 20):
            setter(value)
            if getter() == value:
                taken.add(value)
    setter(default)
    return taken


class Properties(Case):
    def check(self, proxy, vtk_object):
        """Each parameter of the object is a property of the proxy, and follows it."""
        names = parameters(vtk_object)
        self.assertGreater(len(names), 0)
        for name in sorted(names):
            with self.subTest(f"{vtk_object.GetClassName()}.{name}"):
                self.check_parameter(proxy, vtk_object, name)

    def check_parameter(self, proxy, vtk_object, name):
        prop = proxy.SMProxy.GetProperty(name)
        self.assertIsNotNone(prop, "not in the XML")
        self.assertTrue(prop.GetDocumentation().GetDescription().strip(), "no documentation")

        get = getattr(vtk_object, "Get" + name)
        fresh = getattr(type(vtk_object)(), "Get" + name)()
        count = prop.GetNumberOfElements()

        def shown():
            value = [prop.GetElement(i) for i in range(count)]
            return value[0] if count == 1 else tuple(value)

        def push(value):
            for i in range(count):
                prop.SetElement(i, value if count == 1 else value[i])
            proxy.SMProxy.UpdateVTKObjects()

        if isinstance(fresh, tuple):
            for a, b in zip(shown(), fresh):
                self.assertAlmostEqual(a, b, 14)
        else:
            self.assertAlmostEqual(shown(), fresh, 14, "another default")

        domain = prop.FindDomain("vtkSMDoubleRangeDomain") or prop.FindDomain("vtkSMIntRangeDomain")
        enumeration = prop.FindDomain("vtkSMEnumerationDomain")
        boolean = prop.FindDomain("vtkSMBooleanDomain")
        default = shown()
        if boolean:
            push(1 - default)
            self.assertEqual(get(), not default)
        elif enumeration:
            entries = {
                enumeration.GetEntryValue(i) for i in range(enumeration.GetNumberOfEntries())
            }
            self.assertEqual(entries, constants(vtk_object, name))
            for value in entries:
                push(value)
                self.assertEqual(get(), value)
        else:
            self.assertIsNotNone(domain, "no range")
            low, high = domain.GetMinimum(0), domain.GetMaximum(0)
            for end, beyond in ((low, -1), (high, 1)):
                value = end if count == 1 else (end,) * count
                push(value)
                self.assertEqual(get(), value, "the class does not take the end of the range")
                step = max(1.0, abs(end)) * beyond
                further = end + (step if isinstance(end, float) else int(step))
                getattr(vtk_object, "Set" + name)(*([further] * count))
                self.assertEqual(get(), value, "the class's range goes on")
        push(default)
        self.assertEqual(shown(), default)

    def test_view(self):
        view = make_view()
        self.check(view, rays(view))

    def test_model(self):
        view = make_view(Preset="custom")
        self.check(view.Model, rays(view).GetModel())
        self.assertEqual(rays(view).GetModel().GetClassName(), "vtkGodRaysRadialModel")

    def test_integrator(self):
        view = make_view()
        for name in view.GetProperty("Integrator").Available:
            view.Integrator = name
            integrator = rays(view).GetIntegrator()
            self.assertEqual(integrator.GetClassName(), f"vtkGodRays{name}Integrator")
            self.check(view.Integrator, integrator)

    def test_lists_hold_every_class(self):
        view = make_view()
        for prop, kind in (("Model", "Model"), ("Integrator", "Integrator")):
            classes = {
                name
                for name in dir(godrays)
                if name.startswith("vtkGodRays")
                and name.endswith(kind)
                and name != "vtkGodRays" + kind
            }
            available = {
                f"vtkGodRays{name}{kind}" for name in view.GetProperty(prop).Available
            }
            self.assertEqual(available, classes)

    def test_filters(self):
        classes = {
            name
            for name in dir(godrays)
            if name.startswith("vtkGodRays")
            and name.endswith("Filter")
            and name not in NOT_OFFERED
        }
        self.assertGreaterEqual(len(classes), 2)
        for name in sorted(classes):
            image = simple.Wavelet(WholeExtent=[0, 7, 0, 7, 0, 0])
            proxy = getattr(simple, name[3:])(Input=image)
            self.check(proxy, proxy.GetClientSideObject())
            hints = proxy.SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(hints.GetAttribute("category"), "God Rays")

    def test_presets(self):
        model = godrays.vtkGodRaysRadialModel
        names = [model.GetPresetName(i) for i in range(model.GetNumberOfPresets())]
        view = make_view()
        self.assertEqual(list(view.GetProperty("Preset").Available), ["custom"] + names)
        for name in names:
            view.Preset = name
            expected = model()
            expected.ApplyPreset(name)
            for each in parameters(expected):
                actual = getattr(rays(view).GetModel(), "Get" + each)()
                self.assertEqual(actual, getattr(expected, "Get" + each)(), f"{name}: {each}")

    def test_what_the_view_adds(self):
        view = make_view()
        self.assertEqual(
            (view.SunAzimuth, view.SunElevation, view.SunFrame, view.LightSource),
            (0.0, 10.0, "Camera", "Sun"),
        )
        client = view.GetClientSideObject()
        for setter in (client.SetSunAzimuth, client.SetSunElevation):
            for wrong in (math.nan, math.inf):
                with Messages() as messages:
                    setter(wrong)
                self.assertIn("stays", messages.text)
        for setter in (client.SetLightSource, client.SetSunFrame):
            for wrong in (-1, 4):
                with Messages() as messages:
                    setter(wrong)
                self.assertIn("stays", messages.text)

    def test_role(self):
        view = make_view()
        shown = add_pillars(view)[0]
        shown.Representation = "Surface (God Rays)"
        domain = shown.SMProxy.GetProperty("Role").FindDomain("vtkSMEnumerationDomain")
        roles = {
            domain.GetEntryText(i).upper(): domain.GetEntryValue(i)
            for i in range(domain.GetNumberOfEntries())
        }
        for name, value in roles.items():
            self.assertEqual(getattr(godrays.vtkGodRaysPass, name), value)
        self.assertEqual(len(roles), 4)


main()
