# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deformed body of one output: from the files of points and grid to triangles
or boxes."""

import base64
import zlib
from xml.etree import ElementTree

import h5py
import numpy as np
from matplotlib.tri import CubicTriInterpolator, TriAnalyzer, Triangulation, UniformTriRefiner


def decode(array):
    """The numbers of a DataArray of a .vtu file as deal.II writes it."""
    header = 24  # four integers in base 64
    numbers = zlib.decompress(base64.b64decode(array.text.strip()[header:]))
    columns = int(array.get("NumberOfComponents", 1))
    return np.frombuffer(numbers, dtype="<f4").reshape(-1, columns).astype(float)


def read_nodes(path):
    """Present position, displacement [m] and, if any, micro-rotation of the
    nodes of the grid; of a node on several cells only once."""
    if not path.exists():
        return np.empty((2, 0)), np.empty((2, 0)), np.empty(0)
    position, displacement, rotation = [], [], []
    for piece in ElementTree.parse(path).iter("Piece"):
        fields = {array.get("Name"): array for array in piece.find("PointData")}
        position.append(decode(piece.find("Points/DataArray")))
        displacement.append(decode(fields["displacement(m)"]))
        if "micro_rotation(rad)" in fields:
            rotation.append(decode(fields["micro_rotation(rad)"])[:, 0])
    position, displacement = np.vstack(position)[:, :2], np.vstack(displacement)[:, :2]
    rotation = np.concatenate(rotation) if rotation else np.zeros(len(position))
    # by rounded coordinates, twice: two copies may be rounded apart in one way
    step = 1e-5 * np.ptp(position, axis=0).max()
    for shift in (0.0, 0.5):
        rounded = np.round((position - displacement) / step + shift)
        once = np.unique(rounded, axis=0, return_index=True)[1]
        position, displacement, rotation = position[once], displacement[once], rotation[once]
    return position.T, displacement.T, rotation


def read_cells(path):
    """Of a file of the grid: the outlines of the cells in the deformed body [mm], cells x corners x 2, and the
    micro-rotations of their nodes, cells x nodes, or None."""
    outlines, rotations = [], []
    for piece in ElementTree.parse(path).iter("Piece"):
        # a cell of degree n is written as n x n small ones with nodes of its own
        ratio = int(piece.get("NumberOfPoints")) / max(int(piece.get("NumberOfCells")), 1)
        n = 1 if ratio > 3.0 else 2
        lattice = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
        around = np.concatenate([lattice[0, :-1], lattice[:-1, -1], lattice[-1, :0:-1], lattice[:0:-1, 0]])
        fields = {array.get("Name"): array for array in piece.find("PointData")}
        nodes = decode(piece.find("Points/DataArray"))[:, :2].reshape(-1, lattice.size, 2)
        outlines.append(1e3 * nodes[:, around])
        if "micro_rotation(rad)" in fields:
            rotations.append(decode(fields["micro_rotation(rad)"]).reshape(-1, lattice.size))
    return np.concatenate(outlines), np.concatenate(rotations) if rotations else None


def triangulate(initial):
    """Triangles between neighbours in the undeformed body."""
    mesh = Triangulation(*initial)
    corners = initial[:, mesh.triangles]
    longest = np.hypot(*(corners - np.roll(corners, 1, axis=2))).max(axis=1)
    # much longer ones bridge notches
    mesh.set_mask(longest > 2.0 * np.percentile(longest, 99))
    # flat ones lie along a side
    mesh.set_mask(TriAnalyzer(mesh).get_flat_tri_mask(0.02))
    return Triangulation(*initial, mesh.get_masked_triangles())


def border(mesh):
    """The edges that belong to one triangle only, as pairs of points."""
    triangles = mesh.triangles
    edges = np.sort(np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]))
    edges, count = np.unique(edges, axis=0, return_counts=True)
    return edges[count == 1]


class Specimen:
    """The material points of one output, and the nodes on the outline of the
    grid, as triangles; without files of the grid the outermost points are the
    outline."""

    def __init__(self, point_file):
        with h5py.File(point_file) as file:
            self.load = float(file.attrs["load"])
            self.units = {name: file[name].attrs["unit"] for name in file}
            self.points = {name: file[name][:] for name in file}
        points = self.points
        self.position = np.array([points["position_1"], points["position_2"]])
        initial = self.position - [points["displacement_1"], points["displacement_2"]]

        grid_file = point_file.with_name(point_file.name.replace("points", "grid")).with_suffix(".vtu")
        position, displacement, self.rotation = read_nodes(grid_file)
        if self.rotation.size:
            n = initial.shape[1]
            everything = np.hstack([initial, position - displacement])
            nodes = np.unique(border(triangulate(everything)))
            nodes = nodes[nodes >= n] - n
            self.rotation = self.rotation[nodes]
            self.position = np.hstack([self.position, position[:, nodes]])
            initial = np.hstack([initial, everything[:, n + nodes]])
        self.mesh = triangulate(initial)

    def values(self, name):
        """A field at the points, then at the nodes of the outline."""
        values = self.points[name]
        if name == "micro_rotation":
            return np.append(values, self.rotation)
        # the value of the nearest point
        n = len(values)
        mesh = self.mesh
        initial = np.array([mesh.x, mesh.y])
        nearest = [np.hypot(*(initial[:, :n] - node[:, None])).argmin() for node in initial[:, n:].T]
        return np.append(values, values[nearest])

    def refined(self, values):
        """Finer triangles of the deformed body [mm], and the values on them."""
        refiner = UniformTriRefiner(self.mesh)
        finer, parent = refiner.refine_triangulation(return_tri_index=True, subdiv=2)
        x, y, values = (self.interpolate(field, refiner, parent) for field in (*self.position, values))
        return Triangulation(1e3 * x, 1e3 * y, finer.triangles), values

    def interpolate(self, field, refiner, parent):
        """Smooth, within the bounds of the neighbours: no overshoots."""
        cubic = CubicTriInterpolator(self.mesh, field, kind="geom")
        _, smooth = refiner.refine_field(field, cubic, subdiv=2)
        corners = self.mesh.triangles
        low, high = field.copy(), field.copy()
        for corner in corners.T:
            np.minimum.at(low, corner, field[corners].min(axis=1))
            np.maximum.at(high, corner, field[corners].max(axis=1))
        return np.clip(smooth, low[corners].min(axis=1)[parent], high[corners].max(axis=1)[parent])


def levels(values, diverging):
    """Ends of the colours without the outermost few points, and the arrows."""
    low, high = np.percentile(values, [0.5, 99.5])
    if diverging:
        high = max(abs(low), abs(high))
        low = -high
    if not high > low:
        low, high = values.min(), values.max()
    if not high > low:
        low, high = low - 1e-3, high + 1e-3
    below, above = values.min() < low, values.max() > high
    return low, high, {(0, 0): "neither", (0, 1): "max", (1, 0): "min", (1, 1): "both"}[below, above]


class MovingPoints:
    """The material points of one output of the configuration "current"."""

    def __init__(self, point_file):
        with h5py.File(point_file) as file:
            self.load = float(file.attrs["load"])
            self.units = {name: file[name].attrs["unit"] for name in file}
            self.points = {name: file[name][:] for name in file}

    def values(self, name):
        return self.points[name]

    def boxes(self):
        """Corners of the points' first boxes, deformed with them [mm]."""
        points = self.points
        F = np.array([[points[f"deformation_gradient_{i}{j}"] for j in "12"] for i in "12"])
        middle = np.array([points["position_1"], points["position_2"]])
        half = np.array([points["half_length_1"], points["half_length_2"]])
        # a little larger: no white lines between neighbours
        corners = [middle + 1.02 * np.einsum("ijp,jp->ip", F, half * np.array(signs)[:, None])
                   for signs in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        return 1e3 * np.array(corners).transpose(2, 0, 1)
