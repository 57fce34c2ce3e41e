#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scenes of prm/papers/tejchman_patterning, on a coarse grid: all are valid; the
stage before the loading ends in balance at s = 0; both boundary sets give the same
on 1 and 2 ranks; and contrib/reproduce runs only what is not there."""

import pathlib
import re
import signal
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from scene_tools import Check

check = Check(__doc__)
FOLDER = ROOT / "prm/papers/tejchman_patterning"
COARSE = ["Grid/Cells=16, 8", "Output/Fields every=0", "Output/Bands every=0"]

for scene in sorted(FOLDER.glob("*.prm")):
    if scene.stem.startswith("figure"):
        done = subprocess.run([check.program, scene, "--validate"], text=True, capture_output=True)
        check.note(done.returncode == 0, f"{scene.name} is valid {done.stderr}")

# forces [N/m] of a run on one rank, at the first row of a load; of two ranks the same
COLUMNS = ("left force 1 [N/m]", "top force 2 [N/m]", "top u2 [m]", "volume [m2]")


def runs(figure, stop):
    histories = [check.run(FOLDER / f"figure_{figure}.prm", f"{figure}_{ranks}",
                           COARSE + [f"Loading/Stop={stop}", "Solver/Residual=1e-10", "Loading/Fixed steps=true",
                                     "Loading/Largest step=0.015"], ranks).history
                 for ranks in (1, 2)]
    one, two = histories
    check.fields(f"figure {figure} on 2 ranks", 1e-7,
                 **{name: (two[name], one[name], max(map(abs, one[name]))) for name in COLUMNS})
    return one


history = runs("09b", 0.05)
load = history["load [1]"]
check.close("first load", load[0], -0.2)
check.note(0.0 in load, "a step ends at s = 0")
before = [row for row, s in enumerate(load) if s <= 0.0]
check.fields("total pressure while it goes over to the profile", 1e-9,
             top=([history["top force 2 [N/m]"][row] for row in before], -50e3, 50e3))
check.fields("the sides wait", 1e-15, left=([history["left u1 [m]"][row] for row in before], 0.0, 1.0))
check.close("the sides move then [m]", history["left u1 [m]"][-1], 0.005 * 0.05, relative=1e-9)

history = runs("17", 0.1)
check.fields("the platen rises as the sides come", 1e-12,
             top=(history["top u2 [m]"], history["left u1 [m]"], 0.0005))
check.note(history["left force 1 [N/m]"][-1] > 1.5 * abs(history["top force 2 [N/m]"][-1]) > 1e3,
           f"P1 {history['left force 1 [N/m]'][-1]:.0f} N/m, P2 {history['top force 2 [N/m]'][-1]:.0f} N/m")

# -------------------------------------------------------- contrib/reproduce
PYTHON = "/usr/bin/python3"  # where matplotlib is
COMMAND = [PYTHON, ROOT / "contrib/reproduce", "tejchman_patterning", "--program", check.program,
           "--results", check.results / "study", "--figures", "04,07,17", "--set", "Grid/Cells=16, 8"]


def reproduce(stop, *more):
    return subprocess.run(COMMAND + ["--set", f"Loading/Stop={stop}", *more], text=True, capture_output=True)


def told(text):
    """What was said of every run, in the order of the figures."""
    return [re.search(rf"{figure}-paper: (.*)", text).group(1) for figure in ("04", "07", "17")]


# killed as soon as the first run is there
process = subprocess.Popen(COMMAND + ["--set", "Loading/Stop=0.3"], text=True, stdout=subprocess.PIPE)
check.note("04-paper: done" in process.stdout.readline(), "the first figure is told when it is there")
process.send_signal(signal.SIGKILL)
process.wait()
first = reproduce(0.3)
check.note(first.returncode == 0 and told(first.stdout) == ["is there", "done", "done"],
           f"after the kill: {first.stdout}{first.stderr}")
again = reproduce(0.3)
check.note(told(again.stdout) == ["is there"] * 3, "nothing is run twice")
changed = reproduce(0.2)
check.note(told(changed.stdout) == ["done"] * 3, "other input is run again")
table = (check.results / "study/table.md").read_text()
check.contains("the table", table, "4 and 5", "17 and 18", "t, published [d50]", "t [d50], paper")
check.note((check.results / "study/pictures.png").stat().st_size > 10000, "there is a page of pictures")
check.finish()
