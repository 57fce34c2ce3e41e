#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The random field of void ratios is the same on 1 and 2 ranks and on every
grid, another seed gives another one."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
ZONE = 0.9  # the weak spot of the scene overrules the field


def field(name, settings=(), ranks=1):
    """Void ratio of every square; all points of a square must agree."""
    p = check.run("case.prm", name, settings, ranks).points(0)
    squares = {}
    for x, y, e in zip(p["X"], p["Y"], p["void_ratio"]):
        if e != ZONE:
            squares.setdefault((int(x / 0.01), int(y / 0.01)), set()).add(e)
    check.note(all(len(values) == 1 for values in squares.values()),
               f"{name}: one void ratio in each of {len(squares)} squares")
    return {square: values.pop() for square, values in squares.items()}


one = field("one_rank")
values = list(one.values())
mean = sum(values) / len(values)
check.note(len(one) == 50 and len(set(values)) == 50,
           f"{len(set(values))} different void ratios in {len(one)} squares")
check.note(all(0.6 + 0.05 * 0.01 <= e <= 0.6 + 0.05 * 0.99 for e in values),
           "all between 0.6 + 0.01 and 0.6 + 0.99 times the amplitude")
check.close("their mean", mean, 0.625, absolute=3 * 0.05 * 0.98 / (12 * 50) ** 0.5)
check.note(field("two_ranks", ranks=2) == one, "the same on two ranks")
check.note(field("fine_grid", ["Grid/Cells=40, 20"]) == one,
           "the same on a grid of half the cell size")
check.note(field("refined", ["Grid/Refinements=1"]) == one,
           "the same on a refined grid")
other = field("other_seed", ["Initial state/Random field/Seed=8"])
check.note(all(other[square] != e for square, e in one.items()),
           "another seed gives another field")
check.finish()
