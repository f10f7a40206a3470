# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference of Python that the documentation site has, and the tests that a page names, are complete."""

import inspect
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Documentation"))
import godrays
import reference


class Reference(unittest.TestCase):
    def test_the_reference_has_each_name_and_the_meaning_of_each_keyword(self):
        sections = dict(re.findall(r"^### (\w+)\n(.*?)(?=^### |\Z)", reference.make(), re.M | re.S))
        self.assertEqual(set(sections), {name for name in godrays.__all__ if callable(getattr(godrays, name))})
        keywords = 0
        for name, section in sections.items():
            if not inspect.isfunction(getattr(godrays, name)):
                continue
            call, _, text = section.partition("\n```\n")
            for keyword in inspect.signature(getattr(godrays, name)).parameters:
                self.assertRegex(call, rf"[(* ]{keyword}[:,)]", name)
                self.assertRegex(text, rf"(?m)^- (`\w+`, )*`{keyword}`(, `\w+`)*: \S", name)
                keywords += 1
        self.assertGreater(keywords, 100)

    def test_the_reference_has_each_property_with_its_unit_and_default(self):
        sections = dict(re.findall(r"^### (\w+)\n(.*?)(?=^### |\Z)", reference.make(), re.M | re.S))
        classes = [getattr(godrays, name) for name in godrays.__all__ if inspect.isclass(getattr(godrays, name))]
        properties = numbers = 0
        for kind in classes:
            items = re.findall(r"(?m)^- ((?:`\w+`, )*`\w+`)(, read only)?: (\S.*)", sections[kind.__name__])
            found = {name: (text, not only) for names, only, text in items for name in re.findall(r"\w+", names)}
            own = {name: value for name, value in vars(kind).items() if isinstance(value, property)}
            self.assertEqual(set(found), set(own), kind)
            try:
                thing = kind()
            except (NotImplementedError, TypeError):  # abstract
                thing = None
            for name, (text, writable) in found.items():
                properties += 1
                self.assertEqual(writable, own[name].fset is not None, name)
                if writable and not name.endswith("output"):
                    self.assertIn("efault", text, f"{kind.__name__}.{name}")
                if writable and isinstance(getattr(thing, name, None), float):
                    numbers += 1
                    self.assertRegex(text, r"\\\[.+\\\]", f"{kind.__name__}.{name} without a unit")
        self.assertGreater(properties, 250)
        self.assertGreater(numbers, 60)
        intensity = re.search(r"(?m)^- `intensity`: .*", sections["vtkGodRaysPass"])[0]
        for part in (r"\[no unit\]", r"\[0, 1e4\]", "Default is 1."):
            self.assertIn(part, intensity)
        self.assertRegex(sections["vtkGodRaysPass"], r'(?m)^- `output`: .* By name: .*`"occlusion"`')

    def test_the_tests_of_the_viewers_table_are_there(self):
        page = (ROOT / "Documentation/Evidence/Viewer.md").read_text(encoding="utf-8")
        names = 0
        place = None
        for file, case, name in re.findall(r"`(?:(test_[a-z]+)\.([A-Z]\w+)\.)?(test_\w+)`", page):
            place = (file, case) if file else place
            text = (ROOT / f"Testing/CommandLine/{place[0]}.py").read_text(encoding="utf-8")
            of_case = text.partition(f"class {place[1]}(")[2].partition("\nclass ")[0]
            self.assertIn(f"def {name}(", of_case, place)
            names += 1
        self.assertGreater(names, 20)
        paths = re.findall(r"`(Testing/\S+\.py)`", page)
        self.assertGreater(len(paths), 1)
        for path in paths:
            self.assertTrue((ROOT / path).exists(), path)


if __name__ == "__main__":
    unittest.main()
