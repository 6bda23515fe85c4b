# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every argument of every function, replaced by things of every kind that nobody means: the call
works, or names the argument and says what to give."""

import inspect
import os
import unittest
import warnings

import numpy as np

import intrinsic as it
from support import TETRAHEDRON, With_folder, grid


class Thing:
    """Something that is no argument of any function."""

    def __repr__(self):
        return "<a thing>"


THINGS = [Thing(), Thing, lambda: 1, {"a": 1}, it.Surface(*grid(3)), np.array([Thing()]),
          np.zeros(2, dtype=[("a", "f8")]), np.array(["2020-01-01"], dtype="M8")]
JUNK = THINGS + [
    None, "x", "", b"x", True, -1, 1e300, 10**30, float("inf"), float("nan"), 1j,
    [], [None], ["x"], [[1, 2], [3]], [[[1]]], {1}, range(3), (i for i in range(3)),
    np.array(1.5), np.array([.5, .25]), np.array(["a"]), np.array([np.nan, 1]),
    np.full((2, 2), 10**18), it.Point(0, (1, 0, 0)), it.Point("x", None),
    it.Point(10**9, (1, 0, 0))]

# Arguments of calls that work, one of which is replaced.
CALLS = {
    "delaunay": {}, "refine": dict(max_insertions=5), "adapt": dict(max_vertices=20), "mass": {},
    "to_input": dict(u=np.arange(16.)), "from_input": dict(u=np.arange(16.)),
    "locate": dict(points=[1, 2]), "common_subdivision": {}, "save": dict(path="t.idt"),
    "distance": dict(sources=0, targets=[3]), "distances": dict(source_sets=[0, [1]]),
    "pair_distances": dict(A=0, B=[1, 2]), "voronoi": dict(sources=[0, 3]),
    "farthest_points": dict(n=2), "path": dict(a=0, b=15, through=[6]),
    "loop": dict(points=[0, 3, 15]), "network": dict(paths=[[0, 15]], loops=[[0, 3, 15]]),
    "trace": dict(p=0, direction=1 + 1j, length=.5), "isolines": dict(u=np.arange(16.)),
    "isometries": {}, "hash": {}, "cut": {}, "log_map": dict(p=0),
    "transport": dict(points=[0], vectors=[[1, 0]]),
    "extend": dict(points=[0], values=[1]), "direction_field": dict(fixed=([0], [[1, 0]])),
    "signed_distance": dict(curves=[0, 3]), "connection_laplacian": {}, "parametrize": {},
    "simplify": dict(vertices=4), "hierarchy": dict(levels=2), "remove_flat_vertices": {},
    "embed": {}, "uniformize": {}, "eigen": dict(count=2), "deform": dict(handles=[0], displacements=[[1, 0, 0]]),
    "frames": {}, "laplacian": {}, "operators": dict(k=2), "html": {}, "show": dict(path="t.html", open_browser=False)}


def arguments(function):
    return [name for name, p in inspect.signature(function).parameters.items()
            if name != "self" and p.kind is not p.VAR_POSITIONAL]


class Junk(With_folder):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)  # where files are written

    def expect_words_about(self, names, name, function, given):
        """Calls a function with junk as one of its arguments."""
        x = given[name]
        try:
            function(**given)
        except (FileNotFoundError, IsADirectoryError) as error:
            self.assertRegex(str(error), "does not exist|No such file|Is a directory")
            return
        except (ValueError, TypeError) as error:
            words = str(error)
            if name == "progress" and callable(x):
                self.assertIn("argument", words)  # what the function itself raises
                return
        else:
            is_wanted = name in ("progress", "cost") and callable(x) or \
                name == "other" and isinstance(x, it.Surface)
            self.assertFalse(any(x is thing for thing in THINGS) and not is_wanted, "was taken")
            return
        # a message may be about another argument, to which this one does not fit, or an element
        known = "|".join(n.rstrip("s").replace("_", "[_ ]") for n in names)
        others = r"(vertex|face) \d|vector per point|points make a triangle|x: the ext"
        self.assertRegex(words, rf"\b({known}|{others})")
        self.assertRegex(words, r"\b(give|must|choose|needs?|remove|leave|convert|make)\b")

    def check(self, function, **base):
        names = arguments(function)
        for name in names:
            for x in JUNK:
                with self.subTest(function=function.__qualname__, argument=name, x=repr(x)):
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        self.expect_words_about(names, name, function, {**base, name: x})

    def test_methods(self):
        s = it.Surface(*grid(4))
        methods = {name for name, x in inspect.getmembers(s, inspect.ismethod)
                   if not name.startswith("_") and arguments(x)}
        self.assertEqual(methods, set(CALLS))
        sphere = it.Surface(*TETRAHEDRON)
        for name, base in CALLS.items():
            self.check(getattr(sphere if name == "embed" else s, name), **base)

    def test_functions_and_results(self):
        s = it.Surface(*grid(4))
        s.save("t.idt")
        V, F = grid(3)
        self.check(s.frames().to_space, z=np.zeros((16, 2)))
        self.check(it.points, points=np.random.default_rng(1).random((40, 3)))
        self.check(it.read, path="t.idt")
        self.check(it.load, path="t.idt")
        self.check(it.Surface, points=V, faces=F)
        self.check(it.Surface, points=None, faces=[[0, 1, 2]], lengths=[[1, 1, 1]], glue=[[[-1, -1]] * 3])


if __name__ == "__main__":
    unittest.main()
