#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Says which pages of the manual break its rules. They are short, not counting code; the lists of
pages name them; they give the title of the course that they cite; each public concept has one; and
the files in the table of walks have the names that it says; the text of a link is on one line, as
doxygen finds no page otherwise."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "doc" / "Intrinsic_triangulations"
# doc/CMakeLists.txt takes pages and their order from these.
LISTS = ("user_manual", "command_line", "index")
WALKS = "extending.md"
MOST_WORDS = 2400
# Looked up, not read.
LONG = ("measurements",)
CODE = re.compile(r"^```cpp$.*?^```$", re.MULTILINE | re.DOTALL)
FOUND_BY = re.compile(r"^<!-- found by: .*$", re.MULTILINE) # for the search, not for readers
INTERNAL = re.compile(r"^namespace (?:\S*::)?internal \{$.*?^\} // namespace (?:\S*::)?internal$",
                      re.MULTILINE | re.DOTALL)
BROKEN_LINK = re.compile(r"\[([^\[\]\n]*\n[^\[\]\n]*)\]\([^)\n]*\)")
TITLE = "Geometry Processing with Intrinsic Triangulations"


def defects(name, text, listed):
    """What is wrong with a page."""
    if len(FOUND_BY.sub("", CODE.sub("", text)).split()) > MOST_WORDS and name not in LONG:
        yield f"has more than {MOST_WORDS} words: split it by task"
    if name not in listed:
        yield "is linked by none of " + ", ".join(LISTS)
    for link in BROKEN_LINK.findall(CODE.sub("", text)):
        yield f"the text of a link is on two lines: {' '.join(link.split())}"
    cited = re.search(r"\bcourse\b|§ ?\d", text)
    title = re.search(TITLE.replace(" ", r"\s+"), text)
    if cited and (title is None or title.start() > cited.end() + 60):
        yield f"cites the course before it gives its title, {TITLE}"


def walk_defects():
    """What the table of walks names, in a file where it is not."""
    text = (FOLDER / WALKS).read_text(encoding="utf-8")
    table = text.partition('<a id="where_things_are"></a>')[2].partition("\n## ")[0]
    walks = re.findall(r"^\| (?!what|-)(.*) \|$", table, re.MULTILINE)
    for walk in walks:
        what, *files = walk.split(" | ")
        for path, says in re.findall(r"\]\(([^)#]+)[^)]*\)([^|\]]*)", " ".join(files)):
            file = (FOLDER / path).resolve()
            words = file.read_text(encoding="utf-8") if file.exists() else ""
            for name in re.findall(r"`(\w+)(?:\(\))?`", says):
                if not re.search(rf"\b{name}\b", words):
                    yield f"{WALKS}: {what}: there is no {name} in {path}"
    if not walks:
        yield f"{WALKS} has no table of walks"


def concept_defects():
    """Which public concepts have no page of their own, or no misuse that must not compile."""
    concepts = set()
    for header in (ROOT / "include").rglob("*.h"):
        text = INTERNAL.sub("", header.read_text(encoding="utf-8"))
        concepts.update(re.findall(r"^concept (\w+)", text, re.MULTILINE))
    pages = {page.stem for page in (FOLDER / "Concepts").glob("*.h")}
    for name in sorted(concepts ^ pages):
        how = "without" if name in concepts else "no more, but has"
        yield f"{name} is a concept {how} a page in Concepts/"
    cases = (ROOT / "test" / "compile_fail" / "concepts.cpp").read_text(encoding="utf-8")
    for name in sorted(concepts - set(re.findall(r"^namespace case_(\w+)", cases, re.MULTILINE))):
        yield f"{name} is a concept without a case in test/compile_fail/concepts.cpp"


def main():
    listed = {*LISTS, "README"}
    for page in LISTS:
        text = (FOLDER / f"{page}.md").read_text(encoding="utf-8")
        listed.update(re.findall(r"\(([a-z_]+)\.md#", text))
    pages = {page.stem: page for page in sorted(FOLDER.glob("*.md"))}
    pages["README"] = ROOT / "README.md"
    errors = [f"{page.relative_to(ROOT)} {defect}" for name, page in pages.items()
              for defect in defects(name, page.read_text(encoding="utf-8"), listed)]
    errors += [*walk_defects(), *concept_defects()]
    print(*errors, f"{len(pages)} pages, {len(errors)} defects", sep="\n")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
