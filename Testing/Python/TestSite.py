# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documentation site is made of the pages, and every link and picture within it is there."""

import html.parser
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
import urllib.parse

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
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run(
                [sys.executable, "-m", "sphinx", "-q", "-c", str(ROOT / "Documentation"), "-d", f"{folder}/doctrees",
                    "-b", "html", str(ROOT), f"{folder}/site"],
                check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                env={**os.environ, "GODRAYS_SOURCES": "file:///sources"})
            print(result.stdout)
            self.assertEqual(result.returncode, 0)
            self.assertNotIn("target not found", result.stdout)
            self.assertNotIn("toctree contains reference to nonexisting", result.stdout)
            site = pathlib.Path(folder, "site").resolve()
            pages = {path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
            self.assertGreater(len(pages), 60)
            reference = (site / "Documentation/PythonReference.html").read_text(encoding="utf-8")
            for name in "enable(", "vtkGodRaysSmokeSource", "SetIntensity":
                self.assertIn(name, reference)
            dead, sources = [], 0
            for path, page in pages.items():
                for link in page.links:
                    url = urllib.parse.urlsplit(link)
                    if url.scheme == "file":
                        sources += 1
                        if not (ROOT / urllib.parse.unquote(url.path)[len("/sources/"):]).exists():
                            dead.append(f"{path.relative_to(site)}: {link}")
                        continue
                    if url.scheme or url.netloc:
                        continue
                    target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
                    if not target.exists():
                        dead.append(f"{path.relative_to(site)}: {link}")
                    elif url.fragment and target in pages and path.name not in ("search.html", "genindex.html"):
                        name = urllib.parse.unquote(url.fragment)
                        if name not in pages[target].names:
                            dead.append(f"{path.relative_to(site)}: {link}")
            print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {sources} to sources")
            self.assertEqual(dead, [])
            self.assertGreater(sources, 15)
            pictures = {link for page in pages.values() for link in page.links if link.endswith(".jpg")}
            self.assertGreater(len(pictures), 90)


if __name__ == "__main__":
    unittest.main()
