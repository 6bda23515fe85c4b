# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input gives a certified result, or an error that names the element."""

import os
import resource
import subprocess

from cli_support import CUBE, TIME_LIMIT, Cli_test, beside, grid, icosphere, main, shuffled

TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


class Refused_input(Cli_test):
    def refuse(self, mesh, *words, options=()):
        for command in ("delaunay", "laplacian", "info"):
            for arithmetic in ("exact", "double"):
                self.assert_fails(
                    self.run_program(command, mesh, "--arithmetic", arithmetic, *options),
                    str(mesh), *words)

    def test_missing_file(self):
        self.refuse("missing.off", "does not exist")

    def test_directory(self):
        self.refuse(self.directory, "directory")

    def test_unknown_extension(self):
        self.refuse(self.write("mesh.txt", "0 0 0\n"), ".off", ".xyz")

    def test_truncated_file(self):
        path = self.write_off("t.off", *TETRAHEDRON)
        with open(path) as file:
            text = file.read()
        self.refuse(self.write("a.off", text[:len(text) // 2]), "a.off")
        self.refuse(self.write("b.off", "\n".join(text.split("\n")[:8]) + "\n"), "b.off")
        self.refuse(self.write("c.off", ""), "empty")

    def test_coordinates_that_are_not_finite(self):
        for word in ("nan", "inf", "-inf", "1e999"):
            self.refuse(self.write("n.off", f"OFF\n3 1 0\n0 0 0\n1 {word} 0\n0 1 0\n3 0 1 2\n"),
                        "vertex 1", "finite")

    def test_vertex_between_two_parts_of_a_face(self):
        self.refuse(self.write_off("r.off", TETRAHEDRON[0], [(0, 1, 2), (0, 1, 2, 0, 2, 3)]),
                    "face 1", "repeats vertex 0", "cut the face")
        self.refuse(self.write_off("n.off", TETRAHEDRON[0], [(0, 1, 1), (3, 3, 3)]),
                    "three different vertices")

    def test_vertex_that_does_not_exist(self):
        self.refuse(self.write_off("v.off", TETRAHEDRON[0], [(0, 1, 9)]), "face 0", "vertex 9")

    def test_text_without_end_takes_bounded_memory(self):
        if not os.path.exists("/dev/zero"):
            self.skipTest("this system has no /dev/zero")
        with open(self.path("sparse.obj"), "wb") as file:
            file.truncate(1 << 31)
        for name in ("zero.off", "zero.ply", "zero.xyz", "zero.idt", "sparse.obj"):
            if name.startswith("zero"):
                os.symlink("/dev/zero", self.path(name))
            run = subprocess.run([self.program, "info", name], cwd=self.directory, text=True,
                                 capture_output=True, timeout=TIME_LIMIT,
                                 preexec_fn=lambda: resource.setrlimit(
                                     resource.RLIMIT_AS, (1 << 29, 1 << 29)))
            self.assertEqual(run.returncode, 1)
            self.assertIn(name + ":1: the line is longer than 64 MiB", run.stderr)

    def test_messages_show_no_more_than_can_be_read(self):
        for word in ("a\0b", "a\x1b[31m", "x" * 5000):
            for name, text in (("w.off", word), ("f.obj", f"v 0 0 0\nf 1 {word} 2\n"),
                               ("n.ply", f"ply\nformat {word} 1.0\n"), ("i.idt", word),
                               ("j.idt", f"IDT 5 {word}\n")):
                run = self.run_program("info", self.write(name, text))
                self.assert_fails(run, name)
                self.assertLess(len(run.err), len(self.directory) + 300)
                self.assertTrue(run.err[:-1].isprintable(), run.err)

    def test_zero_faces(self):
        self.refuse(self.write_off("z.off", [], []), "no points")
        self.refuse(self.write_off("z.off", TETRAHEDRON[0], []), "no faces",
                    options=("--domain", "manifold"))

    def test_edge_with_three_faces(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)]
        self.refuse(self.write_off("e.off", points, [(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
                    "edge (0, 1)", "3 faces (0, 1, 2)", options=("--domain", "manifold"))

    def test_moebius_strip(self):
        n = 5
        points = [(i, j, 0) for i in range(n) for j in range(2)]
        faces = []
        for i in range(n):
            a, b = 2 * i, 2 * i + 1
            c, d = (2 * i + 2, 2 * i + 3) if i + 1 < n else (1, 0)
            faces += [(a, c, d), (a, d, b)]
        self.refuse(self.write_off("m.off", points, faces), "edge (", "same direction", "one side",
                    "cut", "--domain orientation-cover", options=("--domain", "manifold"))


class Accepted_input(Cli_test):
    def certify(self, mesh, *arguments):
        stats = self.stats("delaunay", mesh, *arguments)
        self.assert_certified(stats)
        return stats

    def test_disconnected(self):
        stats = self.certify(self.write_off("d.off", *beside(*TETRAHEDRON, 5)))
        self.assertEqual(stats["input"]["components"], 2)
        self.assertEqual(stats["input"]["genus"], 0)

    def test_boundary(self):
        stats = self.certify(self.write_off("b.off", *grid(4)))
        self.assertEqual(stats["input"]["boundary_edges"], 16)
        self.assertEqual(stats["input"]["boundary_loops"], 1)
        self.assertEqual(stats["delaunay"]["flips"], 0)
        self.assertEqual(stats["delaunay"]["cocircular_edges"], 16)  # the diagonals are ties

    def test_topology_of_meshes_that_are_renumbered(self):
        side = 190  # smaller meshes keep their order
        points, faces = grid(side)
        n = len(points)
        # a disk, a second one that shares a vertex with the first, and vertices without faces
        points = points + [(x + 400, y, z) for x, y, z in points[1:]] + [(-5, -5, 0), (-6, -5, 0)]
        faces = faces + [tuple(v + n - 1 if v > 0 else 0 for v in f) for f in faces]
        mesh = self.write_off("s.off", *shuffled(points, faces, 3)[:2])
        facts = self.stats("info", mesh)["input"]
        self.assertTrue(facts["renumbered"])
        for key, value in (("vertices", 2 * n + 1), ("faces", 4 * side * side), ("components", 2),
                           ("edges", 2 * (3 * side * side + 2 * side)), ("genus", 0),
                           ("boundary_edges", 8 * side), ("boundary_loops", 2),
                           ("isolated_vertices", 2), ("nonmanifold_vertices", 1)):
            self.assertEqual(facts[key], value, key)

    def test_isolated_vertices(self):
        points, faces = TETRAHEDRON
        stats = self.certify(self.write_off("i.off", points + [(9, 9, 9), (8, 8, 8)], faces))
        self.assertEqual(stats["input"]["isolated_vertices"], 2)
        self.assertEqual(stats["input"]["vertices"], 6)

    def test_two_faces_on_the_same_vertices(self):
        stats = self.certify(
            self.write_off("p.off", [(0, 0, 0), (3, 0, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 1)]))
        self.assertEqual(stats["input"]["faces"], 2)
        self.assertEqual(stats["input"]["edges"], 3)
        # both faces are the right triangle 3, 4, 5: cotangents 0, 4/3, 3/4, each twice
        self.assertAlmostEqual(stats["laplacian"]["trace"], 2 * (4 / 3 + 3 / 4), 12)

    def test_nonmanifold_vertex(self):
        stats = self.certify(self.write_off(
            "n.off", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0), (-1, -1, 0)],
            [(0, 1, 2), (0, 3, 4)]))
        self.assertEqual(stats["input"]["nonmanifold_vertices"], 1)

    def test_faces_that_disagree_are_turned_around(self):
        faces = list(TETRAHEDRON[1])
        faces[0] = faces[0][::-1]
        stats = self.certify(self.write_off("o.off", TETRAHEDRON[0], faces))
        self.assertEqual(stats["input"]["reversed_faces"], 1)
        self.assertEqual(stats["input"]["genus"], 0)
        self.assertEqual(stats["input"]["boundary_edges"], 0)

    def test_polygons_are_triangulated(self):
        stats = self.certify(self.write_off("q.off", *CUBE))
        self.assertEqual(stats["input"]["triangulated_polygons"], 6)
        self.assertEqual(stats["input"]["faces"], 12)
        self.assertEqual(stats["delaunay"]["cocircular_edges"], 6)

    def test_small_edges_far_from_the_origin(self):
        points, faces = icosphere(2)
        # spacing of doubles at 1e8 is 1.5e-8: edges of 1e-6 have about 6 bits, some faces none
        far = [tuple(1e8 + 3e-6 * x for x in p) for p in points]
        stats = self.certify(self.write_off("f.off", far, faces))
        # every face is computed from differences, which are exact: only squares and sums round
        self.assert_close(stats["area"]["input"], stats["area"]["intrinsic"], 1e-9)

    def test_needles(self):
        points = [(0, 0, 0), (1e-15, 0, 0), (0.5, 1, 0), (0.5, -1, 0)]
        self.certify(self.write_off("n.off", points, [(0, 1, 2), (1, 0, 3)]))
        points = [(0, 0, 0), (1, 0, 0), (0.5, 1e-15, 0), (0.5, -1e-15, 0)]
        self.certify(self.write_off("c.off", points, [(0, 1, 2), (1, 0, 3)]))

    def test_caps_are_flipped_away(self):
        points = [(0, 0, 0), (4, 0, 0), (1, 0, 0), (2, -3, 0)]
        stats = self.certify(self.write_off("c.off", points, [(0, 1, 2), (1, 0, 3)]))
        self.assertEqual(stats["input"]["degenerate_faces"], 1)
        self.assertEqual(stats["mollification"]["kind"], "none")
        self.assertEqual(stats["delaunay"]["flips"], 1)

    def test_zero_length_is_mollified_and_reported(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 0, 0), (0, 1, 0)]
        mesh = self.write_off("z.off", points, [(0, 1, 2), (0, 2, 3)])
        stats = self.certify(mesh)
        self.assertEqual(stats["mollification"]["kind"], "squared")
        self.assertGreater(stats["mollification"]["delta"], 0)
        # without, the Laplacian does not exist; the face that has no area is named
        self.assert_fails(
            self.run_program("laplacian", mesh, "--mollification", "none", "-o", "l.mtx"),
            mesh, "face 0")

    def test_extreme_scales(self):
        points, faces = icosphere(2)
        points = [(x, 0.01 * y, z) for x, y, z in points]
        reference = self.certify(self.write_off("s.off", points, faces))
        self.assertGreater(reference["delaunay"]["flips"], 0)
        for scale in (1e120, 1e-160):
            scaled = [tuple(scale * x for x in p) for p in points]
            for arithmetic in ("exact", "double"):
                stats = self.stats("delaunay", self.write_off("s.off", scaled, faces),
                                   "--arithmetic", arithmetic)
                if arithmetic == "exact":
                    self.assert_certified(stats)
                else: # the sign of a tie is rounding's
                    self.assertLessEqual(stats["delaunay"]["non_delaunay_edges"],
                                         reference["delaunay"]["cocircular_edges"])
                # rounding of the scaled coordinates moves angles by some 1e-16 / 0.01
                self.assert_close(stats["laplacian"]["trace"], reference["laplacian"]["trace"],
                                  1e-9)


if __name__ == "__main__":
    main()
