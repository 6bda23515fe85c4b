// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Angle_system.h>
#include <CGAL/Intrinsic_conformal/angles/triangle_angles.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Angle_system::Weight& Angle_system::Weight::operator+=(const Weight& other) {
  sum += other.sum;
  size += other.size;
  return *this;
}

Angle_system::Angle_system(const Ideal_components& components, const std::vector<char>& is_fixed,
                           Geometry geometry)
    : components_(components), geometry_(geometry),
      is_pinned_(components.faces.size(), geometry == Geometry::euclidean ? 1 : 0),
      unknown_(components.of_row.size(), fixed) {
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (components.of_row[r] != Gluing::none && is_fixed[r] != 0)
      is_pinned_[components.of_row[r]] = 0;
  std::vector<char> needs_pin = is_pinned_;
  for (std::size_t r = 0; r < unknown_.size(); ++r) {
    if (components.of_row[r] == Gluing::none || is_fixed[r] != 0) continue;
    if (char& pin = needs_pin[components.of_row[r]]; pin != 0)
      pin = 0;
    else
      unknown_[r] = number_of_unknowns_++;
  }
}

void Angle_system::read(const std::vector<Ideal_face>& faces, double unit) {
  sums_ = excess_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknown_.size()));
  factor_.reset();
  edges_.assign(3 * faces.size() / 2, Weighted_edge());
  for (const Ideal_face& f : faces) {
    const bool is_hyperbolic = geometry_ == Geometry::hyperbolic;
    std::array<double, 3> sides{f.lambda[1], f.lambda[2], f.lambda[0]}, // opposite the corners
        surplus{f.surplus[1], f.surplus[2], f.surplus[0]};
    if (is_hyperbolic)
      for (std::size_t k = 0; k < 3; ++k) {
        sides[k] *= unit;
        surplus[k] *= unit;
      }
    const Triangle_angles t =
        is_hyperbolic ? hyperbolic_angles(sides, surplus) : euclidean_angles(sides, surplus);
    for (std::size_t k = 0; k < 3; ++k) {
      sums_[f.rows[k]] += t.angle[k];
      const int i = f.rows[(k + 1) % 3], j = f.rows[(k + 2) % 3];
      for (const int row : {i, j}) excess_[row] += t.excess[k];
      const std::size_t e = f.edges[(k + 1) % 3];
      if (e >= edges_.size()) edges_.resize(e + 1);
      edges_[e].i = i;
      edges_[e].j = j;
      if (i != j) edges_[e].value += {t.weight[k], std::abs(t.weight[k])};
    }
  }
}

Eigen::VectorXd Angle_system::weights() const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(sums_.size());
  for (const Weighted_edge& e : edges_)
    if (e.i != fixed)
      for (const int row : {e.i, e.j}) result[row] += e.value.size;
  return result;
}

Eigen::SparseMatrix<double> Angle_system::matrix(Eigen::VectorXd& diagonal) const {
  diagonal = Eigen::VectorXd::Zero(number_of_unknowns_);
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (unknown_[r] != fixed) diagonal[unknown_[r]] = excess_[static_cast<Eigen::Index>(r)];
  std::vector<Weighted_edge> between;
  between.reserve(edges_.size());
  for (const Weighted_edge& e : edges_) {
    if (e.i == e.j) continue; // none, or a loop
    const int i = unknown_[static_cast<std::size_t>(e.i)],
              j = unknown_[static_cast<std::size_t>(e.j)];
    if (i != fixed && j != fixed)
      between.push_back({i, j, e.value});
    else if (i != fixed || j != fixed)
      diagonal[std::max(i, j)] += e.value.sum;
  }
  diagonal = diagonal.cwiseMax(0);
  // Edges of a Delaunay triangulation have no negative weight but by rounding. Where all digits are
  // lost, the weight is as large as the error, so that no vertex comes apart from the others.
  constexpr double error = 0x1p-50;
  return Symmetric_columns<Weight>(between, number_of_unknowns_)
      .matrix([](int, auto) { return Weight{}; },
              [](const Weight& w) { return std::min(-w.sum, -error * w.size); });
}

bool Angle_system::has_same_pattern(const Eigen::SparseMatrix<double>& m) const {
  return analysis_ && m.nonZeros() == last_.nonZeros() &&
         std::equal(m.outerIndexPtr(), m.outerIndexPtr() + m.cols() + 1, last_.outerIndexPtr()) &&
         std::equal(m.innerIndexPtr(), m.innerIndexPtr() + m.nonZeros(), last_.innerIndexPtr());
}

// Flips leave an order of elimination nearly as good as it was: on the data set a new one wherever
// the factor grows saves no time. But for rounding, orders only differ in time.
void Angle_system::analyze(const Eigen::SparseMatrix<double>& m) {
  analysis_ = analysis_ ? std::make_shared<const Symbolic_factorization>(m, analysis_->row)
                        : std::make_shared<const Symbolic_factorization>(m);
}

void Angle_system::factor() {
  Eigen::VectorXd diagonal;
  Eigen::SparseMatrix<double> m = matrix(diagonal);
  if (!has_same_pattern(m)) analyze(m);
  factor_.emplace(m, diagonal, analysis_);
  last_ = std::move(m);
}

Eigen::VectorXd Angle_system::solve(Eigen::VectorXd b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  if (number_of_unknowns_ == 0) return x;
  if (!factor_) factor();
  centre(b); // or the row that is left out takes the rounding errors of all others
  Eigen::VectorXd right(number_of_unknowns_);
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (unknown_[r] != fixed) right[unknown_[r]] = b[static_cast<Eigen::Index>(r)];
  const Eigen::VectorXd solution = factor_->solve(right);
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (unknown_[r] != fixed) x[static_cast<Eigen::Index>(r)] = solution[unknown_[r]];
  centre(x);
  return x;
}

void Angle_system::centre(Eigen::VectorXd& x) const {
  std::vector<double> sum(is_pinned_.size(), 0), count(is_pinned_.size(), 0);
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (const std::uint32_t c = components_.of_row[r]; c != Gluing::none) {
      sum[c] += x[static_cast<Eigen::Index>(r)];
      ++count[c];
    }
  for (std::size_t r = 0; r < unknown_.size(); ++r)
    if (const std::uint32_t c = components_.of_row[r]; c != Gluing::none && is_pinned_[c] != 0)
      x[static_cast<Eigen::Index>(r)] -= sum[c] / count[c];
}

} // namespace CGAL::Intrinsic_triangulations::internal
