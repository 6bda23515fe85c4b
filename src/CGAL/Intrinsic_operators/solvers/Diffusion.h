// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_SOLVERS_DIFFUSION_H
#define CGAL_INTRINSIC_OPERATORS_SOLVERS_DIFFUSION_H

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The time of a flow, a factor times a unit. Above 1e8 areas of the surface, heat is so even that
// rounding hides its gradients, and distances are those of 1e6 areas to six digits. Much below
// 1e-100 units, heat falls by 2^-800 along single edges.
// \throws std::invalid_argument if the factor is out of these limits
inline double flow_time(double factor, double unit, double area) {
  const double greatest = 1e8 * std::max(area / unit, 1.0);
  if (factor >= 1e-100 && factor <= greatest) return factor * unit;
  std::ostringstream message;
  message << "the time factor must be between 1e-100 and " << std::setprecision(2) << greatest
          << ", where heat has spread evenly, not " << factor;
  throw std::invalid_argument(message.str());
}

// x * 2^e, in two steps: the power of two alone may exceed the range of doubles.
template <class Scalar>
Scalar times_power_of_two(const Scalar& x, int e) {
  if (e == 0) return x;
  return x * std::ldexp(1.0, e / 2) * std::ldexp(1.0, e - e / 2);
}

// Whether the magnitude of a number is at least `least`; `std::abs()` of complex numbers is slow.
template <class Scalar>
bool is_at_least(const Scalar& x, double least) {
  return std::abs(std::real(x)) >= least || std::abs(std::imag(x)) >= least || std::abs(x) >= least;
}

// Heat after a short time. It decays like exp(-r / sqrt(time)), by hundreds of powers of ten over a
// large mesh, so values have separate exponents: the heat of row r is value[r] * 2^(exponent
// - step * level[r]).
template <class Scalar>
struct Heat {
  static constexpr int step = 800; // leaves 2^222 above the least normal double, for products
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit Heat(Vector v) : value(std::move(v)), level(static_cast<std::size_t>(value.size()), 0) {}

  // the value, as a multiple of 2^(exponent - step * l)
  Scalar at(Eigen::Index r, int l) const {
    const int steps = l - level[static_cast<std::size_t>(r)];
    // not reached: 0, whatever the level of others
    return steps == 0 || value[r] == Scalar(0) ? value[r]
                                               : value[r] * std::ldexp(1.0, step * steps);
  }

  // Scales the greatest value to about 1, and raises the level of values up to 2^-step, which would
  // leave the range of doubles.
  void normalize() {
    int first = std::numeric_limits<int>::max();
    double greatest = 0;
    for (Eigen::Index r = 0; r < value.size(); ++r) {
      const int l = level[static_cast<std::size_t>(r)];
      if (value[r] == Scalar(0) || l > first) continue;
      const double x = std::abs(value[r]);
      if (!(x > 0)) continue;
      greatest = l < first ? x : std::max(greatest, x);
      first = l;
    }
    if (!(greatest > 0)) return;
    const int e = std::ilogb(greatest);
    for (Eigen::Index r = 0; r < value.size(); ++r) {
      int& l = level[static_cast<std::size_t>(r)];
      l = std::max(0, l - first);
      if (value[r] == Scalar(0)) continue;
      const double x = std::abs(value[r]);
      if (!(x > 0)) continue;
      const int raised = std::max(0, (e - std::ilogb(x)) / step);
      value[r] = times_power_of_two(value[r], raised * step - e);
      l += raised;
    }
    exponent += e - step * first;
  }

  Vector value;
  std::vector<int> level;
  int exponent = 0;
};

// The quotient of heats in a row, zero where there is none below.
template <class Scalar>
Scalar heat_ratio(const Heat<Scalar>& above, const Heat<double>& below, Eigen::Index r) {
  if (!(below.value[r] > 0)) return 0;
  const auto i = static_cast<std::size_t>(r);
  const int e = above.exponent - below.exponent + below.step * (below.level[i] - above.level[i]);
  return times_power_of_two(above.value[r] / below.value[r], e);
}

// The natural logarithm of heat in a row, minus infinity where there is none.
inline double log_heat(const Heat<double>& heat, Eigen::Index r) {
  return std::log(heat.value[r]) +
         std::numbers::ln2 * (heat.exponent - heat.step * heat.level[static_cast<std::size_t>(r)]);
}

// Factors M + time L: for functions without subtraction; for vectors, which turn along edges, up to
// rounding.
inline Laplacian_factorization factored_flow(const Eigen::SparseMatrix<double>& laplacian,
                                             const Eigen::VectorXd& masses,
                                             Shared_analysis& analysis) {
  return {laplacian, masses, analysis};
}
inline Cholesky_factorization<std::complex<double>>
factored_flow(Eigen::SparseMatrix<std::complex<double>> laplacian, const Eigen::VectorXd& masses,
              Shared_analysis& analysis) {
  for (int r = 0; r < laplacian.cols(); ++r) laplacian.coeffRef(r, r) += masses[r];
  return raised_factorization(laplacian, analysis);
}

// Makes one implicit step of the heat flow, (M + time L) u = u0, for functions or vector fields.
template <Factorization Factored>
class Diffusion {
public:
  using Matrix = typename Factored::Matrix;
  using Scalar = typename Matrix::Scalar;
  using Vector = typename Heat<Scalar>::Vector;

