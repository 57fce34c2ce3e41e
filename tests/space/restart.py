#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triaxial cube, resumed after its grid has changed: history and points are
those of a run that goes on, on the same ranks and on others."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)

CASE = "../triaxial_cube/case.prm"
EVERY = ["Checkpoint/Every steps=4"]


def compare(name, ours, reference, relative):
    columns = [c for c in reference.history
               if not c.startswith(("cpu", "sweeps", "factorisations", "iterations"))
               and "residual" not in c and "energy error" not in c]
    # what symmetry makes zero is rounding
    check.fields(f"{name}, {len(columns)} columns", relative, **{
        c: (ours.history[c], reference.history[c],
            max(max(map(abs, reference.history[c])), 1e-3)) for c in columns})
    p, q = ours.points(), reference.points()
    check.fields(f"{name}, points", 10 * relative, **{
        c: (p[c], q[c], max(map(abs, q[c])))
        for c in ("displacement_1", "displacement_3", "stress_33", "stress_13",
                  "micro_rotation_2", "plastic_multiplier")})


for first, then, relative in ((1, 1, 1e-9), (2, 1, 1e-6)):
    name = f"{first}_{then}"
    whole = check.run(CASE, f"whole_{name}", EVERY + ["Loading/Stop=0.3"], first)
    check.run(CASE, f"resumed_{name}", EVERY + ["Loading/Stop=0.2"], first)
    resumed = check.run(CASE, f"resumed_{name}", EVERY + ["Loading/Stop=0.3"], then,
                        resume=True)
    check.contains("the log", resumed.text, "Resumed at s = 0.2")
    compare(f"{first} and {then} ranks", resumed, whole, relative)
check.finish()
