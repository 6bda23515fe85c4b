// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_ORACLE_H
#define TEST_INTRINSIC_TRIANGULATIONS_ORACLE_H

#include "meshes.h"

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// Delaunay flips done slowly and differently: by lengths, not their squares; by unfolding two
// faces to the plane and testing whether one point is in the circle through three; by trying all
// edges over and over. Shares neither data structures nor formulas nor arithmetic with the library.

namespace oracle {

/// 400 decimal digits.
using Wide_float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<400>,
                                                 boost::multiprecision::et_off>;

inline double to_double(const Wide_float& x) { return x.convert_to<double>(); }
/// of an exact number, such as `CORE::Expr`
template <class Number>
double to_double(const Number& x) {
  return x.doubleValue();
}

/// Exact.
template <class Number>
int sign_of(const Number& x) {
  return x.sign();
}

/*!
Values of small meshes of integer coordinates are either zero, and come out below 1e-300, or are not
and are far above. Throws in between: then the oracle does not know.
*/
inline int sign_of(const Wide_float& x) {
  if (abs(x) < Wide_float("1e-300")) return 0;
  if (abs(x) < Wide_float("1e-100")) throw std::domain_error("the oracle needs more digits");
  return x < 0 ? -1 : 1;
}

/// The properties that all Delaunay triangulations share; see `properties`.
struct Answer {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, double>> tessellation;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> laplacian;
  std::size_t ties = 0, flips = 0;
  double area = 0;
};

template <class Number>
class Triangulation {
public:
  struct Side {
    std::size_t triangle, k;
    bool operator==(const Side&) const = default;
  };
  static constexpr Side border{static_cast<std::size_t>(-1), 0};

  explicit Triangulation(const meshes::Mesh& m) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Side> side;
    add_triangles(m);
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        side[{m.triangles[f][k], m.triangles[f][(k + 1) % 3]}] = {f, k};
    for (Triangle& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = side.find({t.vertex[(k + 1) % 3], t.vertex[k]});
        t.across[k] = found == side.end() ? border : found->second;
      }
  }

  /// Triangles with given gluings, not by their vertices.
  Triangulation(const meshes::Mesh& m, const std::vector<std::array<Side, 3>>& across) {
    add_triangles(m);
    for (std::size_t f = 0; f < triangles_.size(); ++f) triangles_[f].across = across[f];
  }

  Answer flip_to_delaunay() {
    Answer a;
    for (bool again = true; again;) {
      again = false;
      for (std::size_t f = 0; f < triangles_.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
          if (is_inner({f, k}) && sign_of(outside_circle({f, k})) < 0) {
            flip({f, k});
            ++a.flips;
            again = true;
          }
    }
    describe(a);
    return a;
  }

private:
  // side k runs from vertex k to vertex k + 1
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<Number, 3> length;
    std::array<Side, 3> across;
  };

  struct Vector {
    Number x, y;
  };