  // \param laplacian L times the time, compressed, with its diagonal \param masses the diagonal of
  // M, positive \param analysis of a matrix with entries in the same places; set if there is none
  Diffusion(Matrix laplacian, const Eigen::VectorXd& masses, Shared_analysis& analysis)
      : laplacian_(std::make_shared<const Matrix>(std::move(laplacian))),
        factored_(factored_flow(*laplacian_, masses, analysis)) {}
  // \param factored the factorization of M + time L
  Diffusion(std::shared_ptr<const Matrix> laplacian, double time, Factored factored)
      : laplacian_(std::move(laplacian)), time_(time), factored_(std::move(factored)) {}

  // \param is_reached whether there is any heat in a row
  Heat<Scalar> operator()(const Vector& start, const std::vector<char>& is_reached) const {
    return std::move(all({Heat<Scalar>(start)}, {is_reached})[0]);
  }

  // From several starts at once, each with the rows that it reaches. The results are those of
  // single calls, bit by bit.
  std::vector<Heat<Scalar>> all(std::vector<Heat<Scalar>> starts,
                                const std::vector<std::span<const char>>& is_reached) const {
    typename Factored::Vectors right(laplacian_->rows(), static_cast<Eigen::Index>(starts.size()));
    for (std::size_t k = 0; k < starts.size(); ++k) {
      starts[k].normalize();
      for (Eigen::Index r = 0; r < right.rows(); ++r) right(r, column(k)) = starts[k].at(r, 0);
    }
    const typename Factored::Vectors found = factored_.solve(right);
    std::vector<Heat<Scalar>> result;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      result.emplace_back(Vector(found.col(column(k))));
      result[k].exponent = starts[k].exponent;
    }
    find_lost(result, starts, is_reached);
    return result;
  }

private:
  static Eigen::Index column(std::size_t k) { return static_cast<Eigen::Index>(k); }

  // Below the range of doubles, heat follows from the heat at the limit, as a source. Let w be u
  // where it is known, else zero. Then A (u - w) = u0 - A w, which is not zero only along the limit
  // and where u0 is below the range. It has the magnitude of the values there, and so can be
  // scaled.
  void find_lost(std::vector<Heat<Scalar>>& heat, const std::vector<Heat<Scalar>>& start,
                 const std::vector<std::span<const char>>& is_reached) const {
    std::vector<std::size_t> lost(heat.size()); // the numbers of heats that lose some at a level
    std::iota(lost.begin(), lost.end(), std::size_t{0});
    for (int level = 0; !lost.empty(); ++level) {
      typename Factored::Vectors limits(laplacian_->rows(), column(lost.size()));
      Eigen::Index columns = 0;
      std::erase_if(lost, [&](std::size_t k) {
        if (!mark_lost(heat[k], start[k], level, is_reached[k])) return true;
        const Vector limit = source_at_limit(heat[k], start[k], level);
        if (!(limit.cwiseAbs().maxCoeff() > 0)) return true;
        limits.col(columns++) = limit;
        return false;
      });
      if (lost.empty()) return;
      const typename Factored::Vectors found = factored_.solve(limits.leftCols(columns));
      for (std::size_t i = 0; i < lost.size(); ++i)
        for (Eigen::Index r = 0; r < found.rows(); ++r)
          if (heat[lost[i]].level[row_number(r)] > level)
            heat[lost[i]].value[r] = found(r, column(i));
    }
  }

  // Raises the level of values that are too small, except by cancellation of a source. \return
  // whether there are any, and this level has found some
  static bool mark_lost(Heat<Scalar>& heat, const Heat<Scalar>& start, int level,
                        std::span<const char> is_reached) {
    const double least = std::ldexp(1.0, -Heat<Scalar>::step);
    bool is_any_lost = false, is_any_found = false;
    for (Eigen::Index r = 0; r < heat.value.size(); ++r) {
      if (is_reached[row_number(r)] == 0 || heat.level[row_number(r)] != level) continue;
      if (is_at_least(heat.value[r], least) || is_at_least(start.at(r, level), least)) {
        is_any_found = true;
        continue;
      }
      heat.level[row_number(r)] = level + 1;
      is_any_lost = true;
    }
    return is_any_lost && is_any_found;
  }

  // u0 - A w where heat is lost, and A (u - w) next to it, scaled to the next level
  Vector source_at_limit(const Heat<Scalar>& heat, const Heat<Scalar>& start, int level) const {
    const double scale = std::ldexp(1.0, Heat<Scalar>::step);
    Vector source = Vector::Zero(heat.value.size());
    for (Eigen::Index r = 0; r < source.size(); ++r)
      if (heat.level[row_number(r)] > level) source[r] = start.at(r, level + 1);
    for (int c = 0; c < laplacian_->cols(); ++c)
      for (typename Matrix::InnerIterator i(*laplacian_, c); i; ++i) {
        const auto r = i.row();
        const int from = heat.level[row_number(c)], to = heat.level[row_number(r)];
        if (from == level && to > level)
          source[r] -= time_ * i.value() * (heat.value[c] * scale);
        else if (from > level && to == level)
          source[r] += time_ * i.value() * (heat.value[c] * scale);
      }
    return source;
  }

  std::shared_ptr<const Matrix>
      laplacian_; // with the time, which differs from the matrix on its diagonal
  double time_ = 1;
  Factored factored_;
};

class Function_flow : public Diffusion<Laplacian_factorization> {
public:
  using Diffusion::Diffusion;
};
class Vector_flow : public Diffusion<Cholesky_factorization<std::complex<double>>> {
public:
  using Diffusion::Diffusion;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_SOLVERS_DIFFUSION_H
