// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Angle_system.h>
#include <CGAL/Intrinsic_conformal/metric/angle_enclosures.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Larger changes of u make needles of good triangles. On meshes of the data set that are stretched
// by 100, steps without a bound take 2.7 times as long, and steps up to 2 take 1.5 times as long;
// both leave one of 100 metrics unsolved.
constexpr double longest_step = 8;

// The factors exp(u/2) at rows. Doubles have too few digits: beside a needle of 1e-9 of the edges
// around it, a unit in the last place changes angles by 1e-7.
using Factors = std::vector<Double_double>;

// exp(x), with an error of 2^-64 of its difference from 1: small changes of factors keep all
// digits.
Double_double exponential(double x) {
  const bool is_small = std::abs(x) < 0.5;
  const long double wide = x, value = is_small ? std::expm1(wide) : std::exp(wide);
  const auto rounded = static_cast<double>(value);
  const Double_double result =
      Double_double(rounded) + Double_double(static_cast<double>(value - rounded));
  return is_small ? Double_double(1) + result : result;
}

// twice the logarithm of a factor
double logarithmic_scale(const Double_double& factor) {
  return static_cast<double>(2 *
                             std::log(static_cast<long double>(factor.to_double()) + rest(factor)));
}

// Newton's method.
class Conformal_newton {
public:
  Conformal_newton(Ideal_surface& surface, const Prescribed_angles& angles,
                   const Conformal_options& options)
      : surface_(surface), options_(options), factors_(surface.number_of_rows(), 1.) {
    surface_.read(faces_);
    components_ = components_of(faces_, surface.number_of_rows());
    prescribe(angles);
    system_.emplace(components_, is_fixed_, options.geometry);
    go_to(Factors(factors_));
    if (is_hyperbolic()) match_areas();
  }

  Conformal_metric solve();

private:
  bool is_hyperbolic() const { return options_.geometry == Geometry::hyperbolic; }
  void prescribe(const Prescribed_angles& angles);
  // Scales by factors with which angles may be out of reach.
  void go_to(Factors factors) {
    excess_ = excess_at(factors).value_or(Eigen::VectorXd::Constant(total_.size(), infinity));
    factors_ = std::move(factors);
  }
  // Scales by factors. \return angles minus prescribed ones, zero where it is free; nothing if they
  // cannot be computed
  std::optional<Eigen::VectorXd> excess_at(const Factors& factors);
  // The factors after a change of u.
  Factors changed(const Eigen::VectorXd& u) const;
  // Changes u, unless angles cannot be computed then. \return whether it did
  bool change(const Eigen::VectorXd& u);
  double residual(const Eigen::VectorXd& excess) const {
    return excess.size() == 0 ? 0 : excess.lpNorm<Eigen::Infinity>() / surface_.sheets();
  }
  // Whether the rounding of factors may be all that is left of the excess.
  bool is_rounding() const;
  // Takes steps until the status of the result is known.
  void iterate(Conformal_metric& result);
  // Takes one more step, unless the residual is rounding. Layouts need more than the tolerance, and
  // a step nearly squares the residual.
  void polish(Conformal_metric& result);
  // Goes where the lambda lengths at a vertex have the mean of all: where they differ by many
  // powers of ten, triangles are needles whose angles are lost in rounding.
  void balance();
  // Scales hyperbolic components without fixed rows such that their triangles, in Euclid's plane,
  // have the areas that prescribed angles leave to them: small triangles are nearly Euclidean.
  void match_areas();
  // Goes along Newton's direction. \return the part of it, or zero: rounding hides a better place
  double step();

  Ideal_surface& surface_;
  const Conformal_options& options_;
  std::vector<Ideal_face> faces_;
  Ideal_components components_;
  std::vector<char> is_fixed_;
  Eigen::VectorXd total_; // prescribed angle of each row, on all sheets
  std::optional<Angle_system> system_;
  Factors factors_;
  Eigen::VectorXd excess_;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double least_ = infinity;     // norm of the excess up to now
  double reach_ = longest_step; // a change of u up to which the next step is tried
  std::size_t flips_ = 0;
};

