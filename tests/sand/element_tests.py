#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The element tests of prm/element_tests, run by the program: all rows of the
reference files biaxial_point.csv and compression.csv to 1e-5, the peaks of
triaxial and biaxial compression, critical states."""

import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check, file_name

check = Check(__doc__)
CASES = check.here.parents[1] / "prm" / "element_tests"
S = {name: f"stress {name} [Pa]" for name in ("11", "22", "33", "12")}
FRICTION = "mobilised friction angle [deg]"


def reference(name):
    lines = (check.here.parent / "reference" / name).read_text().splitlines()
    return list(csv.DictReader(l for l in lines if not l.startswith("#")))


def run(case, name, others=None, **settings):
    """The rows of element_test.csv as dictionaries of numbers. The settings are
    those of the element test, and others with their sections."""
    changes = {f"Element test/{entry.replace('_', ' ')}": value
               for entry, value in settings.items()}
    changes.update(others or {})
    result = check.run(CASES / case / "case.prm", file_name(name),
                       [f"{entry}={value}" for entry, value in changes.items()])
    with open(result.folder / "element_test.csv", newline="") as file:
        return [{column: float(value) for column, value in row.items()}
                for row in csv.DictReader(file)]


def compare(name, rows, axis, strain, expected, columns):
    """Rows of a file at strains of an axis: columns are pairs of ours and of
    the file's with the unit of the latter."""
    by_strain = {round(-row[axis], 9): row for row in rows}
    pairs = [(by_strain[round(float(row[strain]), 9)][ours],
              float(row[theirs]) * unit)
             for row in expected for ours, theirs, unit in columns]
    worst = max(abs(a - b) / abs(b) for a, b in pairs)
    check.note(len(expected) > 0 and worst <= 1e-5,
               f"{name}: {len(expected)} states, largest error {worst:.1e} of "
               "1e-05 allowed")


biaxial = reference("biaxial_point.csv")
for e0, p in (("0.60", 100), ("0.75", 100), ("0.60", 1000)):
    name = f"biaxial e0 = {e0}, p = {p} kPa"
    compare(name, run("biaxial", name, Void_ratio=e0, Vertical_pressure=p * 1e3),
            "strain 11", "eps1",
            [row for row in biaxial if row["case"].startswith(f"e{e0}_p{p}_")],
            ((S["11"], "s11", 1e3), (S["33"], "s33", 1e3), ("void ratio", "e", 1),
             (FRICTION, "phi_deg", 1)))

compression = reference("compression.csv")
for e0, oedometer_steps in (("0.60", 1600), ("0.75", 2400)):
    rows = [row for row in compression if row["e0"] == e0]
    name = f"oedometer e0 = {e0}"
    compare(name,
            run("oedometer", name, Void_ratio=e0, Steps=oedometer_steps,
                Axial_strain=oedometer_steps * 1.25e-5),
            "strain 22", "eps_vert",
            [row for row in rows if row["test"] == "oedo"],
            ((S["22"], "s_vert", 1e3), (S["11"], "s_lat", 1e3),
             (S["33"], "s_lat", 1e3), ("void ratio", "e", 1)))
    name = f"isotropic e0 = {e0}"
    compare(name, run("isotropic", name, Void_ratio=e0), "strain 22",
            "eps_vert",
            [row for row in rows if row["test"] == "iso"],
            ((S["11"], "s_lat", 1e3), (S["22"], "s_vert", 1e3),
             (S["33"], "s_lat", 1e3), ("void ratio", "e", 1)))

for e0, expected in (("0.60", -710.857e3), ("0.75", -257.572e3),
                     ("0.85", -151.079e3)):
    end = run("oedometer", f"oedometer to one percent e0 = {e0}", Void_ratio=e0,
              Axial_strain=0.01, Steps=800)[-1]
    check.close(f"oedometer e0 = {e0}, s22 at 1 %", end[S["22"]], expected,
                absolute=1.0)

