// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARK_INTRINSIC_OPERATORS_PLAIN_CONFORMAL_H
#define BENCHMARK_INTRINSIC_OPERATORS_PLAIN_CONFORMAL_H

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// A closed ideal triangulation: halfedges 2 e and 2 e + 1 of edge e, with the next one and the
// origin of each, and the lambda length of each edge, which flips update.
template <class FT>
struct Plain_surface {
  std::vector<std::uint32_t> next, origin;
  std::vector<FT> lambda;

  const FT& length(std::uint32_t h) const { return lambda[h / 2]; }

  // Flips until all edges are ideal Delaunay, or as often as `most` says: rounding may let flips go
  // on for ever.
  void make_delaunay(std::size_t most) {
    std::vector<std::uint32_t> stack;
    for (std::uint32_t e = 0; e < lambda.size(); ++e) stack.push_back(2 * e);
    for (std::size_t flips = 0; !stack.empty() && flips < most;) {
      const std::uint32_t h = stack.back();
      stack.pop_back();
      if (is_delaunay(h)) continue;
      flip(h);
      ++flips;
      for (const std::uint32_t side : sides(h)) stack.push_back(side);
    }
  }

private:
  // Of the diamond with the diagonal ij: jk, ki, im, mj.
  std::array<std::uint32_t, 4> sides(std::uint32_t h) const {
    const std::uint32_t t = h ^ 1U;
    return {next[h], next[next[h]], next[t], next[next[t]]};
  }

  bool is_delaunay(std::uint32_t h) const {
    const auto [jk, ki, im, mj] = sides(h);
    const FT &e = length(h), &a = length(jk), &b = length(ki), &c = length(im), &d = length(mj);
    return (a * c + b * d) * (a * d + b * c) >= e * e * (a * b + c * d);
  }

  void flip(std::uint32_t h) {
    const auto [jk, ki, im, mj] = sides(h);
    lambda[h / 2] = (length(jk) * length(im) + length(ki) * length(mj)) / length(h);
    origin[h] = origin[ki];
    origin[h ^ 1U] = origin[mj];
    for (const auto& [a, b, c] :
         {std::array{h, mj, jk}, std::array{std::uint32_t(h ^ 1U), ki, im}}) {
      next[a] = b;
      next[b] = c;
      next[c] = a;
    }
  }
};

// Newton's method for prescribed angles with everything in one number type: lambda lengths, angles
// and linear systems. Steps are chosen as `conformal_metric()` does.
template <class FT>
class Plain_newton {
public:
  using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;

  Plain_newton(Plain_surface<FT> start, Vector angles)
      : surface_(std::move(start)), angles_(std::move(angles)), u_(Vector::Zero(angles_.size())) {}

  // Scales by `u`, which is relative to the start, and flips. \return angles minus prescribed ones
  Vector excess_at(const Vector& u) {
    using std::exp;
    Vector factors = u;
    for (Eigen::Index v = 0; v < u.size(); ++v) factors[v] = exp(FT((u[v] - u_[v]) / 2));
    for (std::size_t e = 0; e < surface_.lambda.size(); ++e)
      surface_.lambda[e] *= factors[surface_.origin[2 * e]] * factors[surface_.origin[2 * e + 1]];
    u_ = u;
    surface_.make_delaunay(100 * surface_.lambda.size());
    Vector excess = -angles_;
    cotangents_.resize(surface_.next.size());
    for (std::uint32_t h = 0; h < cotangents_.size(); ++h)
      excess[surface_.origin[surface_.next[surface_.next[h]]]] += read_angle(h);
    return excess;
  }

  // Takes Newton's steps. \return the best scale on the way
  Vector solve(unsigned most_steps, double tolerance) {
    Vector excess = excess_at(u_), best = u_;
    residual_ = size(excess);
    for (steps_ = 0; steps_ < most_steps && residual_ > tolerance && step(excess); ++steps_)
      if (const FT now = size(excess); now < residual_) {
        residual_ = now;
        best = u_;
      }
    return best;
  }
  // The largest difference from a prescribed angle at that scale, as far as the numbers tell.
  const FT& residual() const { return residual_; }
  unsigned steps() const { return steps_; }

