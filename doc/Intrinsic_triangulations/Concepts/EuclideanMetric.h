// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class EuclideanMetric metric_concepts.h <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>
\cgalConcept

The concept `EuclideanMetric` describes the store of a cone metric on a triangulation: one squared
length per edge, one quadruple area per face, and the predicates and constructions of moves on them.

Functions of triangulations that need lengths, areas or angles do not compile with another metric.

\cgalRefines{\ref ::IntrinsicMetric}

\cgalHasModel{\itc{Euclidean_metric}\,
\itc{Tolerant_metric}\,
\itc{Interval_metric}\,
\itc{Exact_euclidean_metric}}

\cgalHeading{Types}

Those of \ref ::IntrinsicMetric. A \itc{Vertex_star} or a \itc{Border_star} has the faces and edges
at a vertex. Values are in scaled units: lengths of the input times 2 to the power of
`scale_exponent()`.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | `is_degenerate`, `is_zero_length`, `approximate_squared_length` |
| \itf{check_delaunay}, `delaunay_sign()`, `flip_status()` | `sign` of a diamond |
| `compare_angle_to_pi()` | also `sign` of faces, `approximate_squared_length`, `approximate_quadruple_area` |
| `squared_length()` and `area()` of the triangulation | `approximate_squared_length`, `approximate_quadruple_area`, `scale_exponent` |
| `insert_vertex()`, `remove_vertex()` | also `compute_flip_to_zero_area`, and what \ref ::RefinableMetric adds |
| \itf{delaunay_refine} | also `sign` of faces |
| \itf{locate_on_input}, insertion with \itc{Integer_coordinates} and \itc{Explicit_crossings} | also `sign` of faces |
| \itf{cotangent_laplacian}, \itf{measure_quality} | `cotangent_weight` |

A metric that answers only what it is certain of has `certain_sign` in place of `sign`,
`stored_weight` in place of `cotangent_weight` of a diamond, and what its decider needs:
`enclosure`, `enclosures`, `is_narrow`, `refine`, `refine_length`, `remembered_signs` and
`statistics`, see \itc{Exact_euclidean_metric}.

\cgalHeading{Invariants}

- An edge is Delaunay if the angles opposite it sum to at most pi, and can be flipped if its diamond
  is strictly convex.
- Areas and squared lengths are not negative.
- The quadruple area of a face agrees with the squared lengths of its sides, up to the accuracy of
  `FT`.

\cgalHeading{Complexity}

As for \ref ::IntrinsicMetric.
*/
class EuclideanMetric {
public:
  /// Number type of the stored values.
  typedef unspecified_type FT;
  /*!
  \brief returns the sign of an expression in the values of a diamond.
  \tparam Expression a model of \ref ::DiamondExpression, such as \itc{Delaunay_expression}
  */
  template <class Expression>
  CGAL::Sign sign(const CGAL::Intrinsic_triangulations::Diamond& d,
                  const Expression& expression) const;
  /// The values that a flip makes.
  typedef unspecified_type Flipped;
  /*!
  \brief computes the values that a flip makes which leaves a face of zero area.
  \pre the diamond is a triangle with the source of the edge on a side
  */
  std::optional<Flipped>
  compute_flip_to_zero_area(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /*!
  \brief returns the sign of an expression in the values of faces.
  \tparam Expression a model of \ref ::FaceExpression
  */
  template <class Expression>
  CGAL::Sign sign(std::span<const CGAL::Intrinsic_triangulations::Indexed_face> faces,
                  const Expression& expression) const;
  /// tells whether the area of a face is zero.
  bool is_degenerate(std::uint32_t face) const;
  /// tells whether the length of an edge is zero.
  bool is_zero_length(std::uint32_t edge) const;
  /// returns the squared length of an edge.
  FT squared_length(std::uint32_t edge) const;
  /// returns four times the area of a face.
  FT quadruple_area(std::uint32_t face) const;
  /// returns a double near the squared length of an edge.
  double approximate_squared_length(std::uint32_t edge) const;
  /// returns a double near four times the area of a face.
  double approximate_quadruple_area(std::uint32_t face) const;

  /// returns half the sum of the cotangents of the angles opposite an edge between two faces.
  double cotangent_weight(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// returns half the cotangent of the angle opposite `ij` in a face with sides ij, jk and ki.
  double cotangent_weight(std::uint32_t ij, std::uint32_t jk, std::uint32_t ki,
                          std::uint32_t face) const;
};
