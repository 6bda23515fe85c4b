// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicMetric metric_concepts.h <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>
\cgalConcept

The concept `IntrinsicMetric` describes the store of a metric on a triangulation, as far as flips
need it: it decides whether an edge is Delaunay and whether it can be flipped, or answers if it is
certain, and computes and stores the values that a flip makes. \ref ::EuclideanMetric adds lengths,
areas and angles.

Algorithms ask the triangulation for everything that must be right, and it asks the metric or its
decider, with numbers of edges and faces. So they depend neither on the number type nor on the
geometry.

\cgalRefines{`DefaultConstructible`\, `MoveConstructible` and `MoveAssignable` of the C++ standard;
also copyable\, if triangulations are to be copied}

\cgalHasModel{\itc{Ideal_hyperbolic_metric}\, \itc{Exact_ideal_hyperbolic_metric}\, \itc{Integer_only_metric}\, and all models of \ref ::EuclideanMetric}

\cgalHeading{Types}

`FT`, `Scope` and `Flipped`, below. Numbers from 0 name edges and faces; flips do not change them. A
\itc{Diamond} has the faces and edges at an edge.

Predicates and all functions that read are const. Caches and counters of a metric are not part of
its value.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | constructors |
| `is_locally_delaunay()`, \itf{flip_to_delaunay} | `is_locally_delaunay`, `compute_flip`, `store_flip`, `is_exact` |
| \itf{is_delaunay} | `is_locally_delaunay` |
| \itf{check_delaunay}, \itf{delaunay_tessellation}, `delaunay_sign()` | `delaunay_sign` |
| `flip_status()` | `is_flippable` |
| `flip_edge()` | also `compute_flip`, `store_flip` |
| `undo_flip()`, \itc{Flip_log} | also `before_flip` |
| `scale_vertices()` | `set_factors`, `scale` |

A model of \ref ::EuclideanMetric has `sign` in place of `delaunay_sign` and `is_flippable`.

A metric decides alone, or answers only what it is certain of. Such a metric has `certain_delaunay`
in place of `is_locally_delaunay`, `delaunay_sign` and `is_flippable`. The triangulation that owns it
has a decider, which asks the metric first, decides the rest from the input, and hands better
enclosures of the stored values back. \itc{Exact_euclidean_metric},
\itc{Exact_ideal_hyperbolic_metric} and \itc{Integer_only_metric}, which stores nothing, are such
metrics; the deciders are parts of the package, one for each kind of store.

\cgalHeading{Invariants}

- If `is_exact`, predicates decide on the exact values, and `compute_flip()` never refuses.
- If `is_locally_delaunay()` is false, or `certain_delaunay()` is `no`, the edge can be flipped. If the flip is stored,
  `is_locally_delaunay()` is true for the flipped edge. Otherwise the test could fail after the last
  flip.

\cgalHeading{Complexity}

Constructors are linear. Everything else takes constant time. A decider may need time that depends
on how many input triangles a diamond lies over.
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
  \throws CGAL::Intrinsic_triangulations::Invalid_input naming an element whose values are no such
    metric, or which `FT` cannot represent
  */
  IntrinsicMetric(const CGAL::Intrinsic_triangulations::Gluing_map& mesh,
                  const CGAL::Intrinsic_triangulations::Input_metric& input);

  /// tells whether an edge is Delaunay; true for ties.
  bool is_locally_delaunay(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// tells the same, if the metric is certain.
  CGAL::Intrinsic_triangulations::Certainty
  certain_delaunay(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// returns the sign of that property: negative if the edge is not Delaunay, zero for ties.
  CGAL::Sign delaunay_sign(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// tells whether the edge between two different faces can be flipped.
  bool is_flippable(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// The values that a flip makes.
  typedef unspecified_type Flipped;
  /*!
  \brief computes the values that a flip makes; nothing changes.
  \return the values; nothing if the number type cannot represent them
  \pre the edge can be flipped
  */
  std::optional<Flipped> compute_flip(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// stores the values that a flip makes, under the numbers that were there before; cannot fail.
  void store_flip(const CGAL::Intrinsic_triangulations::Diamond& d, Flipped&& values) noexcept;
  /// returns the exponent of the power of two that lengths of the input are scaled by.
  int scale_exponent() const;
};
