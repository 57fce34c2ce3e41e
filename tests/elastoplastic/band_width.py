#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Width of the band that softens first in a layer which all yields at the same
stress (benchmarks C3): closed form of the rate problem."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings

check = Check(__doc__)

MU, MU_C, B, H = 4000.0, 2000.0, 288000.0, -2000.0
HEIGHT, CELLS = 200, 400  # [mm]: high enough that the walls do not matter
SMALL, YIELD = 1e-3, 100.0  # stresses of the scene relative to the reference

a = -MU * H / (H + 3 * MU)
k = math.sqrt(4 * MU_C * a / (B * (MU_C - a)))
k_e = math.sqrt(4 * MU_C * MU / (B * (MU_C + MU)))
expected = 2 / k * (math.pi - math.atan(
    k_e / k * (1 / MU_C + 1 / MU) / (1 / a - 1 / MU_C)))
check.close("width of the formula [mm]", expected, 34.629, absolute=1e-3)

# Its load-displacement curve goes back: the opening of 40 mm leads along it.
result = check.run(
    "layer.prm", "band_width", element_settings("Q2/Q2 full") + [
        f"Grid/Cells=1, {CELLS}", f"Geometry/Box=0.5, {HEIGHT}",
        f"Materials/solid/Hardening modulus={H}",
        f"Boundary conditions/top/Displacement 1={HEIGHT * 5e-5!r}*s",
        "Loading/Control=opening",
        f"Loading/Opening/From=0.25, {HEIGHT // 2 - 20}",
        f"Loading/Opening/To=0.25, {HEIGHT // 2 + 20}",
        "Loading/Opening/Final opening=5e-3", "Loading/Stop=0.24",
        "Loading/Fixed steps=false", "Output/Fields every=0.002"])

# The points that have yielded more in a step, from the second step after the
# first yielding on: in the first one the band forms.
stresses, widths, before = [], [], None
for points in result.all_points():
    plastic = points["plastic_multiplier"]
    if before is not None:
        active = sum(b > a + 1e-13 for a, b in zip(before, plastic))
        tau = sum(points["stress_12"]) / len(plastic) / SMALL
        if active > 0 and tau < 0.999 * YIELD:
            stresses.append(tau)
            widths.append(active / len(plastic) * HEIGHT)
    before = plastic

# A straight line through the widths against the stress, which falls from the
# yield stress to 96: its value there is that of the first softening.
n = len(stresses)
mean_tau, mean_width = sum(stresses) / n, sum(widths) / n
slope = (sum((t - mean_tau) * (w - mean_width)
             for t, w in zip(stresses, widths)) /
         sum((t - mean_tau) ** 2 for t in stresses))
print(f"      {n} steps, stress {stresses[0]:.2f} to {stresses[-1]:.2f}, width "
      f"{widths[0]:.2f} to {widths[-1]:.2f} mm")
check.close("width at first softening [mm]",
            mean_width + slope * (YIELD - mean_tau), expected, relative=5e-3)
check.finish()
