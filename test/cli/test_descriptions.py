# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page for `man` and the scripts that complete command lines have all options of the program."""

import re
import shutil
import subprocess
import unittest

from cli_support import Cli_test, main

ASK = """
source ./completion
complete_at() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _intrinsic; echo "${COMPREPLY[*]}"; }
complete_at intrinsic para
complete_at intrinsic distance a.off --meth
complete_at intrinsic distance a.off --method ""
complete_at intrinsic distance a.o
"""


class Descriptions(Cli_test):
    def written(self, *arguments):
        run = self.run_program(*arguments)
        self.assertEqual((run.code, run.err), (0, ""))
        return run.out

    def options(self):
        """The names of the options of each command, as help says."""
        listed = self.written("--help").split("Subcommands:")[1]
        commands = re.findall(r"^  (\w+)", listed, re.MULTILINE)
        self.assertIn("delaunay", commands)
        return {c: re.findall(r"^  (?:-h,)?(--?[\w-]+)", self.written(c, "--help"), re.MULTILINE)
                for c in commands if c != "study"}

    def test_man_shows_each_option_without_warnings(self):
        page = self.write("intrinsic.1", self.written("--man"))
        with open(page, encoding="utf-8") as file:
            text = file.read().replace("\\-", "-")
        for command, options in self.options().items():
            own = text.split(f".SS {command}\n")[1].split(".SS ")[0]
            common = text.split("OPTIONS OF ALL COMMANDS")[1].split(".SH ")[0]
            for option in options:
                self.assertRegex(own + common, rf"\\fB{option}\\fR", command)
        if shutil.which("groff"):
            said = subprocess.run(["groff", "-man", "-Tutf8", "-k", "-ww", "-z", page], check=True,
                                  capture_output=True, text=True)
            self.assertEqual(said.stderr, "")

    def test_bash_completes_commands_options_and_words(self):
        self.write("completion", self.written("--completion", "bash"))
        said = subprocess.run(["bash", "-c", ASK], cwd=self.directory, check=True,
                              capture_output=True, text=True).stdout.splitlines()
        self.assertEqual(said, ["parametrize", "--method", "exact heat", ""])

    def test_both_shells_know_all_options(self):
        for shell in ("bash", "zsh"):
            text = self.written("--completion", shell)
            for command, options in self.options().items():
                own = re.split(rf"\n +{command}\)", text)[-1].split(";;")[0]
                for option in options:
                    self.assertRegex(own, rf"[\s\"*]{option}[\s\"\[]", f"{shell} {command}")
            if shutil.which(shell):
                subprocess.run([shell, "-n", self.write("script", text)], check=True)

    def test_help_does_not_list_them(self):
        self.assertNotIn("--man", self.written("--help"))
        self.assertEqual(self.run_program("--completion", "fish").code, 2)


if __name__ == "__main__":
    main()
