# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of the wrapped classes, such as rays.intensity for GetIntensity() and SetIntensity().

VTK 9.5 and later wrap such properties themselves. These here are the same for all versions; besides, they
raise errors, and take constants by name.
"""

from __future__ import annotations

import ctypes
import gc
import math
import re
from numbers import Real
from typing import Any

from ._errors import raising, tell_names


def snake(name: str) -> str:
    """sun_angular_radius for SunAngularRadius."""
    return "".join("_" + c.lower() if c.isupper() else c for c in name).lstrip("_")


def constant(owner: Any, name: str, text: str) -> int:
    """The value of an owner's constant, such as 1 for "occlusion"."""
    if re.match(rf"Set{name}\(self,\s+\w+:float", getattr(owner, "Set" + name).__doc__ or ""):
        raise ValueError(f"{snake(name)}={text!r} should be a number")
    constants = {
        each.lower(): getattr(owner, each)
        for each in dir(owner)
        if each.isupper() and isinstance(getattr(owner, each), int)
    }
    if text.lower() not in constants:
        raise ValueError(
            f"{snake(name)}={text!r} is none of the constants of {owner.GetClassName()}"
            + tell_names(text, constants)
        )
    return int(constants[text.lower()])


def describe(cls: type, name: str) -> str:
    """What the documentation in C++ says of a property, or of the first of its group."""
    methods = {"Set" + name, "Get" + name}
    declares = next(each for each in cls.__mro__ if methods & set(vars(each)))
    found = ""
    for method, thing in vars(declares).items():  # in the order of the header
        if isinstance(thing, property) or not method[:1].isupper():
            continue
        found = _text(thing) or found
        if method in methods:
            return found
    return ""


def _text(method: Any) -> str:
    """A wrapped method's documentation, without its signatures."""
    text = getattr(method, "__doc__", None) or ""
    text = re.sub(r"(?m)^\w+\([^\n]*(?:\n +[^\n]*)*\nC\+\+:[^\n]*(?:\n +[^\n]*)*\n*", "", text)
    text = re.sub(r"^(?:Set/Get|The) ", "", " ".join(text.split()))
    return text[:1].upper() + text[1:]


def set_value(owner: Any, name: str, value: Any) -> None:
    """Call an owner's SetName() with one value or several, a constant by its name; errors are raised.

    So is what C++ clamps in silence: a number out of the range that the header gives, which changes nothing.
    """
    method = getattr(owner, "Set" + name)
    if isinstance(value, str) and not re.search(rf"Set{name}\(self,\s+\w+:(?:str|Path)", method.__doc__):
        value = constant(owner, name, value)
    is_list = hasattr(value, "__iter__") and not isinstance(value, str) and not hasattr(value, "IsA")
    text = describe(type(owner), name) if isinstance(value, Real) and math.isfinite(value) else ""
    bounds = re.search(r"Valid range: \[([-+.e\d]+), ([-+.e\d]+)\](, and 0)?", text)
    if bounds and not (
        float(bounds[1]) <= value <= float(bounds[2]) or (bounds[3] and value == 0)
    ):
        raise ValueError(f"{snake(name)}={value} must be in [{bounds[1]}, {bounds[2]}]; nothing is changed")
    with raising():
        if is_list:
            method(*value)
        else:
            method(value)


def install(classes: list[type]) -> None:
    """Give each class a property for each GetName() without arguments that it declares."""
    for cls in classes:
        for method in list(vars(cls)):
            name = method[3:]
            if not method.startswith("Get") or re.search("^$|^MTime$|(Min|Max)Value$", name):
                continue
            if not re.match(rf"{method}\(self\)\s+->", getattr(cls, method).__doc__ or ""):
                continue
            add(cls, snake(name), _make(cls, name))
        if "__init__" in vars(cls) and hasattr(cls, "override"):
            cls.override(_with_keywords(cls))  # type: ignore[attr-defined]


def _with_keywords(cls: Any) -> type:
    """A class whose constructor takes properties, as VTK's do since 9.4, and that takes no others later."""

    def init(self: Any, *arguments: Any, **properties: Any) -> None:
        cls.__init__(self, *arguments)
        for name, value in properties.items():
            if not hasattr(type(self), name):
                raise TypeError(f"{cls.__name__} has no property {name}")
            setattr(self, name, value)

    def put(self: Any, name: str, value: Any) -> None:
        if type(self) is made and not name.startswith("_") and not hasattr(cls, name):
            names = [each for each in dir(cls) if isinstance(getattr(cls, each), property)]
            what = f"{cls.__name__} has no property {name}"
            raise AttributeError(what + tell_names(name, names))
        cls.__setattr__(self, name, value)

    made = type(cls.__name__, (cls,), {
        "__init__": init, "__setattr__": put, "__repr__": lambda self: cls.__repr__(self),
        "__module__": cls.__module__, "__doc__": cls.__doc__})
    return made


def _make(cls: type, name: str) -> property:
    def get(self: Any) -> Any:
        return getattr(self, "Get" + name)()

    def put(self: Any, value: Any) -> None:
        set_value(self, name, value)

    return property(get, put if hasattr(cls, "Set" + name) else None, None, describe(cls, name))


def add(cls: type, name: str, attribute: Any) -> None:
    """Add an attribute to a wrapped class. VTK's classes are static types, which take none by setattr()."""
    gc.get_referents(vars(cls))[0][name] = attribute
    if name == "__repr__":  # is called by a pointer; that of a class made in Python looks the name up
        made = type("made", (), {name: attribute})
        offset = object.__basicsize__ + 9 * ctypes.sizeof(ctypes.c_void_p)  # PyTypeObject.tp_repr
        to_pointer = ctypes.c_void_p.from_address
        to_pointer(id(cls) + offset).value = to_pointer(id(made) + offset).value
    ctypes.pythonapi.PyType_Modified(ctypes.py_object(cls))
