#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the shear stress at the reference displacements and the width of the zone of rotation, and draws both:
plot.py RESULTS [picture.png]"""

import csv
import pathlib
import sys

import h5py
import numpy as np

WIDTH, HEIGHT = 0.5e-3, 20e-3  # m
LOADS = (0.1, 0.2, 0.5, 1.0)
EXPECTED = (71.72, 64.08, 60.67, 59.66)  # kPa, at these loads
PEAK = (0.0335, 89.352)


def stress(folder):
    """U/h and shear stress on the upper wall [kPa]."""
    with open(folder / "history.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return (np.array([float(row["load [1]"]) for row in rows]),
            np.array([float(row["top force 1 [N/m]"]) / WIDTH / 1e3 for row in rows]))


def peak(load, tau):
    """The vertex of the parabola through the largest value and its neighbours."""
    k = int(tau.argmax())
    a, b, c = np.polyfit(load[k - 1:k + 2], tau[k - 1:k + 2], 2)
    return -b / (2 * a), c - b * b / (4 * a)


def profile(folder, load):
    """Present height [m] and micro-rotation of the points at a load, upwards; a wall at either end."""
    for path in sorted(folder.glob("points-*.h5")):
        with h5py.File(path) as file:
            if abs(file.attrs["load"] - load) < 1e-9:
                y, w = file["position_2"][()], file["micro_rotation"][()]
    order = np.argsort(y)
    y, w = y[order].reshape(-1, 3).mean(axis=1), w[order].reshape(-1, 3).mean(axis=1)
    top = HEIGHT
    with open(folder / "history.csv", newline="") as file:
        for row in csv.DictReader(file):
            if abs(float(row["load [1]"]) - load) < 1e-9:
                top += float(row["top u2 [m]"])
    return np.concatenate([[0.0], y, [top]]), np.concatenate([[0.0], w, [0.0]])


def width(folder, share, load=0.5):
    """Over which |w| exceeds a share of its maximum [m]."""
    y, w = profile(folder, load)
    w = abs(w)
    k = int(w.argmax())
    a, b, c = np.polyfit(y[k - 1:k + 2], w[k - 1:k + 2], 2)
    level = share * (c - b * b / (4 * a))
    upper = np.interp(-level, -w[k:], y[k:])
    lower = np.interp(level, w[:k + 1], y[:k + 1])
    return upper - lower


def main():
    folder = pathlib.Path(sys.argv[1])
    load, tau = stress(folder)
    at, largest = peak(load, tau)
    print(f"largest tau {largest:.3f} kPa at U/h = {at:.4f}; expected {PEAK[1]} at {PEAK[0]}")
    for s, expected in zip(LOADS, EXPECTED):
        print(f"tau({s:g}) {np.interp(s, load, tau):.2f} kPa; expected {expected}")
    for share in (0.5, 0.05):
        print(f"|w| > {100 * share:g} % over {1e3 * width(folder, share):.3f} mm at U/h = 0.5")
    if len(sys.argv) < 3:
        return

    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
    left.plot(load, tau, "r-", lw=1, label="Riedel")
    left.plot(LOADS, EXPECTED, "ks", ms=4, fillstyle="none", label="independent program")
    left.plot(*PEAK, "ks", ms=4, fillstyle="none")
    left.set_xlabel("$U/h$")
    left.set_ylabel("shear stress [kPa]")
    left.set_ylim(0.0)
    left.legend()
    for s in (0.5, 1.0):
        y, w = profile(folder, s)
        right.plot(w, 1e3 * y, ".-", ms=3, lw=0.8, label=f"$U/h$ = {s:g}")
    right.set_xlabel("micro-rotation [rad]")
    right.set_ylabel("height [mm]")
    right.legend()
    figure.savefig(sys.argv[2], dpi=120)


if __name__ == "__main__":
    main()
