# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What new users stumble over: misspelt names, what is not there and why, how results print."""

import pickle
import re
import subprocess
import sys
import unittest

import numpy as np

import intrinsic as it
from support import TETRAHEDRON, bumpy, grid


def moebius(n=9):
    """Returns a strip with one side."""
    turns = np.linspace(0, 2 * np.pi, n, endpoint=False)
    V = [[(1 + w * np.cos(a / 2)) * np.cos(a), (1 + w * np.cos(a / 2)) * np.sin(a),
          w * np.sin(a / 2)] for a in turns for w in (-.3, .3)]
    F = []
    for i in range(n):
        a, b = 2 * i, 2 * i + 1
        c, d = (a + 2, a + 3) if i < n - 1 else (1, 0)
        F += [[a, c, b], [b, c, d]]
    return V, F


class Names(unittest.TestCase):
    def test_unknown_arguments_have_the_nearest_one_in_the_error(self):
        s = it.Surface(*grid(3))
        for call, message in (
                (lambda: s.distance(0, target=3), "distance.* no argument target; .*targets"),
                (lambda: s.parametrize(target="disk"),
                 r"parametrize.* no argument target; uniformize\(\) has it"),
                (lambda: s.refine(minangle=3), "refine.* no argument minangle; .*min_angle"),
                (lambda: s.mass(flipped=True), "mass.* no argument flipped; .*flip"),
                (lambda: s.uniformize(xyzzy=1), "uniformize.* xyzzy; give some of angles, cones"),
                (lambda: it.Surface(*grid(3), domian="auto"), "Surface.* domian; .*domain"),
                (lambda: it.read("x.off", aritmetic="exact"), "read.* aritmetic; .*arithmetic"),
                (lambda: it.points(grid(3)[0], neighbours=9), "points.* neighbours; .*neighbors")):
            with self.assertRaisesRegex(TypeError, message):
                call()
        with self.assertRaisesRegex(TypeError, "missing 1 required"):
            s.distance()

    def test_names_that_others_have_lead_to_those_of_a_surface(self):
        s = it.Surface(*grid(3))
        for name, found in (("vertices", "points"), ("F", "faces"), ("n_vertices", "number_of_v"),
                            ("area", r"mass\(\).sum"), ("geodesic", "path"), ("lenghts", "lengths"),
                            ("distnace", "distance")):
            with self.assertRaisesRegex(AttributeError, f"Surface has no {name}; .*mean {found}"):
                getattr(s, name)
        for name in "xyzzy", "_repr_png_":
            self.assertFalse(hasattr(s, name))
        with self.assertRaisesRegex(AttributeError, "CoarseSurface has no keptt; .*kept"):
            it.Surface(*bumpy(6)).simplify(9).keptt

    def test_errors_in_properties_of_a_subclass_are_not_masked(self):
        class Named(it.Surface):
            @property
            def label(self):
                return self.points.no_such_name

            @property
            def _hidden(self):
                return self.points.no_such_name

        s = Named(*TETRAHEDRON)
        for name in "label", "_hidden":
            with self.assertRaisesRegex(AttributeError, "ndarray.*no_such_name"):
                getattr(s, name)
        with self.assertRaisesRegex(AttributeError, "a Named has no lable; did you mean label"):
            s.lable

    def test_what_is_no_list_of_points_or_faces_has_a_remedy(self):
        V, F = grid(3)
        s = it.Surface(V, F)
        for call, message in (
                (lambda: s.distance((0, [.3, .3, .4])), r"sources\[1\] is .*intrinsic.Point\(face"),
                (lambda: s.distance(np.arange(9) < 2), "but bool; .*np.flatnonzero"),
                (lambda: it.Surface(V, F.ravel().tolist()), "a list of faces"),
                (lambda: it.map(len, "a.off"), "files is 'a.off'; give a list")):
            with self.assertRaisesRegex((ValueError, TypeError), message):
                call()

    def test_functions_say_who_they_are(self):
        self.assertRegex(repr(it.points), "function points")
        self.assertIn("nearest source", it.Surface.distance.__doc__)
        self.assertIs(pickle.loads(pickle.dumps(it.read)), it.read)

    def test_one_side(self):
        with self.assertRaisesRegex(ValueError, 'one side.*domain="orientation-cover"'):
            it.Surface(*moebius(), domain="manifold")
        self.assertIn("36 faces of a double cover", repr(it.Surface(*moebius())))


