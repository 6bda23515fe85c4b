#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the search box of the manual finds: the texts of all pages and names, as a script.

    make_text_index.py searchdata.xml FOLDER PAGES    # writes FOLDER/text_index.js

Doxygen lists names in searchdata.xml for search engines, and texts without punctuation. So texts are
read from the generated pages in FOLDER: those of manual pages by section. The Markdown of such a page,
in PAGES, has a comment `<!-- found by: words, more words -->` below its label. An entry is
[kind, title, address, text, words]; search.js looks entries up.
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
FOUND_BY = re.compile(r'#.*\n<a id="(\w+)"></a>\n<!-- found by: (.+) -->\n')
EMPTY = {"area", "base", "br", "col", "hr", "img", "input", "link", "meta", "param", "wbr"}


class Elements(html.parser.HTMLParser):
    """Reads a page. What an element changes of the attributes in `inherited` ends with it."""
    inherited = ()

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attrs):
        if tag in EMPTY:
            return
        self.open.append((tag, [getattr(self, name) for name in self.inherited]))
        attrs = dict(attrs)
        self.begin(tag, attrs, set((attrs.get("class") or "").split()))

    def handle_endtag(self, tag):
        if tag not in (entry[0] for entry in self.open):
            return
        while True:
            name, state = self.open.pop()
            for attribute, value in zip(self.inherited, state):
                setattr(self, attribute, value)
            if name == tag:
                return


class Sections(Elements):
    """The sections of a page: [anchor, title, text], the first without an anchor."""
    skipped = {"toc", "ttc"}
    inherited = ("in_title", "in_contents", "skips", "heading")

    def __init__(self, text):
        super().__init__()
        self.title, self.sections = "", [["", "", ""]]
        self.in_title, self.in_contents, self.skips, self.heading = 0, 0, 0, 0
        self.feed(text)

    def begin(self, tag, attrs, classes):
        self.in_title |= "title" in classes
        self.in_contents |= "contents" in classes
        self.skips |= bool(classes & self.skipped)
        if self.in_contents and not self.skips and re.fullmatch("h[1-4]", tag):
            self.heading = 1
            self.sections.append(["", "", ""])
        elif self.heading and attrs.get("id"):
            self.sections[-1][0] = attrs["id"]

    def handle_data(self, data):
        if self.in_title:
            self.title += data
        elif self.in_contents and not self.skips:
            self.sections[-1][1 if self.heading else 2] += data


class Comments(Elements):
    """The comments on a page by their anchors: of members, and without an anchor of a class."""
    inherited = ("into",)

    def __init__(self, text):
        super().__init__()
        self.texts, self.anchor, self.into = {}, "", None
        self.feed(text)

    def begin(self, tag, attrs, classes):
        if tag == "a" and attrs.get("id") and self.into is None:
            self.anchor = attrs["id"]
        brief = re.fullmatch(r"memdesc:(\w+)", attrs.get("class") or "")
        if "compoundTemplParams" in classes or "memTemplParams" in classes:
            self.into = None
        elif brief:
            self.into = brief[1]
        elif "memdoc" in classes: # contains what is brief, too
            self.into = self.anchor
            self.texts.pop(self.into, None)
        elif "textblock" in classes and self.into is None:
            self.into = ""

    def handle_data(self, data):
        if self.into is not None:
            self.texts[self.into] = self.texts.get(self.into, "") + data


def words(text):
    return re.sub(r"\s+", " ", LICENCE.sub("", text)).strip()


def page_entries(kind, address, text):
    page = Sections(text)
    title = words(page.title)
    for anchor, heading, body in page.sections:
        name = f"{title}: {words(heading)}" if heading else title
        yield [kind, name, f"{address}#{anchor}" if anchor else address, words(body)]


def words_of_pages(pages):
    """What each page of the manual is found by, by its address."""
    found = {}
    for page in pages.glob("*.md"):
        match = FOUND_BY.match(page.read_text(encoding="utf-8"))
        if match:
            found[match[1] + ".html"] = [" ".join(re.findall(r"[^\W_]+", phrase.lower()))
                                         for phrase in match[2].split(",")]
    return found


def entries(data, folder, pages):
    found_by, comments = words_of_pages(pages), {}

    def comment(address):
        name, _, anchor = address.partition("#")
        if name not in comments:
            page = folder / name
            comments[name] = Comments(page.read_text(encoding="utf-8")).texts if page.exists() else {}
        return words(comments[name].get(anchor, ""))

    for doc in xml.etree.ElementTree.parse(data).getroot():
        field = {entry.get("name"): entry.text or "" for entry in reversed(doc.findall("field"))}
        kind, address = KINDS.get(field["type"], field["type"]), field["url"]
        # values without a text have no place on a page
        if kind in LEFT_OUT or (kind == "enumvalue" and not field.get("text")):
            continue
        if kind == "manual":
            if address.startswith("py_"):
                kind = "Python"
            elif address.endswith("-example.html"):
                kind = "example"
            for entry in page_entries(kind, address, (folder / address).read_text(encoding="utf-8")):
                yield [*entry, found_by.get(entry[2], [])]
            continue
        is_topic = kind == "topic"
        title = field.get("keywords", "") if is_topic else field["name"].removeprefix(NAMESPACE)
        suffix = "()" if kind == "function" else ""
        text = comment(address) or words(field.get("text", ""))
        yield [kind, title + suffix, address, text, []]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data", metavar="searchdata.xml", type=pathlib.Path)
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path)
    parser.add_argument("pages", metavar="PAGES", type=pathlib.Path)
    options = parser.parse_args()
    found = sorted(entries(options.data, options.folder, options.pages))
    lines = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in found)
    index = f"var textIndex = [\n{lines}\n];\n"
    (options.folder / "text_index.js").write_text(index, encoding="utf-8")


if __name__ == "__main__":
    main()
