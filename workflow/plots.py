# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots of results, as elements `svg` of a page."""

import io
import json
import math
import re
import xml.etree.ElementTree as ElementTree

import matplotlib
from matplotlib.figure import Figure

SVG, XLINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}"
matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "study", "font.size": 10, "axes.spines.top": False,
    "axes.spines.right": False, "axes.edgecolor": "#444444", "axes.grid": True,
    "axes.axisbelow": True, "grid.color": "#e2e2e2", "lines.linewidth": 1.4,
    "lines.markersize": 5})


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
            e.set("style", re.sub(r"(font: [\w ]*?[\d.]+px) [^;]*", r"\1 sans-serif",
                                  e.get("style")))
        e.tag = e.tag.replace(SVG, "")


class Plots:
    """Numbers plots, and writes them as `svg` elements."""

    def __init__(self):
        self.count = 0

    def svg(self, plot):
        self.count += 1
        text = io.StringIO()
        plot.savefig(text, format="svg", metadata={"Date": None})
        root = ElementTree.fromstring(text.getvalue())
        add_texts(root)
        clean(root, self.count)
        attributes = {"viewBox": root.get("viewBox"), "role": "img",
                      "aria-label": plot.axes[0].get_title()}
        root.attrib.clear()
        root.attrib.update(attributes)
        return ElementTree.tostring(root, encoding="unicode") + "\n"
