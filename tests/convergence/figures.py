#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 4 on cells of 5, 2.5 and 1.25 mm, at u1/h = 0.02: the classical band halves with every refinement, the
micropolar one settles (contrib/convergence)."""

import csv
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from scene_tools import Check

GRIDS = ("5", "2.5", "1.25")

check = Check(__doc__)
folder = check.results / "study"
shutil.rmtree(folder, ignore_errors=True)  # what is there is not run again
subprocess.run([sys.executable, ROOT / "contrib/convergence", "--program", check.program, "--results", folder,
                "--no-picture", "--stop", "0.2", "--members", ",".join(f"4-*-{grid}" for grid in GRIDS)],
               check=True, stdout=subprocess.DEVNULL)
with open(folder / "table.csv", newline="") as file:
    rows = {(row["law"], row["grid"]): row for row in csv.DictReader(file) if abs(float(row["u1/h"]) - 0.02) < 1e-9}


def ratios(law, column):
    """The value on a grid over that on the coarser one before it."""
    values = [float(rows[law, grid][column]) for grid in GRIDS]
    return [fine / coarse for coarse, fine in zip(values, values[1:])]


for grid, ratio in zip(GRIDS[1:], ratios("classical", "t50 shear [mm]")):
    check.note(0.4 < ratio < 0.6, f"classical, {grid} mm: thickness of the shear strain times {ratio:.3f}, a half")
ratio = ratios("micropolar", "t50 shear [mm]")[-1]
check.note(0.85 < ratio < 1.05, f"micropolar, 1.25 mm: thickness of the shear strain times {ratio:.3f}, it settles")
ratio = ratios("micropolar", "P1 [kN/m]")[-1]
check.note(abs(ratio - 1.0) < 0.01, f"micropolar, 1.25 mm: P1 times {ratio:.4f}, it settles")
ratio = ratios("classical", "P1 [kN/m]")[-1]
check.note(ratio < 0.95, f"classical, 1.25 mm: P1 times {ratio:.4f}, it goes on falling")
check.finish()
