#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles a source all of whose cases must be refused, each with its message.

A case is a namespace `case_NAME` with a comment `// error: REGEX` or `// error at once: REGEX`. All
cases are compiled together, and each must have an error of its own in which REGEX is found; `at
once` in its first five lines, those not counted that say by which headers a header was included.
"""

import dataclasses
import os
import pathlib
import re
import subprocess
import sys

CASE = re.compile(r"^namespace case_(\w+) \{\n(.*?)^\} // namespace case_",
                  re.MULTILINE | re.DOTALL)
EXPECTED = re.compile(r"^// error( at once)?: (.+)$", re.MULTILINE)
INCLUDED = re.compile(r"(In file included| +) from ")
CONTEXT = re.compile(r"In file included from |\S+: (In|At) ")
MESSAGE = re.compile(r": ((fatal )?error|warning|note): ")
ERROR = re.compile(r": (fatal )?error: ")


@dataclasses.dataclass
class Case:
    name: str
    lines: range
    at_once: bool
    expected: str
    said: str = ""  # by the compiler


def read_cases(text):
    cases = []
    for found in CASE.finditer(text):
        expected = EXPECTED.search(found[2])
        if not expected:
            raise ValueError(f"case {found[1]} has no line `// error: REGEX`")
        first = text.count("\n", 0, found.start()) + 1
        lines = range(first, first + found[0].count("\n") + 1)
        cases.append(Case(found[1], lines, bool(expected[1]), expected[2]))
    return cases


def messages(output):
    """Yields the messages of the compiler with the lines of context around them. g++ says before
    a message where a template is instantiated, clang after it. What the build says comes first."""
    message, complete = "", True
    for line in output.splitlines(keepends=True):
        if complete and (ERROR.search(line) or CONTEXT.match(line)):
            yield message
            message, complete = "", False
        message += line
        complete = complete or bool(MESSAGE.search(line))
    yield message


def distribute(cases, name, output):
    """Gives messages to the cases whose lines they name; what names none, as a compiler does that
    goes on about the same template, to the case before. Returns errors before the first case."""
    case, others = None, []
    for message in messages(output):
        named = [int(line) for text in message.splitlines() if not INCLUDED.match(text)
                 for line in re.findall(rf"{re.escape(name)}:(\d+):", text)]
        case = next((c for c in cases if any(line in c.lines for line in named)), case)
        if case:
            case.said += message
        elif ERROR.search(message):
            others.append(message)
    return others


def complaints(text, name, output):
    """Yields what is wrong with the output of a compiler for source `name` of contents `text`."""
    cases = read_cases(text)
    if not cases:
        yield f"{name} has no cases"
    for error in distribute(cases, name, output):
        yield f"an error belongs to no case:\n{error}"
    for case in cases:
        lines = [line for line in case.said.splitlines() if not INCLUDED.match(line)]
        said = "\n".join(lines[:5] if case.at_once else lines)
        if not ERROR.search(case.said):
            yield f"case {case.name} compiles, it must not"
        elif not re.search(case.expected, said):
            yield f"case {case.name} fails without a message that matches {case.expected}:\n{said}"


def main():
    source, *command = sys.argv[1:]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                         env=os.environ | {"LC_ALL": "C"})  # plain ASCII quotes in messages
    path = pathlib.Path(source)
    errors = list(complaints(path.read_text(encoding="utf-8"), path.name, run.stdout))
    if errors:
        print(run.stdout, *errors, sep="\n")
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
