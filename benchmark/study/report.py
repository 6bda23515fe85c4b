#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report of a study from the lines that `intrinsic study` writes.

One page of HTML with tables and plots, without scripts, that needs nothing else. The order of lines does not matter,
except that of lines with the same mesh and arithmetic the last counts.
"""

import argparse
import html
import io
import json
import math
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import matplotlib
    import pandas
    from matplotlib.figure import Figure
except ImportError as error:
    sys.exit(f"report.py: {error}; install pandas and matplotlib (Debian: python3-pandas "
             "python3-matplotlib, for /usr/bin/python3)")

# From the simplest to exact ones; others come last.
ARITHMETICS = ["double", "double-1e-12", "double-1e-6", "double-1e-5", "long-double", "interval",
               "boost-100", "boost-200", "gmpq", "core-expr", "lazy-core-expr", "exact",
               "exact-integer"]
CERTIFIED = ["exact", "exact-integer"]
NAIVE_EXACT = ["gmpq", "core-expr", "lazy-core-expr"]  # without filter and history of our own
STATUSES = {"done": "done", "cap": "cap on flips", "timed_out": "timed out",
            "out_of_memory": "out of memory", "crashed": "crashed",
            "not_applicable": "not applicable", "refused_input": "input refused"}
UNFINISHED = ["timed_out", "out_of_memory", "crashed", "cap"]
WORDS = ["mesh", "family", "arithmetic", "status", "message", "result", "comparison", "version",
         "machine"]
NUMBERS = ["faces", "flips", "checks", "refused_flips", "filter_failures", "integer",
           "certified_zero", "probable_zero", "undecided", "different_decisions", "nonconvex_flips",
           "inverted_faces", "non_delaunay_edges", "cycles", "largest_interval_width", "area_drift",
           "cone_angle_drift", "seconds.build", "seconds.flip", "peak_rss_mib", "limits.seconds",
           "limits.mib"]
UNKNOWN = "\u2013"

# The palette of Okabe and Ito (2008), which color-blind people can tell apart; relatives share a
# color and differ by marker and dashes. Yellow is left out: it does not show on white.
STYLES = {
    "double": ("#000000", "o", "-"),
    "double-1e-12": ("#E69F00", "o", "-"),
    "double-1e-6": ("#E69F00", "s", "--"),
    "double-1e-5": ("#E69F00", "^", ":"),
    "long-double": ("#777777", "D", "--"),
    "interval": ("#56B4E9", "o", ":"),
    "boost-100": ("#009E73", "s", "-"),
    "boost-200": ("#009E73", "D", "--"),
    "gmpq": ("#CC79A7", "^", "-"),
    "core-expr": ("#D55E00", "^", "-"),
    "lazy-core-expr": ("#D55E00", "X", "--"),
    "exact": ("#0072B2", "o", "-"),
    "exact-integer": ("#0072B2", "s", "--"),
}
OTHER_STYLE = ("#999999", "X", ":")

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Arithmetics of Delaunay flips</title>
<style>
body { font: 15px/1.45 sans-serif; color: #111; background: #fff; max-width: 1280px;
  margin: 0 auto; padding: 1em 2em 4em; }
h1, h2, h3 { line-height: 1.2; }
h2 { margin-top: 2.2em; border-bottom: 1px solid #bbb; }
p, li { max-width: 50em; }
table { border-collapse: collapse; margin: 0.8em 0; font-size: 13px; }
th, td { padding: 3px 10px; text-align: right; vertical-align: bottom; }
td { font-variant-numeric: tabular-nums; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 2px solid #444; max-width: 8em; }
tbody tr:nth-child(even) { background: #f3f6f8; }
.words td { text-align: left; white-space: normal; }
.words th { text-align: left; }
.wide { overflow-x: auto; }
svg { display: block; width: 100%; max-width: 900px; height: auto; margin: 1em 0; }
svg * { stroke-linejoin: round; stroke-linecap: butt; }
summary { cursor: pointer; color: #0072B2; }
</style>
</head>
<body>
"""


