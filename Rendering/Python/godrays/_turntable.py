# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views from all around as one HTML file: turntable()."""

from __future__ import annotations

import base64
import operator
import pathlib
from typing import TYPE_CHECKING, Any

from ._render import _KEYWORDS, _draw, _read, encode
from ._targets import write_whole
from ._vtk import vtkCamera

if TYPE_CHECKING:
    from collections.abc import Sequence

_PAGE = pathlib.Path(__file__).with_name("_turntable.html")
_LARGEST = 5_000_000  # [bytes]
_QUALITIES = 90, 80, 65, 50, 35, 20  # of JPEG


def turntable(
    data: Any,
    file: Any,
    size: Sequence[int] = (800, 600),
    preset: str | None = None,
    *,
    views: int = 36,
    **parameters: Any,
) -> None:
    """Write views from all around the data as one HTML file, which any browser turns.

    data, size, preset: as of render().
    file: the name of the file, which ends in .html. It has at most 5 MB: pictures are JPEG, of a quality that
        fits.
    views: how many pictures. Valid range: [2, 360]. Default is 36.
    parameters: all else that render() takes, but transparent. camera is that of the first picture.

    A drag with the mouse or a finger turns the data, and so do the arrow keys. The file needs no server and
    no network. A sun that is placed moves with the camera; sun=(azimuth, elevation) stays.

    ValueError: the name ends otherwise, views is out of range, or the pictures do not fit into 5 MB.
    Others are those of render().
    """
    if pathlib.Path(file).suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"file={str(file)!r} should end in .html: turntable() writes no other type")
    try:
        count = operator.index(views)
    except TypeError:
        count = 0
    if not 2 <= count <= 360:
        raise ValueError(f"views={views!r} should be a whole number from 2 to 360")
    if "transparent" in parameters:
        raise TypeError("turntable() has no parameter transparent: JPEG has no alpha")
    options = {name: parameters.pop(name, value) for name, value in _KEYWORDS.items()}
    options["transparent"] = False
    pictures = _draw(data, size, preset, options, parameters, lambda window: _turn(window, count))
    head, tail = _PAGE.read_text(encoding="utf-8").split("<!-- pictures -->")
    for quality in _QUALITIES:
        images = [base64.b64encode(encode(each, ".jpg", quality)).decode() for each in pictures]
        body = "\n".join(f'<img alt="View {i} of {count}" src="data:image/jpeg;base64,{each}">'
            for i, each in enumerate(images, 1))
        page = f"{head}{body}{tail}".encode()
        if len(page) <= _LARGEST:
            write_whole(file, lambda path: path.write_bytes(page))
            return
    raise ValueError(f"{count} pictures of {size[0]} x {size[1]} have {len(page) / 1e6:.1f} MB: "
        "give a smaller size or fewer views")


def _turn(window: Any, count: int) -> Any:
    """The pictures of cameras about the focal point; the scene has its camera back then."""
    scene = window.GetRenderers().GetFirstRenderer()
    camera, former = scene.GetActiveCamera(), vtkCamera()
    former.DeepCopy(camera)
    pictures = []
    try:
        for i in range(count):
            camera.DeepCopy(former)
            camera.Azimuth(360 * i / count)
            scene.ResetCameraClippingRange()
            pictures.append(_read(window, False))
    finally:
        camera.DeepCopy(former)
    return pictures
