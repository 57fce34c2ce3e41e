#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How runs end: a failure, Ctrl-C, a results folder that exists."""

import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)
SCENE = "../specimen/case.prm"
for name in ("failing", "failing_on_two", "interrupted", "again"):
    shutil.rmtree(check.results / name, ignore_errors=True)

# A step that cannot be solved: exit code 1, a message that names the step, the
# place and the parameter, and the results so far.
failed = check.run("failing.prm", "failing", expect=1)
check.contains("the message of a failed run", failed.text,
               "The step from s = ", " cannot be solved: ",
               "Loading/Smallest step = 0.001", "Results up to s = ")
message = failed.text[failed.text.find("The step from s = "):]
check.note(re.search(r"\(-?[\d.e-]+ -?[\d.e-]+\) m|at -?[\d.e-]+", message)
           is not None, "it names a place")
load = failed.history["load [1]"][-1]
check.note(0 < load <= 0.02, f"the history ends at s = {load:g}, before the jump")
points = failed.points()
check.close("the last fields are those of the last step", points["load"], load,
            absolute=1e-12)
check.contains("log.txt", (failed.folder / "log.txt").read_text(),
               " not solved: ", "Where the time went")

# The same on two ranks: the message comes once and nothing hangs.
failed = check.run("failing.prm", "failing_on_two", ranks=2, expect=1)
check.note(failed.text.count(" cannot be solved: ") == 1,
           "the message comes once on two ranks")

# Ctrl-C: the step is finished, everything is written, exit code 0.
interrupted = check.run(SCENE, "interrupted", interrupt_after=4)
check.contains("log.txt", (interrupted.folder / "log.txt").read_text(),
               "Interrupted", "Where the time went")
load = interrupted.history["load [1]"][-1]
check.note(load < 0.29, f"it stopped at s = {load:g}")
check.close("the last fields are those of the last step",
            interrupted.points()["load"], load, absolute=1e-12)

# The folder of an earlier run is refused and left as it is; with --overwrite
# the run is repeated.
short = ["Loading/Stop=0.008"]
first = check.run(SCENE, "again", short, overwrite=False)
before = (first.folder / "history.csv").read_bytes()
refused = check.run(SCENE, "again", short, overwrite=False, expect=2)
check.contains("the refusal", refused.text, "exists", "--overwrite")
check.note((first.folder / "history.csv").read_bytes() == before,
           "the earlier results are untouched")
second = check.run(SCENE, "again", short)
for column in ("left force 1 [N/m]", "top u2 [m]", "volume [m2]"):
    check.note(second.history[column] == first.history[column],
               f"the second run has the same {column}")
check.finish()
