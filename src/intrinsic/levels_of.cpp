// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "levels.h"

#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>

#include <array>

// Apart from what checks options: it needs the library of curves, which the first program does not
// link.

namespace program {

std::vector<double> levels_of(const std::string& text, double least, double greatest) {
  const auto count = number_of_levels(text);
  return count ? CGAL::Intrinsic_triangulations::even_levels(std::array{least, greatest}, *count)
               : listed_levels(text);
}

} // namespace program
