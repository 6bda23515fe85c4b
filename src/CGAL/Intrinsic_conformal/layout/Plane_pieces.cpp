// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

double Plane_pieces::extent(std::uint32_t p) const {
  double longest = 0;
  for (std::uint32_t c = begin[p]; c < begin[p + 1]; ++c)
    longest = std::max(longest, std::abs(side[c]));
  return longest;
}

namespace {

// Development of pieces, and its improvement.
class Piece_developer {
public:
  using Complex = Plane_pieces::Complex;

  explicit Piece_developer(const Plane_pieces& pieces)
      : p_(pieces), piece_of_side_(pieces.piece_of_corner()),
        is_placed_(pieces.number_of_vertices, 0) {
    result_.position.assign(pieces.number_of_vertices, 0);
    result_.rotation.assign(pieces.size(), 0);
    for (std::uint32_t i = 0; i < p_.size(); ++i) unit_ = std::max(unit_, p_.extent(i));
  }

  Developed_pieces run() {
    for (const std::uint32_t i : by_extent())
      if (result_.rotation[i] == 0.) spread_from(i);
    result_.largest_error = largest_error(result_.position);
    improve();
    return std::move(result_);
  }

private:
  // The pieces, small ones first: a component begins at the origin with its smallest piece, because
  // doubles are densest there.
  std::vector<std::uint32_t> by_extent() const {
    std::vector<double> extent(p_.size());
    for (std::uint32_t i = 0; i < p_.size(); ++i) extent[i] = p_.extent(i);
    std::vector<std::uint32_t> result(p_.size());
    std::iota(result.begin(), result.end(), 0U);
    std::stable_sort(result.begin(), result.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return extent[i] < extent[j]; });
    return result;
  }

  // A side across which a piece is reached: by how small that is, then in the order of discovery.
  struct Step {
    int scale;
    std::size_t number;
    std::uint32_t corner;
    bool operator>(const Step& s) const {
      return std::pair(scale, number) > std::pair(s.scale, s.number);
    }
  };

  // Lays out the component of a piece: breadth first within classes of size, each a thousand
  // times as large as the one before, and small classes first. Thus pieces between the corners of
  // a needle follow from each other: if large ones around led to them from all sides, they would
  // have the errors of those.
  void spread_from(std::uint32_t first) {
    fixed_.push_back(p_.vertex[p_.begin[first]]);
    is_placed_[fixed_.back()] = 1;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
    std::size_t steps = 0;
    const auto reach = [&](std::uint32_t i, std::uint32_t corner, Complex rotation) {
      result_.rotation[i] = rotation;
      place(i, corner);
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c)
        if (p_.glue[c] != Gluing::none)
          queue.push({size_class(piece_of_side_[p_.glue[c]]), steps++, c});
    };
    reach(first, p_.begin[first], 1);
    while (!queue.empty()) {
      const std::uint32_t c = queue.top().corner, j = piece_of_side_[p_.glue[c]];
      queue.pop();
      if (result_.rotation[j] != 0.) continue;
      const Complex r = result_.rotation[piece_of_side_[c]] * p_.turn[c];
      reach(j, p_.glue[c], r / std::abs(r)); // the length is 1 but for rounding
    }
  }

  // At most 0, by the largest piece, so that classes do not depend on the unit of lengths.
  int size_class(std::uint32_t i) const { return std::ilogb(p_.extent(i) / unit_) / 10; }

  // Places the corners of a piece, of which corner `c` has a place.
  void place(std::uint32_t i, std::uint32_t c) {
    Complex z = result_.position[p_.vertex[c]];
    for (std::uint32_t n = p_.begin[i]; n < p_.begin[i + 1]; ++n, c = p_.next(i, c)) {
      char& placed = is_placed_[p_.vertex[c]];
      if (placed == 0) result_.position[p_.vertex[c]] = z;
      placed = 1;
      z += result_.rotation[i] * p_.side[c];
    }
  }

  // Calls a function with the ends of each side of each piece, with its vector in the plane, and
  // its piece.
  template <class Function>
  void for_each_side(const Function& f) const {
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c)
        f(p_.vertex[c], p_.vertex[p_.next(i, c)], result_.rotation[i] * p_.side[c], i);
  }

  double largest_error(const std::vector<Complex>& z) const {
    double largest = 0;
    for_each_side([&](std::uint32_t a, std::uint32_t b, Complex side, std::uint32_t i) {
      const double extent = p_.extent(i);
      if (extent > 0) largest = std::max(largest, std::abs(z[b] - z[a] - side) / extent);
    });
    return largest;
  }

  // 1 / length^2. A side shorter than a millionth of its piece counts as so long: it may be a point
  // but for rounding. So does one shorter than a billionth of the distance of its start from the
  // origin: the rounding of that place, times a greater weight, would move all others. 1e-50 keeps
  // weights finite.
  double weight(Complex side, std::uint32_t i, Complex from) const {
    const double length =
        std::max({std::abs(side), 1e-6 * p_.extent(i), 0x1p-30 * std::abs(from), 1e-50 * unit_});
    return unit_ / length * (unit_ / length);
  }

  // Solves for changes of the places, until the largest error does not fall.
  void improve() {
    const auto n = static_cast<Eigen::Index>(p_.number_of_vertices);
    std::vector<Eigen::Triplet<double>> entries;
    for_each_side([&](std::uint32_t a, std::uint32_t b, Complex side, std::uint32_t i) {
      if (a == b) return;
      const int v = static_cast<int>(a), w = static_cast<int>(b);
      const double by = weight(side, i, result_.position[a]);
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
    const Laplacian_factorization factor(laplacian, diagonal);
    for (int round = 0; round < 3; ++round) {
      std::vector<Complex> z = changed(factor);
      const double error = largest_error(z);
      if (!(error < result_.largest_error)) return;
      result_.largest_error = error;
      result_.position = std::move(z);
    }
  }

  std::vector<Complex> changed(const Laplacian_factorization& factor) const {
    std::vector<Complex> z = result_.position;
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
  std::vector<std::uint32_t> piece_of_side_;
  std::vector<char> is_placed_;
  std::vector<std::uint32_t> fixed_; // a vertex of each component
  double unit_ = 0; // the longest side
  std::vector<double> weight_; // of each side between two vertices
  Developed_pieces result_;
};

} // namespace

Developed_pieces develop(const Plane_pieces& pieces) { return Piece_developer(pieces).run(); }

} // namespace CGAL::Intrinsic_triangulations::internal
