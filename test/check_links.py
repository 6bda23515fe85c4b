#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Says which links lead nowhere, without a network.

    check_links.py                 # links in the .md files of the repository, as a git host shows them; and commands
                                   # and labels of doxygen's, which a git host shows as they are
                                   # written
    check_links.py --html FOLDER   # those of generated pages: files, images, scripts, anchors; trees and search
"""

import argparse
import functools
import html.parser
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXTERNAL = ("http", "https", "mailto")
DYNAMIC = ("javascript", "data", "about")
# Pages that a script of doxygen's names: trees at the side, results of searches.
SCRIPT_LINK = re.compile(r"""["']((?:\.\./)?[\w.-]+\.html(?:#[\w-]*)?)["']""")
HOST = re.compile(r"(?=.{4,253}$)([a-z0-9]([a-z0-9-]*[a-z0-9])?\.)+[a-z]{2,}(:\d+)?$", re.IGNORECASE)
FENCE = re.compile(r"^(```|~~~).*?^\1[^\S\n]*$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"(`+).*?\1", re.DOTALL)
INDENTED = re.compile(r"(?<=\n\n)((?: {4}|\t).*\n)+")
MARKDOWN_LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]*)>?(?:\s+\"[^\"]*\")?\s*\)")
MARKDOWN_REFERENCE = re.compile(r"^\[[^\]]+\]:\s*(\S+)", re.MULTILINE)
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$", re.MULTILINE)
LABEL = re.compile(r"^<a id=\"([\w-]+)\"></a>$", re.MULTILINE)
# what a git host shows as it is written, and what doc/page_text.awk makes it of
DOXYGEN = re.compile(r"^\\snippet .*|\\(?:ref|itf|itc|subpage|page)\b(?:\{[^}]*\}|\s[\w:]+)|\\f[$\[{]|^\[TOC\]$|\{#[\w-]+\}", re.MULTILINE)


def url_defect(url):
    """Why a link to another site is not well formed, or None."""
    parts = urllib.parse.urlsplit(url)
    if parts.scheme == "mailto":
        return None if re.fullmatch(r"[^@\s]+@[^@\s]+\.[^@\s]+", parts.path) else "not an address"
    if re.search(r"[\s<>\"{}|\\^`]", url):
        return "has characters that a URL cannot have"
    return None if HOST.match(parts.netloc) else f"'{parts.netloc}' is not the name of a host"


class Page(html.parser.HTMLParser):
    """The links and the anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("href", "src", "data") and value is not None:
                self.links.append(value)
            elif name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)

    handle_startendtag = handle_starttag


class Html:
    """Pages that were generated, and the data of the scripts in them."""
    suffixes = (".html", ".js")

    @staticmethod
    def read(file, text):
        if file.suffix == ".js":
            return SCRIPT_LINK.findall(text), set()
        page = Page(text)
        return page.links, page.anchors


class Markdown:
    """Files as a git host shows them: headings are anchors, code has no links."""
    suffixes = (".md",)

    @staticmethod
    def read(_, text):
        text = FENCE.sub("", text)
        anchors = set()
        for heading in HEADING.findall(text):
            heading = CODE.sub(lambda code: code.group(0).strip("`"), heading)
            base = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
            number = 0
            while (anchor := f"{base}-{number}" if number else base) in anchors:
                number += 1
            anchors.add(anchor)
        text = CODE.sub("", INDENTED.sub("", text))
        anchors.update(LABEL.findall(text))
        links = MARKDOWN_LINK.findall(text) + MARKDOWN_REFERENCE.findall(text)
        return links + DOXYGEN.findall(text), anchors


class Checker:
    def __init__(self, files, kind, root):
        self.pages = {file: kind.read(file, file.read_text(encoding="utf-8")) for file in files}
        self.root = root

    @functools.cache  # pages name the same files again and again
    def target(self, folder, path):
        """The file that a path in a folder names, and why there is none, or None."""
        if path.startswith("/"):
            folder, path = self.root, path.lstrip("/")
        target = (folder / path).resolve()
        if not target.is_relative_to(self.root):
            return target, "leads out of the folder"
        return target, None if target.exists() else "no such file"

    def defect(self, file, link):
        """Why a link of a file leads nowhere, or None."""
        if DOXYGEN.match(link):
            return "not understood by a git host: see test/check_snippets.py for code, doc/page_text.awk for links"
        parts = urllib.parse.urlsplit(link)
        if parts.scheme in DYNAMIC:
            return None
        if parts.scheme in EXTERNAL:
            return url_defect(link)
        if parts.scheme or parts.netloc:
            return f"'{parts.scheme}:{parts.netloc}' is no known kind of link"
        target = file
        if parts.path:
            target, defect = self.target(file.parent, urllib.parse.unquote(parts.path))
            if defect:
                return defect
        elif not parts.fragment:
            return None if link == "#" else "empty"
        if parts.fragment and target in self.pages:
            if urllib.parse.unquote(parts.fragment) not in self.pages[target][1]:
                return "no such anchor"
        return None

    def errors(self):
        for file, (links, _) in sorted(self.pages.items()):
            for link in sorted(set(links)):
                if defect := self.defect(file, link):
                    yield f"{file.relative_to(self.root)}: {link or '(no target)'}: {defect}"

    def number_of_links(self):
        return sum(len(set(links)) for links, _ in self.pages.values())


def files_below(root, kind, others):
    """The files of a kind, without folders that are hidden or belong to others."""
    return [file for file in sorted(root.rglob("*")) if file.suffix in kind.suffixes
            and not any(part.startswith(".") or part in others
                        for part in file.relative_to(root).parts)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--html", metavar="FOLDER", type=pathlib.Path)
    folder = parser.parse_args().html
    kind, others = (Html, ("mathjax",)) if folder else (Markdown, ("build", "results"))
    root = folder.resolve() if folder else ROOT
    files = files_below(root, kind, others)
    checker = Checker(files, kind, root)
    errors = list(checker.errors())
    print(*errors, sep="\n" if errors else "", end="\n" if errors else "")
    print(f"{len(errors)} of {checker.number_of_links()} links in {len(files)} files lead nowhere")
    return 1 if errors or not files else 0


if __name__ == "__main__":
    sys.exit(main())
