// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicCorrespondence concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IntrinsicCorrespondence` describes an observer of the moves of an intrinsic triangulation,
which learns from them how the triangulation lies on the input surface, or anything else.

A model is a member of `Intrinsic_triangulation`, of which it is a template parameter, and must not store
references to that. It reads the triangulation, by numbers of elements, through a
\itc{Intrinsic_view}.

\cgalRefines{`DefaultConstructible`\, `MoveConstructible` and `MoveAssignable` of the C++ standard; also copyable\,
if triangulations are to be copied}

\cgalHasModel{\itc{No_correspondence}\,
\itc{Integer_coordinates}\,
\itc{Explicit_crossings}\,
\itc{Signposts}; an observer of one's own: own_correspondence.cpp among the examples}

\cgalHeading{Types}

None of its own. Elements are named by numbers of type `std::uint32_t`: halfedges `2e` and `2e + 1` are the sides of
edge `e`. Flips do not change numbers; an insertion uses the numbers of removed elements again, or the next ones.

\cgalHeading{Order of calls}

Every move runs in one order: what it makes is computed, the correspondence hears of it (`before_...`) and may
refuse, connectivity and metric change, the correspondence hears again (`after_...`). A move that is refused for
reasons of connectivity or convexity is not announced. An insertion may be announced and then not be done, because
an inexact number type cannot hold it: then the next call announces another move.

A vertex on an inner edge is inserted in a face, at distance zero from the side, which is flipped then; it is removed
in the opposite order.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | `start()` |
| `flip_edge()`, \itf{flip_to_delaunay} | `before_flip()`, `after_flip()` |
| `insert_vertex()`, `split_edge()` | those, and the four functions that hear of insertions |
| `remove_vertex()` | those of flips, and the four functions that hear of removals |
| `reposition_vertex()`, \itf{delaunay_refine}, \itf{odt_optimize} | all |
| \itf{common_subdivision}, queries | not part of this concept: see \ref ::CurveCoordinates |

The C++20 concept asks for all of them, so that a triangulation can make every move.

\cgalHeading{Invariants}

- After `start()` and after every `after_...` the model describes the triangulation that it was called with.
- If a `before_...` returns false, nothing has changed, in the model either.

\cgalHeading{Complexity}

Free; a move takes as long as its observer. `No_correspondence` is empty and costs nothing.

The C++20 concept \itc{IntrinsicCorrespondence} in concepts.h checks the syntax.
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
  \param t the triangulation, before the flip
  \param h a halfedge of the edge
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
