#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coulomb friction of a plate: stick below tan(phi) times the normal force,
tan(phi) times the normal force when all points slide; a smooth plate has no
tangential force, a rough one more; the same on two ranks."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
TAN = math.tan(math.radians(20))
F1, F2 = "stamp force 1 [N/m]", "stamp force 2 [N/m]"
CONTACTS, SLIDING = "stamp contacts [1]", "stamp sliding [1]"

coulomb = check.run("sliding.prm", "coulomb")
h = coulomb.history
check.fields("balance of forces", 1e-8,
             f1=([a + b for a, b in zip(h[F1], h["bottom force 1 [N/m]"])], 0.0,
                 max(h[F1])),
             f2=([a + b for a, b in zip(h[F2], h["bottom force 2 [N/m]"])], 0.0,
                 -min(h[F2])))
pressed = h["load [1]"].index(min(h["load [1]"], key=lambda s: abs(s - 0.5)))
check.close("no tangential force before the plate moves sideways",
            h[F1][pressed], 0.0, absolute=-1e-8 * h[F2][pressed])
first = pressed + 1
check.note(0.0 < h[F1][first] < -0.9 * TAN * h[F2][first] and
           h[SLIDING][first] < h[CONTACTS][first],
           f"the first step sticks: {h[F1][first]:.1f} N/m, "
           f"{h[SLIDING][first]:g} of {h[CONTACTS][first]:g} points slide")
check.note(h[CONTACTS][-1] > 0 and h[SLIDING][-1] == h[CONTACTS][-1],
           "all points slide at the end")
check.close("tangential over normal force", -h[F1][-1] / h[F2][-1], TAN,
            relative=1e-9)

two = check.run("sliding.prm", "two_ranks", ranks=2).history
for name in (F1, F2, "stamp moment [N]"):
    check.fields(f"two ranks: {name}", 1e-7, force=(
        two[name], h[name], max(abs(x) for x in h[name])))

smooth = check.run("sliding.prm", "smooth",
                   ["Plates/stamp/Friction angle=0"]).history
check.close("smooth", smooth[F1][-1], 0.0, absolute=-1e-8 * smooth[F2][-1])

rough = check.run("sliding.prm", "rough",
                  ["Plates/stamp/Friction angle=rough"])
check.note(rough.history[F1][-1] > 1.1 * h[F1][-1] and
           max(rough.history[SLIDING]) == 0.0, "a rough plate does not slide")
points = rough.points()
# the middles of the boxes are half a box below the plate
moved = [u for u, t in zip(points["displacement_1"],
                           points["contact_traction_2"]) if t < 0.0]
check.fields("points at a rough plate move with it", 0.1,
             u1=(moved, 0.02, 0.02))
check.finish()
