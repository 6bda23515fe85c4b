# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options, exit codes, the keys of the statistics, and the files that are written."""

import json
import os
import random
import signal
import subprocess
import time

from cli_support import Cli_test, grid, icosphere, main

KEYS = {
    "input": {"file", "vertices", "edges", "faces", "boundary_edges", "components", "genus",
              "degenerate_faces"},
    "mollification": {"kind", "delta"},
    "delaunay": {"checks", "flips", "filter_failures", "escalations", "sharpenings", "certified_zero",
                 "probable_zero", "non_delaunay_edges"},
    "quality": {"min_angle_deg", "max_angle_deg", "min_cotan_weight"},
    "laplacian": {"trace"},
    "dirichlet": {"x", "y", "z"},
    "area": {"input", "intrinsic"},
    "seconds": {"read", "build", "topology", "delaunay", "write"},
}


class Options(Cli_test):
    def setUp(self):
        super().setUp()
        points, faces = icosphere(2)
        self.mesh = self.write_off("m.off", [(x, y, 0.1 * z) for x, y, z in points], faces)
        self.points = points

    def files(self):
        return sorted(os.listdir(self.directory))

    def assert_misused(self, *arguments, word=""):
        before = self.files()
        run = self.run_program(*arguments)
        self.assertEqual(run.code, 2, run.out + run.err)
        self.assertEqual(run.out, "")
        self.assertIn(word, run.err)
        self.assertEqual(self.files(), before)

    def test_help_and_version(self):
        for arguments in (["--help"], ["--version"], ["delaunay", "--help"], ["help"],
                          ["help", "delaunay"], ["help", "help"], ["help", "--version"]):
            run = self.run_program(*arguments)
            self.assertEqual(run.code, 0)
            self.assertNotEqual(run.out, "")
            self.assertEqual(run.err, "")

    def test_wrong_usage(self):
        self.assert_misused()
        self.assert_misused("delaunay")
        self.assert_misused("refine")
        self.assert_misused("refine", self.mesh, "--min-angle", "60")
        self.assert_misused("refine", self.mesh, "--max-circumradius", "0")
        self.assert_misused("refine", self.mesh, "--laplacian", "l.txt")
        self.assert_misused("delaunay", self.mesh, "--arithmetic", "float")
        self.assert_misused("delaunay", self.mesh, "--mollification", "some")
        self.assert_misused("delaunay", self.mesh, "--mass", "m.mtx")
        self.assert_misused("laplacian", self.mesh, "--mass-kind", "full")
        self.assert_misused("transfer", self.mesh, "extra.txt", "extra.off")
        self.assert_misused("delaunay", self.mesh, "--correspondence", "some")
        self.assert_misused("laplacian", self.mesh, "--correspondence", "integer")
        self.assert_misused("delaunay", self.mesh, "-o", "out.txt", word=".idt")
        self.assert_misused("delaunay", self.mesh, "-o", "out.ply", "--correspondence", "none",
                            word="integer")
        self.assert_misused("delaunay", self.mesh, "-o", "a.ply", "--view", "a.ply", word="two")
        self.assert_misused("laplacian", self.mesh, "-o", "out.txt", word=".mtx")
        self.assert_misused("laplacian", self.mesh, "-o", "a.mtx", "--mass", "a.mtx", word="two")

    def test_options_that_would_do_nothing_are_refused(self):
        self.assert_misused("laplacian", self.mesh, "--mass-kind", "galerkin", word="--mass")
        self.assert_misused("distance", self.mesh, "--source", "0", "-o", "d.txt", "--plain",
                            word="--plain leaves labels")
        for output in ("-o", "g.obj"), ("-o", "g.ply"), ("-o", "g.off"), ():
            self.assert_misused("geodesic", self.mesh, "--path", "0,5", *output, "--plain",
                                word="curves have no labels; leave --plain out, or give --subdiv")
        self.assert_misused("geodesic", self.mesh, "--path", "0,5", "-o", "g.idt", "--plain",
                            word="--plain leaves labels")
        self.assert_misused("geodesic", self.mesh, "--source", "0", "--waypoints",
                            word="--waypoints is of curves")
        self.assert_misused("cut", self.mesh, "--to-disk", "--waypoints",
                            word="--waypoints is of curves")
        self.assert_fails(self.run_program("logmap", self.mesh, "--source", "0", "--time-factor",
                                           "2"), "m.off", "leave out --time-factor")
        self.run_program("simplify", self.mesh, "-o", "coarse.idt")
        self.assert_fails(self.run_program("field", "coarse.idt", "--align", "1"), "coarse.idt",
                          "leave --align out")

    def test_misspelt_words_have_the_nearest_one_in_the_message(self):
        for arguments, word in ((("delanay", self.mesh), "did you mean delaunay?"),
                                (("xyzzy", self.mesh), "use delaunay, refine,"),
                                (("refine", self.mesh, "--min-angel", "20"), "did you mean --min-angle?"),
                                (("delaunay", self.mesh, "--arithmatic=exact"),
                                 "did you mean --arithmetic?"),
                                (("delaunay", self.mesh, "--mollify", "none"),
                                 "did you mean --mollification?"),
                                (("distance", self.mesh, "-source", "1"), "did you mean --source?"),
                                (("distance", self.mesh, "--surce", "1"), "did you mean --source?"),
                                (("info", self.mesh, "--xyzzy"), "--help lists all"),
                                (("info", self.mesh, "--json"), "did you mean --stats: write"),
                                (("voronoi", self.mesh), "--voronoi is an option of distance"),
                                (("mass", self.mesh), "--mass is an option of refine, laplacian"),
                                (("delaunay", self.mesh, "--constrain", "e.txt"), "no option --constrain")):
            self.assert_misused(*arguments, word=word)

    def test_names_that_other_programs_have_for_options_lead_to_these(self):
        for name in "--output", "--out", "--write", "--save", "--file", "--Output=a.ply":
            self.assert_misused("delaunay", self.mesh, name, "x.ply",
                                word="; did you mean -o: write the common subdivision")
            self.assert_misused("info", self.mesh, name, "x.ply", word="--help lists all")
        for command in "delaunay", "parametrize":  # where help has the word, too
            self.assert_misused(command, "--mesh", self.mesh, word="; did you mean IN: mesh (.off,")

    def test_words_of_help_lead_to_an_option_if_it_is_the_only_one(self):
        self.assert_misused("delaunay", self.mesh, "--megabytes", "1",
                            word="did you mean --view-limit: most megabytes")
        for word in "--megabyte", "--faces":  # a part of a word; in the help of several options
            self.assert_misused("delaunay", self.mesh, word, "1", word="--help lists all")

    def test_help_on_an_unknown_command_is_an_error(self):
        self.assert_misused("help", "foo", word='there is no command "foo"; use delaunay,')
        self.assert_misused("help", "delanay", word="did you mean delaunay?")

    def test_points_of_one_option_are_separated_by_commas(self):
        for option in ("--source", "--targets"):
            self.assert_misused("distance", self.mesh, "--source", "3", option, "0", "1",
                                word="1: there is no such mesh; if this is a point, separate")
        run = self.run_program("distance", self.mesh, "--source", "0,1", "--source", "5")
        self.assertEqual(run.code, 0, run.err)

    def test_messages_on_numbers_say_which_are_allowed(self):
        self.assert_misused("eigen", self.mesh, "--count", "0",
                            word="--count: 0: give a positive whole number\n")
        self.assert_misused("field", self.mesh, "--degree", "1000",
                            word="give a whole number from 1 to 999")
        self.assert_fails(self.run_program("eigen", self.write_off("s.off", *icosphere(4)), "--count",
                                           "20000"), "s.off: ", "2562 vertices", "not 20000")

    def test_outputs_are_told_apart_by_what_they_name(self):
        os.mkdir(self.path("d"))
        os.symlink(".", self.path("link"))
        for stats in ("a.ply", "./a.ply", "d/../a.ply", "link/a.ply", self.path("a.ply")):
            self.assert_misused("delaunay", self.mesh, "-o", "a.ply", "--stats", stats, word="two")
        self.write("a.ply", "what was there before")
        os.symlink("a.ply", self.path("other.json"))
        self.assert_misused("delaunay", self.mesh, "-o", "a.ply", "--stats", "other.json",
                            word="two")
        run = self.run_program("delaunay", self.mesh, "-o", "a.ply", "--stats", "d/a.ply")
        self.assertEqual(run.code, 0, run.err)

    def test_outputs_do_not_overwrite_inputs(self):
        edges = self.write("edges.txt", "0 11\n")
        os.symlink("m.off", self.path("link.off"))
        os.link(edges, self.path("hard.json"))
        for output in (self.mesh, "m.off", "./m.off", "link.off"):
            self.assert_misused("delaunay", self.mesh, "-o", output, word="also an input")
        for output in ("edges.txt", "./edges.txt", "hard.json"):
            self.assert_misused("delaunay", self.mesh, "--keep", edges, "--stats", output,
                                word="also an input")
        self.write("factors.txt", "1\n" * len(self.points))
        self.assert_misused("delaunay", self.mesh, "--metric", "factors.txt", "--stats",
                            "factors.txt", word="factors.txt")
        run = self.run_program("delaunay", "/dev/null", "--stats", "/dev/null")
        self.assert_fails(run, "/dev/null")  # devices may be both

    def test_names_that_are_no_text(self):
        # bytes that are no UTF-8: alone, cut short, longer than necessary, surrogates, too great
        generator = random.Random(7)
        names = [b"caf\xe9", b"\xc3", b"\xc0\xaf", b"\xed\xa0\x80", b"\xf4\x90\x80\x80",
                 b"\xe2\x82", b"\xc3\xa9t\xc3\xa9", b"\xf0\x9f\x90\x98"]
        names += [bytes(generator.choice(b"a\x80\xbf\xc3\xe2\xf0\xff") for _ in range(6))
                  for _ in range(12)]
        for name in names:
            path = os.path.join(os.fsencode(self.directory), name + b".off")
            with open(self.mesh, "rb") as file, open(path, "wb") as copy:
                copy.write(file.read())
            arguments = [os.fsencode(self.program), b"delaunay", path, b"--stats", b"-"]
            done = subprocess.run(arguments, capture_output=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            shown = json.loads(done.stdout.decode())["input"]["file"]
            # escaped by the rules of Python's own decoder, whose digits are small
            expected = path.decode(errors="surrogateescape")
            expected = "".join(f"\\x{ord(c) - 0xdc00:02X}" if 0xdc80 <= ord(c) < 0xdd00 else c
                               for c in expected)
            self.assertEqual(shown, expected)

    def test_numbers_that_mean_nothing(self):
        for option in ("--odt-length", "--max-circumradius", "--max-edge-length"):
            for number in ("nan", "inf", "-1", "0", "many"):
                if (option, number) != ("--max-edge-length", "many"):  # may be a file
                    self.assert_misused("refine", self.mesh, option, number)
        for number in ("nan", "-1", "1e999", "59.5"):
            self.assert_misused("refine", self.mesh, "--min-angle", number)
        for number in ("-1", "nan", "1.5", "1e30"):
            self.assert_misused("refine", self.mesh, "--max-insertions", number)
        run = self.run_program("refine", self.mesh, "--max-insertions", "0")
        self.assertEqual(run.code, 0, run.err)

    def test_messages_on_usage_are_short(self):
        lengthy = "x" * 5000
        for arguments in ((lengthy,), ("transfer", self.mesh, "u.txt", lengthy), ("delaunay", self.mesh, "-o", lengthy),
                          ("refine", self.mesh, "--odt-length", lengthy), ("refine", self.mesh, "--odt-length", "0"),
                          ("refine", self.mesh, "--order", lengthy), ("info", "--" + lengthy),
                          ("refine", self.mesh, "--max-insertions", "-1"),
                          ("refine", self.mesh, "--min-angle", "9" * 3000),
                          ("delaunay", self.mesh, "--stats", "a\x1b[31m", "\x1b[31m")):
            run = self.run_program(*arguments)
            self.assertEqual(run.code, 2)
            self.assertLess(len(run.err), 500)
            self.assertTrue(run.err.replace("\n", "").isprintable(), run.err)
            if arguments[-1] == "0":
                self.assertNotRegex(run.err, r"\d{10}")

    def test_keys_of_the_statistics(self):
        for command in ("delaunay", "laplacian", "info"):
            for arithmetic in ("exact", "double"):
                stats = self.stats(command, self.mesh, "--arithmetic", arithmetic)
                for key, inner in KEYS.items():
                    self.assertLessEqual(inner, stats[key].keys())
                self.assertEqual(stats["arithmetic"], arithmetic)
                self.assertEqual(stats["correspondence"],
                                 "integer" if command == "delaunay" else "none")
                self.assertGreater(stats["peak_rss_mib"], 1)
                self.assertEqual(stats["input"]["file"], self.mesh)
                self.assertEqual(stats["input"]["genus"], 0)

    def test_standard_output_has_only_what_is_asked_for(self):
        run = self.run_program("delaunay", self.mesh, "-o", "a.idt", "--stats", "s.json", "--quiet")
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        self.assertEqual(self.files(), ["a.idt", "m.off", "s.json"])
        run = self.run_program("info", self.mesh)
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertIn("162 vertices", run.out)

    def test_mollification(self):
        kinds = {"automatic": "none", "none": "none", "squared": "squared"}
        for option, kind in kinds.items():
            stats = self.stats("delaunay", self.mesh, "--mollification", option)
            self.assertEqual(stats["mollification"]["kind"], kind)
            self.assertEqual(stats["mollification"]["delta"] > 0, kind != "none")
        stats = self.stats("delaunay", self.mesh, "--mollification", "lengths")
        self.assertIn("dirichlet", stats)

    def test_triangulation_is_read_back(self):
        for arithmetic in ("exact", "double"):
            done = self.stats("delaunay", self.mesh, "--arithmetic", arithmetic, "-o", "a.idt")
            again = self.stats("info", "a.idt")
            self.assertEqual(again["arithmetic"], arithmetic)
            self.assertEqual(again["certificate"], done["certificate"])
            self.assertEqual(again["laplacian"], done["laplacian"])
            self.assertEqual(again["quality"], done["quality"])
            self.assertEqual(again["area"]["intrinsic"], done["area"]["intrinsic"])
            if arithmetic == "exact":
                self.assertEqual(again["dirichlet"], done["dirichlet"])
                self.assertEqual(again["area"], done["area"])
            more = self.stats("delaunay", "a.idt", "-o", "b.idt")
            self.assertEqual(more["delaunay"]["flips"], 0)
            self.assert_same_triangulation("a.idt", "b.idt")
            other = "double" if arithmetic == "exact" else "exact"
            self.assert_fails(self.run_program("info", "a.idt", "--arithmetic", other), "a.idt")
            self.assert_fails(self.run_program("info", "a.idt", "--mollification", "none"), "a.idt")

    def test_damaged_triangulation_is_refused(self):
        self.run_program("delaunay", self.mesh, "-o", "a.idt")
        with open(self.path("a.idt")) as file:
            text = file.read()
        self.assert_fails(self.run_program("info", self.write("b.idt", text[:len(text) // 2])),
                          "b.idt:")
        self.assert_fails(self.run_program("info", self.write("c.idt", "OFF\n")), "c.idt:1")

    def test_laplacian_of_the_input(self):
        raw = self.stats("laplacian", self.mesh, "--no-flip")
        flipped = self.stats("laplacian", self.mesh)
        self.assertEqual(raw["delaunay"]["flips"], 0)
        self.assertGreater(raw["delaunay"]["non_delaunay_edges"], 0)
        self.assertEqual(raw["certificate"], "none")
        # x^T L x of the input is that of its coordinates; flips to Delaunay can only lower it
        self.assertLess(flipped["dirichlet"]["x"], raw["dirichlet"]["x"])

    def test_target_that_cannot_be_written(self):
        before = self.files()
        self.assert_fails(self.run_program("delaunay", self.mesh, "-o", "none/a.idt"), "none/a.idt")
        # the second output fails: the first does not appear either
        self.assert_fails(self.run_program("laplacian", self.mesh, "-o", "a.mtx", "--mass",
                                           "none/m.mtx"), "none/m.mtx")
        self.assert_fails(self.run_program("delaunay", self.mesh, "-o", "a.idt", "--stats",
                                           "none/s.json"), "none/s.json")
        self.assertEqual(self.files(), before)

    def test_interrupt_leaves_no_half_written_file(self):
        points, faces = grid(150)
        mesh = self.write_off("g.off", [(x, y, 0.3 * ((7 * x + 3 * y) % 5)) for x, y, _ in points],
                              faces)
        old = self.write("out.idt", "what was there before")
        for delay in (0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4):
            with subprocess.Popen([self.program, "delaunay", mesh, "-o", old],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
                time.sleep(delay)
                process.send_signal(signal.SIGINT)
                process.wait(60)
            with open(old) as file:
                text = file.read()
            # the signal may come after the file was replaced: then it is complete
            self.assertIn(process.returncode, (0, -signal.SIGINT))
            is_complete = text.startswith("IDT 5 ") and text.endswith("\nend\n")
            if process.returncode == 0:
                self.assertTrue(is_complete)
            self.assertTrue(is_complete or text == "what was there before")
            self.write("out.idt", "what was there before")
            self.assertEqual(self.files(), ["g.off", "m.off", "out.idt"])


if __name__ == "__main__":
    main()
