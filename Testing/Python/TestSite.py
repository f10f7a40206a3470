# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documentation site is made of the pages, and every link and picture within it is there.

Its notebooks draw what their scripts draw. In a browser, where there is one, no page is wider than a phone.
"""

import contextlib
import html.parser
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
import urllib.parse

import browser_testing
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
for needed in "sphinx", "myst_parser", "sphinx_rtd_theme":
    if importlib.util.find_spec(needed) is None:
        print(f"SKIPPED: there is no {needed}")
        sys.exit(77)


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.names = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.names.add(found.get("id"))
        target = found.get({"a": "href", "img": "src", "link": "href", "script": "src"}.get(tag))
        if target:
            self.links.append(target)


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.made = subprocess.run(
            [sys.executable, "-m", "sphinx", "-q", "-c", str(ROOT / "Documentation"), "-d", f"{folder}/doctrees",
                "-b", "html", str(ROOT), f"{folder}/site"],
            check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={**os.environ, "GODRAYS_SOURCES": "file:///sources"})
        cls.site = pathlib.Path(folder, "site").resolve()

    def test_links_to_sources_of_a_tree_in_any_folder(self):
        """Without GODRAYS_SOURCES they are URLs of files, so a blank and a letter beyond ASCII are encoded."""
        spec = importlib.util.spec_from_file_location("conf", ROOT / "Documentation" / "conf.py")
        conf = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(conf)
        context = {"body": f'<a href="{conf.PLACE}Testing">'}
        with unittest.mock.patch.dict(os.environ):
            os.environ.pop("GODRAYS_SOURCES", None)
            conf.name_sources(types.SimpleNamespace(srcdir="/a b/\u00fc/vtkGodRays"), "", "", context, None)
        self.assertEqual(context["body"], '<a href="file:///a%20b/%C3%BC/vtkGodRays/Testing">')

    def test_links(self):
        print(self.made.stdout)
        self.assertEqual(self.made.returncode, 0)
        self.assertNotIn("target not found", self.made.stdout)
        self.assertNotIn("toctree contains reference to nonexisting", self.made.stdout)
        pages = {path: Page(path.read_text(encoding="utf-8")) for path in self.site.rglob("*.html")}
        self.assertGreater(len(pages), 60)
        reference = (self.site / "Documentation/PythonReference.html").read_text(encoding="utf-8")
        for name in "enable(", "vtkGodRaysSmokeSource", "SetIntensity":
            self.assertIn(name, reference)
        dead, sources = [], 0
        for path, page in pages.items():
            for link in page.links:
                url = urllib.parse.urlsplit(link)
                if url.scheme == "file":
                    sources += 1
                    if not (ROOT / urllib.parse.unquote(url.path)[len("/sources/"):]).exists():
                        dead.append(f"{path.relative_to(self.site)}: {link}")
                    continue
                if url.scheme or url.netloc:
                    continue
                target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
                if not target.exists():
                    dead.append(f"{path.relative_to(self.site)}: {link}")
                elif url.fragment and target in pages and path.name not in ("search.html", "genindex.html"):
                    name = urllib.parse.unquote(url.fragment)
                    if name not in pages[target].names:
                        dead.append(f"{path.relative_to(self.site)}: {link}")
        print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {sources} to sources")
        self.assertEqual(dead, [])
        self.assertGreater(sources, 15)
        pictures = {link for page in pages.values() for link in page.links if link.endswith(".jpg")}
        self.assertGreater(len(pictures), 90)

    def run_notebook(self, path, folder):
        """Runs the code of a notebook in a folder, as Jupyter does."""
        code = [cell["source"] for cell in json.loads(path.read_text(encoding="utf-8"))["cells"][1:]]
        names = {"__name__": "__main__"}
        former = os.getcwd(), list(sys.argv), list(sys.path)
        os.chdir(folder)
        sys.path.insert(0, folder)
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                for cell in code[:-1]:
                    first, _, rest = cell.partition("\n")
                    if first.startswith("%%writefile "):
                        pathlib.Path(first.split()[1]).write_text(rest, encoding="utf-8")
                    else:
                        exec(compile(cell, path.name, "exec"), names)
                if "IPython" not in code[-1]:
                    exec(compile(code[-1], path.name, "exec"), names)
        finally:
            os.chdir(former[0])
            sys.argv[:], sys.path[:] = former[1:]

    def test_notebooks_are_those_of_scripts(self):
        """Each has all code of its script, in cells that compile, and five draw a picture that is not empty."""
        folder = self.site / "downloads"
        notebooks = sorted(folder.glob("*.ipynb"))
        self.assertGreater(len(notebooks), 45)
        for path in notebooks:
            with self.subTest(path.name):
                notebook = json.loads(path.read_text(encoding="utf-8"))
                self.assertEqual((notebook["nbformat"], notebook["cells"][0]["cell_type"]), (4, "markdown"))
                cells = [cell["source"] for cell in notebook["cells"][1:]]
                for cell in cells:
                    compile(re.sub(r"^%%.*", "", cell), path.name, "exec")
                script = path.with_suffix(".py").read_text(encoding="utf-8")
                missing = [word for word in re.sub(r"^(#.*\n)*\"\"\".*?\"\"\"", "", script, flags=re.S).split()
                    if word not in "".join(cells)]
                self.assertEqual(missing, [])
        for name in "MinimalSun", "city", "recipe-01", "recipe-02", "recipe-14":
            with self.subTest(name), tempfile.TemporaryDirectory() as place:
                self.run_notebook(folder / f"{name}.ipynb", place)
                reader = vtkPNGReader()
                reader.SetFileName(f"{place}/{name}.png")
                reader.Update()
                pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
                self.assertGreater(pixels.std(), 5)

    def test_pages_suit_a_phone(self):
        with browser_testing.open_phone() as phone, tempfile.TemporaryDirectory() as folder:
            wrong = pathlib.Path(folder, "wrong.html")  # the control
            wrong.write_text('<meta name="viewport" content="width=device-width"><img src="none.png"><pre>' + "w" * 99)
            self.assertEqual(len(browser_testing.find_faults(phone, wrong)), 2)
            faults = {str(page.relative_to(self.site)): browser_testing.find_faults(phone, page)
                for page in sorted(self.site.rglob("*.html"))}
            self.assertEqual({page: found for page, found in faults.items() if found}, {})


if __name__ == "__main__":
    unittest.main()
