#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Glide layer (benchmarks A3): rotation, displacement, couple stress, no shear
stress on its faces, and orders of convergence."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name, l2_error

check = Check(__doc__)

SMALL = 1e-3  # of the scene; the reference is linear


def rotation(_, y):
    return SMALL * math.sinh(2 * y)


def displacement(_, y):
    return -0.6 * SMALL * (math.cosh(2 * y) - 1)


def couple_stress(_, y):
    return 2.4 * SMALL * math.cosh(2 * y)


check.close("w(1) of the formula", rotation(0, 1) / SMALL, 3.626860407847,
            absolute=1e-12)
check.close("u(1) of the formula", displacement(0, 1) / SMALL, -1.65731741465,
            absolute=1e-11)


def run(element, cells):
    return check.run("glide_layer.prm",
                     file_name(f"glide_layer {element} {cells}"),
                     element_settings(element) + [f"Grid/Cells=1, {cells}"])


for element, order, couple_order in (
        ("Q1/Q1 full", 2, 1), ("Q1/Q1 assumed", 2, 1), ("Q2/Q1 full", 2, 1),
        ("Q2/Q2 full", 3, 2), ("Q2/Q2 assumed", 3, 2)):
    errors = {"rotation": [], "displacement": [], "couple stress": [],
              "shear stress": []}
    for cells in (8, 16, 32):
        p = run(element, cells).points()
        errors["rotation"].append(l2_error(p, "micro_rotation", rotation))
        errors["displacement"].append(
            l2_error(p, "displacement_1", displacement))
        errors["couple stress"].append(
            l2_error(p, "couple_stress_2", couple_stress))
        errors["shear stress"].append(
            l2_error(p, "stress_12", lambda x, y: 0.0))
    for name, list_of_errors in errors.items():
        check.order(f"{element} {name}", list_of_errors,
                    couple_order if "stress" in name else order)

# The values in the middle to the digits given, between the nearest points of a
# fine grid: the parabola that they lie on is exact for these elements.
p = run("Q2/Q2 full", 160).points()
for column, expected in (("micro_rotation", 1.175201194),
                         ("displacement_1", -0.325848381)):
    near = sorted({(round(y, 9), round(value / SMALL, 12)) for y, value in
                   zip(p["Y"], p[column])}, key=lambda pair: abs(pair[0] - 0.5))
    below = [pair for pair in near if pair[0] < 0.5][:3]
    value = 0.0
    for i, (y, v) in enumerate(below):
        weight = 1.0
        for j, (other, _) in enumerate(below):
            if i != j:
                weight *= (0.5 - other) / (y - other)
        value += weight * v
    check.close(f"{column} at y = .5", value, expected, absolute=2e-8)
check.finish()
