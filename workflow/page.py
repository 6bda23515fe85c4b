# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pages of results are made of: texts, tables, files that are never half."""

import argparse
import html
import math
import os
import re
import tempfile

import pandas

from failure import Failure

_HEAD = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@title@</title>
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
UNKNOWN = "\u2013"


def grouped(n):
    """A number with commas between groups of three digits; a dash if it is not known."""
    return UNKNOWN if n is None or math.isnan(n) else f"{int(n):,}".replace("-", "\u2212")


def plural(n, one, many):
    return f"{grouped(n)} {one if n == 1 else many}"


def short(x, digits=3):
    """A number with some significant digits, such as 0.0123 or 3.1e-12; a dash if not known."""
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
                                                                justify="unset", na_rep=UNKNOWN)
        text = re.sub("<table [^>]*>", "<table>", text)
        return f'<div class="wide {classes}">{text}</div>\n'.replace(' ">', '">')
    if len(rows) <= shown + 5:  # folding away a few rows hides more than it saves
        return part(rows)
    return part(rows[:shown]) + details(f"{len(rows) - shown} more", part(rows[shown:]))


def page(title, *parts):
    """A page of parts, which are HTML."""
    return "".join([_HEAD.replace("@title@", html.escape(title)), *parts, "</body>\n</html>\n"])


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
