#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the code that the manual quotes with the examples, which the tests run.

    check_snippets.py            # says which quotes differ, and which parts of examples lack one
    check_snippets.py --write    # writes the quotes

A quote is a link, `[name.cpp: part, other part](path/name.cpp)`, alone on a line, with a block of
code below it. Lines `//! [part]` in the example enclose each part; in Python, `# [part]`.
"""

import argparse
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
QUOTE = re.compile(r"^\[[a-z0-9_]+\.(?:cpp|py): ([^]]+)\]\(([^)]+)\)\n(?:\n```(?:cpp|py)\n(.*?)^```\n)?",
                   re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^ *(?://!|#) \[(.*)\]\n", re.MULTILINE)


def part_of(file, name):
    """The lines of a file between two lines with the name, without other such lines."""
    mark = rf"^ *(?://!|#) \[{re.escape(name)}\]\n"
    text = file.read_text(encoding="utf-8")
    found = re.search(mark + "(.*?)" + mark, text, re.MULTILINE | re.DOTALL)
    if not found:
        raise ValueError(f"{file.relative_to(ROOT)} has no part [{name}]")
    return textwrap.dedent(MARK.sub("", found[1])).strip("\n") + "\n"


def checked(page, write, quoted):
    """Yields what is wrong with the quotes of a page, which become right with `write`; adds their
    parts to `quoted`."""
    text = page.read_text(encoding="utf-8")
    differ = []

    def with_code(quote):
        file = (page.parent / quote[2]).resolve()
        parts = quote[1].split(", ")
        quoted.update((file, part) for part in parts)
        code = "\n".join(part_of(file, part) for part in parts)
        if quote[3] != code:
            differ.append(quote[0].splitlines()[0])
        return f"{quote[0].splitlines()[0]}\n\n```{file.suffix[1:]}\n{code}```\n"

    right = QUOTE.sub(with_code, text)
    if write and differ:
        page.write_text(right, encoding="utf-8")
    elif differ:
        yield from (f"{page.relative_to(ROOT)}: {quote} is not what the example says: "
                    "run test/check_snippets.py --write" for quote in differ)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    write = parser.parse_args().write
    quoted = set()
    errors = [error for page in sorted((ROOT / "doc" / "Intrinsic_triangulations").glob("*.md"))
              for error in checked(page, write, quoted)]
    for file in sorted(file for folder in ("examples", "src/intrinsic")
                       for file in (ROOT / folder).rglob("*") if file.suffix in (".cpp", ".py")):
        for part in sorted(set(MARK.findall(file.read_text(encoding="utf-8")))):
            if (file, part) not in quoted:
                errors.append(f"{file.relative_to(ROOT)}: nothing quotes [{part}]")
    print(*errors, f"{len(quoted)} parts of examples are quoted, {len(errors)} defects", sep="\n")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
