// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_INACCURACY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_INACCURACY_H

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief says what rounding took from a triangulation while an algorithm inserted, removed or moved vertices.
*/
struct Inaccuracy {
  /// What is not as it must be.
  enum class Kind : std::uint8_t {
    face,       ///< a length or the area of a face is not a positive number
    shape,      ///< the sides of a face do not span its area
    total_area, ///< the faces together have not the area that they had before
    topology    ///< the Euler characteristic has changed
  };
  Kind kind; ///< what it is
  /// Number of the face; where none has failed alone, of that whose sides and area agree the least.
  std::uint32_t face;
  double area_before; ///< of all faces, in the units of the input
  double area_after;  ///< of all faces, in the units of the input; maybe not a number
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_INACCURACY_H
