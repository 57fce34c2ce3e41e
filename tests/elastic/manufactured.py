#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Manufactured solution (benchmarks A7) with body force and body couple."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name, l2_error

check = Check(__doc__)


def displacement(x, y):
    return (x * x + y * y) / 2


def rotation(x, y):
    return x - y


def run(element, cells):
    return check.run("manufactured.prm", file_name(f"{element} {cells}"),
                     element_settings(element) +
                     [f"Grid/Cells={cells}, {cells}"]).points()


# On rectangles the strains sampled from 2x2 points are exact, too
for element in ("Q2/Q1 full", "Q2/Q2 full", "Q2/Q2 assumed"):
    p = run(element, 4)
    places = list(zip(p["X"], p["Y"]))
    u = [displacement(*place) for place in places]
    check.fields(element, 1e-9, u1=(p["displacement_1"], u, 0.25),
                 u2=(p["displacement_2"], u, 0.25),
                 rotation=(p["micro_rotation"],
                           [rotation(*place) for place in places], 1.0))

# On the uniform grid of the square Q1/Q1 meets the rotation exactly, since the
# errors of the displacement gradients cancel; so distorted cells are used.
EDGE = "Boundary conditions/edge/"
for element in ("Q1/Q1 full", "Q1/Q1 mean dilatation", "Q1/Q1 assumed"):
    tables = [check.run("patch.prm", file_name(f"distorted {element} {n}"),
                        element_settings(element) +
                        ["Materials/solid/Lame modulus=1500",
                         EDGE + "Displacement 1=(x^2 + y^2)/2 * s",
                         EDGE + "Displacement 2=(x^2 + y^2)/2 * s",
                         EDGE + "Rotation=(x - y) * s",
                         "Loading/Body force 1=-4000 * s",
                         "Loading/Body force 2=-4000 * s",
                         "Loading/Body couple=1000 * (x - y) * s",
                         f"Grid/Refinements={n}"]).points() for n in (2, 3, 4)]
    for what, exact in (("displacement_1", displacement),
                        ("displacement_2", displacement),
                        ("micro_rotation", rotation)):
        check.order(f"{element} {what}",
                    [l2_error(p, what, exact) for p in tables], 2)
check.finish()
