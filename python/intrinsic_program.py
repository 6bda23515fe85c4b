# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `intrinsic` of an installed wheel. It lies beside the package, so that the program
starts without numpy and scipy, which the package imports."""

import os
import sys
from pathlib import Path


def main():
    """Becomes the program, which the package has."""
    program = Path(__file__).with_name("intrinsic") / "programs" / "intrinsic"
    os.execv(program, ["intrinsic", *sys.argv[1:]])
