#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the table of the manual of what closed_forms wrote: closed_forms_table.py closed_forms.json"""

import json
import sys

COLUMNS = {"as_is": "as it is", "delaunay": "Delaunay", "refined": "refined to 30 degrees",
           "longer": "refined, 16 times as long"}
QUANTITIES = {"distance": ("distance", 100, " %"),
              "exact_logarithm": ("logarithm, exact", 100, " %"),
              "affine_logarithm": ("logarithm, affine", 100, " %"),
              "polar_logarithm": ("logarithm, polar", 100, " %"),
              "transport": ("transport", 1, " rad"), "eigenvalues": ("eigenvalues", 100, " %")}


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        results = json.load(file)
    print("| | surface |", " | ".join(COLUMNS.values()), "|")
    print("|---|---|" + "---|" * len(COLUMNS))
    for key, (name, factor, unit) in QUANTITIES.items():
        for shape, r in results.items():
            if key not in r["as_is"]:
                continue
            values = (factor * r[c][key] for c in COLUMNS)
            print(f"| {name} | {shape} |", " | ".join(f"{x:.2g}{unit}" for x in values), "|")


if __name__ == "__main__":
    main()
