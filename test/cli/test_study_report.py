# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that `workflow/study/report.py` makes of lines of results, written by hand here."""

import json
import os
import random
import re
import xml.etree.ElementTree
from html.parser import HTMLParser

from cli_support import REPORT, REPORT_PYTHON, Cli_test, Run, main


def line(mesh, arithmetic, status="done", seconds=1.0, **more):
    family = mesh.split(":")[1] if mesh.startswith("stress:") else "files"
    found = {"mesh": mesh, "family": family, "arithmetic": arithmetic, "status": status}
    if status == "done":
        found.update(vertices=102, faces=200, flips=30, checks=400, refused_flips=0,
                     non_delaunay_edges=0, cycles=0, area_drift=0.0, result="0123456789abcdef",
                     comparison="complete", seconds={"build": seconds / 4, "flip": 3 * seconds / 4},
                     peak_rss_mib=9.0)
    found.update(limits={"seconds": 60.0, "mib": 4096}, **more)
    return found


LINES = [
    line("b.off", "double", seconds=1.0, flips=37, cycles=4),
    line("b.off", "double-1e-5", seconds=1.0, non_delaunay_edges=11, flips=19, result="f" * 16),
    line("b.off", "core-expr", "timed_out", message="60 s"),
    line("b.off", "exact", seconds=1.5, filter_failures=1234567, integer=3,
         escalations={"128": 1000, "256": 21}, certified_zero=7),
    line("b.off", "exact-integer", seconds=6.0),
    line("a<&>.off", "double", seconds=2.0),
    line("a<&>.off", "double-1e-5", seconds=2.0),
    line("a<&>.off", "core-expr", "crashed", message="signal <11>"),
    line("a<&>.off", "exact", seconds=3.0),
    line("a<&>.off", "exact-integer", seconds=6.0, result="1" * 16),
    *(line(f"stress:caps:amount=1e-{k}", "double-1e-5", non_delaunay_edges=k) for k in (1, 5, 9)),
    *(line(f"stress:caps:amount=1e-{k}", a, seconds=1e-3) for k in (1, 5, 9)
      for a in ("double", "exact", "exact-integer")),
]


class Page(HTMLParser):
    """Texts of a page, of list items, and of table cells by row."""

    def __init__(self, source):
        super().__init__()
        self.tags, self.attributes, self.rows, self.items = [], [], [], []
        self._open = []
        self.feed(source)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += attributes
        self._open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag == "li":
            self.items.append("")

    def handle_endtag(self, tag):
        while self._open and self._open.pop() != tag:
            pass

    def handle_data(self, data):
        if self._open and self._open[-1] in ("td", "th"):
            self.rows[-1][-1] += data
        if self._open and self._open[-1] == "li":
            self.items[-1] += data


