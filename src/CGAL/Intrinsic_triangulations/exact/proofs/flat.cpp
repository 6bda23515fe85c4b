// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The plane of an input face in space.
template <class FT>
class Input_plane {
public:
  using Vector = Space_vector<FT>;

  Input_plane(const Input_metric& input, std::uint32_t face)
      : input_(input), normal_(normal_of(face)) {}

  // times a positive number
  const Vector& normal() const { return normal_; }
  Vector point(std::uint32_t name) const {
    const Input_metric::Point& p = input_.points()[name];
    return {FT(p[0]), FT(p[1]), FT(p[2])};
  }
  // Whether another face lies in the plane, in the same orientation; two of its corners do, but for
  // the one in a given slot.
  Uncertain<bool> contains(std::uint32_t face, std::uint32_t slot) const {
    const Input_metric::Sides& s = input_.sides(face);
    const Vector side = difference(point(s[slot]), point(s[(slot + 1) % 3]));
    const Uncertain<bool> is_in_plane = inner_product(normal_, side) == FT(0);
    if (!possibly(is_in_plane)) return false;
    return is_in_plane & (inner_product(normal_, normal_of(face)) > FT(0));
  }

private:
  Vector normal_of(std::uint32_t face) const {
    const auto [i, j, k] = input_.sides(face);
    const Vector a = point(i);
    return cross_product(difference(point(j), a), difference(point(k), a));
  }

  const Input_metric& input_;
  Vector normal_;
};

// A diamond as it lies in space.
template <class FT>
class Diamond_in_space {
public:
  using Vector = Space_vector<FT>;

  Diamond_in_space(const Input_metric& input, const Flat_diamond& d)
      : plane_(input, d.face), i_(position(d.corners[0])), j_(position(d.corners[1])),
        k_(position(d.corners[2])), m_(position(d.corners[3])) {}

  // areas in units of the length of a normal, exactly
  Diamond_values<FT> scaled_values() const {
    const auto area = [this](const Vector& a, const Vector& b) {
      return FT(2) * inner_product(plane_.normal(), cross_product(a, b));
    };
    return values(area);
  }
  // areas by square roots. \pre they are not negative
  Diamond_values<FT> values() const {
    return values([](const Vector& a, const Vector& b) {
      const Vector n = cross_product(a, b);
      return FT(2) * CGAL::sqrt(CGAL::square(n[0]) + CGAL::square(n[1]) + CGAL::square(n[2]));
    });
  }

private:
  template <class Area>
  Diamond_values<FT> values(const Area& area) const {
    const Vector ij = difference(j_, i_), jk = difference(k_, j_), ki = difference(i_, k_),
                 im = difference(m_, i_), mj = difference(j_, m_);
    const auto length = [](const Vector& v) {
      return CGAL::square(v[0]) + CGAL::square(v[1]) + CGAL::square(v[2]);
    };
    return {length(ij), length(jk), length(ki), length(im), length(mj), area(ki, ij), area(ij, mj)};
  }

  Vector position(const Flat_diamond::Corner& c) const {
    if (c.weights[0] == 1) return plane_.point(c.points[0]);
    Vector sum{FT(0), FT(0), FT(0)};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector p = plane_.point(c.points[k]);
      for (std::size_t x = 0; x < 3; ++x) sum[x] = sum[x] + FT(c.weights[k]) * p[x];
    }
    return sum;
  }

  Input_plane<FT> plane_;
  Vector i_, j_, k_, m_;
};

} // namespace

} // namespace internal

bool are_coplanar(const Input_metric& input, std::uint32_t f, std::uint32_t g, std::uint32_t slot) {
  const Uncertain<bool> s = internal::Input_plane<Interval_nt<false>>(input, f).contains(g, slot);
  return is_certain(s) ? get_certain(s)
                       : get_certain(internal::Input_plane<Mpzf>(input, f).contains(g, slot));
}

Diamond_values<Interval_nt<false>> values_in_space(const Input_metric& input,
                                                   const Flat_diamond& diamond) {
  return internal::Diamond_in_space<Interval_nt<false>>(input, diamond).values();
}

Answer
Flat_proof::operator()(const Question<Flat_diamond, Recorded_diamond_expression>& q) const {
  if (!q.expression.is_linear_in_areas()) return Answer::open;
  const internal::Diamond_in_space<Mpzf> diamond(q.input, q.figure);
  return to_answer(CGAL::sign(q.expression(diamond.scaled_values())));
}

} // namespace CGAL::Intrinsic_triangulations
