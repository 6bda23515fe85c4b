// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_FLAT_SURFACES_H
#define TEST_FLAT_SURFACES_H

#include "torus_gluing.h"

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

/// Flat surfaces with cones in closed form, with random triangulations.
namespace flat {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;

/// Triangles that are glued, with lengths: an IT::Surface_to_cut with moves that keep the surface.
class Surface : public IT::Surface_to_cut {
public:
  /// glues triangles with points in space or the plane.
  Surface(const std::vector<std::array<std::uint32_t, 3>>& triangles,
          const std::vector<std::array<double, 3>>& points) {
    gluing = IT::gluing_from_triangles(static_cast<std::uint32_t>(points.size()), triangles);
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &p = points[t[k]], &q = points[t[(k + 1) % 3]];
        length.push_back(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
  }

  /// glues n times n parallelograms, of two triangles each, to the torus of two translations.
  static Surface torus(Complex a, Complex b, std::uint32_t n) {
    Surface s;
    s.gluing = torus_gluing(n, n);
    const double of_n = n, l[3] = {std::abs(a) / of_n, std::abs(b) / of_n, std::abs(a + b) / of_n};
    for (std::uint32_t cell = 0; cell < n * n; ++cell)
      for (const double x : {l[0], l[1], l[2], l[2], l[0], l[1]}) s.length.push_back(x);
    return s;
  }

  /// glues two copies of a convex polygon together along its sides; a fan from its first corner.
  static Surface doubled_polygon(const std::vector<Complex>& corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<double, 3>> points;
    for (const Complex& c : corners) points.push_back({c.real(), c.imag(), 0});
    for (std::uint32_t k = 1; k + 1 < corners.size(); ++k) triangles.push_back({0, k, k + 1});
    Surface s(triangles, points), back = s;
    const auto n = static_cast<std::uint32_t>(s.length.size());
    const auto mirror = [n](std::uint32_t h) { return n + h - h % 3 + 2 - h % 3; };
    s.gluing.origin.resize(2 * n);
    s.gluing.glue.resize(2 * n);
    s.length.resize(2 * n);
    for (std::uint32_t h = 0; h < n; ++h) {
      const std::uint32_t m = mirror(h), p = back.gluing.glue[h];
      s.gluing.origin[m] = back.gluing.origin[IT::Gluing::next(h)];
      s.length[m] = back.length[h];
      s.gluing.glue[m] = p == IT::Gluing::none ? h : mirror(p);
      if (p == IT::Gluing::none) s.gluing.glue[h] = m;
    }
    return s;
  }

  std::uint32_t number_of_faces() const { return gluing.number_of_faces(); }

  /// returns the corners of a face: side `h` from 0 to its length, and the third corner.
  Complex apex(std::uint32_t h) const {
    const double a = length[h], b = length[IT::Gluing::next(h)],
                 c = length[IT::Gluing::next(IT::Gluing::next(h))],
                 x = (a * a + c * c - b * b) / (2 * a);
    return {x, std::sqrt(std::max(0., c * c - x * x))};
  }

  /// flips the edge of a side if its diamond is convex, with angles over some degrees.
  bool flip(std::uint32_t h) {
    std::vector<std::uint32_t>& glue = gluing.glue;
    const std::uint32_t p = glue[h];
    if (p == IT::Gluing::none || p / 3 == h / 3) return false;
    const std::uint32_t hn = IT::Gluing::next(h), hp = IT::Gluing::next(hn),
                        pn = IT::Gluing::next(p), pp = IT::Gluing::next(pn);
    const Complex k = apex(h), m = length[h] - apex(p), j = length[h];
    const auto turn = [](Complex a, Complex b) { return std::arg(b / a); };
    const double least = 0.1;
    if (turn(m, k) > std::numbers::pi - least || turn(k - j, m - j) > std::numbers::pi - least ||
        turn(m, k) < 0 || turn(k - j, m - j) < 0)
      return false;
    if (std::min({std::abs(turn(m - k, -k)), std::abs(turn(m - k, j - k)),
                  std::abs(turn(k - m, -m)), std::abs(turn(k - m, j - m))}) < least)
      return false;
    // sides around: jk = hn, ki = hp, im = pn, mj = pp
    struct Side {
      std::uint32_t origin, glue;
      double length;
    };
    const auto read = [&](std::uint32_t x) { return Side{gluing.origin[x], glue[x], length[x]}; };
    const std::array<std::uint32_t, 4> old{hn, hp, pn, pp}, to{pp, hn, hp, pn};
    std::array<Side, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) sides[i] = read(old[i]);
    const auto moved = [&](std::uint32_t x) {
      for (std::size_t i = 0; i < 4; ++i)
        if (old[i] == x) return to[i];
      return x;
    };
    for (std::size_t i = 0; i < 4; ++i) {
      gluing.origin[to[i]] = sides[i].origin;
      length[to[i]] = sides[i].length;
      glue[to[i]] = sides[i].glue == IT::Gluing::none ? IT::Gluing::none : moved(sides[i].glue);
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (glue[to[i]] != IT::Gluing::none) glue[glue[to[i]]] = to[i];
    // face of h: m k (h), ki (hn), im (hp); face of p: k m (p), mj (pn), jk (pp)
    gluing.origin[h] = sides[3].origin; // m
    gluing.origin[p] = sides[1].origin; // k
    length[h] = length[p] = std::abs(k - m);
    return true;
  }

  /// inserts a vertex into a face.
  void insert(std::uint32_t f, const std::array<double, 3>& weights) {
    const std::uint32_t v = gluing.number_of_vertices++, a = 3 * f;
    const Complex z[3] = {0, length[a], apex(a)};
    const Complex x = weights[0] * z[0] + weights[1] * z[1] + weights[2] * z[2];
    const auto n = static_cast<std::uint32_t>(length.size());
    std::array<std::uint32_t, 3> origin, glue;
    std::array<double, 3> l;
    for (std::uint32_t k = 0; k < 3; ++k)
      origin[k] = gluing.origin[a + k], glue[k] = gluing.glue[a + k], l[k] = length[a + k];
    gluing.origin.resize(n + 6);
    gluing.glue.resize(n + 6);
    length.resize(n + 6);
    const std::uint32_t base[3] = {a, n, n + 3}; // side k of the old face is the first of a new one
    const auto moved = [&](std::uint32_t g) { return g / 3 == f ? base[g % 3] : g; };
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t b = base[k], next = base[(k + 1) % 3], before = base[(k + 2) % 3];
      gluing.origin[b] = origin[k];
      gluing.origin[b + 1] = origin[(k + 1) % 3];
      gluing.origin[b + 2] = v;
      length[b] = l[k];
      length[b + 1] = std::abs(z[(k + 1) % 3] - x);
      length[b + 2] = std::abs(z[k] - x);
      gluing.glue[b] = glue[k] == IT::Gluing::none ? glue[k] : moved(glue[k]);
      if (glue[k] != IT::Gluing::none) gluing.glue[gluing.glue[b]] = b;
      gluing.glue[b + 1] = next + 2;
      gluing.glue[b + 2] = before + 1;
    }
  }

