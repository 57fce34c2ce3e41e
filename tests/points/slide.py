#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stressed block of sand slides through the grid: its stress and volume stay.

In 1000 steps too.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)

for sampling, steps, ranks in (("full", 100, 1), ("assumed", 100, 2),
                               ("assumed", 1000, 1)):
    name = f"{sampling}, {steps} steps, {ranks} ranks"
    p = check.run("slide.prm", file_name(name),
                  [f"Grid/Strain sampling={sampling}",
                   f"Loading/Initial step={1 / steps!r}",
                   f"Loading/Largest step={1 / steps!r}"], ranks).points()
    # every step may leave the residual of 1e-9
    check.fields(name, 1e-9 * steps,
                 s11=(p["stress_11"], -40e3, 100e3),
                 s22=(p["stress_22"], -100e3, 100e3),
                 s33=(p["stress_33"], -40e3, 100e3),
                 s12=(p["stress_12"], 0.0, 100e3),
                 s21=(p["stress_21"], 0.0, 100e3),
                 m1=(p["couple_stress_1"], 0.0, 50.0),
                 m2=(p["couple_stress_2"], 0.0, 50.0),
                 rotation=(p["micro_rotation"], 0.0, 1.0),
                 u1=(p["displacement_1"], 0.04, 0.04),
                 u2=(p["displacement_2"], 0.0, 0.04),
                 volume=([v / v0 for v, v0 in
                          zip(p["volume"], p["initial_volume"])], 1.0, 1.0),
                 void_ratio=(p["void_ratio"], 0.6, 1.0))
check.finish()
