#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes `flip_counts.svg` beside itself from the output of the benchmark `flip_counts`, and prints
the table of the manual: make_flip_figure.py FLIP_COUNTS.json. Needs only Python 3."""
import json
import math
import os
import sys

sys.dont_write_bytecode = True
from drawing import GREY, INK, Drawing

HERE = os.path.dirname(os.path.abspath(__file__))
ORDERS = ("as they come", "queue", "longest first")
COLOURS = ("#1f5fa8", "#b3261e", "#2e7d32", "#e08a00", "#6a3d9a", "#008b8b", "#8c564b", "#d147a3",
           "#222222")
FACES, FLIPS = (2.3, 4.4), (-1.2, 3)  # powers of ten: of faces, of flips per face
WIDTH, HEIGHT = 190, 260


def place(panel, faces, flips):
    x = (math.log10(faces) - FACES[0]) / (FACES[1] - FACES[0])
    y = (math.log10(flips / faces) - FLIPS[0]) / (FLIPS[1] - FLIPS[0])
    return 55 + panel * (WIDTH + 25) + WIDTH * x, 40 + HEIGHT * (1 - y)


def axes(drawing, panel, order):
    for power in range(-1, 4):
        faces = [10**FACES[0], 10**FACES[1]]
        ends = [place(panel, n, n * 10.**power) for n in faces]
        drawing.lines([ends], "#ddd")
        if panel == 0:
            drawing.text(ends[0][0] - 8, ends[0][1] + 4, f"{10.**power:g}", 12, INK, "end")
    for faces in (1000, 10000):
        x = place(panel, faces, faces)[0]
        drawing.lines([[(x, 40 + HEIGHT), (x, 45 + HEIGHT)]], GREY)
        drawing.text(x, 60 + HEIGHT, f"{faces:,}", 12)
    left = place(panel, 10**FACES[0], 1)[0]
    drawing.lines([[(left, 40), (left, 40 + HEIGHT), (left + WIDTH, 40 + HEIGHT)]], GREY)
    drawing.text(left + WIDTH / 2, 28, order, 13)


def legend(drawing, families):
    for i, family in enumerate(families):
        x, y = 60 + i % 3 * 220, 105 + HEIGHT + 20 * (i // 3)
        drawing.lines([[(x, y), (x + 22, y)]], COLOURS[i], 2)
        drawing.text(x + 28, y + 4, family["name"], 12, INK, "start")


def table(families):
    print("| family | faces | " + " | ".join(f"{o}: flips, exponent" for o in ORDERS) + " |")
    print("|---|---|" + "---|" * len(ORDERS))
    for family in families:
        last = family["rows"][-1]
        cells = [f"{last[o]:,}, {family['exponent'][o]:.2f}" for o in ORDERS]
        print(f"| {family['name']} | {last['size']:,.0f} | " + " | ".join(cells) + " |")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        families = json.load(file)["families"]
    drawn = [f for f in families if f["size"] == "faces"]
    table(drawn)
    drawing = Drawing(55 + 3 * WIDTH + 85, 165 + HEIGHT)
    for panel, order in enumerate(ORDERS):
        axes(drawing, panel, order)
        for family, colour in zip(drawn, COLOURS):
            points = [place(panel, row["size"], row[order]) for row in family["rows"]]
            drawing.lines([points], colour, 1.6)
            drawing.dots(points, 2.2, colour)
    drawing.text(8, 14, "flips per face", 13, INK, "start")
    drawing.text(place(1, 10**(sum(FACES) / 2), 1)[0], 78 + HEIGHT, "faces", 13)
    legend(drawing, drawn)
    drawing.write(os.path.join(HERE, "flip_counts.svg"))


if __name__ == "__main__":
    main()
