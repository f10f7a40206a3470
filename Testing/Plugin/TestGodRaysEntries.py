# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The XML that CMake/write_entries.py writes from headers, and what it says where a header does not say enough."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIRE = "Filters/Sources/vtkGodRaysFireSource.h"
SOURCES = "Plugin/Views/GodRaysSources.xml.in"
NEW = """  ///@{
  /**
   * Set/Get how much of the fire SpawnRate leaves out [fraction]. vtkMath knows. Valid range: [0, 0.5].
   * Default is 0.25.
   */
  void SetNewPart(double part);
  vtkGetMacro(NewPart, double);
  ///@}

"""


class Entries(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name, "source")
        for part in ("Filters", "Rendering", "Plugin"):
            shutil.copytree(ROOT / part, self.root / part, ignore=shutil.ignore_patterns("*.cxx", "*.py", "*.glsl"))
        self.written = self.root / "written"
        self.written.mkdir()

    def write(self, classes=""):
        templates = sorted((self.root / "Plugin/Views").glob("*.xml.in"))
        return subprocess.run([sys.executable, ROOT / "CMake/write_entries.py", self.root, self.written, classes,
            *templates], capture_output=True, text=True)

    def change(self, name, old, new):
        text = (self.root / name).read_text(encoding="utf-8")
        self.assertEqual(text.count(old), 1, old)
        (self.root / name).write_text(text.replace(old, new), encoding="utf-8")

    def fails(self, message, classes=""):
        result = self.write(classes)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertRegex(result.stderr, message)

    def test_every_property_is_documented_in_words_of_users(self):
        result = self.write()
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(str(self.root / FIRE), result.stdout.splitlines())
        count = 0
        for path in self.written.glob("*.xml"):
            for element in ElementTree.parse(path).iter():
                self.assertNotIn(element.tag, ("Parameters", "Input", "Properties", "Proxies", "Texts"), path)
                if element.tag in ("IntRangeDomain", "IntVectorProperty"):
                    for each in ("min", "max", "default_values"):
                        self.assertRegex(element.get(each, ""), r"^(-?\d+( |$))*$")
                if element.tag.endswith("VectorProperty"):
                    count += 1
                    name, text = element.get("name"), " ".join(element.findtext("Documentation").split())
                    self.assertRegex(text, r"^[A-Z0-9].*\.$", name)
                    self.assertNotRegex(text, r"vtk[A-Z]|\w\(\)|::|\.h\b|[A-Z]_[A-Z]|Valid range", name)
        self.assertGreater(count, 180)

    def test_a_new_parameter_is_there_by_itself(self):
        before = "  ///@{\n  /**\n   * Set/Get how long particles live"
        self.change(FIRE, before, NEW + before)
        self.change(FIRE, "  double Lifetime = 1.2;", "  double Lifetime = 1.2;\n  double NewPart = 0.25;")
        self.assertEqual(self.write().stderr, "")
        found = ElementTree.parse(self.written / "GodRaysSources.xml").find(".//*[@name='NewPart']")
        self.assertEqual(found.attrib, {"name": "NewPart", "command": "SetNewPart", "number_of_elements": "1",
            "default_values": "0.25"})
        self.assertEqual(found.find("DoubleRangeDomain").attrib, {"name": "range", "min": "0", "max": "0.5"})
        self.assertEqual(found.findtext("Documentation"), "How much of the fire Spawn Rate leaves out [fraction].")

    def test_sliders_go_over_the_useful_range(self):
        self.assertEqual(self.write().stderr, "")
        for file, name, ends in (("GodRaysParts", "Intensity", ("0", "4")), ("GodRaysParts", "Exposure", ("0", "20")),
                ("GodRaysModels", "DataScale", ("0", "10"))):
            for found in ElementTree.parse(self.written / f"{file}.xml").findall(f".//*[@name='{name}']"):
                domain = found.find("DoubleRangeDomain")
                self.assertEqual((domain.get("min"), domain.get("max")), ends, name)
                self.assertNotIn("range", found.findtext("Documentation"))

    def test_what_a_header_does_not_say_is_an_error_with_place_and_remedy(self):
        for old, new, message in (
            ("Valid range: [0, 1e9]. Default is 1500.", "Default is 1500.",
                r"FireSource\.h:\d+: SetSpawnRate\(\) has no range .* Write \"Valid range"),
            ("Valid range: [0, 1e9]. Default is 1500.", "Valid range: [0, 1e9]. Default is 1600.",
                r"FireSource\.h:\d+: the default of SpawnRate is \[1600.0\] in the comment, .* Correct"),
            ("how many particles are born [1/s].", "what vtkMath::Random() says.",
                r"FireSource\.h:\d+: the first sentence about SpawnRate is not for users\. Name"),
            ("double SpawnRate = 1500.0;", "double SpawnRate;", ""),  # the comment has it, too
        ):
            with self.subTest(message):
                text = (self.root / FIRE).read_text(encoding="utf-8")
                self.change(FIRE, old, new)
                if message:
                    self.fails(message)
                else:
                    self.assertEqual(self.write().returncode, 0)
                (self.root / FIRE).write_text(text, encoding="utf-8")

    def test_templates_that_fit_no_header_are_errors(self):
        self.fails(r"vtkGodRaysHDRWriter\.h: vtkGodRaysHDRWriter is not in ParaView\. Write", "vtkGodRaysHDRWriter")
        self.change(SOURCES, "Fisheye; Cube Map", "Fisheye")
        self.fails(r"GodRaysSources\.xml\.in: .*MappingType has 4 constants, and 3 texts\. Write")
        self.change(SOURCES, "Equirectangular; Fisheye", "Equirectangular; Fisheye; Cube Map")
        self.change(SOURCES, "SunDisc MultipleScattering", "SunDisk MultipleScattering")
        self.fails(r"GodRaysSources\.xml\.in: vtkGodRaysSkySource has no SetSunDisk\(\) .* Write")


if __name__ == "__main__":
    unittest.main()
