#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grid that changes after the very first step, when there is no step before
the last one to be extrapolated from."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)

result = check.run(
    "../specimen/case.prm", "first_step",
    ["Grid/Cells=8, 4", "Adaptation/Criteria=shear rate",
     "Adaptation/Every steps=1", "Adaptation/Cell size=0",
     "Adaptation/Refine initially=", "Adaptation/Thresholds/Shear rate=1.001",
     "Loading/Stop=0.012"])
cells = result.history["cells [1]"]
check.note(cells[2] > cells[1] == 32,
           f"cells: {', '.join(f'{c:g}' for c in cells)}")
check.finish()
