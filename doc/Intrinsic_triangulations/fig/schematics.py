# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the plane: layers of the package, an edge flip, normal coordinates of a face."""
import math

from drawing import BLUE, GREY, INK, RED, Drawing

LAYERS = [
    ("Intrinsic_operators/, Intrinsic_conformal/", "matrices, heat, vectors, maps (Eigen)", "#e8eef7"),
    ("Intrinsic_geodesics/", "curves, shortest paths, exact distances", "#e8eef7"),
    ("IO/", "files, pages to look at", "#dbe7f5"),
    ("domains/", "surfaces from any faces", "#dbe7f5"),
    ("retriangulation/", "flips to Delaunay, refinement, ODT, quality", "#dbe7f5"),
    ("Intrinsic_triangulation", "owns a mesh and the green parts; only it changes them", "#f7ead0"),
    ("correspondence/", "where intrinsic edges run on the input", "#e3f1df"),
    ("triangulation/, tracing/", "records of moves, sessions; straight lines", "#eeeeee"),
    ("metric/, exact/", "lengths, areas, exact decisions", "#e3f1df"),
    ("input/, formulas/", "the surface before all moves; one triangle, one diamond", "#eeeeee"),
    ("connectivity/", "gluings, mesh types, moves without geometry", "#e3f1df")]
CONCEPTS = {0: "MeasuredTriangulation", 1: "GeodesicTriangulation", 4: "IntrinsicTriangulation",
            6: "IntrinsicCorrespondence", 8: "IntrinsicTriangulationTraits",
            10: "MutableDeltaComplex"}
MODELS = {
    0: ["Intrinsic_triangulation"],
    1: ["Intrinsic_triangulation"],
    4: ["Intrinsic_triangulation,", "Integer_only_triangulation"],
    6: ["No_correspondence, Integer_coordinates,", "Explicit_crossings, Signposts"],
    8: ["Exact_euclidean_traits, Interval_traits,",
        "Euclidean_traits&lt;FT&gt;, Tolerant_traits&lt;FT, T&gt;"],
    10: ["Gluing_map, Surface_mesh,", "Polyhedron_3, OpenMesh"]}


def layers(file):
    d = Drawing(780, 664)
    mono = 'font-family="monospace" font-weight="bold"'
    d.rectangle(10, 140, 420, 514, "#fafafa", GREY) # the rooms of triangulations
    d.text(20, 158, "Intrinsic_triangulations/", 13, INK, "start", mono)
    places = [(10, 10, 420), (10, 72, 420), (20, 168, 195), (225, 168, 195)]
    places += [(20, 230 + 62 * k, 400) for k in range(7)]
    for (name, what, fill), (x, y, w) in zip(LAYERS, places):
        d.rectangle(x, y, w, 46, fill)
        d.text(x + w / 2, y + 20, name, 13, style=mono)
        d.text(x + w / 2, y + 37, what, 11.5, GREY)
    d.lines([[(220, 56), (220, 72)], [(220, 118), (220, 140)], [(117, 214), (117, 230)],
             [(322, 214), (322, 230)]] +
            [[(220, 276 + 62 * k), (220, 292 + 62 * k)] for k in range(6)], arrow=True)
    for k, name in CONCEPTS.items():
        y = places[k][1]
        d.lines([[(places[k][0] + places[k][2], y + 23), (444, y + 23)]], GREY, dash="8 8")
        d.text(450, y + 12, name, 12, BLUE, "start")
        for i, line in enumerate(MODELS[k]):
            d.text(460, y + 28 + 14 * i, line, 11.5, INK, "start")
    d.write(file)


def angle_arc(corner, a, b, radius):
    s = math.atan2(a[1] - corner[1], a[0] - corner[0])
    t = math.atan2(b[1] - corner[1], b[0] - corner[0])
    t -= 2 * math.pi * round((t - s) / (2 * math.pi))
    steps = [s + (t - s) * k / 12 for k in range(13)]
    return [(corner[0] + radius * math.cos(u), corner[1] + radius * math.sin(u)) for u in steps]


