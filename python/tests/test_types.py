# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Examples and the Python in the manual have no error of types: `mypy --strict` passes."""

import doctest
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import intrinsic as it

ROOT = Path(__file__).resolve().parents[2]
MANUAL = ROOT / "doc" / "Intrinsic_triangulations"
PAGES = [*sorted(MANUAL.glob("python*.md")), MANUAL / "coming_from.md", MANUAL / "learning.md",
         ROOT / "README.md"]
# What pages take for granted.
GIVEN = """
from concurrent.futures import ProcessPoolExecutor
from typing import Any
import numpy as np
from numpy.typing import NDArray
import intrinsic as it
V: NDArray[np.float64]
F: NDArray[np.int64]
P: NDArray[np.float64]
u: NDArray[np.float64]
direction: NDArray[np.float64]
length: float
points: list[it.Point]
source: int
files: list[str]
s: it.Surface
"""


def code_of(page):
    """Returns the Python of a page: what it quotes as such, and what it shows at a prompt."""
    text = page.read_text(encoding="utf-8")
    text = re.sub(r"^\[\w+\.py: [^]]*\]\([^)]*\)\n\n```py\n.*?^```$", "", text,
                  flags=re.DOTALL | re.MULTILINE)  # what is quoted is in an example
    code = [example.source for example in doctest.DocTestParser().get_examples(text)]
    for block in re.findall(r"^```py(?:thon)?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        if ">>>" not in block:
            code.append(block)
    for block in re.findall(r"(?<=\n\n)(?: {4}.*\n)+", text):
        if re.match(r" {4}[\w, ]+ = \w+\.", block):
            code.append(re.sub("^    ", "", block, flags=re.MULTILINE))
    return "".join(code)


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Makes a cache: the types of numpy are read once, which takes longer than all else."""
        cls.cache = cls.enterClassContext(tempfile.TemporaryDirectory())

    def mypy(self, *files):
        run = subprocess.run(
            [sys.executable, "-m", "mypy", "--config-file", "mypy.ini", "--cache-dir", self.cache,
             *map(str, files)], capture_output=True, text=True,
            cwd=Path(__file__).resolve().parent,
            env=os.environ | {"MYPYPATH": str(Path(it.__file__).resolve().parents[1])})
        return run.stdout + run.stderr

    def test_examples_and_pages(self):
        with tempfile.TemporaryDirectory() as directory:
            files = sorted((ROOT / "examples" / "python").glob("*.py"))
            for page in PAGES:
                code = code_of(page)
                if code:
                    files.append(Path(directory) / f"{page.stem}_page.py")
                    files[-1].write_text(GIVEN + code, encoding="utf-8")
            self.assertGreater(len(files), 12)
            said = self.mypy(*files)
        self.assertIn(f"Success: no issues found in {len(files)} source files", said)

    def test_mistakes_are_found(self):
        with tempfile.TemporaryDirectory() as directory:
            file = Path(directory) / "wrong.py"
            file.write_text("import intrinsic as it\n"
                            "s = it.Surface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])\n"
                            "s.distance(0, method='heta')\n"
                            "s.distance(0, targets=1).shape\n"
                            "s.parametrize('conformal').uv\n")
            said = self.mypy(file)
        self.assertEqual(re.findall(r"wrong.py:(\d): error", said), ["3", "4", "5"], said)


if __name__ == "__main__":
    unittest.main()
