// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_WEDGE_ANGLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_WEDGE_ANGLE_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>
#include <boost/graph/graph_traits.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

// the power of two 2^-k, where |x| is in [2^k, 2^(k+1)); 1 where that is none, or x is not finite
inline double inverse_binade(double x) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000U, largest = 0x7fe0000000000000U;
  const std::uint64_t e = std::bit_cast<std::uint64_t>(x) & exponent;
  return e == 0 || e >= largest ? 1. : std::bit_cast<double>(largest - e);
}

// An approximate sum of angles of corners in doubles, never used for decisions: the product of
// their z, see `Wedge_expression.h`, up to its sign and a positive factor, so that its argument is
// in [0, pi); and how many half turns there are before.
class Angle_sum {
public:
  // Adds the corner at the source of the first side of a face. \return a power of two that keeps
  // the product near 1
  double add(const Face_values<double>& v) {
    const auto& l = v.squared_lengths;
    const double p = l[0] + l[2] - l[1], a = v.quadruple_area;
    double x = a == 0 && p == 0 ? real_ : real_ * p - imaginary_ * a;
    double y = a == 0 && p == 0 ? imaginary_ : real_ * a + imaginary_ * p;
    if (y < 0 || (y == 0 && x < 0)) {
      x = -x;
      y = -y;
      ++half_turns_;
    }
    const double scale = inverse_binade(std::abs(x) + std::abs(y));
    real_ = x * scale;
    imaginary_ = y * scale;
    return scale;
  }
  void add(const Indexed_face&, const Face_values<double>& v) { add(v); }

  bool is_beyond_pi() const { return half_turns_ > 0; }
  // to 1e-6, far above rounding: where the exact comparison may be needed
  bool is_nearly_pi() const {
    return half_turns_ == (real_ < 0 ? 0U : 1U) && imaginary_ < 1e-6 * std::abs(real_);
  }
  // Grows with the angle, from 0 by 2 for each half turn: puts angles in order, for less than an
  // arc tangent.
  double rank() const { return 2 * static_cast<double>(half_turns_) + rank(real_, imaginary_); }
  // of a direction in [0, pi)
  static double rank(double x, double y) { return 1 - x / (std::abs(x) + y); }

private:
  double real_ = 1, imaginary_ = 0;
  std::size_t half_turns_ = 0;
};

// The corners between two sides of a vertex, each the source of the first side of its face, in
// order.
struct Wedge {
  boost::container::small_vector<Indexed_face, 12> faces;
  boost::container::small_vector<double, 12> scales; // powers of two that keep products near 1
  std::size_t first_beyond_pi = 0; // number of corners whose angles seem to sum to pi or more
  bool has_flat_face = false;      // one without area

  void add(const Indexed_face& face, const Face_values<double>& v) {
    faces.push_back(face);
    scales.push_back(sum_.add(v));
    if (first_beyond_pi == 0 && sum_.is_beyond_pi()) first_beyond_pi = faces.size();
    has_flat_face = has_flat_face || v.quadruple_area == 0;
  }
  std::span<const Indexed_face> all_faces() const { return {faces.data(), faces.size()}; }
  std::span<const double> all_scales() const { return {scales.data(), scales.size()}; }
  const Angle_sum& sum() const { return sum_; }

private:
  Angle_sum sum_;
};

// Two corners of a wedge are those at the source of a diamond; the sine of their sum is
// `Convexity_at_source_expression`.
inline Diamond diamond_of_corners(const Indexed_face& f, const Indexed_face& g) {
  return {f.edges[0], f.edges[1], f.edges[2], g.edges[0], g.edges[1], f.face, g.face};
}