# ---- Lines ---------------------------------------------------------------------------------------


class Failure(Exception):
    """Valid usage that failed; the message names the file and the remedy."""


def is_result(line):
    return isinstance(line, dict) and all(isinstance(line.get(key), str) and line[key]
                                          for key in ("mesh", "arithmetic", "status"))


def parsed(text):
    try:
        return json.loads(text)
    except ValueError:
        return None


def read_lines(path):
    """The lines of a file; a last one that is not complete, as of a study at work, is left out."""
    try:
        with open(path, encoding="utf-8") as file:
            complete = file.read().split("\n")[:-1]
    except (OSError, UnicodeDecodeError) as e:
        raise Failure(f"{path}: cannot be read: {e}; give files that `intrinsic study` has "
                      "written") from e
    lines = [parsed(text) for text in complete]
    for number, line in enumerate(lines, 1):
        if not is_result(line):
            raise Failure(f"{path}: line {number} is no result of the study; remove it")
    return lines


def rank(arithmetic):
    known = arithmetic in ARITHMETICS
    return (ARITHMETICS.index(arithmetic) if known else len(ARITHMETICS), arithmetic)


def value_of(line, key):
    """A value, that of an object by `object.key`; None if there is none."""
    for part in key.split("."):
        line = line.get(part) if isinstance(line, dict) else None
    return line


def number_of(line, key):
    x = value_of(line, key)
    is_number = isinstance(x, (int, float)) and not isinstance(x, bool) and math.isfinite(x)
    return x if is_number else math.nan


def word_of(line, key):
    x = value_of(line, key)
    return x if isinstance(x, str) else ""


def escalations_of(line):
    """How many predicates so many bits have decided."""
    found = value_of(line, "escalations")
    pairs = found.items() if isinstance(found, dict) else []
    return {int(bits): n for bits, n in pairs if bits.isdigit() and isinstance(n, int)}


def row_of(line):
    row = {key: word_of(line, key) for key in WORDS}
    row.update({key: number_of(line, key) for key in NUMBERS})
    return row | {"escalations": escalations_of(line)}


def results_of(lines):
    """One row per mesh and arithmetic, files first, then by family, by name, and arithmetic."""
    frame = pandas.DataFrame([row_of(line) for line in lines])
    frame = frame.drop_duplicates(["mesh", "arithmetic"], keep="last").copy()
    by_mesh = frame.groupby("mesh")
    frame["faces"] = by_mesh["faces"].transform("max").fillna(0)
    frame["seconds"] = frame["seconds.build"] + frame["seconds.flip"]
    frame["is_done"] = frame["status"] == "done"
    frame["is_file"] = by_mesh["family"].transform("max") == "files"
    frame["rank"] = frame["arithmetic"].map(rank)
    frame = frame.sort_values(["is_file", "family", "mesh", "rank"],
                              ascending=[False, True, True, True])
    return frame.reset_index(drop=True)


def meshes_of(results):
    return list(dict.fromkeys(results["mesh"]))


def arithmetics_of(results):
    return sorted(set(results["arithmetic"]), key=rank)


def faces_of(results):
    """Numbers of faces by mesh."""
    return results.drop_duplicates("mesh").set_index("mesh")["faces"]


def of(results, arithmetic):
    """The lines of an arithmetic, by mesh."""
    return results[results["arithmetic"] == arithmetic].set_index("mesh")


def done(results, arithmetic):
    """Those that have finished."""
    lines = of(results, arithmetic)
    return lines[lines["is_done"]]


# ---- Texts and tables ----------------------------------------------------------------------------


def grouped(n):
    """A number with commas between groups of three digits; a dash if it is not known."""
    return UNKNOWN if n is None or math.isnan(n) else f"{int(n):,}".replace("-", "\u2212")


