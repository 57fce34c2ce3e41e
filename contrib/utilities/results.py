# SPDX-License-Identifier: LGPL-2.1-or-later
"""A results folder of Riedel and its tables."""

import csv
import re

import h5py
import numpy as np


class LeftOut(Exception):
    """Why a picture cannot be drawn."""


def read_table(path):
    """The columns of a CSV file by their names."""
    if not path.exists():
        raise LeftOut(f"there is no {path.name}")
    with open(path, newline="") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    # a run that was killed may leave half a line
    rows = [row for row in rows if len(row) == len(header)]
    if not rows:
        raise LeftOut(f"{path.name} has no rows")
    return dict(zip(header, np.array(rows, dtype=float).T))


class Results:
    """A results folder."""

    def __init__(self, folder):
        self.folder = folder
        self.others = []  # element tests drawn into the same pictures
        self.parameters = (folder / "parameters.prm").read_text()
        log = folder / "log.txt"
        self.log = log.read_text() if log.exists() else ""

    def parameter(self, name):
        """The first parameter of this name, or an empty text."""
        found = re.search(rf"^\s*set {name} *=[ \t]*(.*)$", self.parameters, re.M)
        return found.group(1).strip() if found else ""

    def case(self):
        return (self.parameter("Title") or self.folder.resolve().name).replace("$", r"\$")

    def height(self):
        """Height of the undeformed body [m]; None if it is not a box."""
        edges = self.parameter("Box").split(",")
        return float(edges[1]) if len(edges) > 1 else None

    def watched(self, history):
        """Symbol of the displacement, displacement [m] and force [N/m] of the
        boundary that the terminal shows, both positive where it is pushed."""
        found = re.search(r"^P1 is the force (\d) on (.*) of the body", self.log, re.M)
        if not found:
            raise LeftOut("no boundary is moved, so none is watched")
        component, name = found.groups()
        displacement = history[f"{name} u{component} [m]"]
        sign = -1.0 if displacement[-1] < 0.0 else 1.0
        force = history[f"{name} force {component} [N/m]"]
        return f"u_{component}", sign * displacement, sign * force

    def plates(self, load):
        """Lower left and upper right corners of the plates at a load [m]."""
        section = re.search(r"^subsection Plates\n(.*?)^end", self.parameters, re.M | re.S)
        plates = []
        for name, text in re.findall(r"^  subsection (.*?)\n(.*?)^  end", section.group(1) if section else "",
                                     re.M | re.S):
            box = re.search(r"set Box *= *(.*)", text).group(1)
            corners = np.array([[float(x) for x in corner.split(",")] for corner in box.split(":")])
            history = read_table(self.folder / "history.csv")
            plates.append(corners + [np.interp(load, history["load [1]"], history[f"{name} u{d} [m]"]) for d in (1, 2)])
        return plates

    def point_file(self, load):
        """The points' file nearest to a load, or the last one."""
        files = []
        for path in sorted(self.folder.glob("points-*.h5")):
            try:
                with h5py.File(path) as file:
                    files.append((float(file.attrs["load"]), path))
            except OSError:
                print(f"{path.name} is not complete and is left out.")
        if not files:
            raise LeftOut("there are no files of points (Output/Write points)")
        if load is None:
            return files[-1][1]
        return min(files, key=lambda file: abs(file[0] - load))[1]

    def state(self, load):
        """E.g. "biaxial, s = 0.5, u1 = 2.5 mm, u1/h = 0.05"."""
        parts = [self.case(), f"$s = {load:.4g}$"]
        try:
            history = read_table(self.folder / "history.csv")
            symbol, displacement, _ = self.watched(history)
            u = np.interp(load, history["load [1]"], displacement)
            parts.append(f"${symbol} = {1e3 * u:.3g}$ mm")
            if self.height():
                parts.append(f"${symbol}/h = {u / self.height():.3g}$")
        except LeftOut:
            pass
        return ", ".join(parts)
