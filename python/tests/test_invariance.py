# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results do not depend on how a surface is written down: see `invariance` and its table."""

import functools
import inspect
import numbers
import subprocess
import tempfile
import unittest
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np

import intrinsic as it
import program
from intrinsic.compat import potpourri3d, robust_laplacian
from intrinsic.compat.pygeodesic import geodesic
from invariance import Left_out, conformal_map
from invariance_commands import COMMANDS, write
from invariance_compat import COMPAT
from invariance_table import TABLE
from smooth_surfaces import SMOOTH, smooth
from ten_surfaces import ALL, MESHES, of_many_sheets
from written import (AROUND, DIVIDED, RENUMBERED, RIGID, Written, base, place, refined,
                     written)

TOLERANCE = {"intrinsic": 1e-10, "vertices": 1e-10, "discrete": 1e-8, "combinatorial": 1e-8}
COVERED = "Moebius", "soup", "book"
SUMS = 1e-6  # of unit vectors that are nearly opposite, down to 1e-3, in fields to 1e-9


@functools.cache
def found(measure, name, change=None):
    """What a measure finds on one of the ten surfaces, as the base has it or changed."""
    return measure(written(name, change) if change else base(name))


@functools.cache
def found_refined(measure, name, times):
    return measure(refined(name, times))


def deviation(a, b):
    """How far two lists of results are apart: relative to those above 1; infinite if they are
    something else."""
    if len(a) != len(b):
        return np.inf
    worst = 0.0
    for x, y in zip(a, b):
        if isinstance(x, (np.ndarray, numbers.Real)) and not isinstance(x, (bool, np.bool_)):
            x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
            if x.shape != y.shape or (np.isnan(x) != np.isnan(y)).any():
                return np.inf
            far = np.abs(x - y)[np.isfinite(x) | np.isfinite(y)]
            size = np.abs(x[np.isfinite(x)]).max(initial=1)
            worst = max(worst, far.max(initial=0) / size)
        elif x != y:
            return np.inf
    return worst


def mean_deviation(a, b):
    """The largest mean deviation of two lists of arrays."""
    return max(np.mean(np.abs(x - y)) for x, y in zip(a, b))


def changes(check, name):
    """The changes under which a check must hold on a surface."""
    if check.changes:
        return check.changes
    found = list(RIGID) + list(RENUMBERED)
    if name == "cloud":
        return [c for c in found if "named" not in c]
    if check.kind == "intrinsic":
        found += DIVIDED
    return found + (list(AROUND) if name in COVERED else [])


class Invariance(unittest.TestCase):
    def check(self, check):
        for name in check.on:
            for change in changes(check, name):
                with self.subTest(surface=name, change=change):
                    far = deviation(found(check.measure, name), found(check.measure, name, change))
                    self.assertLess(far, TOLERANCE[check.kind])
            if check.converges and name != "cloud":
                with self.subTest(surface=name, change="refined"):
                    some = [found_refined(check.measure, name, k) for k in range(3)]
                    first, second = (mean_deviation(*some[k:k + 2]) for k in range(2))
                    self.assertLess(second, max(0.8 * first, 0.01))


def _add_tests(case, table):
    """Adds a test for each entry of a table."""
    def test_of(checks):
        def test(self):
            for check in checks:
                self.check(check)
        return test

    for name, checks in table.items():
        if not isinstance(checks, Left_out):
            name = "test_" + name.replace(".", "_")
            setattr(case, name, test_of(checks))


_add_tests(Invariance, TABLE | COMPAT)


@functools.cache
def run_command(measure, name, change):
    """What a command says of one of the ten surfaces."""
    x = written(name, change) if change else base(name)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / ("x.xyz" if x.F is None else "x.off")
        write(x, path)
        return measure(x, path, Path(folder))


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Invariance_of_commands(unittest.TestCase):
    def check(self, check):
        for name in check.on:
            some = ["written anew"] + ["divided"] * (check.kind == "intrinsic" and name != "cloud")
            for change in some:
                with self.subTest(surface=name, change=change):
                    far = deviation(*(run_command(check.measure, name, c) for c in ("", change)))
                    self.assertLess(far, TOLERANCE[check.kind])


_add_tests(Invariance_of_commands, COMMANDS)


def public_names():
    """All that users can call: what the module offers, and methods and properties of its classes
    and of those of its results, named for the class that has them."""
    found = set(it.__all__)
    for module in (v for v in vars(it).values() if inspect.ismodule(v) and v is not it._core):
        for kind in vars(module).values():
            if not inspect.isclass(kind) or not kind.__module__.startswith("intrinsic."):
                continue
            is_private = kind.__name__.startswith("_")
            if is_private and not issubclass(it.Surface, kind):
                continue
            owner = "Surface" if is_private else kind.__name__
            found |= {f"{owner}.{k}" for k, v in vars(kind).items() if not k.startswith("_")
                      and (inspect.isfunction(v) or isinstance(v, (property, classmethod)))}
    return found


def public_names_of_compat():
    """The same of the modules with the names of other packages; inherited methods, too."""
    found = set()
    for prefix, module in (("potpourri3d", potpourri3d), ("pygeodesic", geodesic),
                           ("robust_laplacian", robust_laplacian)):
        for name, kind in vars(module).items():
            if name.startswith("_") or not getattr(kind, "__module__", "").startswith("intrinsic."):
                continue
            if inspect.isfunction(kind):
                found.add(f"{prefix}.{name}")
            elif inspect.isclass(kind):
                found |= {f"{prefix}.{kind.__name__}.{k}" for k in dir(kind)
                          if not k.startswith("_")}
    return found