def plural(n, one, many):
    return f"{grouped(n)} {one if n == 1 else many}"


def short(x, digits=3):
    """A number with some significant digits, such as 0.0123 or 3.1e-12; a dash if it is not known."""
    if x is None or math.isnan(x):
        return UNKNOWN
    if x != 0 and not 1e-3 <= abs(x) < 1e6:
        return f"{x:.{digits - 2}e}"
    leading = math.floor(math.log10(abs(x))) if x != 0 else digits - 1
    return f"{x:.{max(0, digits - 1 - leading)}f}"


def share(some, all_of_them):
    return UNKNOWN if all_of_them == 0 else f"{grouped(some)} of {grouped(all_of_them)}"


def items(texts):
    return "<ul>\n" + "".join(f"<li>{html.escape(t)}</li>\n" for t in texts) + "</ul>\n"


def paragraph(text):
    return f"<p>{html.escape(text)}</p>\n"


def details(summary, content):
    return f"<details><summary>{html.escape(summary)}</summary>\n{content}</details>\n"


def table(rows, head, shown=30, classes=""):
    """A table whose first column holds names; rows beyond `shown` are folded away."""
    def part(some):
        with pandas.option_context("display.max_colwidth", None):
            text = pandas.DataFrame(some, columns=head).to_html(index=False, border=0,
                                                                justify="unset", na_rep="")
        text = re.sub("<table [^>]*>", "<table>", text)
        return f'<div class="wide {classes}">{text}</div>\n'.replace(' ">', '">')
    if len(rows) <= shown + 5:  # folding away a few rows hides more than it saves
        return part(rows)
    return part(rows[:shown]) + details(f"{len(rows) - shown} more", part(rows[shown:]))


# ---- What is known of an arithmetic --------------------------------------------------------------


def total(results, arithmetic, key):
    """Sum of a key over the lines of an arithmetic that have it; NaN if none has."""
    return of(results, arithmetic)[key].sum(min_count=1)


def finishing_arithmetics(results):
    """Those that have done at least nine meshes of ten."""
    number = len(meshes_of(results))
    return [a for a in arithmetics_of(results) if 10 * len(done(results, a)) >= 9 * number]


def common_meshes(results):
    """The meshes that all finishing arithmetics have done, with times."""
    common, names = set(meshes_of(results)), finishing_arithmetics(results)
    for a in names:
        common &= set(done(results, a)["seconds"].dropna().index)
    return common if names else set()


def times_beside_double(results, arithmetic, meshes=None):
    """Times of an arithmetic and of double on the meshes that both have done, of `meshes` if given."""
    times = pandas.DataFrame({"own": done(results, arithmetic)["seconds"],
                              "double": done(results, "double")["seconds"]}).dropna()
    return times if meshes is None else times[times.index.isin(meshes)]


def ratio(times):
    return times["own"].sum() / times["double"].sum() if times["double"].sum() > 0 else math.nan


def agreement(results, a, b):
    """Of each mesh whose result is known of two arithmetics, whether they are the same."""
    found = pandas.DataFrame({x: done(results, x)["result"] for x in {a, b}}).dropna()
    found = found[(found[a] != "") & (found[b] != "")]
    order = {name: i for i, name in enumerate(meshes_of(results))}
    return (found[a] == found[b]).sort_index(key=lambda index: index.map(order))


def flips_beyond_exact(results, arithmetic):
    return (of(results, arithmetic)["flips"] - done(results, "exact")["flips"]).dropna()


def decided_by(results, arithmetic):
    """Predicates that the filter left open, by what decided them, in order of cost."""
    steps = {"integers": total(results, arithmetic, "integer")}
    for bits in sorted({b for found in results["escalations"] for b in found}):
        steps[f"{bits} bits"] = sum(found.get(bits, 0)
                                    for found in of(results, arithmetic)["escalations"])
    for name, key in (("zero, proven", "certified_zero"), ("zero, probably", "probable_zero"),
                      ("undecided", "undecided")):
        steps[name] = total(results, arithmetic, key)
    return steps


