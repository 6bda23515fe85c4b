// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RepositioningCorrespondence concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `RepositioningCorrespondence` describes an observer that follows a vertex which moves
within its star. With other correspondences a vertex is inserted at the new place, and the old one
is removed.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{No_correspondence}\, \itc{Signposts}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `reposition_vertex()`, \itf{odt_optimize} | both, if the metric has `moved_values` and `store_star`; the metric may refuse after `before()` has agreed |

\cgalHeading{Invariants and complexity}

Those of \ref ::IntrinsicCorrespondence.
*/
class RepositioningCorrespondence {
public:
  /*!
  \brief is called before a vertex moves within its star.
  \return whether it may move; if not, nothing has changed
  */
  template <class Triangulation>
  bool before(const Triangulation& t,
              const CGAL::Intrinsic_triangulations::Move_in_star& move) const;
  /// allocates the memory that `after()` needs, once nobody has refused the move; may throw.
  template <class Triangulation>
  void make_room(const Triangulation& t, const CGAL::Intrinsic_triangulations::Move_in_star& move);
  /// is called after it: the metric of `t` is as after the move.
  template <class Triangulation>
  void after(const Triangulation& t,
             const CGAL::Intrinsic_triangulations::Move_in_star& move) noexcept;
};
