#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report of a study from the lines that `intrinsic study` writes.

One page of HTML with tables and plots, without scripts, that needs nothing else. The order of lines
does not matter, except that of lines with the same mesh and arithmetic the last counts.
"""

import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
try:
    from failure import Failure
    from page import grouped, items, page, page_name, paragraph, plural, short, write
    from plots import Plots
    from report_lines import (CERTIFIED, agreement, arithmetics_of, common_meshes, done,
                              flips_beyond_exact, meshes_of, of, ratio, read_lines, results_of,
                              times_beside_double)
    from report_plots import plot_escalations, plot_profile, plot_stress, plot_times
    from report_tables import escalations, harm, messages, summaries, unfinished
except ImportError as error:
    sys.exit(f"report.py: {error}; install pandas and matplotlib (Debian: python3-pandas "
             "python3-matplotlib, for /usr/bin/python3)")


# ---- The start of the page ----------------------------------------------------------------------


def known(values):
    return "; ".join(sorted(set(values) - {""})) or "unknown"


def limits(results):
    """The limits of all jobs: results of several machines may be merged."""
    pairs = results[["limits.seconds", "limits.mib"]].drop_duplicates().dropna(how="all")
    return known(f"{s:.6g} s and {m:.6g} MiB" for s, m in pairs.itertuples(index=False))


def exact_items(results):
    common = common_meshes(results)
    for a in CERTIFIED:
        if a not in arithmetics_of(results):
            continue
        lines, finished = of(results, a), done(results, a)
        left = finished["non_delaunay_edges"].sum()
        text = (f"{a} finishes {grouped(len(finished))} of {plural(len(lines), 'mesh', 'meshes')} "
                f"and leaves {plural(left, 'edge that is', 'edges that are')} not Delaunay")
        times = ratio(times_beside_double(results, a, common))
        if not math.isnan(times):
            text += f"; it takes {short(times)} times as long as double in total"
        yield text + "."
    agree = agreement(results, *CERTIFIED)
    if len(agree) > 0:
        yield (f"exact and exact-integer have the same result on {grouped(agree.sum())} of "
               f"{plural(len(agree), 'mesh', 'meshes')}.")
    yield from (f"They differ on {name}." for name in agree.index[~agree])


def harm_item(counts, verb, one, many):
    counts = counts[counts > 0]
    if len(counts) > 0:
        yield (f"{verb} {plural(counts.sum(), one, many)} in "
               f"{plural(len(counts), 'mesh', 'meshes')}, {grouped(counts.max())} of them in "
               f"{counts.idxmax()}.")


def unfinished_item(results, arithmetic):
    lines = of(results, arithmetic)
    lines = lines[~lines["status"].isin(["not_applicable", "refused_input"])]
    stuck = lines[~lines["is_done"]]
    if len(stuck) > 0:
        smallest = stuck["faces"].idxmin()
        yield (f"{arithmetic} does not finish {grouped(len(stuck))} of "
               f"{plural(len(lines), 'mesh', 'meshes')}; the smallest is {smallest} with "
               f"{plural(stuck['faces'].min(), 'face', 'faces')}.")


def inexact_items(results):
    for a in arithmetics_of(results):
        if a in CERTIFIED:
            continue
        lines = of(results, a)
        yield from harm_item(lines["non_delaunay_edges"], f"{a} leaves",
                             "edge that is not Delaunay", "edges that are not Delaunay")
        more = flips_beyond_exact(results, a).reindex(lines.index)
        yield from harm_item(more, f"{a} makes", "flip more than exact", "flips more than exact")
        yield from harm_item(lines["cycles"], f"{a} undoes", "flip at once", "flips at once")
        yield from unfinished_item(results, a)


def start(results):
    numbers = ", ".join([plural(len(meshes_of(results)), "mesh", "meshes"),
                         plural(len(arithmetics_of(results)), "arithmetic", "arithmetics"),
                         plural(len(results), "job", "jobs")])
    return ("<h1>Arithmetics of Delaunay flips</h1>\n"
            + paragraph(f"{numbers}, each in a process of its own. Limits: {limits(results)}.")
            + paragraph(f"Program: intrinsic {known(results['version'])}. "
                        f"Machine: {known(results['machine'])}.")
            + items([*exact_items(results), *inexact_items(results)]))


# ---- The page -----------------------------------------------------------------------------------


def study_page(lines):
    results, plots = results_of(lines), Plots()
    return page(
        "Arithmetics of Delaunay flips", start(results), summaries(results), "<h2>Time</h2>\n",
        plot_times(plots, results), plot_profile(plots, results), harm(results),
        plot_stress(plots, results), unfinished(results), messages(results), "<h2>What exact decisions take</h2>\n",
        escalations(results), plot_escalations(plots, results))


def main():
    parser = argparse.ArgumentParser(prog="report.py", description=__doc__.split("\n", 1)[0])
    parser.add_argument("results", nargs="+", metavar="FILE.jsonl",
                        help="what `intrinsic study` has written; several files are merged")
    parser.add_argument("-o", dest="page", required=True, type=page_name, metavar="FILE.html",
                        help="the page")
    options = parser.parse_args()
    try:
        lines = [line for path in options.results for line in read_lines(path)]
        if not lines:
            raise Failure(f"{options.results[0]}: there are no results in it; run the study")
        write(options.page, study_page(lines))
    except Failure as e:
        sys.exit(f"report.py: {e}")


if __name__ == "__main__":
    main()
