// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_IDEAL_DECIDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_IDEAL_DECIDER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Decides for a metric that stores enclosures of lambda lengths: asks the metric first. What that
leaves open is decided by lambda lengths computed anew from where edges run on the input: in
intervals, which the metric gets, then in balls of 106 bits, then in rational numbers. Each is
computed in the strip of input triangles of its edge; or by repeating the flips, if they are few and
edges cross very many triangles, or if crossings are not counted.
*/
template <class Triangulation>
class Ideal_decider {
public:
  using FT = Interval_nt<false>;

  Ideal_decider(const Triangulation& t, const Vertex_places<Triangulation>& places,
                Exact_memory& memory)
      : t_(t), places_(places), memory_(memory), view_(t) {}

  // whether an edge is ideal Delaunay, which stored intervals leave open
  bool is_open_delaunay(const Diamond& d) const { return open_sign(d) != NEGATIVE; }
  // every edge between two faces can be flipped
  static bool is_flippable(const Diamond&) { return true; }
  // the sign of `Ideal_delaunay_expression`
  Sign delaunay_sign(const Diamond& d) const {
    const std::optional<Sign> s = metric().certain_delaunay_sign(metric().values(d));
    return s ? *s : open_sign(d);
  }

  // makes the interval of an edge as narrow as its strip of input triangles allows
  void sharpen(std::uint32_t e) const {
    ++metric().statistics().sharpenings[53];
    const FT better = unscaled_lambdas<FT>(std::array{e})[0];
    const auto [from, to] = rows(e);
    metric().refine(e, {metric().scaled(better, from, to), better});
  }
  // lambda lengths in any number type from where edges run on the input, with factors of vertices
  template <FieldNumber Number, std::size_t n>
  std::array<Number, n> lambdas(const std::array<std::uint32_t, n>& edges) const {
    std::array<Number, n> result = unscaled_lambdas<Number>(edges);
    for (std::size_t k = 0; k < n; ++k) {
      const auto [from, to] = rows(edges[k]);
      result[k] = metric().scaled(result[k], from, to);
    }
    return result;
  }

private:
  using Values = Ideal_diamond_values<FT>;

  const typename Triangulation::Metric& metric() const { return t_.metric(); }

  // a sign that the stored intervals leave open
  Sign open_sign(const Diamond& d) const {
    Predicate_statistics& statistics = metric().statistics();
    ++statistics.filter_failures;
    if (const auto known = metric().remembered_signs().find(d.ij)) {
      if (known->sign == ZERO) ++statistics.certified_zero;
      return known->sign;
    }
    const std::array edges{d.ij, d.jk, d.ki, d.im, d.mj};
    for (const std::uint32_t e : edges)
      if (!metric().is_narrow(e)) sharpen(e);
    const Values sharp = metric().values(d);
    const double by = unit(sharp);
    if (const std::optional<Sign> s = metric().certain_delaunay_sign(multiplied(sharp, by))) {
      ++statistics.escalations[53];
      return *s;
    }
    Sign s = ZERO;
    if (const Uncertain<Sign> precise = precise_sign(edges, by); is_certain(precise)) {
      s = precise.make_certain();
      ++statistics.escalations[106];
    } else {
      s = CGAL::sign(Ideal_delaunay_expression()(exact_values<Gmpq>(edges)));
      ++(s == ZERO ? statistics.certified_zero : statistics.integer);
    }
    metric().remembered_signs().remember(d.ij, {s, false});
    return s;
  }

  // decides what nearly is a tie because input lengths were rounded
  Uncertain<Sign> precise_sign(const std::array<std::uint32_t, 5>& edges, double by) const {
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    return Ideal_delaunay_expression()(multiplied(exact_values<Short_ball>(edges), by)).sign();
  }
  template <class Number>
  Ideal_diamond_values<Number> exact_values(const std::array<std::uint32_t, 5>& edges) const {
    const std::array<Number, 5> l = lambdas<Number>(edges);
    return {l[0], l[1], l[2], l[3], l[4]};
  }

