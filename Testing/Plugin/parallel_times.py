# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write Documentation/Evidence/Parallel.md: times and differences of parallel rendering.

Usage: ninja -C build-paraview parallel_times, which runs parallel_times.py <file.md>
"""

import json
import os
import statistics
import sys
import tempfile

from parallel_testing import difference, draw, on_processes

COUNTS = (1, 2, 4)
SCENES = ("opaque", "tagged", "lamp", "volume")
ROUNDS = 3  # one after the other, so that a busy minute of the machine does not count for one row
FRAMES = 3  # of a round

TEXT = """# Parallel rendering

Written by `xvfb-run -a ninja -C build-paraview parallel_times`, which runs `Testing/Plugin/parallel_times.py`; the
scenes are those of `parallel_scenes.py`, of 800 x 600 pixels, each process with a part of the data.

Milliseconds of a frame in `pvbatch`, medians of {frames} frames: of the whole frame with rays and without
(`UseGodRays`), and of the pass's stages on the process that joins the pictures, by OpenGL's timers. The
rest is joining and what ParaView does besides. The largest difference is that between the picture and
the one of one process, in levels of 255, with rays and without: what it has without is ParaView's own.

All processes share this machine's {cores} processors with each other, with the threads of software
OpenGL, and with whatever else runs ({load:.1f} programs wanted one in the last minute): more of them cannot
be faster here, and times say no more than what joining costs. On a busy machine they vary by up to a
factor of two from run to run.

| scene | processes | frame | without rays | scene stage | occlusion | scattering | blend | difference | without rays |
|---|---|---|---|---|---|---|---|---|---|
"""


def milliseconds(values):
    return f"{1000.0 * statistics.median(values):.1f}"


with tempfile.TemporaryDirectory() as folder:
    rounds = [
        {
            count: draw(
                os.path.join(folder, f"{i}-{count}"),
                on_processes(count),
                SCENES,
                GODRAYS_FRAMES=str(FRAMES),
            )
            for count in COUNTS
        }
        for i in range(ROUNDS)
    ]
    text = TEXT.format(
        frames=ROUNDS * FRAMES, cores=os.cpu_count(), load=os.getloadavg()[0]
    )
    for scene in SCENES:
        for count in COUNTS:
            times = {"frames": [], "plain": [], "stages": []}
            for drawn in rounds:
                with open(os.path.join(drawn[count], "times.json"), encoding="utf-8") as file:
                    for key, values in json.load(file)[scene].items():
                        times[key] += values
            row = [scene, str(count), milliseconds(times["frames"]), milliseconds(times["plain"])]
            row += map(milliseconds, zip(*times["stages"]))
            row += [
                str(max(difference(each[count], each[1], scene + end) for each in rounds))
                for end in ("", "-plain")
            ]
            text += "| " + " | ".join(row) + " |\n"
with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write(text)
