// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class IntrinsicCorrespondence concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `IntrinsicCorrespondence` describes an observer of the moves of an intrinsic
triangulation. It finds out from them how the triangulation lies on the input surface, or anything
else.

A model is a template parameter and a member of `Intrinsic_triangulation`, and must not store
references to it. It reads the triangulation, by numbers of elements, through a
\itc{Intrinsic_view}.

\cgalRefines{`DefaultConstructible`\, `MoveConstructible` and `MoveAssignable` of the C++ standard;
also copyable\, if triangulations are to be copied}

\cgalHasModel{\itc{No_correspondence}\,
\itc{Integer_coordinates}\,
\itc{Explicit_crossings}\,
\itc{Signposts}; your own observer: own_correspondence.cpp among the examples}

\cgalHeading{Types}

The concept has no types of its own. A model reads the records of moves (Moves.h): \itc{Flip},
\itc{Insertion_in_face},
\itc{Insertion_on_border}, \itc{Removal_from_face} and \itc{Removal_from_border}, which hold all
elements around, so that the model never walks over the mesh. Numbers of type `std::uint32_t` name
elements: halfedges `2e` and `2e + 1` are the sides of edge `e`. Flips do not change numbers; an
insertion uses the numbers of removed elements again, or the next ones.

\cgalHeading{Order of calls}

Every move is planned, then made. The triangulation makes a record of it, and computes the values of
a flip. It passes the record to `before()`, which may refuse, and is const: what it finds out for
`after()` is in mutable members. If no observer refuses, and the arithmetic can hold the result, it
passes the record to `make_room()`, which allocates the memory that `after()` needs, and changes
nothing else. Until then any function may throw, for instance `std::bad_alloc`. Then connectivity
and metric change, and the triangulation passes the record to `after()`, which cannot fail. All
calls get the same record, except that new elements are `Gluing::none` before an insertion; their
numbers will be below `vertex_capacity()`, `edge_capacity()` and `face_capacity()` of `t.numbers()`
plus one, three and two. The triangulation does not announce a move that connectivity or convexity
forbids. With exact traits the record of an insertion names the place on the input that defines the
vertex, unless the correspondence finds this place, as \itc{Integer_coordinates} does.

To insert a vertex on an inner edge, the triangulation inserts it in a face, at distance zero from
the side, and then flips the side. To remove it, it goes in the opposite order. If a later move of
such a sequence is refused, or a function throws, the triangulation takes back the moves before,
with the old values of the metric. This cannot fail: it calls `after()` only. A model whose data of
an edge are rounded returns those that a flip will replace from `before_flip(move)`, of type
`Flipped`, and puts them back in `store_flip(move, values) noexcept`, as \itc{Signposts} do.

\cgalHeading{Which operation makes which moves}

| operation | records |
|---|---|
| constructors of \itc{Intrinsic_triangulation} | none: `start()` |
| `flip_edge()`, \itf{flip_to_delaunay} | \itc{Flip} |
| `undo_flip()`, \itc{Flip_log}, \itc{Geodesic_finder} | \itc{Flip} with `is_taken_back()`, only to `after()` |
| `insert_vertex()`, in a face | \itc{Insertion_in_face} |
| `insert_vertex()`, `split_edge()`, on an inner edge | \itc{Insertion_in_face} and \itc{Flip}; also \itc{Removal_from_face}, only to `after()`, if the flip is refused |
| the same on the border | \itc{Insertion_on_border} |
| `remove_vertex()` | \itc{Flip} until three edges are left, then \itc{Removal_from_face} or \itc{Removal_from_border}; if one is refused, flips are taken back |
| `reposition_vertex()`, \itf{delaunay_refine}, \itf{adaptive_refine}, \itf{odt_optimize} | all five; the first and the last of these also \itc{Move_in_star}, see \ref ::RepositioningCorrespondence |
| \itf{common_subdivision}, queries | not part of this concept: see \ref ::CurveCoordinates |

The C++20 concept requires all five, so that a triangulation can make every move. If you need only
one of them, derive from \itc{No_correspondence}, as the example does.

A model can do more: \ref ::RestorableCorrespondence, \ref ::IntegerCorrespondence,
\ref ::QueriedCorrespondence, \ref ::RepositioningCorrespondence.

\cgalHeading{Invariants}

- After `start()` and after every `after()` the model describes the triangulation that it was called
  with.
- If a `before()` returns false, or a `before()` or `make_room()` throws, nothing has changed but
  caches, not in the model either. The same holds for a sequence of moves: connectivity, places, the
  doubles of inexact metrics and directions of signposts are as they were before it. Only the next
  inserted elements may have other numbers.

\cgalHeading{Complexity}

The concept sets no bound; a move takes as long as its observer. `No_correspondence` is empty and
costs nothing.
*/
class IntrinsicCorrespondence {
public:
  /*!
  \brief starts to observe `t`, which is complete and has seen no move.
  \tparam Triangulation an `Intrinsic_triangulation`
  */
  template <class Triangulation>
  void start(const Triangulation& t);
  /*!
  \brief is called before a flip: mesh and metric of `t` are as before.
  \return whether the flip may go on; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t, const CGAL::Intrinsic_triangulations::Flip& move) const;
  /*!
  \brief allocates the memory that a move needs, once nobody has refused the move; may throw.
  \tparam Move each of the five records
  */
  template <class Triangulation, class Move>
  void make_room(const Triangulation& t, const Move& move);
  /// is called after a flip: mesh and metric of `t` are as after it.
  template <class Triangulation>
  void after(const Triangulation& t, const CGAL::Intrinsic_triangulations::Flip& move) noexcept;
  /*!
  \brief is called before the insertion of a vertex in a face; may call the metric of `t` for signs.
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Insertion_in_face& move) const;
  /// is called after the insertion; the record names the new elements.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Insertion_in_face& move) noexcept;
  /*!
  \brief is called before the insertion of a vertex on the border.
  \return whether it may be inserted; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Insertion_on_border& move) const;
  /// is called after the insertion; the record names the new elements.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Insertion_on_border& move) noexcept;
  /*!
  \brief is called before the removal of a vertex with three edges.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Removal_from_face& move) const;
  /// is called after the removal: the first face of the record is the whole one.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Removal_from_face& move) noexcept;
  /*!
  \brief is called before the removal of a vertex with three edges from the border.
  \return whether it may be removed; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Removal_from_border& move) const;
  /// is called after the removal: `ip` and `f` of the record are the whole edge and face.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Removal_from_border& move) noexcept;
};
