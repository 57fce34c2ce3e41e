#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the displacements of the tip and draws the points of all files of
fields: plot.py RESULTS [picture.png]

The tip is the middle of the end, of which the two last columns of points give
the displacements linearly."""

import pathlib
import sys

import h5py
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

with h5py.File(sorted(pathlib.Path(sys.argv[1]).glob("points-*.h5"))[-1]) as f:
    u = [f["displacement_1"][()], f["displacement_2"][()]]
    x = f["position_1"][()] - u[0]
    y = abs(f["position_2"][()] - u[1] - 0.5)
ends = sorted(set(x.round(9)))
last, before = [[component[(abs(x - end) < 1e-6) & (y < y.min() + 1e-6)].mean()
                 for component in u] for end in (ends[-1], ends[-2])]
out = (10 - ends[-1]) / (ends[-1] - ends[-2])
tip = [a + out * (a - b) for a, b in zip(last, before)]
print(f"tip: deflection {-tip[1]:.3f} m, shortening {-tip[0]:.3f} m; "
      f"last points: {-last[1]:.3f} m, {-last[0]:.3f} m")
if len(sys.argv) < 3:
    sys.exit()

figure, axes = plt.subplots(figsize=(6, 5.2))
for file in sorted(pathlib.Path(sys.argv[1]).glob("points-*.h5")):
    with h5py.File(file) as f:
        shown = axes.scatter(f["position_1"], f["position_2"], s=1.5, lw=0,
                             c=f["stress_11"][()] / 1e6, cmap="coolwarm",
                             vmin=-2.5, vmax=2.5)
figure.colorbar(shown, label="stress 11 [MPa]")
axes.set_aspect("equal")
axes.set_xlabel("x [m]")
axes.set_ylabel("y [m]")
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
