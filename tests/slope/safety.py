#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Factor of safety of the cut of prm/tutorial/05_slope: that of plasticity
theory, 3.7776 c/(gamma H), for a small internal length, and more for a large
one."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)

CASE = "../../prm/tutorial/05_slope/case.prm"
MU, HEIGHT = 50e6, 5.0


def load_factor(length):
    run = check.run(CASE, f"length_{length:g}".replace(".", "_"), [
        f"Materials/clay/Bending modulus={2 * MU * length ** 2!r}",
        "Loading/Initial step=0.04", "Loading/Largest step=0.04",
        "Loading/Stop=0.6", "Output/Fields every=0", "Output/Bands every=0"])
    factor = run.history["load factor [1]"]
    check.note(abs(factor[-1] / factor[-4] - 1) < 5e-3,
               f"L = {length} m: the load factor has settled: "
               + ", ".join(f"{f:.4f}" for f in factor[-4:]))
    return factor[-1]


small, large = load_factor(0.05), load_factor(0.5)
check.close(f"L/H = {0.05 / HEIGHT}: load factor at failure", small, 1.0,
            relative=0.02)
check.note(1.1 < large / small < 1.25,
           f"L/H = {0.5 / HEIGHT}: {large / small:.3f} times as much")
check.finish()
