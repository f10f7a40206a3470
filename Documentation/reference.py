# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python reference as Markdown, from the module's docstrings: the site's page PythonReference ends with it."""

import importlib
import inspect
import re


def block(text):
    return f"```text\n{text.strip()}\n```\n"


def describe_function(name, function):
    try:
        signature = str(inspect.signature(function))
    except (TypeError, ValueError):
        signature = "(...)"
    return f"### {name}\n\n" + block(f"{name}{signature}\n\n{inspect.getdoc(function) or ''}")


def describe_class(name, kind):
    parts = [inspect.getdoc(kind) or ""]
    for method, value in sorted(vars(kind).items()):
        is_method = callable(value) and not inspect.isclass(value) and not method.startswith("_")
        text = inspect.getdoc(value) if is_method else None
        if text:
            # VTK's: the call in Python, that in C++, and the text
            text = re.sub(r"^C\+\+:.*\n?", "", text, flags=re.MULTILINE)
            parts.append(f"{method}\n" + "\n".join("    " + line for line in text.strip().splitlines()))
    return f"### {name}\n\n" + block("\n\n".join(parts))


def make():
    """Markdown of all public names; a sentence where the module is not to be had."""
    try:
        module = importlib.import_module("godrays")
    except ImportError as reason:
        return f"This site was made without the module ({reason}).\n"
    functions, classes = [], []
    for name in sorted(module.__all__):
        value = getattr(module, name)
        if inspect.isclass(value):
            classes.append(describe_class(name, value))
        elif callable(value):
            functions.append(describe_function(name, value))
    return "## Functions\n\n" + "\n".join(functions) + "\n## Classes\n\n" + "\n".join(classes)