class Study_report(Cli_test):
    pages = {}

    def report(self, lines, *more_files):
        """The page of lines, and of files if any; made once for all tests."""
        text = "".join(json.dumps(x) + "\n" for x in lines)
        if more_files or text not in self.pages:
            self.write("lines.jsonl", text)
            run = self.make_report("lines.jsonl", *more_files, "-o", "r.html")
            self.assertEqual((run.code, run.out, run.err), (0, "", ""))
            with open(self.path("r.html"), encoding="utf-8") as file:
                page = file.read()
            if more_files:
                return page
            self.pages[text] = page
        return self.pages[text]

    def table(self, page, first_column, *columns):
        """The cells of a row by name of columns, of the first table that has these columns."""
        for i, head in enumerate(page.rows):
            if all(c in head for c in columns):
                for row in page.rows[i + 1:]:
                    if row[0] == first_column:
                        return dict(zip(head, row))
        self.fail(f"no table with {columns} and {first_column}")

    def test_page_needs_nothing_else(self):
        source = self.report(LINES)
        page = Page(source)
        self.assertNotIn("script", page.tags)
        identifiers = [value for name, value in page.attributes if name == "id"]
        self.assertEqual(len(set(identifiers)), len(identifiers))
        for name, value in page.attributes:
            self.assertNotEqual(name, "src")
            if name.endswith("href"):  # markers, defined once
                self.assertIn(value, ["#" + i for i in identifiers])
            self.assertNotIn("http", value or "")
        self.assertNotIn("url(", source)
        self.assertNotIn("@import", source)

    def test_plots_are_well_formed(self):
        plots = self.report(LINES).split("<svg")[1:]
        titles = []
        for plot in plots:
            svg = xml.etree.ElementTree.fromstring("<svg" + plot.split("</svg>")[0] + "</svg>")
            titles.append(svg.get("aria-label"))
            _, _, width, height = map(float, svg.get("viewBox").split())
            drawn = [(use.get("x"), use.get("y")) for use in svg.iter("use")]
            for definitions in list(svg.iter("defs")):
                definitions.clear()  # relative to where they are used
            for path in svg.iter("path"):
                self.assertIsNone(path.get("transform"))
                drawn += re.findall(r"[ML] (\S+) (\S+)", path.get("d", ""))
            self.assertGreater(len(drawn), 10)
            for x, y in drawn:
                self.assertTrue(0 <= float(x) <= width and 0 <= float(y) <= height, (x, y))
        self.assertEqual(len(titles), 4)
        self.assertIn("stress:caps: edges that are not Delaunay", titles)

    def test_order_does_not_matter(self):
        lines = list(LINES)
        random.Random(1).shuffle(lines)
        self.assertEqual(self.report(lines), self.report(LINES))

    def test_script_makes_the_same_page(self):
        """Other tests run it in a process that has loaded it."""
        page = self.report(LINES)
        self.write("lines.jsonl", "".join(json.dumps(x) + "\n" for x in LINES))
        run = Run(REPORT_PYTHON, [REPORT, "lines.jsonl", "-o", "page.html"], self.directory)
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        with open(self.path("page.html"), encoding="utf-8") as file:
            self.assertEqual(file.read(), page)

    def test_files_are_merged_and_the_last_line_counts(self):
        page = self.report(LINES)
        old = [line("b.off", "exact", "timed_out"), line("b.off", "double", flips=99)]
        self.write("more.jsonl", "".join(json.dumps(x) + "\n" for x in LINES))
        self.assertEqual(self.report(old, "more.jsonl"), page)

    def test_ends_are_counted(self):
        page = Page(self.report(LINES))
        core = self.table(page, "core-expr", "jobs", "done", "timed out", "crashed")
        self.assertEqual([core[k] for k in ("jobs", "done", "timed out", "crashed")],
                         ["2", "0", "1", "1"])
        exact = self.table(page, "exact", "jobs", "done", "timed out")
        self.assertEqual([exact[k] for k in ("jobs", "done", "timed out")], ["5", "5", "0"])

    def test_times_are_compared_where_all_have_finished(self):
        # 1 + 2 + 0.003 s; 1.5 + 3 + 0.003; 12.003
        page = Page(self.report(LINES))
        for arithmetic, ratio in (("double", "1.00"), ("exact", "1.50"), ("exact-integer", "4.00"),
                                  ("core-expr", "\u2013")):
            row = self.table(page, arithmetic, "time on common (s)", "ratio to double")
            self.assertEqual(row["ratio to double"], ratio)

    def test_harm_is_named(self):
        page = Page(self.report(LINES))
        items = "\n".join(page.items)
        self.assertIn("double-1e-5 leaves 26 edges that are not Delaunay in 4 meshes, "
                      "11 of them in b.off.", items)
        self.assertIn("double makes 7 flips more than exact in 1 mesh, 7 of them in b.off.", items)
        self.assertIn("core-expr does not finish 2 of 2 meshes", items)
        tolerance = self.table(page, "double-1e-5", "edges not Delaunay", "same result as exact")
        self.assertEqual(tolerance["edges not Delaunay"], "26")
        self.assertEqual(tolerance["in so many meshes"], "4")
        self.assertEqual(tolerance["same result as exact"], "4 of 5")
        row = self.table(page, "b.off", "mesh", "double", "double-1e-5")
        self.assertEqual((row["double"], row["double-1e-5"]), ("0", "11"))
        self.assertNotIn("", [c for row in page.rows for c in row])  # a blank would say nothing

    def test_agreement_of_exact_arithmetics(self):
        page = Page(self.report(LINES))
        self.assertIn("exact and exact-integer have the same result on 4 of 5 meshes.", page.items)
        self.assertIn("They differ on a<&>.off.", page.items)

    def test_escalations(self):
        page = Page(self.report(LINES))
        row = self.table(page, "exact", "filter failures", "128 bits", "256 bits")
        self.assertEqual([row[k] for k in ("filter failures", "integers", "128 bits", "256 bits",
                                           "zero, proven")], ["1,234,567", "3", "1,000", "21", "7"])

    def test_no_cell_is_blank(self):
        refused = line("c.off", "exact", "refused_input")  # without a message
        page = Page(self.report(LINES + [refused]))
        self.assertEqual([row for row in page.rows if "" in row], [])

    def test_bars_of_no_height_say_0_and_unknown_ones_a_dash(self):
        lines = [line("b.off", "exact", integer=3, escalations={"128": 1000}, certified_zero=0)]
        svg = self.report(lines).split("<svg")[-1]
        labels = [text.strip() for text in re.findall(r"<text[^>]*>([^<]*)</text>", svg)]
        for label in ("3", "1,000", "0", "\u2013"):  # integers, 128 bits, proven zeros, probable ones
            self.assertIn(label, labels)

    def test_what_did_not_finish_is_named(self):
        source = self.report(LINES)
        self.assertNotIn("a<&>", source)
        self.assertNotIn("<11>", source)
        page = Page(source)
        row = self.table(page, "b.off", "mesh", "core-expr", "exact")
        self.assertEqual((row["core-expr"], row["exact"]), ("timed out", "1.5 s"))
        self.assertIn(["a<&>.off", "core-expr", "crashed", "signal <11>"], page.rows)

    def test_version_and_machine_are_named(self):
        self.assertIn("Program: intrinsic unknown. Machine: unknown.", self.report(LINES))
        lines = [line("a.off", "exact", version="0.1.0", machine="a <fast> one"),
                 line("b.off", "exact", version="0.1.0", machine="a slow one")]
        self.assertIn("Program: intrinsic 0.1.0. Machine: a &lt;fast&gt; one; a slow one.",
                      self.report(lines))

    def test_points_say_what_they_are(self):
        svg = self.report(LINES).split("<svg")[1].split("</svg>")[0]
        svg = xml.etree.ElementTree.fromstring("<svg" + svg + "</svg>")
        titles = [use.find("title").text for use in svg.iter("use") if use.find("title") is not None]
        timed = [f"{x['mesh']}, {x['arithmetic']}" + ("" if "seconds" in x else ", not finished")
                 for x in LINES if x["status"] in ("done", "timed_out") and
                 (x["mesh"] == "b.off" or "seconds" in x)]
        self.assertEqual(sorted(titles), sorted(timed))

    def test_what_is_no_result_is_named(self):
        good = json.dumps(line("a.off", "exact"))
        for name, text, *words in (("no.jsonl", None), ("empty.jsonl", "", "no results"),
                                   ("bad.jsonl", good + "\n{\"mesh\": 1}\n", "line 2"),
                                   ("text.jsonl", "text\n", "line 1")):
            if text is not None:
                self.write(name, text)
            self.assert_fails(self.make_report(name, "-o", "r.html"), name, *words)
        self.write("good.jsonl", good + "\n" + good[:20])  # the last line is not complete
        self.assertEqual(self.make_report("good.jsonl", "-o", "r.html").code, 0)
        self.assert_fails(self.make_report("good.jsonl", "-o", "none/r.html"), "none/r.html")
        for arguments in ([], ["good.jsonl"], ["good.jsonl", "-o", "r.txt"]):
            self.assertEqual(self.make_report(*arguments).code, 2)
        self.assertEqual(sorted(os.listdir(self.directory)),
                         ["bad.jsonl", "empty.jsonl", "good.jsonl", "r.html", "text.jsonl"])

    def test_few_lines_are_enough(self):
        self.assertIn("1 mesh, 1 arithmetic, 1 job", self.report([line("a.off", "exact")]))
        self.report([line("a.off", "gmpq", "not_applicable")])
        self.report([line("a.off", "a new one", "crashed")])


if __name__ == "__main__":
    main()
