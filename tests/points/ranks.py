#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same history of moving points on 1 and 2 ranks: to 1e-8 before the peak of
the force, to 1e-5 of the peak after it."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
COLUMNS = ("left force 1 [N/m]", "right force 1 [N/m]", "bottom force 2 [N/m]",
           "top u2 [m]", "volume [m2]", "external work [J/m]")

reference = check.run("specimen/case.prm", "one_rank").history
force = [abs(value) for value in reference["left force 1 [N/m]"]]
peak = force.index(max(force))
check.note(0 < peak < len(force) - 10,
           f"peak at s = {reference['load [1]'][peak]:g}")

history = check.run("specimen/case.prm", "two_ranks", [], 2).history
check.fields("loads", 1e-12,
             load=(history["load [1]"], reference["load [1]"], 1.0))
for part, rows, tolerance in (("before the peak", slice(1, peak), 1e-8),
                              ("after the peak", slice(peak, None), 1e-5)):
    fields = {}
    for column in COLUMNS:
        ours, expected = history[column][rows], reference[column][rows]
        largest = max(map(abs, reference[column]))
        if part == "before the peak":  # relative to each value
            ours = [a / b for a, b in zip(ours, expected)]
            expected, largest = 1.0, 1.0
        fields[column] = (ours, expected, largest)
    check.fields(part, tolerance, **fields)
check.finish()
