# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are killed."""

import math
import os
import pathlib
import signal
import time


def kill(process):
    """kill -9 to all ranks of a run."""
    ranks = [process.pid]
    if process.args[0] == "mpirun":
        # it notices that its ranks are gone, and ends
        children = f"/proc/{process.pid}/task/{process.pid}/children"
        try:
            ranks = map(int, pathlib.Path(children).read_text().split())
        except OSError:
            ranks = []
    for rank in ranks:
        try:
            os.kill(rank, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.communicate(timeout=60)


def last_checkpoint(folder):
    """What the marker names, or nothing."""
    try:
        return (folder / "checkpoints" / "last").read_text().strip()
    except OSError:
        return ""


def wait_for(process, condition):
    """Until the condition holds; False if the run ends before."""
    while not condition():
        if process.poll() is not None:
            return False
        time.sleep(0.002)
    return True


def compare(check, what, ours, expected, tolerance, first=0):
    """Two histories from a row on: all but times, and residuals, which are
    rounding errors; relative to the largest value of a column."""
    skipped = ("cpu time [s]", "force residual [1]", "moment residual [1]",
               "energy error [1]")
    check.note(list(ours) == list(expected), f"{what}: the same columns")
    check.fields(what, tolerance, **{
        name: (ours[name][first:], expected[name][first:],
               max((abs(value) for value in expected[name]
                    if not math.isnan(value)), default=0.0) or 1.0)
        for name in expected if name not in skipped})
