// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_RESULT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_RESULT_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports damage by rounding to a triangulation while an algorithm inserted, removed or moved
vertices.
*/
struct Inaccuracy {
  /// Kinds of damage.
  enum class Kind : std::uint8_t {
    face,       ///< a length or the area of a face is not a positive number
    shape,      ///< the sides of a face do not span its area
    total_area, ///< the total area of the faces has changed
    topology    ///< the Euler characteristic has changed
  };
  Kind kind; ///< what it is
  /// Number of the face; if no single face failed, of the one whose sides and area agree the least.
  std::uint32_t face;
  double area_before; ///< of all faces, in the units of the input
  double area_after;  ///< of all faces, in the units of the input; maybe not a number
};

/// Which face refinement turns to next.
enum class Refinement_order {
  first_come, ///< the one that waits longest: neighbours in turn, in time linear in the insertions
  largest_first, ///< that of the largest circumradius: some per cent fewer vertices; all over the
                 ///< mesh, which is slow for millions of them
  worst_first    ///< that of the smallest angle
};

/// Why a face does not meet the criteria.
enum class Unsatisfied_reason {
  needle,      ///< it wraps around a vertex of degree one, whose total angle is below the bound
  small_angle, ///< it lies between constrained or border edges that make a small angle
  refused,     ///< no vertex could be inserted: rounding hides its
               ///< place, or on a cover others are too near
  stopped      ///< refinement was stopped before
};

/*!
\brief names a face that does not meet the criteria.
\tparam Face a face descriptor
*/
template <std::semiregular Face>
struct Unsatisfied_face {
  Face face;                 ///< the face
  Unsatisfied_reason reason; ///< why
};

/*!
\brief counts what refinement did.
*/
struct Refinement_counts {
  /// Circumcenters inserted.
  std::uint64_t circumcenters = 0;
  /// Splits of border edges and constrained edges.
  std::uint64_t segment_splits = 0;
  /// Inserted vertices that were removed again: near edges that were split, or since a copy was too
  /// close to another vertex.
  std::uint64_t removals = 0;
  /// Edges flipped to keep the triangulation Delaunay, those of insertions and removals not
  /// counted.
  std::uint64_t flips = 0;
  /// Insertions and removals that were refused.
  std::uint64_t refused = 0;
  /// Insertions on a cover without all copies, which would have been too close to other vertices.
  std::uint64_t without_copies = 0;

  /// returns how many vertices there are more than before, modulo 2^64: fewer if vertices of an
  /// earlier refinement were removed.
  std::uint64_t inserted_vertices() const { return circumcenters + segment_splits - removals; }
};

/*!
\brief reports what refinement did.
\tparam Face a face descriptor
*/
template <std::semiregular Face>
struct Refinement_result {
  /// `done`: every face meets the criteria, except the listed needles and small angles. `cap` or
  /// `cancelled`: refinement stopped before. `stalled`: faces listed as `refused` do not meet them,
  /// and no vertex could be inserted there. `inaccurate`: do not use the triangulation.
  Status status = Status::done;
  /// The counts.
  Refinement_counts counts;
  /// All faces that do not meet the criteria.
  std::vector<Unsatisfied_face<Face>> unsatisfied;
  /// Damage by rounding, if it is `inaccurate`.
  std::optional<Inaccuracy> inaccuracy = std::nullopt;
};

/*!
\brief observes refinement; the default visitor does nothing.
*/
struct Refinement_visitor {
  /*!
  \brief is called about every 256 insertions; before the first one, about every 65536 edges and
  16384 faces that are tested.
  \return whether to go on; if not before the first insertion, some edges may not be locally
    Delaunay yet, except on covers
  */
  bool progress(const Refinement_counts&) { return true; }
  /*!
  \brief tells whether to refine a face for reasons beyond the criteria of `delaunay_refine()`.

  Refinement ends only if it returns false for all small enough faces.
  */
  template <class Triangulation>
  bool is_bad(const Triangulation&, typename Triangulation::face_descriptor) {
    return false;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_RESULT_H
