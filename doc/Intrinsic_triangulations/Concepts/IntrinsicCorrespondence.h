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

None of its own. It hears of moves by their records (Moves.h): \itc{Flip}, \itc{Insertion_in_face},
\itc{Insertion_on_border}, \itc{Removal_from_face} and \itc{Removal_from_border}, which hold all elements around, so that
it never walks over the mesh. Elements are named by numbers of type `std::uint32_t`: halfedges `2e` and `2e + 1` are
the sides of edge `e`. Flips do not change numbers; an insertion uses the numbers of removed elements again, or the next
ones.

\cgalHeading{Order of calls}

Every move runs in one order: its record is made, and the values of a flip are computed; the correspondence hears of it
(`before()`) and may refuse; connectivity and metric change; the correspondence hears again (`after()`). Both calls get
the same record, except that before an insertion what is new is `Gluing::none`. A move that is refused for reasons of
connectivity or convexity is not announced. An insertion may be announced and then not be done, because an inexact number
type cannot hold it: then the next call announces another move.
With exact traits the record of an insertion names the place on the input that defines the vertex, unless it is the
correspondence that finds it, as \itc{Integer_coordinates} does.

A vertex on an inner edge is inserted in a face, at distance zero from the side, which is flipped then; it is removed
in the opposite order.

\cgalHeading{Which operation makes which moves}

| operation | records |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | none: `start()` |
| `flip_edge()`, \itf{flip_to_delaunay} | \itc{Flip} |
| `undo_flip()`, \itc{Flip_log}, \itc{Geodesic_finder} | \itc{Flip}, whose `km` is the opposite of `ij` when it is taken back; the answer of `before()` is not asked for |
| `insert_vertex()`, in a face | \itc{Insertion_in_face} |
| `insert_vertex()`, `split_edge()`, on an inner edge | \itc{Insertion_in_face} and \itc{Flip}; also \itc{Removal_from_face}, if the flip is refused |
| the same on the border | \itc{Insertion_on_border} |
| `remove_vertex()` | \itc{Flip} until three edges are left, then \itc{Removal_from_face} or \itc{Removal_from_border} |
| `reposition_vertex()`, \itf{delaunay_refine}, \itf{adaptive_refine}, \itf{odt_optimize} | all five; the first and the last of these also \itc{Move_in_star}, where the model takes it and the metric can do it |
| \itf{common_subdivision}, queries | not part of this concept: see \ref ::CurveCoordinates |

The C++20 concept asks for all five, so that a triangulation can make every move. If you need only
one of them, derive from \itc{No_correspondence}, as the example does.

A model may also have `restore(t, coordinates)`, which is called in place of `start(t)` when a triangulation is read from a
file, with its \itc{Integer_coordinates}; a class that derives from \itc{No_correspondence} inherits one that does nothing.

\cgalHeading{Invariants}

- After `start()` and after every `after()` the model describes the triangulation that it was called with.
- If a `before()` returns false, nothing has changed, in the model either.

\cgalHeading{Complexity}

Free; a move takes as long as its observer. `No_correspondence` is empty and costs nothing.
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
  \brief hears that an edge will be flipped: mesh and metric of `t` are as before.
  \return whether the flip may be done; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t, const CGAL::Intrinsic_triangulations::Flip& move);
  /// hears that an edge was flipped: mesh and metric of `t` are as after it.
  template <class Triangulation>
  void after(const Triangulation& t, const CGAL::Intrinsic_triangulations::Flip& move);
  /*!
  \brief hears that a vertex will be inserted in a face; the metric of `t` may be asked for signs.
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Insertion_in_face& move);
  /// hears that the vertex was inserted, and by the record what is new.
  template <class Triangulation>
  void after(const Triangulation& t, const CGAL::Intrinsic_triangulations::Insertion_in_face& move);
  /*!
  \brief hears that a vertex will be inserted on the border.
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Insertion_on_border& move);
  /// hears that the vertex was inserted, and by the record what is new.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Insertion_on_border& move);
  /*!
  \brief hears that a vertex with three edges will be removed.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Removal_from_face& move);
  /// hears that the vertex was removed: the first face of the record is the whole one.
  template <class Triangulation>
  void after(const Triangulation& t, const CGAL::Intrinsic_triangulations::Removal_from_face& move);
  /*!
  \brief hears that a vertex with three edges will be removed from the border.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Removal_from_border& move);
  /// hears that the vertex was removed: `ip` and `f` of the record are the whole edge and face.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Removal_from_border& move);
};