# ---- The start of the page -----------------------------------------------------------------------


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


# ---- Tables of arithmetics -----------------------------------------------------------------------


def ends(results):
    rows = []
    for a in arithmetics_of(results):
        lines = of(results, a)
        rows.append([a, grouped(len(lines)),
                     *(grouped((lines["status"] == s).sum()) for s in STATUSES),
                     short(lines["peak_rss_mib"].max())])
    return table(rows, ["arithmetic", "jobs", *STATUSES.values(), "largest memory (MiB)"])


def times(results):
    finishing, common, rows = finishing_arithmetics(results), common_meshes(results), []
    for a in arithmetics_of(results):
        shared, own = times_beside_double(results, a, common), times_beside_double(results, a)
        on_common = [short(shared["own"].sum()), short(ratio(shared))]
        rows.append([a, *(on_common if a in finishing else [UNKNOWN] * 2), short(ratio(own)),
                     grouped(len(own))])
    text = ("<p>Seconds of building and flipping, without any of the comparisons. <i>Common</i> "
            "meshes are those done by every arithmetic that has done nine meshes in ten; there are "
            f"{grouped(len(common))}.</p>\n")
    return text + table(rows, ["arithmetic", "time on common (s)", "ratio to double",
                               "ratio to double where done", "over so many meshes"])


def decisions(results):
    sums = {"flips": "flips", "different decisions": "different_decisions",
            "flips not convex": "nonconvex_flips", "refused flips": "refused_flips",
            "cycles": "cycles", "inverted faces": "inverted_faces",
            "edges not Delaunay": "non_delaunay_edges"}
    worst = {"area drift": "area_drift", "cone angle drift": "cone_angle_drift",
             "interval width": "largest_interval_width"}
    rows = []
    for a in arithmetics_of(results):
        lines, agree = of(results, a), agreement(results, a, "exact")
        ended = lines["comparison"][lines["comparison"] != ""]
        rows.append([a, *(grouped(total(results, a, key)) for key in sums.values()),
                     grouped((lines["non_delaunay_edges"] > 0).sum()),
                     # comparisons end early where the exact metric cannot follow, or at limits
                     share((ended == "complete").sum(), len(ended)),
                     share(agree.sum(), len(agree)),
                     *(short(lines[key].max(), 2) for key in worst.values())])
    return table(rows, ["arithmetic", *sums, "in so many meshes", "compared to the end",
                        "same result as exact", *worst])


def summary(results):
    return ends(results) + times(results) + decisions(results)


def summaries(results):
    text = "<h2>Summary</h2>\n" + paragraph(
        "All that follows a decision was tested with exact arithmetic: which predicates of an "
        "arithmetic are wrong on the way, which flips were of diamonds that are not convex, and "
        "which edges of the result are not Delaunay. Drifts are the worst over meshes: of the total "
        "area, relative; of cone angles, in radians. Interval widths are relative. A dash: not "
        "known, or without meaning for the arithmetic.") + summary(results)
    files, stress = results[results["is_file"]], results[~results["is_file"]]
    if files.empty or stress.empty:
        return text
    return (text + details("Mesh files only", summary(files))
            + details("Stress families only", summary(stress)))


def escalations(results):
    rows, head = [], []
    for a in arithmetics_of(results):
        failures = total(results, a, "filter_failures")
        if a not in CERTIFIED and not failures > 0:
            continue
        steps = decided_by(results, a)
        head = ["arithmetic", "checks", "filter failures", *steps]
        rows.append([a, grouped(total(results, a, "checks")), grouped(failures),
                     *map(grouped, steps.values())])
    return table(rows, head) if rows else ""


# ---- Tables of meshes by arithmetics -------------------------------------------------------------


