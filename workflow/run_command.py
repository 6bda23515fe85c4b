#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a command of `intrinsic` on a file, within limits, and writes how it ended as JSON.

In the command, {file} is the file (by default it follows the first word), {out} the start of names
of further files, and {cores} a number. A limit that is reached, and an error, are results: this
script fails only if the program does not exist.
"""

import argparse
import json
import os
import platform
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
LONGEST_MESSAGE = 2000


def words_of(command, file, out, cores):
    """The words of a command after the name of the program."""
    words = shlex.split(command)
    if not any("{file}" in word for word in words):
        words.insert(1, "{file}")
    values = {"{file}": file, "{out}": out, "{cores}": str(cores)}
    for name, value in values.items():
        words = [word.replace(name, value) for word in words]
    return words


def limited(words, seconds, mib, cores):
    """Runs words within limits. Returns the exit code, None if the time is over; what was said on
    standard error; and seconds."""
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_AS, (mib << 20, mib << 20))

    environment = os.environ | dict.fromkeys(THREADS, str(cores))
    start = time.monotonic()
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=said, env=environment, start_new_session=True,
                                   preexec_fn=limit_memory)
        try:
            code = process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            end(process)
            code = None
        said.seek(0)
        text = said.read().decode(errors="replace").strip()
        return code, text[-LONGEST_MESSAGE:], time.monotonic() - start


def end(process):
    """Ends a process and those that it has started; the program removes its incomplete files."""
    os.killpg(process.pid, signal.SIGTERM)
    try:
        process.wait(timeout=5)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def status_of(code, message):
    if code is None:
        return "timed_out"
    if code < 0:
        return "crashed"
    if code == 0:
        return "done"
    if "not enough memory" in message:
        return "out_of_memory"
    return "misused" if code == 2 else "failed"


def message_of(code, said, seconds):
    if code is None:
        return f"{seconds:g} s"
    if code < 0:
        return f"{signal.Signals(-code).name}; {said}".rstrip("; ")
    return said


def statistics_of(path):
    """What the program has written: an object, or objects on lines; None if there is nothing."""
    if not path.exists():
        return None
    lines = path.read_text(encoding="utf-8")
    if path.suffix == ".jsonl":
        return [json.loads(line) for line in lines.splitlines()]
    return json.loads(lines)


def repeated(words, seconds, mib, cores):
    """The command for a shell that does the same again."""
    threads = f"{THREADS[0]}={cores} {THREADS[1]}={cores}"
    return f"(ulimit -v {mib << 10}; {threads} timeout {seconds:g} {shlex.join(words)})"


def record(options):
    words = [options.program, *words_of(options.command, options.file, options.out,
                                        options.cores)]
    limits = options.time_limit, options.memory_limit, options.cores
    is_study = words[1] == "study"
    Path(options.out).parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as directory:
        path = Path(directory) / ("lines.jsonl" if is_study else "statistics.json")
        code, said, seconds = limited([*words, "-o" if is_study else "--stats", str(path)],
                                      *limits)
        statistics = statistics_of(path)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024  # never below this script
    return {
        "file": options.file, "sha256": options.sha256, "command": options.command,
        "status": status_of(code, said), "exit_code": code,
        "message": message_of(code, said, options.time_limit), "repeat": repeated(words, *limits),
        "seconds": round(seconds, 4), "peak_rss_mib": round(peak, 1),
        "limits": {"seconds": options.time_limit, "mib": options.memory_limit},
        "machine": f"{platform.node()}, {os.cpu_count()} processors", "statistics": statistics}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--command", required=True, help="what follows the name of the program")
    parser.add_argument("--file", required=True)
    parser.add_argument("--sha256", required=True)
    parser.add_argument("--out", required=True, help="the start of names of further files")
    parser.add_argument("--time-limit", required=True, type=float, help="seconds")
    parser.add_argument("--memory-limit", required=True, type=int, help="MiB")
    parser.add_argument("--cores", required=True, type=int)
    parser.add_argument("-o", dest="record", required=True)
    options = parser.parse_args()
    if not shutil.which(options.program):
        sys.exit(f"run_command.py: {options.program}: there is no such program; correct "
                 "`intrinsic`")
    result = record(options)
    part = options.record + ".part"
    with open(part, "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
    os.replace(part, options.record)


if __name__ == "__main__":
    main()