  static FT size(const Vector& excess) { return excess.template lpNorm<Eigen::Infinity>(); }

private:
  // The angle opposite to a halfedge. Stores half its cotangent, which is zero if the triangle
  // inequality is lost to rounding.
  FT read_angle(std::uint32_t h) {
    using std::atan;
    using std::sqrt;
    const FT &c = surface_.length(h), &a = surface_.length(surface_.next[h]),
             &b = surface_.length(surface_.next[surface_.next[h]]);
    const FT at_a = (c - a) + b, at_b = (c - b) + a, at_c = (a - c) + b;
    cotangents_[h] = 0;
    if (at_a <= 0 || at_b <= 0) return 0;
    if (at_c <= 0) return 4 * atan(FT(1));
    const FT tangent = sqrt(FT(at_a * at_b / ((a + b + c) * at_c))); // of half the angle
    cotangents_[h] = (1 / tangent - tangent) / 4;
    return 2 * atan(tangent);
  }

  Vector direction(const Vector& excess) const {
    const Eigen::Index n = u_.size() - 1; // without the first vertex: a constant is free
    std::vector<Eigen::Triplet<FT>> entries;
    const auto add = [&](std::uint32_t row, std::uint32_t column, const FT& value) {
      if (row > 0 && column > 0) entries.emplace_back(int(row) - 1, int(column) - 1, value);
    };
    for (std::uint32_t h = 0; h < cotangents_.size(); ++h) {
      const std::uint32_t i = surface_.origin[h], j = surface_.origin[h ^ 1U];
      add(i, i, cotangents_[h]);
      add(j, j, cotangents_[h]);
      add(i, j, -cotangents_[h]);
      add(j, i, -cotangents_[h]);
    }
    Eigen::SparseMatrix<FT> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<FT>> factors(matrix);
    Vector result = Vector::Zero(n + 1);
    if (factors.info() != Eigen::Success) return result;
    result.tail(n) = factors.solve(excess.tail(n));
    result.array() -= FT(result.sum() / FT(double(n + 1)));
    return result;
  }

  // Goes along Newton's direction as far as the energy falls. \return whether it does
  bool step(Vector& excess) {
    const Vector d = direction(excess), u = u_;
    const FT slope = -d.dot(excess), largest = size(d);
    if (!(slope < 0)) return false;
    FT part = largest > 8 ? FT(8 / largest) : FT(1);
    for (int halvings = 0; halvings < 60; ++halvings, part /= 2) {
      excess = excess_at(u + part * d);
      if (-d.dot(excess) <= -slope / 10) return true;
    }
    return false;
  }

  Plain_surface<FT> surface_;
  Vector angles_, u_;
  FT residual_ = 0;
  unsigned steps_ = 0;
  std::vector<FT> cotangents_; // half of them, opposite to halfedges
};

// Newton's method for a closed surface and angles that are multiples of pi.
template <class FT>
Plain_newton<FT> plain_newton(const CGAL::Intrinsic_triangulations::Intrinsic_input& input,
                              const CGAL::Intrinsic_triangulations::Prescribed_angles& angles) {
  using std::atan;
  Plain_surface<FT> start;
  for (std::uint32_t h = 0; h < 2 * input.squared_lengths.size(); ++h) {
    const CGAL::Intrinsic_triangulations::Gluing_map::Halfedge halfedge{h};
    start.next.push_back(input.mesh.next(halfedge).index);
    start.origin.push_back(input.names.row(input.mesh.source(halfedge).index));
  }
  for (const double l : input.squared_lengths) start.lambda.push_back(FT(std::sqrt(l)));
  typename Plain_newton<FT>::Vector prescribed(static_cast<Eigen::Index>(angles.size()));
  for (std::size_t v = 0; v < angles.size(); ++v) {
    const CGAL::Intrinsic_triangulations::Multiple_of_pi m = angles.multiple(v);
    prescribed[static_cast<Eigen::Index>(v)] =
        FT(4 * atan(FT(1))) * FT(double(m.numerator)) / FT(double(m.denominator));
  }
  return {std::move(start), std::move(prescribed)};
}

#endif // BENCHMARK_INTRINSIC_OPERATORS_PLAIN_CONFORMAL_H
