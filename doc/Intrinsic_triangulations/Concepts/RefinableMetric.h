// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RefinableMetric metric_concepts.h <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>
\cgalConcept

The concept `RefinableMetric` describes a metric that follows the insertion and removal of vertices.
A triangulation with another metric can only flip: its `insert_vertex()` and `remove_vertex()` do
not compile.

\cgalRefines{\ref ::EuclideanMetric}

\cgalHasModel{all Euclidean metrics of the package: \itc{Euclidean_metric}\, \itc{Exact_euclidean_metric}}

\cgalHeading{What defines an inserted vertex}

Two kinds of models differ in where the values of insertions come from:

- A metric that *measures* insertions has `inserted_values`. It computes new values from stored ones, and from barycentric
  coordinates in the intrinsic face: \itc{Euclidean_metric}.
- A metric that is *defined by places* receives the values from the triangulation, which stores
  where all vertices are on the input: \itc{Exact_euclidean_metric}. A vertex is exactly at a point
  of an input face with barycentric coordinates that are multiples of 2^-52. So values depend on the
  input alone, not on earlier moves. This point differs from the requested one by rounding. These
  are the metrics that store enclosures and have a decider; `inserted_values` is never called.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `insert_vertex()`, `split_edge()` | `make_room`, `insert_in_face`, `insert_in_border_edge`; `inserted_values`, if the metric measures insertions; `before_flip` and `store_flip`, to take them back |
| `remove_vertex()` | `removed_values`, `store_flip`; `before_flip`, to take flips back |
| `reposition_vertex()` | all of these; `moved_values` and `store_star`, if the metric has them, as \itc{Euclidean_metric} does, and the correspondence is a \ref ::RepositioningCorrespondence |

Functions that compute are const and may fail. Those that store cannot: `make_room` has allocated
the memory.

\cgalHeading{Invariants}

The removal of an inserted vertex restores the values: up to rounding if the metric measures
insertions, exactly if places define it.

\cgalHeading{Complexity}

That of the arithmetic.
*/
class RefinableMetric {
public:
  /// Number type of stored values.
  typedef unspecified_type FT;
  /*!
  \brief computes the values at a vertex inserted in a face, if the metric measures insertions.
  \param s the star of the vertex, without spokes: the sides and the first face are stored
  \param weights barycentric coordinates, multiples of 2^-52 that sum to 1
  \return nothing if the arithmetic cannot hold them
  */
  std::optional<CGAL::Intrinsic_triangulations::Vertex_move_values<FT>>
  inserted_values(const CGAL::Intrinsic_triangulations::Vertex_star& s,
                  const std::array<double, 3>& weights) const;
  /*!
  \brief computes the values at a vertex inserted on a border edge, if the metric measures
  insertions.
  \param s the star of the vertex, where `ip` is the whole edge and `f` the whole face
  \param parameter weight of `j`
  \return see `insert_in_border_edge()`; nothing if the arithmetic cannot hold them
  */
  std::optional<CGAL::Intrinsic_triangulations::Vertex_move_values<FT>>
  inserted_values(const CGAL::Intrinsic_triangulations::Border_star& s, double parameter) const;
  /// The values that a flip makes, see \ref ::IntrinsicMetric.
  typedef unspecified_type Flipped;
  /// returns what a flip of the edge will replace; storing it takes the flip back.
  Flipped before_flip(const CGAL::Intrinsic_triangulations::Diamond& d) const;
  /// returns the values of a face from which a vertex is removed: `store_flip()` stores them for the
  /// diamond `without_vertex(s)`.
  Flipped removed_values(const CGAL::Intrinsic_triangulations::Vertex_star& s) const;
  /// returns the values of a border edge and its face from which a vertex is removed; see above.
  Flipped removed_values(const CGAL::Intrinsic_triangulations::Border_star& s) const;
  /// allocates memory for values of so many edges and faces; changes nothing else.
  void make_room(std::uint32_t edges, std::uint32_t faces);
  /// stores the values at a vertex inserted in a face; values of its sides and, in place of the
  /// first face, of the whole one are stored.
  void insert_in_face(const CGAL::Intrinsic_triangulations::Vertex_star& s,
                      CGAL::Intrinsic_triangulations::Vertex_move_values<FT>&& values) noexcept;
  /*!
  \brief stores the values at a vertex inserted on a border edge.
  \param s the star of the vertex; values of `ip`, `jk`, `ki` and `f` are stored, those of the whole
    edge and face
  \param values those at the vertex as if it were in the face: of ip, jp, kp, and of ijp, jkp, kip
  */
  void
  insert_in_border_edge(const CGAL::Intrinsic_triangulations::Border_star& s,
                        CGAL::Intrinsic_triangulations::Vertex_move_values<FT>&& values) noexcept;
};
