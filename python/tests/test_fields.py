# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors: closed forms, and bit for bit what the program computes."""

import unittest

import numpy as np

import intrinsic as it
import program
from support import BOOK, CUBE, TETRAHEDRON, grid, grown_memory


def axes_of(V, face):
    """The axes in the plane of vectors at a point of a face: along its first side, and left."""
    e = V[face[1]] - V[face[0]]
    e /= np.linalg.norm(e)
    return np.array([[e[0], e[1]], [-e[1], e[0]]])


class Closed_forms(unittest.TestCase):
    def setUp(self):
        self.V, self.F = grid()
        self.s = it.Surface(self.V, self.F)
        self.point = it.Point(3, (0.2, 0.3, 0.5))
        self.place = np.array(self.point.barycentric) @ self.V[self.F[3]]
        self.axes = axes_of(self.V, self.F[3])

    def test_logarithms_in_the_plane_are_displacements(self):
        s, V = self.s, self.V
        z, w = s.log_map(40) @ [1, 1j], (V - V[40]) @ [1, 1j, 0]
        others = np.arange(81) != 40
        turns = z[others] / w[others]
        self.assertLess(np.abs(turns - turns[0]).max(), 1e-14)
        self.assertAlmostEqual(abs(turns[0]), 1, 14)
        expected = (V - self.place)[:, :2]
        for method in (None, "exact", "affine"):
            found = s.log_map(self.point, method=method) @ self.axes
            self.assertLess(np.abs(found - expected).max(), 1e-12)
        found = s.log_map(40, method="polar")  # of a coarse mesh
        self.assertLess(np.abs(np.hypot(*found.T) - np.abs(w)).max(), 1)
        self.assertEqual(np.isnan(s.log_map(0, max_distance=3)[:, 0]).sum(),
                         (np.hypot(*V[:, :2].T) > 3).sum())

    def test_transport_in_the_plane_keeps_vectors(self):
        for points, vectors, expected in (
                (40, [1, 2, 0], [1, 2, 0]), ([40, self.point], [[1, 2, 0]] * 2, [1, 2, 0]),
                (self.point, [1, 2], [*([1, 2] @ self.axes), 0]),
                ([8, 44], [[-1, 1, 0]] * 2, [-1, 1, 0]), (80, [-1, -2, 7], [-1, -2, 0])):
            field = self.s.transport(points, vectors)
            error = field.vectors / field.lengths[:, None] - expected / np.linalg.norm(expected)
            self.assertLess(np.abs(error).max(), 1e-9)
        field = self.s.transport(40, [0, 2])
        self.assertLess(np.ptp(field.vectors, axis=0).max(), 1e-9)
        np.testing.assert_allclose(field.lengths, 2, rtol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(field.axes, axis=1), 1, rtol=1e-12)

    def test_frames_of_flat_surfaces_are_those_of_the_plane(self):
        frames, t = self.s.frames(), self.s.delaunay()
        inside = (self.V[:, :2] % 8 != 0).all(axis=1)
        x, y = frames.vertices[inside].transpose(1, 0, 2)
        np.testing.assert_allclose(np.cross(x, y), [[0, 0, 1]] * 49, atol=1e-12)
        corner, other = t.faces, np.roll(t.faces, -1, axis=1)
        side = self.V[other] - self.V[corner]
        side /= t.lengths[:, :, None]
        turned = np.stack([np.cos(frames.angles), np.sin(frames.angles)], axis=2)
        along = np.einsum("fka,fkac->fkc", turned, frames.vertices[corner])
        np.testing.assert_allclose(along[inside[corner]], side[inside[corner]], atol=1e-12)
        field = self.s.transport(self.point, [1, 2])
        np.testing.assert_array_equal(frames.to_space(field.coordinates), field.vectors)
        np.testing.assert_array_equal(frames.to_space(field.coordinates @ [1, 1j]), field.vectors)
        z = np.full(81, np.nan)
        z[40] = 3
        vectors = frames.to_space(z)
        np.testing.assert_allclose(vectors[40], 3 * frames.vertices[40, 0], rtol=1e-14)
        self.assertEqual(np.isnan(vectors[:, 0]).sum(), 80)
        np.testing.assert_allclose([1, 2] @ frames.faces[3], [*([1, 2] @ self.axes), 0],
                                   atol=1e-12)

    def test_vectors_in_space_are_unknown_where_the_field_is(self):
        V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5], [2, 0, 0], [3, 0, 0], [2, 1, 0]]
        z = it.Surface(V, [[0, 1, 2], [4, 5, 6]]).transport(0, [2, 0])  # 3 is in no face
        self.assertTrue(np.isnan(z.vectors[3:]).all())
        np.testing.assert_allclose(np.linalg.norm(z.vectors[:3], axis=1), 2, rtol=1e-14)

    def test_frames_of_cones_and_corners_are_scaled(self):
        s = it.Surface(*TETRAHEDRON)
        for n, surface in (3, s), (4, it.Surface(*grid(2))):  # a corner of the square has 180
            angles = surface.frames().angles
            np.testing.assert_allclose(np.exp(1j * n * angles), 1, atol=1e-12)
            self.assertGreater(np.ptp(angles), 1)
        angles, glue = s.frames().angles, s.delaunay().glue
        turns = np.exp(1j * (angles[tuple(glue.transpose(2, 0, 1))] + np.pi - angles))
        L, corner = s.connection_laplacian().toarray(), s.delaunay().faces
        there = L[np.roll(corner, -1, axis=1), corner]
        np.testing.assert_allclose(-there / np.abs(there), turns, atol=1e-12)

    def test_frames_of_other_surfaces(self):
        V = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 1], [2, 1, 1]]
        faces = it.Surface(V, [[0, 1, 2, 3], [1, 4, 2]]).frames().faces
        self.assertTrue(np.isnan(faces[0]).all())
        np.testing.assert_allclose(faces[1] @ faces[1].T, np.eye(2), atol=1e-12)
        lengths = it.Surface(None, [[0, 1, 2]], lengths=[[3, 4, 5]]).frames()
        np.testing.assert_allclose(lengths.angles, 0, atol=1e-12)
        for array in ("vertices", "faces"):
            with self.assertRaisesRegex(ValueError, "lengths alone"):
                getattr(lengths, array)
        with self.assertRaisesRegex(ValueError, "z has the shape"):
            lengths.to_space([1j])
        cloud = it.points(np.random.default_rng(1).normal(size=(40, 3)), neighbors=6).frames()
        self.assertIsNone(cloud.angles)
        x, y = cloud.vertices.transpose(1, 0, 2)
        np.testing.assert_allclose(np.sum(x * y, axis=1), 0, atol=1e-12)

    def test_traces_along_logarithms_end_at_vertices(self):
        V, F = grid()
        s = it.Surface(V * [1, 0.1, 0], F)  # its Delaunay triangulation has other edges
        for p in 40, self.point:
            for v, (x, y) in list(enumerate(s.log_map(p)))[::17]:
                if v != p:
                    end = s.trace(p, complex(x, y), np.hypot(x, y)).points[-1]
                    np.testing.assert_allclose(end, s.points[v], atol=1e-9)

    def test_values_extend_from_the_nearest_point(self):
        values = self.s.extend([0, self.point], [2, 5])
        self.assertTrue(2 <= values.min() and values.max() <= 5)
        np.testing.assert_allclose(self.s.extend([7, 8], [3, 3]), 3, rtol=1e-12)

    def test_signed_distances_from_a_line(self):
        d = self.s.signed_distance([36, 44])  # eastward, along y = 4
        np.testing.assert_allclose(d, 4 - self.V[:, 1], atol=1e-9)
        loop = self.s.signed_distance([[20, 24, 60, 56, 20]])  # counterclockwise
        self.assertLess(loop[40], -1)
        self.assertGreater(loop[0], 1)
        np.testing.assert_array_equal(loop[[20, 22, 24, 56, 60]], 0)

    def test_signed_distances_from_curves_through_faces(self):
        V, s = self.V, self.s
        for surface in s, it.Surface(V * [1, 0.2, 1], self.F):  # which has other edges after flips
            V = surface.points
            for a, b in (it.Point(40, (0.2, 0.3, 0.5)), 77), (11, it.Point(91, (0.3, 0.3, 0.4))):
                curve = surface.path(a, b)
                x, y = curve.points[0][:2], curve.points[-1][:2]
                along = (y - x) / np.linalg.norm(y - x)
                line = (V[:, :2] - x) @ [along[1], -along[0]]
                d = surface.signed_distance(curve)
                near = np.abs(line) < 0.3
                self.assertTrue((np.sign(d[near]) == np.sign(line[near])).mean() > 0.8)
            straight = surface.path(36, 44)  # along edges
            d = surface.signed_distance(straight)
            np.testing.assert_allclose(d, V[36, 1] - V[:, 1], atol=1e-9)
            np.testing.assert_allclose(surface.signed_distance([straight, [36, 44]]), d, atol=1e-9)
            np.testing.assert_array_equal(surface.signed_distance(surface.network([[36, 44]])), d)
        line, = s.isolines(self.V[:, 0], [3.3])  # larger values on its left
        np.testing.assert_allclose(s.signed_distance(line), 3.3 - self.V[:, 0], atol=1e-9)

    def test_signed_distances_from_points_in_faces(self):
        flat = it.Surface(self.V * [1, 0.2, 1], self.F)  # which has other edges after flips
        for surface in self.s, flat:
            for curve in surface.isolines(self.V[:, 0] + self.V[:, 1], [4.3, 7.9]):
                expected = surface.signed_distance(curve)
                np.testing.assert_allclose(surface.signed_distance(curve.places()), expected,
                                           atol=1e-9)
        corner = it.Point(0, (1.0, 0.0, 0.0))
        d = self.s.signed_distance([corner, 1, 2, 3, 4, 5, 6, 7, 8])
        np.testing.assert_allclose(d, -self.V[:, 1], atol=1e-9)

    def test_fields_turn_as_often_as_the_surface_demands(self):
        for degree in (1, 2, 4, 6):
            field = it.Surface(*CUBE).direction_field(degree)
            self.assertEqual((field.index_sum, field.border_turns), (2 * degree, 0))
            self.assertEqual(field.face_index.sum(), 2 * degree)
            self.assertEqual(field.singularities.index.sum(), 2 * degree)
            self.assertEqual(field.vectors.shape, (degree, 8, 3))
            np.testing.assert_allclose(field.lengths, 1, rtol=1e-12)
        field = self.s.direction_field(4)
        self.assertEqual(field.index_sum, 4 + field.border_turns)
        V, w = self.V, field.singularities.barycentric
        self.assertTrue(np.allclose((w[:, :, None] * V[self.F[field.singularities.faces]]).sum(1),
                                    field.singularities.points))

    def test_fixed_directions_stay(self):
        field = self.s.direction_field(1, fixed=(40, [0, 3, 0]))
        np.testing.assert_allclose(field.vectors[0][40], [0, 1, 0], atol=1e-9)
        self.assertGreater(field.vectors[0][:, 1].min(), 0.5)  # corners turn it
        with self.assertRaisesRegex(ValueError, "vertices only"):
            self.s.direction_field(1, fixed=([self.point], [[1, 0]]))

    def test_nonmanifold_surfaces_have_a_vector_per_vertex(self):
        s = it.Surface(*BOOK)
        np.testing.assert_allclose(np.hypot(*s.log_map(0).T)[[1, 2]], 1, rtol=1e-12)
        self.assertEqual(s.transport(0, [1, 0]).vectors.shape, (5, 3))
        with self.assertRaisesRegex(ValueError, "cover"):
            s.signed_distance([0, 1])


