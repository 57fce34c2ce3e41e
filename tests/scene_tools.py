# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the checks of scenes share: run the program, read its results, judge.

A check is a script next to its scenes. ctest runs it as

    check.py --program path/to/riedel --results folder/for/results
"""

import argparse
import csv
import math
import os
import pathlib
import signal
import subprocess
import sys
import time


class Run:
    """One finished run of the program."""

    def __init__(self, folder, code, text):
        self.folder, self.code, self.text = folder, code, text

    @property
    def history(self):
        """The columns of history.csv by their names."""
        with open(self.folder / "history.csv", newline="") as file:
            header, *rows = csv.reader(file)
        return {name: [float(row[i]) for row in rows]
                for i, name in enumerate(header)}

    def points(self, number=-1):
        """The columns of one points-NNNN.h5, the last one by default, sorted
        by the points' places; with the initial place as X, Y and in space Z."""
        import h5py
        files = sorted(self.folder.glob("points-*.h5"))
        with h5py.File(files[number]) as file:
            table = {name: file[name][()].tolist() for name in file}
            load = float(file.attrs["load"])
        axes = [axis for axis in "XYZ" if
                f"position_{'XYZ'.index(axis) + 1}" in table]
        for number, axis in enumerate(axes, 1):
            table[axis] = [x - u for x, u in
                           zip(table[f"position_{number}"],
                               table[f"displacement_{number}"])]
        order = sorted(range(len(table["X"])),
                       key=lambda p: [round(table[axis][p], 9) for axis in axes])
        table = {name: [column[p] for p in order]
                 for name, column in table.items()}
        table["load"] = load
        return table

    def all_points(self):
        return [self.points(n)
                for n in range(len(list(self.folder.glob("points-*.h5"))))]


