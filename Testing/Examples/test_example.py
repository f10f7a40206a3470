# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""An example in Python: its picture is that of the same example in C++, whose light is checked
against the processor's; and the picture without rays must not pass for it.

Usage: test_example.py example.py picture.png baseline.png [variant]
"""

import os
import subprocess
import sys

import numpy
from example_testing import read

SIZE = "400x300"  # of the baselines
LEVELS = 2


def difference(example, picture, baseline, **environment):
    subprocess.run(
        [sys.executable, example, picture, SIZE, *variant], check=True, env={**os.environ, **environment}
    )
    values, expected = read(picture), read(baseline)
    if values.shape != expected.shape:
        sys.exit(f"{picture} is {values.shape}, its baseline {expected.shape}")
    worst = int(numpy.abs(values - expected).max())
    other = baseline.replace(".png", "_1.png")  # as VTK has it: newer VTK places a sun a little elsewhere
    return min(worst, int(numpy.abs(values - read(other)).max())) if os.path.exists(other) else worst


example, picture, baseline, *variant = sys.argv[1:]
with_rays = difference(example, picture, baseline)
without = difference(example, picture + ".without-rays.png", baseline, GODRAYS_DISABLE="1")
print(f"{with_rays} levels from the baseline with rays, {without} without")
if with_rays > LEVELS:
    sys.exit(f"The picture is not that of the example in C++; see {picture}")
if without <= 10 * LEVELS:
    sys.exit("The picture without rays passes for the one with them: the test is blind.")
