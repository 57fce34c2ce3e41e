#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stress concentration at a circular hole (benchmarks A6), on a grid that
becomes finer around it and follows the circle."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from grid_file import graded, write_block
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

TENSION, MU = 1e-3, 1.0
OUTSIDE = 60.0  # its radius; that of the hole is 1
N_ANGLE = 24  # cells along the quarter of the hole
SOLID = "Materials/solid/"


def make_grid(path):
    radii = [1 + d for d in graded(OUTSIDE - 1, 0.5 * math.pi / N_ANGLE, 1.3)]

    def place(i, j):
        angle = 0.5 * math.pi * j / N_ANGLE
        return radii[i] * math.cos(angle), radii[i] * math.sin(angle)

    names = {"low 1": 1, "high 1": 2, "low 2": 3, "high 2": 4}
    write_block(path, len(radii) - 1, N_ANGLE, place, lambda side, k: names[side])


def stress_at_hole(points):
    """sigma_11 at (0, 1) in units of the tension: the parabola through the
    three points nearest to the hole of those nearest to axis 2."""
    places = list(zip(points["X"], points["Y"], points["stress_11"]))
    smallest = min(x / y for x, y, _ in places if y > 0)
    line = sorted((math.hypot(x, y) - 1, stress / TENSION)
                  for x, y, stress in places
                  if y > 0 and x / y < smallest + 1e-6)[:3]
    value = 0.0
    for i, (r, stress) in enumerate(line):
        weight = 1.0
        for j, (other, _) in enumerate(line):
            if i != j:
                weight *= -other / (r - other)
        value += weight * stress
    return value


grid = check.results / "hole.inp"
make_grid(grid)
for share, ratio, expected in ((0.5, 1, 2.391236), (0.5, 3, 2.733214),
                               (0.5, 10, 2.955509), (0.9, 1, 2.118802),
                               (0.9, 3, 2.566090)):
    mu_c = share / (1 - share) * MU
    bending = 4 * MU * mu_c / (MU + mu_c) / ratio ** 2
    name = f"N^2 = {share}, a/c = {ratio}"
    run = check.run("hole.prm", file_name(name),
                    element_settings("Q2/Q2 full") +
                    [f"Geometry/File={grid}",
                     SOLID + f"Couple modulus={mu_c!r}",
                     SOLID + f"Bending modulus={bending!r}"])
    cells = [int(line.split()[2]) for line in run.text.splitlines()
             if line.strip().startswith("new grid:")]
    check.note(bool(cells) and cells[-1] > 1000,
               f"{name}: {cells[-1] if cells else 'no'} cells in the end")
    check.close(f"{name}: stress concentration", stress_at_hole(run.points()),
                expected, relative=5e-3)
check.finish()
