// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Flips multiply two lengths that two factors scale each: beyond this range products overflow in
// doubles, and rational numbers have to decide.
bool are_in_range(std::span<const Double_double> factors) {
  int least = std::numeric_limits<int>::max(), most = std::numeric_limits<int>::min();
  for (const Double_double& factor : factors) {
    const double w = factor.to_double();
    if (!std::isnormal(w) || w < 0) return false;
    least = std::min(least, std::ilogb(w));
    most = std::max(most, std::ilogb(w));
  }
  // four factors, each at most 2^240 times or a part of the middle of this range
  return factors.empty() || most - least <= 480;
}

double Ideal_face::area() const {
  const double half = (lambda[0] + lambda[1] + lambda[2]) / 2;
  double squared = 1; // of a triangle with half of the perimeter 1
  for (const double x : surplus) squared *= std::max(x / (2 * half), 0.);
  return half * (half * std::sqrt(squared));
}

Ideal_components components_of(const std::vector<Ideal_face>& faces, std::size_t rows) {
  const std::vector<std::uint32_t> least = joined_sets(rows, [&](const auto& join) {
    for (const Ideal_face& f : faces) {
      join(f.rows[0], f.rows[1]);
      join(f.rows[0], f.rows[2]);
    }
  });
  Ideal_components result{std::vector<std::uint32_t>(rows, Gluing::none), {}};
  for (const Ideal_face& f : faces) {
    const std::uint32_t first = least[static_cast<std::size_t>(f.rows[0])];
    std::uint32_t& c = result.of_row[first];
    if (c == Gluing::none) {
      c = static_cast<std::uint32_t>(result.faces.size());
      result.faces.push_back(0);
    }
    ++result.faces[c];
    for (const int r : f.rows) result.of_row[static_cast<std::size_t>(r)] = c;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