def cell(value, is_done):
    if math.isnan(value):
        return "?" if is_done else UNKNOWN
    return grouped(value)


def matrix(results, columns, values):
    """Meshes by arithmetics, of the meshes with a value that is not zero, largest first."""
    meshes = meshes_of(results)
    found = pandas.DataFrame({a: values(a).reindex(meshes) for a in columns}, index=meshes)
    largest = found.abs().max(axis=1).fillna(0)
    names = sorted(largest[largest > 0].index, key=lambda mesh: (-largest[mesh], mesh))
    if not names:
        return paragraph("None.")
    faces = faces_of(results)
    finished = {a: set(done(results, a).index) for a in columns}
    rows = [[mesh, grouped(faces[mesh]),
             *(cell(found.at[mesh, a], mesh in finished[a]) for a in columns)] for mesh in names]
    return table(rows, ["mesh", "faces", *columns], shown=25)


def harm(results):
    inexact = [a for a in arithmetics_of(results) if a not in CERTIFIED + NAIVE_EXACT]
    text = "<h2>What inexact arithmetic does</h2>\n" + paragraph(
        "Meshes with the largest numbers first. A question mark is where the exact comparison did "
        "not get that far, a dash where the arithmetic itself did not.")
    for title, values in (
            ("Edges of the result that are not Delaunay", "non_delaunay_edges"),
            ("Flips more, or fewer, than with exact predicates", None),
            ("Cycles: flips that undo the last flip of the same edge", "cycles"),
            ("Flips of diamonds that are not convex", "nonconvex_flips"),
            ("Faces of the result that are inverted", "inverted_faces")):
        text += f"<h3>{title}</h3>\n" + matrix(
            results, inexact, lambda a, key=values: of(results, a)[key] if key else
            flips_beyond_exact(results, a))
    return text


def how_it_ended(lines, mesh):
    if mesh not in lines.index:
        return UNKNOWN
    line = lines.loc[mesh]
    return short(line["seconds"], 2) + " s" if line["is_done"] else line["status"].replace("_", " ")


def unfinished(results):
    text = "<h2>What does not finish</h2>\n" + paragraph(
        "Meshes on which some arithmetic reached its limits, small ones first; times of those that "
        "finish. A dash: not run.")
    stuck = results[results["status"].isin(UNFINISHED)]
    if stuck.empty:
        return text + paragraph("All arithmetics finished everything that they apply to.")
    shown = {"double", "exact"} | set(stuck["arithmetic"])
    columns = {a: of(results, a) for a in arithmetics_of(results) if a in shown}
    faces = faces_of(stuck).sort_values(kind="stable")
    rows = [[mesh, grouped(n), *(how_it_ended(lines, mesh) for lines in columns.values())]
            for mesh, n in faces.items()]
    return text + table(rows, ["mesh", "faces", *columns], shown=25)


def messages(results):
    """What jobs that failed have to say, each message of a mesh once."""
    failed = results[results["status"].isin(["crashed", "refused_input"])]
    if failed.empty:
        return ""
    merged = failed.groupby(["mesh", "status", "message"], sort=False)["arithmetic"].agg(list)
    every = arithmetics_of(results)
    rows = [[mesh, "all" if len(names) == len(every) > 1 else ", ".join(names), status, message]
            for (mesh, status, message), names in merged.items()]
    return "<h3>Crashes and refusals</h3>\n" + table(
        rows, ["mesh", "arithmetic", "end", "message"], shown=15, classes="words")


# ---- Plots ---------------------------------------------------------------------------------------

SVG, XLINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}"
SETTINGS = {"svg.fonttype": "none", "svg.hashsalt": "study", "font.size": 10,
            "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#444444",
            "axes.grid": True, "axes.axisbelow": True, "grid.color": "#e2e2e2",
            "lines.linewidth": 1.4, "lines.markersize": 5}


