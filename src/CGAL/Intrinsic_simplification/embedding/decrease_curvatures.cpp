// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The matrix has one positive eigenvalue, all others are negative. Elimination without pivoting is
// right nearly always; if not, the residual shows it.
bool solve_symmetric(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b,
                     Eigen::VectorXd& x) {
  const auto is_solved = [&] { return x.allFinite() && (a * x - b).norm() <= 1e-6 * b.norm(); };
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> symmetric(a);
  if (symmetric.info() == Eigen::Success) {
    x = symmetric.solve(b);
    if (x.allFinite()) x += symmetric.solve(b - a * x);
    if (is_solved()) return true;
  }
  Eigen::SparseLU<Eigen::SparseMatrix<double>> general(a);
  if (general.info() != Eigen::Success) return false;
  x = general.solve(b);
  return is_solved();
}

// Newton steps to one place of the path. Mostly they are enough, or the place is too far. Where
// faces are hardly bent, full steps leave the curvatures that are allowed, however near the place
// is: many short ones are the remedy, twice as many after each failure.
constexpr int few_steps = 12;

// Changes radii from those before, whose base may have been another one.
// \return whether all squares are positive
bool change_radii(Apex_radii& radii, const Apex_radii& before, const Eigen::VectorXd& less) {
  for (std::uint32_t v = 0; v < radii.weights.size(); ++v) { // weights are squares of radii
    radii.weights[v] = radii.weights[v] - Double_double(2 * before[v] * less[v]);
    if (!(radii.squared(v).to_double() > 0)) return false;
  }
  radii.balance();
  return true;
}

// Parts of the curvatures of the surface, by vertex: what is left around radii, and what is lost.
struct Curvature_parts {
  std::vector<double> left, lost;

  std::size_t size() const { return left.size(); }
  double smaller(std::size_t v) const { return std::min(left[v], lost[v]); }
};

// Radii whose curvatures go from wanted ones to others, between 0 and those of the surface.
class Curvature_path {
public:
  Curvature_path(Glued_pyramids& p, Embedding_run& run) : p_(p), run_(run) {}

  // \return whether there are radii with nearly the same part of all curvatures
  bool start();
  // How near curvatures must come, relative to their distance from the bounds, in how many steps.
  struct Effort {
    double near;
    int most_steps;
  };
  // goes to a part of all curvatures
  // \return whether it is reached
  bool go_to_part(double part, const Effort& effort);

private:
  bool go_far_away(double area);
  bool go_to(const Curvature_parts& wanted, const Effort& effort);
  Curvature_parts now() const { return {pyramids_.curvature, pyramids_.lost}; }
  Curvature_parts parts(double left) const;
  double excess(const Curvature_parts& wanted, std::size_t v) const;
  double distance(const Curvature_parts& wanted) const;
  double norm(const Curvature_parts& wanted) const;
  bool is_inside(const Curvature_parts& before, const Curvature_parts& wanted) const;
  bool improve(Glued_pyramids& trial, const Curvature_parts& wanted);
  void rescale(Glued_pyramids& trial, const Curvature_parts& wanted);

  Glued_pyramids& p_;
  Embedding_run& run_;
  std::vector<double> most_; // curvatures of the surface
  Pyramids pyramids_;        // of the trial
};

// An apex so far away that no vertex has lost half of its curvature.
bool Curvature_path::go_far_away(double area) {
  constexpr double least = 1e-20; // of what is lost: pyramids have 32 digits
  for (double lost = .5; lost > least; lost /= 4) {
    p_.radii.base = area / (4 * std::numbers::pi * lost);
    p_.curvature_left = 1 - lost;
    if (!pyramids_.build(p_.triangles, p_.radii)) continue;
    bool is_inside = true;
    for (std::size_t v = 0; v < p_.radii.weights.size(); ++v)
      is_inside = is_inside && pyramids_.lost[v] <= pyramids_.curvature[v];
    if (is_inside) return true;
  }
  return false;
}

