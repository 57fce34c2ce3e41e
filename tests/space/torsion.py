#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Torsion of a micropolar cylinder (benchmark A5): the moment over that of the
classical cylinder, mu pi a^4/2 times the twist, for three sets of constants.

Cells have straight edges: the section is a polygon, whose own classical moment
is taken on the same grid. What is left of its edges is of second order.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name
import cylinder

check = Check(__doc__)
SOLID = "Materials/solid/"


def moment(n, radius, settings):
    grid = check.results / f"cylinder_{n}_{radius:g}.inp"
    cylinder.write(grid, n, radius, 0.25 * radius)
    name = file_name(f"{n} {radius} " + " ".join(settings))
    run = check.run("torsion.prm", name, [f"Geometry/File={grid}"] +
                    element_settings("Q2/Q2 full") + settings)
    return run.history["top moment 3 [N m]"][-1]


for (mu_c, alpha, beta, gamma, radius), expected in {
        (0.5, 0, 0.01, 0.03, 1): 1.11397002,
        (0.5, 0.01, 0, 0.08, 1): 1.22394748,
        (5, 0, 0.005, 0.01, 0.5): 1.17662526}.items():
    ratios = []
    for n in (4, 8):
        polar = moment(n, radius, [SOLID + f"Couple modulus={mu_c}",
                                   SOLID + f"Curvature modulus alpha={alpha}",
                                   SOLID + f"Curvature modulus beta={beta}",
                                   SOLID + f"Bending modulus={gamma}"])
        classical = moment(n, radius, [SOLID + "Law=neo-Hookean"] +
                           [f"Boundary conditions/{end}/Rotation 3="
                            for end in ("bottom", "top")])
        ratios.append(polar / classical)
    name = f"mu_c = {mu_c}, radius {radius} m"
    check.order(f"{name}, polygons of 16 and 32 edges",
                [abs(ratio - expected) for ratio in ratios], 2)
    check.close(f"{name}, extrapolated to the circle",
                ratios[1] + (ratios[1] - ratios[0]) / 3, expected,
                relative=1e-4)
check.finish()
