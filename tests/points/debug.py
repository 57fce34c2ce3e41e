#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving points on 1 and 2 ranks: the same forces; in Debug builds the
assertions of deal.II and of the program must hold."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
one, two = (check.run("debug.prm", f"{ranks}_ranks", [], ranks).history
            for ranks in (1, 2))
check.close("force on 2 ranks", two["left force 1 [N/m]"][-1],
            one["left force 1 [N/m]"][-1], relative=1e-5)
check.note(one["left force 1 [N/m]"][-1] > 20e3, "the specimen is loaded")
check.finish()
