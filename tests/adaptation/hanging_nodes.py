#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch tests T1, T2 and T3 (benchmarks A1) and a rigid rotation on grids with
hanging nodes: exact as on uniform ones, on 1 and 3 ranks."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

EDGE = "Boundary conditions/edge/"
TESTS = {
    "T1": ([], lambda x, y: (1.5, 1.5), (0.0, 0.0), lambda x, y: 0.25e-3),
    "T2": ([EDGE + "Rotation=0.75e-3 * s", "Loading/Body couple=s"],
           lambda x, y: (2.0, 1.0), (0.0, 0.0), lambda x, y: 0.75e-3),
    "T3": ([EDGE + "Rotation=1e-3 * (1/4 + x - y) * s",
            "Loading/Body force 1=s", "Loading/Body force 2=s",
            "Loading/Body couple=2 * (x - y) * s"],
           lambda x, y: (1.5 + (x - y), 1.5 - (x - y)), (0.04, -0.04),
           lambda x, y: 1e-3 * (0.25 + x - y)),
}

for test, (settings, shear, couple, rotation) in TESTS.items():
    for element in ("Q1/Q1 assumed", "Q2/Q1 full", "Q2/Q2 assumed"):
        if (test, element) == ("T3", "Q1/Q1 assumed"):
            continue  # strains that vary linearly are met at second order only
        for ranks in (1, 3) if element == "Q2/Q2 assumed" else (1,):
            name = f"{test} {element} {ranks}"
            run = check.run("patch.prm", file_name(name),
                            element_settings(element) + settings, ranks)
            p = run.points()
            places = list(zip(p["X"], p["Y"]))
            check.note(run.history["cells [1]"][-1] > 5,
                       f"{name}: the grid is refined")
            check.fields(
                name, 1e-9,
                s11=(p["stress_11"], 4.0, 4.0),
                s22=(p["stress_22"], 4.0, 4.0),
                s12=(p["stress_12"], [shear(*place)[0] for place in places], 1.5),
                s21=(p["stress_21"], [shear(*place)[1] for place in places], 1.5),
                m1=(p["couple_stress_1"], couple[0], 0.04),
                m2=(p["couple_stress_2"], couple[1], 0.04),
                u1=(p["displacement_1"], [1e-3 * (x + y / 2) for x, y in places],
                    1e-4),
                u2=(p["displacement_2"], [1e-3 * (x + y) for x, y in places], 1e-4),
                rotation=(p["micro_rotation"],
                          [rotation(*place) for place in places], 1e-3))

for element in ("Q1/Q1 assumed", "Q2/Q2 assumed"):
    name = f"rotation by 90 degrees, {element}"
    p = check.run("rotation.prm", file_name(name), element_settings(element)).points()
    check.fields(name, 1e-8, s11=(p["stress_11"], -100.0, 100.0),
                 s22=(p["stress_22"], -50.0, 100.0),
                 s33=(p["stress_33"], -50.0, 100.0),
                 s12=(p["stress_12"], 0.0, 100.0),
                 s21=(p["stress_21"], 0.0, 100.0),
                 m1=(p["couple_stress_1"], 0.0, 20.0),
                 m2=(p["couple_stress_2"], 0.0, 20.0),
                 rotation=(p["micro_rotation"], math.pi / 2, 1.0),
                 volume=(p["volume"], p["initial_volume"], p["initial_volume"][0]))
check.finish()