def style_of(arithmetic):
    return STYLES.get(arithmetic, OTHER_STYLE)


def power_of_ten(exponent):
    digits = str(exponent).translate(str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3"
                                                   "\u2074\u2075\u2076\u2077\u2078\u2079"))
    return {0: "1", 1: "10"}.get(exponent, f"10{digits}")


def set_logarithmic(axes, name, values):
    """Makes an axis logarithmic in whole decades, with a place for zero if there is one."""
    values = list(values)
    positive = [x for x in values if x > 0] or [1]
    low = math.floor(math.log10(min(positive)) + 1e-9)
    high = max(low + 1, math.ceil(math.log10(max(positive)) - 1e-9))
    ticks = list(range(low, high + 1, 1 + (high - low) // 10))
    places, labels = [10.0**k for k in ticks], [power_of_ten(k) for k in ticks]
    start = 0.85 * 10.0**low  # markers need room
    set_scale = getattr(axes, f"set_{name}scale")
    if 0 in values:
        places, labels, start = [0, *places], ["0", *labels], -0.05 * 10.0**low
        set_scale("symlog", linthresh=10.0**low, linscale=0.6)
    else:
        set_scale("log")
    getattr(axes, f"set_{name}lim")(start, 1.15 * 10.0**high)
    axis = getattr(axes, f"{name}axis")
    axis.set_ticks(places, labels)
    axis.set_ticks([], minor=True)


def figure(title, x_label, y_label):
    plot = Figure(figsize=(9, 4.9))
    axes = plot.add_axes((0.085, 0.115, 0.675, 0.8))
    axes.set_title(title, fontsize=11, fontweight="bold")
    axes.set(xlabel=x_label, ylabel=y_label)
    axes.tick_params(length=0)
    return plot, axes


def add_legend(axes):
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), frameon=False, handlelength=2.6)


def set_texts(artist, texts):
    """Sets what is shown when the mouse rests on the points of an artist, for `add_texts()`."""
    artist.set_gid("texts:" + json.dumps(texts))


def add_points(axes, points, style, label, is_hollow=False):
    """Adds points, triples x, y, text."""
    color, marker, _ = style
    xs, ys, texts = zip(*points)
    drawn = axes.scatter(xs, ys, s=22, marker=marker, edgecolors=color, linewidths=1, label=label,
                         facecolors="white" if is_hollow else color, zorder=3)
    set_texts(drawn, texts)


def add_texts(root):
    for group in root.iter(SVG + "g"):
        if group.get("id", "").startswith("texts:"):
            for use, text in zip(group.iter(SVG + "use"), json.loads(group.get("id")[6:])):
                ElementTree.SubElement(use, SVG + "title").text = text


def clean(root, number):
    """Drops what the page does not need, and makes names those of one plot only."""
    for parent in list(root.iter()):
        for child in list(parent):
            if child.tag in (SVG + "metadata", SVG + "style", SVG + "clipPath"):
                parent.remove(child)
    used = {e.get(XLINK + "href", "")[1:] for e in root.iter()}
    for e in root.iter():
        e.attrib.pop("clip-path", None)  # nothing is drawn outside
        name, reference = e.attrib.pop("id", ""), e.attrib.pop(XLINK + "href", "")
        if name in used - {""}:
            e.set("id", f"plot{number}-{name}")
        if reference:
            e.set("href", f"#plot{number}-{reference[1:]}")
        if "style" in e.attrib:
            e.set("style", re.sub(r"(font: [\w ]*?[\d.]+px) [^;]*", r"\1 sans-serif", e.get("style")))
        e.tag = e.tag.replace(SVG, "")


