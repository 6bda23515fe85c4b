// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIFFUSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIFFUSION_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/Cholesky_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Heat after a short time. It decays like exp(-r / sqrt(time)), by hundreds of powers of ten over a large mesh, so that values have
// an exponent of their own: that of row r is value[r] * 2^(-step * level[r]).
template <class Scalar>
struct Heat {
  static constexpr int step = 800;
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> value;
  std::vector<int> level;

  // the value, as a multiple of 2^(-step * l)
  Scalar at(Eigen::Index r, int l) const {
    const int steps = l - level[static_cast<std::size_t>(r)];
    // not reached: 0, whatever the level of others
    return steps == 0 || value[r] == Scalar(0) ? value[r]
                                               : value[r] * std::ldexp(1.0, step * steps);
  }
};

// Makes one implicit step of the heat flow, (M + time L) u = u0, for functions or vector fields.
template <class Scalar>
class Diffusion {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

public:
  explicit Diffusion(Eigen::SparseMatrix<Scalar> matrix)
      : matrix_(std::move(matrix)), factored_(matrix_) {}

  // Where heat is below the range of doubles, it is found again from the heat at the limit, as a source: let w be u where it is
  // known, else zero; then A (u - w) = u0 - A w, which is not zero along the limit only. It has the magnitude of the values
  // there, and so can be scaled.
  // \param is_reached whether there is any heat in a row
  Heat<Scalar> operator()(const Vector& start, const std::vector<char>& is_reached) const {
    Heat<Scalar> heat{factored_.solve(start), std::vector<int>(is_reached.size(), 0)};
    for (int level = 0; mark_lost(heat, level, is_reached); ++level) {
      const Vector limit = source_at_limit(heat, level);
      if (!(limit.cwiseAbs().maxCoeff() > 0)) break;
      const Vector found = factored_.solve(limit);
      for (Eigen::Index r = 0; r < found.size(); ++r)
        if (heat.level[number(r)] > level) heat.value[r] = found[r];
    }
    return heat;
  }

private:
  static std::size_t number(Eigen::Index i) { return static_cast<std::size_t>(i); }

  // Raises the level of what is too small. \return whether there is any, and some has been found on this level
  static bool mark_lost(Heat<Scalar>& heat, int level, const std::vector<char>& is_reached) {
    const double least = std::ldexp(1.0, -Heat<Scalar>::step);
    bool is_any_lost = false, is_any_found = false;
    for (Eigen::Index r = 0; r < heat.value.size(); ++r) {
      if (is_reached[number(r)] == 0 || heat.level[number(r)] != level) continue;
      if (std::abs(heat.value[r]) >= least) {
        is_any_found = true;
        continue;
      }
      heat.level[number(r)] = level + 1;
      is_any_lost = true;
    }
    return is_any_lost && is_any_found;
  }

  // -A w where heat is lost, and A (u - w) next to it, scaled to the next level
  Vector source_at_limit(const Heat<Scalar>& heat, int level) const {
    const double scale = std::ldexp(1.0, Heat<Scalar>::step);
    Vector source = Vector::Zero(heat.value.size());
    for (int c = 0; c < matrix_.cols(); ++c)
      for (typename Eigen::SparseMatrix<Scalar>::InnerIterator i(matrix_, c); i; ++i) {
        const auto r = i.row();
        const int from = heat.level[number(c)], to = heat.level[number(r)];
        if (from == level && to > level)
          source[r] -= i.value() * (heat.value[c] * scale);
        else if (from > level && to == level)
          source[r] += i.value() * (heat.value[c] * scale);
      }
    return source;
  }

  Eigen::SparseMatrix<Scalar> matrix_;
  Cholesky_factorization<Scalar> factored_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_DIFFUSION_H
