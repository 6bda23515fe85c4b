#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints how long every public header takes to compile alone, slowest first.

Two numbers per header: seconds to parse (-fsyntax-only) and to compile an object (-O0 -c). They are
processor times, so that other work on the machine matters little; the smallest of --repeat runs counts.
"""

import argparse
import os
import pathlib
import resource
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"
FLAGS = ["-std=c++20", "-frounding-math", "-D_USE_MATH_DEFINES", "-DCGAL_USE_MPFI=1",
         "-DCGAL_USE_GMP=1", "-DCGAL_USE_MPFR=1", "-isystem", "/usr/include/eigen3"]


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def compile_seconds(command, source, messages):
    """Returns the processor time of a compiler that reads `source`; None if it fails."""
    before = children_seconds()
    done = subprocess.run(command, input=source, text=True, capture_output=True, check=False)
    seconds = children_seconds() - before
    messages.append(done.stderr)
    return seconds if done.returncode == 0 else None


def measure(header, arguments, messages):
    """Returns the seconds to parse and to compile `header`, None where that fails."""
    source = f"#include <{header}>\n"
    base = [arguments.compiler, *FLAGS, *shlex.split(arguments.flags), f"-I{INCLUDE}", "-x", "c++", "-"]
    ways = [["-fsyntax-only"]] + ([] if arguments.parse_only else [["-O0", "-c", "-o", os.devnull]])
    best = []
    for way in ways:
        runs = [compile_seconds(base + way, source, messages) for _ in range(arguments.repeat)]
        best.append(None if None in runs else min(runs))
    return best


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("headers", nargs="*", help="such as CGAL/Intrinsic_triangulation.h; default: all")
    parser.add_argument("--compiler", default=os.environ.get("CXX", "g++"))
    parser.add_argument("--flags", default="", help="further options of the compiler")
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--parse-only", action="store_true", help="leave out the objects")
    parser.add_argument("--messages", type=pathlib.Path, help="file for what the compiler says")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    headers = arguments.headers or sorted(
        str(path.relative_to(INCLUDE)) for path in INCLUDE.rglob("*.h"))
    rows, messages = [], []
    for number, header in enumerate(headers, 1):
        if sys.stderr.isatty():
            print(f"\r{number}/{len(headers)}", end="", file=sys.stderr)
        rows.append((header, measure(header, arguments, messages)))
    if sys.stderr.isatty():
        print(file=sys.stderr)
    if arguments.messages:
        arguments.messages.write_text("".join(messages))
    rows.sort(key=lambda row: max((s for s in row[1] if s is not None), default=0), reverse=True)
    print("  parse" + ("" if arguments.parse_only else "  object") + "  header")
    for header, seconds in rows:
        columns = "".join("  fails " if s is None else f"{s:7.2f} " for s in seconds)
        print(f"{columns} {header}")
    return 1 if any(None in seconds for _, seconds in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
