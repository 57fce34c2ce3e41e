#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A block in space under pressure on three faces: as surface integral and as
virtual stress, on the current and on the initial area, finite elements and
material points. Its stress is that of an isotropic stretch a, for which
((lambda/2) (a^6 - 1) + mu (a^2 - 1))/a^3 is minus the pressure, on the current
area, or minus the dead load over a^2."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name
from neo_hookean import LAMBDA, MU

check = Check(__doc__)

LOAD = 1000.0  # Pa
FACES = ("right", "back", "top")


def stress(a):
    return (LAMBDA / 2 * (a ** 6 - 1) + MU * (a ** 2 - 1)) / a ** 3


def stretch(is_dead):
    """By bisection: the stretch under the whole load."""
    low, high = 0.6, 1.0
    for _ in range(100):
        a = 0.5 * (low + high)
        if stress(a) < -LOAD / (a ** 2 if is_dead else 1.0):
            low = a
        else:
            high = a
    return a


for area in ("current area", "initial area"):
    a = stretch(area == "initial area")
    s = stress(a)
    for form, configuration, ranks in (
            ("surface integral", "initial", 1), ("surface integral", "initial", 2),
            ("virtual stress", "initial", 1), ("virtual stress", "current", 2)):
        if (area, configuration) == ("initial area", "current"):
            continue  # free sides of moving points: the area is that of the start
        name = f"{form}, {area}, {configuration}, {ranks} ranks"
        run = check.run("pressure.prm", file_name(name),
                        [f"Grid/Reference configuration={configuration}"] +
                        [f"Boundary conditions/{face}/{entry}={value}"
                         for face in FACES
                         for entry, value in (("Load form", form),
                                              ("Pressure acts on", area))], ranks)
        p = run.points()
        fields = {f"s{i}{j}": (p[f"stress_{i}{j}"], s if i == j else 0.0, LOAD)
                  for i in "123" for j in "123"}
        for i, axis in enumerate("XYZ", 1):
            fields[f"u{i}"] = (p[f"displacement_{i}"],
                               [(a - 1) * x for x in p[axis]], 0.1)
            fields[f"rotation{i}"] = (p[f"micro_rotation_{i}"], 0.0, 1.0)
        check.fields(name, 1e-8, **fields)
check.finish()
