# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What commands say on the terminal: answers, files, warnings; several inputs; standard input."""

import json
import os
import re
import subprocess

from cli_support import CUBE, Cli_test, beside, grid, icosphere, jittered_grid, main


class Answers(Cli_test):
    def setUp(self):
        super().setUp()
        self.mesh = self.write_off("ball.off", *icosphere(2))
        self.write("vectors.txt", "0 0\n")
        self.write("handles.txt", "0 1 0 0\n")
        self.write("u.txt", "1\n" * 162)
        self.write("pairs.txt", "0 3\n0 5\n")

    def answer(self, command, *arguments):
        run = self.run_program(command, *arguments)
        self.assertEqual((run.code, run.err), (0, ""))
        return run.out

    def test_every_command_answers(self):
        # a command, and what its first lines say
        for arguments, *said in (
                (("delaunay", self.mesh), "Delaunay        yes, certified", "flips           0",
                 "ties            0 edges"),
                (("refine", self.mesh), "inserted        0 vertices", "met by all faces"),
                (("laplacian", self.mesh), "cotan weights   from 0."),
                (("transfer", self.mesh, "u.txt"), "functions       1, from the input, by l2",
                 "integrals       12.", "L2 distance     "),
                (("geodesic", self.mesh, "--path", "0,3"), "status          geodesic, certified",
                 "length          3.11135; before"),
                (("cut", self.mesh, "--to-disk"), "pieces          ", "1 boundary"),
                (("distance", self.mesh, "--source", "0"), "distances       0 to 3.", "exact"),
                (("distance", self.mesh, "--source", "0", "--targets", "0,3"),
                 "to targets      0, 3.11135"),
                (("distance", self.mesh, "--pairs", "pairs.txt"),
                 "of pairs        3.11135, 1.1026"),
                (("parametrize", self.mesh), "map             harmonic",
                 "injective       yes, certified", "cut open        along "),
                (("uniformize", self.mesh), "target          sphere", "layout          injective"),
                (("transport", self.mesh, "--vectors", "vectors.txt"),
                 "vectors         from 1 source; the longest has "),
                (("logmap", self.mesh, "--source", "0"), "radius          3."),
                (("field", self.mesh), "degree          4", "index sum       8, of "),
                (("eigen", self.mesh, "--count", "4"), "eigenvalues     ",
                 ", 1.99993, 1.99993, 1.99993"),
                (("edit", self.mesh, "--handles", "handles.txt"), "moved           by at most 1"),
                (("embed", self.mesh), "320 triangles; status done", "0 vertices on faces"),
                (("info", self.mesh), "162 vertices", "genus 0, closed")):
            with self.subTest(arguments[0]):
                out = self.answer(*arguments)
                for words in said:
                    self.assertIn(words, out)
                lines = out.splitlines()
                self.assertLessEqual(len(lines), 12 if arguments[0] in ("info", "refine") else 8)
                self.assertNotIn("{", out)  # all figures are filled in

    def test_files_are_named_after_the_answer(self):
        out = self.answer("distance", self.mesh, "--source", "0", "-o", "d.vtp", "--isolines",
                          "l.obj", "--stats", "s.json")
        self.assertEqual([line[16:] for line in out.splitlines() if line.startswith("written")],
                         ["d.vtp: the common subdivision with values", "l.obj: isolines",
                          "s.json: statistics"])
        out = self.answer("refine", self.mesh, "-o", "t.idt", "--laplacian", "l.mtx", "--mass",
                          "m.mtx")
        self.assertIn("\nwritten         t.idt: the intrinsic triangulation\n"
                      "written         l.mtx: the Laplacian\n"
                      "written         m.mtx: the mass matrix\n", out)

    def test_results_on_standard_output_are_alone_there(self):
        run = self.run_program("distance", self.mesh, "--source", "0", "--stats", "-")
        self.assertEqual(run.json()["distance"]["method"], "exact")
        self.assertIn("distances       0 to 3.", run.err)
        run = self.run_program("distance", self.mesh, "--source", "0", "-o", "-")
        self.assertEqual(len([float(x) for x in run.out.split()]), 162)
        self.assertIn("distances       0 to 3.", run.err)
        run = self.run_program("delaunay", self.mesh, "-o", "-.off", "--quiet")
        self.assertEqual((run.code, run.out.split()[0][-3:], run.err), (0, "OFF", ""))
        run = self.run_program("distance", self.mesh, "--source", "0", "-o", "-", "--stats", "-")
        self.assertEqual(run.code, 2)  # two results would be mixed

    def test_minus_is_a_file_with_the_first_extension_of_the_help(self):
        self.write("sets.txt", "0 3\n5\n")
        source = ("--source", "0")
        for command, *options, output in (
                ("delaunay", "-o"), ("refine", "-o"), ("laplacian", "-o"),
                ("laplacian", "--mass"), ("transfer", "u.txt", "-o"),
                ("geodesic", "--path", "0,3", "-o"), ("cut", "--to-disk", "-o"),
                ("cut", "--to-disk", "--labels"), ("distance", *source, "-o"),
                ("distance", *source, "--isolines"), ("distance", *source, "--voronoi"),
                ("distance", "--pairs", "pairs.txt", "-o"),
                ("distance", "--sources", "sets.txt", "-o"), ("parametrize", "-o"),
                ("uniformize", "-o"), ("transport", "--vectors", "vectors.txt", "-o"),
                ("logmap", *source, "-o"), ("field", "-o"), ("field", "--singularities"),
                ("eigen", "--count", "4", "-o"), ("edit", "--handles", "handles.txt", "-o"),
                ("simplify", "-o"), ("simplify", "--places"), ("embed", "-o")):
            with self.subTest(command, options=options, output=output):
                said = self.run_program(command, "--help").out
                said = re.search(rf"\n +{output} .*?(?=\n +-)", said, re.DOTALL)[0]
                extension = (re.findall(r"\bto\s+(\.[a-z]+)", said) or [".mtx"])[0]
                run = subprocess.run([self.program, command, self.mesh, *options, output, "-",
                                      "--quiet"], cwd=self.directory, capture_output=True)
                self.assertEqual((run.returncode, run.stderr), (0, b""))
                self.run_program(command, self.mesh, *options, output, "file" + extension)
                with open(self.path("file" + extension), "rb") as file:
                    self.assertTrue(run.stdout == file.read())

    def test_the_program_alone_lists_its_commands(self):
        run = self.run_program()
        self.assertEqual((run.code, run.out), (2, ""))
        self.assertIn("Usage: intrinsic", run.err)
        for command in "delaunay", "distance", "info":
            self.assertRegex(run.err, rf"\n  {command} +[a-z]")

    def test_quiet_and_verbose(self):
        points, faces = beside(*icosphere(1), 3)
        mesh = self.write_off("two.off", points, faces)
        run = self.run_program("distance", mesh, "--source", "0", "--quiet")
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        run = self.run_program("distance", mesh, "--source", "9999", "--quiet")
        self.assert_fails(run, "9999")
        out = self.run_program("distance", mesh, "--source", "0", "--verbose").out
        for words in ("topology        2 components", "angles", "seconds         read "):
            self.assertIn(words, out)
        self.assertEqual(self.run_program("info", mesh, "--quiet", "--verbose").code, 2)

    def warning(self, *arguments):
        run = self.run_program(*arguments)
        self.assertEqual(run.code, 0, run.err)
        self.assertNotIn("warning", run.out)
        return run.err

    def test_warnings_come_last_and_name_the_remedy(self):
        points, faces = beside(*icosphere(1), 3)
        two = self.write_off("two.off", points, faces)
        self.assertIn("two.off: warning: 42 of 84 vertices not reached",
                      self.warning("distance", two, "--source", "0"))
        self.assertEqual("", self.warning("distance", two, "--source", "0", "--max-distance", "1"))
        self.write("far.txt", "0 50\n")
        self.assertIn("1 distance infinite", self.warning("distance", two, "--pairs", "far.txt"))
        thin = self.write_off("thin.off", [(0, 0, 0), (1, 0, 0), (.5, .001, 0)], [(0, 1, 2)])
        heat = self.warning("distance", thin, "--source", "0", "--method", "heat")
        self.assertIn("the error may be large; use --method exact or --refine", heat)
        self.assertIn("thin faces", self.warning("laplacian", thin))
        self.assertEqual("", self.warning("distance", self.mesh, "--source", "0", "--method",
                                          "heat"))

    def test_above_30_degrees_there_is_no_guarantee(self):
        mesh = self.write_off("flat.off", *jittered_grid(12))
        err = self.warning("refine", mesh, "--min-angle", "45", "--max-insertions", "200")
        self.assertIn("no guarantee", err)
        run = self.run_program("refine", mesh, "--min-angle", "45", "--time-limit", "0.5")
        self.assert_fails(run, "no guarantee above 30 degrees", "--min-angle 30", "nothing was")
        self.assertNotIn("more time", run.err)

    def test_errors_name_the_domain(self):
        book = self.write_off("book.off", [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0)],
                              [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        self.assert_fails(self.run_program("info", book, "--domain", "manifold"),
                          "edge (0, 1) has 3 faces", "--domain tufted")


class Several_inputs(Cli_test):
    def setUp(self):
        super().setUp()
        self.write_off("cube.off", *CUBE)
        self.write_off("grid.off", *grid(3))

    def test_each_has_its_heading_and_its_files(self):
        run = self.run_program("distance", "cube.off", "grid.off", "--source", "0", "-o",
                               "{}-d.txt", "--stats", "{}.json")
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertIn("cube.off:\ndistances       0 to 2.23607", run.out)
        self.assertIn("\n\ngrid.off:\ndistances       0 to 4.24264", run.out)
        self.assertEqual([len(self.read_rows(f"{name}-d.txt")) for name in ("cube", "grid")],
                         [8, 16])
        with open(self.path("grid.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["input"]["file"], "grid.off")
        alone = self.run_program("distance", "cube.off", "--source", "0", "-o", "again-{}.txt")
        self.assertEqual(alone.code, 0, alone.err)
        self.assert_same_file("cube-d.txt", "again-cube.txt")

    def test_one_that_fails_does_not_end_the_others(self):
        run = self.run_program("delaunay", "nowhere.off", "grid.off")
        self.assertEqual(run.code, 1)
        self.assertIn("nowhere.off", run.err)
        self.assertIn("grid.off:\nDelaunay        yes", run.out)

    def test_one_file_for_several_inputs_is_refused_in_words(self):
        run = self.run_program("delaunay", "cube.off", "grid.off", "-o", "t.ply")
        self.assertEqual((run.code, run.out), (2, ""))
        self.assertIn("2 inputs cannot share one file", run.err)
        self.assertIn("{}-t.ply", run.err)
        run = self.run_program("delaunay", "cube.off", "grid.off", "-o", "-")
        self.assertEqual((run.code, run.out), (2, ""))
        self.assertIn("2 inputs cannot share standard output; write files, such as -o {}.ply", run.err)
        os.mkdir(self.path("more"))
        self.write_off("more/cube.off", *CUBE)
        run = self.run_program("delaunay", "cube.off", "more/cube.off", "-o", "{}.ply")
        self.assertEqual(run.code, 2)
        self.assertIn("another input has the name cube", run.err)
        self.assertEqual(sorted(os.listdir(self.directory)), ["cube.off", "grid.off", "more"])

    def test_standard_input(self):
        with open(self.path("grid.off"), encoding="ascii") as file:
            grid_file = file.read()
        obj = "# a triangle\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.run_program("delaunay", "grid.off", "-o", "t.idt")
        with open(self.path("t.idt"), encoding="ascii") as file:
            idt = file.read()
        for text, said in ((grid_file, "16 vertices, 33 edges, 18 faces"),
                           (obj, "3 vertices, 3 edges, 1 face"),
                           (idt, "16 vertices, 33 edges, 18 faces")):
            run = self.piped(text, "info", "-")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertIn(said, run.stdout)
        run = self.piped(grid_file, "distance", "-", "--source", "0", "-o", "-")  # elsewhere
        self.assertEqual(len(run.stdout.split()), 16)
        run = self.piped("what is this", "info", "-")
        self.assertEqual(run.returncode, 1)
        self.assertIn("--input-format", run.stderr)
        run = self.piped(grid_file.replace("OFF\n", ""), "info", "-", "--input-format", "off")
        self.assertIn("standard input", run.stdout + run.stderr)
        self.assertEqual(os.listdir(self.temporary), [])

    def test_standard_input_is_called_so(self):
        with open(self.path("grid.off"), encoding="ascii") as file:
            grid_file = file.read()
        for arguments in (("info", "-"), ("info", "-", "--stats", "-"), ("info", "-", "--verbose"),
                          ("distance", "-", "--source", "99"), ("eigen", "-", "--stats", "-"),
                          ("delaunay", "-", "--view", "v.html")):
            run = self.piped(grid_file, *arguments)
            said = run.stdout + run.stderr
            self.assertNotIn(self.temporary, said, arguments)
            self.assertIn("standard input" if run.returncode else "", said)
        with open(self.path("v.html"), encoding="utf-8") as file:
            self.assertIn("<title>standard input</title>", file.read())
        run = self.piped(grid_file, "info", "-", "--stats", "-")
        self.assertIn('"file": "standard input"', run.stdout)
        run = self.piped("garbage 1 2", "info", "-", "--input-format", "off")
        self.assertTrue(run.stderr.startswith("intrinsic: standard input:1: "), run.stderr)

    def piped(self, text, *arguments):
        self.temporary = self.path("temporary")
        os.makedirs(self.temporary, exist_ok=True)
        return subprocess.run([self.program, *arguments], input=text, capture_output=True,
                              text=True, cwd=self.directory, timeout=60, check=False,
                              env={**os.environ, "TMPDIR": self.temporary})


if __name__ == "__main__":
    main()
