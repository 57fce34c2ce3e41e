#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""An infinite layer between rough walls (benchmarks D4): the scene of prm/benchmarks/layer against an independent
program, and the tie of its sides."""

import importlib.util
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/benchmarks/layer"
specification = importlib.util.spec_from_file_location("plot", SCENE / "plot.py")
plot = importlib.util.module_from_spec(specification)
specification.loader.exec_module(plot)

check = Check(__doc__)
run = check.run(SCENE / "case.prm", "layer")
load, tau = plot.stress(run.folder)
at, largest = plot.peak(load, tau)
check.close("largest shear stress [kPa]", largest, plot.PEAK[1], 0.0, 0.01)
check.close("at U/h", at, plot.PEAK[0], 0.0, 0.0002)
for s, expected in zip(plot.LOADS, plot.EXPECTED):
    ours = min(zip(load, tau), key=lambda pair: abs(pair[0] - s))
    check.close(f"shear stress at U/h = {ours[0]:.4f} [kPa]", ours[1], expected, 0.0, 0.03)
check.close("width of |w| > 50 % at U/h = 0.5 [d50]", plot.width(run.folder, 0.5) / 0.5e-3, 5.06, 0.0, 0.01)
check.close("width of |w| > 5 % at U/h = 0.5 [d50]", plot.width(run.folder, 0.05) / 0.5e-3, 11.1, 0.0, 0.05)

# larger grains and looser sand; the two or three digits of the independent program are cut off, not rounded
for name, sets, d50, at_50, at_5 in (
        ("grains of 1 mm", ["Materials/sand/Mean grain diameter=1e-3"], 1e-3, 4.74, 11.6),
        ("e0 = 0.75, K0 = 0.4", ["Initial state/Void ratio=0.75", "Initial state/K0=0.4"], 0.5e-3, 12.7, 31.3)):
    other = check.run(SCENE / "case.prm", name.split(",")[0].replace(" ", "_"), sets + ["Loading/Stop=0.5"])
    check.close(f"{name}: width of |w| > 50 % [d50]", plot.width(other.folder, 0.5) / d50, at_50, 0.0, 0.01)
    check.close(f"{name}: width of |w| > 5 % [d50]", plot.width(other.folder, 0.05) / d50, at_5, 0.0, 0.1)

# Nothing depends on x, up to the residual that is left in a step (1e-6): what rounding brings in grows in softening.
points = run.points()
rows = {}
for y, w in zip(points["Y"], points["micro_rotation"]):
    rows.setdefault(round(y, 9), []).append(w)
scale = max(map(abs, points["micro_rotation"]))
spread = max(max(row) - min(row) for row in rows.values())
check.note(spread < 1e-6 * scale and min(map(len, rows.values())) == 3,
           f"rotations at one height differ by {spread / scale:.1e} of the largest")
check.finish()
