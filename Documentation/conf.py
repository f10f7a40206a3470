# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's configuration of the documentation site: the pages of the tree as they are, without a copy.

    cmake --build build --target documentation     # build/documentation/index.html

The source folder is that of the project, as pages link to each other across folders. Links to what is no page go
to the sources: GODRAYS_SOURCES in the environment says where these are shown; else they are files of this tree.
"""

import os
import pathlib
import re
import sys

sys.path.insert(0, os.path.dirname(__file__))
import reference  # beside this file
import scripts

project = "vtkGodRays"
author = copyright = "the vtkGodRays authors"
extensions = ["myst_parser"]
root_doc = "Documentation/index"
include_patterns = ["*.md", "Documentation/**.md", "Examples/**.md", "Plugin/**.md"]
exclude_patterns = ["build*", "Testing", "Documentation/Paper"]
myst_heading_anchors = 4
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2, "collapse_navigation": False}
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_title = "vtkGodRays"
suppress_warnings = ["myst.header", "toc.not_included"]


PLACE = "https://sources.invalid/"  # Markdown takes no file:// for a link


def link_sources(app, docname, source):
    """Links to what is no page, such as headers and folders, go to where the sources are shown."""
    here = os.path.dirname(docname)

    def replace(found):
        target, _, heading = found[2].partition("#")
        path = os.path.normpath(os.path.join(here, target))
        is_page = path.endswith(".md") and os.path.exists(os.path.join(app.srcdir, path))
        is_picture = re.search(r"\.(png|jpe?g)$", path)
        if not target or re.match(r"[a-z]+:", found[2]) or is_page or is_picture:
            return found[0]
        index = os.path.join(path, "README.md")
        if os.path.exists(os.path.join(app.srcdir, index)):
            return f"{found[1]}{os.path.relpath(index, here)}{'#' + heading if heading else ''})"
        return f"{found[1]}{PLACE}{path}{'#' + heading if heading else ''})"

    source[0] = re.sub(r"(\]\()([^)\s]+)\)", replace, source[0])


def add_made(app, docname, source):
    """Pages that end with what is made: the Python reference, from the docstrings of the module, and scripts."""
    here = os.path.dirname(docname)
    if docname == "Documentation/PythonReference":
        source[0] += "\n" + reference.make()
    elif docname == "Documentation/Gallery/Scripts":
        source[0] += "\n" + scripts.make_gallery(here)
    elif docname == "Documentation/Cookbook":
        source[0] = scripts.link_recipes(source[0], here)
    elif docname == "Documentation/index" and "GODRAYS_API" in os.environ:
        source[0] = source[0].replace("`api/index.html`", '<a href="../api/index.html">the reference of C++</a>')


def name_sources(app, pagename, templatename, context, doctree):
    if "body" in context:
        sources = os.environ.get("GODRAYS_SOURCES", pathlib.Path(app.srcdir).as_uri()).rstrip("/") + "/"
        context["body"] = context["body"].replace(PLACE, sources)


def write_entry(app, exception):
    """An index.html at the top, and the files to download."""
    if exception is None and app.builder.name == "html":
        scripts.write(os.path.join(app.outdir, scripts.FOLDER))
        with open(os.path.join(app.outdir, "index.html"), "w", encoding="utf-8") as file:
            file.write('<!DOCTYPE html><meta http-equiv="refresh" content="0; url=Documentation/index.html">')


def setup(app):
    app.connect("source-read", link_sources)
    app.connect("source-read", add_made)
    app.connect("html-page-context", name_sources)
    app.connect("build-finished", write_entry)
