// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\cgalConcept

The concept `IntrinsicCorrespondence` describes an observer of the moves of an intrinsic triangulation,
which learns from them how the triangulation lies on the input surface.

Every move runs in one order: what it makes is computed, the correspondence hears of it, connectivity
and metric change, the correspondence hears again. A move that is refused for reasons of connectivity
or convexity is not announced. With inexact arithmetic a flip may be announced and then not done: then
`after_flip()` is not called, and the next call is a `before_flip()`.

A model is default constructible and movable. As a template parameter of `Intrinsic_triangulation` it
is a member of that class and must not store references to it.

<b>Complexity.</b> Free; a flip takes as long as its observer.

<b>Which operation needs what.</b> `Intrinsic_triangulation::flip_edge()` and `flip_to_delaunay()` need
both functions.

\cgalHasModel{`CGAL::Intrinsic_triangulations::No_correspondence`}
*/
class IntrinsicCorrespondence {
public:
  /*!
  \brief hears that the edge of `h` will be flipped: mesh and metric of `t` are as before.
  \tparam Triangulation an `Intrinsic_triangulation`
  */
  template <class Triangulation>
  void before_flip(const Triangulation& t, typename Triangulation::halfedge_descriptor h);
  /*!
  \brief hears that the edge of `h` was flipped: mesh and metric of `t` are as after it. `h` has
  turned clockwise and keeps its name.
  \tparam Triangulation an `Intrinsic_triangulation`
  */
  template <class Triangulation>
  void after_flip(const Triangulation& t, typename Triangulation::halfedge_descriptor h);
};