  /// inserts vertices and flips edges at random.
  void mix(std::mt19937& random, int insertions, int flips) {
    std::exponential_distribution<double> weight;
    const auto below = [&](std::size_t n) {
      return std::uniform_int_distribution<std::uint32_t>(0, static_cast<std::uint32_t>(n - 1))(
          random);
    };
    for (int i = 0; i < insertions; ++i) {
      std::array<double, 3> w{weight(random) + 0.3, weight(random) + 0.3, weight(random) + 0.3};
      const double sum = w[0] + w[1] + w[2];
      for (double& x : w) x /= sum;
      insert(below(number_of_faces()), w);
      for (int n = 0; n < 10; ++n) flip(below(length.size()));
    }
    for (int i = 0; i < flips; ++i) flip(below(length.size()));
  }

  /// returns the sums of angles at the vertices.
  std::vector<double> angles() const {
    std::vector<double> result(gluing.number_of_vertices, 0);
    for (std::uint32_t h = 0; h < length.size(); ++h) result[gluing.origin[h]] += std::arg(apex(h));
    return result;
  }
  /// returns the vertices with other sums than 2 pi.
  std::vector<std::uint32_t> cones() const {
    std::vector<std::uint32_t> result;
    const std::vector<double> sums = angles();
    for (std::uint32_t v = 0; v < sums.size(); ++v)
      if (std::abs(sums[v] - 2 * std::numbers::pi) > 1e-6) result.push_back(v);
    return result;
  }

private:
  Surface() = default;
};

/// returns the surface of the unit cube, of 12 triangles.
inline Surface cube() {
  std::vector<std::array<double, 3>> points;
  for (unsigned i = 0; i < 8; ++i)
    points.push_back({double(i & 1U), double(i >> 1U & 1U), double(i >> 2U)});
  return Surface({{0, 2, 3},
                  {0, 3, 1},
                  {4, 5, 7},
                  {4, 7, 6},
                  {0, 1, 5},
                  {0, 5, 4},
                  {2, 6, 7},
                  {2, 7, 3},
                  {0, 4, 6},
                  {0, 6, 2},
                  {1, 3, 7},
                  {1, 7, 5}},
                 points);
}

/// returns the surface of the regular tetrahedron with edges of length sqrt(2).
inline Surface tetrahedron() {
  return Surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                 {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
}

/// A flat surface as input of a triangulation, that keeps its numbers.
inline IT::Intrinsic_input input_of(const Surface& s) {
  IT::Gluing_map map(s.gluing);
  std::vector<double> squares(map.number_of_edges());
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k)
      squares[map.sides({f})[k].index / 2] = std::pow(s.length[3 * f + k], 2);
  IT::Intrinsic_input in(std::move(map), std::move(squares));
  in.may_renumber = false;
  return in;
}

/// Tries to flip random edges of a triangulation, some of which are refused.
template <class Triangulation>
void flip_at_random(Triangulation& t, std::mt19937& random, int flips) {
  std::vector<typename Triangulation::edge_descriptor> all(edges(t.mesh()).begin(),
                                                           edges(t.mesh()).end());
  for (int i = 0; i < flips; ++i) t.flip_edge(halfedge(all[random() % all.size()], t.mesh()));
}

} // namespace flat

#endif // TEST_FLAT_SURFACES_H
