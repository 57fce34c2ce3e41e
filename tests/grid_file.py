# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane grid files (UCD) of blocks of cells with graded edges."""


def graded(length, smallest, ratio):
    """Places from 0 to length whose distances grow by about the ratio, from
    about the smallest one on."""
    steps = [smallest]
    while sum(steps) < length:
        steps.append(steps[-1] * ratio)
    scale = length / sum(steps)
    places = [0.0]
    for step in steps:
        places.append(places[-1] + scale * step)
    places[-1] = length
    return places


def write_block(path, n_1, n_2, place, boundary):
    """A block of n_1 x n_2 cells with nodes at place(i, j), a right-handed
    numbering. The boundary number of an edge of the block is
    boundary(side, k) for side "low 1", "high 1", "low 2" or "high 2" and its
    k-th cell."""
    def node(i, j):
        return 1 + i + (n_1 + 1) * j

    nodes = [place(i, j) for j in range(n_2 + 1) for i in range(n_1 + 1)]
    elements = [("0 quad", (node(i, j), node(i + 1, j), node(i + 1, j + 1),
                            node(i, j + 1)))
                for j in range(n_2) for i in range(n_1)]
    for k in range(n_2):
        for side, i in (("low 1", 0), ("high 1", n_1)):
            elements.append((f"{boundary(side, k)} line",
                             (node(i, k), node(i, k + 1))))
    for k in range(n_1):
        for side, j in (("low 2", 0), ("high 2", n_2)):
            elements.append((f"{boundary(side, k)} line",
                             (node(k, j), node(k + 1, j))))
    lines = [f"{len(nodes)} {len(elements)} 0 0 0"]
    lines += [f"{k} {x:.17g} {y:.17g} 0" for k, (x, y) in enumerate(nodes, 1)]
    lines += [f"{k} {kind} " + " ".join(map(str, corners))
              for k, (kind, corners) in enumerate(elements, 1)]
    path.write_text("\n".join(lines) + "\n")
