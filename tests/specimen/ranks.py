#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same history on 1 and 2 ranks: to 1e-8 before the peak of the force, to
1e-5 of the peak after it; and so by both direct solvers and by Newton's
method."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
COLUMNS = ("left force 1 [N/m]", "right force 1 [N/m]", "bottom force 2 [N/m]",
           "top u2 [m]", "volume [m2]", "external work [J/m]")

reference = check.run("case.prm", "one_rank").history
force = [abs(value) for value in reference["left force 1 [N/m]"]]
peak = force.index(max(force))
check.note(0 < peak < len(force) - 10,
           f"peak at s = {reference['load [1]'][peak]:g}")

for name, settings, ranks, before_peak in (
        ("two_ranks", [], 2, 1e-8),
        ("umfpack", ["Solver/Direct solver=umfpack"], 1, 1e-8),
        # other iterates: what the residual leaves open
        ("newton", ["Solver/Scheme=newton"], 1, 1e-7)):
    history = check.run("case.prm", name, settings, ranks).history
    check.fields(f"{name}: loads", 1e-12,
                 load=(history["load [1]"], reference["load [1]"], 1.0))
    for part, rows, tolerance in (("before the peak", slice(1, peak), before_peak),
                                  ("after the peak", slice(peak, None), 1e-5)):
        fields = {}
        for column in COLUMNS:
            ours, expected = history[column][rows], reference[column][rows]
            largest = max(map(abs, reference[column]))
            if part == "before the peak":  # relative to each value
                ours = [a / b for a, b in zip(ours, expected)]
                expected, largest = 1.0, 1.0
            fields[column] = (ours, expected, largest)
        check.fields(f"{name}, {part}", tolerance, **fields)
check.finish()
