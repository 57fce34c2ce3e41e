#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grid that becomes fine and coarse again while shear bands form, under points
that move through it: halving and merging keep volume, mass and solid volume, and
the history is smooth."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
FORCE = "left force 1 [N/m]"

run = check.run("following.prm", "following")
history = run.history
peak = max(history[FORCE])
cells = history["cells [1]"]
refined = sum(b > a for a, b in zip(cells, cells[1:]))
coarsened = sum(b < a for a, b in zip(cells, cells[1:]))
check.note(refined > 2 and coarsened > 1,
           f"the grid became finer {refined} times and coarser {coarsened} "
           f"times: {cells[0]:g} to {max(cells):g} cells")
split, merged = (history[f"{what} points [1]"][-1]
                 for what in ("split", "merged"))
check.note(split > 100 and merged > 50,
           f"{split:g} points split, {merged:g} merged")
check.close("points", history["points [1]"][-1],
            history["points [1]"][0] + split - merged)
for what in ("volume", "solid volume", "mass"):
    drift = max(map(abs, history[f"{what} drift [1]"]))
    check.note(drift < 1e-13, f"drift of {what} by splitting and merging: "
               f"{drift:.1e}")
check.fields("since the start", 1e-9,
             mass=(history["mass [kg/m]"], history["mass [kg/m]"][0],
                   history["mass [kg/m]"][0]))
solids = history["solid volume [m2]"]
check.note(abs(solids[-1] / solids[0] - 1.0) < 1e-6,
           f"solid volume since the start: {solids[-1] / solids[0] - 1.0:.1e}")
check.close("steps that were cut", history["cuts [1]"][-1], 0)
jump = max(map(abs, history["force jump at change [N/m]"])) / peak
check.note(jump < 0.02, f"largest jump of P1 {jump:.1e} of the peak")

# the same without merging, and without coarsening
for name, setting, tolerance in (
        ("without merging", "Material points/Merge above points per cell=0",
         0.02),
        ("without coarsening", "Adaptation/Coarsen below=0", 0.03)):
    other = check.run("following.prm", name.replace(" ", "_"), [setting]).history
    worst = max(abs(a - b) / peak
                for a, b in zip(history[FORCE], other[FORCE]))
    check.note(worst < tolerance, f"P1 differs from that {name} by "
               f"{worst:.1e} of the peak at most")
    check.close(f"{name}: load", other["load [1]"][-1], 0.4)
check.finish()
