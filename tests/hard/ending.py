#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that cannot go on as they are: they say why and how, and can go on."""

import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from scene_tools import Check

check = Check(__doc__)

# A specimen that grows into the end of the grid: the run stops and says what to
# do, or goes on without the points that have left.
TOUCHING = ["Grid/Margin cells=0,0,0,0", "Material points/Per axis=4",
            "Loading/Stop=0.3"]
SCENE = "../points/debug.prm"
stopped = check.run(SCENE, "touching", TOUCHING +
                    ["Checkpoint/Every steps=4"], expect=1)
check.contains("the message", stopped.text, "has left the grid",
               "Grid/Margin cells", "Leaving points = remove",
               "Results up to s = 0.22", "The last checkpoint is that of step "
               "000008", "--resume")
history = check.run(SCENE, "touching", TOUCHING +
                    ["Material points/Leaving points=remove"],
                    resume=True).history
removed = history["removed points [1]"][-1]
check.note(removed > 0, f"resumed: {removed:g} points have left")
check.close("resumed: load", history["load [1]"][-1], 0.3)
check.close("resumed: points", history["points [1]"][-1],
            history["points [1]"][0] + history["split points [1]"][-1]
            - history["merged points [1]"][-1] - removed)

# A step that cannot be solved: the last good state is on the disk, and the
# message says with which setting the run goes on.
for scene, ranks, last in (("../specimen/case.prm", 1, "000005"), (SCENE, 2, "000007")):
    name = f"unsolved_{pathlib.Path(scene).stem}"
    settings = ["Grid/Cells=10,5", "Loading/Initial step=0.03",
                "Loading/Largest step=0.03", "Loading/Stop=0.24",
                "Solver/Most iterations=8", "Solver/Residual=1e-6",
                "Output/Fields every=0"]
    failed = check.run(scene, name, settings + ["Loading/Fixed steps=true"],
                       ranks, expect=1)
    check.contains(name, failed.text, "cannot be solved",
                   "Loading/Fixed steps forbids a smaller one",
                   f'riedel {scene} --resume --set "Loading/Fixed steps=false"')
    before = failed.history
    steps = before["step [1]"]
    check.note((failed.folder / "checkpoints" / "last").read_text().strip() ==
               f"{steps[-1]:06.0f}", f"{name}: step {steps[-1]:g} is on the disk")
    resumed = check.run(scene, name, settings + ["Loading/Fixed steps=false"],
                        ranks, resume=True).history
    check.close(f"{name}: resumed to", resumed["load [1]"][-1], 0.24)
    check.fields(f"{name}: its history is kept", 0.0,
                 load=(resumed["load [1]"][:len(steps)],
                       before["load [1]"], 1.0))
check.finish()
