#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure and traction, on the current and the initial area, as integral over
the surface and as virtual stress.

Closed form for a uniform state: the law integrates to
sigma = lambda tr(e) + 2 mu e with logarithmic strains e.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)

LAME, MU, P, WIDTH, HEIGHT = 1500.0, 1000.0, 1000.0, 0.2, 0.1
TOP = "Boundary conditions/top/"
FREE = ["Boundary conditions/right/Displacement 1="]
LOADS = {
    "pressure, surface integral": [TOP + "Load form=surface integral"],
    "pressure, virtual stress": [TOP + "Load form=virtual stress"],
    "traction": [TOP + "Pressure=", TOP + f"Traction 2=-{P} * s"],
}


def strains(free_side, area):
    """Logarithmic strains 1 and 2."""
    if not free_side:
        return 0.0, -P / (LAME + 2 * MU)
    ratio = -LAME / (LAME + 2 * MU)
    stiffness = LAME + 2 * MU + LAME * ratio
    e2 = 0.0
    for _ in range(200):  # a contraction
        e2 = -P * (math.exp(-ratio * e2) if area == "initial" else 1) / stiffness
    return ratio * e2, e2


for free_side in (False, True):
    for area in ("current", "initial"):
        e1, e2 = strains(free_side, area)
        s22 = LAME * (e1 + e2) + 2 * MU * e2
        for load, settings in LOADS.items():
            name = (f"{load}, {area} area, "
                    f"{'free' if free_side else 'held'} side")
            result = check.run("pressure.prm", file_name(name),
                               settings + (FREE if free_side else []) +
                               [TOP + f"Pressure acts on={area} area"])
            p, history = result.points(), result.history
            check.fields(
                name, 1e-9, s22=(p["stress_22"], s22, P),
                s11=(p["stress_11"], LAME * (e1 + e2) + 2 * MU * e1, P),
                s12=(p["stress_12"], 0.0, P), s21=(p["stress_21"], 0.0, P),
                top=(history["top u2 [m]"][-1:],
                     HEIGHT * (math.exp(e2) - 1), HEIGHT),
                right=(history["right u1 [m]"][-1:],
                       WIDTH * (math.exp(e1) - 1), WIDTH),
                bottom=(history["bottom force 2 [N/m]"][-1:],
                        -s22 * WIDTH * math.exp(e1), P * WIDTH),
                top_force=(history["top force 2 [N/m]"][-1:],
                           s22 * WIDTH * math.exp(e1), P * WIDTH))

# A stress in equilibrium with the pressure is so from the beginning.
for load, settings in LOADS.items():
    result = check.run("pressure.prm", file_name("rest " + load),
                       [TOP + "Pressure=" + str(P)] +
                       [s.replace(" * s", "") for s in settings] + FREE +
                       [f"Boundary conditions/right/Pressure={P / 2}",
                        "Boundary conditions/right/Load form=" +
                        ("virtual stress" if "virtual" in load
                         else "surface integral"),
                        f"Initial state/Vertical pressure at top={P}",
                        "Loading/Stop=0.2"])
    history, p = result.history, result.points()
    check.close(f"rest, {load}: first residual",
                history["force residual [1]"][0], 0.0, absolute=1e-13)
    check.fields(f"rest, {load}", 1e-10, s22=(p["stress_22"], -P, P),
                 s11=(p["stress_11"], -P / 2, P),
                 u2=(p["displacement_2"], 0.0, HEIGHT))
check.finish()
