# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command isometry, and hashes of surfaces."""

from cli_support import Cli_test, main

CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


class Isometry(Cli_test):
    def setUp(self):
        super().setUp()
        self.cube = self.write_off("cube.off", CUBE, QUADS)
        turned = [(y, z, x) for x, y, z in CUBE]
        # one square has a vertex inside
        faces = QUADS[1:] + [(0, 1, 8), (1, 3, 8), (3, 2, 8), (2, 0, 8)]
        self.cut = self.write_off("cut.off", turned + [(0.5, 0.25, 0)], faces)
        self.long = self.write_off("long.off", [(x, y, 2 * z) for x, y, z in CUBE], QUADS)

    def test_answers(self):
        for files, answer, count in (((self.cube,), "isometric", 48),
                                     ((self.cube, self.cut), "isometric", 48),
                                     ((self.cube, self.long), "not_isometric", 0),
                                     ((self.long,), "isometric", 16)):
            found = self.stats("isometry", *files)["isometry"]
            self.assertEqual((answer, count), (found["answer"], found["count"]))
            self.assertIsInstance(found["count"], int)
            self.assertEqual(0 if count else None, found["largest_difference"])

    def test_hashes(self):
        hashes = [self.stats("info", file, "--hash")["hash"]
                  for file in (self.cube, self.cut, self.long)]
        self.assertEqual(hashes[0], hashes[1])
        self.assertNotEqual(hashes[0], hashes[2])
        self.assertRegex(hashes[0], "^[0-9a-f]{16}$")
        self.assertIn(hashes[0], self.run_program("info", self.cube, "--hash").out)

    def test_the_second_file_must_exist(self):
        run = self.run_program("isometry", self.cube, "nothing.off")
        self.assertEqual(1, run.code)
        self.assertIn("nothing.off", run.err)


if __name__ == "__main__":
    main()