class Plots:
    """Numbers plots, and writes them as `svg` elements."""

    def __init__(self):
        self.count = 0

    def svg(self, plot):
        self.count += 1
        text = io.StringIO()
        with matplotlib.rc_context(SETTINGS):
            plot.savefig(text, format="svg", metadata={"Date": None})
        root = ElementTree.fromstring(text.getvalue())
        add_texts(root)
        clean(root, self.count)
        attributes = {"viewBox": root.get("viewBox"), "role": "img",
                      "aria-label": plot.axes[0].get_title()}
        root.attrib.clear()
        root.attrib.update(attributes)
        return ElementTree.tostring(root, encoding="unicode") + "\n"


def time_points(lines, arithmetic):
    """Places, and whether jobs have finished: others are where they would be at the earliest."""
    late = lines["status"] == "timed_out"
    seconds = lines["seconds"].mask(late, lines["limits.seconds"])
    for mesh in lines.index[(seconds > 0) & (lines["faces"] > 0)]:
        text = f"{mesh}, {arithmetic}" + ("" if lines["is_done"][mesh] else ", not finished")
        yield (lines["faces"][mesh], seconds[mesh], text), lines["is_done"][mesh]


def plot_times(plots, results):
    points = {a: list(time_points(of(results, a), a)) for a in arithmetics_of(results)}
    drawn = [p for found in points.values() for p, _ in found]
    if not drawn:
        return ""
    plot, axes = figure("Time to build and flip", "faces", "seconds (hollow: limit reached)")
    set_logarithmic(axes, "x", (x for x, _, _ in drawn))
    set_logarithmic(axes, "y", (y for _, y, _ in drawn))
    for a, found in points.items():
        label = a
        for is_done in (True, False):
            some = [p for p, d in found if d == is_done]
            if some:
                add_points(axes, some, style_of(a), label, is_hollow=not is_done)
                label = None  # one entry of the legend
    add_legend(axes)
    return plots.svg(plot)


def sorted_ratios(results, arithmetic):
    """Times in multiples of those of double; what takes no measurable time takes as long as double."""
    both = times_beside_double(results, arithmetic)
    return sorted((both["own"] / both["double"]).where(both["double"] > 0, 1))


def plot_profile(plots, results):
    ratios = {a: sorted_ratios(results, a) for a in arithmetics_of(results)}
    number = len(ratios.get("double", []))
    if number == 0:
        return ""
    plot, axes = figure("Share of meshes done within x times the time of double", "x",
                        "share of the meshes that double has done")
    every = [1, *(r for found in ratios.values() for r in found if r > 0)]
    set_logarithmic(axes, "x", every)
    axes.set_ylim(0, 1.02)
    for a, found in ratios.items():
        if found:
            color, _, dashes = style_of(a)
            shares = [k / number for k in range(len(found) + 1)]
            axes.step([found[0], *found, max(every)], [*shares, shares[-1]], where="post",
                      color=color, linestyle=dashes, label=a)
    add_legend(axes)
    return plots.svg(plot)


def split_name(mesh):
    """The name of a stress mesh without `amount`: meshes that share it differ in nothing else."""
    found = re.search(r":amount=([^:]*)", mesh)
    try:
        return (mesh[:found.start()] + mesh[found.end():], float(found[1])) if found else None
    except ValueError:
        return None


def stressed(results):
    """Lines of stress meshes with an amount, by the rest of their names, of which there are several."""
    lines = results[~results["is_file"]].copy()
    names = lines["mesh"].map(split_name)
    lines = lines[names.notna()].assign(name=names.map(lambda n: n and n[0]),
                                        amount=names.map(lambda n: n and n[1]))
    lines = lines[lines["amount"] >= 0]
    return [(name, of_name) for name, of_name in lines.groupby("name")
            if of_name["amount"].nunique() > 1]