def diamond(d, x, flipped):
    i, j, k, m = (x + 15, 150), (x + 265, 150), (x + 110, 60), (x + 165, 232)
    d.polygons([(k, m, j) if flipped else (i, j, k)], "#f7ead0")
    d.polygons([(m, k, i) if flipped else (j, i, m)], "#dbe7f5")
    d.lines([[i, m, j, k, i]], INK, 1.4)
    d.lines([[k, m] if flipped else [i, j]], RED, 2.4)
    d.dots([i, j, k, m], 3)
    for (px, py), name in ((i, "i"), (j, "j"), (k, "k"), (m, "m")):
        out = math.hypot(px - x - 140, py - 148)
        d.text(px + 13 * (px - x - 140) / out, py + 14 * (py - 148) / out + 5, name, 16, INK,
               style='font-style="italic"')
    if flipped:
        d.text(x + 124, 128, "L_{km}", 14, RED, "end")
        d.text(x + 200, 150, "kmj", 14)
        d.text(x + 75, 160, "mki", 14)
    else:
        d.lines([angle_arc(k, i, j, 18), angle_arc(m, i, j, 18)], INK, 1)
        d.text(x + 150, 141, "L_{ij}", 14, RED)
        for at_x, at_y, name in ((112, 118, "f,  a_{f}"), (160, 185, "g,  a_{g}"), (50, 98, "L_{ki}"),
                                 (205, 98, "L_{jk}"), (76, 210, "L_{im}"), (232, 206, "L_{mj}")):
            d.text(x + at_x, at_y, name, 14)


def edge_flip(file):
    d = Drawing(660, 290)
    diamond(d, 20, False)
    diamond(d, 360, True)
    d.lines([[(312, 150), (350, 150)]], INK, 1.4, arrow=True)
    d.text(160, 284, "not Delaunay: angles at k and m sum to more than π", 13)
    d.text(500, 284, "flipped", 13)
    d.write(file)


class Face:
    """One intrinsic face of a common subdivision, laid out in the plane by its lengths."""

    def __init__(self, surface, number):
        self.s = surface
        self.faces = {i for i, f in enumerate(surface.faces) if f["intrinsic_face"] == number}
        inner, border = [], {}
        for e in surface.edges:
            ends = e["vertex1"], e["vertex2"]
            own = self.faces.intersection(surface.sides[frozenset(ends)])
            if own and e["intrinsic_edge"] >= 0:
                border.setdefault(ends[0], []).append((ends[1], e))
                border.setdefault(ends[1], []).append((ends[0], e))
            elif own:
                inner.append(ends)
        self.valid = all(len(x) == 2 for x in border.values())
        self.corners = [v for v in border if surface.vertices[v]["kind"] != 2]
        if self.valid and len(self.corners) == 3:
            self.inner = inner
            self.sides = self.walk(border)
        else:
            self.valid = False

    def walk(self, border):
        """Vertices along each side: starts at a corner and goes around, in either direction."""
        around, previous = [self.corners[0]], None
        while len(around) == 1 or around[-1] != around[0]:
            nexts = [w for w, _ in border[around[-1]] if w != previous]
            previous = around[-1]
            around.append(nexts[0])
        at = [k for k, v in enumerate(around) if v in self.corners]
        self.along = [border[around[a]][0][1] if border[around[a]][0][0] == around[a + 1]
                      else border[around[a]][1][1] for a in at[:-1]]
        return [around[a:b + 1] for a, b in zip(at, at[1:])]

    def layout(self, scale, origin):
        """Corners, then points of sides by their distances along them."""
        def length(side):
            return [math.dist(self.s.points[a], self.s.points[b]) for a, b in zip(side, side[1:])]
        ij, jk, ki = (sum(length(s)) for s in self.sides)
        x = (ij * ij + ki * ki - jk * jk) / (2 * ij)
        y = math.sqrt(ki * ki - x * x)
        corners = [(0, 0), (ij, 0), (x, y)]
        place = {}
        for k, side in enumerate(self.sides):
            a, b, total, way = corners[k], corners[(k + 1) % 3], sum(length(side)), 0
            for v, step in zip(side, length(side)):
                t = way / total
                place[v] = (origin[0] + scale * (a[0] + t * (b[0] - a[0])),
                            origin[1] - scale * (a[1] + t * (b[1] - a[1])))
                way += step
        return place

    def count(self, k):
        """The normal coordinate of side k: crossings, or -1 along an input edge."""
        return -1 if self.along[k]["input_edge"] >= 0 else len(self.sides[k]) - 2


