#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Biaxial compression with softening cohesion (prm/benchmarks/biaxial_softening):
force and thickness of the band on two grids, for another length, with material
points, and of the classical law."""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
CASE = "../../prm/benchmarks/biaxial_softening/case.prm"

MATERIALS = ("body", "weak corner")
CLASSICAL = [f"Materials/{name}/Law=Drucker-Prager" for name in MATERIALS]
MOVING = ["Grid/Reference configuration=current", "Grid/Margin cells=0, 4, 0, 0"]
# L = 3 mm instead of 2
LONGER = [f"Materials/{name}/Bending modulus=720" for name in MATERIALS]
ROTATION, SHEAR = "thickness at 50 % [mm]", "thickness of shear strain at 50 % [mm]"


def band_of(name, cells, settings=(), thickness=ROTATION):
    """Largest force, force and thickness [mm] at s = 0.4."""
    result = check.run(CASE, f"biaxial {name}",
                       [f"Grid/Cells={cells}", "Loading/Stop=0.4",
                        "Output/Fields every=0", "Output/Bands every=0.4",
                        *settings])
    force = [-f for f in result.history["top force 2 [N/m]"]]
    with open(result.folder / "bands.csv", newline="") as file:
        band = list(csv.DictReader(file))[-1]
    check.close(f"{name}: bands", float(band["bands [1]"]), 1)
    return max(force), force[-1], float(band[thickness])


coarse, fine = band_of("16", "16, 32"), band_of("32", "32, 64")
for name, one, other, tolerance in zip(
        ("largest force", "force at the end", "thickness"), coarse, fine,
        (1e-3, 5e-3, 1e-2)):
    check.close(f"{name} on both grids", one, other, relative=tolerance)
check.close("thickness over L", fine[2] / 2, 4.52, relative=0.02)

longer = band_of("3 mm", "16, 32", LONGER)
check.close("thickness over L for L = 3 mm", longer[2] / 3, 4.52, relative=0.04)

points = band_of("points", "16, 32", MOVING)
for name, one, other, tolerance in zip(
        ("largest force", "force at the end", "thickness"), points, fine,
        (2e-3, 5e-3, 0.07)):
    check.close(f"{name} with material points", one, other, relative=tolerance)

# without a length the band is as wide as the cells
wide, narrow = (band_of(f"classical {cells}", cells, CLASSICAL, SHEAR)
                for cells in ("8, 16", "16, 32"))
check.close("thickness on 16 x 32 over 8 x 16 cells, classical",
            narrow[2] / wide[2], 0.58, relative=0.05)
check.finish()
