// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::array<double, 3> checked_half_cotangents(const Table_face& f, double factor) {
  std::array<double, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = factor * f.half_cotangent(k);
    // entries are sums of at most 16 of these
    if (!std::isfinite(16 * result[k]))
      throw Invalid_input(
          Element_kind::vertex, static_cast<std::size_t>(f.rows[0]),
          "the face of vertices " + std::to_string(f.rows[0]) + ", " + std::to_string(f.rows[1]) +
              " and " + std::to_string(f.rows[2]) +
              " has no area, or one too small for its cotangents; make the triangulation "
              "Delaunay, or build it with mollification");
  }
  return result;
}

std::array<std::complex<double>, 3> side_frames(const Table_face& f) {
  const auto corners = f.layout();
  std::array<std::complex<double>, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::complex<double> side = corners[(k + 1) % 3] - corners[k];
    result[k] = (f.halfedges[k] % 2 == 0 ? side : -side) / f.length(k);
  }
  return result;
}

Eigen::SparseMatrix<std::complex<double>> edge_connection_laplacian(const Face_table& table,
                                                                    double factor) {
  std::vector<Hermitian_entry> entries;
  entries.reserve(3 * table.faces.size());
  Eigen::VectorXd diagonal =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.number_of_edges));
  for (const Table_face& f : table.faces) {
    const auto weights = checked_half_cotangents(f, factor);
    const auto frames = side_frames(f);
    for (std::size_t k = 0; k < 3; ++k) {
      // the cotangents at the ends of a side sum to this, which is positive in spite of rounding
      const auto side = static_cast<int>(f.halfedges[k] / 2);
      diagonal[side] += factor * f.squared_lengths[k] / f.area();
      // two sides meet at the corner opposite the third
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const auto i = static_cast<int>(f.halfedges[a] / 2), j = static_cast<int>(f.halfedges[b] / 2);
      const double w = 4 * weights[k];
      const std::complex<double> turn = std::conj(frames[a]) * frames[b]; // from frame b to frame a
      if (i == j)
        diagonal[i] -= 2 * w * turn.real();
      else
        entries.push_back({i, j, -w * turn});
    }
  }
  return hermitian_matrix(entries, diagonal);
}

Eigen::VectorXd edge_areas(const Face_table& table) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.number_of_edges));
  for (const Table_face& f : table.faces)
    for (const std::uint32_t h : f.halfedges) areas[h / 2] += f.area() / 3;
  return areas;
}

} // namespace CGAL::Intrinsic_triangulations::internal
