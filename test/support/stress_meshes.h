// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_STRESS_MESHES_H
#define TEST_INTRINSIC_TRIANGULATIONS_STRESS_MESHES_H

#include "stress_families.h"

#include "../../benchmark/synthetic_meshes.h"
#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>

// The meshes of the stress families; see `stress_families.h` for the parameters.

namespace stress::generators {

namespace synthetic = CGAL::Intrinsic_triangulations::synthetic;
using Point = std::array<double, 3>;

struct Parameters {
  std::uint64_t size, seed;
  double amount;
};

template <class Soup>
Mesh to_mesh(Soup soup) {
  return {std::move(soup.points), std::move(soup.triangles)};
}

// The number of rows, and of cells in each, of a square whose cells make `size` faces.
inline std::uint32_t cells(std::uint64_t size, double faces_per_cell = 2) {
  const double n = std::round(std::sqrt(static_cast<double>(size) / faces_per_cell));
  return std::max(1U, static_cast<std::uint32_t>(n));
}

// A multiple of 2^-20 in [0, 1): sums and differences of such numbers are exact.
inline double draw_dyadic(std::mt19937_64& random) {
  return static_cast<double>(random() >> 44U) / 0x1p20;
}

// ---- quadratic flips

// `synthetic::double_parabola()` has c = 1/4. For c < 1 each point of a chain sees all of the other:
// it lies on the inner side of the tangents there.
inline Mesh parabola(const Parameters& p) {
  const auto n = static_cast<std::uint32_t>(std::max<std::uint64_t>(2, p.size / 2 + 1));
  Mesh m = to_mesh(synthetic::double_parabola(n));
  for (Point& q : m.points) q[1] = std::copysign(1 + p.amount * (q[0] * q[0]), q[1]);
  return m;
}

// ---- cocircular grids

inline Mesh grid_plane(const Parameters& p) {
  const std::uint32_t n = cells(p.size);
  return to_mesh(meshes::sheared_grid(n, n, p.amount));
}

// Splitting the diagonals of unit squares at their midpoints leaves squares on their corners, whose
// diagonals are the sides of the unit squares, those on the edges of the cube included.
inline Mesh grid_cube(const Parameters& p) {
  const std::uint32_t n = cells(p.size, 24);
  meshes::Mesh box = meshes::box(n, n, n);
  synthetic::Edge_splitter splitter({std::move(box.points), std::move(box.triangles)});
  const std::size_t edges = splitter.number_of_edges();
  for (std::size_t e = 0; e < edges; ++e) {
    const Point a = splitter.soup().points[splitter.ends(e)[0]];
    const Point b = splitter.soup().points[splitter.ends(e)[1]];
    int different = 0;
    for (std::size_t k = 0; k < 3; ++k) different += a[k] != b[k] ? 1 : 0;
    if (different == 2) splitter.split(e, 0.5);
  }
  Mesh m = to_mesh(std::move(splitter).take_soup());
  for (Point& q : m.points) q[2] *= p.amount;
  return m;
}

inline Mesh grid_folded(const Parameters& p) {
  const std::uint32_t n = cells(p.size);
  return to_mesh(meshes::folded_lattice(n, n, static_cast<std::uint32_t>(p.amount)));
}

// A side of the prism lies between two columns of points. It is triangulated bottom up: each triangle
// advances on the right or on the left column. Advancing alternately makes rectangles with
// diagonals; advancing only on the right first, long triangles in the same plane.
inline void triangulate_side(Mesh& m, std::uint32_t left, std::uint32_t right, std::uint32_t rows,
                             std::uint32_t ahead) {
  std::uint32_t l = 0, r = 0;
  while (l < rows || r < rows) {
    if (r < rows && r <= l + ahead) {
      m.faces.push_back({left + l, right + r, right + r + 1});
      ++r;
    } else {
      m.faces.push_back({left + l, right + r, left + l + 1});
      ++l;
    }
  }
}

// All points of a column have the same x and y, all of a row the same z: rectangles are exact,
// whatever the sine is.
inline Mesh grid_cylinder(const Parameters& p) {
  const std::uint32_t columns = std::max(3U, cells(p.size)), rows = columns;
  const auto ahead = static_cast<std::uint32_t>(std::min<double>(p.amount, rows));
  Mesh m;
  for (std::uint32_t i = 0; i < columns; ++i) {
    const double u = 2 * std::numbers::pi * i / columns;
    for (std::uint32_t j = 0; j <= rows; ++j)
      m.points.push_back({std::cos(u), std::sin(u), 4. * j / rows});
    triangulate_side(m, i * (rows + 1), (i + 1) % columns * (rows + 1), rows, ahead);
  }
  return m;
}

// Each coordinate is 1 + i 2^-k, k so large that all lie in (1, 2), where a unit in the last place
// is 2^-52.
inline Mesh ulps(const Parameters& p) {
  const std::uint32_t n = cells(p.size);
  double side = 1;
  while ((n + 2) * side >= 1) side /= 2;
  std::mt19937_64 random(p.seed);
  Mesh m = to_mesh(meshes::grid(n, n));
  for (Point& q : m.points)
    for (std::size_t k = 0; k < 2; ++k)
      q[k] = 1 + (q[k] + 1) * side + p.amount * 0x1p-52 * (static_cast<double>(random() % 3) - 1);
  return m;
}

// ---- bad shapes

inline Mesh splits(const Parameters& p) {
  meshes::Mesh sphere = meshes::sphere(2);
  synthetic::Edge_splitter splitter({std::move(sphere.points), std::move(sphere.triangles)});
  splitter.reserve(p.size);
  std::mt19937_64 random(p.seed);
  while (splitter.soup().triangles.size() < p.size) {
    const std::uint64_t e = synthetic::draw_index(random, splitter.number_of_edges());
    splitter.split(e, p.amount + (1 - 2 * p.amount) * synthetic::draw_real(random));
  }
  return to_mesh(std::move(splitter).take_soup());
}

// Joins point `q` to the corners of face `f`, which keeps its first side.
inline void split_face(Mesh& m, std::size_t f, const Point& q) {
  const auto [a, b, c] = m.faces[f];
  const auto v = static_cast<std::uint32_t>(m.points.size());
  m.points.push_back(q);
  m.faces[f] = {a, b, v};
  m.faces.push_back({b, c, v});
  m.faces.push_back({c, a, v});
}

// A grid with rough odd rows. Even rows run along x through z = 0 and have dyadic coordinates, so that a
// point close to them can be told from them by any z, however small.
inline Mesh grid_with_straight_rows(std::uint32_t n, std::mt19937_64& random) {
  Mesh m = to_mesh(meshes::grid(n, n));
  for (Point& q : m.points) {
    q[0] += (draw_dyadic(random) - 0.5) / 2;
    if (static_cast<std::uint32_t>(q[1]) % 2 == 0) continue;
    q[1] += (draw_dyadic(random) - 0.5) / 2;
    q[2] = draw_dyadic(random) - 0.5;
  }
  return m;
}

// Calls `split(mesh, f, a, length)` for the faces above even rows, which start at `a` with the side
// in the row.
template <class Split>
Mesh with_split_faces(const Parameters& p, std::uint32_t n, std::mt19937_64& random,
                      const Split& split) {
  Mesh m = grid_with_straight_rows(n, random);
  for (std::uint32_t j = 0; j < n; j += 2)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::size_t f = 2 * (std::size_t{j} * n + i);
      const Point a = m.points[m.faces[f][0]];
      split(m, f, a, m.points[m.faces[f][1]][0] - a[0], p.amount);
    }
  return m;
}

