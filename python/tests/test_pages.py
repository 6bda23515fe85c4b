# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that show themselves: what is on their pages, short texts, files of other programs."""

import base64
import pickle
import re
import unittest

import numpy as np

import intrinsic as it
from support import TETRAHEDRON, With_folder, bumpy


def data(page, name, type_="<f4"):
    """The numbers of a page under a name."""
    found, = re.findall(f'id="{name}"[^>]*>([A-Za-z0-9+/=]*)</script>', page)
    return np.frombuffer(base64.b64decode(found), dtype=type_)


def names(page):
    """The names of the fields of a page that are classes, and of the others."""
    found = re.findall(r'data-name="([^"]*)" data-least="[^"]*" data-greatest="[^"]*" '
                       r'data-classes="(\d)"', page)
    return [n for n, k in found if k == "1"], [n for n, k in found if k == "0"]


class Pages(With_folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.s = s = it.Surface(*bumpy())
        cls.closed = it.Surface(*TETRAHEDRON)
        cls.cells = s.voronoi([0, 60, 143])
        cls.results = {
            "path": s.path(0, 140), "network": s.network([[0, 140], [11, 132]]),
            "trace": s.trace(60, 1j, 1), "isolines": s.isolines(s.distance(0)),
            "cut": s.cut(s.path(0, 140)), "cells": cls.cells, "junctions": cls.cells.junctions,
            "samples": s.farthest_points(5), "crosses": s.direction_field(4),
            "singularities": s.direction_field(4).singularities,
            "transport": s.transport(0, [1, 0]), "frames": s.frames(),
            "subdivision": s.delaunay().common_subdivision(), "map": s.parametrize(),
            "conformal": s.uniformize(), "sphere": cls.closed.uniformize(),
            "layout": s.uniformize().layout, "surface": s}

    def test_texts_are_short(self):
        for name, result in self.results.items():
            text = repr(result)
            self.assertLess(len(text), 160, name)
            self.assertRegex(text, r"^<intrinsic\.\w+.*>$", name)

    def test_results_show_themselves(self):
        for name, result in self.results.items():
            if name in ("junctions", "samples", "singularities", "layout"):
                continue  # show() of the surface takes them
            self.assertIn("<iframe", result._repr_html_(), name)
            page = result.html()
            self.assertGreater(len(data(page, "triangles", "<u4")), 0, name)
            path = result.show(path=self.folder / f"{name}.html", open_browser=False)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), page)

    def test_pages_have_what_is_given(self):
        s, u = self.s, self.s.distance(0)
        marks = [3, it.Point(0, (1, 0, 0))]
        page = s.html(u, self.results["path"], self.results["samples"], marks=marks)
        self.assertEqual(names(page), ([], ["values_0"]))
        self.assertEqual(len(data(page, "curves-sizes", "<i4")), 1)
        self.assertEqual(len(data(page, "marks")), 3 * (5 + 2))
        self.assertEqual(names(s.html({"far": u, "which": u > 1})), (["which"], ["far"]))
        self.assertEqual(len(names(s.html(s.eigen(3)))[1]), 3)
        self.assertEqual(len(names(s.html(s.distances([0, 5])))[1]), 2)
        self.assertEqual(len(names(s.html([u, [u]]))[1]), 2)
        several = s.html([s.trace(60, 1j ** k, 1) for k in range(4)])
        self.assertEqual(data(several, "curves-labels", "<i4").tolist(), [0, 1, 2, 3])
        self.assertEqual(names(self.cells.html()), (["cell"], ["distance"]))
        for vectors in s.points, s.transport(0, [1, 0]), np.full(s.number_of_vertices, 1j):
            self.assertEqual(len(data(s.html(vectors), "glyph-vectors")) % 3, 0)
            self.assertGreater(len(data(s.html(vectors), "glyph-vectors")), 300)
        crosses = self.results["crosses"].html()
        self.assertEqual(len(data(crosses, "glyph-places")), 4 * 3 * s.number_of_vertices)

    def test_classes_stay_classes_where_edges_cross(self):
        labels = np.arange(self.s.number_of_vertices) % 5
        page = self.s.html(labels)
        self.assertEqual(names(page), (["values"], []))
        self.assertTrue(set(data(page, "field-0")) <= set(np.float32([0, .25, .5, .75, 1])))

    def test_logarithms_end_where_they_tear(self):
        u = np.linspace(0, 2 * np.pi, 24, endpoint=False)
        V = [[np.cos(a), np.sin(a), z / 4] for z in range(-20, 21) for a in u]
        F = [[[24 * z + a, 24 * z + (a + 1) % 24, 24 * z + 24 + a],
              [24 * z + (a + 1) % 24, 24 * z + 24 + (a + 1) % 24, 24 * z + 24 + a]]
             for z in range(40) for a in range(24)]
        tube = it.Surface(V, np.reshape(F, (-1, 3)))
        page = tube.html(tube.log_map(24 * 20))
        reach = [float(x) for x in re.search(r'data-reach="([^"]*)"', page)[1].split(",")]
        size = np.ptp(tube.log_map(24 * 20), axis=0).max()
        self.assertAlmostEqual(reach[2] * size, np.pi, delta=0.3)  # half around the tube
        self.assertNotIn("data-reach", self.results["map"].html())

    def test_what_cannot_be_shown_is_refused(self):
        for wrong in np.zeros(7), np.zeros((7, 4)), ["a"] * 144:
            with self.assertRaises(ValueError):
                self.s.html(wrong)
        with self.assertRaises(TypeError):
            self.s.html(3)
        with self.assertRaises(ValueError):
            self.closed.html(self.closed.parametrize(cut="auto"))  # which was cut open
        lengths = it.Surface(None, self.s.faces, lengths=self.s.lengths, glue=self.s.glue)
        with self.assertRaisesRegex(ValueError, "nothing can be drawn"):
            lengths.html()
        self.assertIsNone(lengths.path(0, 5)._repr_html_())

    def test_pickled_results_leave_the_surface_behind(self):
        for name in "path", "network", "cells":
            copy = pickle.loads(pickle.dumps(self.results[name]))
            self.assertIsNone(copy._repr_html_())
            with self.assertRaisesRegex(ValueError, "pickled"):
                copy.show(open_browser=False)
            self.assertGreater(len(data(self.s.html(copy), "curves")), 0)

    def test_files_of_other_programs(self):
        s = self.s
        for name in "path", "network", "isolines", "cells":
            self.results[name].save(self.folder / f"{name}.obj")
            self.assertIn("\nl ", (self.folder / f"{name}.obj").read_text())
        self.results["map"].save(self.folder / "map.obj")
        places = re.findall(r"^vt (\S+) (\S+)", (self.folder / "map.obj").read_text(), re.M)
        np.testing.assert_array_equal(np.array(places, float)[:len(self.results["map"].uv)],
                                      self.results["map"].uv)
        self.results["conformal"].save(self.folder / "layout.obj")
        self.results["cut"].save(self.folder / "cut.ply", plain=True)
        for name in "surface.ply", "surface.off":
            s.delaunay().save(self.folder / name, plain=True)
            again = it.read(self.folder / name)
            self.assertAlmostEqual(again.mass().sum(), s.mass().sum())
        header = (self.folder / "cut.ply").read_bytes().split(b"end_header")[0]
        self.assertIn(b"component", header)
        self.assertNotIn(b"edge", header)
        corners = (self.folder / "surface.off").read_text().splitlines()[-1].split()
        self.assertEqual(len(corners), 1 + int(corners[0]))  # no colour
        with self.assertRaises(ValueError):
            self.results["sphere"].save(self.folder / "sphere.obj")


if __name__ == "__main__":
    unittest.main()
