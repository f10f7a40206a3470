# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python reference as Markdown, from the module's docstrings: the site's page PythonReference ends with it."""

import importlib
import inspect
import re


def block(text, language="text"):
    return f"```{language}\n{text.strip()}\n```\n"


class Plain(str):
    """An annotation, shown without the quotes of one that is not evaluated."""

    def __repr__(self):
        return str(self)


def write_signature(name, signature):
    """The call in one line, or with a line for each parameter."""
    parts, result = [], ""
    for parameter in signature.parameters.values():
        if parameter.kind == parameter.KEYWORD_ONLY and not any(part.startswith("*") for part in parts):
            parts.append("*")
        if isinstance(parameter.annotation, str):
            parameter = parameter.replace(annotation=Plain(parameter.annotation))
        parts.append(str(parameter))
    if signature.return_annotation is not signature.empty:
        result = f" -> {signature.return_annotation}"
    line = f"{name}({', '.join(parts)}){result}"
    return line if len(line) <= 100 else f"{name}(\n" + "".join(f"    {part},\n" for part in parts) + f"){result}"


def escape(text):
    """Text that Markdown shows as it is, but for code between backticks."""
    parts = re.split(r"(`+[^`]*`+)", text)
    return "".join(part if i % 2 else re.sub(r"([*<\[\]])", r"\\\1", part) for i, part in enumerate(parts))


def write_text(text, parameters):
    """A docstring as Markdown: its "name: meaning" is an item of a list where there is such a parameter."""
    lines, in_item = [], False
    for line in text.splitlines():
        found = re.match(r"\**([a-z_]+(?:, [a-z_]+)*): (.*)", line)
        names = found[1].split(", ") if found else []
        if names and set(names) <= set(parameters):
            if not in_item:
                lines.append("")
            line = f"- {', '.join(f'`{name}`' for name in names)}: {escape(found[2])}"
            in_item = True
        elif in_item and line.startswith("    "):
            line = f"  {escape(line.strip())}"
        elif line.startswith("    "):  # code
            in_item = False
        else:
            if in_item and line:
                lines.append("")
            in_item = in_item and not line
            line = escape(line)
        lines.append(line)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines).strip()) + "\n"


def describe_function(name, function):
    signature = inspect.signature(function)
    return (f"### {name}\n\n" + block(write_signature(name, signature), "python") + "\n" +
        write_text(inspect.getdoc(function) or "", signature.parameters))


def list_constants(kind, text):
    """The names that a property takes whose documentation says "one of <enumeration>", or none."""
    found = re.search(r"\bone of (\w+)", text)
    values = getattr(kind, found[1], None) if found else None
    if not inspect.isclass(values):
        return []
    return [each.lower() for each, value in inspect.getmembers(kind, lambda value: isinstance(value, values))]


def describe_properties(kind):
    """A list of what a class declares as a property: its meaning, unit, valid range and default."""
    names = {}  # by text, which those that C++ has in a group share
    for name, value in vars(kind).items():
        if isinstance(value, property):
            text = " ".join((value.__doc__ or "").split())
            names.setdefault((text, value.fset is None), []).append(name)
    items = []
    for (text, read_only), group in names.items():
        head = ", ".join(f"`{name}`" for name in group) + (", read only" if read_only else "")
        constants = ", ".join(f'`"{each}"`' for each in list_constants(kind, text))
        items.append(f"- {head}: {escape(text)}" + (f" By name: {constants}." if constants else ""))
    return "\nProperties:\n\n" + "\n".join(sorted(items)) + "\n" if items else ""


def describe_class(name, kind):
    parts = [inspect.getdoc(kind) or ""]
    for method, value in sorted(vars(kind).items()):
        is_method = callable(value) and not inspect.isclass(value) and not method.startswith("_")
        text = inspect.getdoc(value) if is_method else None
        if text:
            # VTK's: the call in Python, that in C++, and the text
            text = re.sub(r"^C\+\+:.*\n?", "", text, flags=re.MULTILINE)
            parts.append(f"{method}\n" + "\n".join("    " + line for line in text.strip().splitlines()))
    return f"### {name}\n\n" + block("\n\n".join(parts)) + describe_properties(kind)


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