class Results(unittest.TestCase):
    def test_representations(self):
        s = it.Surface(*grid(4))
        self.assertIn("shrunk to a point", repr(s.loop([0, 1, 4])))
        self.assertRegex(repr(s.path(0, 15)), "curve of [0-9]+ points, length 4.24264>")
        self.assertRegex(repr(s.trace(5, [1, .3, 0], 9.)), ", border>")
        self.assertIn("a cloud of 36 points", repr(it.points(bumpy(6)[0], neighbors=8)))

    def test_singularities_can_be_chosen(self):
        field = it.Surface(*TETRAHEDRON).direction_field(1)
        all_of_them = field.singularities
        self.assertGreater(len(all_of_them), 1)
        first = all_of_them[:1]
        self.assertEqual((len(first), first.points.shape), (1, (1, 3)))
        self.assertIn("of index", repr(first))
        np.testing.assert_array_equal(all_of_them[-1].faces, all_of_them.faces[-1:])
        chosen = all_of_them[all_of_them.index > 0]
        self.assertEqual(len(chosen), (all_of_them.index > 0).sum())
        self.assertEqual([x.faces[0] for x in all_of_them], all_of_them.faces.tolist())
        with self.assertRaises(IndexError):
            all_of_them[len(all_of_them)]

    def test_conformal_maps_say_why_something_is_not_there(self):
        sphere = it.Surface(*TETRAHEDRON).uniformize()
        self.assertIsNone(sphere.layout)
        self.assertIn("sphere", sphere.no_layout)
        with self.assertRaisesRegex(AttributeError, "no uv: a sphere has no layout.*points"):
            sphere.uv
        with self.assertRaisesRegex(ValueError, "a sphere has no layout"):
            sphere.save("x.obj")
        flat = it.Surface(*grid(4)).uniformize()
        self.assertIsNone(flat.no_layout)
        with self.assertRaisesRegex(AttributeError, r"layout\.uv"):
            flat.uv
        with self.assertRaisesRegex(AttributeError, "did you mean distortion"):
            flat.distorsion
        self.assertFalse(hasattr(flat, "_repr_png_"))

    def test_more_eigenfunctions_than_there_are(self):
        self.assertEqual(len(it.Surface(*grid(4)).eigen(17)[0]), 16)
        big = it.Surface(*grid(32))
        with self.assertRaisesRegex(ValueError, "1024 vertices.*not 1025"):
            big.eigen(1025)

    def test_values_of_faces_are_shown(self):
        s = it.Surface(*grid(4))
        page = s.html(np.arange(18) * .5)
        self.assertIn('data-least="0" data-greatest="8.5"', page)
        self.assertIn('data-classes="1"', s.html(np.arange(18)))
        t = s.refine(max_edge_length=.7)
        self.assertIn(f'data-greatest="{t.number_of_faces - .5}"',
                      t.html(np.arange(t.number_of_faces) + .5))
        with self.assertRaisesRegex(ValueError, "16 vertices and 18 faces"):
            s.html(np.arange(17.))


class Pickles(unittest.TestCase):
    def test_maps_and_subdivisions_leave_the_surface_behind(self):
        s = it.Surface(*grid(4))
        for x in s.uniformize(), s.common_subdivision(), it.Surface(*TETRAHEDRON).uniformize():
            data = pickle.dumps(x)
            self.assertNotIn(b"IDT 5", data)
            twin = pickle.loads(data)
            if getattr(twin, "layout", None) is not None:
                self.assertEqual(twin.html(), x.html())
            else:
                with self.assertRaisesRegex(ValueError, "left it behind"):
                    twin.html()


class Imports(unittest.TestCase):
    def test_what_few_need_is_not_imported(self):
        code = ("import sys, numpy; before = set(sys.modules); import intrinsic; "
                "print(*(set(sys.modules) - before))")
        found = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True,
                               text=True).stdout.split()
        rare = r"concurrent|tempfile|hashlib|html|difflib|traceback|scipy|webbrowser|random"
        self.assertEqual([m for m in found if re.match(rf"({rare})\b", m)], [])


if __name__ == "__main__":
    unittest.main()
