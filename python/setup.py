# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the compiled part with CMake, or takes it from a build directory that has it.

The environment variable INTRINSIC_TRIANGULATIONS_BUILD_DIR names such a directory: nothing is
compiled then but what is missing there.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, find_packages, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent.parent


class Build(build_ext):
    """Calls CMake."""

    def build_extension(self, ext):
        build = os.environ.get("INTRINSIC_TRIANGULATIONS_BUILD_DIR")
        if build is None:
            build = os.path.join(os.path.abspath(self.build_temp), "cmake")
            subprocess.run(["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                            f"-DPython_EXECUTABLE={sys.executable}",
                            "-DINTRINSIC_TRIANGULATIONS_BUILD_PYTHON=ON",
                            "-DINTRINSIC_TRIANGULATIONS_BUILD_TESTS=OFF",
                            "-DINTRINSIC_TRIANGULATIONS_BUILD_EXAMPLES=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "python_module", "--parallel",
                        str(os.cpu_count())], check=True)
        built = next(Path(build, "python", "intrinsic").glob("_core*.so"))
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)


project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8").split("project(")[1]
version = re.search(r"VERSION ([0-9.]+)", project)
setup(version=version[1], packages=find_packages(include=["intrinsic*"]),
      ext_modules=[Extension("intrinsic._core", [])], cmdclass={"build_ext": Build})
