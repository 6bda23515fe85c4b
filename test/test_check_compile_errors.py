#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of check_compile_errors.py."""

import unittest

from check_compile_errors import complaints

SOURCE = """\
#include "header.h"
namespace case_call {
// error: no matching function
void misuse() { f(1); }
} // namespace case_call

namespace case_template {
// error at once: pass a mesh
void misuse() { g(1); }
} // namespace case_template
"""
CALL = """\
case.cpp: In function 'void case_call::misuse()':
case.cpp:4:17: error: no matching function for call to 'f(int)'
In file included from case.cpp:1:
header.h:2:6: note: candidate: 'void f()'
"""
TEMPLATE = """\
In file included from case.cpp:1:
header.h: In instantiation of 'void g(T)':
case.cpp:9:17:   required from here
header.h:5:17: error: static assertion failed: pass a mesh
header.h:6:3: error: 'begin' was not declared in this scope
"""
CLANG = """\
case.cpp:4:17: error: no matching function for call to 'f'
header.h:2:6: note: candidate function not viable
In file included from case.cpp:1:
header.h:5:17: error: static_assert failed "pass a mesh"
case.cpp:9:17: note: in instantiation of function template specialization 'g<int>' requested here
2 errors generated.
"""
BUILD = "FAILED: case.cpp.o\n/usr/bin/c++ -o case.cpp.o -c case.cpp\n"


class Compile_errors(unittest.TestCase):
    def found(self, output, source=SOURCE):
        return [error.splitlines()[0] for error in complaints(source, "case.cpp", output)]

    def test_cases_that_fail_as_they_must_are_good(self):
        for output in (CALL + TEMPLATE, TEMPLATE + CALL, BUILD + CALL + TEMPLATE, CLANG):
            self.assertEqual(self.found(output), [])

    def test_case_that_compiles_is_named(self):
        self.assertEqual(self.found(CALL), ["case template compiles, it must not"])
        self.assertEqual(self.found(BUILD + TEMPLATE), ["case call compiles, it must not"])
        self.assertEqual(len(self.found("")), 2)

    def test_case_without_its_message_is_named(self):
        for output in ((CALL + TEMPLATE).replace("no matching", "two"),
                       (CALL + TEMPLATE).replace("header.h:5", "a\n" * 5 + "header.h:5")):
            error, = self.found(output)
            self.assertRegex(error, "case (call|template) fails without a message that matches")

    def test_message_of_another_case_does_not_count(self):
        self.assertEqual(len(self.found(CALL.replace("'f(", "'f pass a mesh (")
                                        + TEMPLATE.replace("pass a", "take a"))), 1)

    def test_errors_before_all_cases_are_found(self):
        self.assertEqual(self.found("header.h:1:1: error: no type\n" + CALL + TEMPLATE),
                         ["an error belongs to no case:"])

    def test_source_without_cases_is_refused(self):
        self.assertEqual(self.found(CALL, "void f();\n"),
                         ["case.cpp has no cases", "an error belongs to no case:"])
        with self.assertRaises(ValueError):
            self.found(CALL, SOURCE.replace("error:", "says:"))


if __name__ == "__main__":
    unittest.main()
