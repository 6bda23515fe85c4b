# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes SVG. Points are pairs of pixels, y downwards; files have integers, quarters of pixels."""

INK, GREY, RED, BLUE = "#222", "#777", "#b3261e", "#1f5fa8"
UNIT = 4


def scaled(x):
    return f"{x * UNIT:g}"


def grid(p):
    return tuple(round(c * UNIT) for c in p)


def path(points, closed=False):
    """Steps are relative, which is short, and between rounded points, so that errors do not add up."""
    points = [grid(p) for p in points]
    d = "M%d %dl" % points[0]
    d += " ".join("%d %d" % (q[0] - p[0], q[1] - p[1]) for p, q in zip(points, points[1:]))
    return d.replace(" -", "-") + ("z" if closed else "")


class Drawing:
    def __init__(self, width, height):
        self.size, self.parts = (width, height), []

    def polygons(self, polygons, fill, stroke=None, width=0.4):
        """One path: polygons of one colour. The stroke of that colour hides seams."""
        if polygons:
            d = "".join(path(p, True) for p in polygons)
            self.parts.append(f'<path d="{d}" fill="{fill}" stroke="{stroke or fill}" '
                              f'stroke-width="{scaled(width)}"/>')

    def lines(self, lines, stroke=INK, width=1, dash=None, arrow=False):
        """One path; with arrows one path each, as markers are only put at the end of a path."""
        for line in lines if arrow and len(lines) > 1 else []:
            self.lines([line], stroke, width, dash, arrow)
        if lines and (not arrow or len(lines) == 1):
            d = "".join(path(p) for p in lines)
            more = f' stroke-dasharray="{dash}"' if dash else ""
            more += ' marker-end="url(#arrow)"' if arrow else ""
            self.parts.append(f'<path d="{d}" fill="none" stroke="{stroke}" '
                              f'stroke-width="{scaled(width)}"{more}/>')

    def dots(self, points, radius, fill=INK, stroke="none"):
        for p in points:
            self.parts.append('<circle cx="%d" cy="%d"' % grid(p) +
                              f' r="{scaled(radius)}" fill="{fill}" stroke="{stroke}"/>')

    def rectangle(self, x, y, width, height, fill, stroke=INK):
        x, y, width, height, radius = (scaled(v) for v in (x, y, width, height, 5))
        self.parts.append(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="{radius}" '
                          f'fill="{fill}" stroke="{stroke}" stroke-width="{scaled(1)}"/>')

    def text(self, x, y, text, size=14, fill=INK, anchor="middle", style=""):
        """Text, in which braces after `_` hold a subscript."""
        spans = ""
        for i, piece in enumerate(text.split("_{")):
            low, _, rest = piece.partition("}") if i else ("", "", piece)
            down = scaled(size * 0.25)
            if low:
                spans += f'<tspan dy="{down}" font-size="{scaled(size * 0.7)}">{low}</tspan>'
            spans += f'<tspan dy="-{down}">{rest or chr(0x200b)}</tspan>' if low else rest
        self.parts.append('<text x="%d" y="%d"' % grid((x, y)) +
                          f' font-size="{scaled(size)}" fill="{fill}" text-anchor="{anchor}" '
                          f'stroke="none" {style}>{spans}</text>')

    def write(self, file):
        w, h = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" '
                f'viewBox="0 0 {w * UNIT} {h * UNIT}" font-family="Helvetica, Arial, sans-serif" '
                'stroke-linecap="round" stroke-linejoin="round">\n'
                '<defs><marker id="arrow" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
                f'markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8Z" fill="{INK}" stroke="none"/>'
                f'</marker></defs>\n<rect width="{w * UNIT}" height="{h * UNIT}" fill="#fff"/>\n')
        with open(file, "w", encoding="utf-8") as out:
            out.write(head + "\n".join(self.parts) + "\n</svg>\n")
