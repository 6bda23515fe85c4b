# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite elements with a material per face, unknowns that are one, and both kinds of conditions.

-div(A grad u) = f on the unit square, where A is the identity below y = 1/2 and diag(2, 1/2)
above. The sides x = 0 and x = 1 are one; u = 0 at y = 0, and the flux through y = 1 is given. The
solution is known, so that errors are. Usage: finite_elements.py [picture.png]
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve

import intrinsic as it

Numbers = NDArray[np.float64]
Integers = NDArray[np.int64]


# [a metric per face]
def material(V: Numbers, F: Integers, n: int) -> tuple[it.Surface, it.Surface]:
    """The square measured so that A is the identity everywhere, and its Delaunay triangulation."""
    stretched = V[F].mean(axis=1)[:, 1] > 0.5
    sides = V[np.roll(F, -1, axis=1)] - V[F]
    sides[stretched] *= [1, 2, 1]  # A = sqrt(det g) g^-1 for the metric g = diag(1, 4)
    s = it.Surface(V, F, lengths=np.linalg.norm(sides, axis=2))
    middle = n // 2 * (n + 1) + np.arange(n + 1)  # both materials meet there
    return s, s.delaunay(keep=np.column_stack([middle[:-1], middle[1:]]))
# [a metric per face]


def solution(x: Numbers, y: Numbers) -> Numbers:
    """At y = 1/2 it is continuous, and so is the flux."""
    height: Numbers = np.where(y < 0.5, y ** 2, 0.25 + 2 * (y - 0.5))
    wave: Numbers = np.sin(2 * np.pi * x)
    return height * wave


def source(x: Numbers, y: Numbers) -> Numbers:
    wave = np.sin(2 * np.pi * x)
    below = 4 * np.pi ** 2 * wave * y ** 2 - 2 * wave
    return np.where(y < 0.5, below, 8 * np.pi ** 2 * wave * (0.25 + 2 * (y - 0.5)))


# [the right side]
def load(V: Numbers, t: it.Surface, n: int) -> Numbers:
    """Integrals of the source, and of the flux through y = 1, times hat functions."""
    faces = t.faces
    a, b, c = (V[faces[:, k]] for k in range(3))
    areas = np.abs(np.cross(b - a, c - a)[:, 2]) / 2  # of the square, in which f is given
    x, y, _ = (a + b + c).T / 3
    total = np.zeros(len(V))
    total += np.bincount(faces.ravel(), np.repeat(areas * source(x, y) / 3, 3), len(V))
    top = n * (n + 1) + np.arange(n + 1)
    ends = np.column_stack([top[:-1], top[1:]])
    flux = np.sin(2 * np.pi * V[ends, 0].mean(axis=1)) / n  # A grad u, times the length of a side
    total += np.bincount(ends.ravel(), np.repeat(flux / 2, 2), len(V))
    return total
# [the right side]


# [unknowns]
def unknowns(V: Numbers) -> tuple[csr_matrix, NDArray[np.bool_]]:
    """The matrix that takes unknowns to vertices, and which unknowns are free."""
    places = np.column_stack([V[:, 0] % 1, V[:, 1]]).round(9)
    first, number = np.unique(places, axis=0, return_index=True, return_inverse=True)[1:]
    P = csr_matrix((np.ones(len(V)), (np.arange(len(V)), number.ravel())))
    return P, V[first, 1] > 0  # u = 0 at y = 0
# [unknowns]


def mesh(n: int) -> tuple[Numbers, Integers]:
    """A grid of n by n squares, sheared inside so that its faces are thin."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n))
    x = x + 0.25 * np.sin(np.pi * x) * np.sin(2 * np.pi * y)  # 0 at y = 0, 1/2 and 1
    i = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()
    return np.column_stack([x, y, 0 * x]), np.concatenate([np.column_stack([a, b, c]),
                                                           np.column_stack([a, c, d])])


# [assembling]
def assembled(V: Numbers, F: Integers) -> csr_matrix:
    """The same operator on the faces as they are, by integrals of A grad u . grad v in each."""
    corners = V[F][:, :, :2]
    a, b, c = (np.roll(corners, -k, axis=1) for k in range(3))
    areas = np.abs(np.linalg.det(np.stack([b[:, 0] - a[:, 0], c[:, 0] - a[:, 0]], axis=1))) / 2
    opposite = c - b
    gradients = np.stack([-opposite[..., 1], opposite[..., 0]], axis=2) / (2 * areas)[:, None, None]
    A = np.where((corners[..., 1].mean(axis=1) > 0.5)[:, None], [2, 0.5], [1, 1])  # diagonal
    entries = np.einsum("f,fik,fk,fjk->fij", areas, gradients, A, gradients)
    rows, columns = np.broadcast_arrays(F[:, :, None], F[:, None, :])
    return csr_matrix((entries.ravel(), (rows.ravel(), columns.ravel())))
# [assembling]


# [solving]
def solve(n: int) -> tuple[Numbers, Integers, Numbers, Numbers]:
    """The vertices and faces, the solution at the vertices, and its error."""
    V, F = mesh(n)
    s, t = material(V, F, n)
    P, free = unknowns(V)
    L, b = P.T @ t.laplacian() @ P, P.T @ load(V, t, n)
    w = np.zeros(len(free))
    w[free] = spsolve(L[free][:, free].tocsc(), b[free])
    u: Numbers = P @ w
    return V, F, u, u - solution(V[:, 0], V[:, 1])
# [solving]


sizes = [10, 20, 40, 80]
errors = []
for n in sizes:
    V, F, u, error = solve(n)
    errors.append(float(np.sqrt((error ** 2).mean())))
    rate = f"; order {np.log2(errors[-2] / errors[-1]):.2f}" if len(errors) > 1 else ""
    print(f"{n} by {n} squares: mean error {errors[-1]:.2e}{rate}")
V_20, F_20 = mesh(20)
assert errors[-2] > 3.8 * errors[-1], "the order is two"
s, t = material(V_20, F_20, 20)
difference = abs(s.laplacian(flip=False) - assembled(V_20, F_20)).max()
assert difference < 1e-10
print(f"assembled by hand, entries differ by {difference:.1g} at most")
for name, x in ("faces of the mesh", s.laplacian(flip=False)), ("Delaunay", t.laplacian()):
    print(f"{name}: the greatest entry off the diagonal is {(x - np.diag(x.diagonal())).max():.2g}")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), constrained_layout=True)
left.set_aspect("equal")
left.set_title("solution")
figure.colorbar(left.tripcolor(V[:, 0], V[:, 1], F, u, shading="gouraud"), ax=left)
right.loglog(sizes, errors, "o-", label="error")
right.loglog(sizes, [errors[0] * (sizes[0] / n) ** 2 for n in sizes], "--", label="second order")
right.set(xlabel="squares along a side", title="root mean square error")
right.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "finite_elements.png", dpi=150)
