#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of check_rooms.py: each test is a small tree of files with one thing wrong."""

import pathlib
import tempfile
import unittest
import unittest.mock

import check_rooms

OWNER = "CGAL/Intrinsic_triangulation.h"
SOURCES = "../src/" + check_rooms.PACKAGES[0]
README = "# Rooms\n\n## `low/`\n\nText.\n\n## `high/inner/`\n\n## The owner: `Intrinsic_triangulation.h`\n"


def header(name, *included, lines=0, guard=None):
    guard = guard or check_rooms.expected_guard(name)
    body = "".join(f"#include <{i}>\n" for i in included) + "//\n" * lines
    return f"#ifndef {guard}\n#define {guard}\n{body}#endif\n"


def path(name, package=0):
    return f"{check_rooms.PACKAGES[package]}/{name}"


class Rooms(unittest.TestCase):
    def setUp(self):
        for name in ("ALLOWED_INCLUDES", "ALLOWED_LENGTHS", "ALLOWED_SIZES", "ALLOWED_COLUMNS",
                     "ALLOWED_INTERNALS"):
            patch = unittest.mock.patch.object(check_rooms, name, {})
            patch.start()
            self.addCleanup(patch.stop)

    def errors(self, changes=None, readme=README):
        files = {path("low/a.h"): (), path("high/inner/b.h"): (path("low/a.h"),),
                 OWNER: (path("high/inner/b.h"),)}
        texts = {name: header(name, *included) for name, included in files.items()}
        texts.update(changes or {})
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory, "include")
            root.mkdir()
            readmes = {f"{package}/README.md": "" for package in check_rooms.PACKAGES}
            for name, text in {**readmes, path("README.md"): readme, **texts}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(check_rooms.check(root))

    def assert_one_error(self, expected, *arguments):
        errors = self.errors(*arguments)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(expected, errors[0])

    def test_a_good_tree_has_no_errors(self):
        self.assertEqual(self.errors(), [])

    def test_a_header_of_a_lower_room_must_not_include_one_of_a_higher(self):
        name = path("low/c.h")
        self.assert_one_error("of a higher room", {name: header(name, path("high/inner/b.h"))})
        self.assert_one_error("of a higher room", {name: header(name, OWNER)})

    def test_a_header_of_a_lower_package_must_not_include_one_of_a_higher(self):
        low, high = path("low/c.h"), path("room/d.h", package=1)
        rooms = {path("README.md", package=1): "## `room/`\n"}
        self.assert_one_error("of a higher room", {**rooms, low: header(low, high), high: header(high)})
        self.assertEqual(self.errors({**rooms, low: header(low), high: header(high, low)}), [])

    def test_an_exception_is_heeded_and_reported_once_it_is_not_needed(self):
        name = path("low/c.h")
        pair = ("Intrinsic_triangulations/low/c.h", "Intrinsic_triangulations/high/inner/b.h")
        with unittest.mock.patch.object(check_rooms, "ALLOWED_INCLUDES", {pair: "reason"}):
            self.assertEqual(self.errors({name: header(name, path("high/inner/b.h"))}), [])
            self.assert_one_error("not needed any more")

    def test_tests_name_nothing_internal_but_by_an_exception_that_is_needed(self):
        name = "../test/room/test_a.cpp"
        for text in ("using CGAL::IT::internal::f;\n", "namespace hidden = IT::internal;\n",
                     "using namespace IT::internal;\n", "namespace IT::internal {\n",
                     "testing::internal::CaptureStdout();\n"):
            self.assert_one_error("test/room/test_a.cpp names something", {name: text})
        public = {name: "internal_only::f(); // internal edges\n"}
        self.assertEqual(self.errors(public), [])
        with unittest.mock.patch.object(check_rooms, "ALLOWED_INTERNALS", {"room/test_a.cpp": "reason"}):
            self.assertEqual(self.errors({name: "IT::internal::f();\n"}), [])
            self.assert_one_error("not needed any more", public)

    def test_headers_of_a_room_must_not_include_each_other_in_a_circle(self):
        one, two = path("low/c.h"), path("low/d.h")
        self.assert_one_error("in a circle: {0}c.h -> {0}d.h -> {0}c.h".format("Intrinsic_triangulations/low/"),
                              {one: header(one, two), two: header(two, one)})

    def test_every_header_lies_in_a_room_and_every_room_has_headers(self):
        for name in (path("other/c.h"), path("high/c.h"), "CGAL/Stray.h"):
            self.assert_one_error("lies in no room", {name: header(name)})
        self.assert_one_error("has no headers", {}, README + "## `empty/`\n")
        self.assert_one_error("does not exist", {}, README + "## `Missing.h`\n")

    def test_rooms_and_headers_must_not_be_too_large(self):
        many = {path(f"low/c{i}.h"): header(path(f"low/c{i}.h")) for i in range(15)}
        self.assert_one_error("has 16 headers", many)
        name = path("low/c.h")
        self.assert_one_error("351 lines", {name: header(name, lines=348)})
        self.assertEqual(self.errors({name: header(name, lines=347)}), [])

    def test_an_include_guard_is_the_path(self):
        name = path("low/c.h")
        self.assert_one_error("needs the include guard CGAL_INTRINSIC_TRIANGULATIONS_LOW_C_H",
                              {name: header(name, guard="C_H")})

    def test_own_headers_are_included_by_their_full_path(self):
        name = path("low/c.h")
        self.assert_one_error("not the full path", {name: header(name, path("low/missing.h"))})
        quoted = header(name).replace("#endif", '#include "a.h"\n#endif')
        self.assert_one_error("not the full path", {name: quoted})

    def test_a_page_is_included_by_its_full_path(self):
        name, page = path("low/c.h"), path("low/page.html")
        self.assert_one_error("not the full path", {name: header(name, page)})
        self.assertEqual(self.errors({name: header(name, page), f"../src/{page}": 'R"(text)"\n'}), [])

    def test_lines_must_not_be_too_long(self):
        name = path("low/c.h")
        text = header(name) + "//" + "x" * 99 + "\n"
        self.assert_one_error("more than 100 columns: 4", {name: text})
        with unittest.mock.patch.object(check_rooms, "ALLOWED_COLUMNS", {check_rooms.short(name): "reason"}):
            self.assertEqual(self.errors({name: text}), [])
            self.assert_one_error("not needed any more")

    def test_sources_are_listed_in_their_order(self):
        one, two = (f"{SOURCES}/{name}" for name in ("high/inner/b.cpp", "low/a.cpp"))
        include = [f"#include <{check_rooms.PACKAGES[0]}/{name}>\n" for name in ("high/inner/b.cpp", "low/a.cpp")]
        files, listing = {one: "", two: ""}, f"{SOURCES}_sources.h"
        self.assertEqual(self.errors({**files, listing: "".join(include)}), [])
        self.assert_one_error("does not include", {**files, listing: include[0]})
        self.assert_one_error("no source of the package", {one: "", listing: "".join(include)})
        self.assert_one_error("in their order", {**files, listing: "".join(reversed(include))})

    def test_sources_keep_to_rooms(self):
        listing = f"{SOURCES}_sources.h"
        for source, included, expected in (("low/a.cpp", "high/inner/b.h", "of a higher room"),
                                           ("other/c.cpp", "low/a.h", "lies in no room")):
            texts = {f"{SOURCES}/{source}": f"#include <{path(included)}>\n", listing: f"#include <{path(source)}>\n"}
            self.assert_one_error(expected, texts)

    def test_headers_that_only_sources_need_keep_to_rooms(self):
        name, source, listing = path("low/c.h"), f"{SOURCES}/low/a.cpp", f"{SOURCES}_sources.h"
        texts = {source: f"#include <{name}>\n", listing: f"#include <{path('low/a.cpp')}>\n"}
        self.assertEqual(self.errors({**texts, f"../src/{name}": header(name)}), [])
        self.assert_one_error("of a higher room", {**texts, f"../src/{name}": header(name, path("high/inner/b.h"))})

    def test_the_program_keeps_to_rooms_and_sizes(self):
        program, module, python = (f"../{folder}" for folder in (
            check_rooms.PROGRAM, check_rooms.MODULE, check_rooms.PYTHON))
        good = {f"{program}/README.md": "## `support/`\n## The first program: `./`\n## `late/`\n",
                f"{program}/support/a.h": "", f"{program}/b.cpp": '#include "support/a.h"\n',
                f"{program}/late/c.h": '#include "../support/a.h"\n', f"{module}/d.h": "",
                f"{module}/e.cpp": '#include "d.h"\n'}
        self.assertEqual(self.errors(good), [])
        for name, text, expected in (
                (f"{program}/b.cpp", '#include "late/c.h"\n', "of a higher room"),
                (f"{program}/support/a.h", '#include "../late/c.h"\n', "of a higher room"),
                (f"{program}/b.cpp", '#include "none.h"\n', "does not exist"),
                (f"{program}/other/f.cpp", "", "lies in no room"),
                (f"{program}/b.cpp", "//\n" * 351, "has 351 lines"),
                (f"{module}/e.cpp", "//\n" * 351, "has 351 lines"),
                (f"{python}/_f.py", "#\n" * 351, "has 351 lines"),
                (f"{python}/compat/_f.py", "#" + "x" * 100 + "\n", "more than 100 columns"),
                (f"{module}/d.h", "//" + "x" * 99 + "\n", "more than 100 columns"),
                (f"{module}/d.h", "IT::internal::Sheets s;\n", "names `internal::`"),
                (f"{program}/b.cpp", "internal::f();\n", "names `internal::`"),
                (f"{module}/e.cpp", '#include "../../src/intrinsic/late/c.h"\n', "never needs the program")):
            with self.subTest(name=name, expected=expected):
                self.assert_one_error(expected, {**good, name: text})
        self.assertEqual(self.errors({**good, f"{program}/b.cpp": "//\n" * 350}), [])

    def test_a_room_must_not_be_named_twice(self):
        with self.assertRaises(ValueError):
            self.errors({}, README + "## `low/`\n")


if __name__ == "__main__":
    unittest.main()
