#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane strain compression with softening: a slab of one cell in space and the
same in the plane, by finite elements and by material points, on 1 and 2 ranks.

The plane 1-2 of the strip is the plane 1-3 of the slab: a rotation from axis 1
to axis 3 is negative about axis 2.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

THICKNESS = 0.0075  # m


def compare(name, strip, slab, relative):
    force = [f * THICKNESS for f in strip.history["top force 2 [N/m]"]]
    largest = max(map(abs, force))
    yielding = strip.history["yielding points [1]"][-1]
    check.note(abs(force[-1]) < 0.99 * largest,
               f"{name}: force falls from {largest:.1f} N to {-force[-1]:.1f} N "
               f"with {yielding:g} yielding points")
    check.fields(f"{name}, history", relative,
                 force=(slab.history["top force 3 [N]"], force, largest),
                 u1=(slab.history["right u1 [m]"], strip.history["right u1 [m]"],
                     abs(strip.history["right u1 [m]"][-1])),
                 work=(slab.history["stress work [J]"],
                       [w * THICKNESS for w in strip.history["stress work [J/m]"]],
                       THICKNESS * strip.history["stress work [J/m]"][-1]))

    p, q = strip.points(), slab.points()
    # for every point of the strip those of the slab that lie behind it
    plane, space = {}, {}
    for i, (x, y) in enumerate(zip(p["X"], p["Y"])):
        plane[round(x, 9), round(y, 9)] = i
    for i, (x, z) in enumerate(zip(q["X"], q["Z"])):
        space.setdefault((round(x, 9), round(z, 9)), []).append(i)
    check.note(plane.keys() == space.keys(),
               f"{name}: {len(p['X'])} points and {len(q['X'])} behind them")
    pairs = [(plane[place], i) for place in plane for i in space[place]]
    fields = {}
    for ours, theirs, sign in (("stress_11", "stress_11", 1),
                               ("stress_33", "stress_22", 1),
                               ("stress_22", "stress_33", 1),
                               ("stress_13", "stress_12", 1),
                               ("stress_31", "stress_21", 1),
                               ("couple_stress_21", "couple_stress_1", -1),
                               ("couple_stress_23", "couple_stress_2", -1),
                               ("micro_rotation_2", "micro_rotation", -1),
                               ("displacement_1", "displacement_1", 1),
                               ("displacement_3", "displacement_2", 1),
                               ("plastic_multiplier", "plastic_multiplier", 1)):
        expected = [sign * p[theirs][i] for i, _ in pairs]
        fields[ours] = ([q[ours][j] for _, j in pairs], expected,
                        max(map(abs, expected)))
    check.fields(f"{name}, points", relative, **fields)


for element, cells, above in (("Q1/Q1 assumed", 8, 16), ("Q2/Q2 assumed", 4, 8)):
    settings = element_settings(element)
    compare(element,
            check.run("strip.prm", file_name(f"strip {element}"),
                      settings + [f"Grid/Cells={cells}, {above}"]),
            check.run("slab.prm", file_name(f"slab {element}"),
                      settings + [f"Grid/Cells={cells}, 1, {above}"]), 1e-6)
MOVING = ["Grid/Reference configuration=current"]
compare("points", check.run("strip.prm", "strip_points", MOVING),
        check.run("slab.prm", "slab_points", MOVING), 1e-6)

for name, settings in (("Q1/Q1 assumed", element_settings("Q1/Q1 assumed")),
                       ("points", MOVING)):
    one = check.run("slab.prm", file_name(f"{name} 1 rank"), settings).history
    two = check.run("slab.prm", file_name(f"{name} 2 ranks"), settings,
                    ranks=2).history
    columns = [c for c in one if max(map(abs, one[c])) > 1e-8 and
               (" force " in c or " u" in c or "work" in c)]
    check.fields(f"{name}, {len(columns)} columns on 1 and 2 ranks", 1e-8, **{
        c: (two[c], one[c], max(map(abs, one[c]))) for c in columns})
check.finish()
