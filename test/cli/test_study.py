# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`intrinsic study`: results of every kind, resumed, repeated and merged."""

import json
import math
import os
import re
import shutil
import subprocess

from cli_support import Cli_test, grid, icosphere, main

ARITHMETICS = ["double", "double-1e-12", "double-1e-6", "double-1e-5", "long-double", "interval",
               "boost-100", "boost-200", "gmpq", "core-expr", "lazy-core-expr", "exact",
               "exact-integer"]
FAST = "double,double-1e-6,interval,boost-100,exact"
TIMES = ("seconds", "peak_rss_mib")  # what may differ between runs


def without_times(line):
    return {key: value for key, value in line.items() if key not in TIMES}


class Study(Cli_test):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("corpus"))
        points, faces = icosphere(0)
        # sheared, so that no symmetry makes ties
        self.write_off("corpus/round.off",
                       [(x + 0.1 * y, 3 * y + 0.07 * z, 0.2 * z) for x, y, z in points], faces)
        points, faces = grid(2)
        self.write_off("corpus/flat.off", [(x + y, y, z) for x, y, z in points], faces)

    def study(self, *arguments, code=0):
        run = self.run_program("study", *arguments)
        self.assertEqual(run.code, code, run.out + run.err)
        self.assertEqual(re.sub(r"results         \d+, \d+ of them new.*\nwritten         .*\n",
                                "", run.out), "")
        self.assertEqual(bool(run.out), code == 0)
        return run

    def lines(self, name="study.jsonl"):
        with open(self.path(name), encoding="utf-8") as file:
            text = file.read()
        self.assertTrue(text.endswith("\n"))
        return [json.loads(line) for line in text.splitlines()]

    def by_key(self, name="study.jsonl"):
        lines = self.lines(name)
        result = {(line["mesh"], line["arithmetic"]): line for line in lines}
        self.assertEqual(len(result), len(lines))
        return result

    def report(self, *names):
        run = self.make_report(*names, "-o", "report.html")
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        return self.text("report.html")

    def text(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_all_arithmetics_agree_on_small_meshes(self):
        self.study("corpus")
        results = self.by_key()
        self.assertEqual(set(results), {(mesh, a) for mesh in ("round.off", "flat.off")
                                        for a in ARITHMETICS})
        for (mesh, arithmetic), line in results.items():
            if (mesh, arithmetic) == ("round.off", "gmpq"):  # areas are irrational
                self.assertEqual(line["status"], "not_applicable")
                self.assertIn("irrational", line["message"])
                continue
            exact = results[mesh, "exact"]
            self.assertEqual(line["status"], "done", line)
            self.assertEqual(line["comparison"], "complete")
            self.assertEqual(line["family"], "files")
            keys = ["vertices", "faces", "cocircular_edges"]
            if arithmetic != "exact-integer":  # which has no lengths that tell the order of flips, hence other ties
                keys += ["flips", "checks", "result"]
            for key in keys:
                self.assertEqual(line[key], exact[key], (mesh, arithmetic, key))
            for key in ("different_decisions", "nonconvex_flips", "inverted_faces",
                        "non_delaunay_edges", "cycles", "refused_flips"):
                self.assertEqual(line[key], 0, (mesh, arithmetic, key))
            if arithmetic != "exact-integer":  # which has no values that could drift
                self.assertLess(line["area_drift"], 1e-14)
                self.assertLess(line["cone_angle_drift"], 1e-13)
            self.assertGreater(line["seconds"]["flip"], 0)
            self.assertGreater(line["peak_rss_mib"], 1)
            self.assertEqual(line["limits"], {"seconds": 60, "mib": 4096})
            self.assertRegex(line["version"], r"^\d+\.\d+\.\d+$")
            self.assertIn("processors", line["machine"])
            self.assertEqual("largest_interval_width" in line, arithmetic in ("interval", "exact"))
            self.assertEqual("certified_zero" in line, arithmetic.startswith("exact"))
            self.assertEqual("undecided" in line, arithmetic == "interval")
        self.assertGreater(results["flat.off", "exact"]["flips"], 0)
        self.assertGreater(results["flat.off", "exact"]["cocircular_edges"], 0)  # squares

    def test_tolerances_leave_edges_that_are_not_delaunay(self):
        # cot k = 0, cot m = (b^2 - 1) / (2 b) = -2e-6
        mesh = self.write_off("kite.off", [(-1, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1 + 2e-6, 0)],
                              [(0, 1, 2), (1, 0, 3)])
        self.study(mesh, "--arithmetic", "double,double-1e-6,double-1e-5,exact")
        results = self.by_key()
        for arithmetic, missed in (("double", 0), ("double-1e-6", 0), ("double-1e-5", 1),
                                   ("exact", 0)):
            line = results["kite.off", arithmetic]
            self.assertEqual(line["flips"], 1 - missed)
            self.assertEqual(line["non_delaunay_edges"], missed)
            self.assertEqual(line["different_decisions"], missed)

    def test_time_limit_is_a_result(self):
        points, faces = icosphere(2)
        mesh = self.write_off("sphere.off", [(x, 3 * y, 0.2 * z) for x, y, z in points], faces)
        self.study(mesh, "--arithmetic", "core-expr,double", "--time-limit", "1.5", "--jobs", "2")
        results = self.by_key()
        late = results["sphere.off", "core-expr"]
        self.assertEqual(late["status"], "timed_out")
        self.assertEqual(late["limits"], {"seconds": 1.5, "mib": 4096})
        self.assertIn("1.5 s", late["message"])
        self.assertEqual(late["vertices"], 162)
        self.assertNotIn("flips", late)
        self.assertNotIn("seconds", late)
        self.assertEqual(results["sphere.off", "double"]["status"], "done")
        # the same limit again: nothing is to be done; a larger one: once more
        before = self.text("study.jsonl")
        self.study(mesh, "--arithmetic", "core-expr,double", "--time-limit", "1.5")
        self.assertEqual(self.text("study.jsonl"), before)
        self.study(mesh, "--arithmetic", "core-expr,double", "--time-limit", "1.6")
        self.assertEqual([line["arithmetic"] for line in self.lines()].count("core-expr"), 2)
        self.assertEqual([line["arithmetic"] for line in self.lines()].count("double"), 1)

    def test_memory_limit_is_a_result(self):
        points, faces = icosphere(4)
        mesh = self.write_off("sphere.off", [(x, 3 * y, 0.2 * z) for x, y, z in points], faces)
        self.study(mesh, "--arithmetic", "core-expr,exact", "--memory-limit", "64",
                   "--time-limit", "5")
        results = self.by_key()
        # address sanitizers reserve so much that memory cannot be limited
        self.assertIn(results["sphere.off", "core-expr"]["status"], ("out_of_memory", "timed_out"))
        self.assertEqual(results["sphere.off", "exact"]["status"], "done")

    def test_malformed_mesh_is_refused(self):
        self.write("corpus/bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
        self.study("corpus", "--arithmetic", "double,exact")
        for arithmetic in ("double", "exact"):
            line = self.by_key()["bad.off", arithmetic]
            self.assertEqual(line["status"], "refused_input")
            self.assertIn("bad.off", line["message"])
            self.assertNotIn("corpus", line["message"])
            self.assertNotIn("flips", line)

    def test_running_again_gives_the_same_numbers(self):
        self.study("corpus", "--arithmetic", FAST, "-o", "a.jsonl")
        self.study("corpus", "--arithmetic", FAST, "-o", "b.jsonl", "--jobs", "3")
        a, b = self.by_key("a.jsonl"), self.by_key("b.jsonl")
        self.assertEqual(a.keys(), b.keys())
        for key, line in a.items():
            self.assertEqual(without_times(line), without_times(b[key]))

    def test_resumes_where_it_was_interrupted(self):
        self.study("corpus", "--arithmetic", FAST)
        whole = self.by_key()
        lines = self.text("study.jsonl").splitlines(keepends=True)
        kept = lines[:3] + lines[5:7]
        self.write("study.jsonl", "".join(kept) + lines[8][:20])  # the last line is not complete
        self.study("corpus", "--arithmetic", FAST)
        self.assertEqual(self.text("study.jsonl").splitlines(keepends=True)[:5], kept)
        resumed = self.by_key()
        self.assertEqual(resumed.keys(), whole.keys())
        for key, line in whole.items():
            self.assertEqual(without_times(line), without_times(resumed[key]))
        self.assertNotEqual(self.report("study.jsonl"), "")

    def test_results_are_merged_in_any_order(self):
        self.study("corpus", "--arithmetic", FAST)
        lines = self.text("study.jsonl").splitlines(keepends=True)
        self.write("a.jsonl", "".join(lines[4:]))
        self.write("b.jsonl", "".join(reversed(lines[:6])))
        whole = self.report("study.jsonl")
        self.assertEqual(self.report("a.jsonl", "b.jsonl"), whole)
        self.assertIn("flat.off", whole)

    def test_stress_meshes(self):
        spec = "stress:caps:amount=1e-8:seed=3"
        self.study(spec, "--arithmetic", "double,exact")
        line = self.by_key()[spec, "exact"]
        self.assertEqual(line["status"], "done")
        self.assertEqual(line["family"], "caps")
        self.assertEqual(line["non_delaunay_edges"], 0)

    def test_faces_that_are_no_manifold_are_compared_on_a_cover(self):
        tips = [(math.cos(t), math.sin(t), 0.3 + 0.1 * t) for t in (0, 1, 2.5)]
        mesh = self.write_off("book.off", [(0, 0, 0), (0, 0, 1)] + tips,
                              [(0, 1, k) for k in (2, 3, 4)])
        self.study(mesh, "--arithmetic", "double,exact")
        self.study(mesh, "--arithmetic", "double,exact", "--domain", "tufted")
        self.study(mesh, "--arithmetic", "double", "--domain", "manifold")
        lines = self.by_key()
        self.assertEqual(len(lines), 5)
        for name in ("book.off", "book.off (tufted)"):
            exact = lines[name, "exact"]
            self.assertEqual((exact["status"], exact["faces"]), ("done", 6))
            self.assertEqual(exact["result"], lines[name, "double"]["result"])
        refused = lines["book.off (manifold)", "double"]
        self.assertEqual(refused["status"], "refused_input")
        self.assertIn("three faces", refused["message"].replace("3 faces", "three faces"))

    def test_wrong_usage(self):
        before = sorted(os.listdir(self.directory))
        self.study(code=2)
        self.study("corpus", "--arithmetic", "float", code=2)
        self.study("corpus", "--jobs", "0", code=2)
        self.study("corpus", "--time-limit", "0", code=2)
        self.study("corpus", "-o", "a.json", code=2)
        self.study("corpus", "--report", "r.html", code=2)
        for arguments in (["a.jsonl"], ["a.jsonl", "corpus"]):
            self.assertIn("report.py", self.study(*arguments, code=2).err)
        self.study("corpus", "--time-limit", "nan", code=2)
        self.assert_fails(self.run_program("study", "nothing.off"), "nothing.off")
        self.assert_fails(self.run_program("study", "corpus", "corpus/flat.off"), "flat.off")
        self.assert_fails(self.run_program("study", "stress:nothing"), "nothing")
        self.assertEqual(sorted(os.listdir(self.directory)), before)

    def test_help(self):
        run = self.run_program("study", "--help")
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertIn("--time-limit", run.out)
        self.assertIn("study", self.run_program("--help").out)

    def test_program_of_the_study_is_found(self):
        """Beside the program, else on PATH; if it is nowhere the message says how to build it."""
        here, path, nowhere = self.path("here"), self.path("path"), self.path("nowhere")
        for directory in (here, path, nowhere):
            os.mkdir(directory)
        for directory in (here, nowhere):
            shutil.copy2(self.program, directory)
        for directory, code in ((here, 10), (path, 11)):
            self.write(directory + "/intrinsic-study", f"#!/bin/sh\necho \"$@\"\nexit {code}\n")
            os.chmod(directory + "/intrinsic-study", 0o755)
        for program, code in ((here, 10), (nowhere, 11)):
            done = subprocess.run([program + "/intrinsic", "study", "a b", "--jobs", "2", "-x"],
                                  env=os.environ | {"PATH": path}, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (code, "a b --jobs 2 -x\n"))
        done = subprocess.run([nowhere + "/intrinsic", "study", "a"], env={"PATH": here + "/none"},
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("--target intrinsic-study", done.stderr)

    def test_other_lines_are_named(self):
        self.write("study.jsonl", "{\"mesh\": 1}\n")
        self.assert_fails(self.run_program("study", "corpus"), "study.jsonl", "line 1")


if __name__ == "__main__":
    main()
