// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RefinableMetric concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `RefinableMetric` describes a metric that follows the insertion and removal of vertices. Without it a triangulation
flips, and `insert_vertex()` and `remove_vertex()` do not compile.

\cgalRefines{\ref ::IntrinsicMetric}

\cgalHasModel{all metrics of the package: \itc{Euclidean_metric}\, \itc{Exact_euclidean_metric}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `insert_vertex()`, `split_edge()` | `insert_in_face`, `insert_in_border_edge`, and the others to take them back |
| `remove_vertex()` | `remove_from_face`, `remove_from_border_edge` |

\cgalHeading{Invariants}

Removing a vertex that was inserted restores the values, up to rounding.

\cgalHeading{Complexity}

That of the arithmetic.

The C++20 concept \itc{RefinableMetric} in concepts.h checks the syntax.
*/
class RefinableMetric {
public:
  /*!
  \brief computes the values at a vertex inserted in a face, and stores them.
  \param s the star of the vertex; values of its sides and, in place of the first face, of the whole one are stored
  \param weights barycentric coordinates, multiples of 2^-52 that sum to 1
  \return whether it was done; if not, nothing has changed
  */
  bool insert_in_face(const CGAL::Intrinsic_triangulations::Vertex_star& s,
                      const std::array<double, 3>& weights);
  /// stores the values of a face from which a vertex is removed, in place of the first face of the star.
  void remove_from_face(const CGAL::Intrinsic_triangulations::Vertex_star& s);
  /*!
  \brief computes the values at a vertex inserted on a border edge, and stores them.
  \param s the star of the vertex; values of `ip`, `jk`, `ki` and `f` are stored, those of the whole edge and face
  \param parameter weight of `j`
  \return whether it was done; if not, nothing has changed
  */
  bool insert_in_border_edge(const CGAL::Intrinsic_triangulations::Border_star& s, double parameter);
  /// stores the values of a border edge and its face from which a vertex is removed.
  void remove_from_border_edge(const CGAL::Intrinsic_triangulations::Border_star& s);
};
