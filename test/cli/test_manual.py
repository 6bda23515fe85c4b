# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the manual about commands name the options that the program has, and no others."""

import pathlib
import re

from cli_support import Cli_test, main

MANUAL = pathlib.Path(__file__).resolve().parents[2] / "doc" / "Intrinsic_triangulations"
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


if __name__ == "__main__":
    main()