void Conformal_newton::prescribe(const Prescribed_angles& angles) {
  std::vector<double> correction(components_.faces.size(), 0);
  if (is_hyperbolic())
    check_hyperbolic_angles(angles, components_.of_row, components_.faces, surface_.sheets());
  else
    correction =
        checked_gauss_bonnet(angles, components_.of_row, components_.faces, surface_.sheets());
  total_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(factors_.size()));
  for (std::size_t r = 0; r < angles.size(); ++r) {
    const std::uint32_t c = components_.of_row[r];
    is_fixed_.push_back(c == Gluing::none || angles.is_free(r) ? 1 : 0);
    if (is_fixed_[r] == 0)
      total_[static_cast<Eigen::Index>(r)] =
          surface_.sheets() * (angles.radians(r) + correction[c]);
  }
}

Factors Conformal_newton::changed(const Eigen::VectorXd& u) const {
  Factors result(factors_);
  for (std::size_t r = 0; r < result.size(); ++r)
    if (const double x = u[static_cast<Eigen::Index>(r)]; x != 0)
      result[r] = result[r] * exponential(x / 2);
  return result;
}

bool Conformal_newton::change(const Eigen::VectorXd& u) {
  Factors factors = changed(u);
  std::optional<Eigen::VectorXd> excess = excess_at(factors);
  if (!excess) return false;
  factors_ = std::move(factors);
  excess_ = *std::move(excess);
  return true;
}

std::optional<Eigen::VectorXd> Conformal_newton::excess_at(const Factors& factors) {
  const std::optional<std::size_t> flips = surface_.scale(factors);
  if (!flips) return std::nullopt;
  flips_ += *flips;
  surface_.read(faces_);
  system_->read(faces_, std::ldexp(1., -surface_.scale_exponent()));
  Eigen::VectorXd excess = system_->angle_sums() - total_;
  for (std::size_t r = 0; r < factors.size(); ++r)
    if (is_fixed_[r] != 0) excess[static_cast<Eigen::Index>(r)] = 0;
  return excess;
}

void Conformal_newton::match_areas() {
  std::vector<double> wanted, area(components_.faces.size(), 0);
  for (const std::size_t faces : components_.faces)
    wanted.push_back(static_cast<double>(faces) * std::numbers::pi);
  const auto component = [this](int row) {
    return components_.of_row[static_cast<std::size_t>(row)];
  };
  for (const Ideal_face& f : faces_) area[component(f.rows[0])] += f.area();
  std::vector<char> is_kept(area.size(), 0);
  for (std::size_t r = 0; r < is_fixed_.size(); ++r)
    if (const std::uint32_t c = components_.of_row[r]; c != Gluing::none) {
      wanted[c] -= total_[static_cast<Eigen::Index>(r)];
      if (is_fixed_[r] != 0) is_kept[c] = 1;
    }
  const double unit = surface_.scale_exponent() * -std::numbers::ln2; // its logarithm
  Eigen::VectorXd u = Eigen::VectorXd::Zero(total_.size());
  for (std::size_t r = 0; r < is_fixed_.size(); ++r)
    if (const std::uint32_t c = components_.of_row[r];
        c != Gluing::none && is_kept[c] == 0 && area[c] > 0)
      u[static_cast<Eigen::Index>(r)] = std::log(wanted[c] / area[c]) / 2 - unit;
  go_to(changed(u));
}

// The energy is convex. At the end of the step its derivative along it may be positive by a tenth
// of what it is at the start: at the minimum rounding decides on its sign. The norm of the excess
// must not rise either, but by some slack for rounding: Newton's direction makes it fall at first,
// and where it rises, a vertex gets dozens of needles from all over the surface, with an excess of
// hundreds of radians that later steps hardly reduce. Of the 100 metrics above, a slack of 1 leaves
// one unsolved, and none at all leaves two.
double Conformal_newton::step() {
  // a shorter part of the longest step, 8, changes u by 1e-8: no step from there converges
  constexpr double shortest = 0x1p-30, slack = 1.05;
  Eigen::VectorXd direction;
  try {
    direction = system_->solve(excess_);
  } catch (const Indefinite_matrix&) { // weights differ by more than doubles can
    return 0;
  }
  const double slope = -direction.dot(excess_);
  const double largest = direction.lpNorm<Eigen::Infinity>();
  if (!(slope < 0) || !std::isfinite(largest)) return 0; // no angles at the start among others
  least_ = std::min(least_, excess_.norm());
  // The energy whose gradient is the excess is convex. A step is good if it does not go past its
  // least value by more than a tenth of the slope (Wolfe's second rule); tests fail without.
  for (double part = std::min(1., reach_ / largest); part >= shortest; part /= 2) {
    Factors factors = changed(part * direction);
    std::optional<Eigen::VectorXd> excess = excess_at(factors);
    if (excess && -direction.dot(*excess) <= -slope / 10 && excess->norm() <= slack * least_) {
      least_ = std::min(least_, excess->norm());
      reach_ = std::min(longest_step, 4 * part * largest);
      factors_ = std::move(factors);
      excess_ = *std::move(excess);
      return part;
    }
  }
  return 0;
}

