// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class CurveCoordinates Vertex_fans.h <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
\cgalConcept

The concept `CurveCoordinates` describes a correspondence that stores, as integers, how the input's
edges run over the intrinsic triangulation: they are *curves* on it (§3.5 of the course).

All queries about places on the other triangulation need only this concept. \itc{Signposts} is not a
model, but \itf{integer_coordinates} makes one from it by tracing. Tracing may fail; then the
function says so.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{Integer_coordinates}\,
\itc{Explicit_crossings}}

\cgalHeading{Types}

\itc{Normal_coordinate}, a signed integer. Numbers name elements.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{follow_curve}, \itf{corner_coordinates} | `normal_coordinate` |
| \itf{edge_crossings} | also `number_of_edges` |
| \itf{trace_edge} | `input`, `normal_coordinate`; the list of crossings, if there is one |
| \itf{common_subdivision}, \itf{locate_on_input}, \itf{locate_on_intrinsic} | all |
| \itf{tangent_to_input}, \itf{tangent_to_intrinsic} | `input`, `fans`, `normal_coordinate`, `roundabout` |
| \itc{Face_vector_transfer} | `input` |

\cgalHeading{Invariants}

- In every face the normal coordinates of the sides are those of curves that do not cross each other
  and do not turn back: the corner coordinates of Eq. 9 and 10 of the course are nonnegative
  integers.
- An edge along which a curve runs has coordinate -1, and no curve crosses it.
- Roundabouts of the halfedges about a vertex of the input are in the order of its curves.

\cgalHeading{Complexity}

Constant time for all functions.

The C++20 concept does not require the observer of moves; the triangulation that owns the model does.
*/
class CurveCoordinates {
public:
  /// returns the triangulation that the intrinsic one started from.
  const CGAL::Intrinsic_triangulations::Input& input() const;
  /// returns the numbering of the curves that start from each vertex.
  const CGAL::Intrinsic_triangulations::Vertex_fans& fans() const;
  /// returns a bound of the numbers of intrinsic edges.
  std::uint32_t number_of_edges() const;
  /// returns how many curves cross an intrinsic edge; -1 if one runs along it.
  CGAL::Intrinsic_triangulations::Normal_coordinate normal_coordinate(std::uint32_t edge) const;
  /// returns the slot in `fans()` of the first curve counterclockwise from an intrinsic halfedge,
  /// itself included.
  std::uint32_t roundabout(std::uint32_t halfedge) const;
  /// tells whether a vertex was inserted.
  bool is_inserted(std::uint32_t vertex) const;
  /// returns where an inserted vertex is on the input.
  const CGAL::Intrinsic_triangulations::Surface_point&
  location(std::uint32_t inserted_vertex) const;
};
