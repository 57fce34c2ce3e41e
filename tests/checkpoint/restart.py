#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are killed and resumed: the same as a run that goes on, to 1e-10 on
the same number of ranks; on other numbers within rounding errors. What a
resumed run refuses."""

import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check
from tools import compare, kill, last_checkpoint, wait_for

check = Check(__doc__)
SCENE = "../specimen/case.prm"
SETTINGS = ["Loading/Stop=0.18", "Checkpoint/Every steps=16",
            "Output/Fields every=0.08", "Output/Bands every=0.02"]
# steps that adapt themselves, on a grid of two levels
ADAPTIVE = ["Loading/Stop=0.06", "Checkpoint/Every steps=4",
            "Output/Fields every=0.03", "Output/Bands every=0.01",
            "Loading/Fixed steps=false", "Grid/Cells=10,5",
            "Grid/Refinements=1"]

# points that move through the grid
MOVING = ["Loading/Stop=0.06", "Checkpoint/Every steps=4",
          "Output/Fields every=0.03", "Output/Bands every=0.01"]


def lists(folder, name):
    """A list of files without the time of day in its head."""
    return [line for line in (folder / name).read_text().splitlines()
            if not line.startswith("#")]


def killed_run(scene, name, settings, ranks, every):
    """A run that is killed some steps after its second checkpoint."""
    folder = check.results / name
    shutil.rmtree(folder, ignore_errors=True)
    process = check.start(scene, name, settings, ranks)
    history = folder / "history.csv"
    check.note(wait_for(process, lambda: last_checkpoint(folder) != "" and
                        len(history.read_text().splitlines()) > 2 * every + 3),
               f"{name}: computing when it is killed")
    kill(process)
    return folder


for scene, ranks, settings, every in ((SCENE, 1, SETTINGS, 16),
                                      (SCENE, 2, ADAPTIVE, 4),
                                      ("moving.prm", 1, MOVING, 4)):
    there = f"on {ranks} ranks" if ranks > 1 else "on 1 rank"
    reference = check.run(scene, f"continuous_{pathlib.Path(scene).stem}_{ranks}", settings, ranks)
    killed = killed_run(scene, f"killed_{pathlib.Path(scene).stem}_{ranks}", settings, ranks, every)
    copy = check.results / f"moved_{pathlib.Path(scene).stem}_{ranks}"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(killed, copy)

    resumed = check.run(scene, killed.name, settings, ranks, resume=True)
    check.contains(f"a run resumed {there}", resumed.text,
                   "Resumed at s = ", f"from the checkpoint {2 * every:06d}.")
    compare(check, f"resumed {there}", resumed.history, reference.history,
            1e-10)
    check.note((killed / "bands.csv").read_text().splitlines()[0] ==
               (reference.folder / "bands.csv").read_text().splitlines()[0] and
               len((killed / "bands.csv").read_text().splitlines()) ==
               len((reference.folder / "bands.csv").read_text().splitlines()),
               "the same rows in bands.csv")
    for name in ("grid.pvd", "points.pvd"):
        check.note(lists(killed, name) == lists(reference.folder, name),
                   f"the same {name}")
    check.note(sorted(path.name for path in killed.iterdir()) ==
               sorted(path.name for path in reference.folder.iterdir()),
               "the same files")
    ours, expected = resumed.points(), reference.points()
    check.fields("the last points", 1e-10, **{
        name: (ours[name], expected[name], max(map(abs, expected[name])) or 1.0)
        for name in ("stress_11", "stress_12", "void_ratio", "displacement_2")})
    check.note(last_checkpoint(killed) == f"{int(resumed.history['step [1]'][-1]):06d}",
               "a checkpoint of the end")

    # on another number of ranks
    other = check.run(scene, copy.name, settings, 3 - ranks, resume=True)
    check.contains("another number of ranks", other.text,
                   "which was written on " + there[3:])
    fields = {name: (other.history[name], reference.history[name],
                     max(map(abs, reference.history[name])))
              for name in ("left force 1 [N/m]", "top u2 [m]", "volume [m2]",
                           "external work [J/m]")}
    check.fields(f"written {there}, resumed on {3 - ranks}", 1e-6, **fields)

# What may change and what may not.
name = "killed_case_1"
before = {path.name: path.read_bytes()
          for path in (check.results / name).iterdir() if path.is_file()}
refused = check.run(SCENE, name, SETTINGS + ["Initial state/Void ratio=0.61",
                                             "Solver/Residual=1e-9"],
                    resume=True, expect=2)
check.contains("the refusal", refused.text,
               'Initial state/Void ratio: "0.60" in the checkpoint, "0.61" now',
               "Set them back")
check.note("Solver/Residual:" not in refused.text, "it names no other parameter")
check.note({path.name: path.read_bytes()
            for path in (check.results / name).iterdir() if path.is_file()}
           == before, "the results are untouched")

longer = check.run(SCENE, name, ["Loading/Stop=0.188", "Loading/Largest step=0.1",
                                 "Checkpoint/Every steps=0",
                                 "Output/Fields every=0"], resume=True)
check.close("a run goes on with a larger Stop",
            longer.history["load [1]"][-1], 0.188, absolute=1e-12)
again = check.run(SCENE, name, ["Loading/Stop=0.188"], resume=True)
check.contains("a complete run", again.text, "has been reached")
check.note(again.history["load [1]"] == longer.history["load [1]"],
           "its history stays as it is")

# A damaged checkpoint: the one before it is used.
folder = check.results / name / "checkpoints"
newest = last_checkpoint(check.results / name)
(folder / newest / "state").write_bytes(b"")
fallback = check.run(SCENE, name, ["Loading/Stop=0.188"], resume=True)
check.contains("the fallback", fallback.text,
               f"{newest} cannot be used: the file state has 0 bytes")
compare(check, "after the fallback", fallback.history, longer.history, 1e-10)

for checkpoint in folder.iterdir():
    if checkpoint.is_dir():
        (checkpoint / "grid").unlink()
refused = check.run(SCENE, name, SETTINGS, resume=True, expect=2)
check.contains("without a good one", refused.text, "the file grid is missing",
               "no checkpoint to resume from", "--overwrite")

shutil.rmtree(check.results / "nothing", ignore_errors=True)
refused = check.run(SCENE, "nothing", SETTINGS, resume=True, expect=2)
check.contains("without results", refused.text, "there is nothing to resume")

# Ctrl-C and a step that cannot be solved leave a checkpoint.
name = "stopped"
shutil.rmtree(check.results / name, ignore_errors=True)
stopped = check.run(SCENE, name, ["Loading/Stop=0.1"], interrupt_after=4)
check.contains("Ctrl-C", stopped.text, "--resume")
step = int(stopped.history["step [1]"][-1])
check.note(last_checkpoint(stopped.folder) == f"{step:06d}",
           f"a checkpoint of step {step}")
resumed = check.run(SCENE, name, ["Loading/Stop=0.1"], resume=True)
check.close("it is resumed", resumed.history["load [1]"][-1], 0.1,
            absolute=1e-12)
check.note(resumed.history["step [1]"] == sorted(set(resumed.history["step [1]"])),
           "every step once")

failed = check.run("../endings/failing.prm", "failed", expect=1)
check.contains("a failed step", failed.text, "--resume", "may be changed")
load = failed.history["load [1]"][-1]
resumed = check.run("../endings/failing.prm", "failed",
                    ["Loading/Smallest step=1e-4", "Loading/Stop=0.0195"],
                    resume=True)
check.note(resumed.history["load [1]"][-1] > load,
           "it goes on with smaller steps")
check.finish()
