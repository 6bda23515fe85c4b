# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plots of the report of a study."""

import re

import pandas

from page import grouped, paragraph
from plots import add_legend, add_points, figure, set_logarithmic, set_texts
from report_lines import (ARITHMETICS, CERTIFIED, OTHER_STYLE, arithmetics_of, decided_by, of,
                          rank, times_beside_double)


def style_of(arithmetic):
    return ARITHMETICS.get(arithmetic, OTHER_STYLE)


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
    """Times in multiples of those of double; 1 where double takes no time that can be measured."""
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
    """Lines of stress meshes with several amounts, by the rest of their names."""
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
    steps = pandas.DataFrame({a: decided_by(results, a) for a in names})
    if not (steps > 0).to_numpy().any():
        return ""
    plot, axes = figure("What decided where the filter did not", "step", "predicates")
    set_logarithmic(axes, "y", [1, *(n for n in steps.to_numpy().flat if n >= 1)])
    bottom = axes.get_ylim()[0]  # a bar of height 1 is there, if only just
    width = 0.8 / len(names)
    for i, a in enumerate(names):
        color = "#56B4E9" if a == "exact-integer" else style_of(a)[0]  # without markers or dashes
        places = [k - 0.4 + (i + 0.5) * width for k in range(len(steps))]
        heights = steps[a].where(steps[a] >= 1, bottom) - bottom
        bars = axes.bar(places, heights, width, bottom, color=color,
                        label=a)
        axes.bar_label(bars, map(grouped, steps[a]), fontsize=8, padding=2)
    axes.set_xlim(-0.5, len(steps) - 0.5)
    axes.set_xticks(range(len(steps)), steps.index)
    axes.grid(False, axis="x")
    add_legend(axes)
    return plots.svg(plot)
