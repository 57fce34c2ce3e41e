#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that cross cells: one and two cells in a step, through small cells with
hanging nodes, and by as little as 1e-14 of a cell."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)
SLIDE = "../points/slide.prm"
CELL = 0.0025  # m


def steps(n):
    return [f"Loading/Initial step={1 / n!r}", f"Loading/Largest step={1 / n!r}"]


# 16 cells of 2.5 mm
for cells_per_step, ranks in ((1, 1), (2, 1), (1, 2)):
    name = f"{cells_per_step} cells in a step, {ranks} ranks"
    n = 16 // cells_per_step
    run = check.run(SLIDE, file_name(name), steps(n) +
                    ["Grid/Strain sampling=assumed"], ranks)
    check.close(f"{name}: steps", run.history["step [1]"][-1], n)
    check.slid_block(name, run.points(), 1e-9 * n)

# Ranks know the neighbours of their cells: steps beyond are cut, or refused.
long_step = ["Grid/Strain sampling=assumed", "Loading/Fixed steps=false",
             "Loading/Smallest step=0.001"]
run = check.run(SLIDE, "cut", steps(8) + long_step, 2)
check.note(run.history["cuts [1]"][-1] >= 1,
           f"two cells in a step on 2 ranks: cut to "
           f"{max(run.history['step size [1]'])!r}")
check.slid_block("cut", run.points(), 1e-9 * 32)
run = check.run(SLIDE, "refused", steps(8) + [long_step[0]], 2, expect=1)
check.contains("two cells in a fixed step on 2 ranks", run.text,
               "points move beyond the neighbours of their rank's cells",
               "Loading/Fixed steps forbids a smaller one")

# Over hanging nodes: points are halved and merged.
for ranks in (1, 2):
    name = f"through small cells, {ranks} ranks"
    run = check.run("through.prm", file_name(name), [], ranks)
    check.slid_block(name, run.points(), 1e-9 * 100)
    history = run.history
    split, merged = (history[f"{what} points [1]"][-1]
                     for what in ("split", "merged"))
    check.note(split > 50 and merged > 300,
               f"{name}: {split:g} points split, {merged:g} merged")
    check.close(f"{name}: points", history["points [1]"][-1],
                history["points [1]"][0] + split - merged)
    for what in ("volume", "solid volume", "mass"):
        drift = max(map(abs, history[f"{what} drift [1]"]))
        check.note(drift < 1e-13, f"{name}: drift of {what} {drift:.1e}")

# A cell with next to nothing in it: the plates go a small share of a cell
# sideways and press then. The force may not depend on this share, in a sweep
# over the weight from which on a node is seen.
forces = {}
for share in ("0", "1e-14", "1e-10", "1e-8", "1e-7", "1e-6", "1e-5", "1e-4"):
    sideways = f"={CELL} * {share} * min(1, 10 * s)"
    run = check.run(SLIDE, f"filled_{share}", steps(10) + [
        "Grid/Strain sampling=assumed",
        "Boundary conditions/bottom/Displacement 1" + sideways,
        "Boundary conditions/top/Displacement 1" + sideways,
        "Boundary conditions/top/Displacement 2=-1e-4 * max(0, s - 0.1)"])
    forces[share] = run.history["top force 2 [N/m]"][-1]
    check.close(f"{share} of a cell: steps", run.history["step [1]"][-1], 10)
    check.close(f"{share} of a cell: force [N/m]", forces[share], forces["0"],
                relative=1e-4)
check.note(forces["0"] < -4000.0, "the block is pressed")
check.finish()
