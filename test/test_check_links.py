#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of check_links.py: each test is a small folder of pages with one link that is wrong, or none."""

import pathlib
import tempfile
import unittest

import check_links


class Links(unittest.TestCase):
    def errors(self, kind, texts):
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory).resolve()
            for name, text in texts.items():
                file = root / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            return list(check_links.Checker(check_links.files_below(root, kind, ("other",)), kind, root).errors())

    def html(self, body, **others):
        return self.errors(check_links.Html, {"page.html": body, **{f"{k}.html": v for k, v in others.items()}})

    def markdown(self, text, **others):
        return self.errors(check_links.Markdown, {"page.md": text, **{f"{k}.md": v for k, v in others.items()}})

    def assert_one(self, errors, *words):
        self.assertEqual(1, len(errors), errors)
        for word in words:
            self.assertIn(word, errors[0])

    def test_pages_anchors_and_sites_that_exist_are_right(self):
        self.assertEqual([], self.html(
            '<a href="next.html#here">x</a><a href="#top" id="top">y</a><a href="https://doc.cgal.org/latest/">z</a>'
            '<a href="javascript:void(0)">s</a>', next='<a name="here"></a>'))

    def test_a_page_that_is_missing(self):
        self.assert_one(self.html('<a href="gone.html">x</a>'), "page.html: gone.html", "no such file")

    def test_an_image_and_a_script_that_are_missing(self):
        self.assertEqual(2, len(self.html('<img src="a.png"/><script src="b.js"></script>')))

    def test_an_anchor_that_is_missing_here_or_elsewhere(self):
        self.assert_one(self.html('<a href="#gone">x</a>'), "no such anchor")
        self.assert_one(self.html('<a href="next.html#gone">x</a>', next=""), "no such anchor")

    def test_code_that_a_git_host_does_not_show(self):
        self.assert_one(self.markdown("\\snippet a.cpp part\n"), "git host", "check_snippets.py")
        self.assert_one(self.markdown("[gone.cpp: part](gone.cpp)\n"), "no such file")
        self.assertEqual([], self.markdown("    \\snippet a.cpp part\n`\\snippet`\n"))

    def test_a_link_without_target(self):
        self.assert_one(self.html('<a href="">x</a>'), "empty")

    def test_sites_must_have_well_formed_addresses(self):
        self.assert_one(self.html('<a href="https://doc.cgal">x</a>'.replace(".cgal", "")), "not the name of a host")
        self.assert_one(self.html('<a href="https://doc.cgal.org/a b">x</a>'), "characters")

    def test_pages_named_by_scripts(self):
        data = {"page.html": '<p id="a"></p>', "tree.js": 'var t = [["A", "page.html#a"], ["B", "gone.html"]];',
                "search/all.js": "['../page.html#b']"}
        self.assertEqual(2, len(self.errors(check_links.Html, data)))

    def test_folders_of_others_are_left_out(self):
        self.assertEqual([], self.errors(check_links.Html, {"page.html": "", "other/x.html": '<a href="gone">x</a>'}))

    def test_files_folders_and_headings_that_exist_are_right(self):
        self.assertEqual([], self.markdown(
            "# Some `code` here\n[a](next.md) [b](#some-code-here) [c](next.md#two-words) [d](.)",
            next="## Two words"))

    def test_a_file_and_a_heading_that_are_missing(self):
        self.assert_one(self.markdown("[x](gone.md)"), "no such file")
        self.assert_one(self.markdown("![x](gone.png)"), "no such file")
        self.assert_one(self.markdown("# One\n[x](#two)"), "no such anchor")

    def test_links_lead_to_files_of_the_repository(self):
        self.assert_one(self.markdown("[x](../other.md)"), "leads out")

    def test_code_has_no_links(self):
        self.assertEqual([], self.markdown("`[x](gone.md)`\n\n```\n[x](gone.md)\n```\n\n    [x](gone.md)\n"))


if __name__ == "__main__":
    unittest.main()
