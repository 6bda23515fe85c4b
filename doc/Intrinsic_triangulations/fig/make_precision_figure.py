#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `conformal_precision.svg` beside itself from the output of the benchmark
`conformal_precision`: make_precision_figure.py PRECISION.json. Needs only Python 3."""
import json
import os
import sys

sys.dont_write_bytecode = True
from drawing import BLUE, GREY, INK, RED, Drawing

HERE = os.path.dirname(os.path.abspath(__file__))
LEAST, MOST = 40, 210  # bits


def place(bits, part):
    return 60 + 560 * (bits - LEAST) / (MOST - LEAST), 250 - 210 * part


def draw_axes(drawing):
    drawing.lines([[place(LEAST, part), place(MOST, part)] for part in (0.25, 0.5, 0.75, 1)],
                  "#ddd")
    drawing.lines([[place(LEAST, 1), place(LEAST, 0), place(MOST, 0)]], GREY)
    for bits in range(50, MOST, 25):
        x, y = place(bits, 0)
        drawing.lines([[(x, y), (x, y + 5)]], GREY)
        drawing.text(x, y + 20, str(bits), 12)
    for percent in (0, 50, 100):
        x, y = place(LEAST, percent / 100)
        drawing.text(x - 8, y + 4, f"{percent} %", 12, INK, "end")
    drawing.text(*place(125, -0.18), "bits of all numbers", 13)
    drawing.text(60, 20, "metrics found", 13, INK, "start")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = json.load(file)["rows"]
    drawing = Drawing(660, 300)
    draw_axes(drawing)
    for powers, colour in ((20, BLUE), (30, INK)):
        points = [place(row["bits"], row["solved"] / row["sets"]) for row in rows
                  if row["powers"] == powers and row["method"] == "plain"]
        drawing.lines([points], colour, 1.6)
        drawing.dots(points, 3, colour)
        steep = next(p for p in points if p[1] < place(0, 0.4)[1])
        drawing.text(steep[0] - 14, 140, f"{powers} powers of ten", 13, colour, "end")
    ours = [row for row in rows if row["method"] != "plain"]
    part = sum(row["solved"] for row in ours) / sum(row["sets"] for row in ours)
    x, y = place(53, part)
    drawing.dots([(x, y)], 6, RED)
    drawing.text(x + 10, y + 18, "conformal_metric(),", 13, RED, "start")
    drawing.text(x + 10, y + 34, "doubles: 20 and 30", 13, RED, "start")
    drawing.write(os.path.join(HERE, "conformal_precision.svg"))


if __name__ == "__main__":
    main()