void Conformal_newton::balance() {
  // Two are enough in a test, for factors over twenty powers of ten. No metric of the data set
  // needs any, so that more of them take no time.
  constexpr int sweeps = 30;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<double> sum(factors_.size(), 0), count(factors_.size(), 0);
    double mean = 0;
    for (const Ideal_face& f : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        const double logarithm = std::log(f.lambda[k]);
        mean += logarithm / (3 * static_cast<double>(faces_.size()));
        for (const int row : {f.rows[k], f.rows[(k + 1) % 3]}) {
          sum[static_cast<std::size_t>(row)] += logarithm;
          ++count[static_cast<std::size_t>(row)];
        }
      }
    Eigen::VectorXd u = Eigen::VectorXd::Zero(total_.size());
    for (std::size_t r = 0; r < count.size(); ++r)
      if (is_fixed_[r] == 0) u[static_cast<Eigen::Index>(r)] = mean - sum[r] / count[r];
    system_->centre(u);
    if (!change(u)) break;
  }
  if (is_hyperbolic()) match_areas();
}

// An error of a unit in the last place of a factor changes u by twice as much, and angles by that
// times the weights of the edges at the vertex, which needles make large.
bool Conformal_newton::is_rounding() const {
  // of good triangles, in radians: a step squares it, which leaves less than rounding
  constexpr double near = 1e-8;
  constexpr double unit = 0x1p-52;
  return (excess_.cwiseAbs() - 2 * unit * system_->weights()).maxCoeff() <= near;
}

void Conformal_newton::iterate(Conformal_metric& result) {
  result.residual = residual(excess_);
  least_ = excess_.norm();
  reach_ = longest_step;
  result.status = Status::cap;
  while (result.residual > options_.tolerance && result.iterations < options_.maximum_iterations) {
    const Factors before = factors_;
    const bool was_rounding = is_rounding();
    const double part = step();
    ++result.iterations;
    const double now = residual(excess_);
    // Near the solution a step that does not help much ends at rounding errors.
    if (part == 0 || (was_rounding && now > result.residual / 2)) {
      if (part == 0 || now >= result.residual)
        go_to(before);
      else
        result.residual = now;
      result.status = Status::stalled;
      break;
    }
    result.residual = now;
    if (!options_.progress({result.iterations, now, part, flips_})) {
      result.status = Status::cancelled;
      break;
    }
  }
  if (result.residual <= options_.tolerance) result.status = Status::done;
}

void Conformal_newton::polish(Conformal_metric& result) {
  const Factors before = factors_;
  if (result.residual <= options_.tolerance * 0x1p-10 || !change(system_->solve(excess_))) return;
  ++result.iterations;
  if (const double now = residual(excess_); now < result.residual)
    result.residual = now;
  else
    go_to(before);
}

Conformal_metric Conformal_newton::solve() {
  Conformal_metric result;
  iterate(result);
  if (result.status == Status::stalled && !is_rounding()) {
    const Factors factors = factors_;
    const double before = result.residual;
    balance();
    iterate(result);
    if (result.residual > before) {
      go_to(factors);
      result.residual = before;
    }
  }
  if (result.status == Status::done) polish(result);
  result.flips = flips_;
  for (const Double_double& w : factors_) {
    result.u.push_back(logarithmic_scale(w));
    result.scale_factors.push_back(w.to_double());
    result.scale_rests.push_back(rest(w));
  }
  return result;
}

} // namespace

Conformal_metric conformal_metric(Ideal_surface& surface, const Prescribed_angles& angles,
                                  const Conformal_options& options) {
  Conformal_metric result = Conformal_newton(surface, angles, options).solve();
  result.proven_residual = proven_residual(surface, result, angles, options.geometry);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
