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
        """Runs mypy once: the types of numpy take it longer than all else."""
        directory = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.files = sorted((ROOT / "examples" / "python").glob("*.py"))
        for page in PAGES:
            code = code_of(page)
            if code:
                cls.files.append(directory / f"{page.stem}_page.py")
                cls.files[-1].write_text(GIVEN + code, encoding="utf-8")
        wrong = directory / "wrong.py"
        wrong.write_text("import intrinsic as it\n"
                         "s = it.Surface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])\n"
                         "s.distance(0, method='heta')\n"
                         "s.distance(0, targets=1).shape\n"
                         "s.parametrize('conformal').uv\n", encoding="utf-8")
        run = subprocess.run(
            [sys.executable, "-m", "mypy", "--config-file", "mypy.ini", "--cache-dir", os.devnull,
             *map(str, cls.files), str(wrong)], capture_output=True, text=True,
            cwd=Path(__file__).resolve().parent,
            env=os.environ | {"MYPYPATH": str(Path(it.__file__).resolve().parents[1])})
        cls.said = run.stdout + run.stderr

    def test_examples_and_pages(self):
        self.assertGreater(len(self.files), 12)
        self.assertIn(f"in 1 file (checked {len(self.files) + 1} source files)", self.said)

    def test_mistakes_are_found(self):
        errors = re.findall(r"^(.*):(\d+): error", self.said, re.MULTILINE)
        self.assertEqual([(Path(file).name, line) for file, line in errors],
                         [("wrong.py", k) for k in "345"], self.said)


if __name__ == "__main__":
    unittest.main()
