#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same history of moving points on 1 and 2 ranks: to 1e-8 before the peak of
the force, to 1e-5 of the peak after it."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
one, two = (check.run("specimen/case.prm", f"{ranks}_ranks", [], ranks).history
            for ranks in (1, 2))
check.same_history("two ranks", two, one, 1e-8, 1e-5)
check.finish()
