#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stressed block of sand slides through the grid: its stress and volume stay.

In 1000 steps too.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)

for sampling, steps, ranks in (("full", 100, 1), ("assumed", 100, 2),
                               ("assumed", 1000, 1)):
    name = f"{sampling}, {steps} steps, {ranks} ranks"
    run = check.run("slide.prm", file_name(name),
                    [f"Grid/Strain sampling={sampling}",
                     f"Loading/Initial step={1 / steps!r}",
                     f"Loading/Largest step={1 / steps!r}"], ranks)
    # every step may leave the residual of 1e-9
    check.slid_block(name, run.points(), 1e-9 * steps)
check.finish()
