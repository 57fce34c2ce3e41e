#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Homogeneous specimens of one cell follow the reference paths of a point
(reference/biaxial_point.csv, compression.csv), with the polar and with the
classical law. The isotropic paths shorten the third axis, too (Loading/Strain
33).
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)
INITIAL = "Initial state/"
COLUMNS = (("s11", "stress_11", 1e3), ("s22", "stress_22", 1e3),
           ("s33", "stress_33", 1e3), ("e", "void_ratio", 1.0))


def reference(name):
    lines = (check.here.parent / "reference" / name).read_text().splitlines()
    return list(csv.DictReader(l for l in lines if not l.startswith("#")))


def compare(name, run, shortening, strain, expected, tolerance):
    """The last state of every cell with the row of its strain."""
    rows = {round(float(row[strain]), 9): row for row in expected}
    found = 0
    for points in run.all_points():
        row = rows.get(round(shortening * points["load"], 9))
        if row is None:
            continue
        found += 1
        check.fields(
            f"{name}, strain {row[strain]}", tolerance,
            **{column: (points[field],
                        float(row[column]) * unit, abs(float(row[column])) * unit)
               for column, field, unit in COLUMNS if column in row},
            s12=(points["stress_12"], 0.0, 1e5))
    check.note(found > 0, f"{name}: {found} states compared")


# A path of small steps, with tolerance 1e-5 (smaller steps: 1e-6 and less).
biaxial = reference("biaxial_point.csv")
for law, case in (("polar", "biaxial.prm"),
                  ("classical", "biaxial_classical.prm")):
    for e0, p in ((0.60, 100), (0.75, 100), (0.60, 1000)):
        if law == "classical" and (e0, p) != (0.60, 100):
            continue
        # the classical cell has no length that keeps it homogeneous
        stop = 1.0 if law == "polar" else 0.1
        name = f"biaxial {law} e0 = {e0:.2f}, p = {p} kPa"
        result = check.run(case, file_name(name),
                           [f"{INITIAL}Void ratio={e0}", f"Loading/Stop={stop}",
                            f"{INITIAL}Vertical pressure at top={p * 1e3}",
                            f"Boundary conditions/top/Pressure={p * 1e3}"])
        compare(name, result, 0.3, "eps1",
                [row for row in biaxial
                 if row["case"].startswith(f"e{e0:.2f}_p{p}_")], 1e-5)

compression = reference("compression.csv")
for test, shortening, start in (("oedometer", 0.03, 5e-5),
                                ("isotropic", 0.014, 2e-5)):
    for law, case in (("polar", f"{test}.prm"),
                      ("classical", f"{test}_classical.prm")):
        for e0 in (0.60, 0.75):
            rows = [dict(row, s11=row["s_lat"], s33=row["s_lat"],
                         s22=row["s_vert"])
                    for row in compression
                    if test.startswith(row["test"]) and float(row["e0"]) == e0]
            name = f"{test} {law} e0 = {e0:.2f}"
            for what, stop in (("", 1.0), (" start", start / shortening)):
                result = check.run(case, file_name(name + what),
                                   [f"{INITIAL}Void ratio={e0}",
                                    f"Loading/Stop={stop!r}"])
                compare(name + what, result, shortening, "eps_vert", rows, 1e-5)

# The classical law has no rotations at all: two unknowns per node.
polar = check.run("oedometer.prm", "unknowns_polar",
                  ["Grid/Cells=3, 2", "Grid/Displacement degree=2",
                   "Loading/Stop=0.01"])
classical = check.run("oedometer_classical.prm", "unknowns_classical",
                      ["Grid/Cells=3, 2", "Grid/Displacement degree=2",
                       "Loading/Stop=0.01"])
check.contains("polar law", polar.text, " 105 unknowns.")
check.contains("classical law", classical.text, " 70 unknowns.")
check.note("micro_rotation" not in classical.points(),
           "the points of the classical law have no micro-rotation")
check.note("left rotation [rad]" not in classical.history,
           "the history of the classical law has no rotations")
check.finish()