/*
From an apex far away, at the distance R, the radius of a vertex has lost the area of its power cell
by R^2 of the curvature. Areas in proportion to curvatures are a problem of optimal transport, which
Newton's method solves: Kitagawa, Merigot, Thibert, "Convergence of a Newton algorithm for
semi-discrete optimal transport" (2019). On needles areas must change by powers of ten. So their
logarithms go to the wanted ones in steps.
*/
bool Curvature_path::start() {
  Metric_triangles& t = p_.triangles;
  if (!flip_to_convex(t, p_.radii.weights)) return false; // equal weights: it is Delaunay then
  if (!go_far_away(area_of(t))) return false;
  const Curvature_parts first = now();
  for (std::size_t v = 0; v < first.size(); ++v) most_.push_back(first.left[v] + first.lost[v]);
  const Curvature_parts last = parts(p_.curvature_left);
  double step = 1, done = 0;
  int most = few_steps;
  while (done < 1 && run_.goes_on() && !run_.is_over()) {
    const double next = std::min(1., done + step);
    Curvature_parts wanted = first;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
      wanted.lost[v] = std::pow(first.lost[v], 1 - next) * std::pow(last.lost[v], next);
      wanted.left[v] = most_[v] - wanted.lost[v];
    }
    const bool is_reached = go_to(wanted, {0.1, most});
    if (is_reached) done = next;
    step *= is_reached ? 1.5 : 0.5;
    most = is_reached ? few_steps : 2 * most;
    if (step < 1e-4) return false;
  }
  return done == 1;
}

Curvature_parts Curvature_path::parts(double left) const {
  Curvature_parts result;
  for (const double k : most_) {
    result.left.push_back(left * k);
    result.lost.push_back((1 - left) * k);
  }
  return result;
}

// of what is left; the part that is smaller is known better
double Curvature_path::excess(const Curvature_parts& wanted, std::size_t v) const {
  return wanted.left[v] < wanted.lost[v] ? pyramids_.curvature[v] - wanted.left[v]
                                         : wanted.lost[v] - pyramids_.lost[v];
}

double Curvature_path::distance(const Curvature_parts& wanted) const {
  double result = 0;
  for (std::size_t v = 0; v < wanted.size(); ++v)
    result = std::max(result, std::abs(excess(wanted, v)) / wanted.smaller(v));
  return result;
}

double Curvature_path::norm(const Curvature_parts& wanted) const {
  double squared = 0;
  for (std::size_t v = 0; v < wanted.size(); ++v)
    squared += CGAL::square(excess(wanted, v)) / wanted.smaller(v);
  return std::sqrt(squared);
}

// Curvatures may come nearer to a bound by half, or up to half of the wanted distance.
bool Curvature_path::is_inside(const Curvature_parts& before, const Curvature_parts& wanted) const {
  for (std::size_t v = 0; v < wanted.size(); ++v)
    if (pyramids_.curvature[v] < std::min(before.left[v], wanted.left[v]) / 2 ||
        pyramids_.lost[v] < std::min(before.lost[v], wanted.lost[v]) / 2)
      return false;
  return true;
}

bool Curvature_path::improve(Glued_pyramids& trial, const Curvature_parts& wanted) {
  const Curvature_parts before = now();
  const double norm_before = norm(wanted);
  const Eigen::Index n = static_cast<Eigen::Index>(wanted.size());
  Eigen::VectorXd too_much(n), change(n);
  for (Eigen::Index v = 0; v < n; ++v) too_much[v] = excess(wanted, static_cast<std::size_t>(v));
  if (!run_.goes_on()) return false;
  run_.count_step();
  // Far away, all radii together hardly change any curvature: that is solved apart, by the sums.
  const Eigen::VectorXd by_base = pyramids_.derivatives_by_base(trial.triangles, trial.radii);
  const double base_change = -too_much.sum() / by_base.sum();
  too_much += base_change * by_base;
  if (!solve_symmetric(pyramids_.derivatives(trial.triangles, trial.radii), too_much, change))
    return false;
  for (double factor = 1; factor > 1e-2; factor /= 2) {
    Glued_pyramids next = trial;
    next.radii.base += factor * base_change;
    if (!change_radii(next.radii, trial.radii, factor * change) ||
        !flip_to_convex(next.triangles, next.radii.weights) ||
        !pyramids_.build(next.triangles, next.radii) || !is_inside(before, wanted) ||
        !(norm(wanted) <= (1 - factor / 4) * norm_before))
      continue;
    trial = std::move(next);
    return true;
  }
  return false;
}

bool Curvature_path::go_to(const Curvature_parts& wanted, const Effort& effort) {
  Glued_pyramids trial = p_;
  if (!pyramids_.build(trial.triangles, trial.radii)) return false;
  rescale(trial, wanted);
  for (int k = 0; k < effort.most_steps && distance(wanted) > effort.near && !run_.is_over(); ++k)
    if (!improve(trial, wanted)) return false;
  if (!(distance(wanted) <= effort.near)) return false;
  p_ = std::move(trial);
  return true;
}

