#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane-strain bending (benchmarks A4): moment over the classical one."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

NU, MU, CURVATURE = 0.3, 1000.0, 1e-3
CLASSICAL = 2 * MU / (1 - NU) * CURVATURE / 12  # per metre, for h = 1 m

RIGHT = "Boundary conditions/right/"


def compare(name, p, modulus):
    """Fields of the exact solution."""
    places = list(zip(p["X"], p["Y"]))
    stress = 2 * MU / (1 - NU) * CURVATURE
    check.fields(
        name, 1e-9,
        u1=(p["displacement_1"], [-CURVATURE * x * y for x, y in places],
            CURVATURE),
        u2=(p["displacement_2"],
            [CURVATURE / 2 * (x * x + NU / (1 - NU) * y * y)
             for x, y in places], CURVATURE),
        rotation=(p["micro_rotation"], [CURVATURE * x for x, y in places],
                  CURVATURE),
        s11=(p["stress_11"], [-stress * y for x, y in places], stress),
        s22=(p["stress_22"], 0.0, stress), s12=(p["stress_12"], 0.0, stress),
        s21=(p["stress_21"], 0.0, stress),
        m1=(p["couple_stress_1"], modulus * CURVATURE,
            stress))


for element in ("Q2/Q1 full", "Q2/Q2 full", "Q2/Q2 assumed"):
    for length, expected in ((0.1, 1.168), (0.2, 1.672), (0.5, 5.2)):
        name = f"{element}, l_b/h = {length}"
        modulus = 4 * MU * length ** 2
        result = check.run(
            "bending.prm", file_name(name), element_settings(element) +
            [f"Materials/solid/Bending modulus={modulus!r}"])
        history = result.history
        check.close(name + ": M/M_classical",
                    history["right moment [N]"][-1] / CLASSICAL, expected,
                    relative=1e-9)
        compare(name, result.points(), modulus)

        # the same by traction and couple traction at the right end
        stress = 2 * MU / (1 - NU) * CURVATURE
        result = check.run(
            "bending.prm", file_name(name + " tractions"),
            element_settings(element) +
            [f"Materials/solid/Bending modulus={modulus!r}",
             RIGHT + "Displacement 1=", RIGHT + "Displacement 2=",
             RIGHT + "Rotation=", RIGHT + "Pressure acts on=initial area",
             RIGHT + f"Traction 1=-{stress!r} * y * s",
             RIGHT + f"Couple traction={modulus * CURVATURE!r} * s"])
        check.close(name + ", tractions: M/M_classical",
                    -result.history["left moment [N]"][-1] / CLASSICAL, expected,
                    relative=1e-9)
        compare(name + ", tractions", result.points(), modulus)
check.finish()