for e0, angle, at in (("0.60", 44.01, 0.0258), ("0.65", 38.29, None),
                      ("0.70", 34.47, None)):
    rows = run("triaxial_drained", f"triaxial peak e0 = {e0}", Void_ratio=e0,
               Axial_strain=0.1, Steps=5000)
    peak = max(rows, key=lambda row: row[FRICTION])
    check.close(f"triaxial e0 = {e0}, peak [deg]", peak[FRICTION], angle,
                absolute=0.005)
    if at:
        check.close(f"triaxial e0 = {e0}, strain of the peak",
                    -peak["strain 11"], at, absolute=5e-5)
    worst = max(abs(row[S[axis]] + 100e3) for row in rows
                for axis in ("22", "33"))
    check.close(f"triaxial e0 = {e0}, cell pressure kept [Pa]", worst, 0.0,
                absolute=1e-4)

for e0, p, angle, at in (("0.60", 100, 47.5922, 0.0206),
                         ("0.75", 100, 36.1376, 0.0275),
                         ("0.60", 1000, 40.2211, 0.0603)):
    rows = run("biaxial", f"biaxial peak e0 = {e0}, p = {p} kPa", Void_ratio=e0,
               Vertical_pressure=p * 1e3, Axial_strain=0.08, Steps=4000)
    peak = max(rows, key=lambda row: row[FRICTION])
    check.close(f"biaxial e0 = {e0}, p = {p} kPa, peak [deg]", peak[FRICTION],
                angle, absolute=2e-4)
    check.close(f"biaxial e0 = {e0}, p = {p} kPa, strain of the peak",
                -peak["strain 11"], at, absolute=1e-4)

end = run("triaxial_drained", "triaxial critical state", Axial_strain=6,
          Steps=20000)[-1]
check.close("drained triaxial, critical friction angle [deg]", end[FRICTION],
            30.0, absolute=1e-3)
for e0 in (0.75, 0.8):
    rows = run("triaxial_undrained", f"undrained e0 = {e0}", Void_ratio=e0,
               Axial_strain=3, Steps=60000)
    check.close(f"undrained e0 = {e0}, change of the volume",
                max(abs(row["volumetric strain"]) for row in rows), 0.0,
                absolute=1e-12)
    check.close(f"undrained e0 = {e0}, change of the void ratio",
                max(abs(row["void ratio"] - e0) for row in rows), 0.0,
                absolute=1e-12)
    end = rows[-1]
    p = end["mean pressure [Pa]"]
    check.close(f"undrained e0 = {e0}, M", end["deviator [Pa]"] / p, 1.2, 1e-4)
    check.close(f"undrained e0 = {e0}, critical void ratio at the last pressure",
                0.82 * math.exp(-math.sqrt(3.0 * p / 190e6)), e0, 1e-4)
    check.close(f"undrained e0 = {e0}, total lateral stress [Pa]",
                end[S["22"]] - end["excess pore pressure [Pa]"], -100e3, 1e-9)

# The stress turns with the spin and must be turned back all the time, which
# costs an angle in proportion to sqrt(p): without it, tan = sin of the critical
# angle in plane strain.
angles = []
for pressure in (4e3, 16e3):
    end = run("simple_shear", f"simple shear p = {pressure:.0f} Pa",
              Shear_strain=8, Steps=20000, Vertical_pressure=pressure)[-1]
    angles.append(math.degrees(math.atan(end[S["12"]] / -end[S["22"]])))
check.close("simple shear, atan(s12/s22) at no pressure [deg]",
            2.0 * angles[0] - angles[1], 29.431, absolute=1e-3)
# m/(3 p d50) = a1 fd with fd = 1/sqrt(a1 ac - a1^2), where nothing changes any
# more under a curvature alone; a1 is that of an isotropic stress.
a1 = 1.0 / (math.sqrt(3.0 / 8.0) * (3.0 - 0.5) / 0.5)
for name, ac in (("1/a1", 1.0 / a1), ("a1 + 1/a1", a1 + 1.0 / a1)):
    end = run("curvature", f"curvature {name}",
              {"Materials/sand/Polar constant": name})[-1]
    check.close(f"curvature, a_c = {name}, m/(3 p d50)",
                end["couple stress 1 [N/m]"] /
                (3.0 * end["mean pressure [Pa]"] * 0.5e-3),
                a1 / math.sqrt(a1 * ac - a1 * a1), 1e-5)
check.finish()
