# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""All meshes of CGAL's data set: certified, or refused with the edge or face at fault."""

import os
import re
import unittest

from cli_support import Cli_test, main

MESHES = os.environ.get("INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR", "")
EXTENSIONS = (".off", ".obj", ".ply", ".stl", ".ts")
SECONDS = 10  # for one mesh; most take less than half a second on an idle machine
SECONDS_FOR_CLOUD = 30  # b9.ply, 84,000 points among which 317,000 are inserted: six seconds there


def mesh_files():
    return sorted(name for name in os.listdir(MESHES) if name.endswith(EXTENSIONS))


@unittest.skipUnless(MESHES and os.path.isdir(MESHES), "CGAL's data set is not installed")
class Cgal_meshes(Cli_test):
    def check_areas(self, stats):
        """Flips conserve area. Both sums round: products of coordinates to 2^-53 of |u| |v|, whose
        ratio to the area of a face is its worst cotangent or more; 1e-12 leaves a mean ratio of
        1e3, which no mesh of the set has, except where mollification acted, which adds to areas."""
        if stats["mollification"]["kind"] == "none":
            self.assert_close(stats["area"]["input"], stats["area"]["intrinsic"], 1e-12)
        else:
            self.assert_close(stats["area"]["input"], stats["area"]["intrinsic"], 1e-6)

    def check_agreement(self, exact, double):
        """The Laplacian of a Delaunay triangulation is unique, and continuous where ties are decided
        differently. Doubles lose up to the worst aspect ratio of a face of the input, squared in
        the trace: 1e-6 leaves it 1e5."""
        self.assertEqual(double["certificate"], "none")
        if exact["mollification"]["kind"] != "none":
            return
        self.assert_close(exact["laplacian"]["trace"], double["laplacian"]["trace"], 1e-6)
        total = sum(exact["dirichlet"].values())
        for axis in "xyz":
            difference = abs(exact["dirichlet"][axis] - double["dirichlet"][axis])
            self.assertLessEqual(difference, 1e-6 * total)

    def test_every_mesh_is_certified_or_refused(self):
        accepted, refused = 0, []
        for name in mesh_files():
            path = os.path.join(MESHES, name)
            with self.subTest(mesh=name):
                runs = [self.run_program("delaunay", path, "--arithmetic", a, "--stats", "-")
                        for a in ("exact", "double")]
                for run in runs:
                    self.assertLess(run.seconds, SECONDS)
                self.assertEqual(runs[0].code, runs[1].code, runs[0].err + runs[1].err)
                if runs[0].code == 1:
                    refused.append(name)
                    self.assertEqual(runs[0].out, "")
                    self.assertIn(name, runs[0].err)
                    self.assertRegex(runs[0].err, re.compile(r"(edge|face) \(?\d+|no faces"))
                    continue
                self.assertEqual(runs[0].code, 0, runs[0].err)
                accepted += 1
                exact, double = runs[0].json(), runs[1].json()
                self.assert_certified(exact)
                if exact["quality"]["min_cotan_weight"] is not None: # else all edges are border
                    self.assertGreaterEqual(exact["quality"]["min_cotan_weight"], 0)
                self.check_areas(exact)
                self.check_agreement(exact, double)
        print(f"{accepted} meshes certified, {len(refused)} refused: {' '.join(refused)}")
        self.assertGreater(accepted, 100)

    def check_effort(self, name, counts):
        """Refinement works in doubles and sums of two; what they leave open are ties, and a few signs and places on needles."""
        wide = {kind: sum(n for bits, n in counts[kind].items() if int(bits) > 106)
                for kind in ("escalations", "sharpenings")}
        if name.split(".")[0] in ("armadillo", "camel", "elephant"):
            self.assertEqual(wide, {"escalations": 0, "sharpenings": 0})
        for kind in wide:
            self.assertLessEqual(wide[kind], counts["flips"] // 50 + 10)
        self.assertEqual(counts["probable_zero"], 0)

    def test_every_mesh_is_refined_exactly_at_the_price_of_doubles(self):
        refined = 0
        for name in mesh_files():
            with self.subTest(mesh=name):
                run = self.run_program("refine", os.path.join(MESHES, name), "--min-angle", "25",
                                       "--stats", "-")
                self.assertLess(run.seconds,
                                SECONDS_FOR_CLOUD if name == "b9.ply" else SECONDS)
                if run.code == 1:
                    continue # see above
                refined += 1
                stats = run.json()
                self.assertEqual(stats["certificate"], "exact")
                self.check_areas(stats)
                self.check_effort(name, stats["delaunay"])
        self.assertGreater(refined, 100)


if __name__ == "__main__":
    main()
