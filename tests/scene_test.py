#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs case.prm of a folder and compares its history.csv with expected.csv of
the folder, by tolerances.txt.

To renew expected.csv after a change of results that is meant:

    scene_test.py --program riedel --results /tmp/x --folder F --ranks 1 --renew
"""

import argparse
import csv
import os
import pathlib
import subprocess
import sys

import compare_csv

RENEW_EVERY = 5  # rows of the history


def renew(history, folder):
    """The compared columns of every fifth row."""
    tolerances, key = compare_csv.read_tolerances(folder / "tolerances.txt")
    columns = ([key] if key else []) + list(tolerances)
    with open(history, newline="") as file:
        rows = list(csv.DictReader(file))
    with open(folder / "expected.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore",
                                lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[::RENEW_EVERY] if key else rows[-1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, type=pathlib.Path)
    parser.add_argument("--results", required=True, type=pathlib.Path)
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    parser.add_argument("--ranks", default=1, type=int)
    parser.add_argument("--renew", action="store_true")
    arguments = parser.parse_args()
    results = arguments.results.resolve()
    folder = arguments.folder.resolve()

    command = [str(arguments.program.resolve()), "case.prm", "--overwrite",
               "--set", f"Results={results}"]
    if arguments.ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np",
                   str(arguments.ranks)] + command
    results.parent.mkdir(parents=True, exist_ok=True)
    run = subprocess.run(
        command, cwd=folder, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"))
    if run.returncode != 0:
        sys.exit(f"exit code {run.returncode}:\n{run.stdout}")
    if arguments.renew:
        renew(results / "history.csv", folder)
        return
    tolerances, key = compare_csv.read_tolerances(folder / "tolerances.txt")
    good = compare_csv.compare(
        compare_csv.read_table(results / "history.csv"),
        compare_csv.read_table(folder / "expected.csv"), tolerances, key)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
