#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The adaptive scene at full size against the first scene on a uniform grid of
cells as small as its finest ones, to u1/h = 0.05."""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

SCENES = pathlib.Path(__file__).resolve().parents[2] / "prm/tutorial"

check = Check(__doc__)
COMMON = ["Loading/Stop=0.5", "Output/Fields every=0"]


def last_bands(run):
    with open(run.folder / "bands.csv", newline="") as file:
        return {name: float(value) for name, value in list(csv.DictReader(file))[-1].items()}


uniform = check.run(SCENES / "01_biaxial/case.prm", "uniform",
                    COMMON + ["Grid/Refinements=1"])
adaptive = check.run(SCENES / "03_biaxial_adaptive/case.prm", "adaptive", COMMON)
ours, expected = adaptive.history, uniform.history
peak = max(expected["left force 1 [N/m]"])
check.close("largest P1 [kN/m]", 1e-3 * max(ours["left force 1 [N/m]"]), 1e-3 * peak, 5e-3)
check.close("P1 at u1/h = 0.05 [kN/m]", 1e-3 * ours["left force 1 [N/m]"][-1],
            1e-3 * expected["left force 1 [N/m]"][-1], 1e-2)
bands, expected_bands = last_bands(adaptive), last_bands(uniform)
check.close("bands", bands["bands [1]"], 4)
for share in (50, 10):
    name = f"thickness at {share} % [d50]"
    check.close(name, bands[name], expected_bands[name], 0.1)

n_changes = ours["grid changes [1]"][-1]
jumps = [abs(jump) / peak for jump in ours["force jump at change [N/m]"]]
check.note(max(jumps) < 1e-2, f"largest jump of P1 {max(jumps):.1e} of the peak")
check.note(sum(jumps) < 1e-3 * n_changes,
           f"mean jump of P1 {sum(jumps) / n_changes:.1e} of the peak")
print(f"      CPU time {ours['cpu time [s]'][-1]:.1f} s, uniform "
      f"{expected['cpu time [s]'][-1]:.1f} s")
check.finish()
