#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the tables of the manual of what heat_accuracy wrote: heat_accuracy_table.py heat_accuracy.json"""

import json
import sys

COLUMNS = ["as_is", "delaunay", "by_angle", "by_size"]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        results = json.load(file)
    print("| mesh | vertices | as it is | Delaunay | times smaller | refined to 25 degrees | and by size | vertices | times smaller |")
    print("|---|---|---|---|---|---|---|---|---|")
    models = sorted(results.items(), key=lambda item: -item[1]["as_is"]["mean"])
    for name, r in models:
        mean = {c: r[c]["mean"] for c in COLUMNS}
        percent = {c: f"{100 * mean[c]:.2f} %" for c in COLUMNS}
        print(f"| {name} | {r['as_is']['vertices']} | {percent['as_is']} | {percent['delaunay']} "
              f"| {mean['as_is'] / mean['delaunay']:.1f} | {percent['by_angle']} | {percent['by_size']} "
              f"| {r['by_size']['vertices']} | {mean['as_is'] / mean['by_size']:.1f} |")
    print("\n| mesh | mean: Delaunay | at the source | near: as it is | Delaunay | at the source | by size |")
    print("|---|---|---|---|---|---|---|")
    for name, r in models:
        numbers = [r["delaunay"]["mean"], r["at_source"]["mean"],
                   *(r[c]["near"] for c in ("as_is", "delaunay", "at_source", "by_size"))]
        print(f"| {name} | " + " | ".join(f"{100 * x:.2f} %" for x in numbers) + " |")


if __name__ == "__main__":
    main()
