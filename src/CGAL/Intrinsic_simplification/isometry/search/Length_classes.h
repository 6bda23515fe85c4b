// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_LENGTH_CLASSES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_LENGTH_CLASSES_H

#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Classes of edges of one or two surfaces that have equal squared lengths, and as many ends that
// are copies.
struct Length_classes {
  // for each surface and dart
  std::vector<std::vector<std::uint32_t>> of_dart;
  // whether lengths in one class are equal by proof, and those of different
  // classes differ
  bool are_proven = true, are_separated = true;
};

/*
Compares squared lengths exactly. Enclosures prove most to be different. Two are
equal if the same strips of input triangles lie under both edges, if their chains
are identical, or if they are the same number in the field of the square roots of
all surfaces.
*/
Length_classes exact_length_classes(std::span<const Singular_surface* const> surfaces);

// Lengths in different classes differ by more than a relative error.
// \param darts the tessellations of the surfaces
Length_classes rounded_length_classes(std::span<const Singular_surface* const> surfaces,
                                      double error, std::span<const Dart_complex* const> darts);

// the power of four by which squared lengths of a surface are multiplied for
// the units of another
int exponent_to_units_of(const Singular_surface& from, const Singular_surface& to);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_LENGTH_CLASSES_H
