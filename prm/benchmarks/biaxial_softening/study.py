#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Biaxial softening on many grids, by both laws and both methods, and for several internal lengths: runs what is not
there yet, prints the table and draws the picture.

    study.py [--program build/release/riedel] [--results biaxial_softening_study] [--members fe-16,...] [picture.png]
"""

import argparse
import csv
import pathlib
import subprocess

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).resolve().parent
MATERIALS = ("body", "weak corner")
# Without a length the body snaps back on fine grids: s is then what the lower half of the side has moved down less than
# the upper one, which grows all the way.
CLASSICAL = [f"Materials/{name}/Law=Drucker-Prager" for name in MATERIALS] + [
    "Loading/Control=opening", "Loading/Opening/Component=2", "Loading/Opening/From=0.06, 0.09",
    "Loading/Opening/To=0.06, 0.03", "Loading/Opening/Final opening=0.0055"]
# the body bulges over the edge of its first grid
MOVING = ["Grid/Reference configuration=current", "Grid/Margin cells=0, 4, 0, 0"]
SHEAR_MODULUS = 40e6


def length(mm):
    return [f"Materials/{name}/Bending modulus={2 * SHEAR_MODULUS * (1e-3 * mm) ** 2:g}" for name in MATERIALS]


# method and cells along the short side; what differs from case.prm; length [mm]
MEMBERS = {f"fe-{n}": (n, [], 2) for n in (8, 16, 32, 64)}
MEMBERS |= {f"classical-{n}": (n, CLASSICAL, 2) for n in (8, 16, 32, 64)}
MEMBERS |= {f"mpm-{n}": (n, MOVING, 2) for n in (8, 16, 32, 64)}
MEMBERS |= {f"length-{mm}": (cells, length(mm), mm) for mm, cells in ((1, 64), (1.5, 32), (3, 16))}


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Member:
    """The curve of a run that has ended, over the shortening [mm], and its bands."""

    def __init__(self, folder, name):
        self.cells, _, self.length = MEMBERS[name]
        history = rows_of(folder / name / "history.csv")
        self.shortening = [-1e3 * float(row["top u2 [m]"]) for row in history]
        self.force = [-float(row["top force 2 [N/m]"]) / 1e3 for row in history]
        self.last = float(history[-1]["load [1]"])
        self.complete = self.last > 0.4 - 1e-9
        self.bands = rows_of(folder / name / "bands.csv")
        # of the shear strain for the law without rotations of its own
        self.thickness = ("thickness of shear strain at 50 % [mm]" if name.startswith("classical") else
                          "thickness at 50 % [mm]")

    def slope(self):
        """Mean slope of the force between 3/4 and 1/4 of what it loses in all [kN/m per mm]."""
        if not self.complete:
            return float("nan")
        top, end = max(self.force), self.force[-1]
        after = list(zip(self.shortening, self.force))[self.force.index(top):]
        places = []
        for share in (0.75, 0.25):
            level = end + share * (top - end)
            i = next(i for i, (_, f) in enumerate(after) if f <= level)
            (u0, f0), (u1, f1) = after[i - 1], after[i]
            places.append((u0 + (f0 - level) / (f0 - f1) * (u1 - u0), level))
        (u0, f0), (u1, f1) = places
        return (f1 - f0) / (u1 - u0)

    def at_end(self, column):
        return float(self.bands[-1][column]) if self.complete else float("nan")

    def narrowest(self):
        widths = [float(row[self.thickness]) for row in self.bands]
        return min((w for w in widths if w == w), default=float("nan"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=HERE.parents[2] / "build/release/riedel")
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("biaxial_softening_study"))
    parser.add_argument("--members", default=",".join(MEMBERS))
    parser.add_argument("picture", nargs="?")
    arguments = parser.parse_args()

    members = {}
    for name in arguments.members.split(","):
        cells, sets, _ = MEMBERS[name]
        folder = arguments.results / name
        log = folder / "log.txt"
        if not log.exists() or "total, all ranks" not in log.read_text():
            sets = sets + [f"Results={folder}", f"Grid/Cells={cells}, {2 * cells}", "Loading/Stop=0.4",
                           "Output/Bands every=0.05", "Output/Fields every=0.4"]
            command = [arguments.program, HERE / "case.prm", "--overwrite"]
            code = subprocess.run(command + [part for item in sets for part in ("--set", item)],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
            if code != 0:
                print(f"{name}: exit code {code}")
        members[name] = Member(arguments.results, name)

    print("| run | cells | L [mm] | largest force [kN/m] | force at the end | slope after the peak [kN/m per mm] "
          "| width at the end [mm] | narrowest [mm] | inclination [deg] |\n|---|---|---|---|---|---|---|---|---|")
    for name, member in members.items():
        ends = "" if member.complete else f", ends at s = {member.last:.3g}"
        print(f"| {name}{ends} | {member.cells} x {2 * member.cells} | {member.length} | {max(member.force):.3f} "
              f"| {member.force[-1]:.3f} | {member.slope():+.1f} | {member.at_end(member.thickness):.2f} "
              f"| {member.narrowest():.2f} | {member.at_end('inclination [deg]'):.1f} |")
    if arguments.picture:
        draw(members, arguments.picture)


def draw(members, path):
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10, 3.2), layout="constrained")
    styles = {"fe": ("-", "micropolar, finite elements"), "classical": ("--", "classical"),
              "mpm": (":", "micropolar, material points")}
    colours = {8: "tab:blue", 16: "tab:orange", 32: "tab:green", 64: "tab:red"}
    for name, member in members.items():
        kind = name.split("-")[0]
        if kind in styles:
            left.plot(member.shortening, member.force, styles[kind][0], color=colours[member.cells], lw=1,
                      label=f"60 mm/{member.cells}" if kind == "fe" else None)
    left.set_xlabel("shortening [mm]")
    left.set_ylabel("force [kN/m]")
    left.set_xlim(0, 2.4)
    left.legend(fontsize=7, title="cells", title_fontsize=7)
    left.set_title("solid micropolar FE, dotted MPM, dashed classical", fontsize=8)
    for kind, (line, label) in styles.items():
        points = [(60 / m.cells, m.at_end(m.thickness)) for name, m in members.items() if name.startswith(kind)]
        middle.plot(*zip(*points), line, marker="o", ms=3, label=label)
    middle.set_xscale("log")
    sizes = [60 / cells for cells in colours]
    middle.set_xticks(sizes, [f"{size:.3g}" for size in sizes])
    middle.minorticks_off()
    middle.set_ylim(0, None)
    middle.set_xlabel("cell size [mm]")
    middle.set_ylabel("width of the band at the end [mm]")
    middle.legend(fontsize=7)
    points = sorted((m.length, m.narrowest()) for name, m in members.items()
                    if name.startswith("length") or name == "fe-32")
    right.plot(*zip(*points), "o", ms=4)
    mean = sum(w / x for x, w in points) / len(points)
    right.plot([0, points[-1][0]], [0, mean * points[-1][0]], "-", lw=0.8, label=f"{mean:.2f} L")
    right.set_xlabel("internal length L [mm]")
    right.set_ylabel("narrowest width [mm]")
    right.legend(fontsize=7)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    main()
