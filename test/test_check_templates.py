#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of check_templates.py."""

import unittest

import check_templates
import run_check

HEADER = """\
#define MACRO(x) template <class x>
namespace CGAL {{

{}

}} // namespace CGAL
"""


class Templates(unittest.TestCase):
    def found(self, text):
        return list(check_templates.unconstrained(HEADER.format(text)))

    def test_bare_class_is_found(self):
        self.assertEqual(self.found("/// does.\ntemplate <class T, int n>\nvoid f(T);"), ["f: T"])
        self.assertEqual(self.found("/*!\nholds.\n*/\ntemplate <typename T = int>\nclass C {\n};"),
                         ["C: T"])

    def test_concepts_and_requires_clauses_constrain(self):
        for text in ["template <std::integral T>\nvoid f(T);",
                     "template <class T>\n  requires std::integral<T>\nvoid f(T);",
                     "template <class T>\nvoid f(T) requires requires(T t) { t + t; }\n{}",
                     "template <class T>\nconcept C = requires(T t) {\n  { t + t };\n};"]:
            self.assertEqual(self.found("/// does.\n" + text), [], text)

    def test_what_is_not_for_users_needs_none(self):
        for text in ["// does.\ntemplate <class T>\nvoid f(T);",
                     "namespace internal {\n/// does.\ntemplate <class T>\nvoid f(T);\n}",
                     "/// holds.\nclass C {\n  /// does.\n  template <class T>\n  void f(T);\n};",
                     "/// \\tparam T any type\ntemplate <class T>\nvoid f(T);",
                     "/// holds.\ntemplate <class T>\nclass C<std::vector<T>> {};"]:
            self.assertEqual(self.found(text), [], text)

    def test_this_project_has_no_more_than_those_allowed(self):
        self.assertEqual(list(check_templates.check(run_check.INCLUDE)), [])


if __name__ == "__main__":
    unittest.main()