class Arguments(unittest.TestCase):
    def test_bad_ones_are_named(self):
        s = it.Surface(*grid(4))
        for message, call in (
                ("does not exist", lambda: s.log_map(0, method="fast")),
                ("several points", lambda: s.log_map([0, 1])),
                (r"p\[?0?\]? is 99|from 0 to 15", lambda: s.log_map(99)),
                ("positive number", lambda: s.log_map(0, method="affine", time_factor=0)),
                ("leave out time_factor", lambda: s.log_map(0, time_factor=2)),
                ("leave out max_distance", lambda: s.log_map(0, method="affine", max_distance=1)),
                ("a vector per point", lambda: s.transport([0, 1], [[1, 0]])),
                ("two coordinates", lambda: s.transport([0], [[1, 0, 0, 0]])),
                ("finite", lambda: s.transport(0, [np.nan, 0])),
                ("one number for each", lambda: s.extend([0, 1], [1])),
                ("degree", lambda: s.direction_field(0)),
                ("degree", lambda: s.direction_field(1.5)),
                ("even degree", lambda: s.direction_field(1, align=1)),
                ("align", lambda: s.direction_field(4, align=-1)),
                ("curves", lambda: s.signed_distance([])),
                ("curves", lambda: s.signed_distance([3])),
                (r"curves\[1\]", lambda: s.signed_distance([[0, 1], [0, 16]])),
                ("not in one face", lambda: s.signed_distance([[15, it.Point(0, (0.5, 0.5, 0))]])),
                ("curves", lambda: s.signed_distance([[it.Point(0, (0.5, 0.5, 0))]])),
                ("another surface", lambda: s.signed_distance(it.Surface(*grid(9)).path(0, 80)))):
            with self.assertRaisesRegex(ValueError, message):
                call()

    def test_any_types_and_strides(self):
        s = it.Surface(*grid(4))
        expected = s.transport([0, 15], [[1, 0], [0, 1]]).coordinates
        for points, vectors in ((np.array([0, 99, 15], dtype=np.uint8)[::2], np.eye(2, dtype="f4")),
                                ((0, 15), np.asfortranarray(np.eye(2))),
                                ([0, 15], [[1, 0], [0, 1]])):
            np.testing.assert_array_equal(s.transport(points, vectors).coordinates, expected)

    def test_the_user_may_end_signed_distances(self):
        def stop(stage, count, total):
            raise KeyboardInterrupt

        s = it.Surface(*grid(200))
        with self.assertRaises(KeyboardInterrupt):
            s.signed_distance([0, 199], progress=stop)
        self.assertAlmostEqual(s.signed_distance([0, 199])[-1], -199, 6)  # nothing is spoilt

    def test_nothing_leaks(self):
        s = it.Surface(*grid(4))

        def work():
            s.log_map(0)
            s.transport(0, [1, 0]).vectors
            s.direction_field(4).singularities
            s.signed_distance([0, 15])
            s.extend(0, [1])

        self.assertLess(grown_memory(work, 100), 20000)


