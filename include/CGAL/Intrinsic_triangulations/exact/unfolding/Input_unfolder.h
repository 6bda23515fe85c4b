// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_INPUT_UNFOLDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_INPUT_UNFOLDER_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flat_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief unfolds the input triangles over which diamonds and faces of a triangulation lie, for a metric that decides
predicates on them.
*/
class Input_unfolder {
public:
  virtual ~Input_unfolder() = default;
  /// returns a diamond whose interior is known to lie in one plane in space.
  virtual std::optional<Flat_diamond> flat_diamond(const Diamond& d) = 0;
  /// returns the input triangles under a diamond, valid until the next call; null if that is not known, or edges
  /// cross too many of them: then the history of flips tells the values.
  virtual const Unfolded_diamond* diamond(const Diamond& d) = 0;
  /// returns those under a face, as a diamond whose corner m is i, valid until the next call; null as above.
  virtual const Unfolded_diamond* face(const Indexed_face& f) = 0;
  /// returns those under the first side of a face, as a diamond whose corners i and j are its ends; see above.
  virtual const Unfolded_diamond* first_side(const Indexed_face& f) = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_INPUT_UNFOLDER_H