// Four caps over the first side of the face, one in the other, the flattest last: none of the triangles
// between them has a larger height than the first.
inline Mesh caps(const Parameters& p) {
  std::mt19937_64 random(p.seed);
  const auto split = [&random](Mesh& m, std::size_t f, const Point& a, double length, double h) {
    for (int k = 4; k > 0; --k) {
      const double x = 0.25 + draw_dyadic(random) / 2;
      split_face(m, f, {a[0] + x * length, a[1], k * h * length});
    }
  };
  return with_split_faces(p, cells(p.size, 6), random, split);
}

// Three points above one another over a: needles of a right angle, and two between parallels, almost.
inline Mesh needles(const Parameters& p) {
  std::mt19937_64 random(p.seed);
  const auto split = [&random](Mesh& m, std::size_t f, const Point& a, double length, double h) {
    split_face(m, f, {a[0], a[1], h * length});
    double z = h * length;
    for (int k = 0; k < 2; ++k) { // each time in the face that is left of the first
      const std::size_t rest = m.faces.size() - 2;
      std::rotate(m.faces[rest].begin(), m.faces[rest].begin() + 2, m.faces[rest].end());
      z *= 2 + draw_dyadic(random);
      split_face(m, rest, {a[0], a[1], z});
    }
  };
  return with_split_faces(p, cells(p.size, 5), random, split);
}

