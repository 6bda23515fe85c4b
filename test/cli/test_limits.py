# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Work that doubles spoil, that takes long, or that is ended: what is said, and what is left."""

import os
import re
import resource
import select
import signal
import stat
import subprocess

from cli_support import Cli_test, grid, icosphere, main, parabola_fan


class Limits(Cli_test):
    def files(self):
        return sorted(os.listdir(self.directory))

    def rough_grid(self, n):
        points, faces = grid(n)
        return self.write_off("g.off", [(x, y, 0.3 * ((7 * x + 3 * y) % 5)) for x, y, _ in points],
                              faces)

    def test_what_doubles_spoil_is_not_written(self):
        mesh = self.write_off("fan.off", *parabola_fan(250))
        for options in ([], ["--odt-length", "5"], ["--correspondence", "crossings"]):
            run = self.run_program("refine", mesh, "--arithmetic", "double", "-o", "out.ply",
                                   "--stats", "out.json", "--view", "out.html", *options)
            self.assert_fails(run, "fan.off", "--arithmetic exact", "nothing was written")
            self.assertRegex(run.err, r"face \d+")
            before, after = map(float, re.search(r"area was (\S+) and is ([^;]+);",
                                                 run.err).groups())
            self.assert_close(before, 10292, 1e-9)
            self.assertGreater(abs(after - before), 1e-3)
            self.assertEqual(self.files(), ["fan.off"])

    def test_area_of_the_subdivision_is_that_of_the_input(self):
        points, faces = icosphere(2)
        mesh = self.write_off("m.off", [(x, 4 * y, 0.1 * z) for x, y, z in points], faces)
        for arithmetic in ("exact", "double"):
            stats = self.stats("refine", mesh, "--arithmetic", arithmetic, "-o", "out.ply")
            self.assert_close(stats["subdivision"]["area"], stats["area"]["input"], 1e-12)

    def test_files_beside_the_mesh_are_read_as_far_as_they_describe_it(self):
        mesh = self.rough_grid(2)
        for command, line in ((["delaunay", mesh, "--metric"], "1.5"),
                              (["refine", mesh, "--max-edge-length"], "0.5"),
                              (["transfer", mesh], "1 2"),
                              (["edit", mesh, "--handles"], "0 1 2 3"),
                              (["transport", mesh, "--vectors"], "0 90")):
            # lines without end
            with subprocess.Popen(["yes", line], stdout=subprocess.PIPE) as endless:
                done = subprocess.run([self.program, *command, "/dev/stdin"], stdin=endless.stdout,
                                      capture_output=True, text=True, timeout=60, check=False)
                endless.stdout.close()
            self.assertEqual(done.returncode, 1)
            self.assertIn("/dev/stdin:10", done.stderr)
            self.assertIn("9 vertices", done.stderr)

    def test_vertices_are_given_once(self):
        mesh = self.rough_grid(2)
        vectors = self.write("v.txt", "3 90\n# next\n5 0\n3 80\n")
        self.assert_fails(self.run_program("transport", mesh, "--vectors", vectors),
                          "v.txt:4", "vertex 3 is on line 1")
        self.assert_fails(self.run_program("field", mesh, "--vectors", vectors), "v.txt:4")
        handles = self.write("h.txt", "0 1 0 0\n0 1 0 0\n")
        self.assert_fails(self.run_program("edit", mesh, "--handles", handles), "h.txt:2")

    def test_times_of_heat(self):
        mesh = self.rough_grid(3)
        for time in ("1e300", "1e-300"):
            for source in (["--source", "0", "--method", "heat"], ["--signed", "--curve", "0,5"]):
                self.assert_fails(self.run_program("distance", mesh, "--time-factor", time, *source),
                                  "g.off", "time factor", "between")
            vectors = self.write("v.txt", "0 30\n")
            for arguments in (["transport", mesh, "--vectors", vectors],
                              ["logmap", mesh, "--source", "0", "--method", "polar"],
                              ["logmap", mesh, "--source", "0", "--method", "affine"]):
                self.assert_fails(self.run_program(*arguments, "--time-factor", time),
                                  "g.off", "time factor", "between")

    def test_fields_that_follow_curvature_closely_tend_to_it(self):
        points, faces = icosphere(2)
        mesh = self.write_off("m.off", [(x, 2 * y, 3 * z) for x, y, z in points], faces)

        def field(strength):
            run = self.run_program("field", mesh, "--degree", "2", "--align", strength, "-o",
                                   "f.txt", "--on", "intrinsic")
            self.assertEqual(run.code, 0, run.err)
            with open(self.path("f.txt")) as file:
                return [complex(*map(float, line.split()[:2])) for line in file]

        limit = field("1e9")
        for strength in ("1e20", "1e300"):
            # directions are lines: squares are alike
            far = [abs(z * z - w * w) for z, w in zip(field(strength), limit)]
            self.assertLess(max(far), 1e-3)

    def test_file_that_is_too_large_for_the_system(self):
        mesh = self.rough_grid(40)
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        for output in ("a.idt", "a.ply"):
            done = subprocess.run([self.program, "delaunay", mesh, "-o", output], text=True,
                                  cwd=self.directory, capture_output=True, timeout=60,
                                  preexec_fn=limit, check=False)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(output, done.stderr)
            self.assertEqual(self.files(), ["g.off"])

    def test_limit_of_time_ends_long_work(self):
        # neither ends in less than many seconds
        slow = self.rough_grid(60)
        for command in (["refine", slow, "--max-edge-length", "1e-3"],
                        ["refine", slow, "--max-edge-length", "1e-3", "--arithmetic", "double"]):
            run = self.run_program(*command, "-o", "out.ply", "--stats", "out.json",
                                   "--time-limit", "0.8")
            self.assert_fails(run, "g.off", "time limit of 0.8 s", "while refining",
                              "nothing was written", "--time-limit")
            self.assertLess(run.seconds, 8)
            self.assertEqual(self.files(), ["g.off"])

    def test_limit_of_time_that_is_met_does_nothing(self):
        mesh = self.rough_grid(5)
        run = self.run_program("delaunay", mesh, "-o", "a.ply", "--time-limit", "50",
                               "--quiet")
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        for word in ("0", "-1", "nan", "soon"):
            run = self.run_program("delaunay", mesh, "--time-limit", word)
            self.assertEqual(run.code, 2, run.err)

    def test_limit_of_time_at_any_moment_leaves_no_file(self):
        mesh = self.rough_grid(100)
        for k in range(1, 12):
            run = self.run_program("delaunay", mesh, "-o", "a.idt", "--stats", "s.json",
                                   "--time-limit", str(0.03 * k))
            self.assertIn(run.code, (0, 1))
            if run.code == 1:
                self.assertIn("time limit", run.err)
            self.assertEqual(self.files(), ["a.idt", "g.off", "s.json"] if run.code == 0
                             else ["g.off"])
            for name in set(self.files()) - {"g.off"}:
                os.remove(self.path(name))

    def test_limit_of_time_holds_while_a_program_becomes_another_one(self):
        mesh = self.rough_grid(60)
        for k in range(1, 40):
            run = self.run_program("eigen", mesh, "-o", "a.txt", "--time-limit", str(0.0005 * k))
            self.assertEqual(run.code, 1, run.err)
            self.assertIn("time limit", run.err)
            self.assertEqual(self.files(), ["g.off"])

    def test_progress_is_a_log(self):
        mesh = self.rough_grid(60)
        run = self.run_program("refine", mesh, "--max-edge-length", "1e-2", "--arithmetic",
                               "double", "--progress", "--time-limit", "3.5")
        lines = run.err.splitlines()
        stages = [re.fullmatch(r"(\d+\.\d) s: ([^:]+)(: \d+ vertices inserted)?", line)
                  for line in lines[:-1]]
        self.assertTrue(all(stages), run.err)
        self.assertEqual([m[2] for m in stages[:4]],
                         ["reading", "building", "flipping to Delaunay", "refining"])
        # one line a second
        times = [float(m[1]) for m in stages if m[3]]
        self.assertGreaterEqual(len(times), 2)
        self.assertTrue(all(b - a >= 0.9 for a, b in zip(times, times[1:])), times)
        run = self.run_program("delaunay", mesh)
        self.assertEqual(run.err, "")

    def start(self, *arguments, **streams):
        return subprocess.Popen([self.program, *arguments], cwd=self.directory,
                                stderr=subprocess.DEVNULL, **streams)

    def test_whatever_ends_the_program_leaves_no_file(self):
        mesh = self.rough_grid(60)
        os.mkfifo(self.path("pipe.mtx"))
        for ending in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL,
                       signal.SIGPIPE):
            reader = os.open(self.path("pipe.mtx"), os.O_RDONLY | os.O_NONBLOCK)
            with self.start("refine", mesh, "-o", "a.ply", "--laplacian", "pipe.mtx", "--stats",
                            "s.json", "--arithmetic", "double") as process:
                # a.ply is written but not complete, as nobody reads all of the matrix
                self.assertTrue(select.select([reader], [], [], 60)[0])
                if ending == signal.SIGPIPE:
                    os.close(reader)
                else:
                    process.send_signal(ending)
                self.assertEqual(process.wait(60), -ending)
                if ending != signal.SIGPIPE:
                    os.close(reader)
            self.assertEqual(self.files(), ["g.off", "pipe.mtx"])

    def test_a_file_that_is_replaced_keeps_its_mode(self):
        mesh = self.rough_grid(5)
        for mode in (0o600, 0o640, 0o755):
            old = self.write("a.ply", "what was there before")
            os.chmod(old, mode)
            run = self.run_program("delaunay", mesh, "-o", old)
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(stat.S_IMODE(os.stat(old).st_mode), mode)
            self.assertNotEqual(os.path.getsize(old), len("what was there before"))

    def test_a_new_file_has_the_mode_of_new_files(self):
        mesh = self.rough_grid(5)
        other = self.write("other", "")
        run = self.run_program("delaunay", mesh, "-o", "new.ply")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(os.stat(self.path("new.ply")).st_mode, os.stat(other).st_mode)

    def test_a_read_only_file_is_not_replaced(self):
        mesh = self.rough_grid(5)
        old = self.write("a.ply", "what was there before")
        os.chmod(old, 0o444)
        run = self.run_program("delaunay", mesh, "-o", "a.ply", "--stats", "s.json")
        self.assert_fails(run, "a.ply", "read-only")
        with open(old) as file:
            self.assertEqual(file.read(), "what was there before")
        self.assertEqual(self.files(), ["a.ply", "g.off"])

    def test_a_full_disk_is_named_with_the_file(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("this system has no /dev/full")
        mesh = self.rough_grid(5)
        for command, option, name in (("delaunay", "-o", "a.ply"), ("delaunay", "-o", "a.idt"),
                                      ("delaunay", "--stats", "s.json"),
                                      ("refine", "--laplacian", "l.mtx"),
                                      ("laplacian", "-o", "l.mtx"),
                                      ("laplacian", "--mass", "l.mtx")):
            os.symlink("/dev/full", self.path(name))
            run = self.run_program(command, mesh, option, name)
            self.assert_fails(run, name, "disk full")
            os.remove(self.path(name))


if __name__ == "__main__":
    main()
