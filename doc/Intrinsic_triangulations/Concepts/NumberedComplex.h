// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class NumberedComplex concepts.h <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
\cgalConcept

The concept `NumberedComplex` describes a triangulated surface with a metric, which algorithms read
by the numbers of its elements: a Delta-complex whose halfedges `2e` and `2e + 1` are the sides of
edge `e`.

Both triangulations of a surface, the input and the intrinsic one, have this interface. So the same
functions for geodesics, circumcenters and balls walk over either of them.

\cgalHasModel{\itc{Input}\,
\itc{Intrinsic_view}}

\cgalHeading{Types}

All elements are numbers of type `std::uint32_t`; \itc{Gluing::none} stands for no element. Values
are doubles in scaled units.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itc{Geodesic_face}, \itf{trace_geodesic} | `next`, `is_border`, `face`, `squared_length`, `quadruple_area` |
| \itf{vector_between} | as `Geodesic_face`, and `scale_exponent` |
| \itf{locate_circumcenter} | as `trace_geodesic()` |
| \itc{Constrained_segments} | `is_border`, `source`, `target`, `squared_length` |
| \itc{Tangent_frames} | also `number_of_halfedges`, which `Input` has |

\cgalHeading{Invariants}

Those of \ref ::MutableDeltaComplex on connectivity and of \ref ::EuclideanMetric on values.

\cgalHeading{Complexity}

Constant time for all functions.
*/
class NumberedComplex {
public:
  /// returns the halfedge after `h` in its face, or along the border.
  std::uint32_t next(std::uint32_t h) const;
  /// tells whether `h` has no face.
  bool is_border(std::uint32_t h) const;
  /// returns the face of `h`, or none.
  std::uint32_t face(std::uint32_t h) const;
  /// returns the vertex that `h` starts from.
  std::uint32_t source(std::uint32_t h) const;
  /// returns the vertex that `h` points to.
  std::uint32_t target(std::uint32_t h) const;
  /*!
  \brief returns a halfedge that starts at vertex `v`, the one whose right side is the border if
  there is one.
  \pre `v` is not isolated
  */
  std::uint32_t outgoing_halfedge(std::uint32_t v) const;
  /// returns the squared length of edge `e`.
  double squared_length(std::uint32_t e) const;
  /// returns four times the area of face `f`.
  double quadruple_area(std::uint32_t f) const;
  /// returns s, where lengths are 2^s times those in the units of the input.
  int scale_exponent() const;
};
