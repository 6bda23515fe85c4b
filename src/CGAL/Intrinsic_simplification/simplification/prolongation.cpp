// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

Eigen::SparseMatrix<double> prolongation(const Simplification& s) {
  std::vector<Eigen::Triplet<double>> entries;
  const Gluing_map& mesh = s.surface.mesh;
  for (std::size_t i = 0; i < s.places.size(); ++i) {
    const Place& p = s.places[i];
    const int row = static_cast<int>(i);
    if (p.is_vertex()) entries.emplace_back(row, static_cast<int>(p.vertex), 1);
    else if (p.has_face()) {
      const auto sides = mesh.sides(Gluing_map::Face{p.face});
      for (std::size_t k = 0; k < 3; ++k)
        entries.emplace_back(row, static_cast<int>(mesh.source(sides[k]).index), p.weights[k]);
    }
  }
  Eigen::SparseMatrix<double> m(static_cast<Eigen::Index>(s.places.size()),
                                static_cast<Eigen::Index>(s.kept.size()));
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

} // namespace CGAL::Intrinsic_triangulations
