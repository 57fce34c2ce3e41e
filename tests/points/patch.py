#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch tests T1 and T2 (benchmarks A1) in the configuration "current", with
the points where the program puts them. Stresses, displacements and rotations
are met to rounding, on two ranks too. Boxes that lie anyhow: unit tests.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)

SIDES = ("left", "right", "bottom", "top")
TESTS = {
    "T1": ([], (1.5, 1.5), 0.25e-3),
    "T2": (["Loading/Body couple=s"] +
           [f"Boundary conditions/{side}/Rotation=0.75e-3 * s"
            for side in SIDES], (2.0, 1.0), 0.75e-3),
}
VARIANTS = (("full", "generalised", 3, 1), ("full", "point", 2, 1),
            ("mean dilatation", "generalised", 2, 1),
            ("assumed", "generalised", 1, 1), ("assumed", "generalised", 2, 2))

for test, (settings, shear, rotation) in TESTS.items():
    for sampling, shape, per_axis, ranks in VARIANTS:
        name = f"{test}, {sampling}, {shape}, {per_axis} per axis, {ranks} ranks"
        p = check.run("patch.prm", file_name(name), settings +
                      [f"Grid/Strain sampling={sampling}",
                       f"Material points/Shape={shape}",
                       f"Material points/Per axis={per_axis}"], ranks).points()
        check.note(len(p["X"]) == 20 * per_axis ** 2,
                   f"{name}: {len(p['X'])} points")
        places = list(zip(p["X"], p["Y"]))
        check.fields(
            name, 1e-10,
            s11=(p["stress_11"], 4.0, 4.0),
            s22=(p["stress_22"], 4.0, 4.0),
            s12=(p["stress_12"], shear[0], 1.5),
            s21=(p["stress_21"], shear[1], 1.5),
            m1=(p["couple_stress_1"], 0.0, 0.04),
            m2=(p["couple_stress_2"], 0.0, 0.04),
            u1=(p["displacement_1"], [1e-3 * (x + y / 2) for x, y in places],
                1e-4),
            u2=(p["displacement_2"], [1e-3 * (x + y) for x, y in places], 1e-4),
            rotation=(p["micro_rotation"], rotation, 1e-3))
check.finish()
