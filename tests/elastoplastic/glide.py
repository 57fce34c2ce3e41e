#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Glide layer with couple stress in the yield function (benchmarks C1)."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings

check = Check(__doc__)
SMALL, S = 1e-3, 81.649658  # strains relative to the reference; its circle

result = check.run("glide.prm", "glide", element_settings("Q2/Q2 full"))
p = result.points()
height = p["Y"]
stress = [s / SMALL for s in p["stress_21"]]
couple = [m / SMALL for m in p["couple_stress_2"]]
plastic = [i for i, a in enumerate(p["plastic_multiplier"]) if a > 0]
check.close("lowest plastic point", min(height[i] for i in plastic), 4.382,
            absolute=0.03)
check.close("points on the circle s21^2 + m^2 = S^2",
            max(abs(math.hypot(stress[i], couple[i]) - S) for i in plastic), 0,
            absolute=1e-6 * S)
# s21 = -S cos f, m = S sin f, f - y constant. The step from elastic to plastic
# lies within a cell.
phase = [math.atan2(couple[i], -stress[i]) - height[i] for i in plastic
         if height[i] > 4.5]
check.close("f - y, mean", sum(phase) / len(phase), -3.62743, absolute=2e-3)
check.close("f - y, spread", max(phase) - min(phase), 0, absolute=5e-3)
top = max(range(len(height)), key=lambda i: height[i])
check.close("u(5)", result.history["top u1 [m]"][-1] / SMALL, -7.240e-4,
            relative=5e-3)
check.close("m near 5", couple[top], 80.05, relative=2e-3)
check.finish()