inline Mesh offset(const Parameters& p) {
  const meshes::Mesh m = meshes::rough_grid(cells(p.size), static_cast<unsigned>(p.seed), 0.1);
  return to_mesh(meshes::translated(m, {p.amount, p.amount, p.amount}));
}

inline Mesh stretched(const Parameters& p) {
  unsigned levels = 0;
  while (std::uint64_t{16} << 2 * levels <= p.size) ++levels; // 8 * 4^levels, to the nearest
  meshes::Mesh m = meshes::potato(levels, static_cast<unsigned>(p.seed));
  return to_mesh(synthetic::stretch_x({std::move(m.points), std::move(m.triangles)}, p.amount));
}

// ---- wound triangles

// A circle around the z-axis with `columns` points.
inline void push_circle(Mesh& m, double radius, double z, std::uint32_t columns) {
  for (std::uint32_t j = 0; j < columns; ++j) {
    const double u = 2 * std::numbers::pi * j / columns;
    m.points.push_back({radius * std::cos(u), radius * std::sin(u), z});
  }
}

// Column j of the circle that starts at `here` is joined to column j + shift of the next one.
inline void join_circles(Mesh& m, std::uint32_t here, std::uint32_t columns, std::uint32_t shift) {
  const std::uint32_t there = here + columns;
  for (std::uint32_t j = 0; j < columns; ++j) {
    const std::uint32_t a = here + j, b = here + (j + 1) % columns;
    const std::uint32_t c = there + (j + 1 + shift) % columns, d = there + (j + shift) % columns;
    m.faces.push_back({a, b, d});
    m.faces.push_back({b, c, d});
  }
}

inline std::uint32_t shift_of(const Parameters& p, std::uint32_t columns) {
  return static_cast<std::uint32_t>(p.amount) % columns;
}

inline Mesh wound_sphere(const Parameters& p) {
  const std::uint32_t rows = std::max(2U, cells(p.size, 16)), columns = 8 * rows;
  Mesh m;
  for (std::uint32_t i = 0; i < rows; ++i) {
    const double v = std::numbers::pi * (i + 1) / (rows + 1);
    push_circle(m, std::sin(v), -std::cos(v), columns);
    if (i > 0) join_circles(m, (i - 1) * columns, columns, shift_of(p, columns));
  }
  const auto south = static_cast<std::uint32_t>(m.points.size());
  m.points.push_back({0, 0, -1});
  m.points.push_back({0, 0, 1});
  for (std::uint32_t j = 0; j < columns; ++j) {
    const std::uint32_t next = (j + 1) % columns, last = (rows - 1) * columns;
    m.faces.push_back({south, next, j});
    m.faces.push_back({south + 1, last + j, last + next});
  }
  return m;
}

inline Mesh wound_torus(const Parameters& p) {
  const std::uint32_t rows = std::max(3U, cells(p.size, 16)), columns = 8 * rows;
  return to_mesh(synthetic::torus(rows, columns, 0.35, shift_of(p, columns)));
}

inline Mesh wound_cylinder(const Parameters& p) {
  const std::uint32_t rows = std::max(2U, cells(p.size, 16)), columns = 8 * rows;
  Mesh m;
  for (std::uint32_t i = 0; i <= rows; ++i) {
    push_circle(m, 1, 3. * i / rows, columns);
    if (i > 0) join_circles(m, (i - 1) * columns, columns, shift_of(p, columns));
  }
  return m;
}

} // namespace stress::generators

#endif // TEST_INTRINSIC_TRIANGULATIONS_STRESS_MESHES_H
