# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflow in `workflow/`, run by Snakemake on CGAL's data set: `.ci/run` runs it."""

import json
import os
import shutil
import signal
import subprocess
import time

from cli_support import HERE, REPORT_PYTHON, Cli_test, main

WORKFLOW = os.path.join(HERE, "..", "..", "workflow")
MESHES = os.environ["INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR"]
SAMPLE = ("elephant.off", "fandisk.off", "knot1.off", "sphere.off")


class Workflow(Cli_test):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("meshes"))
        for name in SAMPLE:
            shutil.copy(os.path.join(MESHES, name), self.path("meshes"))
        self.write_off("meshes/bad.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)])

    def words(self, config):
        self.write("config.yaml", json.dumps(  # YAML is a superset of JSON
            {"intrinsic": self.program, "python": REPORT_PYTHON, "time_limit": 60} | config))
        return ["snakemake", "--snakefile", os.path.join(WORKFLOW, "Snakefile"), "--profile",
                os.path.join(WORKFLOW, "profiles", "local"), "--configfile", "config.yaml"]

    def run_workflow(self, config, *options):
        """Runs it, and returns how many runs it has made."""
        run = subprocess.run([*self.words(config), *options], cwd=self.directory, capture_output=True,
                             text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stderr.count("\nrule run:")

    def records(self, results="results"):
        with open(self.path(f"{results}/runs.jsonl"), encoding="utf-8") as file:
            return {(r["command"], os.path.basename(r["file"])): r for r in map(json.loads, file)}

    def test_only_what_is_new_runs(self):
        config = {"files": ["meshes"], "commands": ["delaunay", "refine --min-angle 25"]}
        self.assertEqual(self.run_workflow(config), 10)
        records = self.records()
        self.assertEqual(len(records), 10)
        for (command, name), record in records.items():
            self.assertEqual(record["status"], "failed" if name == "bad.off" else "done")
        self.assertIn("face 0 refers to vertex 7", self.text("results/report.html"))
        self.assertEqual(self.run_workflow(config), 0)
        os.rename(self.path("meshes"), self.path("moved"))
        config["files"] = ["moved/*.off"]
        for name in SAMPLE:
            os.utime(self.path("moved/" + name))
        self.assertEqual(self.run_workflow(config), 0)
        shutil.copy(os.path.join(MESHES, "eight.off"), self.path("moved/bad.off"))
        os.mkdir(self.path("old"))
        shutil.copy(self.path("results/runs.jsonl"), self.path("old"))
        self.assertEqual(self.run_workflow(config | {"before": "old/runs.jsonl"}), 2)
        self.assertIn("8 runs on the same contents", self.text("results/report.html"))

    def text(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_it_continues_after_an_interruption(self):
        config = {"files": ["meshes"], "commands": ["delaunay", "eigen --count 20"]}
        process = subprocess.Popen(self.words(config), cwd=self.directory,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and self.number_of_records() < 6:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        process.wait()
        done = self.number_of_records()
        self.assertLess(done, 10)
        again = self.run_workflow(config)
        self.assertGreaterEqual(again, 10 - done)
        self.assertLess(again, 10)  # what ended while it was interrupted may run again
        self.assertEqual(len(self.records()), 10)

    def number_of_records(self):
        return sum(name.endswith(".json") for _, _, names in os.walk(self.path("results/runs"))
                   for name in names)

    def test_runs_are_submitted_in_groups(self):
        """As to a cluster: processes of their own read the config again."""
        config = {"files": ["meshes"], "commands": ["delaunay"]}
        with open(self.write("submit", "#!/bin/sh\necho >> submitted; sh \"$1\"\n")) as script:
            os.chmod(script.name, 0o755)
        self.run_workflow(config, "--cluster", self.path("submit"), "--jobs", "2",
                          "--group-components", "runs=3", "--latency-wait", "1")
        self.assertEqual(len(self.records()), 5)
        self.assertEqual(len(self.text("submitted")), 2)

    def test_it_runs_the_study(self):
        config = {"files": ["meshes/knot1.off", "stress:caps:amount=1e-9"],
                  "commands": ["study --arithmetic double", "study --arithmetic exact", "delaunay"]}
        self.assertEqual(self.run_workflow(config), 5)
        with open(self.path("results/study.jsonl"), encoding="utf-8") as file:
            found = {(line["mesh"], line["arithmetic"]) for line in map(json.loads, file)}
        self.assertEqual(found, {(mesh, a) for mesh in ("knot1.off", "stress:caps:amount=1e-9")
                                 for a in ("double", "exact")})
        self.assertIn("Arithmetics of Delaunay flips", self.text("results/study.html"))

    def test_all_of_the_data_set(self):
        config = {"files": [MESHES], "commands": ["delaunay", "refine --min-angle 30"]}
        self.run_workflow(config)
        ends = {}
        for (command, _), record in self.records().items():
            count = ends.setdefault(command, {})
            count[record["status"]] = count.get(record["status"], 0) + 1
        for command, count in ends.items():
            self.assertEqual(set(count), {"done"}, (command, count))
            self.assertGreater(count["done"], 130)


if __name__ == "__main__":
    main()
