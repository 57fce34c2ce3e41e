#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""GMRES with multigrid: its iterations stay bounded as the grid becomes finer,
and its forces are those of the direct solver."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)


def run(cells, *settings, ranks=1):
    name = "_".join([f"cube_{cells}", *(s.rsplit("=")[-1] for s in settings),
                     str(ranks)])
    return check.run("cube.prm", name,
                     [f"Grid/Cells={cells}, {cells}, {cells}", *settings], ranks)


def iterations(result):
    """Of a linear system, on average, and systems left unfinished."""
    match = re.search(r"multigrid: ([\d.]+) iterations on average, at most "
                      r"(\d+), (\d+) systems left unfinished", result.text)
    return float(match[1]), int(match[3])


counts = {}
for cells, ranks in ((4, 1), (8, 1), (16, 1), (8, 2)):
    for settings in ([], ["Materials/solid/Couple modulus=1e5"],
                     ["Materials/solid/Bending modulus=0.02",
                      "Materials/solid/Curvature modulus beta=0",
                      "Materials/solid/Curvature modulus alpha=0"]):
        if settings and cells == 16:
            continue
        name = " ".join([f"{cells} cells", f"{ranks} ranks", *settings])
        mean, unfinished = iterations(run(cells, *settings, ranks=ranks))
        counts[cells, ranks, len(settings)] = mean
        check.note(unfinished == 0 and mean <= 20,
                   f"{name}: {mean} iterations per system, at most 20 allowed")
check.note(counts[16, 1, 0] <= 1.5 * counts[8, 1, 0],
           f"8 and 16 cells: {counts[8, 1, 0]} and {counts[16, 1, 0]} iterations")

one, direct = (run(8, *settings).history["top force 3 [N]"][-1]
               for settings in ([], ["Solver/Linear solver=direct"]))
check.close("force of both solvers", one, direct, relative=1e-9)
check.finish()
