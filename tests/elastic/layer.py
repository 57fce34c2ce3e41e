#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shear of a layer with clamped rotation (benchmarks A2): stress, rotation in
the middle, and orders of convergence."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name, l2_error

check = Check(__doc__)

MU, H, U, WIDTH = 1000.0, 1.0, 1e-3, 0.1
SOLID = "Materials/solid/"


def run(name, ratio, length, element, cells):
    """Relative length L/H and mu_c/mu."""
    return check.run("layer.prm", file_name(f"layer {name} {cells}"),
                     element_settings(element) +
                     [f"Grid/Cells=1, {cells}",
                      f"{SOLID}Couple modulus={ratio * MU!r}",
                      f"{SOLID}Bending modulus={2 * MU * length ** 2!r}"])


def results(run):
    """tau H/(mu U) and w_mid H/U"""
    history = run.history
    return (history["top force 1 [N/m]"][-1] / WIDTH * H / (MU * U),
            history["top rotation [rad]"][-1] * H / U)


# The values to the digits given, on a fine grid.
for length, ratio, tau, rotation in (
        (0.05, 0.5, 1.04256243, -0.52098466), (0.05, 1, 1.05263158, -0.52626800),
        (0.1, 0.25, 1.06725786, -0.48853354), (0.1, 0.5, 1.08885399, -0.52606811),
        (0.1, 10, 1.15585503, -0.57656328)):
    name = f"L/H = {length}, mu_c/mu = {ratio}"
    ours = results(run(name, ratio, length, "Q2/Q2 full", 160))
    check.close(name + ": tau", ours[0], tau, absolute=1e-8)
    check.close(name + ": rotation", ours[1], rotation, absolute=1e-8)

# Orders of convergence.
LENGTH, RATIO = 0.1, 0.5
MU_C, B = RATIO * MU, 2 * MU * LENGTH ** 2
k = math.sqrt(4 * MU * MU_C / (B * (MU + MU_C)))
half = k * H / 2
tau = MU * U / H / (1 - MU_C / (MU + MU_C) * math.tanh(half) / half)


def rotation(_, y):
    return -tau / (2 * MU) * (1 - math.cosh(k * (y - H / 2)) / math.cosh(half))


def displacement(_, y):
    # tau = (mu + mu_c) u' + 2 mu_c w, integrated
    slope = (tau + MU_C * tau / MU) / (MU + MU_C)
    return slope * y - MU_C / (MU + MU_C) * tau / MU * (
        math.sinh(k * (y - H / 2)) + math.sinh(half)) / (k * math.cosh(half))


check.close("displacement of the formulas at the top", displacement(0, H / 2),
            U / 2, relative=1e-12)
stress_errors = {}
for element, order, tau_order in (
        ("Q1/Q1 full", 2, 2), ("Q1/Q1 assumed", 2, 2), ("Q2/Q1 full", 2, 2),
        ("Q2/Q2 full", 3, 4), ("Q2/Q2 assumed", 3, 4)):
    errors = {"stress": [], "rotation": [], "displacement": []}
    for cells in (5, 10, 20):
        result = run(element, RATIO, LENGTH, element, cells)
        p = result.points()
        errors["stress"].append(abs(results(result)[0] * U / H * MU - tau))
        errors["rotation"].append(l2_error(p, "micro_rotation", rotation))
        errors["displacement"].append(
            l2_error(p, "displacement_1", displacement))
        scale = max(map(abs, p["stress_12"]))
        check.fields(f"{element}, {cells} cells: one-dimensional", 1e-10,
                     u2=(p["displacement_2"], 0.0, U),
                     s11=(p["stress_11"], 0.0, scale),
                     m1=(p["couple_stress_1"], 0.0, scale * LENGTH))
    stress_errors[element] = errors["stress"]
    for name, list_of_errors in errors.items():
        check.order(f"{element} {name}", list_of_errors,
                    tau_order if name == "stress" else order)

# Strains and rotations sampled in the same points do not lock: on every grid
# the stress is far closer than by full strains. Either of them alone is not.
for degrees in ("Q1/Q1", "Q2/Q2"):
    shares = [a / b for a, b in zip(stress_errors[degrees + " assumed"],
                                    stress_errors[degrees + " full"])]
    check.note(max(shares) < 0.05,
               f"{degrees}: error of the stress, assumed over full: "
               + ", ".join(f"{share:.3f}" for share in shares))
check.finish()
