#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first scene at full size against independent results.

Specimen and loads of figure 4 of Tejchman, "Numerical studies on patterning of
shear zones in granular bodies"; the figures are those of an independent program:
biquadratic cells with assumed strains, and bilinear ones with mean dilatation,
the published resolution. Also the effort of the default scheme.
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

CASE = pathlib.Path(__file__).resolve().parents[2] / "prm/tutorial/01_biaxial/case.prm"

check = Check(__doc__)


def bands_at(run, load):
    """The row of bands.csv at a load."""
    with open(run.folder / "bands.csv", newline="") as file:
        rows = [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]
    return next(row for row in rows if abs(row["load [1]"] - load) < 1e-9)


def row_at(history, load):
    return next(i for i, s in enumerate(history["load [1]"])
                if abs(s - load) < 1e-9)


def figures(name, settings, peak, residual, thickness):
    run = check.run(CASE, name, settings)
    history = run.history
    force = [1e-3 * value for value in history["left force 1 [N/m]"]]
    largest = force.index(max(force))
    half = row_at(history, 0.5)  # u1/h = 0.05
    bands = bands_at(run, 0.5)
    check.close(f"{name}: largest P1 [kN/m]", force[largest], *peak)
    check.close(f"{name}: P1 at u1/h = 0.05 [kN/m]", force[half], *residual)
    check.close(f"{name}: bands", bands["bands [1]"], 4)
    check.close(f"{name}: thickness at 50 % [d50]",
                bands["thickness at 50 % [d50]"], *thickness)
    check.close(f"{name}: void ratio outside", bands["void ratio outside [1]"],
                0.596, 0.0, 0.003)
    check.close(f"{name}: runs on to u1/h = 0.1, s", history["load [1]"][-1], 1.0,
                0.0, 1e-9)
    check.close(f"{name}: P1 left and right [kN/m]",
                -1e-3 * history["right force 1 [N/m]"][half], force[half], 1e-5)
    return history, largest, half


# expected value, relative and absolute tolerance
history, largest, half = figures("biquadratic", [], (33.4, 0.0, 0.15),
                                 (20.35, 0.0, 0.25), (5.7, 0.0, 0.6))
check.close("biquadratic: largest P1 at u1/h",
            0.1 * history["load [1]"][largest], 0.017, 0.0, 0.0005)
for column, most in (("factorisations [1]", 90), ("sweeps [1]", 1200),
                     ("cuts [1]", 2)):
    check.note(history[column][half] <= most,
               f"biquadratic: {history[column][half]:g} {column} to u1/h = 0.05, "
               f"at most {most}")

figures("bilinear", ["Grid/Displacement degree=1", "Grid/Rotation degree=1",
                     "Grid/Strain sampling=mean dilatation"],
        (35.33, 0.0, 0.2), (25.97, 0.0, 0.4), (13.8, 0.0, 1.5))
check.finish()