// Far away, all losses are in inverse proportion to the squares of radii: with other radii, but the
// same weights, Newton's method starts from nearby.
void Curvature_path::rescale(Glued_pyramids& trial, const Curvature_parts& wanted) {
  const Pyramids before = pyramids_;
  const double distance_before = distance(wanted), base = trial.radii.base;
  const auto sum = [](const std::vector<double>& x) {
    return std::accumulate(x.begin(), x.end(), 0.);
  };
  trial.radii.base *= sum(before.lost) / sum(wanted.lost);
  if (pyramids_.build(trial.triangles, trial.radii) &&
      is_inside({before.curvature, before.lost}, wanted) && distance(wanted) < distance_before)
    return;
  trial.radii.base = base;
  pyramids_ = before;
}

bool Curvature_path::go_to_part(double part, const Effort& effort) {
  if (!go_to(parts(part), effort)) return false;
  p_.curvature_left = part;
  return true;
}

// The matrix of the equations without those of some vertices, whose radii stay.
Eigen::SparseMatrix<double> with_fixed(const Eigen::SparseMatrix<double>& a,
                                       const std::array<std::uint32_t, 3>& fixed) {
  const auto is_fixed = [&](Eigen::Index v) {
    return std::find(fixed.begin(), fixed.end(), static_cast<std::uint32_t>(v)) != fixed.end();
  };
  Eigen::SparseMatrix<double> result = a;
  for (int k = 0; k < result.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator i(result, k); i; ++i)
      if (is_fixed(i.row()) || is_fixed(i.col())) i.valueRef() = i.row() == i.col() ? 1 : 0;
  return result;
}

} // namespace

void close_pyramids(Glued_pyramids& p, const std::array<std::uint32_t, 3>& fixed,
                    Embedding_run& run) {
  Pyramids pyramids;
  if (!pyramids.build(p.triangles, p.radii)) return;
  const auto greatest = [&] { // of the curvatures
    double result = 0;
    for (const double k : pyramids.curvature) result = std::max(result, std::abs(k));
    return result;
  };
  double before = greatest();
  for (int k = 0; k < 20 && run.goes_on(); ++k) {
    const Eigen::Index n = static_cast<Eigen::Index>(pyramids.curvature.size());
    Eigen::VectorXd too_much = Eigen::VectorXd::Map(pyramids.curvature.data(), n), change(n);
    for (const std::uint32_t v : fixed) too_much[v] = 0;
    const Eigen::SparseMatrix<double> a =
        with_fixed(pyramids.derivatives(p.triangles, p.radii), fixed);
    Glued_pyramids next = p;
    run.count_step();
    if (!solve_symmetric(a, too_much, change) || !change_radii(next.radii, p.radii, change) ||
        !flip_to_convex(next.triangles, next.radii.weights) ||
        !pyramids.build(next.triangles, next.radii) || !(greatest() < before / 2))
      return;
    before = greatest();
    p = std::move(next);
  }
}

Status decrease_curvatures(Glued_pyramids& p, Embedding_run& run,
                           const std::function<bool(const Glued_pyramids&)>& is_found) {
  constexpr double end = 1e-10;
  Curvature_path path(p, run);
  run.begin(Embedding_stage::start);
  if (!path.start()) return run.status();
  double step = 1;
  int most = few_steps;
  while (p.curvature_left > end) {
    if (is_found(p)) return Status::stopped;
    run.begin(Embedding_stage::curvatures);
    run.set_curvature_left(p.curvature_left);
    if (!run.goes_on() || run.is_over()) return run.status();
    // the quotient of what is left and what is lost decreases by exp(-step)
    const double left = p.curvature_left * std::exp(-step),
                 part = left / (left + 1 - p.curvature_left);
    const bool is_reached = path.go_to_part(part, {std::min(0.1, 0.2 * step), most});
    step = is_reached ? std::min(1.5 * step, 7.) : step / 3;
    most = is_reached ? few_steps : 2 * most;
    if (step < 1e-6) return p.curvature_left < 1e-3 ? Status::done : run.status();
  }
  return is_found(p) ? Status::stopped : Status::done;
}

} // namespace CGAL::Intrinsic_triangulations::internal
