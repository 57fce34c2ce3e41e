#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that move through a grid which follows the shear bands, on 1, 2 and 3
ranks: the same history to 1e-8 before the first change of the grid and to 1e-3
of the peak after it. Points are split where cells become small; mass stays."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
COLUMNS = ("left force 1 [N/m]", "right force 1 [N/m]", "bottom force 2 [N/m]",
           "top u2 [m]", "volume [m2]", "external work [J/m]")

reference = check.run("moving.prm", "one_rank").history
changes = reference["grid changes [1]"]
peak = max(abs(value) for value in reference["left force 1 [N/m]"])
first = changes.index(1)

check.note(changes[-1] >= 2, f"{changes[-1]:g} changes of the grid")
splits = reference["split points [1]"][-1]
check.note(splits > 0, f"{splits:g} points split")
check.close("points", reference["points [1]"][-1],
            reference["points [1]"][0] + splits)
check.fields("mass and force at the top", 1e-9,
             mass=(reference["mass [kg/m]"], reference["mass [kg/m]"][0],
                   reference["mass [kg/m]"][0]),
             force=(reference["top force 2 [N/m]"], -10000.0, 10000.0))
jumps = [abs(value) / peak for value in reference["force jump at change [N/m]"]]
check.note(max(jumps) < 1e-2, f"largest jump of P1 {max(jumps):.1e} of the peak")
check.note(sum(jumps) < 1e-3 * changes[-1],
           f"mean jump of P1 {sum(jumps) / changes[-1]:.1e} of the peak")

for ranks in (2, 3):
    history = check.run("moving.prm", f"{ranks}_ranks", [], ranks).history
    before, after = {}, {}
    for column in COLUMNS:
        ours, expected = history[column], reference[column]
        before[column] = ([a / b for a, b in zip(ours[1:first], expected[1:first])],
                          1.0, 1.0)
        after[column] = (ours[first:], expected[first:], max(map(abs, expected)))
    check.fields(f"{ranks} ranks, before the first change", 1e-8, **before)
    check.fields(f"{ranks} ranks, after it", 1e-3, **after)
    for column in ("points [1]", "grid changes [1]", "cells [1]"):
        check.close(f"{ranks} ranks: {column}", history[column][-1],
                    reference[column][-1])
check.finish()
