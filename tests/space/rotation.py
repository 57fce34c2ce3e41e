#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid rotation in space by 720 degrees in 16 steps only turns the stress:
finite elements."""

import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name
import neo_hookean

check = Check(__doc__)

AXIS = numpy.array([2.0, -3.0, 6.0]) / 7
for element in ("Q1/Q1 assumed", "Q2/Q2 assumed"):
    run = check.run("rotation.prm", file_name(element), element_settings(element))
    for p in run.all_points():
        vector = 4 * math.pi * p["load"] * AXIS
        R = neo_hookean.rotation(vector)
        stress = R @ numpy.diag([-50.0, -50.0, -100.0]) @ R.T
        fields = {}
        for i in range(3):
            for j in range(3):
                fields[f"s{i + 1}{j + 1}"] = (p[f"stress_{i + 1}{j + 1}"],
                                              stress[i, j], 100.0)
                fields[f"m{i + 1}{j + 1}"] = (p[f"couple_stress_{i + 1}{j + 1}"],
                                              0.0, 20.0)
            fields[f"rotation{i + 1}"] = (p[f"micro_rotation_{i + 1}"],
                                          float(vector[i]), 1.0)
        fields["volume"] = ([v / v0 for v, v0 in zip(p["volume"],
                                                    p["initial_volume"])], 1.0, 1.0)
        check.fields(f"{element}, {720 * p['load']:g} degrees", 1e-7, **fields)
check.finish()
