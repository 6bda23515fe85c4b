#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that tests of units name what takes or returns lengths, areas or vectors.

The functions and classes are those of `doc/members.md`, without the topics of formulas, of
connectivity and of files, where a comment or a declaration speaks of such a thing. Each is named in
a test `test_units*.cpp`, or below with a reason why it is not. Fails if one is missing, and if a
reason is not needed any more.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "doc"))

import list_members  # noqa: E402

# What a function that has units speaks of; of classes, it is what members say.
OF_FUNCTIONS = re.compile(r"\b(lengths?|areas?|distances?|radius|circumradius|vectors?|units?|"
                          r"times?|tolerance|energy|logarithms?|points? in space)\b")
OF_CLASSES = re.compile(r"\bunits? of (the (input|mesh)|area|length)\b")
OTHER_TOPICS = {"ref_formulas", "ref_connectivity", "ref_io"}
COSTS = re.compile(r"\\(complexity|throws|cgalModels)[^\\]*")

# Names by the reason why no test of units has them.
LEFT_OUT = {
    "a result of functions that are called":
        "Bezier_curve Certificate_on_faces Farthest_points Geodesic_tree Shortest_path",
    "the units of the visitor's caller, which are those of the result":
        "Polyhedral_distance_visitor",
    "reported only where rounding has spoilt a triangulation": "Inaccuracy",
    "an option or a report of functions that are called": "Distance_options Vector_options",
    "tells edges, faces, vertices, or signs, which have no units":
        "bent_edges certify_delaunay certify_geodesic certify_map certify_on_faces "
        "components_of_matrix constrained_input_edges cut_open cut_to_disk cut_to_disks "
        "cut_to_round_disk delaunay_tessellation face_locations "
        "faces_violating_triangle_inequality homology_generators insert_curves insert_place "
        "insert_places insert_point_on_sheets intrinsic_face_colors restore_input_edges "
        "rows_with_constant_kernel shorten_curves singularities triangles_at_points",
    "counts rows": "solver_for",
    "a map that the user gives, in any units": "certified_map pack_components",
    "takes what the user gives to other elements, in its units":
        "corner_coordinates definition_of directions_along_path even_levels fields_of_layout "
        "for_each_subdivision_triangle smallest_eigenpairs values_at_corners values_at_vertices",
    "a hyperbolic plane and a sphere have a unit of their own":
        "hyperbolic_metric hyperbolic_surface lay_out_in_disk lay_out_on_sphere",
    "a step of `uniformize()`": "place_cones_within scaled_surface",
    "compares two surfaces, and its test scales one of them": "find_isometries",
    "about memory": "reserve_at_least",
    "builds a triangulation, whose functions are called": "delaunay_triangulation",
}


def bodies():
    """The names of members, and the text to search for words about units."""
    groups = list_members.groups_of_names()
    topics = {name for name, _, _ in list_members.topics()} - OTHER_TOPICS
    for header in sorted(list_members.INCLUDE.rglob("*.h")):
        if list_members.topic_of(header, groups) not in topics:
            continue
        text = list_members.INTERNAL.sub("", header.read_text(encoding="utf-8"))
        entities = list(list_members.ENTITY.finditer(text))
        for found, after in zip(entities, [*entities[1:], None]):
            comment = "".join(found.groups(""))
            declaration = list_members.without_template(text[found.end():])
            head = re.split("[{;]", declaration, maxsplit=1)[0]
            name = list_members.name_of(head)
            if not name or "\\cond" in comment:
                continue
            if name.endswith("()"):
                yield name, OF_FUNCTIONS.search(COSTS.sub("", comment) + head)
            else:
                body = text[found.start():after.start() if after else len(text)]
                yield name, OF_CLASSES.search(COSTS.sub("", body))


def errors():
    has_units = {name.removesuffix("()") for name, found in bodies() if found}
    tests = "".join(p.read_text(encoding="utf-8")
                    for p in (ROOT / "test").glob("Intrinsic_*/**/test_units*.cpp"))
    called = {name for name in has_units if re.search(rf"\b{name}\b", tests)}
    left_out = {name for names in LEFT_OUT.values() for name in names.split()}
    for name in sorted(has_units - called - left_out):
        yield f"no test of units calls {name}: add it to test_units.cpp, or say why not"
    for name in sorted(left_out - has_units | left_out & called):
        yield f"{name} has no units, or a test of them: it need not be left out"


if __name__ == "__main__":
    found = list(errors())
    print("\n".join(found), file=sys.stderr)
    sys.exit(1 if found else 0)
