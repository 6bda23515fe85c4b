// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\cgalConcept

The concept `IntrinsicCorrespondence` describes an observer of the moves of an intrinsic triangulation,
which learns from them how the triangulation lies on the input surface.

Every move runs in one order: what it makes is computed, the correspondence hears of it and may refuse,
connectivity and metric change, the correspondence hears again. A move that is refused for reasons of
connectivity or convexity is not announced. An insertion may be announced and then not be done, because
an inexact number type cannot hold it: then the next call announces another move.

Elements are named by numbers: halfedges `2e` and `2e + 1` are the sides of edge `e`. Flips do not
change numbers; an insertion uses the numbers of removed elements again, or the next ones. An
`Intrinsic_view` reads the triangulation by these numbers.

A vertex on an inner edge is inserted in a face, at distance zero from the side, which is flipped then;
it is removed in the opposite order.

A model is default constructible, movable, and copyable if the triangulation is to be copied. As a
template parameter of `Intrinsic_triangulation` it is a member of that class and must not store
references to it.

<b>Complexity.</b> Free; a move takes as long as its observer.

<b>Which operation needs what.</b>

| operation | needs |
|---|---|
| constructors of `Intrinsic_triangulation` | `start()` |
| `Intrinsic_triangulation::flip_edge()`, `flip_to_delaunay()` | `before_flip()`, `after_flip()` |
| `Intrinsic_triangulation::insert_vertex()`, `split_edge()` | those, and the four functions that hear of insertions |
| `Intrinsic_triangulation::remove_vertex()` | those of flips, and the four functions that hear of removals |
| `Intrinsic_triangulation::reposition_vertex()` | all |

\cgalHasModel{`CGAL::Intrinsic_triangulations::No_correspondence`\,
`CGAL::Intrinsic_triangulations::Integer_coordinates`\,
`CGAL::Intrinsic_triangulations::Explicit_crossings`\,
`CGAL::Intrinsic_triangulations::Signposts`}
*/
class IntrinsicCorrespondence {
public:
  /*!
  \brief hears that `t` is complete and has seen no move.
  \tparam Triangulation an `Intrinsic_triangulation`
  */
  template <class Triangulation>
  void start(const Triangulation& t);
  /*!
  \brief hears that the edge of `h` will be flipped: mesh and metric of `t` are as before.
  \return whether the flip may be done; if not, nothing has changed
  */
  template <class Triangulation>
  bool before_flip(const Triangulation& t, std::uint32_t h);
  /*!
  \brief hears that the edge of `h` was flipped: mesh and metric of `t` are as after it. `h` has
  turned clockwise and keeps its number.
  */
  template <class Triangulation>
  void after_flip(const Triangulation& t, std::uint32_t h);
  /*!
  \brief hears that a vertex will be inserted in the face of `h`.
  \param t the triangulation, whose metric may be asked for signs
  \param h a halfedge
  \param weights barycentric coordinates of the source of `h`, its target, the third corner; if the
    last one is zero, the edge of `h` is flipped next
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before_insert_in_face(Triangulation& t, std::uint32_t h,
                             const std::array<double, 3>& weights);
  /// hears that the vertex was inserted; where the new edges are, `split_face()` tells.
  template <class Triangulation>
  void after_insert_in_face(const Triangulation& t, std::uint32_t h);
  /*!
  \brief hears that a vertex will be inserted on the border.
  \param t the triangulation
  \param h a halfedge that has a face and whose opposite has none
  \param parameter 0 at the source of `h`, 1 at its target
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before_insert_in_border_edge(Triangulation& t, std::uint32_t h, double parameter);
  /// hears that the vertex was inserted; where the new edges are, `split_border_edge()` tells.
  template <class Triangulation>
  void after_insert_in_border_edge(const Triangulation& t, std::uint32_t h);
  /*!
  \brief hears that a vertex with three edges will be removed: the one opposite `h` in its face, see
  `remove_degree_3_vertex()`.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before_remove(const Triangulation& t, std::uint32_t h);
  /// hears that the vertex was removed.
  template <class Triangulation>
  void after_remove(const Triangulation& t, std::uint32_t h);
  /*!
  \brief hears that the target of `h` will be removed from the border, see `remove_border_vertex()`.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before_remove_from_border(const Triangulation& t, std::uint32_t h);
  /// hears that the vertex was removed.
  template <class Triangulation>
  void after_remove_from_border(const Triangulation& t, std::uint32_t h);
};
