#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid rotation by 90 degrees in 4 and 36 steps only turns the stress.

A body without stress stays without: what is left is compared with the shear
modulus.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

for element in ("Q1/Q1 full", "Q1/Q1 mean dilatation", "Q1/Q1 assumed",
                "Q2/Q1 full", "Q2/Q2 assumed"):
    for steps in (4, 36):
        for pressure in (0, 100):
            name = f"{element}, {steps} steps, {pressure} Pa"
            p = check.run("rotation.prm", file_name(name),
                          element_settings(element) +
                          [f"Loading/Initial step={1 / steps!r}",
                           f"Loading/Largest step={1 / steps!r}",
                           f"Initial state/Vertical pressure at top={pressure}"]
                          ).points()
            scale = pressure or 1000  # Pa, the shear modulus
            check.fields(name, 1e-8 if pressure else 1e-10, s11=(p["stress_11"], -pressure, scale),
                         s22=(p["stress_22"], -pressure / 2, scale),
                         s33=(p["stress_33"], -pressure / 2, scale),
                         s12=(p["stress_12"], 0.0, scale),
                         s21=(p["stress_21"], 0.0, scale),
                         m1=(p["couple_stress_1"], 0.0, scale * 0.2),
                         m2=(p["couple_stress_2"], 0.0, scale * 0.2),
                         rotation=(p["micro_rotation"], math.pi / 2, 1.0),
                         volume=(p["volume"], p["initial_volume"],
                                 p["initial_volume"][0]))
check.finish()
