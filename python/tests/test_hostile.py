# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments, surfaces and files that nobody means: each works, or is refused in words."""

import copy
import pickle
import random
import unittest
import warnings

import numpy as np

import intrinsic as it
from support import BOOK, SQUARE, TETRAHEDRON, With_folder, bumpy, failures_of_threads, grid

try:
    from hypothesis import given, settings, strategies as st
except ImportError:  # then the others run
    given = None

STRANGE = {
    "one triangle": ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]),
    "an isolated vertex": ([[0, 0], [1, 0], [0, 1], [5, 5]], [[0, 1, 2]]),
    "one triangle three times": ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]] * 3),
    "no area": ([[0, 0], [1, 0], [2, 0], [1, 1]], [[0, 1, 2], [0, 2, 3]]),
    "two triangles apart": ([[0, 0], [1, 0], [0, 1], [5, 0], [6, 0], [5, 1]],
                            [[0, 1, 2], [3, 4, 5]]),
    "one side": ([[0, 0, 0], [1, 0, 0], [2, 1, 0], [1, 2, 1], [0, 1, 1]],
                 [[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)]),
    "polygons": ([[0, 0], [1, 0], [1, 1], [0, 1], [2, 2]], [[0, 1, 2, 3], [1, 4, 2]]),
    "three pages": BOOK, "a tetrahedron": TETRAHEDRON, "a square": SQUARE,
}


def all_methods(s):
    """Calls of all methods, with arguments that suit most surfaces."""
    u = np.arange(float(s.number_of_vertices))
    return (s.delaunay, s.laplacian, s.mass, s.common_subdivision, s.frames, s.cut, s.uniformize,
            lambda: s.refine(max_insertions=20), lambda: s.adapt(0, max_vertices=40),
            lambda: s.distance(0), lambda: s.distance(0, method="heat"),
            lambda: s.distances([0, [1, 2]]), lambda: s.pair_distances([0, 1], 2),
            lambda: s.voronoi([0, 2]), lambda: s.farthest_points(2), lambda: s.path(0, 2),
            lambda: s.loop([0, 1, 2]), lambda: s.network([[0, 1, 2]], certify=True),
            lambda: s.trace(0, [1, .3, 0], .5), lambda: s.trace(0, 1 + 1j, .5),
            lambda: s.isolines(u), lambda: s.cut(s.path(0, 2)), lambda: s.cut(s.isolines(u, 2)),
            lambda: s.log_map(0), lambda: s.log_map(0, method="affine"),
            lambda: s.transport(0, [1, 0]).vectors, lambda: s.extend([0, 1], [1, 2]),
            lambda: s.direction_field(align=1), lambda: s.signed_distance([0, 1]),
            lambda: s.parametrize(), lambda: s.parametrize("lscm"),
            lambda: s.parametrize("spectral", cut="auto"), lambda: s.uniformize(cones=4),
            lambda: s.eigen(3), lambda: s.eigen(10**9), lambda: s.deform([0], [[1, 0, 0]]),
            lambda: s.deform([], np.zeros((0, 3))), lambda: s.to_input(u), lambda: s.locate([0, 1]),
            lambda: s.statistics, lambda: s.report, s._repr_html_,
            lambda: pickle.loads(pickle.dumps(s)), lambda: copy.deepcopy(s))


