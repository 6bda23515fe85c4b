# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `cmake --install` puts below a prefix is the whole package."""

import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import intrinsic
import program
from support import With_folder

CODE = """
import intrinsic as it
from intrinsic.compat import potpourri3d, pygeodesic, robust_laplacian
s = it.Surface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
print(it.__file__, s.mass().sum(), it.__version__)
"""


def version(cache):
    """The version of the project, as CMake has it."""
    return re.search(r"CMAKE_PROJECT_VERSION:STATIC=(\S+)", cache.read_text())[1]


@unittest.skipUnless(shutil.which("cmake") and (program.BUILD / "CMakeCache.txt").exists(),
                     "this is not a build tree")
class Installed(With_folder):
    def test_it_imports_and_has_all_files(self):
        subprocess.run(["cmake", "--install", program.BUILD, "--prefix", self.folder,
                        "--component", "Intrinsic_triangulations_Python"], check=True,
                       capture_output=True)
        package = next(self.folder.glob("**/intrinsic/__init__.py")).parent
        done = subprocess.run([sys.executable, "-B", "-c", CODE], check=True, text=True,
                              capture_output=True, cwd=self.folder,
                              env={**os.environ, "PYTHONPATH": str(package.parent)})
        self.assertEqual(done.stdout.split(), [str(package / "__init__.py"), "0.5",
                                               version(program.BUILD / "CMakeCache.txt")])
        built = Path(intrinsic.__file__).parent

        def files(folder):
            return sorted(p.relative_to(folder) for p in folder.rglob("*")
                          if p.is_file() and p.suffix != ".pyc")

        self.assertEqual(files(package), files(built))


if __name__ == "__main__":
    unittest.main()
