# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mass and interpolation matrices beside the Laplacian, of refined triangulations too."""

from cli_support import Cli_test, icosphere, jittered_grid, main, product


class Matrices(Cli_test):
    def setUp(self):
        super().setUp()
        points, faces = icosphere(2)
        self.mesh = self.write_off("m.off", [(x, 3 * y, 0.3 * z) for x, y, z in points], faces)

    def test_mass_matrices_integrate(self):
        for command, laplacian in (("refine", "--laplacian"), ("laplacian", "-o")):
            for arithmetic in ("exact", "double"):
                sums = {}
                for kind in ("lumped", "galerkin"):
                    stats = self.stats(command, self.mesh, laplacian, "l.mtx", "--mass", "m.mtx",
                                       "--mass-kind", kind, "--arithmetic", arithmetic)
                    vertices = stats["input"]["vertices"]
                    if command == "refine":
                        vertices += stats["refine"]["insertions"]
                    mass, stiffness = self.read_matrix("m.mtx"), self.read_matrix("l.mtx")
                    self.assertEqual(mass[:2], (vertices, vertices))
                    self.assertEqual(stiffness[:2], (vertices, vertices))
                    sums[kind] = product(mass, [1.0] * vertices)
                    self.assert_close(sum(sums[kind]), stats["area"]["input"], 1e-10)
                    self.assertTrue(all(x > 0 for x in mass[2].values()))
                    self.assertEqual(kind == "lumped", all(i == j for i, j in mass[2]))
                    # constants are in the kernel
                    zero = product(stiffness, [1.0] * vertices)
                    self.assertLess(max(map(abs, zero)), 1e-10)
                for a, b in zip(*sums.values()):  # rows of both sum to the same
                    self.assert_close(a, b, 1e-10)

    def subdivision_points(self, name):
        with open(self.path(name), encoding="ascii") as file:
            return [[float(x) for x in line.split()[1:4]] for line in file if line.startswith("v ")]

    def test_interpolation_from_both_sides_gives_the_points_of_the_subdivision(self):
        points, faces = jittered_grid(8)
        mesh = self.write_off("g.off", points, faces)
        for kind in ("integer", "crossings", "signposts"):
            stats = self.stats("refine", mesh, "-o", "s.obj", "--interpolation", "p.mtx",
                               "--input-interpolation", "q.mtx", "--correspondence", kind)
            wanted = self.subdivision_points("s.obj")
            p, q = self.read_matrix("p.mtx"), self.read_matrix("q.mtx")
            vertices = len(points) + stats["refine"]["insertions"]
            self.assertEqual(p[:2], (stats["subdivision"]["vertices"], vertices))
            self.assertEqual(q[:2], (stats["subdivision"]["vertices"], len(points)))
            for matrix in (p, q):
                for x in product(matrix, [1.0] * matrix[1]):
                    self.assertAlmostEqual(x, 1, 12)
            # in the plane coordinates are linear on both triangulations
            row = {j: i for (i, j), x in p[2].items() if x == 1}
            self.assertEqual(len(row), vertices)
            for k in range(3):
                from_input = product(q, [x[k] for x in points])
                from_intrinsic = product(p, [wanted[row[v]][k] for v in range(vertices)])
                for a, b, c in zip(from_input, from_intrinsic, wanted):
                    self.assertAlmostEqual(a, c[k], 9)
                    self.assertAlmostEqual(b, c[k], 9)

    def test_interpolation_beside_the_laplacian_of_the_delaunay_triangulation(self):
        stats = self.stats("laplacian", self.mesh, "-o", "l.mtx", "--interpolation", "p.mtx",
                           "--input-interpolation", "q.mtx")
        n = stats["input"]["vertices"]
        self.assertEqual(self.read_matrix("l.mtx")[:2], (n, n))
        for name in ("p.mtx", "q.mtx"):
            rows, columns, entries = self.read_matrix(name)
            self.assertEqual((rows, columns), (stats["subdivision"]["vertices"], n))
            self.assertLessEqual(len(entries), 2 * rows)  # vertices, and points on edges
        alone = self.stats("laplacian", self.mesh, "-o", "k.mtx")
        self.assertEqual(alone["correspondence"], "none")
        self.assert_same_file("l.mtx", "k.mtx")

    def test_wrong_usage(self):
        for arguments in (("refine", self.mesh, "--mass", "m.txt"),
                          ("refine", self.mesh, "--interpolation", "p.txt"),
                          ("refine", self.mesh, "--mass", "a.mtx", "--laplacian", "a.mtx"),
                          ("refine", self.mesh, "--interpolation", "a.mtx",
                           "--input-interpolation", "a.mtx"),
                          ("refine", self.mesh, "--interpolation", "p.mtx",
                           "--correspondence", "none"),
                          ("refine", self.mesh, "--mass", "m.mtx", "--mass-kind", "full")):
            self.assertEqual(self.run_program(*arguments).code, 2, arguments)
        self.run_program("delaunay", self.mesh, "-o", "t.idt", "--arithmetic", "double",
                         "--correspondence", "none")
        self.assert_fails(self.run_program("refine", "t.idt", "--interpolation", "p.mtx"), "t.idt",
                          "start from the mesh")
        self.stats("refine", self.mesh, "-o", "t.idt", "--interpolation", "a.mtx")
        self.assertEqual(self.stats("refine", "t.idt", "--interpolation", "b.mtx")["refine"]
                         ["insertions"], 0)
        self.assertEqual(self.read_matrix("a.mtx"), self.read_matrix("b.mtx"))
        stats = self.stats("refine", "t.idt", "--mass", "m.mtx")  # that needs no correspondence
        self.assert_close(sum(self.read_matrix("m.mtx")[2].values()), stats["area"]["input"], 1e-10)


if __name__ == "__main__":
    main()
