// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicMetric concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IntrinsicMetric` describes the store of a cone metric on a triangulation: one squared
length per edge, one quadruple area per face, and the predicates and constructions of moves on them.

Algorithms call the metric for everything that must be right, with numbers of edges and faces. So
they do not depend on the number type.

\cgalRefines{`DefaultConstructible`\, `MoveConstructible` and `MoveAssignable` of the C++ standard;
also copyable\, if triangulations are to be copied}

\cgalHasModel{\itc{Euclidean_metric}\,
\itc{Tolerant_metric}\,
\itc{Interval_metric}\,
\itc{Exact_euclidean_metric}}

\cgalHeading{Types}

`FT`, `Scope` and `Flipped`, below. Numbers from 0 name edges and faces; flips do not change them. A
\itc{Diamond} has the faces and edges at an edge, a \itc{Vertex_star} or a \itc{Border_star} those
at a vertex. Values are in scaled units: lengths of the input times 2 to the power of
`scale_exponent()`.

Predicates and all functions that read are const. Caches and counters of a metric are not part of
its value.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | constructors, `is_degenerate`, `is_zero_length`, `approximate_squared_length` |
| `is_locally_delaunay()`, \itf{flip_to_delaunay} | `is_locally_delaunay`, `compute_flip`, `store_flip`, `is_exact` |
| \itf{is_delaunay} | `is_locally_delaunay` |
| \itf{check_delaunay}, `delaunay_sign()`, `flip_status()` | `sign` of a diamond |
| `flip_edge()` | also `compute_flip`, `store_flip` |
| `undo_flip()`, \itc{Flip_log} | also `before_flip`, `undo_flip` |
| `compare_angle_to_pi()` | also `sign` of faces, `approximate_squared_length`, `approximate_quadruple_area` |
| `squared_length()` and `area()` of the triangulation | `approximate_squared_length`, `approximate_quadruple_area`, `scale_exponent` |
| `insert_vertex()`, `remove_vertex()` | also `compute_flip_to_zero_area`, and what \ref ::RefinableMetric adds |
| \itf{delaunay_refine} | also `sign` of faces |
| \itf{locate_on_input}, insertion with \itc{Integer_coordinates} and \itc{Explicit_crossings} | also `sign` of faces |
| \itf{cotangent_laplacian}, \itf{measure_quality} | `cotangent_weight` |

A metric decides alone, or by the input. A metric that decides by the input takes one more argument
in `is_locally_delaunay`, `sign` and `cotangent_weight`: the triangulation that owns it passes an
object with exact values. \itc{Exact_euclidean_metric} does this.

The C++20 concept has the requirements of flips and Laplacians; \ref ::RefinableMetric has those of
moves of vertices.

\cgalHeading{Invariants}

- Areas and squared lengths are not negative.
- The quadruple area of a face agrees with the squared lengths of its sides, up to the accuracy of
  `FT`.
- If `is_exact`, predicates decide on the exact values, and `compute_flip()` never refuses.
- If `is_locally_delaunay()` is false and a flip is stored, it is true for the flipped edge.
  Otherwise the test could fail after the last flip.

\cgalHeading{Complexity}

Constructors are linear. Everything else takes constant time, except that an exact
metric may need time for a decision that depends on how many input triangles a diamond lies over.
*/
class IntrinsicMetric {
public:
  /// Number type of the stored values.
  typedef unspecified_type FT;
  /// Default constructible; lives around every use of the metric, and may set the rounding mode.
  typedef unspecified_type Scope;
  /// Whether predicates are exact, so that flipping to Delaunay ends without a cap.
  static constexpr bool is_exact;

  /// constructs an empty metric.
  IntrinsicMetric();
  /*!
  \brief evaluates the input.
  \param mesh the connectivity
  \param input what defines the values of the edges and faces of `mesh`
  \throws CGAL::Intrinsic_triangulations::Invalid_input naming a face that breaks the triangle
    inequality, or for which `FT` cannot represent the area
  */
  IntrinsicMetric(const CGAL::Intrinsic_triangulations::Gluing_map& mesh,
                  const CGAL::Intrinsic_triangulations::Input_metric& input);

  /// tells whether the angles opposite the edge sum to at most pi; true for ties.
  bool is_locally_delaunay(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /*!
  \brief returns the sign of an expression in the values of a diamond.
  \tparam Expression a model of the C++20 concept \itc{DiamondExpression}: a functor with a template
    `operator()(const Diamond_values<Number>&)` that uses field operations only, such as
    \itc{Delaunay_expression},
    \itc{Convexity_at_source_expression}, \itc{Convexity_at_target_expression}
  */
  template <class Expression>
  CGAL::Sign sign(const CGAL::Intrinsic_triangulations::Diamond& d,
                  const Expression& expression) const;
  /// The values that a flip makes.
  typedef unspecified_type Flipped;
  /*!
  \brief computes the values that a flip makes; nothing changes.
  \return the values; nothing if the number type yields an area that is not positive
  \pre the diamond is strictly convex
  */
  std::optional<Flipped> compute_flip(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /*!
  \brief computes the values that a flip makes which leaves a face of zero area.
  \pre the diamond is a triangle with the source of the edge on a side
  */
  std::optional<Flipped>
  compute_flip_to_zero_area(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// stores the values that a flip makes, under the numbers that were there before.
  void store_flip(const CGAL::Intrinsic_triangulations::Diamond& d, const Flipped& values);

  /*!
  \brief returns the sign of an expression in the values of faces.
  \tparam Expression a model of the C++20 concept \itc{FaceExpression}: a functor with a template
    `operator()(std::span<const Face_values<Number>>)` that uses field operations only
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
  /// returns the exponent of the power of two that lengths are scaled by.
  int scale_exponent() const;

  /// returns half the sum of the cotangents of the angles opposite an edge between two faces.
  double cotangent_weight(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// returns half the cotangent of the angle opposite `ij` in a face with sides ij, jk and ki.
  double cotangent_weight(std::uint32_t ij, std::uint32_t jk, std::uint32_t ki,
                          std::uint32_t face) const;
};
