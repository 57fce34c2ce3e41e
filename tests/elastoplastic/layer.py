#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Softening layer between rough walls (benchmarks C2): shear stress after the
peak and extent of the plastic zone."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

WIDTH, SMALL = 2.5, 1e-3  # of the scene; strains relative to the reference
PEAK = 100.1088
REFERENCE = {3: 96.660, 4: 87.822, 5: 72.469}

errors = []
for cells in (20, 40, 80):
    result = check.run("layer.prm", file_name(f"layer {cells}"),
                       element_settings("Q2/Q1 full") +
                       [f"Grid/Cells=1, {cells}"])
    history = result.history
    tau = [f / WIDTH / SMALL for f in history["top force 1 [N/m]"]]
    at = {round(5 * s, 6): t for s, t in zip(history["load [1]"], tau)}
    errors.append(abs(at[5] - REFERENCE[5]))
    if cells == 80:
        check.close("largest stress", max(tau), PEAK, relative=5e-4)
        for u, expected in REFERENCE.items():
            check.close(f"stress at U = {u} mm", at[u], expected,
                        relative=2e-3)
        p = result.points()
        plastic = [y for y, a in zip(p["Y"], p["plastic_multiplier"])
                   if a > 0]
        check.close("plastic extent [mm]", max(plastic) - min(plastic), 53.4,
                    absolute=1.5)
        for name in ("points at the apex [1]", "unregularised points [1]",
                     "points without strength [1]"):
            check.close(name, max(history[name]), 0)
        check.note("points yield, 0 of them at the apex" in result.text,
                   "the summary counts yielding points")
print("      errors of the stress at the end: " +
      ", ".join(f"{e:.3f}" for e in errors))
check.order("stress at the end", errors, 2)
check.finish()
