#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the search box of the manual: what doc/make_text_index.py lists of small pages and of the
manual that was generated, and, where there is a node, what doc/search.js finds there.

    test_text_index.py --html FOLDER
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

DOC = pathlib.Path(__file__).resolve().parent.parent / "doc"
sys.path.insert(0, str(DOC))
import make_text_index  # noqa: E402
import python_pages  # noqa: E402

PAGE = """<html><body><div class="header"><div class="title">Curves<br/> </div></div>
<div class="contents"><div class="toc"><ul><li>not this</li></ul></div>
<p>Straight &amp; short.<img src="a.png"> <code>flip()</code></p>
<h1><a class="anchor" id="loops"></a>
Closed ones</h1><p>They end<div class="ttc"><div>nor this</div></div> too.</p></div><p>nor that</p>
</body></html>"""
DATA = """<?xml version="1.0"?><add>
<doc><field name="type">page</field><field name="name">c</field><field name="url">c.html</field>
  <field name="keywords"></field><field name="text">all in one</field></doc>
<doc><field name="type">function</field>
  <field name="name">CGAL::Intrinsic_triangulations::A::add_loop</field>
  <field name="url">a.html#b</field><field name="keywords">x</field>
  <field name="text">adds a loop</field></doc>
<doc><field name="type">enumvalue</field><field name="name">A::b</field>
  <field name="url">a.html#c</field></doc>
<doc><field name="type">dir</field><field name="name">include</field>
  <field name="url">d.html</field></doc></add>"""
MEMBERS = """<div class="textblock">A class.</div><a id="b"></a><h2>no heading</h2>
<div class="memitem"><div class="memproto">no types</div><div class="memdoc">
<p>Adds a <a id="x"></a>loop (2002).</p></div></div>"""
SOURCE = """# Curves
<a id="c"></a>
<!-- found by: Geodesic curve, Heat_method_3 -->
"""
# Words, and a page of the manual that is among the first five with them.
QUERIES = {"loop": "geodesic_curves.html", "poisson": "operators.html",
           "heat method": "page_distance.html", "signed distance": "page_distance.html"}


class Index(unittest.TestCase):
    folder = None

    def test_pages_are_listed_by_section_and_names_by_name(self):
        with tempfile.TemporaryDirectory() as directory:
            folder = pathlib.Path(directory)
            (folder / "c.html").write_text(PAGE, encoding="utf-8")
            (folder / "data.xml").write_text(DATA, encoding="utf-8")
            (folder / "a.html").write_text(MEMBERS, encoding="utf-8")
            (folder / "curves.md").write_text(SOURCE, encoding="utf-8")
            found = sorted(make_text_index.entries(folder / "data.xml", folder, folder))
            self.assertEqual([["function", "A::add_loop()", "a.html#b", "Adds a loop (2002).", []],
                              ["manual", "Curves", "c.html", "Straight & short. flip()",
                               ["geodesic curve", "heat method 3"]],
                              ["manual", "Curves: Closed ones", "c.html#loops", "They end too.",
                               []]], found)

    def index(self):
        if self.folder is None:
            self.skipTest("no --html")
        text = (self.folder / "text_index.js").read_text(encoding="utf-8")
        return json.loads(text.removeprefix("var textIndex = ").rstrip().removesuffix(";"))

    def test_pages_have_the_words_that_users_look_for(self):
        index = self.index()
        for query, page in QUERIES.items():
            found = {entry[2].split("#")[0] for entry in index
                     if all(word in (entry[1] + " " + entry[3]).lower() for word in query.split())}
            self.assertIn(page, found, query)

    def test_the_page_about_it_is_among_the_first(self):
        index, node = self.index(), shutil.which("node") or shutil.which("nodejs")
        if node is None:
            self.skipTest("no node")
        program = ("const read = require('fs').readFileSync(0, 'utf8');"
                   "const {index, queries} = JSON.parse(read);"
                   f"const {{ findTexts }} = require({json.dumps(str(DOC / 'search.js'))});"
                   "console.log(JSON.stringify(queries.map(query => findTexts(index, query))))")
        declared = [(words, e) for e in index for words in e[4]]
        self.assertGreater(len(declared), 100)
        first = [words for words, _ in declared]
        queries = [*QUERIES, "", "qqq", "Gluing", *first]
        output = subprocess.run([node, "-e", program], capture_output=True, text=True, check=True,
                                input=json.dumps({"index": index, "queries": queries})).stdout
        found = json.loads(output)
        for (words, entry), entries in zip(declared, found[-len(first):]):
            self.assertEqual(entry[2], entries[0][2], words)
        *found, nothing, unknown, name = found[:-len(first)]
        for query, page, entries in zip(QUERIES, QUERIES.values(), found):
            guide = dict.fromkeys(e[2].split("#")[0] for e in entries if e[0] == "manual")
            self.assertIn(page, list(guide)[:5], query)
        self.assertEqual(([], []), (nothing, unknown))
        self.assertEqual("Gluing", name[0][1])

    def test_each_function_of_the_module_has_a_page(self):
        titles = {entry[1] for entry in self.index() if entry[0] == "Python"}
        module = DOC.parent / "python" / "intrinsic"
        names = python_pages.parsed(module)
        for name in python_pages.members(names["Surface"], names):
            self.assertTrue({f"Python: {name}", f"Python: {name}()"} & titles, name)
        self.assertIn("Python: read()", titles)
        self.assertTrue(any("neighbors" in e[3] for e in self.index() if e[1] == "Python: points()"))

    def test_texts_are_whole(self):
        texts = " ".join(entry[3] for entry in self.index())
        self.assertTrue("Xue and Ye 2002)" in texts)
        self.assertFalse("2 0 0 2" in texts)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--html", type=pathlib.Path)
    options, others = parser.parse_known_args()
    Index.folder = options.html
    unittest.main(argv=[sys.argv[0], *others])