// Compares the angle of a wedge with pi. Every corner is at most pi, so that the angle is smaller
// iff the sine of the sum of the first m corners is positive for all m, as long as it is not zero
// (a corner of zero area has angle 0 or pi). A sum whose sine is negative is beyond pi,
// independently of the others: one that seems to be is tried first.
template <class Sign_of>
Comparison_result compare_wedge_to_pi(const Wedge& w, const Sign_of& sign_of) {
  const std::span<const Indexed_face> faces = w.all_faces();
  const std::span<const double> scales = w.all_scales();
  const auto sine = [&](std::size_t from, std::size_t n) {
    return sign_of(faces.subspan(from, n), Wedge_sine_expression{scales.subspan(from, n)});
  };
  const auto cosine = [&](std::size_t from, std::size_t n) {
    return sign_of(faces.subspan(from, n), Wedge_cosine_expression{scales.subspan(from, n)});
  };
  if (w.first_beyond_pi > 1 && sine(0, w.first_beyond_pi) == NEGATIVE) return LARGER;
  for (std::size_t m = 1; m <= faces.size(); ++m) {
    const Sign s = sine(0, m);
    if (s == NEGATIVE) return LARGER;
    if (s == POSITIVE || cosine(0, m) == POSITIVE) continue;
    for (; m < faces.size(); ++m) // exactly pi, so far
      if (sine(m, 1) != ZERO || cosine(m, 1) == NEGATIVE) return LARGER;
    return EQUAL;
  }
  return SMALLER;
}

// Compares the angle of a wedge with pi by the stored intervals of a metric, which may leave it
// open: see `compare_wedge_to_pi()`.
template <class Metric>
std::optional<Comparison_result> certain_comparison_to_pi(const Metric& metric, const Wedge& w) {
  using FT = typename Metric::FT;
  Plane_vector<FT> z{FT(1), FT(0)};
  for (std::size_t k = 0; k < w.faces.size(); ++k) {
    const auto& [f, e] = w.faces[k];
    const FT p =
        metric.squared_length(e[0]) + metric.squared_length(e[2]) - metric.squared_length(e[1]);
    const Plane_vector<FT> corner{p * w.scales[k], metric.quadruple_area(f) * w.scales[k]};
    z = k == 0 ? corner : z * corner;
    if (CGAL::certainly(z.y < 0)) return LARGER;
    if (!CGAL::certainly(z.y > 0)) return std::nullopt;
  }
  return SMALLER;
}

// Doubles near the values of a face: stored ones or, if the metric stores none, new ones.
template <class Triangulation>
Face_values<double> near_values(const Triangulation& t, const Indexed_face& f) {
  if constexpr (requires { t.metric().approximate_quadruple_area(f.face); })
    return approximate_values(t.metric(), f);
  else
    return t.decider().approximate_values(f);
}

// Finds the wedge at the target of h between h and g, on the left of h: the first corner is in the
// face of h. If g is the opposite of h, it goes all around the vertex. Returns false if a side in
// between has no face, or `may_pass()` refuses its halfedge from the vertex, or g is in another fan
// of a nonmanifold vertex. `wedge` is a `Wedge` or, if that is enough, an `Angle_sum`.
template <class Triangulation, class Corners, class May_pass>
bool find_wedge(const Triangulation& t, typename Triangulation::halfedge_descriptor h,
                typename Triangulation::halfedge_descriptor g, Corners& wedge,
                const May_pass& may_pass) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const auto& mesh = t.mesh();
  const auto edge_number = [&](Halfedge x) { return t.numbers().halfedge(x) / 2; };
  const Halfedge first = h;
  while (true) {
    if (face(h, mesh) == boost::graph_traits<typename Triangulation::Mesh>::null_face())
      return false;
    const Halfedge ij = next(h, mesh);
    const Indexed_face f{t.numbers().face(face(h, mesh)),
                         {edge_number(ij), edge_number(next(ij, mesh)), edge_number(h)}};
    wedge.add(f, near_values(t, f));
    if (ij == g) return true;
    if (!may_pass(ij)) return false;
    h = opposite(ij, mesh);
    if (h == first) return false;
  }
}

template <class Triangulation, class Corners>
bool find_wedge(const Triangulation& t, typename Triangulation::halfedge_descriptor h,
                typename Triangulation::halfedge_descriptor g, Corners& wedge) {
  return find_wedge(t, h, g, wedge,
                    [](typename Triangulation::halfedge_descriptor) { return true; });
}

// Compares the angle of a wedge from h to g with pi; a session may do so without finding the wedge
// again.
template <class Session, class Halfedge>
Comparison_result compare_to_pi(const Session& session, Halfedge h, Halfedge g,
                                const Wedge& wedge) {
  if constexpr (requires { session.compare_angle_to_pi(wedge); })
    return session.compare_angle_to_pi(wedge);
  else
    return session.compare_angle_to_pi(h, g);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_WEDGE_ANGLE_H
