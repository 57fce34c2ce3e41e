#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch tests in space at finite strain and finite rotation of the grains:
distorted cells, hanging nodes, material points, one and two ranks."""

import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name
import neo_hookean

check = Check(__doc__)

ROTATION = numpy.array([0.06, -0.12, 0.04])
SHEARED = numpy.array([[0.10, 0.05, -0.03], [-0.02, -0.06, 0.08],
                       [0.04, 0.02, -0.09]])
STRETCHED = numpy.diag([0.10, -0.06, -0.09])

for element in ("Q1/Q1 full", "Q1/Q1 mean dilatation", "Q1/Q1 assumed",
                "Q2/Q1 full", "Q2/Q2 assumed"):
    for grid, ranks in (("patch", 1), ("hanging", 1), ("hanging", 2)):
        if ranks > 1 and element != "Q1/Q1 assumed":
            continue
        name = f"{element}, {grid}, {ranks} ranks"
        run = check.run(f"{grid}.prm", file_name(name),
                        element_settings(element) +
                        neo_hookean.couple_settings(SHEARED, ROTATION, 2), ranks)
        if grid == "hanging":
            check.note(run.history["cells [1]"][-1] > 7,
                       f"{name}: the grid is refined")
        check.fields(name, 1e-8, **neo_hookean.errors(run.points(), SHEARED,
                                                      ROTATION))

for sampling, ranks in (("full", 1), ("mean dilatation", 1), ("assumed", 1),
                        ("assumed", 2)):
    name = f"points, {sampling}, {ranks} ranks"
    run = check.run("points.prm", file_name(name),
                    [f"Grid/Strain sampling={sampling}"] +
                    neo_hookean.couple_settings(STRETCHED, ROTATION, 4), ranks)
    check.fields(name, 1e-8, **neo_hookean.errors(run.points(), STRETCHED,
                                                  ROTATION))
check.finish()