  // The power of two that takes the largest lambda length of a diamond near one: the expression, of
  // degree four, overflows in doubles beyond 1e77.
  static double unit(const Values& v) {
    const double most = std::max({v.ij.sup(), v.jk.sup(), v.ki.sup(), v.im.sup(), v.mj.sup()});
    if (!(most <= std::numeric_limits<double>::max())) return 1; // out of range already
    int exponent = 0;
    std::frexp(most, &exponent);
    return std::ldexp(1., std::clamp(-exponent, -1000, 1000));
  }
  template <class Number>
  static Ideal_diamond_values<Number> multiplied(const Ideal_diamond_values<Number>& v, double by) {
    const Number x(by);
    return {v.ij * x, v.jk * x, v.ki * x, v.im * x, v.mj * x};
  }

  // the rows of the ends of an edge
  std::array<std::uint32_t, 2> rows(std::uint32_t edge) const {
    const auto row = [this](std::uint32_t v) { return t_.input_vertex(t_.numbers().vertex_at(v)); };
    return {row(view_.source(2 * edge)), row(view_.target(2 * edge))};
  }

  // without factors of vertices
  template <class Number, std::size_t n>
  std::array<Number, n> unscaled_lambdas(const std::array<std::uint32_t, n>& edges) const {
    std::array<Number, n> result;
    const Integer_coordinates* const c = coordinates(edges);
    if (c == nullptr) {
      const std::vector<Number> all = replayed<Number>();
      for (std::size_t k = 0; k < n; ++k) result[k] = all[edges[k]];
      return result;
    }
    std::vector<Number> at;
    for (std::size_t k = 0; k < n; ++k) result[k] = lambda_on_input(*c, edges[k], at);
    if (const std::size_t steps = memory_.unfolder.take_steps(); steps > 0)
      c->count_steps(t_, steps);
    return result;
  }

  // null if the strips of edges are much longer than the list of flips
  template <std::size_t n>
  const Integer_coordinates* coordinates(const std::array<std::uint32_t, n>& edges) const {
    const Integer_coordinates* const c = places_.coordinates(t_);
    if (c == nullptr || places_.flips() == nullptr) return c;
    return are_worth_unfolding(*c, edges, *places_.flips()) ? c : nullptr;
  }

  // from where the edge runs on the input
  template <class Number>
  Number lambda_on_input(const Integer_coordinates& c, std::uint32_t edge,
                         std::vector<Number>& at) const {
    const auto lambda = [&](const Face_side& side, unsigned k) {
      std::uint32_t h = c.input().halfedge_of_face(side.face);
      for (unsigned n = (side.slot + k) % 3; n > 0; --n) h = c.input().next(h);
      return Number(metric().input_lambdas()[h / 2]);
    };
    const std::uint32_t h = view_.is_border(2 * edge) ? 2 * edge + 1 : 2 * edge;
    return lambdas_along_strip<Number>(memory_.unfolder.strip(view_, c, h), lambda, at);
  }

  template <class Number>
  std::vector<Number> replayed() const {
    const Flip_list& flips = *places_.flips();
    Gluing_map mesh = flips.input_mesh(places_.connectivity(t_), t_.input());
    const Mesh_adaptor<Gluing_map> numbers(mesh);
    const std::vector<double>& input = metric().input_lambdas();
    std::vector<Number> result(input.begin(), input.end());
    for (std::size_t n = 0; n < flips.size(); ++n) {
      const Diamond d = diamond_of(flips[n], mesh, numbers);
      result[d.ij] = ptolemy_flip(Ideal_diamond_values<Number>{
          result[d.ij], result[d.jk], result[d.ki], result[d.im], result[d.mj]});
      CGAL::Euler::flip_edge(flips[n], mesh);
    }
    return result;
  }

  const Triangulation& t_;
  const Vertex_places<Triangulation>& places_;
  Exact_memory& memory_;
  Intrinsic_view<Triangulation> view_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_IDEAL_DECIDER_H
