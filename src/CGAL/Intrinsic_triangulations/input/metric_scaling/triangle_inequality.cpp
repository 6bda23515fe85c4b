// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

bool squares_satisfy_triangle_inequality(double L_ij, double L_jk, double L_ki) {
  const double d = squared_quadruple_area(L_ij, L_jk, L_ki);
  const double scale = 4 * (L_ij + L_jk + L_ki - std::max({L_ij, L_jk, L_ki})) *
                       std::min({L_ij, L_jk, L_ki}); // 4yz at least
  if (std::abs(d) > 0x1p-90 * scale && scale > 0x1p-800 && scale < 0x1p1000 && std::isfinite(d))
    return d > 0;
  return squared_quadruple_area(Gmpq(L_ij), Gmpq(L_jk), Gmpq(L_ki)) >= Gmpq(0);
}

std::vector<std::uint32_t>
faces_violating_triangle_inequality(const Gluing_map& mesh,
                                    const std::vector<double>& squared_lengths) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto [a, b, c] = internal::edges_of_face(mesh, f);
    if (!squares_satisfy_triangle_inequality(squared_lengths[a], squared_lengths[b],
                                             squared_lengths[c]))
      result.push_back(f);
  }
  return result;
}

namespace internal {

class Edge_shortener {
public:
  // Rounds upwards during its lifetime.
  Edge_shortener(const Gluing_map& mesh, std::vector<double>& squared_lengths, double margin)
      : mesh_(mesh), squared_(squared_lengths), keep_((Interval(1) - Interval(margin)).inf()) {}

  Shortening_report run() {
    for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f) constrain(f);
    Shortening_report report;
    while (!queue_.empty()) {
      const auto [allowed, e] = queue_.top();
      queue_.pop();
      if (allowed >= squared_[e]) continue;
      ++report.changed_edges;
      report.largest_relative_change =
          std::max(report.largest_relative_change, 1 - std::sqrt(allowed / squared_[e]));
      squared_[e] = allowed;
      for (const std::uint32_t h : {2 * e, 2 * e + 1})
        if (mesh_.face({h}).index != Gluing::none) constrain(mesh_.face({h}).index);
    }
    return report;
  }

private:
  using Interval = Interval_nt<false>;
  using Candidate = std::pair<double, std::uint32_t>; // a squared length, the edge to get it

  // G^2 of squared lengths, rounded down, so that the inequality holds strictly for the rounded
  // squares, too, if min(b, c) > 0. Every operation is monotone, and the sum is at least the larger
  // square: the properties of G in the file's comment hold for the rounded function.
  double allowed(double b, double c) const {
    const Interval large(std::max(b, c)), small(std::min(b, c)), keep(keep_);
    const Interval rest = keep * (keep * small + Interval(2) * (sqrt(large) * sqrt(small)));
    return (large + rest).inf();
  }

  // only the longest side can exceed the bound by the others, since that bound is at least both
  void constrain(std::uint32_t f) {
    std::array<std::uint32_t, 3> e = edges_of_face(mesh_, f);
    const auto longest = std::max_element(
        e.begin(), e.end(), [&](auto a, auto b) { return squared_[a] < squared_[b]; });
    std::swap(*longest, e[0]);
    const double bound = allowed(squared_[e[1]], squared_[e[2]]);
    if (squared_[e[0]] > bound) queue_.emplace(bound, e[0]);
  }

  const Gluing_map& mesh_;
  std::vector<double>& squared_;
  double keep_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

} // namespace internal

Shortening_report shorten_edges(const Gluing_map& mesh, std::vector<double>& squared_lengths,
                                double margin) {
  if (!(margin > 0 && margin <= 1))
    throw std::invalid_argument("the margin of the triangle inequality is " +
                                std::to_string(margin) + "; give one above 0 and at most 1");
  const Protect_FPU_rounding<true> upwards;
  return internal::Edge_shortener(mesh, squared_lengths, margin).run();
}

} // namespace CGAL::Intrinsic_triangulations
