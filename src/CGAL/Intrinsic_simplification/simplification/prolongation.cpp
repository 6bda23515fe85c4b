// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Rows for vertices at places on a coarse surface.
template <class Place_of_row>
Eigen::SparseMatrix<double> matrix_of_places(const Simplification& s, std::size_t rows,
                                             const Place_of_row& place) {
  std::vector<Eigen::Triplet<double>> entries;
  const Gluing_map& mesh = s.surface.mesh;
  for (std::size_t v = 0; v < rows; ++v) {
    const Place& p = place(v);
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
  Eigen::SparseMatrix<double> result(static_cast<int>(rows), static_cast<int>(s.kept.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace

} // namespace internal

Eigen::SparseMatrix<double> prolongation(const Simplification& s) {
  return internal::matrix_of_places(s, s.places.size(),
                                    [&](std::size_t v) -> const Place& { return s.places[v]; });
}

Eigen::SparseMatrix<double> prolongation(const Simplification& finer,
                                         const Simplification& coarser) {
  return internal::matrix_of_places(coarser, finer.kept.size(), [&](std::size_t v) -> const Place& {
    return coarser.places[finer.kept[v]];
  });
}

} // namespace CGAL::Intrinsic_triangulations
