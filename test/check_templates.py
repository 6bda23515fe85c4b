#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that public templates say in their heads what they ask for.

Reads all headers and lists the documented templates outside of classes and of namespaces `internal`
that have a type parameter without a concept: `class T`, where no requires-clause names `T`. A
parameter that is documented as "any type" needs none. Fails for a template that is not in ALLOWED,
and for one in ALLOWED that is not needed any more.
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Templates without a concept today: header, below CGAL/, and the names. Shrinks only. Those of `Mesh_adaptor.h` are
# specialised by users; those of `triangulation/` are named before their arguments are complete.
ALLOWED = {
    "Intrinsic_geodesics/bezier/bezier_point.h": [
        "bezier_point: Triangulation",
    ],
    "Intrinsic_geodesics/bezier/make_bezier_curve.h": [
        "Bezier_curve: Triangulation",
    ],
    "Intrinsic_geodesics/curves/Curve_network.h": [
        "Curve_network: Triangulation",
    ],
    "Intrinsic_geodesics/curves/Edge_path_finder.h": [
        "Edge_path_finder: Triangulation",
    ],
    "Intrinsic_geodesics/curves/add_marked_edges.h": [
        "add_marked_edges: EdgeIsMarked",
    ],
    "Intrinsic_geodesics/curves/curve_labels.h": [
        "curve_labels: Triangulation",
    ],
    "Intrinsic_geodesics/curves/insert_point.h": [
        "Vertex_at_point: Triangulation",
    ],
    "Intrinsic_geodesics/curves/insert_polyline.h": [
        "Inserted_polyline: Triangulation",
    ],
    "Intrinsic_geodesics/curves/insert_traced_path.h": [
        "Inserted_path: Triangulation",
    ],
    "Intrinsic_geodesics/queries/Geodesic_finder.h": [
        "Geodesic_finder: Triangulation",
    ],
    "Intrinsic_geodesics/queries/add_geodesics.h": [
        "Added_geodesics: Triangulation",
        "Curve_through_vertices: Triangulation",
    ],
    "Intrinsic_geodesics/queries/insert_geodesic.h": [
        "Inserted_geodesic: Triangulation",
    ],
    "Intrinsic_geodesics/queries/trace_curve.h": [
        "face_locations: Mesh",
        "polyline: Mesh",
        "trace_curve: HalfedgeRange",
    ],
    "Intrinsic_geodesics/queries/trace_shortest_path.h": [
        "polyline: Mesh",
    ],
    "Intrinsic_geodesics/shortening/certify_geodesic.h": [
        "certify_geodesic: Traits",
    ],
    "Intrinsic_geodesics/single_source/Geodesic_tree.h": [
        "Geodesic_tree: Triangulation",
    ],
    "Intrinsic_operators/operators/subdivision_matrices.h": [
        "for_each_subdivision_triangle: Function",
        "for_each_subdivision_triangle: Triangulation",
    ],
    "Intrinsic_operators/operators/transfer.h": [
        "copy_to_input: Derived",
        "copy_to_intrinsic: Derived",
    ],
    "Intrinsic_operators/solvers/Cholesky_factorization.h": [
        "Cholesky_factorization: Scalar",
    ],
    "Intrinsic_operators/solvers/components_of_matrix.h": [
        "components_of_matrix: Scalar",
    ],
    "Intrinsic_operators/vectors/field_singularities.h": [
        "Field_singularities: Triangulation",
    ],
    "Intrinsic_operators/vectors/principal_directions.h": [
        "principal_directions: Mesh",
    ],
    "Intrinsic_triangulation.h": [
        "Intrinsic_triangulation: Correspondence_",
    ],
    "Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h": [
        "Indexed_mesh_adaptor: Mesh",
        "Mesh_adaptor: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/Intrinsic_view.h": [
        "Intrinsic_view: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/curves/Edge_crossings.h": [
        "crossing_parameters: Triangulation",
        "edge_crossings: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h": [
        "find_curve: View",
    ],
    "Intrinsic_triangulations/correspondence/curves/Unfolded_face.h": [
        "Unfolded_face: FT",
    ],
    "Intrinsic_triangulations/correspondence/curves/normal_coordinates.h": [
        "corner_coordinates: Complex",
        "corner_coordinates: Coordinates",
        "first_crossing: Complex",
        "first_crossing: Coordinates",
        "follow_curve: Complex",
        "follow_curve: Coordinates",
        "follow_curve: Visit",
        "follow_curves: Complex",
        "follow_curves: Coordinates",
        "follow_curves: Visit",
    ],
    "Intrinsic_triangulations/correspondence/curves/points_on_input.h": [
        "corner_on_input: View",
        "location_on_side: View",
        "parameter_on_halfedge: Coordinates",
        "vector_between: Input",
    ],
    "Intrinsic_triangulations/correspondence/models/Integer_geometry.h": [
        "Integer_geometry: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/models/check_coordinates.h": [
        "first_inconsistent_edge: Coordinates",
        "first_inconsistent_edge: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/models/check_curves.h": [
        "first_inconsistent_edge: Coordinates",
        "first_inconsistent_edge: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/models/follow_signposts.h": [
        "trace_edges: Signposts",
        "trace_edges: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/models/signpost_coordinates.h": [
        "integer_coordinates: Signposts",
        "integer_coordinates: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/queries/Curve_queries.h": [
        "Curve_queries: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h": [
        "Marked_edges: Mark",
        "constrained_input_edges: EdgeIsConstrained",
        "constrained_input_edges: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/queries/locate.h": [
        "locate_on_input: Mesh",
        "locate_on_intrinsic: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/queries/places_on_mesh.h": [
        "Face_location: Mesh",
        "face_location: Mesh",
        "place_in_face: Mesh",
        "point_in_space: Mesh",
        "surface_point: Mesh",
        "vertex_on_intrinsic: Mesh",
        "weights_in_face: Face",
    ],
    "Intrinsic_triangulations/correspondence/queries/tangent_field.h": [
        "tangent_field_to_input: Mesh",
        "tangent_field_to_intrinsic: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/queries/trace_edge.h": [
        "polyline: Mesh",
        "trace_input_edge: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/queries/vector_field.h": [
        "vectors_in_space: Mesh",
    ],
    "Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h": [
        "weighted_vertices: Triangulation",
    ],
    "Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h": [
        "for_each_subdivision_edge: Visitor",
    ],
    "Intrinsic_triangulations/exact/Input_face_intervals.h": [
        "Input_face_intervals: FT",
    ],
    "Intrinsic_triangulations/exact/numbers/Ball.h": [
        "Ball: Center",
    ],
    "Intrinsic_triangulations/exact/numbers/Complex_ball.h": [
        "Complex_ball: FT",
    ],
    "Intrinsic_triangulations/exact/numbers/nearest_double.h": [
        "nearest_double: Center",
    ],
    "Intrinsic_triangulations/exact/proofs/Question.h": [
        "Question: Expression",
        "Question: Expression_",
        "Question: Figure",
        "Question: Figure_",
    ],
    "Intrinsic_triangulations/exact/unfolding/Input_side_values.h": [
        "Input_side_values: FT",
    ],
    "Intrinsic_triangulations/formulas/Development.h": [
        "Development: Side_",
    ],
    "Intrinsic_triangulations/formulas/Diamond.h": [
        "Diamond_values: FT",
        "Flipped_values: FT",
        "consistent_corner: FT",
        "cotangent_weight: FT",
        "flipped: FT",
        "flipped_area_error: FT",
        "flipped_consistently: FT",
        "left_cotangent_numerator: FT",
        "right_cotangent_numerator: FT",
    ],
    "Intrinsic_triangulations/formulas/Face_values.h": [
        "Face_values: FT",
        "diamond_values: FT",
    ],
    "Intrinsic_triangulations/formulas/Plane_vector.h": [
        "Plane_vector: FT",
    ],
    "Intrinsic_triangulations/formulas/Vertex_star.h": [
        "Vertex_move_values: FT",
        "Whole_star_values: FT",
        "moved_in_star: FT",
        "removed_from_border_edge: FT",
        "removed_from_face: FT",
        "squared_distance_from_corner: FT",
    ],
    "Intrinsic_triangulations/formulas/apex.h": [
        "apex: FT",
        "scaled_corner: FT",
    ],
    "Intrinsic_triangulations/formulas/triangle_formulas.h": [
        "angle_defect: Angles",
        "boundary_geodesic_curvature: Angles",
        "squared_quadruple_area: FT",
        "twice_inner_product: FT",
    ],
    "Intrinsic_triangulations/metric/Euclidean_traits.h": [
        "Euclidean_metric: FT_",
        "Euclidean_traits: FT_",
    ],
    "Intrinsic_triangulations/metric/Tolerant_traits.h": [
        "Tolerant_metric: FT_",
        "Tolerant_metric: Tolerance",
        "Tolerant_traits: FT_",
        "Tolerant_traits: Tolerance",
    ],
    "Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h": [
        "certify_delaunay: Traits",
    ],
    "Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h": [
        "measure_quality: Is_tie",
    ],
    "Intrinsic_triangulations/retriangulation/segments/Flip_log.h": [
        "Flip_log: Triangulation",
    ],
    "Intrinsic_triangulations/tracing/common_face.h": [
        "seen_from: Input",
    ],
    "Intrinsic_triangulations/tracing/geodesic_face.h": [
        "apex_above_side: Complex",
        "approximate_values: Complex",
        "sides_of_face: Complex",
        "squared_lengths_of_face: Complex",
    ],
    "Intrinsic_triangulations/triangulation/Metric_values.h": [
        "Metric_values: Mesh",
        "Metric_values: Metric",
        "Metric_values: Triangulation",
    ],
    "Intrinsic_triangulations/triangulation/Session.h": [
        "Move_session: Triangulation",
        "Predicate_session: Triangulation",
    ],
}


def closing(text, start, pair):
    """Returns the place after the bracket that closes the one at `start`."""
    depth = 0
    for place in range(start, len(text)):
        depth += {pair[0]: 1, pair[1]: -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise ValueError(f"{pair[0]} is not closed")


def split_parameters(text):
    """Splits at commas outside of brackets."""
    parts, depth = [""], 0
    for char in text:
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(char, 0)
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts]


def without_comments(text):
    """Blanks comments and strings, so that places stay; returns that and the ends of doc comments."""
    docs = {}

    def blank(match):
        if match[0].startswith(("/*!", "///")):
            docs[match.end()] = match[0]
        return re.sub(r"[^\n]", " ", match[0])

    pattern = r'/\*.*?\*/|//[^\n]*|"(?:[^"\\\n]|\\.)*"|^#(?:[^\n]*\\\n)*[^\n]*'
    return re.sub(pattern, blank, text, flags=re.DOTALL | re.MULTILINE), docs


def scopes(text):
    """Yields place and brace: the names of the scopes around each template at namespace scope."""
    stack, last = [], 0
    for match in re.finditer(r"[{};]|\btemplate\s*<", text):
        if match[0] == "{":
            head = text[last:match.start()].strip()
            name = re.fullmatch(r"(?:inline )?namespace ([\w:]*)", head)
            stack.append(name[1] if name else None)
        elif match[0] == "}":
            stack.pop()
        elif match[0].startswith("template") and None not in stack:
            yield match.start(), "::".join(stack)
        if match[0] in "{};":
            last = match.end()


def doc_before(docs, text, place):
    """Returns the doc comment that ends before a place, with nothing in between."""
    ends = [end for end in docs if end <= place and not text[end:place].strip()]
    if not ends:
        return None
    end = max(ends)
    earlier = doc_before({e: d for e, d in docs.items() if e < end}, text, end - len(docs[end]))
    return (earlier or "") + docs[end]


def end_of_declaration(text, place):
    """Returns the place of the body or semicolon of a declaration; requires-expressions have braces, too."""
    begin = place
    while text[place] != ";":
        if text[place] == "(":
            place = closing(text, place, "()")
        elif text[place] != "{":
            place += 1
        elif re.search(r"\brequires\s*(\((?:[^()]|\([^()]*\))*\))?\s*$", text[begin:place]):
            place = closing(text, place, "{}")
        else:
            break
    return place


def declared(text, place):
    """Returns the parameters of a template, its declaration up to body or semicolon, and its name."""
    begin = text.index("<", place)
    end = closing(text, begin, "<>")
    declaration = text[end:end_of_declaration(text, end)]
    name = re.search(r"(?:class|struct)\s+(\w+)|([\w~]+|operator\S+)\s*(?=\(|=)",
                     re.sub(r"requires\s*\((?:[^()]|\([^()]*\))*\)", " ", declaration))
    return (text[begin + 1:end - 1], declaration,
            next(filter(None, name.groups()), "?") if name else "?")


def unconstrained(text):
    """Yields the names of documented free templates with a parameter without a concept."""
    code, docs = without_comments(text)
    for place, scope in scopes(code):
        doc = doc_before(docs, code, place)
        if doc is None or "internal" in scope or "\\cond" in doc:
            continue
        parameters, declaration, name = declared(code, place)
        if re.match(r"\s*concept\b", declaration):
            continue
        requires = declaration.partition("requires")[2]
        is_specialisation = re.match(r"[^({]*\b(?:class|struct)\s+\w+\s*<", declaration)
        for parameter in split_parameters(parameters):
            bare = re.match(r"(?:class|typename)\b\s*(?:\.\.\.)?\s*(\w+)", parameter)
            if not bare or is_specialisation or re.search(rf"\b{bare[1]}\b", requires):
                continue
            if not re.search(rf"\\tparam {bare[1]} any type", doc):
                yield f"{name}: {bare[1]}"


def check(include):
    """Yields all that is wrong with the headers below the directory `include`."""
    found = {}
    for path in sorted(include.rglob("*.h")):
        header = path.relative_to(include).as_posix().removeprefix("CGAL/")
        found[header] = set(unconstrained(path.read_text()))
    for header, names in found.items():
        for name in sorted(names - set(ALLOWED.get(header, ()))):
            yield f"{header}: {name} needs a concept"
    for header, names in ALLOWED.items():
        for name in sorted(set(names) - found.get(header, set())):
            yield f"check_templates.py allows {header}: {name}, which is not needed any more: remove it"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--include", type=pathlib.Path, default=ROOT / "include",
                        help="directory of the headers; default: that of this project")
    errors = list(check(parser.parse_args().include))
    for error in errors:
        print(error, file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
