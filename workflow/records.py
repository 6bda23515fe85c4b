# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `run_command.py` writes as a table."""

import json
import math
from pathlib import Path

import pandas

from failure import Failure

STATUSES = {"done": "done", "failed": "failed", "misused": "wrong usage",
            "timed_out": "timed out", "out_of_memory": "out of memory", "crashed": "crashed"}
KEYS = ("file", "sha256", "command", "status", "message", "repeat", "seconds", "peak_rss_mib")


def _records_in(path):
    """Pairs of a place, for messages, and a text."""
    path = Path(path)
    try:
        if path.is_dir():
            return [(str(p), p.read_text(encoding="utf-8"))
                    for p in sorted(path.rglob("runs/*/*.json"))]
        lines = path.read_text(encoding="utf-8").splitlines()
        return [(f"{path}: line {number}", line) for number, line in enumerate(lines, 1)]
    except (OSError, UnicodeDecodeError) as e:
        raise Failure(f"{path}: cannot be read: {e}; give a directory of results, or a file "
                      "runs.jsonl") from e


def _record_of(place, text):
    try:
        record = json.loads(text)
    except ValueError:
        record = None
    if not isinstance(record, dict) or not all(key in record for key in KEYS):
        raise Failure(f"{place} is not how a command ended; remove it")
    return record


def _numbers_of(value, name=""):
    """Numbers in an object by names such as `quality.min_angle_deg`."""
    if isinstance(value, dict):
        for key, x in value.items():
            yield from _numbers_of(x, f"{name}.{key}" if name else key)
    elif isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value):
        yield name, value


def read_records(paths):
    """Returns a row for each file and command, in their order; the last record of each counts."""
    records = [_record_of(*r) for path in paths for r in _records_in(path)]
    if not records:
        raise Failure(f"{paths[0]}: there are no results in it; run the workflow")
    frame = pandas.DataFrame([{key: r[key] for key in KEYS} for r in records])
    frame["limits"] = [f"{r['limits']['seconds']:g} s and {r['limits']['mib']} MiB"
                       for r in records]
    frame["machine"] = [r.get("machine", "") for r in records]
    frame["numbers"] = [dict(_numbers_of(r["statistics"])) if isinstance(r["statistics"], dict)
                        else {} for r in records]
    frame["faces"] = [numbers.get("input.faces", math.nan) for numbers in frame["numbers"]]
    frame["faces"] = frame.groupby("sha256")["faces"].transform("max")  # of failures, too
    frame = frame.drop_duplicates(["file", "command"], keep="last")
    return frame.sort_values(["command", "file"]).reset_index(drop=True)


def statistics(runs):
    """Returns the numbers of runs of a command that are done: a column for each, a row per file.
    """
    done = runs[runs["status"] == "done"]
    return pandas.DataFrame(list(done["numbers"]), index=done["file"])


def is_measured(name):
    """Tells whether a number differs from run to run."""
    return name.startswith("seconds.") or "rss" in name or name.endswith("_seconds")
