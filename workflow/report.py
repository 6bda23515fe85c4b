#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one page of how commands ended on files, and compares it with an earlier run.

The page needs nothing else, and has no scripts.
"""

import argparse
import html
import math
import sys

try:
    from failure import Failure
    from page import (details, grouped, items, page, page_name, paragraph, plural, short,
                      table, write)
    from plots import Plots, add_legend, add_points, figure, set_logarithmic
    from records import STATUSES, is_measured, read_records, statistics
except ImportError as error:
    sys.exit(f"report.py: {error}; install pandas and matplotlib (Debian: python3-pandas "
             "python3-matplotlib, for /usr/bin/python3)")

COLORS = ["#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#000000"]
MARKERS = "os^Dv"


def known(values):
    return "; ".join(sorted(set(values) - {""})) or "unknown"


def exactly(x):
    return grouped(x) if x == int(x) and abs(x) < 1e15 else short(x)


def by_command(runs):
    return list(runs.groupby("command", sort=True))


def start(runs):
    failed = (runs["status"] != "done").sum()
    counts = ", ".join([plural(runs["sha256"].nunique(), "file", "files"),
                        plural(runs["command"].nunique(), "command", "commands"),
                        plural(len(runs), "run", "runs")])
    return ("<h1>Commands on files</h1>\n"
            + paragraph(f"{counts}; {grouped(failed)} of them did not end well. "
                        f"Limits: {known(runs['limits'])}. Machine: {known(runs['machine'])}."))


def ends(runs):
    used = [s for s in STATUSES if s == "done" or (runs["status"] == s).any()]
    rows = [[command, grouped(len(some)), *(grouped((some["status"] == s).sum()) for s in used),
             short(some["seconds"].sum()), short(some["seconds"].median()),
             short(some["seconds"].max()), short(some["peak_rss_mib"].max())]
            for command, some in by_command(runs)]
    head = ["command", "runs", *(STATUSES[s] for s in used), "seconds", "median", "longest",
            "largest memory (MiB)"]
    return "<h2>How runs ended</h2>\n" + table(rows, head)


# ---- Distributions ------------------------------------------------------------------------------


def plot_shares(plots, runs, key, title, label):
    """The share of files that a command has done within x."""
    done = runs[(runs["status"] == "done") & (runs[key] > 0)]
    if done.empty:
        return ""
    plot, axes = figure(title, label, "share of the files")
    set_logarithmic(axes, "x", done[key])
    axes.set_ylim(0, 1.02)
    for number, (command, some) in enumerate(by_command(runs)):
        values = sorted(done[done["command"] == command][key])
        shares = [k / len(some) for k in range(len(values) + 1)]
        if values:
            axes.step([values[0], *values], shares, where="post", label=command[:40],
                      color=COLORS[number % len(COLORS)])
    add_legend(axes)
    return plots.svg(plot)


def plot_times(plots, runs):
    drawn = runs[(runs["faces"] > 0) & (runs["seconds"] > 0)]
    if drawn.empty:
        return ""
    plot, axes = figure("Time by size", "faces", "seconds (hollow: not done)")
    set_logarithmic(axes, "x", drawn["faces"])
    set_logarithmic(axes, "y", drawn["seconds"])
    for number, (command, some) in enumerate(by_command(drawn)):
        style = COLORS[number % len(COLORS)], MARKERS[number % len(MARKERS)], "-"
        for is_done in True, False:
            points = [(run.faces, run.seconds, f"{run.file}, {command}")
                      for run in some.itertuples() if (run.status == "done") == is_done]
            if points:
                label = command[:40] + ("" if is_done else ", not done")
                add_points(axes, points, style, label, is_hollow=not is_done)
    add_legend(axes)
    return plots.svg(plot)


def distributions(plots, runs):
    return "<h2>Time and memory</h2>\n" + "".join([
        plot_shares(plots, runs, "seconds", "Share of files done within a time", "seconds"),
        plot_times(plots, runs),
        plot_shares(plots, runs, "peak_rss_mib", "Share of files done within a memory", "MiB")])


def slowest(runs):
    longest = runs.sort_values("seconds", ascending=False, kind="stable").head(20)
    rows = [[run.file, run.command, grouped(run.faces), short(run.seconds),
             short(run.peak_rss_mib), STATUSES.get(run.status, run.status)]
            for run in longest.itertuples()]
    return "<h2>Slowest</h2>\n" + table(
        rows, ["file", "command", "faces", "seconds", "memory (MiB)", "end"])


def worst(runs):
    """The extremes of each number in statistics that is not the same for all files."""
    text = "<h2>Worst</h2>\n" + paragraph(
        "Numbers in the statistics of runs that are done, with the files where they are extreme.")
    for command, some in by_command(runs):
        found = statistics(some)
        rows = []
        for name in sorted(found.columns):
            x = found[name].dropna()
            if not is_measured(name) and x.nunique() > 1:
                rows.append([name, exactly(x.min()), x.idxmin(), exactly(x.median()),
                             exactly(x.max()), x.idxmax()])
        if rows:
            text += details(command, table(rows, ["number", "least", "in", "median", "greatest",
                                                  "in"], shown=1000))
    return text


def failures(runs):
    bad = runs[runs["status"] != "done"]
    text = "<h2>Failures</h2>\n"
    if bad.empty:
        return text + paragraph("None.")
    rows = [[run.file, run.command, STATUSES.get(run.status, run.status), run.message or "\u2013",
             run.repeat] for run in bad.itertuples()]
    return text + table(rows, ["file", "command", "end", "message", "to repeat it"],
                        classes="words")


# ---- Two runs -----------------------------------------------------------------------------------


def ratios(both):
    """How much longer commands take than before."""
    rows = []
    for command, some in by_command(both):
        done = some[(some["status"] == "done") & (some["status_before"] == "done")]
        done = done[(done["seconds"] > 0) & (done["seconds_before"] > 0)]
        if len(done):
            factors = done["seconds"] / done["seconds_before"]
            slower = factors.idxmax()
            rows.append([command, grouped(len(done)),
                         short(done["seconds"].sum() / done["seconds_before"].sum()),
                         short(math.exp(factors.map(math.log).mean())),
                         short(factors.max()), done["file"][slower]])
    return table(rows, ["command", "done both times", "ratio of times", "mean ratio",
                        "largest ratio", "in"]) if rows else ""


def changes(both):
    """What ended in another way, and numbers that differ."""
    ended, differ = [], []
    for run in both.itertuples():
        if run.status != run.status_before:
            ended.append([run.file, run.command, STATUSES[run.status_before],
                          STATUSES[run.status], run.message or "\u2013"])
        elif run.status == "done":
            names = [n for n in sorted(run.numbers.keys() | run.numbers_before.keys())
                     if not is_measured(n) and run.numbers.get(n) != run.numbers_before.get(n)]
            differ += [[run.file, run.command, n, str(run.numbers_before.get(n, "\u2013")),
                        str(run.numbers.get(n, "\u2013"))] for n in names]
    text = "<h3>What ended in another way</h3>\n"
    text += table(ended, ["file", "command", "before", "now", "message"],
                  classes="words") if ended else paragraph("Nothing.")
    text += "<h3>Statistics that differ</h3>\n"
    return text + (table(differ, ["file", "command", "number", "before", "now"]) if differ
                   else paragraph("None."))


def compared(runs, before):
    both = runs.merge(before, on=["sha256", "command"], suffixes=("", "_before"))
    counts = [f"{plural(len(both), 'run', 'runs')} on the same contents with the same command.",
              f"{plural(len(runs) - len(both), 'run is', 'runs are')} new.",
              f"{plural(len(before) - len(both), 'earlier run is', 'earlier runs are')} not "
              "repeated."]
    return "<h2>Compared with before</h2>\n" + items(counts) + ratios(both) + changes(both)


# ---- The page -----------------------------------------------------------------------------------


def report(runs, before):
    plots = Plots()
    return page("Commands on files", start(runs), ends(runs), failures(runs),
                "" if before is None else compared(runs, before), distributions(plots, runs),
                slowest(runs), worst(runs))


def main():
    parser = argparse.ArgumentParser(prog="report.py", description=__doc__.split("\n", 1)[0])
    parser.add_argument("results", nargs="+", help="directories of results, or files runs.jsonl")
    parser.add_argument("--before", action="append", metavar="RESULTS",
                        help="those of an earlier run, to compare with")
    parser.add_argument("-o", dest="page", required=True, type=page_name, metavar="FILE.html")
    options = parser.parse_args()
    try:
        before = read_records(options.before) if options.before else None
        write(options.page, report(read_records(options.results), before))
    except Failure as e:
        sys.exit(f"report.py: {e}")


if __name__ == "__main__":
    main()
