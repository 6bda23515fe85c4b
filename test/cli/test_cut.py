# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `cut`: meshes cut open along curves, isolines, and to disks."""

import math

from cli_support import Cli_test, grid, icosphere, main


def area(points, face):
    a, b, c = (points[v] for v in face)
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2


def torus(n, m):
    points, faces = [], []
    for j in range(m):
        for i in range(n):
            a, b = 2 * math.pi * i / n, 2 * math.pi * j / m
            d = 3 + math.cos(a)
            points.append((d * math.cos(b), d * math.sin(b), math.sin(a)))
            p, q = n * j + i, n * j + (i + 1) % n
            u, v = n * ((j + 1) % m) + i, n * ((j + 1) % m) + (i + 1) % n
            faces += [(p, u, v), (p, v, q)]
    return points, faces


class Cut(Cli_test):
    def obj(self, name):
        """Points, faces, and the component of each face."""
        points, faces, components = [], [], []
        with open(self.path(name), encoding="ascii") as file:
            for words in map(str.split, file):
                if words[0] == "v":
                    points.append(tuple(map(float, words[1:])))
                elif words[0] == "g":
                    component = int(words[1].removeprefix("component_"))
                elif words[0] == "f":
                    faces.append([int(w) - 1 for w in words[1:]])
                    components.append(component)
        return points, faces, components

    def test_a_square_is_divided_by_a_path(self):
        mesh = self.write_off("g.off", *grid(7))
        cut = self.stats("cut", mesh, "--path", "3,59", "-o", "c.obj", "--labels", "l.txt")["cut"]
        points, faces, components = self.obj("c.obj")
        self.assertEqual(cut["faces"], len(faces))
        self.assertEqual(cut["vertices"], len(points))
        self.assertEqual([c["faces"] for c in cut["components"]],
                         [components.count(0), components.count(1)])
        self.assert_close(sum(area(points, f) for f in faces), 49, 1e-12)
        self.assert_close(sum(c["area"] for c in cut["components"]), 49, 1e-12)
        self.assertEqual(cut["divided_faces"], 0) # the path runs along edges, at y = 3
        for face, component in zip(faces, components):
            sides = {points[v][1] > 3 for v in face if points[v][1] != 3}
            self.assertEqual(len(sides), 1)
        with open(self.path("l.txt"), encoding="ascii") as file:
            labels = [tuple(map(int, line.split())) for line in file if not line.startswith("#")]
        self.assertEqual([component for component, _ in labels], components)
        self.assertEqual(sorted(face for _, face in labels), list(range(98)))

    def test_a_sphere_is_divided_by_isolines_of_values_and_distances(self):
        points, faces = icosphere(3)
        mesh = self.write_off("s.off", points, faces)
        self.write("z.txt", "".join(f"{p[2]!r}\n" for p in points))
        for function in (["--values", "z.txt", "--levels", "-0.3,0.4"],
                         ["--source", "0", "--levels", "2"]):
            stats = self.stats("cut", mesh, *function, "-o", "c.ply")
            cut = stats["cut"]
            self.assertEqual(len(cut["components"]), 3)
            self.assertEqual(cut["euler_characteristic"], 2)
            self.assertEqual(cut["border_loops"], 4)
            self.assertEqual(len(stats["isolines"]["levels"]), 2)
            whole = sum(area(points, f) for f in faces)
            self.assert_close(sum(c["area"] for c in cut["components"]), whole, 1e-12)

    def test_a_torus_becomes_an_annulus_and_a_disk(self):
        mesh = self.write_off("t.off", *torus(8, 14))
        loop = self.stats("cut", mesh, "--loop", "0,3,6")["cut"]
        self.assertEqual((loop["euler_characteristic"], loop["border_loops"]), (0, 2))
        disk = self.stats("cut", mesh, "--to-disk", "-o", "d.off")["cut"]
        self.assertEqual((disk["euler_characteristic"], disk["border_loops"]), (1, 1))
        self.assertEqual(self.stats("info", "d.off")["input"]["boundary_edges"], 2 * disk["edges"])

    def test_misuse_and_curves_that_cut_nothing_are_refused(self):
        mesh = self.write_off("s.off", *icosphere(1))
        for arguments, word in (([], "nothing to cut"), (["--levels", "2"], "--values"),
                                (["--levels", "2", "--source", "0", "--path", "0,3"], "either"),
                                (["--to-disk", "--path", "0,3"], "either")):
            run = self.run_program("cut", mesh, *arguments)
            self.assertEqual(run.code, 2, run.err)
            self.assertIn(word, run.err)
        self.assert_fails(self.run_program("cut", mesh, "--loop", "0,3,5", "-o", "c.obj"), "point")
        self.assert_fails(self.run_program("cut", mesh, "--levels", "7", "--source", "99"), "99")
        self.assert_fails(self.run_program("cut", mesh, "--source", "0", "--levels", "50,60"),
                          "isoline")
        self.write("few.txt", "1\n2\n")
        self.assert_fails(self.run_program("cut", mesh, "--values", "few.txt", "--levels", "2"),
                          "few.txt")
        wings = self.write_off("w.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)],
                               [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        self.assert_fails(self.run_program("cut", wings, "--path", "2,3"), "cover")


if __name__ == "__main__":
    main()
