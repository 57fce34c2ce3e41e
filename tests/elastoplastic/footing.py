#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bearing capacity of a strip footing on a half space with cohesion (benchmarks
C4), without friction and with 20 degrees, and under a surcharge."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from grid_file import graded, write_block
from scene_tools import Check, element_settings, file_name

check = Check(__doc__)

HALF_WIDTH, COHESION = 1.0, 1.0
RATIO = 1.2  # of neighbouring cells


def make_grid(path, width, depth, smallest):
    """Cells that are smallest at the edge of the footing."""
    under = [HALF_WIDTH - x for x in
             reversed(graded(HALF_WIDTH, smallest, RATIO))]
    x = under + [HALF_WIDTH + d for d in
                 graded(width - HALF_WIDTH, smallest, RATIO)[1:]]
    y = [depth - d for d in reversed(graded(depth, smallest, RATIO))]
    n_footing = len(under) - 1
    names = {"low 1": 1, "high 1": 2, "low 2": 3}
    write_block(path, len(x) - 1, len(y) - 1, lambda i, j: (x[i], y[j]),
                lambda side, k: names.get(side, 4 if k < n_footing else 5))


def capacity(name, width, depth, smallest, element, settings):
    """Load over width and cohesion at the end, where it does not grow."""
    grid = check.results / f"{file_name(name)}.inp"
    make_grid(grid, width, depth, smallest)
    run = check.run("footing.prm", file_name(name),
                    element_settings(element) + settings +
                    [f"Geometry/File={grid}"])
    history = run.history
    load = [-f / HALF_WIDTH / COHESION for f in
            history["footing force 2 [N/m]"]]
    late = next(p for s, p in zip(history["load [1]"], load) if s >= 0.8)
    check.note(abs(load[-1] / late - 1) < 0.005,
               f"{name}: {late:.4f} at s = .8, {load[-1]:.4f} at the end")
    return load[-1]


SOLID = "Materials/solid/"
N_C = {0: 5.1416, 20: 14.835}
N_Q = 6.399
SCENES = {0: (5, 3, "Q2/Q2 mean dilatation", []),
          20: (8, 4, "Q2/Q2 assumed",
               ["Boundary conditions/footing/Displacement 2=-0.006*s"])}
for friction, (width, depth, element, settings) in SCENES.items():
    settings = settings + [SOLID + f"Friction angle={friction}",
                           SOLID + f"Dilatancy angle={friction}",
                           SOLID + f"Cohesion={COHESION}"]
    errors = []
    for smallest in (0.05, 0.025):
        name = f"phi {friction}, cells {smallest}"
        ours = capacity(name, width, depth, smallest, element, settings)
        errors.append(abs(ours / N_C[friction] - 1))
        check.close(f"{name} m at the edge: N_c", ours, N_C[friction],
                    relative=0.03 if smallest == 0.025 else 0.05)
    check.note(errors[1] < 0.8 * errors[0], "the finer grid is closer")
ours = capacity("surcharge", width, depth, smallest, element,
                settings + ["Boundary conditions/surface/Pressure="
                            f"min(10*s, 1)*{COHESION}"])
check.close("as much surcharge as cohesion: N_c + N_q", ours, N_C[20] + N_Q,
            relative=0.03)
check.finish()
