#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the columns of a table with expected ones.

    compare_csv.py RESULT.csv EXPECTED.csv TOLERANCES

TOLERANCES has a line for every column that is compared:

    left force 1 [N/m]: relative 1e-6, absolute 0.01
    top u2 [m]:         relative 1e-5 of peak
    key: load [1]

Either tolerance may be missing. A value b is met by a if
|a - b| <= max(R |b|, A); "of peak" puts the column's largest |b| in the place
of |b|. With a key (a column), every row of EXPECTED is compared with the row of
the same key, to 1e-9; without one, the last rows are compared. "#" starts a
comment.
"""

import csv
import math
import re
import sys


def read_table(path):
    with open(path, newline="") as file:
        header, *rows = [row for row in csv.reader(file)
                         if row and not row[0].startswith("#")]
    return [dict(zip(header, map(float, row))) for row in rows]


def read_tolerances(path):
    """(relative, of peak, absolute) by column, and the key or None."""
    key, tolerances = None, {}
    number = r"([-+.0-9eE]+)"
    with open(path) as file:
        lines = [line.split("#")[0].strip() for line in file]
    for line in filter(None, lines):
        column, _, text = map(str.strip, line.rpartition(":"))
        if column == "key":
            key = text
            continue
        relative = re.search(rf"relative {number}( of peak)?", text)
        absolute = re.search(rf"absolute {number}", text)
        rest = re.sub(rf"relative {number}( of peak)?|absolute {number}|,", "",
                      text).strip()
        if not column or rest or not (relative or absolute):
            sys.exit(f"{path}: cannot read {line!r}")
        tolerances[column] = (float(relative[1]) if relative else 0.0,
                              bool(relative and relative[2]),
                              float(absolute[1]) if absolute else 0.0)
    if not tolerances:
        sys.exit(f"{path}: no columns to compare")
    return tolerances, key


def pair_rows(result, expected, key):
    """Rows of the result and of what is expected that belong together."""
    if not result or not expected:
        sys.exit("a table without rows")
    if key is None:
        return [(result[-1], expected[-1])]
    pairs = []
    for row in expected:
        near = min(result, key=lambda other: abs(other[key] - row[key]))
        if not abs(near[key] - row[key]) <= 1e-9 * max(1.0, abs(row[key])):
            sys.exit(f"the result has no row with {key} = {row[key]}")
        pairs.append((near, row))
    return pairs


def compare(result, expected, tolerances, key):
    """Prints the worst deviation of every column; True if all pass."""
    good = True
    columns = list(tolerances) + ([key] if key else [])
    for table, name in ((result, "result"), (expected, "expected table")):
        for column in columns:
            if table and column not in table[0]:
                sys.exit(f"the {name} has no column {column!r}")
    pairs = pair_rows(result, expected, key)
    for column, (relative, of_peak, absolute) in tolerances.items():
        peak = max(abs(row[column]) for row in expected)
        worst, text = -1.0, ""
        for ours, theirs in pairs:
            a, b = ours[column], theirs[column]
            allowed = max(relative * (peak if of_peak else abs(b)), absolute)
            share = abs(a - b) / allowed if allowed > 0.0 else (
                0.0 if a == b else math.inf)
            if not share <= worst:  # not a number is the worst
                place = f" at {key} = {theirs[key]:g}" if key else ""
                worst, text = share, (
                    f"{a:.10g}, expected {b:.10g} +- {allowed:.1e}{place}")
                if math.isnan(share):
                    break
        passed = worst <= 1.0
        good = good and passed
        print(f"{'      ' if passed else 'FAULT '}{column}: worst {text}: "
              f"{worst:.1e} of what is allowed")
    return good


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    tolerances, key = read_tolerances(sys.argv[3])
    good = compare(read_table(sys.argv[1]), read_table(sys.argv[2]),
                   tolerances, key)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
