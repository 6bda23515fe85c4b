# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What must not depend on how a surface is written down: a table of all public functions.

A measure takes a `Written` and returns numbers, words and arrays in terms of the base. Each `Check`
says which measure belongs to which class:

- "intrinsic": values that the surface determines, equal under all changes;
- "vertices": values that the surface and its vertices determine, under all changes that add none;
- "discrete": approximations on the given vertices, likewise, to a larger tolerance; they converge
  when the surface is refined;
- "combinatorial": numbers of elements, connectivity and choices, likewise; there are no ties.
"""

import re
import tempfile
from typing import Callable, NamedTuple

import numpy as np
from scipy.spatial import ConvexHull

import intrinsic as it
from ten_surfaces import ALL, MESHES, ORIENTED
from written import place


class Check(NamedTuple):
    kind: str
    measure: Callable
    on: tuple = ALL
    converges: bool = False  # under refinement, at the vertices of the base
    changes: tuple = ()  # all of the kind if there are none


class Left_out(NamedTuple):
    reason: str


def intrinsic(measure, on=MESHES, **more):
    return Check("intrinsic", measure, on, **more)


def vertices(measure, on=ALL, **more):
    return Check("vertices", measure, on, **more)


def discrete(measure, on=ALL, **more):
    return Check("discrete", measure, on, **more)


def combinatorial(measure, on=ALL, **more):
    return Check("combinatorial", measure, on, **more)


# ---- What measures share -------------------------------------------------------------------------


def spot(x, k):
    """A place, as it is named here; in a cloud, a vertex."""
    return x.at(place(x.name, k if x.F is not None else k % 4))


def spots(x, *ks):
    return [spot(x, k) for k in ks]


def direction(k):
    return np.random.default_rng(k).normal(size=3)


def base_function(x):
    """A smooth function at the vertices of the base."""
    V = x.space(x.V)[x.vertex]
    return np.sin(V @ [1.3, 0.4, -0.6]) + V @ [0.5, -0.2, 0.9]


def function(x):
    """The function that is linear in the faces of the base."""
    return x.values(base_function(x))


def up_to_turns(z, k, is_oriented):
    """Complex numbers of which one has become positive; conjugates stand for each other on surfaces
    without an orientation."""
    z = z * np.conj(z[k]) / abs(z[k])
    return [z.real, z.imag if is_oriented else abs(z.imag)]


def complexes(pairs):
    return np.asarray(pairs) @ [1, 1j]


def up_to_similarity(x, uv):
    """Places in the plane, of the vertices of the base."""
    z = complexes(np.asarray(uv)[x.vertex])
    i, j = place(x.name, 0), place(x.name, 3)
    z = (z - z[i]) / (z[j] - z[i])
    return [z.real, z.imag]


def up_to_sign(columns):
    """Columns of which the largest entry is positive."""
    columns = np.array(columns)
    for c in columns.T:
        c *= np.sign(c[np.argmax(abs(c))])
    return columns


def distances_between(P):
    return np.linalg.norm(P[:, None] - P[None], axis=2)


def areas(points, triangles):
    a, b, c = (points[np.asarray(triangles)[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def submatrix(x, m):
    return np.asarray(m.todense())[np.ix_(x.vertex, x.vertex)]


def triangles(x, faces):
    """Sorted triples of vertices of the base; orientations differ on covers."""
    found = x.base_vertex[np.asarray(faces)]
    turn = np.argmin(found, axis=1)
    found = np.array([np.roll(f, -k) for f, k in zip(found, turn)])
    if x.name not in ORIENTED:
        found = np.sort(found, axis=1)
    return sorted(map(tuple, found.tolist()))


def sides(x, faces, lengths):
    """The lengths of the sides of triangles between vertices of the base, by their ends."""
    a = x.base_vertex[np.asarray(faces)]
    b = np.roll(a, -1, axis=1)
    rows = sorted(zip(np.minimum(a, b).ravel().tolist(), np.maximum(a, b).ravel().tolist(),
                      np.ravel(lengths).tolist()))
    return [[r[:2] for r in rows], np.array([r[2] for r in rows]) / x.scale]


def in_order(P):
    """Points in an order that rounding does not change, if they differ in a direction."""
    P = np.asarray(P).reshape(-1, 3)
    return P[np.argsort(P @ [1, 0.61803, 0.367])]


def euler(faces):
    F = np.asarray(faces)
    edges = {tuple(sorted(e)) for f in F.tolist() for e in zip(f, f[1:] + f[:1])}
    return len(np.unique(F)) - len(edges) + len(F)


# ---- Surfaces and triangulations -----------------------------------------------------------------


def of_lengths(x):
    """Distances on the surface that the lengths alone make."""
    s = it.Surface(len(x.V), x.F, lengths=np.linalg.norm(
        x.V[np.roll(x.F, -1, axis=1)] - x.V[x.F], axis=2))
    return [x.rows(s.distance(spots(x, 0, 4))) / x.scale]


def delaunay(x):
    t = x.d
    return [triangles(x, t.faces), t.certificate, *sides(x, t.faces, t.lengths)]


def flips(x):
    return [x.d.statistics["delaunay"]["flips"]]


def refined_by(**options):
    def measure(x):
        lengths = "max_edge_length", "max_circumradius", "odt_length"
        scaled = {k: v * x.scale if k in lengths else v for k, v in options.items()}
        t = x.s.refine(max_insertions=300, **scaled)
        return [t.number_of_vertices, t.number_of_faces, in_order(x.space(t.points)),
                t.statistics["quality"]["min_angle_deg"]]
    return measure


def adapted(x):
    t = x.s.adapt(int(x.vertex[place(x.name, 0)]), tolerance=0.05, max_vertices=80)
    return [t.number_of_vertices, in_order(x.space(t.points))]


def adapted_enough(x):
    """Insertions follow the numbers of faces; the error that they end at does not."""
    t = x.s.adapt(int(x.vertex[place(x.name, 0)]), tolerance=0.05)
    found = t.statistics["adaptive"]
    return [found["status"], found["rounds"][-1]["estimated_error"] <= 0.05]


def numbers(x):
    s = x.s
    return [s.number_of_vertices, s.number_of_faces, s.number_of_input_vertices,
            s.number_of_input_faces]


def glue(x):
    """How many sides are glued, each to one that is glued to it."""
    g = x.s.glue
    f, k = g[g[..., 0] >= 0].T
    back = g[f, k]
    return [len(f), bool((g[back[:, 0], back[:, 1]] == np.column_stack([f, k])).all())]


def statistics(x):
    q, counts = x.d.statistics["quality"], x.d.statistics["delaunay"]
    return [q["min_angle_deg"], q["max_angle_deg"], counts["non_delaunay_edges"]]


def located(x):
    """Where places are in space, by way of the triangulation."""
    faces, weights = x.d.locate(spots(x, *range(8)))
    faces, weights = x.d.locate([it.Point(int(f), tuple(w)) for f, w in zip(faces, weights)],
                                on="input")
    return [x.space(np.einsum("pk,pkc->pc", weights, x.V[x.F[faces]]))]


def subdivision(x):
    c = x.d.common_subdivision()
    tri, _ = c.triangles()
    return [areas(c.points, tri).sum() / x.scale**2]


def subdivision_in_detail(x):
    c = x.d.common_subdivision()
    u = c.P_input @ function(x)
    w = c.P_intrinsic @ function(x)
    return [len(c.points), len(c.polygons), in_order(x.space(c.points)), u.sum(), w.sum(), (u * w).sum()]


def transferred(x):
    u = function(x)
    return [x.rows(x.d.to_input(u)), x.rows(x.d.from_input(u)),
            x.rows(x.d.to_input(u, method="pointwise"))]


def constants(x):
    one = np.ones(x.d.number_of_vertices)
    return [x.rows(x.d.to_input(one)), x.rows(x.d.from_input(one))]


# ---- Distances and curves ------------------------------------------------------------------------


def distance(x):
    s, r = x.s, x.rows
    return [r(s.distance(spot(x, 0))) / x.scale, r(s.distance(spot(x, 4))) / x.scale,
            r(s.distance(spots(x, 1, 6))) / x.scale,
            s.distance(spot(x, 5), targets=spots(x, 0, 4, 6, 7)) / x.scale]


def distance_by_heat(x):
    s = x.s
    return [x.rows(s.distance(spot(x, 0), method="heat")) / x.scale,
            x.rows(s.distance(spots(x, 1, 4), method="heat")) / x.scale]


def distance_by_heat_from_edge(x):
    return [x.rows(x.s.distance(spot(x, 6), method="heat")) / x.scale]


def voronoi(x):
    v = x.s.voronoi(spots(x, 0, 1, 2, 4) if x.F is not None else spots(x, 0, 1, 2, 3))
    return [x.rows(v.labels).tolist(), x.rows(v.distances) / x.scale]


def cells(x):
    v = x.s.voronoi(spots(x, 0, 1, 2))
    return [v.areas / x.scale**2, len(v.junctions.cells)]


def farthest(x):
    f = x.s.farthest_points(5, start=int(x.vertex[place(x.name, 0)]))
    return [x.base_vertex[f.vertices].tolist(), f.radius / x.scale]


def curve(x, c):
    return [c.length / x.scale, c.bounds[0] / x.scale, c.bounds[1] / x.scale, c.is_closed]


def path(x):
    s = x.s
    return [*curve(x, s.path(spot(x, 0), spot(x, 1))), *curve(x, s.path(spot(x, 2), spot(x, 4))),
            *curve(x, s.path(spot(x, 6), spot(x, 5))),
            *curve(x, s.path(spot(x, 0), spot(x, 3), through=[spot(x, 2)], waypoints=True))]


def path_in_space(x):
    p = x.s.path(spot(x, 0), spot(x, 1))
    return [x.space(p.points), len(p.places())]


def places_of_path(x):
    p = x.s.path(spot(x, 0), spot(x, 5))
    on = np.array([np.dot(w, x.V[c]) for w, c in zip(p.barycentric, p.corners)])
    return [np.linalg.norm(np.diff(x.space(on), axis=0), axis=1).sum(),
            sum(x.s.pair_distances(p.places()[:-1], p.places()[1:])) / x.scale]


def network(x):
    n = x.s.network([spots(x, 0, 1), spots(x, 2, 4)], certify=True)
    return [n.length / x.scale, n.certified, [round(c.length / x.scale, 9) for c in n], n.status]


def loop(x):
    ends = x.s.loop(spots(x, 0, 2, 1), waypoints=True)
    return curve(x, ends)


def trace(x):
    frames = x.s.frames().faces
    p, d = spot(x, 4), x.vector(direction(1))
    z = complex(*(frames[p.face] @ d))
    found = []
    for c in (x.s.trace(p, d, 0.9 * x.scale), x.s.trace(p, z, 0.9 * x.scale),
              x.s.trace(spot(x, 0), d, 0.7 * x.scale), x.s.trace(spot(x, 6), d, 0.7 * x.scale)):
        found += [x.space(c.points[-1]), c.length / x.scale, c.status]
    return found


def isolines(x):
    lines = x.s.isolines(function(x), [0.1, 0.35]) + x.s.isolines(function(x), 3)
    return [len(lines), np.sort([c.length for c in lines]) / x.scale,
            sum(c.is_closed for c in lines)]


def lengths_of_lines(x):
    lines = x.s.isolines(function(x), [0.1, 0.35])
    return [np.sort(lines.lengths) / x.scale, lines.length / x.scale]


def cut_along_lines(x):
    c = x.s.cut(x.s.isolines(function(x), [0.1]))
    parts = [areas(c.points, c.faces[c.component == k]).sum()
             for k in range(c.number_of_components)]
    return [c.number_of_components, np.sort(parts) / x.scale**2]


def cut_along_path(x):
    c = x.s.cut(x.s.path(spot(x, 0), spot(x, 3)))
    return [c.number_of_components, areas(c.points, c.faces).sum() / x.scale**2,
            euler(c.faces), c.surface.mass().sum() / x.scale**2]


def cut_to_disks(x):
    c = x.s.cut()
    return [c.number_of_components, areas(c.points, c.faces).sum() / x.scale**2, euler(c.faces)]


# ---- Vectors -------------------------------------------------------------------------------------


def logarithm(method, *ks):
    def measure(x):
        found = []
        for k in ks:
            z = complexes(x.rows(x.s.log_map(spot(x, k), method=method))) / x.scale
            found += without_frame(x, k, z)
        return found
    return measure


def without_frame(x, k, z):
    """Vectors at a place, up to the frame there."""
    p, found = spot(x, k), [abs(z)]
    if has_plane(x, place(x.name, k)):
        if isinstance(p, it.Point) and max(p.barycentric) == 1:
            z = as_at_vertex(x, p, z)
        found += up_to_turns(z, place(x.name, 3), x.name in ORIENTED)
    return found


def has_plane(x, p):
    """Whether directions at a place fit into one plane: not at the vertices of soups, nor if angles
    sum to more than a full turn, where those at corners do not tell all directions apart."""
    if x.name in ("soup", "book"):
        return False
    return isinstance(p, dict) or x.F is None or angle_and_border(x, x.vertex[p])[0] < 2 * np.pi


def angle_and_border(x, v):
    """The sum of the angles at a vertex, and whether it is on the border."""
    total, ends = 0.0, []
    for f in x.F[(x.F == v).any(axis=1)]:
        _, a, b = np.roll(f, -np.argmax(f == v))
        total += np.angle(between(x.V[a] - x.V[v], x.V[b] - x.V[v]))
        ends += [a, b]
    return total, len(set(ends)) > len(ends) // 2


def as_at_vertex(x, p, z):
    """Vectors at a corner of a face in polar coordinates of the vertex, but for a turn: angles from
    the middle of the corner are those on the surface, and here they are scaled."""
    k = int(np.argmax(p.barycentric))
    corners = x.V[np.roll(x.F[p.face], -k)]
    first = x.V[x.F[p.face][1]] - x.V[x.F[p.face][0]]
    a, b = corners[1] - corners[0], corners[2] - corners[0]
    middle = a / np.linalg.norm(a) + b / np.linalg.norm(b)
    turn = between(first, middle)
    if np.cross(first, middle) @ np.cross(a, b) < 0:
        turn = turn.conjugate()
    total, is_on_border = angle_and_border(x, x.F[p.face][k])
    whole, angle = np.pi if is_on_border else 2 * np.pi, np.angle(z / turn)
    beyond = np.maximum(abs(angle) - total / 2, 0)  # the border
    scaled = (abs(angle) - beyond) * whole / total + beyond * np.pi / (2 * np.pi - total)
    return abs(z) * np.exp(1j * np.sign(angle) * scaled)


def between(a, b):
    """A complex number at the angle between two vectors."""
    return complex(a @ b, np.linalg.norm(np.cross(a, b)))


def transport(x):
    field = x.s.transport(spots(x, 0, 4, 6), [x.vector(direction(k)) for k in (2, 3, 4)])
    return [x.rows(field.lengths), x.vectors(x.rows(field.vectors))]


def transport_from_vertex(x):
    return [x.vectors(x.rows(x.s.transport(spot(x, 0), x.vector(direction(2))).vectors))]


def axes(x):
    field = x.s.transport(spot(x, 0), x.vector(direction(2)))
    return [np.linalg.norm(field.axes, axis=1)[x.vertex]]


def extend(x):
    return [x.rows(x.s.extend(spots(x, 6, 2), [3., -1.]))]


def extend_from_far(x):
    return [x.rows(x.s.extend(spots(x, 0, 1, 4), [1., 2., 4.]))]


def directions(x, field):
    """Powers of products with three vectors: no direction comes first."""
    W = x.vectors(field.vectors[:, x.vertex])
    return ((W @ np.array([direction(k) for k in (5, 6, 7)]).T) ** 4).sum(axis=0)


def aligned(x):
    return [directions(x, x.s.direction_field(4, align=1.0)),
            directions(x, x.s.direction_field(2, align=0.3))]


def fixed(x):
    ends = [int(x.vertex[place(x.name, k)]) for k in (0, 1)]
    field = x.s.direction_field(1, fixed=(ends, [x.vector(direction(2)), x.vector(direction(3))]))
    return [x.vectors(field.vectors[0][x.vertex])]


def singularities(x):
    field = x.s.direction_field(4)
    order = np.argsort(x.space(field.singularities.points) @ [1, 0.61803, 0.367])
    return [field.index_sum, field.border_turns, len(order),
            abs(field.singularities.index[order]).tolist(),
            x.space(field.singularities.points)[order]]


def signed(what):
    def measure(x):
        return [x.rows(x.s.signed_distance(what(x))) / x.scale]
    return measure


def corners_of_curve(x):
    return [[int(x.vertex[place(x.name, k)]) for k in (0, 1, 2, 0)]]


def axes_of_frames(x):
    frames = x.s.frames()
    of_face = {g: f for f, g in enumerate(x.of_face)}
    normals = np.cross(frames.faces[:, 0], frames.faces[:, 1])
    normals = x.vectors(normals)[[of_face[g] for g in sorted(of_face)]]
    e = frames.vertices[x.vertex]
    return [np.einsum("fi,fj->fij", normals, normals), np.linalg.norm(e, axis=2)]


def to_space(x):
    field = x.s.transport(spot(x, 0), x.vector(direction(2)))
    return [x.vectors(x.rows(x.s.frames().to_space(field.coordinates)))]


def turns(x):
    """How far vectors turn that are transported around triangles: without their sign on covers."""
    angles, glue = x.s.frames().angles, x.d.glue
    inside = (glue[..., 0] >= 0).all(axis=1)
    there = angles[glue[..., 0], glue[..., 1]]
    turned = np.exp(1j * (there + np.pi - angles)).prod(axis=1)[inside]
    return [np.sort(turned.real), np.sort(abs(turned.imag))]


def connection(x):
    L = x.s.connection_laplacian(2)
    e = np.linalg.eigvalsh(L.todense())
    return [e, abs(submatrix(x, L))] if x.name in ORIENTED else [e]  # on covers rows are of copies


# ---- Maps ----------------------------------------------------------------------------------------


def mapped(method):
    def measure(x):
        m = x.s.parametrize(method)
        return [*up_to_similarity(x, m.uv), m.status,
                m.certificate and m.certificate["injective"]]
    return measure


def mapped_conformally(start):
    def measure(x):
        m = x.s.parametrize("conformal", start=start)
        return [x.rows(m.u), m.status]
    return measure


def places_in_plane(x, m):
    """Where a conformal map of a disk takes each vertex."""
    known = m.layout.vertices >= 0
    at = np.empty((len(x.V), 2))
    at[m.layout.vertices[known]] = m.layout.uv[known]
    return at


def flat_map(x):
    """A map of a flat disk: it changes nothing."""
    m = x.s.parametrize("conformal")
    return [x.rows(m.u), distances_between(x.rows(places_in_plane(x, m))) / x.scale]


def conformal_map(x, count):
    """Scale factors at the first vertices, and what similarities and rotations leave unchanged of
    their places; of a torus only the period."""
    if x.name == "disk":
        m = x.s.parametrize("conformal")
        return [m.u[:count], distances_between(places_in_plane(x, m)[:count])]
    m = x.s.uniformize()
    if x.name == "torus":  # a factor of all lengths is free
        tau = reduced_period(m.period)
        return [m.u[:count] - m.u[:count].mean(), np.array([tau.real, tau.imag])]
    return [m.u[:count], distances_between(m.points[:count])]


def coarse(x):
    """Which vertices go first depends on rounding where costs are nearly the same."""
    t = x.s.simplify("50%")
    levels = x.s.hierarchy(2, ratio=.5)
    return [t.number_of_vertices, t.status, [level.number_of_vertices for level in levels]]


def coarse_vectors(x):
    P = x.s.simplify("50%").vector_prolongation
    return [*P.shape, round(float(abs(P).sum()), 6)]


def without_flat(x):
    return [x.s.remove_flat_vertices(1e-6).number_of_vertices]


def symmetries(x):
    """Turned and scaled surfaces are rounded, and other surfaces: each has its own symmetries."""
    found = x.s.isometries()
    return [found.answer, len(found), found.maps[0].vertices.tolist() == list(range(len(x.V))),
            x.s.hash() == x.s.delaunay().hash()]


def embedded(x):
    """The surface is not convex: the largest sum of angles, which the error names."""
    return [angle_in_error(x.s.embed)]


def hull_again(x):
    """The area of the convex hull, which is found again from its lengths."""
    hull = ConvexHull(x.V)
    a, b, c = (x.V[hull.simplices[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), hull.equations[:, :3]) < 0
    F = np.where(inward[:, None], hull.simplices[:, [0, 2, 1]], hull.simplices)
    number = np.full(len(x.V), -1)
    number[hull.vertices] = np.arange(len(hull.vertices))
    found = it.Surface(x.V[hull.vertices], number[F]).embed()
    return [found.status, round(found.surface.mass().sum() / x.scale**2, 9)]


def angle_in_error(function):
    try:
        function()
    except (ValueError, RuntimeError) as error:
        return round(float(re.search(r"sum to ([\d.]+) degrees", str(error))[1]), 4)


def cut_and_mapped(x):
    m = x.s.parametrize("lscm", cut="auto")
    return [m.status, bool((np.bincount(m.original_vertex) > 0)[x.vertex].any())]


def uniformized(start):
    def measure(x):
        m = x.s.uniformize(start=start)
        # hyperbolic planes and spheres have a unit of their own
        shift = np.log(x.scale) if m.target in ("disk", "sphere") else 0
        found = [m.target, m.status, x.rows(m.u) + shift]
        if m.period is not None:
            found.append(j_invariant(m.period))
        if m.points is not None:
            found.append(distances_between(x.rows(m.points)))
        return found
    return measure


def start_of_the_surface(x):
    """The difference of the metrics of two triangulations that are the same surface."""
    t = x.d
    same = it.Surface(t.number_of_vertices, t.faces, lengths=t.lengths, glue=t.glue)
    return [x.rows(x.s.uniformize().u) - x.rows(same.uniformize().u)]


def with_cones(x):
    angles = {"sphere": (1.2, 0.8, 1, 1), "torus": (2.5, 1.5), "genus 2": (4.5, 3.5)}[x.name]
    m = x.s.uniformize(cones={int(x.vertex[place(x.name, k)]): a * np.pi
                              for k, a in enumerate(angles)})
    return [m.status, x.rows(m.u)]


def reduced_period(tau):
    """The period in the basis of the two shortest vectors of a lattice."""
    tau = complex(tau)
    for _ in range(50):
        tau -= round(tau.real)
        if abs(tau) >= 1:
            break
        tau = -1 / tau
    return tau


def j_invariant(tau):
    """Klein's invariant, the same for all bases of a lattice."""
    tau = reduced_period(tau)
    q = np.exp(2j * np.pi * tau)
    n = np.arange(1, 60)
    e4 = 1 + 240 * (n**3 * q**n / (1 - q**n)).sum()
    e6 = 1 - 504 * (n**5 * q**n / (1 - q**n)).sum()
    j = e4**3 / (e4**3 - e6**2)
    return np.array([j.real, j.imag])


def eigen(x):
    values, u = x.s.eigen(5)
    return [values * x.scale**2, up_to_sign(x.rows(u) * x.scale)[:, 1:]]


def operators(x):
    """The same from a file; and gradients, whose axes depend on how the surface is written."""
    with tempfile.TemporaryDirectory() as folder:
        x.s.operators(k=5).save(folder + "/o.npz")
        o = it.Operators.load(folder + "/o.npz")
    u = function(x)
    slope = np.hypot(o.gradient_x @ u, o.gradient_y @ u)
    return [o.eigenvalues * x.scale**2, x.rows(o.mass) / x.scale**2, x.rows(slope) * x.scale]


def eigenvalues(x):
    return [x.s.eigen(4)[0] * x.scale**2]


def deform(energy):
    def measure(x):
        h = [int(x.vertex[place(x.name, k)]) for k in (0, 1, 2)]
        moves = np.array([x.vector(direction(k)) * x.scale for k in (0, 1, 2)])
        return [x.vectors(x.rows(x.s.deform(h, moves, energy=energy))) / x.scale]
    return measure
