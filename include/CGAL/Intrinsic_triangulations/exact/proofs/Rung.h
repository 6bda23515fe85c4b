// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_RUNG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_RUNG_H

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// The rungs of the ladder that decides signs exactly, see `Exact_ladder`, in their order.
enum class Rung {
  integers,       ///< two faces of the input, in integers
  doubles,        ///< intervals of doubles, unfolded anew
  flat,           ///< a plane in space
  prism,          ///< cylinders and prisms, in integers
  mirrored,       ///< symmetry
  bits_106,       ///< numbers of 106 bits
  prism_in_field, ///< cylinders and prisms, in a field
  bits_256,       ///< numbers of 256 bits
  field,          ///< the field of all square roots
  more_bits       ///< numbers of 512 bits and more
};

/// Number of rungs.
inline constexpr std::size_t number_of_rungs = 10;

/// returns the name of a rung.
constexpr const char* name_of(Rung rung) {
  constexpr std::array<const char*, number_of_rungs> names{
      "integers", "doubles",        "flat",     "prism", "mirrored",
      "bits_106", "prism_in_field", "bits_256", "field", "more_bits"};
  return names[static_cast<std::size_t>(rung)];
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_RUNG_H