@unittest.skipUnless(program.is_there(), "the program or its meshes are missing")
class As_the_program(program.Comparison):
    MESHES = program.some(("elephant.off", "mpi.off", "ellipsoid.off", "double-torus-example.off",
                           "hole.off"), program.CONNECTED)

    def test_logarithmic_maps(self):
        for name in self.MESHES:
            path, V, F = program.mesh(name)
            for method in ("exact", "affine", "polar"):
                _, expected = self.numbers_of_program("logmap", path, "--method", method,
                                                       "--source", 3)
                s = it.Surface(V, F)  # a search sharpens what is stored, as in each run there
                np.testing.assert_array_equal(s.log_map(3, method=method), expected, name)

    def test_transport(self):
        (self.folder / "v.txt").write_text("3 0 2\n8 90 1\n")
        for name in self.MESHES:
            path, V, F = program.mesh(name)
            _, expected = self.numbers_of_program("transport", path,
                                                   "--vectors", self.folder / "v.txt")
            angle = np.array([0.0, 90 * np.pi / 180])
            field = it.Surface(V, F).transport(
                [3, 8], np.column_stack([np.cos(angle), np.sin(angle)]) * [[2], [1]])
            np.testing.assert_array_equal(field.lengths, expected[:, 0], name)
            np.testing.assert_array_equal(field.coordinates, expected[:, 1:3], name)
            np.testing.assert_array_equal(field.axes, expected[:, 3:], name)

    def test_direction_fields(self):
        for name in self.MESHES:
            path, V, F = program.mesh(name)
            s = it.Surface(V, F)
            for degree, align in ((1, None), (4, None), (4, 0.5)):
                options = ("--align", align) if align is not None else ()
                found, expected = self.numbers_of_program("field", path,
                                                           "--degree", degree, *options)
                field = s.direction_field(degree, align=align)
                np.testing.assert_array_equal(field.coordinates, expected[:, :2], name)
                found = found["field"]
                self.assertEqual((len(field.singularities), field.index_sum, field.border_turns),
                                 (found["singular_faces"], found["index_sum"],
                                  found["border_turns"]))

    def test_signed_distances(self):
        for name in self.MESHES:
            path, V, F = program.mesh(name)
            _, expected = self.numbers_of_program("distance", path, "--method", "heat", "--signed",
                                           "--curve", "3,8,12")
            np.testing.assert_array_equal(it.Surface(V, F).signed_distance([3, 8, 12]), expected,
                                          name)


if __name__ == "__main__":
    unittest.main()
