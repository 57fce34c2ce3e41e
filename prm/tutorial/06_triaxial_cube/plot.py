#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws cuts of the cube at two loads: the hardening variable of the points whose
cells a vertical plane meets, on the deformed body.

    prm/tutorial/06_triaxial_cube/plot.py RESULTS [LOAD LOAD]
"""

import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

DEPTHS = (0.005, 0.03, 0.055)  # m, of the cuts behind the front


def states(folder):
    """Points by the load at which they were written."""
    found = {}
    for name in sorted(folder.glob("points-*.h5")):
        with h5py.File(name) as file:
            found[round(float(file.attrs["load"]), 9)] = name
    return found


def draw_cut(axes, name, depth, largest):
    with h5py.File(name) as file:
        place = np.array([file[f"position_{d}"][()] for d in (1, 2, 3)])
        edge = np.cbrt(file["volume"][()])
        value = file["plastic_multiplier"][()]
    here = np.abs(place[1] - depth) <= edge / 2
    x, z, half = (1e3 * a[here] for a in (place[0], place[2], 0.56 * edge))  # without gaps
    squares = np.stack([np.stack([x + i * half, z + j * half], axis=1)
                        for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))], axis=1)
    image = PolyCollection(squares, array=value[here], cmap="viridis")
    image.set_clim(0, largest)
    image.set_edgecolor("face")
    axes.add_collection(image)
    axes.set_xlim(-1, 62)
    axes.set_ylim(-1, 62)
    axes.set_aspect("equal")
    return image


folder = Path(sys.argv[1])
files = states(folder)
loads = [float(load) for load in sys.argv[2:]] or [0.2, max(files)]
plt.rcParams.update({"font.size": 8, "savefig.dpi": 200})
figure, rows = plt.subplots(len(loads), len(DEPTHS), figsize=(7, 4.6), sharex=True,
                            sharey=True, layout="constrained", squeeze=False)
for load, row in zip(loads, rows):
    with h5py.File(files[load]) as file:
        largest = file["plastic_multiplier"][()].max()
    for depth, axes in zip(DEPTHS, row):
        image = draw_cut(axes, files[load], depth, largest)
        axes.set_title(f"$y$ = {1e3 * depth:g} mm, $s$ = {load:g}")
    row[0].set_ylabel("$z$ [mm]")
    figure.colorbar(image, ax=row, label="hardening variable [1]")
for axes in rows[-1]:
    axes.set_xlabel("$x$ [mm]")
figure.savefig(folder / "cuts.png")
