# SPDX-License-Identifier: LGPL-2.1-or-later
"""The neo-Hookean micropolar solid of solid.prm, written down once more."""

import numpy

LAMBDA, MU, KAPPA = 1500.0, 1000.0, 2 * 500.0


def rotation(vector):
    """The rotation by a rotation vector (Rodrigues)."""
    angle = numpy.linalg.norm(vector)
    if angle == 0.0:
        return numpy.eye(3)
    x, y, z = vector / angle
    n = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * n + (1 - numpy.cos(angle)) * n @ n


def stress(gradient, vector):
    """Cauchy stress and J of the displacement gradient and the grains'
    rotation vector, without curvature (physics of doc/theory/elastoplasticity.md)."""
    F = numpy.eye(3) + gradient
    V = F @ rotation(vector).T
    J = numpy.linalg.det(F)
    tau = (LAMBDA / 2 * (J * J - 1) * numpy.eye(3) + MU * (V @ V.T - numpy.eye(3))
           + KAPPA / 2 * (V @ V.T - (V @ V).T))
    return tau / J, J


def couple_load(gradient, vector):
    """The couple per initial volume that balances the skew stress."""
    sigma, J = stress(gradient, vector)
    return J * numpy.array([sigma[1, 2] - sigma[2, 1], sigma[2, 0] - sigma[0, 2],
                            sigma[0, 1] - sigma[1, 0]])


def couple_settings(gradient, vector, steps):
    """Body couples, formulas in s that hold at the ends of so many equal
    steps of a proportional strain and rotation."""
    s = [(n + 1) / steps for n in range(steps)]
    loads = numpy.array([couple_load(t * gradient, t * vector) for t in s])
    # s times a polynomial of as many terms as there are steps
    terms = numpy.linalg.solve([[t ** (p + 1) for p in range(steps)] for t in s],
                               loads)
    return [f"Loading/Body couple {k + 1}=" +
            " + ".join(f"({terms[p][k]:.17g})*s^{p + 1}" for p in range(steps))
            for k in range(3)]


def errors(points, gradient, vector):
    """The fields of a homogeneous state for Check.fields."""
    sigma, J = stress(gradient, vector)
    scale = abs(sigma).max()
    place = numpy.array([points["X"], points["Y"], points["Z"]])
    u = gradient @ place
    fields = {}
    for i in range(3):
        for j in range(3):
            fields[f"s{i + 1}{j + 1}"] = (points[f"stress_{i + 1}{j + 1}"],
                                          sigma[i, j], scale)
            fields[f"m{i + 1}{j + 1}"] = (points[f"couple_stress_{i + 1}{j + 1}"],
                                          0.0, 0.2 * scale)
        fields[f"u{i + 1}"] = (points[f"displacement_{i + 1}"], u[i].tolist(), 0.1)
        fields[f"rotation{i + 1}"] = (points[f"micro_rotation_{i + 1}"],
                                      float(vector[i]), 0.1)
    fields["volume"] = ([v / v0 for v, v0 in zip(points["volume"],
                                                points["initial_volume"])], J, 1.0)
    return fields
