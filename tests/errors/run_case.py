#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs riedel with a wrong input and checks how it ends.

    run_case.py path/to/riedel case.prm

The program must end with exit code 2, write nothing to stdout, leave no files
behind, and its message must contain every line of case.expected, each once
(also under MPI). The first lines of case.prm may say

    # Arguments: --set "Loading/Stp = 0.5"
    # Ranks: 2
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    case = pathlib.Path(sys.argv[2]).resolve()
    text = case.read_text()
    expected = case.with_suffix(".expected").read_text().splitlines()
    if not any(expected):
        sys.exit(f"{case.with_suffix('.expected')} expects nothing")

    def setting(name):
        found = re.search(rf"^# {name}: (.*)$", text, re.MULTILINE)
        return found.group(1) if found else ""

    command = [str(program), case.name] + shlex.split(setting("Arguments"))
    if setting("Ranks"):
        command = ["mpirun", "--oversubscribe", "-np", setting("Ranks")] + command
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

    # The case is run where it is, since it includes its neighbours; a wrong
    # input must not make files, so there is nothing to clean up.
    before = sorted(os.listdir(case.parent))
    try:
        result = subprocess.run(command, cwd=case.parent, env=environment,
                                text=True, capture_output=True, timeout=60)
    except subprocess.TimeoutExpired:
        sys.exit("the program hangs")

    faults = []
    if result.returncode != 2:
        faults.append(f"exit code {result.returncode} instead of 2")
    for line in filter(None, expected):
        times = result.stderr.count(line)
        if times != 1:
            faults.append(f"{times} times instead of once: {line}")
    if not setting("Ranks") and result.stdout:
        faults.append("there is something on stdout:\n" + result.stdout)
    for word in ("Stacktrace", "terminate called", "An error occurred", "Errc:",
                 "std::"):
        if word in result.stderr:
            faults.append(f"users must not see {word!r}")
    if sorted(os.listdir(case.parent)) != before:
        faults.append("the program left files behind")

    if faults:
        sys.exit("\n".join(faults) + "\n--- stderr:\n" + result.stderr)


if __name__ == "__main__":
    main()
