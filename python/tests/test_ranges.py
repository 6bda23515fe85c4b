# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program and the module take the same numbers and the same words for each option: numbers of
the library's table of ranges, words that the signatures of methods list."""

import functools
import math
import re
import subprocess
import typing
import unittest

import numpy as np

import intrinsic as it
import program
from intrinsic import _core, _types
from support import PART, grid

S = it.Surface
HEAT = dict(method="heat")
# Of each range the command with its option, and a call with the number.
RANGES = {
    "neighbors": ("info --domain points --neighbors", lambda s, x: it.points(s.points, neighbors=x)),
    "sharp_angle": ("delaunay --sharp-angle", lambda s, x: s.delaunay(keep=x)),
    "min_angle": ("refine --max-insertions 1 --min-angle",
                  lambda s, x: s.refine(min_angle=x, max_insertions=1)),
    "max_circumradius": ("refine --max-insertions 1 --max-circumradius",
                         lambda s, x: s.refine(max_circumradius=x, max_insertions=1)),
    "max_edge_length": ("refine --max-insertions 1 --max-edge-length",
                        lambda s, x: s.refine(max_edge_length=x, max_insertions=1)),
    "max_insertions": ("refine --max-insertions", lambda s, x: s.refine(max_insertions=x)),
    "odt_length": ("refine --max-insertions 1 --odt-length",
                   lambda s, x: s.refine(odt_length=x, max_insertions=1)),
    "heat_time": ("refine --adaptive --max-vertices 9 --heat-time",
                  lambda s, x: s.adapt(heat_time=x, max_vertices=9)),
    "tolerance": ("refine --adaptive --max-vertices 9 --tolerance",
                  lambda s, x: s.adapt(tolerance=x, max_vertices=9)),
    "max_vertices": ("refine --adaptive --max-vertices", lambda s, x: s.adapt(max_vertices=x)),
    "time_factor": ("distance --source 0 --method heat --time-factor",
                    lambda s, x: s.distance(0, time_factor=x, **HEAT)),
    "max_distance": ("distance --source 0 --max-distance", lambda s, x: s.distance(0, max_distance=x)),
    "cell_tolerance": ("distance --source 0,1 --voronoi {}.obj --cell-tolerance",
                       lambda s, x: s.voronoi([0, 1], cell_tolerance=x)),
    "levels": ("distance --source 0 --isolines {}.obj --levels",
               lambda s, x: s.isolines(np.arange(16.), x)),
    "degree": ("field --degree", lambda s, x: s.direction_field(x)),
    "align": ("field --align", lambda s, x: s.direction_field(align=x)),
    "count": ("eigen --count", lambda s, x: s.eigen(x)),
    "stretch": ("simplify --stretch", lambda s, x: s.simplify(stretch=x)),
    "within": ("simplify --flat", lambda s, x: s.remove_flat_vertices(x)),
    "flat_within": ("embed --flat-within", lambda s, x: s.embed(flat_within=x)),
}
# What is no number of a range, but something else: a file, or a list of levels.
OTHERS = {"max_edge_length": ("few",), "levels": (-1, 1.5, "few")}
# Of each option with words those that the module has.
WORDS = {
    "info --arithmetic": typing.get_args(_types.Arithmetic),
    "info --mollification": typing.get_args(_types.Mollification),
    "info --polygons": typing.get_args(_types.Polygons),
    "info --domain": typing.get_args(_types.Domain) + ("points",),
    "refine --order": (S.refine, "order"),
    "simplify --cost": (S.simplify, "cost"),
    "laplacian --mass-kind": (S.mass, "kind"),
    "transfer --method": (S.to_input, "method"),
    "distance --method": typing.get_args(_types.DistanceMethod),
    "geodesic --method": typing.get_args(_types.CurveMethod),
    "logmap --method": (S.log_map, "method"),
    "parametrize --method": ("harmonic", "lscm", "spectral", "conformal"),
    "uniformize --target": (S.uniformize, "target"),
    "uniformize --start": (S.uniformize, "start"),
    "edit --energy": (S.deform, "energy"),
    "edit --solver": typing.get_args(_types.Solver),
    "eigen --solver": typing.get_args(_types.Solver),
    "field --solver": typing.get_args(_types.Solver),
    "parametrize --solver": typing.get_args(_types.Solver),
}


