# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the manual about commands name the options that the program has, and no others, and
their examples show what it writes."""

import os
import pathlib
import re
import shutil
import subprocess

from cli_support import Cli_test, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = ROOT / "doc" / "Intrinsic_triangulations"
NUMBER = re.compile(r"(?<![\w.-])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![\w.-])")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
# What every command has, and the page of a command never says.
EVERYWHERE = {"--help", "--version"}


def page(command):
    return (MANUAL / f"command_{command}.md").read_text(encoding="utf-8")


def promised(text):
    """The options of the synopsis, which comes first, and of first columns of tables."""
    synopsis = re.search(r"\n\n((?: {4}.*\n)+)", text)
    columns = re.findall(r"^\| (`.*?) \| ", text, re.MULTILINE)
    return set(OPTION.findall("\n".join([synopsis[1] if synopsis else "", *columns])))


def links(text):
    return set(re.findall(r"\(command_([a-z]+)\.md#", text)) - {"statistics"}


def shell_blocks(text):
    """The blocks of commands and output, as lists of lines."""
    for block in re.findall(r"^ {4}\$ .*\n(?: {4}.*\n)*", text, re.MULTILINE):
        yield [line[4:] for line in block.splitlines()]


def agrees(shown, line):
    """Whether a line of an example is the program's. Numbers may differ by a percent, counts by ten:
    another compiler or mathematical library may round differently."""
    return NUMBER.sub("#", shown) == NUMBER.sub("#", line) and all(
        abs(float(a) - float(b)) <= max(0.01 * abs(float(b)), 10 if a.isdigit() else 0)
        for a, b in zip(NUMBER.findall(shown), NUMBER.findall(line)))


class Manual(Cli_test):
    found = {}  # the options of each command that was asked

    def commands(self):
        text = self.run_program("--help").out.partition("Subcommands:\n")[2]
        return re.findall(r"^  ([a-z]+) ", text, re.MULTILINE)

    def options(self, command):
        if command not in Manual.found:
            text = self.run_program(command, "--help").out
            found = re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE)
            Manual.found[command] = set(found) - EVERYWHERE
        return Manual.found[command]

    def test_the_overview_lists_all_commands(self):
        overview = (MANUAL / "command_line.md").read_text(encoding="utf-8")
        self.assertEqual(self.commands(), re.findall(r"^\| \[`([a-z]+)`\]", overview, re.MULTILINE))

    def test_pages_name_all_options(self):
        for command in self.commands():
            text = page(command)
            linked = links(text)
            if "options" in linked:
                linked |= links(page("options"))
            named = set(OPTION.findall("\n".join([text, *map(page, linked)])))
            self.assertEqual(set(), self.options(command) - named, command)

    def test_pages_promise_no_option_that_does_not_exist(self):
        options = {command: self.options(command) for command in self.commands()}
        for command, own in options.items():
            self.assertEqual(set(), promised(page(command)) - own, command)
        everything = set().union(*options.values()) | EVERYWHERE
        for common in ("options", "statistics", *options):
            self.assertEqual(set(), set(OPTION.findall(page(common))) - everything
                             - {"--build", "--target"}, common)

    def output(self, command):
        """What a command line of the manual writes to standard output."""
        path = os.pathsep.join([os.path.dirname(os.path.abspath(self.program)), os.environ["PATH"]])
        run = subprocess.run(command, shell=True, cwd=self.directory, capture_output=True, text=True,
                             env={**os.environ, "PATH": path}, timeout=60)
        self.assertEqual(0, run.returncode, command + "\n" + run.stderr)
        return run.stdout.splitlines()

    def test_examples_show_what_the_program_writes(self):
        shutil.copy(ROOT / "examples" / "data" / "part.off", self.directory)
        for file in sorted(MANUAL.glob("command_*.md")):
            for block in shell_blocks(file.read_text(encoding="utf-8")):
                written, lines = [], []
                for line in block:
                    if line.startswith("$ "):
                        written = self.output(line[2:])
                    elif line != "...":
                        lines.append(line)
                if not lines:
                    continue
                self.assertIn(lines[0], written, file.name)
                begin = written.index(lines[0])
                for shown, line in zip(lines, written[begin:]):
                    shown, line = shown.rstrip(","), line.rstrip(",")
                    self.assertTrue(agrees(shown, line),
                                    f"{file.name} shows {shown}, the program writes {line}")


if __name__ == "__main__":
    main()