  void add_triangles(const meshes::Mesh& m) {
    for (const auto& t : m.triangles) {
      Triangle triangle{t, {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        Number sum(0);
        for (std::size_t x = 0; x < 3; ++x) {
          const Number d = Number(m.points[t[k]][x]) - Number(m.points[t[(k + 1) % 3]][x]);
          sum = sum + d * d;
        }
        triangle.length[k] = sqrt(sum);
      }
      triangles_.push_back(triangle);
    }
  }

  static Side turned(Side s, std::size_t by) { return {s.triangle, (s.k + by) % 3}; }
  const Number& length(Side s) const { return triangles_[s.triangle].length[s.k]; }
  Side across(Side s) const { return triangles_[s.triangle].across[s.k]; }
  std::uint32_t start(Side s) const { return triangles_[s.triangle].vertex[s.k]; }
  bool is_inner(Side s) const { return across(s) != border && across(s).triangle != s.triangle; }

  // the third vertex of a triangle whose side s lies on the x axis and starts at 0
  Vector apex(Side s) const {
    const Number &l = length(s), &b = length(turned(s, 1)), &a = length(turned(s, 2));
    const Number x = (l * l + a * a - b * b) / (Number(2) * l);
    const Number square = a * a - x * x;
    return {x, sign_of(square) <= 0 ? Number(0) : Number(sqrt(square))};
  }
  // the third vertex of the triangle across, in the same coordinates
  Vector apex_across(Side s) const {
    const Vector v = apex(across(s));
    return {length(s) - v.x, -v.y};
  }

  // positive iff the vertex across is outside of the circle: the lifting to a paraboloid, from
  // vertex i
  Number outside_circle(Side s) const {
    const Number& l = length(s);
    const Vector k = apex(s), m = apex_across(s);
    return l * (k.y * (m.x * m.x + m.y * m.y) - m.y * (k.x * k.x + k.y * k.y)) +
           l * l * (k.x * m.y - k.y * m.x);
  }

  void flip(Side s) {
    const Side o = across(s);
    const Vector k = apex(s), m = apex_across(s);
    const Number x = k.x - m.x, y = k.y - m.y;
    const Number km = sqrt(x * x + y * y);
    const Triangle f = triangles_[s.triangle], g = triangles_[o.triangle];
    const std::size_t s1 = (s.k + 1) % 3, s2 = (s.k + 2) % 3, o1 = (o.k + 1) % 3,
                      o2 = (o.k + 2) % 3;
    // k m j and m k i
    triangles_[s.triangle] = {{f.vertex[s2], g.vertex[o2], f.vertex[s1]},
                              {km, g.length[o2], f.length[s1]},
                              {Side{o.triangle, 0}, g.across[o2], f.across[s1]}};
    triangles_[o.triangle] = {{g.vertex[o2], f.vertex[s2], f.vertex[s.k]},
                              {km, f.length[s2], g.length[o1]},
                              {Side{s.triangle, 0}, f.across[s2], g.across[o1]}};
    const std::array<std::pair<Side, Side>, 4> moved{{{{o.triangle, o2}, {s.triangle, 1}},
                                                      {{s.triangle, s1}, {s.triangle, 2}},
                                                      {{s.triangle, s2}, {o.triangle, 1}},
                                                      {{o.triangle, o1}, {o.triangle, 2}}}};
    for (const auto& [was, is] : moved) {
      Side& a = triangles_[is.triangle].across[is.k];
      for (const auto& [other_was, other_is] : moved)
        if (a == other_was) {
          a = other_is;
          break;
        }
      if (a != border) triangles_[a.triangle].across[a.k] = is;
    }
  }

  double cotangent(Side s) const { // of the angle opposite, by its cosine
    const Number &l = length(s), &b = length(turned(s, 1)), &a = length(turned(s, 2));
    const Number cosine = (a * a + b * b - l * l) / (Number(2) * a * b);
    return to_double(Number(cosine / sqrt(Number(1) - cosine * cosine)));
  }

  void describe(Answer& a) const {
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const Vector p = apex({f, 0});
      a.area += to_double(Number(length({f, 0}) * p.y)) / 2;
      for (std::size_t k = 0; k < 3; ++k) {
        const Side s{f, k}, o = across(s);
        const std::uint32_t i = start(s), j = start(turned(s, 1));
        const bool tie = is_inner(s) && sign_of(outside_circle(s)) == 0;
        if (i != j && !tie) a.laplacian[std::minmax(i, j)] += cotangent(s) / 2;
        const bool is_second = o != border && std::tie(o.triangle, o.k) < std::tie(f, k);
        if (is_second) continue;
        if (tie)
          ++a.ties;
        else
          a.tessellation.emplace_back(std::min(i, j), std::max(i, j),
                                      to_double(Number(length(s) * length(s))));
      }
    }
    std::sort(a.tessellation.begin(), a.tessellation.end());
  }

  std::vector<Triangle> triangles_;
};

template <class Number = Wide_float>
Answer delaunay(const meshes::Mesh& m) {
  return Triangulation<Number>(m).flip_to_delaunay();
}

} // namespace oracle

#endif // TEST_INTRINSIC_TRIANGULATIONS_ORACLE_H
