# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands on files, as `workflow/` runs them: limits, records, hashes, the report."""

import json
import os
import re
import subprocess
import sys
import types
import unittest
import unittest.mock

from cli_support import HERE, REPORT_PYTHON, Cli_test, Run, grid, icosphere, main

WORKFLOW = os.path.join(HERE, "..", "..", "workflow")
sys.path.insert(0, WORKFLOW)
import commands
import inputs
import processes
from failure import Failure

LIMITS = {"time_limit": 60, "memory_limit": 4096, "cores": 1}


Names = types.SimpleNamespace


class Versions(unittest.TestCase):
    """Snakemake 7 is what Debian has; 8 has other names."""

    def modules(self, **found):
        names = ("snakemake.common", "snakemake_interface_executor_plugins.settings")
        return unittest.mock.patch.dict(sys.modules, {
            "snakemake": None, **dict.fromkeys(names), **{n.replace("__", "."): m for n, m in found.items()}})

    def test_the_first_process_knows_itself(self):
        with self.modules(snakemake=Names(), snakemake__common=Names(Mode=Names(default=0))):
            self.assertTrue(processes.is_first_process(Names(mode=0)))
            self.assertFalse(processes.is_first_process(Names(mode=1)))
        settings = Names(ExecMode=Names(DEFAULT=0))
        with self.modules(snakemake=Names(), snakemake__common=Names(),
                          snakemake_interface_executor_plugins=Names(),
                          snakemake_interface_executor_plugins__settings=settings):
            self.assertTrue(processes.is_first_process(Names(exec_mode=0)))
            self.assertFalse(processes.is_first_process(Names(exec_mode=1)))


