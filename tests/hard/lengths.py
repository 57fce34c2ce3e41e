#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Internal lengths of a thousandth and of a thousand times the height of a
layer between walls on which grains do not turn: elastic and ideally plastic."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

MU, MU_C, HEIGHT, YIELD = 4000.0, 2000.0, 100.0, 100.0
WIDTH, SMALL, U_END = 2.5, 1e-3, 5.0  # of the scene, as in elastoplastic/layer


def stress(length, yield_stress):
    """At the end, on the top."""
    name = f"L/H = {length / HEIGHT:g}, strength {yield_stress:g}"
    run = check.run(
        "../elastoplastic/layer.prm", file_name(name),
        element_settings("Q2/Q2 assumed") + [
            f"Materials/solid/Bending modulus={2 * MU * length ** 2!r}",
            f"Materials/solid/Yield stress={math.sqrt(3) * SMALL * yield_stress!r}",
            "Materials/solid/Hardening=none",
            "Loading/Initial step=0.02", "Loading/Largest step=0.02",
            "Loading/Fixed steps=false", "Output/Fields every=0"])
    check.close(f"{name}: cuts", run.history["cuts [1]"][-1], 0)
    return run.history["top force 1 [N/m]"][-1] / WIDTH / SMALL


for share in (1e-3, 1e3):
    length = share * HEIGHT
    # benchmarks A2, with B = 2 mu L^2
    half = 0.5 * HEIGHT * math.sqrt(
        4 * MU * MU_C / (2 * MU * length ** 2 * (MU + MU_C)))
    elastic = MU * U_END / HEIGHT / (
        1 - MU_C / (MU + MU_C) * math.tanh(half) / half)
    check.close(f"elastic, L/H = {share:g}: stress",
                stress(length, 1e6 * YIELD), elastic, relative=1e-3)
    # Free grains leave no skew stress. Grains that are held let the symmetric
    # part yield and the skew one, which J2 of de Borst does not see, grow.
    plastic = YIELD + (MU_C * U_END / HEIGHT if share > 1 else 0.0)
    check.close(f"plastic, L/H = {share:g}: stress",
                stress(length, YIELD), plastic, relative=1e-3)
check.finish()