class Hostile(With_folder):
    def expect_words(self, call):
        """Calls a function, which works or says in words why not."""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                call()
        except (ValueError, RuntimeError) as error:
            self.assertRegex(str(error), r"\w+ \w+ \w+")
            self.assertNotIn("incompatible function arguments", str(error))

    def test_strange_surfaces(self):
        for name, (V, F) in STRANGE.items():
            for call in all_methods(it.Surface(V, F)):
                with self.subTest(surface=name):
                    self.expect_words(call)

    def test_numbers(self):
        s = it.Surface(*grid(4))
        for name, call in (
                ("time_factor", lambda x: s.distance(0, method="heat", time_factor=x)),
                ("max_distance", lambda x: s.distance(0, max_distance=x)),
                ("threads", lambda x: s.distances([0], threads=x)),
                ("n", lambda x: s.farthest_points(x)), ("length", lambda x: s.trace(0, 1, x)),
                ("levels", lambda x: s.isolines(np.arange(16.), x)),
                ("cell_tolerance", lambda x: s.voronoi([0], cell_tolerance=x)),
                ("time_factor", lambda x: s.signed_distance([0, 1], time_factor=x)),
                ("max_distance", lambda x: s.log_map(0, max_distance=x)),
                ("align", lambda x: s.direction_field(align=x)),
                ("degree", lambda x: s.direction_field(x)),
                ("degree", lambda x: s.connection_laplacian(x)), ("count", lambda x: s.eigen(x)),
                ("min_angle", lambda x: s.refine(min_angle=x)),
                ("max_edge_length", lambda x: s.refine(max_edge_length=x)),
                ("max_circumradius", lambda x: s.refine(max_circumradius=x)),
                ("max_insertions", lambda x: s.refine(max_insertions=x)),
                ("odt_length", lambda x: s.refine(odt_length=x)),
                ("heat_time", lambda x: s.adapt(heat_time=x)),
                ("tolerance", lambda x: s.adapt(tolerance=x)),
                ("max_vertices", lambda x: s.adapt(max_vertices=x)),
                ("neighbors", lambda x: it.points(s.points, neighbors=x)),
                ("energy", lambda x: s.deform([0], [[1]], energy=x)),
                ("solver", lambda x: s.deform([0], [[1]], solver=x)),
                ("solver", lambda x: s.direction_field(solver=x)),
                ("solver", lambda x: s.eigen(solver=x)),
                ("solver", lambda x: s.parametrize(solver=x)),
                ("method", lambda x: s.distance(0, method=x)),
                ("target", lambda x: s.uniformize(target=x))):
            for x in "1", b"1", float("nan"), -1, True, {1}, np.zeros((2, 2)), object(), lambda: 1:
                with self.subTest(name=name, x=x):
                    with self.assertRaisesRegex(ValueError, rf"^{name}\b.*(give|must)"):
                        call(x)

    def test_times_without_heat(self):
        s = it.Surface(*grid(4))
        for call in (lambda x: s.adapt(heat_time=x), lambda x: s.transport(0, [1, 0], time_factor=x),
                     lambda x: s.distance(0, method="heat", time_factor=x)):
            for x in 1e300, 1e17, 10**30, 1e-300:
                with self.assertRaisesRegex(ValueError, "time .* 1e-100 (to|and) [0-9.e+]+"):
                    call(x)

    def test_sequences(self):
        s = it.Surface(*grid(4))
        with self.assertRaisesRegex(ValueError, "^direction has rows"):
            s.trace(0, [[1, 2], 1, 1], 1)
        for x in "1", {1}, object(), float("nan"), [1], [1, float("inf")]:
            with self.assertRaisesRegex(ValueError, "^direction.*give"):
                s.trace(0, x, 1)
        for name, call in (("paths", lambda: s.network(3)), ("loops", lambda: s.network((), 3)),
                           ("source_sets", lambda: s.distances(None)),
                           ("curves", lambda: s.signed_distance(None)),
                           ("curves", lambda: s.cut(3)), ("angles", lambda: s.uniformize(3))):
            with self.assertRaisesRegex(TypeError, f"^{name} is .*give"):
                call()

    def test_damaged_files(self):
        s = it.Surface(*grid(4)).refine(max_insertions=9)
        path = self.folder / "t.idt"
        s.save(path)
        good = path.read_bytes()
        chance = random.Random(1)
        for k in range(300):
            bad = bytearray(good)
            at = chance.randrange(len(bad))
            if k % 3 == 0:
                del bad[at:]
            elif k % 3 == 1:
                bad[at] = chance.randrange(256)
            else:
                bad[at:at + chance.randrange(9)] = good[chance.randrange(len(good)):][:5]
            path.write_bytes(bad)
            with self.subTest(k=k):
                self.expect_words(lambda: it.load(path).distance(0))
        for name in "off", "obj", "ply", "stl", "ts", "xyz", "pwn", "idt", "none":
            for words in (b"", b"\0" * 99, b"OFF\n99999999999 2 0\n", b"OFF\n3 1 0\nnan 0 0\n",
                          b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", b"solid x\n", good):
                path = self.folder / f"t.{name}"
                path.write_bytes(words)
                with self.subTest(name=name, words=words[:9]):
                    self.expect_words(lambda: it.read(path))

    def test_results_can_be_pickled_and_copied(self):
        s = it.Surface(*grid(5))
        u = np.arange(25.)
        for x in (s.frames(), s.transport(0, [1, 0]), s.direction_field(), s.voronoi([0, 24]),
                  s.farthest_points(3), s.common_subdivision(), s.cut(s.path(0, 24)),
                  s.parametrize(), s.uniformize(), it.Surface(*TETRAHEDRON).uniformize(),
                  it.Surface(*TETRAHEDRON).embed(), s.simplify(9),
                  s.isolines(u), it.Point(0, (1, 0, 0))):
            for twin in pickle.loads(pickle.dumps(x)), copy.deepcopy(x), copy.copy(x):
                self.assertEqual(repr(twin), repr(x))
        field = s.direction_field()
        twin = pickle.loads(pickle.dumps(field))
        np.testing.assert_array_equal(twin.vectors, field.vectors)
        np.testing.assert_array_equal(twin.axes, field.axes)
        np.testing.assert_array_equal(copy.deepcopy(s.frames()).vertices, s.frames().vertices)

    def test_threads_that_share_a_surface(self):
        s = it.Surface(*bumpy(12)).refine(max_edge_length=0.3, max_insertions=300)
        far = s.number_of_vertices - 1
        works = [lambda: s.distance(0), lambda: s.distance(0, method="heat"), s.laplacian,
                 lambda: s.path(0, far), lambda: s.log_map(0), lambda: s.eigen(3),
                 lambda: s.refine(max_insertions=9), lambda: copy.copy(s).statistics,
                 lambda: pickle.dumps(s), s.common_subdivision]

        def work(k):
            for i in range(len(works)):
                works[(i + 3 * k) % len(works)]()

        self.assertEqual(failures_of_threads(work, 6, 60), [])
        expected = s.copy().distance(0)
        np.testing.assert_allclose(s.distance(0), expected, rtol=1e-12, atol=1e-12)

    if given is not None:
        @settings(max_examples=40, deadline=None, derandomize=True)
        @given(st.lists(st.tuples(*[st.integers(-2, 2)] * 3), min_size=3, max_size=7, unique=True),
               st.lists(st.lists(st.integers(0, 6), min_size=3, max_size=4, unique=True),
                        min_size=1, max_size=7))
        def test_soups(self, points, faces):
            faces = [f for f in faces if max(f) < len(points)]
            try:
                s = it.Surface(points, faces)
            except ValueError:
                return
            for call in all_methods(s):
                self.expect_words(call)


if __name__ == "__main__":
    unittest.main()
