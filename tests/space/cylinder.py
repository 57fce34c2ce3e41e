# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grid file (UCD) of a cylinder: a square of n x n cells in a ring of n/2
layers, and one layer along the axis."""

import math

# numbers of the boundaries
BOTTOM, TOP, SIDE = 1, 2, 3


def disc(n, radius):
    """Places and quadrilaterals of a disc, counterclockwise."""
    places, quads, number = [], [], {}

    def node(x, y):
        key = (round(x / radius, 9), round(y / radius, 9))
        if key not in number:
            number[key] = len(places)
            places.append((x, y))
        return number[key]

    half = 0.5 * radius

    def square(i, j):
        return half * (2 * i / n - 1), half * (2 * j / n - 1)

    for i in range(n):
        for j in range(n):
            quads.append([node(*square(i + a, j + b))
                          for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
    # along the edge of the square, counterclockwise from its lower left corner
    edge = ([square(i, 0) for i in range(n)] + [square(n, i) for i in range(n)] +
            [square(n - i, n) for i in range(n)] + [square(0, n - i)
                                                    for i in range(n)])
    layers = max(n // 2, 1)

    def ring(k, layer):
        angle = math.pi * (1.25 + 0.5 * k / n)
        x, y = edge[k % (4 * n)]
        share = layer / layers
        return ((1 - share) * x + share * radius * math.cos(angle),
                (1 - share) * y + share * radius * math.sin(angle))

    rim = []
    for k in range(4 * n):
        for layer in range(layers):
            quads.append([node(*ring(k, layer)), node(*ring(k, layer + 1)),
                          node(*ring(k + 1, layer + 1)),
                          node(*ring(k + 1, layer))])
        rim.append((node(*ring(k, layers)), node(*ring(k + 1, layers))))
    return places, quads, rim


def write(path, n, radius, length):
    places, quads, rim = disc(n, radius)
    above = len(places)
    faces = ([(BOTTOM, q) for q in quads] +
             [(TOP, [i + above for i in q]) for q in quads] +
             [(SIDE, [a, b, b + above, a + above]) for a, b in rim])
    lines = [f"{2 * above} {len(quads) + len(faces)} 0 0 0"]
    for z in (0.0, length):
        lines += [f"{len(lines) + k} {x:.17g} {y:.17g} {z:g}"
                  for k, (x, y) in enumerate(places)]
    cells = ([("0 hex", q + [i + above for i in q]) for q in quads] +
             [(f"{boundary} quad", q) for boundary, q in faces])
    lines += [f"{k} {kind} " + " ".join(str(i + 1) for i in corners)
              for k, (kind, corners) in enumerate(cells, 1)]
    path.write_text("\n".join(lines) + "\n")
