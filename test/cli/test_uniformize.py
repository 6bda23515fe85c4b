# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scale factors with which surfaces have prescribed angles."""

import math

from cli_support import CUBE, Cli_test, grid, icosphere, main


def angle_sums(points, faces, u):
    """The angles around vertices with lengths scaled by exp((u_i + u_j)/2)."""
    sums = [0] * len(points)
    for face in faces:
        sides = [math.dist(points[i], points[j]) * math.exp((u[i] + u[j]) / 2)
                 for i, j in zip(face, face[1:] + face[:1])]
        for k in range(3):
            a, b, c = sides[k], sides[k - 1], sides[(k + 1) % 3]
            sums[face[k]] += math.acos((a * a + b * b - c * c) / (2 * a * b))
    return sums


class Uniformize(Cli_test):
    def scale(self, mesh, *arguments):
        stats = self.stats("uniformize", mesh, "-o", "u.txt", *arguments)
        return stats, [row[0] for row in self.read_rows("u.txt")]

    def test_angles_are_the_prescribed_ones(self):
        points, faces = icosphere(2)
        faces = [list(f) for f in faces]
        mesh = self.write_off("s.off", points, faces)
        angles = [x + 0.02 * math.sin(7 * i) for i, x in
                  enumerate(angle_sums(points, faces, [0] * len(points)))]
        angles[0] += math.pi * len(faces) - math.fsum(angles)
        file = self.write("a.txt", "# radians\n" + "".join(f"{x!r}\n" for x in angles))
        for arithmetic in ("exact", "double"):
            stats, u = self.scale(mesh, "--angles", file, "--arithmetic", arithmetic)
            result = stats["conformal"]
            self.assertEqual(result["status"], "done")
            self.assertEqual(result["flips"], 0)  # so that lengths in space can be scaled
            self.assertLess(abs(math.fsum(u)), 1e-12)
            for found, wanted in zip(angle_sums(points, faces, u), angles):
                self.assertLess(abs(found - wanted), 1e-10)
            if arithmetic == "exact":
                self.assertLess(result["proven_residual"], 1e-9)
                self.assertGreater(result["proven_residual"], 0)
            else:
                self.assertIsNone(result["proven_residual"])
            self.assertGreater(stats["seconds"]["uniformize"], 0)

    def test_cones_are_chosen_or_listed(self):
        mesh = self.write_off("s.off", *icosphere(3))
        stats, u = self.scale(mesh, "--cones", "8")
        result = stats["conformal"]
        self.assertEqual((result["status"], result["cones"]), ("done", 8))
        self.assertEqual([c["angle"] for c in result["cone_angles"]], [1.5 * math.pi] * 8)
        file = self.write("c.txt", "".join(f"{c['vertex']} 3/2pi\n" for c in result["cone_angles"]))
        self.assertEqual(self.scale(mesh, "--cones", file)[1], u)
        _, other = self.scale(mesh, "--cones", file, "--start", "input")
        self.assertLess(max(abs(x - y) for x, y in zip(u, other)), 0.1)

    def test_planar_disks_stay_as_they_are(self):
        points, faces = grid(5)
        stats, u = self.scale(self.write_off("g.off", points, faces))
        self.assertEqual(u, [0] * len(points))
        self.assertEqual(stats["conformal"]["iterations"], 0)
        file = self.write("a.txt", "free\n" * len(points))
        self.assertEqual(self.scale("g.off", "--angles", file)[1], u)

    def test_bad_angles_are_refused(self):
        mesh = self.write_off("cube.off", *CUBE)
        refused = lambda *a: self.run_program("uniformize", mesh, *a)
        self.assert_fails(refused(), "cube.off", "Gauss and Bonnet", "too large by", "(4 pi)")
        self.assert_fails(refused("--cones", "2"), "place at least 3")
        for text, words in (("pi\n", ("has 1 angles", "8 vertices")),
                            ("-1\n" * 8, ("a.txt:1:", "not positive")),
                            ("xpi\n" * 8, ("a.txt:1:", "3/2pi")),
                            ("1 2\n" * 8, ("a.txt:1:",)),
                            ("3pi/2\n" * 7 + "pi\n", ("too small by", "(0.5 pi)"))):
            self.assert_fails(refused("--angles", self.write("a.txt", text)), *words)
        for text, words in (("8 pi\n", ("c.txt:1:",)), ("1 0\n", ("c.txt:1:", "not positive"))):
            self.assert_fails(refused("--cones", self.write("c.txt", text)), *words)
        file = self.write("a.txt", "3pi/2\n" * 8)
        self.assertEqual(self.scale(mesh, "--angles", file)[1], [0] * 8)
        run = refused("--angles", file, "--cones", "8")
        self.assertEqual(run.code, 2)


if __name__ == "__main__":
    main()
