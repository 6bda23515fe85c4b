#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Says which pages of the manual break its rules: pages are short but for code, the lists of pages name them, and they
name the course that they cite."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "doc" / "Intrinsic_triangulations"
# doc/CMakeLists.txt takes pages and their order from these.
LISTS = ("user_manual", "command_line", "index")
MOST_WORDS = 2400
# Looked up, not read.
LONG = ("measurements",)
CODE = re.compile(r"^```cpp$.*?^```$", re.MULTILINE | re.DOTALL)
TITLE = "Geometry Processing with Intrinsic Triangulations"


def defects(name, text, listed):
    """What is wrong with a page."""
    if len(CODE.sub("", text).split()) > MOST_WORDS and name not in LONG:
        yield f"has more than {MOST_WORDS} words: split it by task"
    if name not in listed:
        yield "is linked by none of " + ", ".join(LISTS)
    cited = re.search(r"\bcourse\b|§ ?\d", text)
    title = re.search(TITLE.replace(" ", r"\s+"), text)
    if cited and (title is None or title.start() > cited.end() + 60):
        yield f"cites the course before it gives its title, {TITLE}"


def main():
    listed = {*LISTS, "README"}
    for page in LISTS:
        listed.update(re.findall(r"\(([a-z_]+)\.md#", (FOLDER / f"{page}.md").read_text(encoding="utf-8")))
    pages = {page.stem: page for page in sorted(FOLDER.glob("*.md"))}
    pages["README"] = ROOT / "README.md"
    errors = [f"{page.relative_to(ROOT)} {defect}" for name, page in pages.items()
              for defect in defects(name, page.read_text(encoding="utf-8"), listed)]
    print(*errors, f"{len(pages)} pages, {len(errors)} defects", sep="\n")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
