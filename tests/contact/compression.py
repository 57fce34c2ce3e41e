#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plate compresses a block between smooth walls as a wall would.

Under lateral restraint a stretch a gives sigma_22 = M ln(a)/a in a Hencky
solid, M = lambda + 2 mu, everywhere. The block's height is that below the
plate plus the penetration, which grows by dp/k in a step. The stiffness is
k = penalty 2 mu / (box length a^2): the penetration is between p/k of the
first and of the last step. Checkpoints on the way change nothing.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)

E, NU, HEIGHT, WIDTH, BOX = 1e6, 0.25, 0.1, 0.1, 0.01
MU = E / (2 * (1 + NU))
M = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))

for penalty in (1, 10, 1000):
    run = check.run("compression.prm", f"penalty_{penalty}",
                    [f"Plates/stamp/Penalty={penalty}"])
    history, points = run.history, run.points()
    force, moment = history["stamp force 2 [N/m]"][-1], \
        history["stamp moment [N]"][-1]
    a = points["volume"][0] / points["initial_volume"][0]
    name = f"penalty {penalty}"
    stress = M * math.log(a) / a
    check.fields(f"{name}: uniform", 1e-8,
                 s22=(points["stress_22"], stress, -stress),
                 s12=(points["stress_12"], 0.0, -stress),
                 stretch=([v / v0 for v, v0 in zip(
                     points["volume"], points["initial_volume"])], a, 1.0))
    check.close(f"{name}: force", force, WIDTH * stress, relative=1e-8)
    check.close(f"{name}: force on the floor",
                history["bottom force 2 [N/m]"][-1], -force, relative=1e-8)
    check.close(f"{name}: moment", moment, force * WIDTH / 2, relative=1e-8)
    check.close(f"{name}: displacement", history["stamp u2 [m]"][-1], -0.03)
    penetration = HEIGHT * a - (HEIGHT - 0.03)
    softest = -stress * BOX / (penalty * 2 * MU)
    check.note(softest * a ** 2 < penetration < softest,
               f"{name}: penetration {penetration:.3e} m between "
               f"{softest * a ** 2:.3e} and {softest:.3e} m")
    top = sorted(points["Y"])[-1]
    check.fields(f"{name}: contact traction", 1e-8, traction=(
        points["contact_traction_2"],
        [stress if y > top - BOX / 2 else 0.0 for y in points["Y"]], -stress))
    check.note(history["stamp contacts [1]"][-1] == 10.0,
               f"{name}: ten points touch the plate")
    check.close(f"{name}: energy balance", history["energy error [1]"][-1], 0.0,
                absolute=1e-3)

# the equations are built anew at a checkpoint, as on a new grid
saved = check.run("compression.prm", "checkpoints",
                  ["Plates/stamp/Penalty=1000", "Checkpoint/Every steps=3"])
check.fields("penalty 1000, with checkpoints", 1e-8, force=(
    saved.history["stamp force 2 [N/m]"], history["stamp force 2 [N/m]"],
    WIDTH * M))

wall = check.run("compression.prm", "wall", [
    "Grid/Margin cells=0, 0, 0, 0",
    "Boundary conditions/top/Displacement 2=-0.03 * s",
    "Plates/stamp/Box=-0.01, 0.2 : 0.11, 0.22"])
check.close("penalty 1000: force of a wall", force,
            wall.history["top force 2 [N/m]"][-1], relative=2e-3)
check.note(wall.history["stamp contacts [1]"][-1] == 0.0 and
           wall.history["stamp force 2 [N/m]"][-1] == 0.0,
           "a plate that does not arrive has no force")
check.finish()
