// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Eigen::SparseMatrix<double> prolongation(const Simplification& s) {
  std::vector<Eigen::Triplet<double>> entries;
  const Gluing_map& mesh = s.surface.mesh;
  for (std::size_t v = 0; v < s.places.size(); ++v) {
    const Place& p = s.places[v];
    const auto row = static_cast<int>(v);
    if (p.is_vertex()) {
      entries.emplace_back(row, static_cast<int>(p.vertex), 1);
    } else if (p.has_face()) {
      const auto sides = mesh.sides({p.face});
      for (std::size_t k = 0; k < 3; ++k)
        if (p.weights[k] > 0)
          entries.emplace_back(row, static_cast<int>(mesh.source(sides[k]).index), p.weights[k]);
    }
  }
  Eigen::SparseMatrix<double> result(static_cast<int>(s.places.size()),
                                     static_cast<int>(s.kept.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
