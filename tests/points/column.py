#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The column under its own weight (prm/benchmarks/column, reference B5).

Error: sum |s22 - exact| V0/(foot's stress V), exact = -800 (50 - Y) Pa. Without
surface stabilisation the method is that of AMPLE 1.1, whose errors are met to
all their digits; with it the errors are smaller.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
CASE = "../../prm/benchmarks/column/case.prm"
LENGTH, GAMMA = 50.0, 800.0  # m, N/m3
HEIGHT = 24.059646  # m, closed form (elastic/column)
AMPLE = {16: 3.659e-3, 32: 1.0487e-3, 64: 4.357e-4}


def run(cells, stabilisation):
    return check.run(CASE, f"{cells}_{stabilisation}",
                     [f"Grid/Cells=1, {cells}",
                      f"Geometry/Box={LENGTH / cells!r}, {LENGTH}",
                      f"Material points/Surface stabilisation={stabilisation}"])


def error(points):
    return sum(abs(s + GAMMA * (LENGTH - y)) * v for s, y, v in zip(
        points["stress_22"], points["Y"], points["initial_volume"])
    ) / (GAMMA * LENGTH * sum(points["initial_volume"]))


errors = []
for cells, published in AMPLE.items():
    check.close(f"{cells} cells without stabilisation: error",
                error(run(cells, 0).points()), published, relative=2e-4)
    result = run(cells, 0.1)
    errors.append(error(result.points()))
    check.note(errors[-1] <= published,
               f"{cells} cells: error {errors[-1]:.4e}, at most {published:g}")
    check.close(f"{cells} cells: height",
                LENGTH + result.history["top u2 [m]"][-1], HEIGHT,
                absolute=0.4 / cells)
# at least 1.2 between every two grids
for coarse, fine in zip(errors, errors[1:]):
    check.order("mean error of the stress", [coarse, fine], 1.4)
check.finish()
