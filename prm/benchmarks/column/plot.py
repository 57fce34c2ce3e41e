#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the mean error of the vertical stress and draws it over the points'
initial height, and the errors over the number of cells:
plot.py RESULTS [picture.png]"""

import pathlib
import sys

import h5py
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

LENGTH, GAMMA = 50.0, 800.0  # m, N/m3
CELLS = (16, 32, 64)
OURS = (2.827e-3, 9.058e-4, 3.761e-4)    # README.md
AMPLE = (3.659e-3, 1.0487e-3, 4.357e-4)  # AMPLE 1.1

with h5py.File(sorted(pathlib.Path(sys.argv[1]).glob("points-*.h5"))[-1]) as f:
    initial = f["position_2"][()] - f["displacement_2"][()]
    stress = f["stress_22"][()]
    volume = f["initial_volume"][()]

error = abs(stress + GAMMA * (LENGTH - initial)) * volume
print(f"{len(stress)} points, mean error of the stress over that at the foot: "
      f"{error.sum() / (GAMMA * LENGTH * volume.sum()):.4e}")
if len(sys.argv) < 3:
    sys.exit()

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.6))
left.plot([-GAMMA * LENGTH / 1e3, 0], [0, LENGTH], "k-", lw=1, label="exact")
left.plot(stress / 1e3, initial, "r.", ms=3, label="points")
left.set_xlabel("vertical stress [kPa]")
left.set_ylabel("initial height [m]")
left.legend()
right.loglog(CELLS, AMPLE, "ks--", label="AMPLE 1.1")
right.loglog(CELLS, OURS, "ro-", label="Riedel")
right.set_xlabel("cells")
right.set_ylabel("mean error of the stress")
right.set_xticks(CELLS, [str(n) for n in CELLS])
right.minorticks_off()
right.legend()
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