def plot_stress(plots, results):
    text = "<h2>By amount of stress</h2>\n" + paragraph(
        "Meshes of a stress family that differ in the amount only, and arithmetics that leave such "
        "edges. Axes are logarithmic, with a place for zero.")
    drawn = ""
    for name, lines in stressed(results):
        counts = lines.pivot(index="amount", columns="arithmetic", values="non_delaunay_edges")
        # lines of those that leave none anywhere would hide each other
        counts = counts[sorted(counts.columns[counts.sum() > 0], key=rank)]
        if counts.empty or len(counts.columns) == 0:
            continue
        plot, axes = figure(f"{name}: edges that are not Delaunay", "amount", "edges of the result")
        counts = counts.dropna(how="all")
        set_logarithmic(axes, "x", counts.index)
        set_logarithmic(axes, "y", (n for n in counts.to_numpy().flat if n >= 0))
        for a in counts.columns:
            color, marker, dashes = style_of(a)
            points = counts[a].dropna()
            drawn_line, = axes.plot(points.index, points, color=color, marker=marker,
                                    linestyle=dashes, label=a)
            set_texts(drawn_line, [f"{a}, {grouped(n)}" for n in points])
        add_legend(axes)
        drawn += plots.svg(plot)
    return text + (drawn or paragraph("None."))


def plot_escalations(plots, results):
    names = [a for a in arithmetics_of(results) if a in CERTIFIED]
    steps = pandas.DataFrame({a: decided_by(results, a) for a in names}).fillna(0)
    if not steps.to_numpy().sum() > 0:
        return ""
    plot, axes = figure("What decided where the filter did not", "step", "predicates")
    set_logarithmic(axes, "y", [1, *(n for n in steps.to_numpy().flat if n >= 1)])
    bottom = axes.get_ylim()[0]  # a bar of height 1 is there, if only just
    width = 0.8 / len(names)
    for i, a in enumerate(names):
        color = "#56B4E9" if a == "exact-integer" else style_of(a)[0]  # without markers or dashes
        places = [k - 0.4 + (i + 0.5) * width for k in range(len(steps))]
        bars = axes.bar(places, steps[a].where(steps[a] >= 1) - bottom, width, bottom, color=color,
                        label=a)
        axes.bar_label(bars, [grouped(n) if n >= 1 else "" for n in steps[a]], fontsize=8, padding=2)
    axes.set_xlim(-0.5, len(steps) - 0.5)
    axes.set_xticks(range(len(steps)), steps.index)
    axes.grid(False, axis="x")
    add_legend(axes)
    return plots.svg(plot)


# ---- The page ------------------------------------------------------------------------------------


def page(lines):
    results, plots = results_of(lines), Plots()
    with matplotlib.rc_context(SETTINGS):
        return "".join([
            PAGE, start(results), summaries(results), "<h2>Time</h2>\n",
            plot_times(plots, results), plot_profile(plots, results), harm(results),
            plot_stress(plots, results), unfinished(results), messages(results),
            "<h2>What exact decisions take</h2>\n", escalations(results),
            plot_escalations(plots, results), "</body>\n</html>\n"])


def write(path, text):
    """Writes a file beside the target and renames it: never half."""
    directory = os.path.dirname(path) or "."
    try:
        with tempfile.NamedTemporaryFile("w", encoding="utf-8", dir=directory, delete=False,
                                         suffix=".part") as file:
            try:
                file.write(text)
                file.close()
                mask = os.umask(0)
                os.umask(mask)
                os.chmod(file.name, 0o666 & ~mask)  # as open() would
                os.replace(file.name, path)
            except BaseException:
                os.unlink(file.name)
                raise
    except OSError as e:
        raise Failure(f"{path}: cannot be written: {e.strerror}") from e


def page_name(path):
    if os.path.splitext(path)[1] != ".html":
        raise argparse.ArgumentTypeError(f"{path}: pages are written, to a file with extension "
                                         ".html only")
    return path


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
            raise Failure(f"{options.results[0]}: there are no results in it; run `intrinsic study`")
        write(options.page, page(lines))
    except Failure as e:
        sys.exit(f"report.py: {e}")


if __name__ == "__main__":
    main()
