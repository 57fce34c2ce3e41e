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
reference = check.run("case.prm", "one_rank").history
for name, settings, ranks, before_peak in (
        ("two_ranks", [], 2, 1e-8),
        ("umfpack", ["Solver/Direct solver=umfpack"], 1, 1e-8),
        # other iterates: what the residual leaves open
        ("newton", ["Solver/Scheme=newton"], 1, 1e-7)):
    check.same_history(name, check.run("case.prm", name, settings, ranks).history,
                       reference, before_peak, 1e-5)
check.finish()
