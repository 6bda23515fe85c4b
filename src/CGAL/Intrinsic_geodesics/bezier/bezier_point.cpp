// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/bezier/bezier_point.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Place_on_curve place_on_curve(const Input& input, const Traced_curve& curve, double share) {
  const auto end_of_piece = [&](std::size_t piece, std::size_t end) {
    return seen_in_face(input, curve.points[piece + end], curve.faces[piece]);
  };
  std::vector<double> lengths;
  double all = 0;
  for (std::size_t i = 0; i < curve.faces.size(); ++i) {
    const Unscaled_vector v = vector_between(input, end_of_piece(i, 0), end_of_piece(i, 1));
    lengths.push_back(std::hypot(v[0], v[1]));
    all += lengths.back();
  }
  double left = share * all;
  std::size_t piece = 0;
  for (; piece + 1 < lengths.size() && left > lengths[piece]; ++piece) left -= lengths[piece];
  Surface_point p = end_of_piece(piece, 0);
  const Surface_point q = end_of_piece(piece, 1);
  double x = lengths[piece] > 0 ? std::clamp(left / lengths[piece], 0.0, 1.0) : 0.0;
  // Up to rounding it is a point of the curve, which may be a vertex: that one is exact.
  for (const double end : {0., 1.})
    if (std::abs(x - end) * lengths[piece] <= 0x1p-40 * all) x = end;
  for (std::size_t k = 0; k < 3; ++k) p.weights[k] = (1 - x) * p.weights[k] + x * q.weights[k];
  return {piece, p};
}

} // namespace CGAL::Intrinsic_triangulations::internal
