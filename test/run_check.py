# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts that check the headers share: their option, and their exit code."""

import argparse
import pathlib
import sys

INCLUDE = pathlib.Path(__file__).resolve().parent.parent / "include"


def run(check, text):
    """Prints what `check(include)` yields, and exits with 1 if there is anything."""
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    parser.add_argument("--include", type=pathlib.Path, default=INCLUDE,
                        help="directory of the headers; default: that of this project")
    errors = list(check(parser.parse_args().include))
    for error in errors:
        print(error, file=sys.stderr)
    sys.exit(1 if errors else 0)
