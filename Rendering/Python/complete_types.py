# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Usage: complete_types.py <file.pyi>...

Give the properties in files of types that VTK has written their types: those of the methods that they are
made of. VTK writes for each, "name:property".
"""

import pathlib
import re
import sys

LAYERS = "".join(f"    @property\n    def {name}(self) -> Any: ...\n" for name in ("occlusion", "scattering"))
LAYERS += "".join(f"    @property\n    def {name}(self) -> Any: ...\n"
    f"    @{name}.setter\n    def {name}(self, value: Any) -> None: ...\n" for name in ("light", "preset"))
CONTEXT = """    def __enter__(self) -> 'vtkGodRaysPass': ...
    def __exit__(self, *error: Any) -> None: ...
"""


def complete(text):
    """The text of a file with its properties."""
    parts = re.split(r"(?m)^(?=class )", text)
    return parts[0] + "".join(map(complete_class, parts[1:]))


def complete_class(text):
    getters = {name.lower(): kind
        for name, kind in re.findall(r"(?m)^    def Get(\w+)\(self\) -> (.*): \.\.\.$", text)}
    setters = {name.lower() for name in re.findall(r"(?m)^    def Set(\w+)\(self", text)}

    def replace(found):
        key = found[1].replace("_", "")
        if key not in getters:
            return ""  # of no getter: written below
        kind = getters[key]
        lines = f"    @property\n    def {found[1]}(self) -> {kind}: ...\n"
        if key in setters:
            accepts = re.sub(r"^Tuple\[(\w+).*", r"Sequence[\1]", kind)
            accepts = f"Union[{kind}, str]" if kind == "int" else accepts
            lines += f"    @{found[1]}.setter\n    def {found[1]}(self, value: {accepts}) -> None: ...\n"
        return lines

    head, rest = text.split("\n", 1)
    properties = []
    for found in re.finditer(r"(?m)^    (\w+): ?'?(?:property|getset_descriptor)'?\n", rest):
        properties.append(replace(found))
    rest = re.sub(r"(?m)^    (\w+): ?'?(?:property|getset_descriptor)'?\n", "", rest)
    if head.startswith("class vtkGodRaysPass("):
        properties += [LAYERS, CONTEXT]
    # After the methods: a property must not hide what a method's type names.
    body = rest.rstrip("\n")
    return head + "\n" + body + ("\n" if body else "") + "".join(properties) + "\n"


def main():
    for name in sys.argv[1:]:
        path = pathlib.Path(name)
        path.write_text(complete(path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
