// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/Border_spectrum.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Complex_matrix conformal_energy(const Eigen::SparseMatrix<double>& laplacian,
                                const Disk_border& border) {
  Complex_matrix c = (laplacian / 2).cast<std::complex<double>>();
  std::vector<Eigen::Triplet<std::complex<double>>> area;
  for (std::size_t k = 0; k < border.rows.size(); ++k) { // the area is 1/2 Im(conj(w_i) w_j)
    const auto i = static_cast<int>(border.rows[k]),
               j = static_cast<int>(border.rows[(k + 1) % border.rows.size()]);
    area.emplace_back(i, j, std::complex<double>(0, -0.25));
    area.emplace_back(j, i, std::complex<double>(0, 0.25));
  }
  c -= matrix_of(c.rows(), c.cols(), area);
  c.makeCompressed();
  return c;
}

// The points, scaled to the area of the surface.
static Eigen::MatrixX2d scaled_to_area(const Face_table& table, const Eigen::VectorXcd& w) {
  double area = 0, of_image = 0;
  for (const Table_face& f : table.faces) {
    const std::complex<double> a = w[f.rows[1]] - w[f.rows[0]], b = w[f.rows[2]] - w[f.rows[0]];
    area += f.area();
    of_image += std::imag(std::conj(a) * b) / 2;
  }
  const double factor = table.unscaled(of_image > 0 ? std::sqrt(area / of_image) : 1);
  Eigen::MatrixX2d result(w.size(), 2);
  result.col(0) = factor * w.real();
  result.col(1) = factor * w.imag();
  return result;
}

Eigen::MatrixX2d least_squares_conformal_map(const Face_table& table,
                                             const Eigen::SparseMatrix<double>& laplacian,
                                             const Disk_border& border) {
  Complex_matrix c = conformal_energy(laplacian, border);
  regularise_isolated(c);
  const double half = std::accumulate(border.lengths.begin(), border.lengths.end(), 0.0) / 2;
  std::size_t other = 0;
  for (double length = 0; length < half; ++other) length += border.lengths[other];
  const auto first = static_cast<int>(border.rows[0]),
             second = static_cast<int>(border.rows[std::min(other, border.rows.size() - 1)]);
  std::vector<char> is_fixed(static_cast<std::size_t>(c.rows()), 0);
  is_fixed[border.rows[0]] = is_fixed[static_cast<std::size_t>(second)] = 1;
  Eigen::VectorXcd w = -c.col(second);
  w[first] = 0;
  w[second] = 1;
  c = with_fixed_rows(std::move(c), is_fixed);
  w = raised_factorization(c).solve(w);
  return scaled_to_area(table, w);
}

Eigen::MatrixX2d spectral_conformal_map(const Face_table& table,
                                        const Eigen::SparseMatrix<double>& laplacian,
                                        const Disk_border& border) {
  Eigen::VectorXcd w = first_of_border_spectrum(conformal_energy(laplacian, border), border);
  const std::complex<double> start = w[border.rows[0]];
  if (std::abs(start) > 0) w *= std::conj(start) / std::abs(start);
  for (Eigen::Index r = 0; r < w.size(); ++r)
    if (laplacian.coeff(static_cast<int>(r), static_cast<int>(r)) == 0) w[r] = 0;
  return scaled_to_area(table, w);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
