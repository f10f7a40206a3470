# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The XML against the classes: each property is there, with the class's range and default."""

from plugin_testing import *

# What a class has, and ParaView has in another form: objects, and what is not a parameter.
ELSEWHERE = {
    # the view knows by itself how colours stand for light
    "vtkGodRaysPass": {
        "Model", "Integrator", "Role", "DelegatePass", "Compositor", "DisplayTransfer", "Sun",
        "SunPlacement"},  # fmt: skip
    # another form of its coefficients; what media by name have without a unit
    "vtkGodRaysHomogeneousModel": {"Visibility", "OpticalDepth"},
    "vtkGodRaysReferenceFilter": set(),
    "vtkGodRaysScatteringFilter": set(),
    "vtkGodRaysAtmosphereModel": {"Atmosphere"},
    "vtkGodRaysSkySource": {"Atmosphere", "Sun"},
    # a group of the view's own has the sun; one unit is for the sky and for media
    "vtkGodRaysSkyPass": {
        "Atmosphere", "Sun", "SunElevation", "SunAzimuth", "Up", "North", "WorldUnitInMeters",
        "Compositor", "DelegatePass", "DisplayTransfer"},  # fmt: skip
    "vtkGodRaysSun": {"Ephemeris"},
    "vtkGodRaysVisibilityFilter": {"CameraFocalPoint", "CameraViewUp"},  # which it does not read
    "vtkGodRaysSunPosition": {"DateTime", "Height", "Pressure", "Temperature"},
}

# What is no filter or source, but writes a file.
NOT_OFFERED = {"vtkGodRaysEXRWriter", "vtkGodRaysHDRWriter"}


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


def is_abstract(vtk_class):
    try:
        vtk_class()
    except (NotImplementedError, TypeError):
        return True
    return False


def choices(view, name):
    """What a list of the view offers: names in the XML, and labels."""
    domain = view.SMProxy.GetProperty(name).FindDomain("vtkSMProxyListDomain")
    names = [domain.GetProxyName(i) for i in range(domain.GetNumberOfProxyTypes())]
    return list(zip(names, view.GetProperty(name).Available))