class Check:
    """Runs scenes and counts what differs from what is expected."""

    def __init__(self, description):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("--program", required=True, type=pathlib.Path)
        parser.add_argument("--results", required=True, type=pathlib.Path)
        arguments = parser.parse_args()
        self.program = arguments.program.resolve()
        self.results = arguments.results.resolve()
        self.results.mkdir(parents=True, exist_ok=True)
        self.faults = 0
        self.here = pathlib.Path(sys.argv[0]).resolve().parent

    def command(self, case, name, settings=(), ranks=1, overwrite=True,
                resume=False):
        command = [str(self.program), str(case),
                   "--set", f"Results={self.results / name}"]
        for setting in settings:
            command += ["--set", setting]
        if resume:
            command.append("--resume")
        elif overwrite:
            command.append("--overwrite")
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(ranks)] + command
        return command

    def start(self, *arguments, **options):
        """A run of a case of this folder, as for command()."""
        return subprocess.Popen(
            self.command(*arguments, **options),
            cwd=self.here, text=True, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env=dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                     OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"))

    def run(self, case, name, settings=(), ranks=1, overwrite=True, expect=0,
            interrupt_after=None, resume=False):
        """Runs a case of this folder. With interrupt_after, the program gets
        Ctrl-C as soon as its history has so many rows."""
        process = self.start(case, name, settings, ranks, overwrite, resume)
        if interrupt_after is not None:
            history = self.results / name / "history.csv"
            while process.poll() is None:
                if (history.exists() and
                        len(history.read_text().splitlines()) > interrupt_after):
                    process.send_signal(signal.SIGINT)
                    break
                time.sleep(0.02)
        text = process.communicate(timeout=600)[0]
        if process.returncode != expect:
            self.faults += 1
            print(f"FAULT {name}: exit code {process.returncode} instead of "
                  f"{expect}\n{text}")
            if process.returncode not in (0, 1, 2) or expect == 0:
                sys.exit(1)
        return Run(self.results / name, process.returncode, text)

    def note(self, good, text):
        self.faults += not good
        print(("      " if good else "FAULT ") + text)

    def close(self, what, ours, expected, relative=0.0, absolute=0.0):
        """One number against its expected value."""
        error = abs(ours - expected)
        allowed = max(relative * abs(expected), absolute)
        size = abs(expected) if relative > 0.0 and expected != 0.0 else 1.0
        self.note(error <= allowed,
                  f"{what}: {ours:.10g}, expected {expected:.10g}, error "
                  f"{error / size:.1e} of {allowed / size:.1e}")

    def fields(self, what, relative, **fields):
        """Lists of numbers: name=(ours, expected, scale), where expected is a
        list or one number for all; the errors are measured by scale. What
        cannot be measured (nan) must be so in both. Reports the worst."""
        worst, which = -1.0, ""
        for name, (ours, expected, scale) in fields.items():
            if not isinstance(expected, (list, tuple)):
                expected = [expected] * len(ours)
            same = len(ours) == len(expected) > 0
            error = max((0.0 if math.isnan(a) and math.isnan(b) else
                         abs(a - b) / scale for a, b in zip(ours, expected)),
                        default=math.inf) if same else math.inf
            if not error <= worst:  # not a number is the worst
                worst, which = error, name
        self.note(worst <= relative, f"{what}: largest error {worst:.1e} of "
                  f"{relative:.0e} allowed, in {which}")

    def order(self, what, errors, expected, refinement=2.0):
        """The order of convergence from the errors on ever finer grids; the
        last two grids must show it."""
        orders = [math.log(a / b) / math.log(refinement)
                  for a, b in zip(errors, errors[1:])]
        self.note(orders[-1] >= expected - 0.2,
                  f"{what}: errors " + ", ".join(f"{e:.2e}" for e in errors) +
                  "; orders " + ", ".join(f"{o:.2f}" for o in orders) +
                  f"; expected {expected}")

    def slid_block(self, what, points, relative):
        """The block of points/slide.prm under 40 and 100 kPa, 40 mm to the
        right of where it was: only its place has changed."""
        p = points
        self.fields(what, relative,
                    s11=(p["stress_11"], -40e3, 100e3),
                    s22=(p["stress_22"], -100e3, 100e3),
                    s33=(p["stress_33"], -40e3, 100e3),
                    s12=(p["stress_12"], 0.0, 100e3),
                    s21=(p["stress_21"], 0.0, 100e3),
                    m1=(p["couple_stress_1"], 0.0, 50.0),
                    m2=(p["couple_stress_2"], 0.0, 50.0),
                    rotation=(p["micro_rotation"], 0.0, 1.0),
                    u1=(p["displacement_1"], 0.04, 0.04),
                    u2=(p["displacement_2"], 0.0, 0.04),
                    volume=([v / v0 for v, v0 in
                             zip(p["volume"], p["initial_volume"])], 1.0, 1.0),
                    void_ratio=(p["void_ratio"], 0.6, 1.0))

    def same_history(self, what, ours, reference, before_peak, after_peak):
        """Forces, displacement, volume and work of a specimen that is
        compressed: relative to each value before the peak of the force, to the
        largest one after it."""
        force = [abs(value) for value in reference["left force 1 [N/m]"]]
        peak = force.index(max(force))
        self.note(0 < peak < len(force) - 10,
                  f"{what}: peak at s = {reference['load [1]'][peak]:g}")
        self.fields(f"{what}: loads", 1e-12,
                    load=(ours["load [1]"], reference["load [1]"], 1.0))
        columns = ("left force 1 [N/m]", "right force 1 [N/m]",
                   "bottom force 2 [N/m]", "top u2 [m]", "volume [m2]",
                   "external work [J/m]")
        self.fields(f"{what}, before the peak", before_peak, **{
            c: ([a / b for a, b in zip(ours[c][1:peak], reference[c][1:peak])],
                1.0, 1.0) for c in columns})
        self.fields(f"{what}, after the peak", after_peak, **{
            c: (ours[c][peak:], reference[c][peak:],
                max(map(abs, reference[c]))) for c in columns})

    def contains(self, what, text, *words):
        for word in words:
            self.note(word in text, f"{what} says {word!r}"
                      + ("" if word in text else f":\n{text}"))

    def finish(self):
        print(f"{self.faults} faults" if self.faults else "all as expected")
        sys.exit(1 if self.faults else 0)


def l2_error(points, ours, exact):
    """Root of the integral of (ours - exact)^2 over the body by the points'
    volumes; exact is a function of the initial place."""
    return math.sqrt(sum(
        v * (u - exact(x, y)) ** 2
        for v, u, x, y in zip(points["volume"], points[ours],
                              points["X"], points["Y"])))


ELEMENTS = {
    "Q1/Q1 full": (1, 1, "full"),
    "Q1/Q1 mean dilatation": (1, 1, "mean dilatation"),
    "Q1/Q1 assumed": (1, 1, "assumed"),
    "Q2/Q1 full": (2, 1, "full"),
    "Q2/Q2 full": (2, 2, "full"),
    "Q2/Q2 mean dilatation": (2, 2, "mean dilatation"),
    "Q2/Q2 assumed": (2, 2, "assumed"),
}


def element_settings(name):
    u, w, sampling = ELEMENTS[name]
    return [f"Grid/Displacement degree={u}", f"Grid/Rotation degree={w}",
            f"Grid/Strain sampling={sampling}"]


def file_name(text):
    return "".join(c if c.isalnum() else "_" for c in text)
