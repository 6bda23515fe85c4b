#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program compiles that links the library: no polygon triangulation, no arithmetic beyond
rationals, no source, and none of the algorithms that the library has. Seconds depend on the
machine; these do not."""

import argparse
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLAGS = ["-std=c++20", "-frounding-math", "-DCGAL_USE_GMP=1", "-DCGAL_USE_MPFR=1",
         f"-I{ROOT / 'include'}", f"-I{ROOT / 'src'}", "-isystem", "/usr/include/eigen3"]
COMPILED = "-DCGAL_INTRINSIC_TRIANGULATIONS_COMPILED=1"
HEAVY = re.compile(r"(CGAL/(Triangulation_2|Constrained_\w+|Filtered_kernel|Lazy_\w+|Mpzf)\.h"
                   r"|c\+\+/\d+/(ranges|mutex|regex|future|filesystem)|boost/multiprecision/\w+\.hpp)$")
PACKAGES = ("triangulations", "geodesics", "operators", "conformal", "simplification")
PROGRAM = """
#include <CGAL/Intrinsic_triangulations.h>
namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::parameters;
int main() {
  IT::Corresponding_triangulation t(IT::read_triangle_soup("mesh.off"));
  IT::flip_to_delaunay(t);
  IT::delaunay_refine(t);
  IT::flip_to_delaunay(t, maximum_number(99));
  IT::delaunay_refine(
      t, minimum_angle(25).maximum_edge_length(1).maximum_insertions(9).conforming(true));
  return IT::common_subdivision(t).number_of_faces() > 0;
}
"""
ALGORITHMS = ("common_subdivision", "read_triangle_soup", "Delaunay_refiner<", "Refinement_moves<",
              "Delaunay_flipper<", "Mover<", "Exact_ladder::", "Integer_coordinates::before")
# With named numbers the program instantiates what passes them on, without them nothing.
WITH_NUMBERS = {"flip_to_delaunay": "tags::maximum_number",
                "delaunay_refine": "tags::minimum_angle"}
compiler = os.environ.get("CXX", "g++")


def run(arguments, source):
    return subprocess.run([compiler, *FLAGS, *arguments, "-x", "c++", "-"], input=source, text=True,
                          capture_output=True, check=True)


def headers_of(headers, *arguments):
    """Returns the headers that a program with some of them includes."""
    source = "".join(f"#include <{header}>\n" for header in headers)
    return run([*arguments, "-M", "-MG"], source).stdout.replace("\\\n", " ").split()


class LightHeaders(unittest.TestCase):
    def test_with_the_library_nothing_heavy_is_included(self):
        headers = headers_of([f"CGAL/Intrinsic_{package}.h" for package in PACKAGES], COMPILED)
        self.assertEqual([h for h in headers if HEAVY.search(h) or "/src/CGAL/" in h], [])

    def test_cmath_is_read_once(self):
        """The guard of <cmath> does not surround it all: g++ reads 1,900 lines at each inclusion."""
        for folder in (ROOT / "include", ROOT / "src/CGAL"):
            found = [str(path) for path in sorted(folder.rglob("*.*"))
                     if path.suffix in (".h", ".cpp") and "#include <cmath>" in path.read_text()]
            self.assertEqual([path for path in found if not path.endswith("support/cmath.h")], [])

    def test_without_it_all_is(self):
        self.assertTrue(any(HEAVY.search(h)
                            for h in headers_of(["CGAL/Intrinsic_triangulations_sources.h"])))

    def test_the_library_has_what_most_programs_do(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "program.o"
            run([COMPILED, "-O1", "-c", "-o", str(out)], PROGRAM)
            symbols = subprocess.run(["nm", "-C", str(out)], text=True, capture_output=True,
                                     check=True).stdout
        defined = [line for line in symbols.splitlines()
                   if re.search(r" [TtWV] ", line) and "~" not in line]
        self.assertTrue(any(re.search(r" T main$", line) for line in defined))
        for name in ALGORITHMS:
            self.assertEqual([line for line in defined if name in line], [], name)
        for name, number in WITH_NUMBERS.items():
            self.assertEqual([line for line in defined if name in line and number not in line], [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", default=compiler)
    arguments, rest = parser.parse_known_args()
    compiler = arguments.compiler
    unittest.main(argv=[__file__, *rest])
