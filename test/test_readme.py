#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the blocks of README that are there to be copied.

    test_readme.py --build DIRECTORY            # what they run, with what a build directory has
    test_readme.py --build DIRECTORY --whole    # all of them as they are pasted, in a copy of the
                                                # repository whose build directory is that one
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FENCE = re.compile(r"^### From (the terminal|Python|C\+\+)\n\n```sh\n(.*?)^```$",
                   re.MULTILINE | re.DOTALL)


def blocks():
    """The blocks, by their headings."""
    return dict(FENCE.findall((ROOT / "README.md").read_text(encoding="utf-8")))


def here_documents(block):
    """What a block gives to programs or writes to files, in its order."""
    return re.findall(r"<<'END'\n(.*?)^END$", block, re.MULTILINE | re.DOTALL)


class Blocks(unittest.TestCase):
    build = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_in(self, folder, command, text=None, **environment):
        """What a command writes, which must end well."""
        done = subprocess.run(command, cwd=folder, input=text, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env={**os.environ, **environment})
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout


class Parts(Blocks):
    def test_the_three_are_there(self):
        self.assertEqual(sorted(blocks()), ["C++", "Python", "the terminal"])

    def test_commands_write_what_they_name(self):
        (self.folder / "examples").symlink_to(ROOT / "examples")
        commands = re.findall(r"^intrinsic .*", blocks()["the terminal"], re.MULTILINE)
        self.run_in(self.folder, ["bash", "-e"], "\n".join(commands),
                    PATH=f"{self.build / 'bin'}:{os.environ['PATH']}")
        self.assertTrue((self.folder / "part.ply").exists())
        self.assertTrue((self.folder / "part.html").exists())

    def test_python_says_two_surfaces(self):
        said = self.run_in(ROOT, [sys.executable, "-B", "-"], here_documents(blocks()["Python"])[0],
                           PYTHONPATH=str(self.build / "python"))
        self.assertEqual(said.count("<intrinsic.Surface"), 2, said)


class Whole(Blocks):
    def setUp(self):
        super().setUp()
        def made(folder, names):  # what is no source: build directories are at the root
            at_root = Path(folder) == ROOT
            return {n for n in names if n in ("__pycache__", ".git") or n.endswith(".egg-info")
                    or at_root and (n == "results" or n.startswith("build"))}

        shutil.copytree(ROOT, self.folder / "copy", ignore=made)
        self.copy = self.folder / "copy"
        (self.copy / "build").mkdir()
        (self.copy / "build" / "release").symlink_to(self.build)

    def test_blocks_as_they_are_pasted(self):
        ends = {"the terminal": "part.html", "Python": "build/env/bin/intrinsic",
                "C++": "build/my_program/build/my_program"}
        for name, block in blocks().items():
            with self.subTest(name):
                self.run_in(self.copy, ["bash", "-e", "-c", block], "",
                            INTRINSIC_TRIANGULATIONS_BUILD_DIR=str(self.build))
                self.assertTrue((self.copy / ends[name]).exists())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--whole", action="store_true")
    options = parser.parse_args()
    Blocks.build = options.build.resolve()
    unittest.main(argv=[sys.argv[0], "Whole" if options.whole else "Parts"], verbosity=2)


if __name__ == "__main__":
    main()
