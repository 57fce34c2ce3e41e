#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cantilever (prm/benchmarks/cantilever, reference B6) on cells of 0.5 m in
25 steps, and on 2 ranks: a regression. The case itself, at the points that bear
the load, is within 2 % of the elastica."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
CASE = "../../prm/benchmarks/cantilever/case.prm"
CELL = 0.5  # m


def columns(points, cell):
    """Displacements of the last two columns of points, between the two points
    beside the middle."""
    result = []
    for column in (0, 1):
        x = 10 - cell / 12 - column * cell / 6
        beside = [(u, v) for X, Y, u, v in zip(
            points["X"], points["Y"], points["displacement_1"],
            points["displacement_2"])
            if abs(X - x) < 1e-6 and abs(Y - 0.5) < cell / 10]
        assert len(beside) == 2
        result.append([sum(pair) / 2 for pair in zip(*beside)])
    return result


def tip(points):
    """Displacements of the middle of the end: linear from the two last columns
    of points."""
    return [1.5 * last - 0.5 * before
            for last, before in zip(*columns(points, CELL))]


for ranks in (1, 2):
    run = check.run(CASE, f"{ranks}_ranks",
                    [f"Grid/Cells={10 / CELL:g}, {1 / CELL:g}",
                     f"Grid/Margin cells=0, 1, {9 / CELL:g}, 1",
                     f"Loading/Body force 2=if (x > 10 - {CELL}/6, "
                     f"-100e3 / ({CELL}/6) * s, 0)",
                     "Loading/Initial step=0.04", "Loading/Largest step=0.04",
                     "Solver/Residual=1e-10", "Output/Fields every=0"], ranks)
    u1, u2 = tip(run.points())
    # made by this program; converged finite elements: 8.253 and 5.540 m
    check.close(f"{ranks} ranks: deflection", -u2, 8.164900205, relative=1e-6)
    check.close(f"{ranks} ranks: shortening", -u1, 5.43271137, relative=1e-6)
    # what the wall carries
    check.close(f"{ranks} ranks: force of the wall",
                run.history["left force 2 [N/m]"][-1], 100e3, relative=1e-8)

u1, u2 = columns(check.run(CASE, "case", ["Output/Fields every=0"]).points(),
                 0.25)[0]
check.close("the case: deflection where the load acts", -u2, 8.062,
            relative=0.02)
check.close("the case: shortening where the load acts", -u1, 5.461,
            relative=0.02)
check.finish()