class Lipschitz(unittest.TestCase):
    """Exact distances change no faster than the place of a source or a target."""

    def places(self, x, random):
        """Pairs of places in a face, near corners and sides, and how far apart they are."""
        for _ in range(24):
            f = int(random.integers(len(x.F)))
            weights = []
            for _ in range(2):
                small = random.random(2) * 10.0 ** -random.choice([1, 3, 8, 13, 15, 16, 17], 2)
                w = np.array([1 - small.sum(), *small])
                weights.append(np.roll(w, random.integers(3)) if random.random() < 0.3 else w)
            corner = int(x.F[f][0])
            yield [it.Point(f, tuple(w)) for w in weights] + [corner], \
                [w @ x.V[x.F[f]] for w in weights] + [x.V[corner]]

    def test_distances(self):
        for name in MESHES:
            x, random = base(name), np.random.default_rng(ALL.index(name))
            others = [int(v) for v in np.unique(x.F)] + [x.at(place(name, k)) for k in (4, 5, 6, 7)]
            for places, points in self.places(x, random):
                from_here = [x.d.distance(p, targets=others) for p in places]
                to_here = [x.d.distance(others[-2], targets=[p])[0] for p in places]
                pairs = [x.d.pair_distances(others[-4:], p) for p in places]
                for i in range(3):
                    apart = np.linalg.norm(points[i] - points[i - 1]) + 1e-10
                    for found in from_here, to_here, pairs:
                        with self.subTest(surface=name, places=places):
                            self.assertLess(np.max(np.abs(found[i] - found[i - 1])), apart)


class Sides_of_faces(unittest.TestCase):
    """Vectors in space do not depend on which sides of faces are the fronts."""

    def test_vectors_at_vertices_edges_and_faces(self):
        for seed in range(30):
            random = np.random.default_rng(seed)
            x = Written("soup", *of_many_sheets(random))
            y = x.turned_around(random)
            f = x.F[random.integers(len(x.F))]
            some = random.choice(np.unique(x.F), 3, replace=False)
            places = [int(some[0]), *(dict(zip(f.tolist(), [Fraction(k, 8) for k in weights]))
                                      for weights in ((3, 5), (1, 5, 2)))]
            W = random.normal(size=(3, 3))

            def vectors(z):
                a = [z.s.transport(z.at(p), w).vectors for p, w in zip(places, W)]
                a += [z.s.transport([z.at(p) for p in places], W).vectors]
                return a + [z.s.direction_field(k, fixed=(some, W)).vectors[0] for k in (1,)]

            for k, (a, b) in enumerate(zip(vectors(x), vectors(y))):
                with self.subTest(seed=seed, case=k):
                    np.testing.assert_allclose(b, a, atol=SUMS)


class Conformal_maps(unittest.TestCase):
    """Conformal maps depend on the vertices, except on flat surfaces. On smooth surfaces they
    converge with the second order at fixed vertices: each step is a fourth of the one before in the
    limit, and at most a third here. A vertex in an edge or a face changes them by less than the
    error."""

    def test_they_converge_on_smooth_surfaces(self):
        for name in SMOOTH:
            found = [conformal_map(*smooth(name, k)) for k in range(4)]
            steps = [[np.abs(a - b).mean() for a, b in zip(*pair)] for pair in pairwise(found)]
            for k, (first, second) in enumerate(pairwise(steps)):
                for what, a, b in zip(("metric", "places"), first, second):
                    with self.subTest(surface=name, level=k, what=what):
                        self.assertLess(b, 0.4 * a)

    def test_vertices_in_edges_and_faces_change_less_than_the_error(self):
        for name in SMOOTH:
            (x, count), finer = smooth(name, 1), smooth(name, 2)
            found = conformal_map(x, count)
            errors = [np.abs(a - b).mean() for a, b in zip(found, conformal_map(*finer))]
            for seed in range(4):
                random = np.random.default_rng(seed)
                f, g = random.integers(len(x.F), size=2)
                for y in x.with_split_edge(*map(int, x.F[f][:2])), x.with_split_face(int(g)):
                    changed = conformal_map(y, count)
                    for a, b, error in zip(found, changed, errors):
                        with self.subTest(surface=name, seed=seed):
                            self.assertLess(np.abs(a - b).mean(), error / 2)


class The_table(unittest.TestCase):
    def test_it_names_every_public_function(self):
        self.assertEqual(set(TABLE), public_names())
        self.assertEqual(set(COMPAT), public_names_of_compat())

    @unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
    def test_it_names_every_command(self):
        words = subprocess.run([program.PROGRAM, "--help"], capture_output=True, text=True).stdout
        listed = words.split("Subcommands:")[1].splitlines()
        # view draws what other commands have written
        self.assertEqual({*COMMANDS, "view"}, {line.split()[0] for line in listed if line.strip()})

    def test_few_are_left_out(self):
        left_out = [c for c in [*TABLE.values(), *COMMANDS.values()] if isinstance(c, Left_out)]
        self.assertLessEqual(len({c.reason for c in left_out}), 7)
        self.assertTrue(all(c.reason for c in left_out))


if __name__ == "__main__":
    unittest.main()
