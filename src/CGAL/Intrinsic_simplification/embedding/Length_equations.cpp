// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Length_equations::Length_equations(const Metric_triangles& t, const Space_points& points) {
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
    if (h < t.opposite(h)) halfedges.push_back(h);
  const Eigen::Index n = static_cast<Eigen::Index>(halfedges.size());
  residual.resize(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * halfedges.size());
  for (Eigen::Index e = 0; e < n; ++e) {
    const std::uint32_t h = halfedges[static_cast<std::size_t>(e)];
    const std::uint32_t a = t.source(h), b = t.target(h);
    Double_double squared(0);
    for (int k = 0; k < 3; ++k) {
      const Double_double d = Double_double::difference(points[b][k], points[a][k]);
      squared = squared + d * d;
      const double slope = d.to_double() / t.length(h);
      entries.emplace_back(3 * static_cast<int>(a) + k, static_cast<int>(e), -slope);
      entries.emplace_back(3 * static_cast<int>(b) + k, static_cast<int>(e), slope);
    }
    residual[e] = (squared - t.squared_length(h)).to_double() / (2 * t.length(h));
  }
  gradients.resize(3 * static_cast<Eigen::Index>(points.size()), n);
  gradients.setFromTriplets(entries.begin(), entries.end());
}

} // namespace CGAL::Intrinsic_triangulations::internal
