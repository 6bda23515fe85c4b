// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ACCURACY_H
#define INTRINSIC_ACCURACY_H

#include "options.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>

#include <optional>

namespace program {

/// checks what an algorithm found.
/// \throws std::runtime_error if rounding has spoilt the triangulation
void expect_accurate(const std::optional<CGAL::Intrinsic_triangulations::Inaccuracy>& inaccuracy,
                     const Options& options);

/// checks that flips have kept the area.
/// \throws std::runtime_error if rounding has changed it
void expect_area_kept(double before, double after, const Options& options);

/// checks that the common subdivision covers the input once.
/// \throws std::runtime_error if rounding has spoilt it
void expect_covered(double input_area, double area, const Options& options);

} // namespace program

#endif // INTRINSIC_ACCURACY_H
