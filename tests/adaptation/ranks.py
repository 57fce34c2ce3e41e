#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A specimen whose grid follows the shear bands, on 1, 2 and 3 ranks: the same
history to 1e-8 before the first change of the grid and to 1e-3 of the peak after
it, and the same bands. What a change does to volume, mass and force."""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
COLUMNS = ("left force 1 [N/m]", "right force 1 [N/m]", "bottom force 2 [N/m]",
           "top u2 [m]", "volume [m2]", "external work [J/m]")


def last_bands(run):
    with open(run.folder / "bands.csv", newline="") as file:
        return list(csv.DictReader(file))[-1]


reference_run = check.run("specimen.prm", "one_rank")
reference = reference_run.history
changes = reference["grid changes [1]"]
force = [abs(value) for value in reference["left force 1 [N/m]"]]
peak = max(force)
first = changes.index(1)

check.note(2 <= changes[-1] <= 15, f"{changes[-1]:g} changes of the grid")
check.note(max(reference["cells [1]"]) > reference["cells [1]"][-1],
           "the grid becomes coarse behind the bands")
check.close("points per cell", reference["points [1]"][-1],
            9 * reference["cells [1]"][-1])
check.fields("mass and force at the top", 1e-9,
             mass=(reference["mass [kg/m]"], reference["mass [kg/m]"][0],
                   reference["mass [kg/m]"][0]),
             force=(reference["top force 2 [N/m]"], -5000.0, 5000.0))
jumps = [abs(value) / peak for value, step in
         zip(reference["force jump at change [N/m]"], reference["step [1]"])]
check.note(max(jumps) < 1e-2, f"largest jump of P1 {max(jumps):.1e} of the peak")
check.note(sum(jumps) < 1e-3 * changes[-1],
           f"mean jump of P1 {sum(jumps) / changes[-1]:.1e} of the peak")
imbalance = max(reference["imbalance after change [1]"])
check.note(0 < imbalance < 0.3, f"largest imbalance after a change {imbalance:.2g}")
stress = max(reference["stress change at change [1]"])
check.note(0 < stress < 1e-2, f"largest change of the summed stress {stress:.1e}")

for ranks in (2, 3):
    run = check.run("specimen.prm", f"{ranks}_ranks", [], ranks)
    history = run.history
    check.fields(f"{ranks} ranks: loads", 1e-12,
                 load=(history["load [1]"], reference["load [1]"], 1.0))
    before, after = {}, {}
    for column in COLUMNS:
        ours, expected = history[column], reference[column]
        before[column] = ([a / b for a, b in zip(ours[1:first], expected[1:first])],
                          1.0, 1.0)
        after[column] = (ours[first:], expected[first:], max(map(abs, expected)))
    check.fields(f"{ranks} ranks, before the first change", 1e-8, **before)
    check.fields(f"{ranks} ranks, after it", 1e-3, **after)
    ours, expected = last_bands(run), last_bands(reference_run)
    check.close(f"{ranks} ranks: bands", float(ours["bands [1]"]),
                float(expected["bands [1]"]))
    check.close(f"{ranks} ranks: thickness [d50]",
                float(ours["thickness at 50 % [d50]"]),
                float(expected["thickness at 50 % [d50]"]), 1e-2)
check.finish()
