#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists the public classes and functions by topic, with their headers, from the comments in the headers.

    list_members.py            # says whether doc/members.md is what they say now
    list_members.py --write    # writes it
"""

import argparse
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "doc" / "members.md"
INCLUDE = ROOT / "include" / "CGAL"
HEAD = """\
# Classes and functions by topic

The names that programs use, for readers without doxygen. `doc/list_members.py` makes this page from
the comments in the headers, and a test checks that it is up to date. All names are in the namespace
`CGAL::Intrinsic_triangulations`. Names marked with * are in the header of their package:
`CGAL/Intrinsic_triangulations.h`, `CGAL/Intrinsic_geodesics.h`, `CGAL/Intrinsic_operators.h`,
`CGAL/Intrinsic_conformal.h` or `CGAL/Intrinsic_simplification.h`. The links lead to the headers, which describe parameters, results and costs. The
[user manual](Intrinsic_triangulations/user_manual.md) says what to use for which task.
"""
PACKAGES = ("Intrinsic_triangulations", "Intrinsic_geodesics", "Intrinsic_operators", "Intrinsic_conformal",
            "Intrinsic_simplification")
GROUPS = ROOT / "doc" / "Intrinsic_triangulations" / "groups.h"
# The lines of a topic that name its headers, and the name of the topic.
GROUP = re.compile(r"((?:^// Headers: .*\n)+)/\*!\n\\defgroup (\w+)", re.MULTILINE)
TOPIC = re.compile(r"\\defgroup (\w+) ([^\n]+)\n\\ingroup page_reference\n\\brief (.*?)(?=\n\n|\n\*/)", re.DOTALL)
INTERNAL = re.compile(r"^(namespace (?:CGAL::Intrinsic_triangulations::)?internal) \{$.*?^\} // \1$", re.MULTILINE | re.DOTALL)
# A comment of an entity in a namespace: others are indented. What follows is its declaration.
ENTITY = re.compile(r"^(?:/\*!\n\\brief (.*?)\*/\n|((?:/// [^\n]*\n)+))(?!#|$)", re.MULTILINE | re.DOTALL)
CLOSED = {"<": ">", "(": ")", "{": "}"}
TYPE = re.compile(r"^(?:class|struct|enum class|concept|using)\s+(\w+)", re.MULTILINE)
INCLUDED = re.compile(r"#include <CGAL/([\w/.]+)>")


def after_brackets(text):
    """What follows the bracket that a text begins with, and all in it."""
    depth = 0
    for i, letter in enumerate(text):
        depth += (letter == text[0]) - (letter == CLOSED[text[0]] and text[i - 1] != "-")
        if not depth:
            return text[i + 1:].lstrip()
    return ""


def without_template(text):
    """A declaration without template parameters and their requirements."""
    if text.startswith("template"):
        text = after_brackets(text.removeprefix("template").lstrip())
    while found := re.match(r"requires\b\s*|[|&]{2}\s*", text):
        text = re.sub(r"^!?[\w:]*\s*", "", text[found.end():])
        while text[:1] in CLOSED:
            text = after_brackets(text)
    return text


def without_brackets(text):
    """A declaration without what is between < and >, template parameters above all."""
    text = text.replace("operator<", "operator").replace("->", "")
    while (shorter := re.sub(r"<[^<>]*>", "", text)) != text:
        text = shorter
    return text


def name_of(declaration):
    """The name of a class, or of a function with (), or None."""
    bare = without_brackets(declaration)
    if found := TYPE.search(re.sub(r"\[\[.*?\]\]", "", bare)):
        return found[1]
    found = re.search(r"(\w+)\s*\(", bare)
    return f"{found[1]}()" if found else None


def brief(comment):
    """The sentence that a comment begins with, as text."""
    comment = comment.removeprefix("\\brief ")
    text = re.split(r"\n\s*\n|\n\\(?!it|ref|f\$)|\s\\complexity", comment)[0]
    text = re.sub(r"\\it([cf])\{(\w+)\}", lambda m: f"`{m[2]}{'()' if m[1] == 'f' else ''}`", text)
    text = re.sub(r'\\ref (?:::)?(\w+)(?: "([^"]*)")?', lambda m: m[2] or m[1], text)
    return " ".join(text.replace("\\f$", "").replace("|", "\\|").split())


def topics():
    """The topics that programs use, in their order: their names, titles and briefs."""
    text = GROUPS.read_text(encoding="utf-8")
    return [(name, title, " ".join(text.split())) for name, title, text in TOPIC.findall(text)
            if not title.startswith("Inside") and name != "ref_concepts"]


def short_path(header):
    return header.relative_to(INCLUDE).as_posix().removeprefix("Intrinsic_triangulations/")


def groups_of_names():
    """The topic of each folder and header that groups.h names."""
    result = {name: topic for names, topic in GROUP.findall(GROUPS.read_text(encoding="utf-8"))
              for name in names.replace("// Headers:", "").split()}
    paths = [short_path(header) for header in INCLUDE.rglob("*.h")]
    if gone := [name for name in result if not any(path.startswith(name) for path in paths)]:
        sys.exit(f"doc/Intrinsic_triangulations/groups.h names no header by {', '.join(gone)}")
    return result


def topic_of(header, groups):
    path = short_path(header)
    fitting = [prefix for prefix in groups if path.startswith(prefix)]
    return groups[max(fitting, key=len)] if fitting else "ref_owner"


def members():
    """For each topic the names, headers and briefs."""
    groups = groups_of_names()
    result = collections.defaultdict(dict)
    for header in sorted(INCLUDE.rglob("*.h"), key=lambda h: h.name.lower()):
        topic = topic_of(header, groups)
        text = INTERNAL.sub("", header.read_text(encoding="utf-8"))
        for found in ENTITY.finditer(text):
            long, short = found.groups("")
            declaration = re.split("[{;]", without_template(text[found.end():]), maxsplit=1)[0]
            if "\\cond" not in long + short and (name := name_of(declaration)):
                result[topic].setdefault((name, header), brief(long or short.replace("/// ", "")))
    return result


def included_by(path, known):
    """The headers that a header includes, with those that they include, but for `*_impl.h`."""
    header = INCLUDE / path
    if path not in known and not path.endswith("_impl.h") and header.exists():
        known.add(path)
        for other in INCLUDED.findall(header.read_text(encoding="utf-8")):
            included_by(other, known)
    return known


def page():
    lines, found = [HEAD], members()
    umbrella = set()
    for package in PACKAGES:
        included_by(f"{package}.h", umbrella)
    for topic, title, text in topics():
        lines += [f"## {title}", f'<a id="{topic}"></a>', "", text, "", "| name | header | |", "|---|---|---|"]
        for (name, header), says in sorted(found[topic].items(), key=lambda m: (m[0][0].lower(), m[0][1])):
            path = header.relative_to(INCLUDE).as_posix()
            mark = " *" if path in umbrella else ""
            short = path.removeprefix("Intrinsic_triangulations/")
            lines.append(f"| `{name}` | [{short}](../include/CGAL/{path}){mark} | {says} |")
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    text = page()
    if parser.parse_args().write:
        PAGE.write_text(text, encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != text:
        print("doc/members.md is not what the headers say: run doc/list_members.py --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
