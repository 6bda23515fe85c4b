# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of setuptools that build what is compiled, with CMake: see pyproject.toml.

The environment variable INTRINSIC_TRIANGULATIONS_BUILD_DIR names a build directory that exists:
then only what is missing there is compiled.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension
from setuptools.command.build_ext import build_ext

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ["intrinsic", "intrinsic-applications", "intrinsic-study"]
VERSION = re.search(r"project\([^)]*VERSION ([0-9.]+)",
                    (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


class Wheel(bdist_wheel):
    """Says that something is compiled, and leaves out files of earlier builds."""

    def initialize_options(self):
        super().initialize_options()
        self.distribution.ext_modules = [Extension("intrinsic._core", [])]

    def run(self):
        shutil.rmtree(self.get_finalized_command("build").build_lib, ignore_errors=True)
        super().run()


class Build(build_ext):
    """Builds the module and the programs, and puts them into the package."""

    def build_extension(self, ext):
        build = os.environ.get("INTRINSIC_TRIANGULATIONS_BUILD_DIR")
        if build is None:
            build = os.path.join(os.path.abspath(self.build_temp), "cmake")
            subprocess.run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", build,
                            "-DCMAKE_BUILD_TYPE=Release",
                            f"-DPython_EXECUTABLE={sys.executable}",
                            "-DINTRINSIC_TRIANGULATIONS_BUILD_PYTHON=ON",
                            "-DINTRINSIC_TRIANGULATIONS_BUILD_TESTS=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--parallel", str(os.cpu_count()), "--target",
                        "python_module", *PROGRAMS], check=True)
        module = Path(self.get_ext_fullpath(ext.name))
        programs = module.parent / "programs"
        programs.mkdir(parents=True, exist_ok=True)
        shutil.copy(next(Path(build, "python", "intrinsic").glob("_core*.so")), module)
        for name in PROGRAMS:
            shutil.copy(Path(build, "bin", name), programs)
        for file in [module, *programs.iterdir()]:
            subprocess.run(["strip", "--strip-unneeded", file], check=True)
