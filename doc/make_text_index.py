#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the search box of the manual finds: the texts of all pages and names, as a script.

    make_text_index.py searchdata.xml FOLDER    # writes FOLDER/text_index.js

Doxygen lists names and their comments in searchdata.xml for search engines. Its pages are one entry
each there, so their sections are read from the generated pages in FOLDER. An entry is
[kind, title, address, text]; search.js looks entries up.
"""

import argparse
import html.parser
import json
import pathlib
import re
import xml.etree.ElementTree

NAMESPACE = "CGAL::Intrinsic_triangulations::"
# Entries without a text of their own.
LEFT_OUT = ("dir", "namespace", "source")
KINDS = {"page": "manual", "group": "topic", "file": "header", "struct": "class"}
LICENCE = re.compile(r"// Copyright.*\n// SPDX.*\n")
EMPTY = {"area", "base", "br", "col", "hr", "img", "input", "link", "meta", "param", "wbr"}


class Sections(html.parser.HTMLParser):
    """The sections of a page: [anchor, title, text], the first without an anchor."""
    skipped = {"toc", "ttc"}

    def __init__(self, text):
        super().__init__()
        self.title, self.sections = "", [["", "", ""]]
        self.open, self.in_title, self.in_contents, self.skips, self.heading = [], 0, 0, 0, 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag in EMPTY:
            return
        attrs = dict(attrs)
        classes = set((attrs.get("class") or "").split())
        self.open.append((tag, self.in_title, self.in_contents, self.skips, self.heading))
        self.in_title |= "title" in classes
        self.in_contents |= "contents" in classes
        self.skips |= bool(classes & self.skipped)
        if self.in_contents and not self.skips and re.fullmatch("h[1-4]", tag):
            self.heading = 1
            self.sections.append(["", "", ""])
        elif self.heading and attrs.get("id"):
            self.sections[-1][0] = attrs["id"]

    def handle_endtag(self, tag):
        if tag not in (entry[0] for entry in self.open):
            return
        while True:
            name, *state = self.open.pop()
            self.in_title, self.in_contents, self.skips, self.heading = state
            if name == tag:
                return

    def handle_data(self, data):
        if self.in_title:
            self.title += data
        elif self.in_contents and not self.skips:
            self.sections[-1][1 if self.heading else 2] += data


def words(text):
    return re.sub(r"\s+", " ", LICENCE.sub("", text)).strip()


def page_entries(kind, address, text):
    page = Sections(text)
    title = words(page.title)
    for anchor, heading, body in page.sections:
        name = f"{title}: {words(heading)}" if heading else title
        yield [kind, name, f"{address}#{anchor}" if anchor else address, words(body)]


def entries(data, folder):
    for doc in xml.etree.ElementTree.parse(data).getroot():
        field = {entry.get("name"): entry.text or "" for entry in reversed(doc.findall("field"))}
        kind, address = KINDS.get(field["type"], field["type"]), field["url"]
        # values without a text have no place on a page
        if kind in LEFT_OUT or (kind == "enumvalue" and not field.get("text")):
            continue
        if kind == "manual":
            kind = "example" if address.endswith("-example.html") else kind
            yield from page_entries(kind, address, (folder / address).read_text(encoding="utf-8"))
            continue
        is_topic = kind == "topic"
        title = field.get("keywords", "") if is_topic else field["name"].removeprefix(NAMESPACE)
        suffix = "()" if kind == "function" else ""
        yield [kind, title + suffix, address, words(field.get("text", ""))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data", metavar="searchdata.xml", type=pathlib.Path)
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path)
    options = parser.parse_args()
    found = sorted(entries(options.data, options.folder))
    lines = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in found)
    index = f"var textIndex = [\n{lines}\n];\n"
    (options.folder / "text_index.js").write_text(index, encoding="utf-8")


if __name__ == "__main__":
    main()