class Properties(Case):
    def check(self, proxy, vtk_object, prefix=""):
        """Each parameter of the object is a property of the proxy, after a prefix, and follows it."""
        names = parameters(vtk_object)
        self.assertGreater(len(names), 0)
        for name in sorted(names):
            with self.subTest(f"{vtk_object.GetClassName()}.{name}"):
                self.check_parameter(proxy, vtk_object, name, prefix)

    def check_parameter(self, proxy, vtk_object, name, prefix):
        prop = proxy.SMProxy.GetProperty(prefix + name)
        self.assertIsNotNone(prop, "not in the XML")
        label = prop.GetXMLLabel().replace(" ", "")
        self.assertEqual(label, prefix + name, "Python has another name")
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

        if isinstance(fresh, str):
            push("other")
            self.assertEqual(get(), "other")
            push(fresh)
            return
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
            if count == 3 and name in ("Up", "North"):  # a direction
                push((0.0, 3.0, 4.0))
                self.assertEqual(get(), (0.0, 3.0, 4.0))
                push(default)
                return
            self.assertIsNotNone(domain, "no range")
            low, high = domain.GetMinimum(0), domain.GetMaximum(0)
            for end, beyond in ((low, -1), (high, 1)):
                value = end if count == 1 else (end,) * count
                push(value)
                self.assertEqual(get(), value, "the class does not take the end of the range")
                if name.endswith("Azimuth"):
                    continue  # any number is one
                step = max(1.0, abs(end)) * beyond
                further = end + (step if isinstance(end, float) else int(step))
                if isinstance(end, int) and abs(further) >= 2**31:
                    continue  # the end of all integers
                setter = getattr(vtk_object, "Set" + name)
                setter(*([further] * count))
                if beyond > 0 and "Useful range" in " ".join(setter.__doc__.split()):
                    self.assertEqual(get(), further)  # sliders end before the class does
                elif get() != value:  # a filter that tells what it cannot use when it executes
                    with Messages() as messages:
                        vtk_object.Update()
                    self.assertIn("Cannot", messages.text, "the class's range goes on")
        push(default)
        self.assertEqual(shown(), default)

    def test_view(self):
        view = make_view()
        sun = rays(view).GetSun()
        self.check(view, rays(view))
        self.check(view, view.GetClientSideObject().GetSkyPass(), "Sky")
        self.check(view, sun, "Sun")
        self.check(view, sun.GetEphemeris(), "Sun")

    def test_models_and_integrators(self):
        view = make_view(Preset="custom")
        for prop in ("Model", "Integrator"):
            for name, label in choices(view, prop):
                view.Model = "Radial"
                setattr(view, prop, label)
                chosen = getattr(view, prop)
                vtk_object = chosen.GetClientSideObject()
                self.assertEqual(vtk_object.GetClassName(), f"vtkGodRays{name}{prop}")
                self.check(chosen, vtk_object)
        self.assertEqual(choices(make_view(), "Model")[0][0], "Radial")

    def test_every_choice_can_be_drawn(self):
        view = make_view(Preset="custom")
        add_pillars(view)
        for _, model in choices(view, "Model"):
            for _, integrator in choices(view, "Integrator"):
                view.Model, view.Integrator = model, integrator
                with Messages() as messages:
                    simple.Render(view)
                self.assertNotIn("cannot evaluate", messages.text, (model, integrator))
                self.assertEqual(
                    rays(view).GetModel(), view.Model.GetClientSideObject(), (model, integrator)
                )

    def test_lists_hold_every_class(self):
        view = make_view()
        for prop in ("Model", "Integrator"):
            classes = {
                name
                for name in dir(godrays)
                if name.startswith("vtkGodRays") and name.endswith(prop)
                and not is_abstract(getattr(godrays, name))
            }  # fmt: skip
            available = {f"vtkGodRays{name}{prop}" for name, _ in choices(view, prop)}
            self.assertEqual(available, classes)

    def test_filters_and_sources(self):
        """Each class is in the menu God Rays, and follows its properties."""
        manager = simple.servermanager.ProxyManager()
        pipeline = [
            each()
            for name, each in vars(godrays).items()
            if isinstance(each, type)
            and issubclass(each, vtk.vtkAlgorithm)
            and not is_abstract(each)
            and name not in NOT_OFFERED
        ]
        data = {
            "vtkImageData": simple.Wavelet(WholeExtent=[0, 7, 0, 7, 0, 0]),
            "vtkPointSet": simple.Sphere(),
            "vtkPolyData": simple.Sphere(),
        }
        for group in ("filters", "sources"):
            classes = {
                each.GetClassName(): each
                for each in pipeline
                if (each.GetNumberOfInputPorts() > 0) == (group == "filters")
            }
            offered = set()
            for entry in manager.NewDefinitionIterator(group):
                name = entry["xml"].GetAttribute("class")
                if name and name.startswith("vtkGodRays"):
                    offered.add(name)
                    label = entry["xml"].GetAttribute("label")
                    inputs = {}
                    if group == "filters":
                        port = classes[name].GetInputPortInformation(0)
                        kind = port.Get(vtk.vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE())
                        inputs["Input"] = data[kind]
                    proxy = getattr(simple, label.replace(" ", ""))(**inputs)
                    self.check(proxy, proxy.GetClientSideObject())
                    hints = proxy.SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
                    # references, to check others with, are where ParaView puts all: in the alphabet
                    category = None if "Reference" in name else "God Rays"
                    self.assertEqual(hints.GetAttribute("category"), category)
            self.assertEqual(offered, set(classes))

    def test_presets(self):
        view = make_view(WorldUnitInMeters=3.0)
        offered = ["custom"]
        presets = godrays.vtkGodRaysPresets
        for i in range(presets.GetNumberOfPresets()):
            name = presets.GetPresetName(i)
            offered.append(name)
            view.Preset = name
            expected = presets.NewModel(name)
            self.assertEqual(rays(view).GetModel().GetClassName(), expected.GetClassName())
            if hasattr(expected, "SetWorldUnitInMeters"):
                expected.SetWorldUnitInMeters(3.0)
            for each in parameters(expected):
                actual = getattr(rays(view).GetModel(), "Get" + each)()
                self.assertEqual(actual, getattr(expected, "Get" + each)(), f"{name}: {each}")
        self.assertEqual(list(view.GetProperty("Preset").Available), offered)

    def test_what_the_view_adds(self):
        view = make_view()
        self.assertEqual(
            (view.SunAzimuth, view.SunElevation, view.SunFrame, view.LightSource),
            (0.0, 10.0, "Camera", "Sun"),
        )
        for wrong in (-1, 5):
            with Messages() as messages:
                view.GetClientSideObject().SetLightSource(wrong)
            self.assertIn("stays", messages.text)

    def test_parts_of_the_view(self):
        """They are shared, each view has its own, and what is set in one is seen in the next frame."""
        views = [make_view(UseSky=1), make_view(UseSky=1)]
        suns = [view.GetClientSideObject().GetSun() for view in views]
        self.assertIsNot(*suns)
        for view, sun in zip(views, suns):
            self.assertIs(rays(view).GetSun(), sun)
            self.assertIs(view.GetClientSideObject().GetSkyPass().GetSun(), sun)
        before = [pixels(view) for view in views]
        for name, value in {
            "SunElevation": 25.0,
            "SkyExposure": 1.0,
            "SkyAtmosphere": "Earth, polluted",
            "Output": "Scattering",
        }.items():
            setattr(views[0], name, value)
            after = pixels(views[0])
            self.assert_different(after, before[0], 5)
            before[0] = after
        self.assert_alike(pixels(views[1]), before[1])

    def test_sun_position(self):
        view = make_view()
        sun = godrays.vtkGodRaysSunPosition()
        self.assertEqual(list(view.SunDate), [sun.GetYear(), sun.GetMonth(), sun.GetDay()])
        with Messages() as messages:
            view.SunDate = [2001, 2, 29]
        self.assertIn("2001-2-29", messages.text)

    def test_role(self):
        shown = add_pillars(make_view())
        domain = shown.SMProxy.GetProperty("GodRaysRole").FindDomain("vtkSMEnumerationDomain")
        roles = {
            domain.GetEntryText(i).upper(): domain.GetEntryValue(i)
            for i in range(domain.GetNumberOfEntries())
        }
        for name, value in roles.items():
            self.assertEqual(getattr(godrays.vtkGodRaysPass, name), value)
        self.assertEqual(len(roles), 5)
        for wrong in (-1, 5):
            with Messages() as messages:
                shown.SMProxy.GetProperty("GodRaysRole").SetElement(0, wrong)
                shown.SMProxy.UpdateVTKObjects()
            self.assertEqual(messages.text.count("stays as it was"), 1, messages.text)
            with Messages() as messages:
                simple.Render()
            self.assertEqual(messages.text, "")


main()