class Collections(Cli_test):
    def setUp(self):
        super().setUp()
        self.write_off("flat.off", *grid(3))
        self.write_off("bad.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)])

    def record(self, command, file, seconds=60, mib=4096):
        run = Run(sys.executable, [
            os.path.join(WORKFLOW, "run_command.py"), "--program", self.program, "--command",
            command, "--file", file, "--sha256", "0" * 64, "--out", "files/out", "--cores", 1,
            "--time-limit", seconds, "--memory-limit", mib, "-o", "record.json"], self.directory)
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        with open(self.path("record.json"), encoding="utf-8") as file:
            return json.load(file)

    def repeated(self, record):
        return subprocess.run(["bash", "-c", record["repeat"]], cwd=self.directory,
                              stderr=subprocess.PIPE, text=True)

    def test_what_is_done_has_statistics_and_files(self):
        record = self.record("refine --min-angle 30 -o {out}.ply", "flat.off")
        self.assertEqual((record["status"], record["exit_code"]), ("done", 0))
        self.assertEqual(record["statistics"]["input"]["faces"], 18)
        self.assertTrue(os.path.exists(self.path("files/out.ply")))
        os.unlink(self.path("files/out.ply"))
        self.assertEqual(self.repeated(record).returncode, 0)
        self.assertTrue(os.path.exists(self.path("files/out.ply")))

    def test_a_study_has_its_lines(self):
        record = self.record("study --arithmetic double,exact", "flat.off")
        self.assertEqual([line["arithmetic"] for line in record["statistics"]],
                         ["double", "exact"])

    def test_errors_are_results_with_the_command_that_repeats_them(self):
        record = self.record("delaunay", "bad.off")
        self.assertEqual((record["status"], record["exit_code"]), ("failed", 1))
        self.assertIn("face 0 refers to vertex 7", record["message"])
        again = self.repeated(record)
        self.assertEqual((again.returncode, again.stderr.strip()), (1, record["message"]))
        self.assertEqual(self.record("delaunay --nonsense", "flat.off")["status"], "misused")

    def test_limits_are_results(self):
        self.write_off("round.off", *icosphere(5))
        late = self.record("refine --max-edge-length 1e-3", "round.off", seconds=0.2)
        self.assertEqual((late["status"], late["exit_code"]), ("timed_out", None))
        self.assertLess(late["seconds"], 5)
        self.assertEqual(self.repeated(self.record("delaunay", "flat.off")).returncode, 0)
        large = self.record("refine --max-edge-length 1e-3", "round.off", mib=128)
        self.assertEqual(large["status"], "out_of_memory", large)

    def test_names_have_the_hash_of_contents(self):
        os.mkdir(self.path("more"))
        text = "OFF\n0 0 0\n"
        for name in "more/a.off", "more/b.off", "more/c.txt":
            self.write(name, text)
        hashes = inputs.Hashes(self.path("hashes.json"))
        found = inputs.hashed_files([self.path("more"), "stress"], hashes)
        hashes.keep()
        self.assertEqual([os.path.basename(path) for path, _ in found],
                         ["a.off", "b.off", "stress"])
        self.assertEqual(found[0][1], found[1][1])
        listed = subprocess.run(["sha256sum", *(path for path, _ in found[:2])],
                                stdout=subprocess.PIPE, text=True).stdout
        self.assertEqual(list(inputs.hashed_files([self.write("l.sha256", listed)], hashes)),
                         found[:2])
        os.rename(self.path("more"), self.path("moved"))
        self.assertEqual(set(inputs.named_files(inputs.hashed_files([self.path("moved")], hashes))),
                         set(inputs.named_files(found[:2])))
        self.write("moved/a.off", text + "\n")
        changed = inputs.hashed_files([self.path("moved")], hashes)
        self.assertNotEqual(changed[0][1], changed[1][1])
        with self.assertRaisesRegex(Failure, "nothing.off"):
            inputs.hashed_files([self.path("nothing.off")], hashes)

    def test_commands_may_have_limits_of_their_own(self):
        named = commands.named_commands(LIMITS | {"commands": [
            "delaunay", {"run": "eigen --count 3", "time_limit": 600, "cores": 4}]})
        self.assertEqual(list(named), ["delaunay", "eigen_--count_3"])
        self.assertEqual(named["delaunay"], ("delaunay", 60, 4096, 1))
        self.assertEqual(named["eigen_--count_3"], ("eigen --count 3", 600, 4096, 4))
        for wrong in (None, [], ["delaunay", "delaunay"], [{"time_limit": 3}],
                      [{"run": "x", "y": 1}]):
            with self.assertRaises(Failure):
                commands.named_commands(LIMITS | {"commands": wrong})


def record(file, command="delaunay", status="done", seconds=1.0, message="", **statistics):
    return {"file": file, "sha256": file, "command": command, "status": status,
            "message": message, "repeat": f"intrinsic {command} {file}", "seconds": seconds,
            "peak_rss_mib": 20.0, "limits": {"seconds": 60, "mib": 4096},
            "statistics": {"input": {"faces": 200}, "seconds": {"read": seconds}} | statistics
            if status == "done" else None}


class Report(Cli_test):
    """The page; of records that are written here."""

    def page(self, records, *arguments):
        self.write("runs.jsonl", "".join(json.dumps(r) + "\n" for r in records))
        run = Run(REPORT_PYTHON, [os.path.join(WORKFLOW, "report.py"), "runs.jsonl", *arguments,
                                  "-o", "page.html"], self.directory)
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        with open(self.path("page.html"), encoding="utf-8") as file:
            return file.read()

    def rows(self, page):
        return [re.findall("<t[dh][^>]*>(.*?)</t[dh]>", row)
                for row in re.findall("<tr.*?</tr>", page, re.DOTALL)]

    def test_the_page_says_what_was_found_and_what_has_changed(self):
        before = [record("a.off", angle=20), record("b.off", seconds=2.0, angle=10),
                  record("c.off"), record("old.off")]
        self.write("before.jsonl", "".join(json.dumps(r) + "\n" for r in before))
        page = self.page(
            [record("a.off", seconds=4.0, angle=20), record("b.off", seconds=2.0, angle=30),
             record("c.off", status="failed", message="edge <3> is bad"),
             record("new.off", angle=40)],
            "--before", "before.jsonl")
        self.assertNotRegex(page, "<script|<link|src=|http|<3>")
        rows = self.rows(page)
        self.assertIn(["delaunay", "4", "3", "1", "8.00", "1.50", "4.00", "20.0"], rows)
        self.assertIn(["c.off", "delaunay", "failed", "edge &lt;3&gt; is bad",
                       "intrinsic delaunay c.off"], rows)
        self.assertIn(["angle", "20", "a.off", "30", "40", "new.off"], rows)
        self.assertEqual([row[0] for row in rows if row[-1:] == ["done"]][0], "a.off")
        self.assertIn("3 runs on the same contents", page)
        self.assertIn(["delaunay", "2", "2.00", "2.00", "4.00", "a.off"], rows)
        self.assertIn(["c.off", "delaunay", "done", "failed", "edge &lt;3&gt; is bad"], rows)
        self.assertIn(["b.off", "delaunay", "angle", "10", "30"], rows)
        self.assertNotIn("seconds.read", page)

    def test_what_is_no_result_is_named(self):
        self.write("bad.jsonl", "{}\n")
        run = Run(REPORT_PYTHON, [os.path.join(WORKFLOW, "report.py"), "bad.jsonl", "-o", "p.html"],
                  self.directory)
        self.assert_fails(run, "bad.jsonl: line 1")


if __name__ == "__main__":
    main()
