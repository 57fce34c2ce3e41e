#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Biaxial compression with softening cohesion: force and thickness of the band
on two grids (prm/benchmarks/biaxial_softening)."""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
CASE = "../../prm/benchmarks/biaxial_softening/case.prm"

figures = []
for cells in ("16, 32", "32, 64"):
    result = check.run(CASE, "biaxial " + cells.split(",")[0],
                       [f"Grid/Cells={cells}", "Loading/Stop=0.4",
                        "Output/Fields every=0", "Output/Bands every=0.4"])
    force = [-f for f in result.history["top force 2 [N/m]"]]
    with open(result.folder / "bands.csv", newline="") as file:
        band = list(csv.DictReader(file))[-1]
    figures.append((max(force), force[-1],
                    float(band["thickness at 50 % [mm]"])))
    check.close("bands", float(band["bands [1]"]), 1)

for name, coarse, fine, tolerance in zip(
        ("largest force", "force at the end", "thickness"), *figures,
        (1e-3, 5e-3, 1e-2)):
    check.close(f"{name} on both grids", coarse, fine, relative=tolerance)
check.close("thickness over L", figures[1][2] / 2, 4.52, relative=0.02)
check.finish()