def niceness(face):
    """Twice the area by the square of the longest side, times the least distance between crossings."""
    place = face.layout(1, (0, 0))
    a, b, c = (place[side[0]] for side in face.sides)
    longest = max(math.dist(a, b), math.dist(b, c), math.dist(c, a))
    area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    gap = min(math.dist(place[v], place[w]) for s in face.sides for v, w in zip(s, s[1:]))
    return area * gap / longest ** 3


def nicest_face(surface, counts):
    """The nicest face whose sides are crossed as often as `counts` says, in any order."""
    faces = [Face(surface, n) for n in sorted({f["intrinsic_face"] for f in surface.faces})]
    return max((f for f in faces
                if f.valid and sorted(f.count(k) for k in range(3)) == counts), key=niceness)


def away(p, centre, by):
    n = math.dist(p, centre)
    return tuple(c + by * (c - o) / n for c, o in zip(p, centre))


def normal_coordinates(file, surface):
    face = nicest_face(surface, [1, 2, 5])
    d = Drawing(660, 300)
    shape = face.layout(1, (0, 0))
    low, high = (f(y for _, y in shape.values()) for f in (min, max))
    scale = 225 / (high - low)
    place = face.layout(scale, (60, 258 - scale * high))
    corners = [place[side[0]] for side in face.sides]
    centre = tuple(sum(c) / 3 for c in zip(*corners))
    d.polygons([corners], "#f7ead0")
    d.lines([[place[v] for v in ends] for ends in face.inner], BLUE, 1.6)
    d.lines([corners + corners[:1]], INK, 2.2)
    crossings = [place[v] for side in face.sides for v in side[1:-1]]
    d.dots(crossings, 3.2, "#fff", INK)
    d.dots(corners, 4)
    for k, name in enumerate("ijk"):
        x, y = away(corners[k], centre, 15)
        d.text(x, y + 5, name, 17, style='font-style="italic"')
        a, b = corners[k], corners[(k + 1) % 3]
        x, y = away(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), centre, 24)
        d.text(x, y + 5, "n_{%s} = %d" % ("ijki"[k:k + 2], face.count(k)), 15, BLUE)
    corner_counts(d, face)
    d.write(file)


def corner_counts(d, face):
    """How many curves cut each corner off, or start from it, counted in the figure itself."""
    names, y = "ijk", 60
    side_of = [{v for v in side[1:-1]} for side in face.sides]
    starts = [side[0] for side in face.sides]
    d.text(430, y - 18, "input edges in this face", 14, INK, "start")
    for k in range(3):
        following, last = side_of[k], side_of[(k + 2) % 3]
        cut = sum(1 for a, b in face.inner
                  if (a in following and b in last) or (b in following and a in last))
        begun = sum(1 for ends in face.inner if starts[k] in ends)
        low = names[k] + "," + names[(k + 1) % 3] + names[(k + 2) % 3]
        d.text(430, y + 12, "c_{%s} = %d   cut corner %s off" % (low, cut, names[k]), 14, INK,
               "start")
        d.text(430, y + 36, "e_{%s} = %d   start at corner %s" % (low, begun, names[k]), 14, INK,
               "start")
        y += 62


def draw_all(directory, surface):
    layers(f"{directory}/layers.svg")
    edge_flip(f"{directory}/edge_flip.svg")
    normal_coordinates(f"{directory}/normal_coordinates.svg", surface)