def beyond(allowed):
    """Returns numbers outside of a range, and one at each of its ends that does not take long."""
    least, most = allowed["least"], allowed["most"]
    if allowed["whole"]:
        least, most = int(least), int(most)
    outside = [-1, math.nan, "few"] + [0] * allowed["positive"] + [1.5] * allowed["whole"]
    if least > 0:
        outside.append(least - 1)
    if most is None:  # infinite
        most = math.inf
    elif most < 1e9:
        outside.append(most + 1)
    else:
        outside.append(math.inf)
    inside = [least] * (not allowed["positive"]) + [most] * (most < 1e9)
    return outside, inside


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class Ranges(program.With_folder):
    def setUp(self):
        super().setUp()
        self.s = S(*grid(4))
        self.mesh = self.folder / "grid.off"
        self.s.save(self.mesh, plain=True)

    def run_program(self, words, *more):
        command, *options = words.format(self.folder / "x").split()
        return subprocess.run([program.PROGRAM, command, self.mesh, *options, *map(str, more)],
                              capture_output=True, text=True, timeout=60)

    def test_every_range_is_here(self):
        self.assertEqual(set(RANGES), set(_core.ranges))

    def test_numbers(self):
        for name, (words, call) in RANGES.items():
            outside, inside = beyond(_core.ranges[name])
            for x in outside:
                with self.subTest(name=name, x=x):
                    if x not in OTHERS.get(name, ()):
                        run = self.run_program(words, x)
                        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
                        self.assertIn("give ", run.stderr)
                    with self.assertRaises(ValueError) as raised:
                        call(self.s, x)
                    self.assertIn(f"give {_core.ranges[name]['description']}"
                                  if name not in ("max_edge_length", "levels") else "give",
                                  str(raised.exception))
            for x in inside:
                with self.subTest(name=name, x=x):
                    run = self.run_program(words, x)
                    self.assertNotEqual(run.returncode, 2, run.stderr)
                    self.assertEqual(run.returncode == 0, self.is_done(call, x), run.stderr)

    def test_infinity_is_refused_by_its_name(self):
        for name, (_, call) in RANGES.items():
            allowed = _core.ranges[name]
            is_bounded = allowed["most"] is not None and allowed["most"] < 1e9
            with self.subTest(name=name):
                if allowed["most"] is None or allowed["whole"] or is_bounded:
                    self.assertNotIn("finite", allowed["description"])
                    continue
                self.assertIn("finite", allowed["description"])
                with self.assertRaisesRegex(ValueError, "finite"):
                    call(self.s, math.inf)

    def is_done(self, call, x):
        try:
            call(self.s, x)
        except ValueError:  # of the surface, such as too few neighbors
            return False
        return True

    @functools.cache
    def help(self, command):
        return subprocess.run([program.PROGRAM, command, "--help"], check=True, capture_output=True,
                              text=True).stdout

    def test_words(self):
        for words, expected in WORDS.items():
            command, option = words.split()
            found = re.search(rf"{option} \S+:{{(.*?)}}", self.help(command))[1].split(",")
            if callable(expected[0]):
                function, parameter = expected
                hint = function.__annotations__[parameter]
                expected = re.findall(r"[\"'](.*?)[\"']", hint)
            with self.subTest(words):
                self.assertEqual(set(found), set(expected))

    def test_points_alone_are_another_function(self):
        with self.assertRaisesRegex(ValueError, r"intrinsic.points\(points\)"):
            S(*grid(4), domain="points")


if __name__ == "__main__":
    unittest.main()
