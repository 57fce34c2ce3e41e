#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""kill -9 at 20 random moments: every time the run can be resumed, and in the
end it is what it would have been without."""

import pathlib
import random
import shutil
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check
from tools import compare, kill, last_checkpoint, wait_for

KILLS = 20
check = Check(__doc__)
SCENE = "../specimen/case.prm"
SETTINGS = ["Grid/Cells=8,4", "Checkpoint/Every steps=1", "Checkpoint/Keep=1",
            "Loading/Stop=0.5", "Loading/Initial step=0.0005",
            "Loading/Largest step=0.0005", "Output/Fields every=0.002",
            "Output/Bands every=0.01"]
seed = random.randrange(1000)
chance = random.Random(seed)
print(f"      seed {seed}")

folder = check.results / "killed"
shutil.rmtree(folder, ignore_errors=True)
seconds_to_start = 0.5
kills = steps_before = 0
while kills < KILLS:
    before = last_checkpoint(folder)
    began = time.monotonic()
    process = check.start(SCENE, "killed", SETTINGS, resume=before != "")
    # half of them while it computes, half of them also while it resumes
    if before == "" or chance.random() < 0.5:
        if not wait_for(process, lambda: last_checkpoint(folder) != before):
            sys.exit(f"cannot be resumed from {before or 'the start'}:\n"
                     f"{process.communicate()[0]}")
        seconds_to_start = time.monotonic() - began
        time.sleep(chance.uniform(0.0, 0.3))
    else:
        time.sleep(chance.uniform(0.0, 1.5 * seconds_to_start))
    if process.poll() is not None:
        sys.exit(f"the run ended before it was killed:\n"
                 f"{process.communicate()[0]}")
    kill(process)
    kills += 1
reached = int(last_checkpoint(folder))
stop = (reached + 3) * 0.0005
print(f"      {KILLS} kills, the last checkpoint is of step {reached}")

SETTINGS.append(f"Loading/Stop={stop}")
resumed = check.run(SCENE, "killed", SETTINGS, resume=True)
reference = check.run(SCENE, "continuous", SETTINGS)
compare(check, f"after {KILLS} kills", resumed.history, reference.history, 1e-10)
names = {path.name for path in folder.iterdir()} ^ {
    path.name for path in reference.folder.iterdir()}
check.note(not names, f"the same files {sorted(names) or ''}")
check.finish()
