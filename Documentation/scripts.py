# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of pictures in the documentation site: thumbnails, code, and files to download, also as notebooks."""

import ast
import json
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = "downloads"  # at the top of the site
END = 'if "picture" not in globals():\n    picture = godrays.render(renderer)\npicture.save("{}.png")\n'


def make_notebook(title, *cells):
    """A notebook of Jupyter, as text, of a first cell in Markdown and cells of code."""
    fields = [("markdown", title, {}), *(("code", cell, {"execution_count": None, "outputs": []}) for cell in cells)]
    return json.dumps({
        "cells": [{"cell_type": kind, "id": f"cell-{i}", "metadata": {}, "source": text.strip("\n"), **more}
            for i, (kind, text, more) in enumerate(fields)],
        "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}},
        "nbformat": 4, "nbformat_minor": 5}, indent=1)


def split(code):
    """The paragraphs of a script, between whole statements, without its docstring."""
    lines, first, parts = code.splitlines(), 0, []
    for node in ast.parse(code).body:
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            first = node.end_lineno
        elif node.end_lineno == len(lines) or not lines[node.end_lineno].strip():
            parts.append("\n".join(lines[first:node.end_lineno]))
            first = node.end_lineno
    return parts


def find_picture(script):
    """The picture in the tree that a script draws, or none."""
    names = (f"Documentation/Gallery/science/{script.stem}.jpg", f"Testing/Baseline/Example-{script.stem}.png",
        f"Documentation/Gallery/{script.stem.lower()}.jpg")
    return next((ROOT / name for name in names if (ROOT / name).exists()), None)


def find_scripts():
    """The examples in Python that draw a picture of the tree."""
    return [script for script in sorted(ROOT.glob("Examples/*/*.py")) if find_picture(script)]


def find_companions(script):
    """The files beside a script that it needs: modules and data."""
    code = script.read_text(encoding="utf-8")
    names = [f"{name}.py" for name in re.findall(r"^(?:import|from) (\w+)", code, re.M)]
    names += re.findall(r'with_name\("([^"]+)"\)', code)
    return [script.with_name(name) for name in names if script.with_name(name).exists()]


def add_links(names, here):
    """A line of HTML that links files to download from a page in this folder."""
    up = "../" * len(pathlib.PurePath(here).parts)
    return "Download: " + " · ".join(f'<a href="{up}{FOLDER}/{name}" download>{name}</a>' for name in names) + "\n"


def make_gallery(here):
    """The page of scripts, as Markdown: thumbnails, then each picture with its script."""
    thumbnails, sections = [], []
    for script in find_scripts():
        picture = pathlib.PurePath("../" * len(pathlib.PurePath(here).parts), find_picture(script).relative_to(ROOT))
        code = script.read_text(encoding="utf-8")
        says = ast.get_docstring(ast.parse(code)).split("\n\n")[0]
        anchor = "script-" + script.stem.lower().replace("_", "-")
        names = [script.name, f"{script.stem}.ipynb", *(each.name for each in find_companions(script))]
        thumbnails.append(f"```{{image}} {picture}\n:width: 160px\n:alt: {script.stem}\n:target: '#{anchor}'\n```\n")
        sections.append(f"({anchor})=\n## {script.stem}\n\n{says}\n\n![{script.stem}]({picture})\n\n"
            f"{add_links(names, here)}\n```python\n{code.strip()}\n```\n")
    return "\n".join(thumbnails + sections)


def split_cookbook(page):
    """The setup of the cookbook's recipes, and (number, title, code) of each in Python."""
    setup, *parts = re.split(r"^### (?=\d+\. )", page, flags=re.M)
    def join(text):
        return "".join(re.findall(r"^```python\n(.*?)^```", text, re.S | re.M))

    return join(setup), [(int(part.split(".")[0]), part.splitlines()[0], join(part)) for part in parts]


def link_recipes(page, here):
    """The cookbook with files to download under the picture of each recipe."""
    def link(found):
        return f"{found[0]}\n{add_links((f'recipe-{found[1]}.py', f'recipe-{found[1]}.ipynb'), here)}"
    return re.sub(r"^!\[\]\(Cookbook/(\d+)\.jpg\)\n", link, page, flags=re.M)


def write(folder):
    """Write all files to download into a folder: scripts, what they need, and notebooks."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for script in find_scripts():
        code, companions = script.read_text(encoding="utf-8"), find_companions(script)
        modules = [each for each in companions if each.suffix == ".py"]
        data = [f"Save {each.name} beside this notebook." for each in companions if each not in modules]
        start = f'import sys\n\n__file__ = "{script.name}"\nsys.argv = ["{script.name}", "{script.stem}.png"]'
        title = "\n\n".join((f"# {script.stem}", ast.get_docstring(ast.parse(code)), *data))
        (folder / f"{script.stem}.ipynb").write_text(make_notebook(title,
            *(f"%%writefile {each.name}\n{each.read_text(encoding='utf-8')}" for each in modules), start, *split(code),
            f'from IPython.display import Image\n\nImage("{script.stem}.png")'), encoding="utf-8")
        for each in (script, *companions):
            (folder / each.name).write_bytes(each.read_bytes())
    setup, recipes = split_cookbook((ROOT / "Documentation/Cookbook.md").read_text(encoding="utf-8"))
    for number, title, code in recipes:
        name = f"recipe-{number:02}"
        (folder / f"{name}.py").write_text(f'"""{title}"""\n\n{setup}\n{code}\n{END.format(name)}', encoding="utf-8")
        (folder / f"{name}.ipynb").write_text(
            make_notebook(f"# {title}", setup, code, END.format(name) + "picture"), encoding="utf-8")
