# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What methods return can be pickled by every protocol, and copied."""

import copy
import inspect
import pickle
import unittest

import numpy as np
import scipy.sparse

import intrinsic as it
from intrinsic import _core
from support import TETRAHEDRON, bumpy, grid


def results():
    """An object of each class that methods return."""
    s = it.Surface(*grid(5))
    u = np.arange(25.)
    crossing = s.network([[0, 24], [4, 20]], certify=True)
    field = s.direction_field()
    cells = s.voronoi([0, 24, 4])
    flat = s.uniformize()
    return [s, it.Surface(*bumpy(5)).refine(), it.points(bumpy(6)[0], neighbors=8), s.frames(),
            s.transport([0, it.Point(3, (.2, .3, .5))], [[1, 0], [0, 2]]), field,
            field.singularities, cells, cells.junctions, s.farthest_points(3),
            s.common_subdivision(), s.isometries(), s.isometries().maps[3], s.simplify(9),
            s.simplify(9).stretch, it.Surface(*TETRAHEDRON).embed(), s.path(0, 23),
            s.loop([0, 4, 24], waypoints=True), crossing,
            s.cut(crossing), s.parametrize(), flat, flat.layout,
            it.Surface(*TETRAHEDRON).uniformize(), s.isolines(u), it.Point(0, (1., 0., 0.)),
            s.trace(0, [1, .3, 0], 2.), s.operators(k=3), it.map(int, ["x"])[0]]


def state(x):
    """What an object has, in types that can be compared."""
    if isinstance(x, np.ndarray):
        return "array", x.dtype.str, x.shape, x.tobytes()
    if scipy.sparse.issparse(x):
        return "matrix", x.shape, *map(state, (x.data, x.indices, x.indptr))
    if isinstance(x, (list, tuple)):
        return type(x).__name__, *map(state, x)
    if isinstance(x, dict):
        return "dict", *((k, state(v)) for k, v in x.items())
    if isinstance(x, _core.Surface):
        return "surface", _core.dump(x)
    if isinstance(x, _core.Field):
        return "field", state(x.coordinates)
    if isinstance(x, _core.Way):
        return "way", state(_core.parts_of_way(x))
    if isinstance(x, it.Surface):
        return "Surface", state(x._core), state(x.points)
    names = getattr(x, "__slots__", None) or getattr(x, "__dict__", None)
    if names is None:
        return x
    return type(x).__name__, *((k, state(getattr(x, k))) for k in names
                               if k not in ("_edges", "_found", "_isometries", "_map", "_other", "_surface"))


class Pickles(unittest.TestCase):
    def test_every_class_that_is_returned_is_here(self):
        here = {type(x).__name__ for x in results()}
        for module in (v for v in vars(it).values() if inspect.ismodule(v)):
            for name, kind in vars(module).items():
                if inspect.isclass(kind) and kind.__module__.startswith("intrinsic.") \
                        and kind.__module__ != "intrinsic._core" and not name.startswith("_"):
                    self.assertIn(name, here)

    def test_twins_are_equal(self):
        for x in results():
            expected = state(x)
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.subTest(kind=type(x).__name__, protocol=protocol):
                    self.assertEqual(state(pickle.loads(pickle.dumps(x, protocol))), expected)
            for copied in copy.copy, copy.deepcopy:
                with self.subTest(kind=type(x).__name__, copied=copied.__name__):
                    self.assertEqual(state(copied(x)), expected)

    def test_twins_can_do_what_the_originals_can(self):
        s = it.Surface(*grid(5))
        field, frames = s.direction_field(), s.frames()
        network = s.network([[0, 24], [4, 20]])
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            def twin(x):
                return pickle.loads(pickle.dumps(x, protocol))
            np.testing.assert_array_equal(twin(field).vectors, field.vectors)
            np.testing.assert_array_equal(twin(field).axes, field.axes)
            np.testing.assert_array_equal(twin(frames).vertices, frames.vertices)
            self.assertEqual(s.cut(twin(network)).number_of_components, 4)
            self.assertEqual(s.cut(twin(network[0])).number_of_components, 2)
            np.testing.assert_array_equal(twin(s).distance(3), s.copy().distance(3))

    def test_objects_inside_are_refused_in_words(self):
        s = it.Surface(*grid(5))
        inside = [s.network([[0, 24]])._edges, _core.DistanceMethod(True, 1, 1)]
        for x in inside:
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.assertRaisesRegex(TypeError, "cannot be pickled"):
                    pickle.dumps(x, protocol)
            for copied in copy.copy, copy.deepcopy:
                with self.assertRaisesRegex(TypeError, "cannot be pickled"):
                    copied(x)


if __name__ == "__main__":
    unittest.main()
