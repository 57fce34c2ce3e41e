#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Hencky column that its weight compresses to less than half its height.

The nominal stress carries what is above: sigma_22 = -gamma (L - Y) at the
initial height Y, because the width stays. With s = gamma (L - Y)/M and the
modulus M = lambda + 2 mu of lateral restraint, ln(a)/a = -s has the solution
a = W(s)/s for the stretch a; the height is L (W + W^2/2)/s at the foot's s.
A column of Q1 cells has the exact stress in the middle of each cell, with the
exact stretch there.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

LENGTH, GAMMA, M = 50.0, 800.0, 10e3
FOOT = GAMMA * LENGTH / M
HEIGHT = 24.059646


def lambert(s):
    """W exp(W) = s by Newton's method."""
    w = math.log(1 + s)
    for _ in range(50):
        w -= (w - s * math.exp(-w)) / (1 + w)
    return w


def settings(element, cells, nu):
    young = M * (1 + nu) * (1 - 2 * nu) / (1 - nu)
    return element_settings(element) + [
        f"Grid/Cells=1, {cells}", f"Materials/solid/Young modulus={young!r}",
        f"Materials/solid/Poisson ratio={nu}"]


def stress_error(points):
    """Mean of |sigma_22 - exact| over the initial volume, by the foot's."""
    return sum(abs(s + GAMMA * (LENGTH - y)) * v for s, y, v in zip(
        points["stress_22"], points["Y"], points["initial_volume"])
    ) / (GAMMA * LENGTH * sum(points["initial_volume"]))


foot = lambert(FOOT)
check.close("height, closed form", LENGTH * (foot + foot ** 2 / 2) / FOOT,
            HEIGHT, absolute=1e-6)

for nu in (0, 0.3):
    K0 = nu / (1 - nu)
    for cells in (16, 32):
        name = f"Q1, nu = {nu}, {cells} cells"
        run = check.run("column.prm", file_name(name),
                        settings("Q1/Q1 full", cells, nu))
        p, h = run.points(), LENGTH / cells
        middle = [(math.floor(y / h) + 0.5) * h for y in p["Y"]]
        s22 = [-GAMMA * (LENGTH - y) for y in middle]
        s = [-x / M for x in s22]
        check.fields(name, 1e-9, s22=(p["stress_22"], s22, M),
                     s11=(p["stress_11"], [K0 * x for x in s22], M),
                     s33=(p["stress_33"], [K0 * x for x in s22], M),
                     s12=(p["stress_12"], 0.0, M),
                     stretch=([v / v0 for v, v0 in
                               zip(p["volume"], p["initial_volume"])],
                              [lambert(x) / x for x in s], 1.0))
        # two Gauss points at h/(2 sqrt 3) from the middle
        check.close(name + ": mean error of the stress", stress_error(p),
                    1 / (2 * math.sqrt(3) * cells), relative=1e-9)

errors = []
for cells in (8, 16, 32):
    run = check.run("column.prm", f"Q2_{cells}",
                    settings("Q2/Q2 full", cells, 0))
    errors.append(stress_error(run.points()))
check.order("Q2: mean error of the stress", errors, 2)
check.close("Q2, 32 cells: height", LENGTH + run.history["top u2 [m]"][-1],
            HEIGHT, absolute=1e-4)

# An initial stress is in balance with the weight: nothing moves.
run = check.run("column.prm", "rest", settings("Q1/Q1 full", 16, 0.3) +
                ["Loading/Body force 2=0",
                 f"Initial state/Grain unit weight={1.6 * GAMMA}",
                 "Initial state/K0=0.7", "Loading/Stop=0.05"])
p = run.points()
check.close("rest: first residual", run.history["force residual [1]"][0], 0.0,
            absolute=1e-13)
check.fields("rest", 1e-12, s22=(p["stress_22"],
                                 [-GAMMA * (LENGTH - y) for y in p["Y"]], M),
             s11=(p["stress_11"],
                  [-0.7 * GAMMA * (LENGTH - y) for y in p["Y"]], M),
             u2=(p["displacement_2"], 0.0, LENGTH))
check.finish()
