// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The pieces, small ones first: a component begins at the origin with its smallest piece, because
// doubles are densest there.
std::vector<std::uint32_t> by_extent(const std::vector<double>& extent) {
  std::vector<std::uint32_t> result(extent.size());
  std::iota(result.begin(), result.end(), 0U);
  std::ranges::stable_sort(result, {}, [&extent](std::uint32_t i) { return extent[i]; });
  return result;
}

// Improves places by least squares.
class Place_improver {
public:
  using Complex = Plane_pieces::Complex;

  // \param fixed a vertex of each component
  Place_improver(const Plane_pieces& pieces, const std::vector<std::uint32_t>& fixed,
                 Developer<Plane_pieces>& developer)
      : p_(pieces), fixed_(fixed), developer_(developer), d_(developer.result),
        unit_(developer.unit()) {}

  // Solves for changes of the places, until the largest error does not fall.
  void run() {
    d_.largest_error = developer_.largest_error(d_.position);
    const Laplacian_factorization factor = factorization();
    for (int round = 0; round < 3; ++round) {
      std::vector<Complex> z = changed(factor);
      const double error = developer_.largest_error(z);
      if (!(error < d_.largest_error)) return;
      d_.largest_error = error;
      d_.position = std::move(z);
    }
  }

private:
  // Calls a function with the ends of each side of each piece, with its vector in the plane, and
  // its piece.
  template <class Function>
  void for_each_side(const Function& f) const {
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c)
        f(p_.vertex[c], p_.vertex[p_.next(i, c)], d_.frame[i] * p_.side[c], i);
  }

  // 1 / length^2. A side shorter than a millionth of its piece counts as so long: it may be a point
  // but for rounding. So does one shorter than a billionth of the distance of its start from the
  // origin: the rounding of that place, times a greater weight, would move all others. 1e-50 keeps
  // weights finite.
  double weight(Complex side, std::uint32_t i, Complex from) const {
    const double length =
        std::max({std::abs(side), 1e-6 * d_.extent[i], 0x1p-30 * std::abs(from), 1e-50 * unit_});
    return unit_ / length * (unit_ / length);
  }

  Laplacian_factorization factorization() {
    const auto n = static_cast<Eigen::Index>(p_.number_of_vertices);
    std::vector<Eigen::Triplet<double>> entries;
    for_each_side([&](std::uint32_t a, std::uint32_t b, Complex side, std::uint32_t i) {
      if (a == b) return;
      const int v = static_cast<int>(a), w = static_cast<int>(b);
      const double by = weight(side, i, d_.position[a]);
      weight_.push_back(by);
      for (const int k : {v, w}) entries.emplace_back(k, k, by);
      entries.emplace_back(v, w, -by);
      entries.emplace_back(w, v, -by);
    });
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
    for (const std::uint32_t v : fixed_) diagonal[v] = laplacian.coeff(v, v);
    for (Eigen::Index v = 0; v < n; ++v) // vertices without a side
      if (!(laplacian.coeff(v, v) > 0)) diagonal[v] = 1;
    return Laplacian_factorization(laplacian, diagonal);
  }

  std::vector<Complex> changed(const Laplacian_factorization& factor) const {
    std::vector<Complex> z = d_.position;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(z.size()), 2);
    auto by = weight_.begin();
    for_each_side([&](std::uint32_t a, std::uint32_t b, Complex side, std::uint32_t) {
      if (a == b) return;
      const Complex d = *by++ * (side - (z[b] - z[a]));
      const Eigen::RowVector2d row(d.real(), d.imag());
      right.row(b) += row;
      right.row(a) -= row;
    });
    for (const std::uint32_t v : fixed_) right.row(v).setZero();
    const Eigen::MatrixXd x = factor.solve(right);
    for (std::size_t v = 0; v < z.size(); ++v) {
      const auto row = static_cast<Eigen::Index>(v);
      z[v] += Complex(x(row, 0), x(row, 1));
    }
    return z;
  }

  const Plane_pieces& p_;
  const std::vector<std::uint32_t>& fixed_;
  const Developer<Plane_pieces>& developer_;
  Developed<Plane_pieces>& d_;
  double unit_;                // the longest side
  std::vector<double> weight_; // of each side between two vertices
};

} // namespace

Developed<Plane_pieces> develop(const Plane_pieces& pieces) {
  Developer<Plane_pieces> developer(pieces);
  std::vector<std::uint32_t> fixed;
  for (const std::uint32_t i : by_extent(developer.result.extent)) {
    if (developer.is_placed(i)) continue;
    developer.spread_from(i, 1);
    fixed.push_back(pieces.vertex[pieces.begin[i]]);
  }
  Place_improver(pieces, fixed, developer).run();
  return std::move(developer.result);
}

} // namespace CGAL::Intrinsic_triangulations::internal
