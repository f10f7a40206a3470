# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the classes of this project say, as exceptions and warnings of Python instead of VTK's log."""

from __future__ import annotations

import difflib
import math
import re
import warnings
from collections.abc import Iterable, Sequence
from typing import Any

from ._vtk import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

_MESSAGE = re.compile(
    r"^(?P<kind>ERROR|Warning|Generic Warning): In (?P<file>[^\n]*), line \d+\n"
    r"(?:(?P<class>vtk\w+) \(\w+\): )?(?P<text>.*?)(?:\n\n|\Z)", re.M | re.S)


def tell_names(name: Any, names: Iterable[str]) -> str:
    """The end of a message about a name that there is not: which was probably meant, and all there are."""
    names = list(names)
    near = difflib.get_close_matches(str(name).lower(), names, 1, 0.7)
    meant = f"did you mean {near[0]}? There" if near else "there"
    return f"; {meant} are: {', '.join(names)}"


def to_numbers(
    name: str, value: Any, counts: Sequence[int], meaning: str, bounds: tuple[float, float] | None = None
) -> list[float]:
    """A value as so many finite numbers; ValueError, with what it should be, if it is no such thing."""
    try:
        numbers = [float(number) for number in value]
    except (TypeError, ValueError):
        numbers = []
    low, high = bounds or (-math.inf, math.inf)
    if len(numbers) not in counts or not all(math.isfinite(x) and low <= x <= high for x in numbers):
        raise ValueError(f"{name}={value!r} should be {meaning}")
    return numbers


class Error(RuntimeError):
    """An error that a class of this project tells; the text is that of VTK's log."""


class GodRaysWarning(UserWarning):
    """A warning of a class of this project, such as that a scene is drawn without rays, and why."""


class raising:
    """Have errors of this project's classes raised, and their warnings given to the module warnings.

        with godrays.raising():
            rays.SetIntensity(math.nan)  # godrays.Error: Intensity must be a finite number in ...

    They are raised at the end of the block, as one Error. What other classes of VTK say goes where it would
    have gone. The properties and functions of this package do so by themselves; methods of VTK's spelling
    otherwise leave errors to VTK's log. An object that has observers of its errors tells these alone.
    """

    def __enter__(self) -> Any:
        self._former = vtkOutputWindow.GetInstance()
        self._messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self._messages)
        self._verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, kind: Any, *_: Any) -> None:
        vtkLogger.SetStderrVerbosity(self._verbosity)
        if vtkOutputWindow.GetInstance() is self._messages:
            vtkOutputWindow.SetInstance(self._former)
        said = self._messages.GetOutput()
        if said:
            self._tell(said, kind is None)

    def _tell(self, said: str, may_raise: bool) -> None:
        errors = []
        for found in _MESSAGE.finditer(said):
            is_error = found["kind"] == "ERROR"
            if "vtkGodRays" not in f"{found['file']} {found['class']}" or (is_error and not may_raise):
                tell = "DisplayErrorText" if is_error else "DisplayWarningText"
                getattr(self._former, tell)(found[0])
            elif is_error:
                errors.append(found["text"].strip())
            else:
                warnings.warn(found["text"].strip(), GodRaysWarning, stacklevel=4)
        rest = _MESSAGE.sub("", said)
        if rest.strip():
            self._former.DisplayText(rest)
        if errors:
            raise Error("\n".join(errors))


def watch(rays: Any) -> None:
    """Have the warnings of a pass given to the module warnings, also while a window renders."""

    def warn(caller: Any, event: str, text: str) -> None:
        found = _MESSAGE.search(text)
        warnings.warn((found["text"] if found else text).strip(), GodRaysWarning, stacklevel=2)

    warn.CallDataType = "string0"  # type: ignore[attr-defined]
    rays.AddObserver("WarningEvent", warn)
