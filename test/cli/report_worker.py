# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `report.py` as often as its standard input asks, in a copy of this process each: to load
pandas takes as long as to make a page.

usage: report_worker.py FOLDER_OF_REPORT
A line of the input is `{"arguments": [...], "directory": ..., "out": FILE, "err": FILE}`; the
answer is the exit code.
"""

import json
import os
import sys

sys.path.insert(0, sys.argv[1])
import report


def run(arguments, directory, out, err):
    for number, name in ((1, out), (2, err)):
        os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
    os.chdir(directory)
    sys.argv = ["report.py", *arguments]
    sys.exit(report.main())


for line in iter(sys.stdin.readline, ""):
    child = os.fork()
    if child == 0:
        run(**json.loads(line))
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
