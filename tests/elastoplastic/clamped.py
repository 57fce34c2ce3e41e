#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finite shear of an elastic layer with clamped rotation (benchmarks B3):
nominal stresses and the rotation in the middle."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

WIDTH = 0.02
REFERENCE = {0.1: (.1088727, -.0002402, -.0525626),
             0.5: (.5429189, -.0057161, -.2576609),
             1.0: (1.0783906, -.0199336, -.4866356)}


def middle(points):
    """The rotation at half height: it is that of the points in the middle
    section of a cell, since the number of cells is odd."""
    nearest = min(points["Y"], key=lambda y: abs(y - 0.5))
    values = [w for y, w in zip(points["Y"], points["micro_rotation"])
              if abs(y - nearest) < 1e-9]
    check.note(abs(nearest - 0.5) < 1e-9, f"points at half height: {nearest}")
    return sum(values) / len(values)


errors = []
for cells in (25, 51, 101):
    result = check.run("clamped.prm", file_name(f"clamped {cells}"),
                       element_settings("Q2/Q2 full") +
                       [f"Grid/Cells=1, {cells}"])
    history = result.history
    row = {round(s, 9): i for i, s in enumerate(history["load [1]"])}
    error = 0.0
    for points in result.all_points():
        load = round(points["load"], 9)
        if load not in REFERENCE:
            continue
        ours = (history["top force 1 [N/m]"][row[load]] / WIDTH,
                history["top force 2 [N/m]"][row[load]] / WIDTH,
                middle(points))
        error = max(error, *(abs(a - b) for a, b in
                             zip(ours, REFERENCE[load])))
        if cells == 101:
            for name, a, b in zip(("P12", "P22", "rotation"), ours,
                                  REFERENCE[load]):
                check.close(f"U = {load}: {name}", a, b, absolute=2e-7)
    errors.append(error)
print("      largest errors: " + ", ".join(f"{e:.1e}" for e in errors))
check.finish()
