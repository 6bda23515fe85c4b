// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
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

using Curvatures = std::vector<double>;

// Radii whose curvatures go from wanted ones to others, between 0 and those of the surface.
class Curvature_path {
public:
  Curvature_path(Glued_pyramids& p, Embedding_run& run)
      : p_(p), run_(run), most_(p.triangles.curvatures()) {}

  // \return whether there are radii with nearly the same part of all curvatures
  bool start();
  // goes to a part of all curvatures. \param near how far they may be from it, relative to their
  // distance from the bounds
  // \return whether it is reached
  bool go_to_part(double part, double near);

private:
  bool go_to(const Curvatures& wanted, double near);
  Curvatures part_of_all(double part) const;
  double distance(const Curvatures& wanted) const;
  double norm(const Curvatures& wanted) const; // of the difference
  bool is_inside(const Curvatures& before, const Curvatures& wanted) const;
  bool improve(Glued_pyramids& trial, const Curvatures& wanted);

  Glued_pyramids& p_;
  Embedding_run& run_;
  Curvatures most_;   // those of the surface
  Pyramids pyramids_; // of the trial
};

/*
From an apex far away, at the distance R, the radius of a vertex has lost the area of its power cell
by R^2 of the curvature; the weights of the cells are the squares of the radii. Areas in proportion
to curvatures are a problem of optimal transport, which Newton's method solves: Kitagawa, Merigot,
Thibert, "Convergence of a Newton algorithm for semi-discrete optimal transport" (2019). On needles
areas must change by powers of ten. So their logarithms go to the wanted ones in steps.
*/
bool Curvature_path::start() {
  Metric_triangles& t = p_.triangles;
  p_.radii.assign(t.number_of_vertices(), 1);
  if (!flip_to_convex(t, p_.radii)) return false; // equal radii: it is Delaunay then
  const double area = area_of(t);
  double lost = 1;
  do {
    lost /= 2;
    if (lost < 1e-9) return false;
    std::fill(p_.radii.begin(), p_.radii.end(), std::sqrt(area / (4 * std::numbers::pi * lost)));
  } while (!pyramids_.build(t, p_.radii) || !is_inside(most_, most_));
  const Curvatures first = pyramids_.curvature, last = part_of_all(1 - lost);
  constexpr double least = 1e-15; // of areas, which are positive but for rounding
  double step = 1, done = 0;
  while (done < 1 && !run_.is_over()) {
    const double now = std::min(1., done + step);
    Curvatures wanted = most_;
    for (std::size_t v = 0; v < wanted.size(); ++v)
      wanted[v] -= std::pow(std::max(most_[v] - first[v], least), 1 - now) *
                   std::pow(most_[v] - last[v], now);
    const bool is_reached = go_to(wanted, 0.1);
    if (is_reached) done = now;
    step *= is_reached ? 1.5 : 0.5;
    if (step < 1e-4) return false;
  }
  p_.curvature_left = 1 - lost;
  return done == 1;
}

Curvatures Curvature_path::part_of_all(double part) const {
  Curvatures result = most_;
  for (double& k : result) k *= part;
  return result;
}

double Curvature_path::distance(const Curvatures& wanted) const {
  constexpr double rounding = 1e-13;
  double result = 0;
  for (std::size_t v = 0; v < most_.size(); ++v)
    result = std::max(result, std::abs(pyramids_.curvature[v] - wanted[v]) /
                                  (std::min(wanted[v], most_[v] - wanted[v]) + rounding));
  return result;
}

double Curvature_path::norm(const Curvatures& wanted) const {
  double squared = 0;
  for (std::size_t v = 0; v < most_.size(); ++v)
    squared += CGAL::square(pyramids_.curvature[v] - wanted[v]);
  return std::sqrt(squared);
}

// Curvatures may come nearer to a bound by half, or up to half of the wanted distance.
bool Curvature_path::is_inside(const Curvatures& before, const Curvatures& wanted) const {
  constexpr double rounding = 1e-13;
  for (std::size_t v = 0; v < most_.size(); ++v) {
    const double now = pyramids_.curvature[v];
    if (now < std::min(before[v], wanted[v]) / 2 - rounding ||
        most_[v] - now < (most_[v] - std::max(before[v], wanted[v])) / 2 - rounding)
      return false;
  }
  return true;
}

bool Curvature_path::improve(Glued_pyramids& trial, const Curvatures& wanted) {
  const Eigen::Index n = static_cast<Eigen::Index>(most_.size());
  const Curvatures curvature = pyramids_.curvature;
  const Eigen::VectorXd excess = Eigen::Map<const Eigen::VectorXd>(curvature.data(), n) -
                                 Eigen::Map<const Eigen::VectorXd>(wanted.data(), n);
  Eigen::VectorXd change(n);
  if (!run_.goes_on()) return false;
  run_.count_step();
  if (!solve_symmetric(pyramids_.derivatives(trial.triangles, trial.radii), excess, change))
    return false;
  for (double factor = 1; factor > 1e-2; factor /= 2) {
    Glued_pyramids next = trial;
    bool is_positive = true;
    for (std::size_t v = 0; v < most_.size(); ++v) { // weights are squares of radii
      const double r = trial.radii[v], d = change[static_cast<Eigen::Index>(v)];
      const double weight = r * r - 2 * factor * r * d;
      is_positive = is_positive && weight > 0;
      next.radii[v] = std::sqrt(std::max(weight, 0.));
    }
    if (!is_positive || !flip_to_convex(next.triangles, next.radii) ||
        !pyramids_.build(next.triangles, next.radii) || !is_inside(curvature, wanted) ||
        !(norm(wanted) <= (1 - factor / 4) * excess.norm()))
      continue;
    trial = std::move(next);
    return true;
  }
  return false;
}

bool Curvature_path::go_to(const Curvatures& wanted, double near) {
  constexpr int most_steps = 12;
  Glued_pyramids trial = p_;
  if (!pyramids_.build(trial.triangles, trial.radii)) return false;
  for (int k = 0; k < most_steps && distance(wanted) > near && !run_.is_over(); ++k)
    if (!improve(trial, wanted)) return false;
  if (!(distance(wanted) <= near)) return false;
  p_ = std::move(trial);
  return true;
}

bool Curvature_path::go_to_part(double part, double near) {
  if (!go_to(part_of_all(part), near)) return false;
  p_.curvature_left = part;
  return true;
}

} // namespace

Status decrease_curvatures(Glued_pyramids& p, Embedding_run& run,
                           const std::function<bool(const Glued_pyramids&)>& is_found) {
  constexpr double end = 1e-10;
  Curvature_path path(p, run);
  run.begin(Embedding_stage::start);
  if (!path.start()) return run.status();
  double step = 1;
  while (p.curvature_left > end) {
    if (is_found(p)) return Status::stopped;
    run.begin(Embedding_stage::curvatures);
    run.set_curvature_left(p.curvature_left);
    if (run.is_over()) return run.status();
    // the quotient of what is left and what is lost decreases by exp(-step)
    const double left = p.curvature_left * std::exp(-step),
                 part = left / (left + 1 - p.curvature_left);
    step = path.go_to_part(part, std::min(0.1, 0.2 * step)) ? std::min(1.5 * step, 7.) : step / 3;
    if (step < 1e-6) return p.curvature_left < 1e-3 ? Status::done : run.status();
  }
  return is_found(p) ? Status::stopped : Status::done;
}

} // namespace CGAL::Intrinsic_triangulations::internal
