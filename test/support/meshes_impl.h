// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_MESHES_IMPL_H
#define TEST_INTRINSIC_TRIANGULATIONS_MESHES_IMPL_H

#include "meshes.h"
#include "shared_meshes.h"

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace meshes {

TEST_MESHES_INLINE Mesh scaled(Mesh m, double factor) {
  for (Point& p : m.points)
    for (double& x : p) x *= factor;
  return m;
}

TEST_MESHES_INLINE Mesh translated(Mesh m, const Point& by) {
  for (Point& p : m.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return m;
}

TEST_MESHES_INLINE Mesh mirrored(Mesh m) {
  for (Point& p : m.points) p[0] = -p[0];
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

TEST_MESHES_INLINE std::vector<std::uint32_t> permutation(std::size_t n, unsigned seed) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random(seed);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

TEST_MESHES_INLINE Mesh permuted(const Mesh& m, const std::vector<std::uint32_t>& order,
                                 unsigned seed) {
  Mesh result = m;
  for (std::size_t v = 0; v < m.points.size(); ++v) result.points[order[v]] = m.points[v];
  const std::vector<std::uint32_t> faces = permutation(m.triangles.size(), seed);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Triangle t = m.triangles[f];
    for (std::uint32_t& v : t) v = order[v];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>((f + seed) % 3), t.end());
    result.triangles[faces[f]] = t;
  }
  return result;
}

TEST_MESHES_INLINE Mesh subdivided(const Mesh& m) {
  Mesh result{m.points, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [i, fresh] = middle.try_emplace(std::minmax(a, b), result.points.size());
    if (fresh) {
      Point p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = (m.points[a][k] + m.points[b][k]) / 2;
      result.points.push_back(p);
    }
    return i->second;
  };
  for (const auto& [a, b, c] : m.triangles) {
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      result.triangles.push_back(t);
  }
  return result;
}

TEST_MESHES_INLINE Mesh welded(const Mesh& m) {
  Mesh result;
  std::map<Point, std::uint32_t> number;
  std::vector<std::uint32_t> name;
  for (const Point& p : m.points) {
    const auto [i, fresh] = number.try_emplace(p, static_cast<std::uint32_t>(result.points.size()));
    if (fresh) result.points.push_back(p);
    name.push_back(i->second);
  }
  for (const auto& [a, b, c] : m.triangles) result.triangles.push_back({name[a], name[b], name[c]});
  return result;
}

TEST_MESHES_INLINE Mesh grid(std::uint32_t n, std::uint32_t m, double dx, double dy) {
  Mesh g;
  for (std::uint32_t j = 0; j <= m; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) g.points.push_back({i * dx, j * dy, 0});
  for (std::uint32_t j = 0; j < m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = (n + 1) * j + i;
      g.triangles.push_back({v, v + 1, v + n + 2});
      g.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return g;
}

TEST_MESHES_INLINE Mesh sheared_grid(std::uint32_t n, std::uint32_t m, double shear) {
  Mesh g = grid(n, m);
  for (Point& p : g.points) p[0] += shear * p[1];
  return g;
}

TEST_MESHES_INLINE Mesh swept(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto turn = [&points](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point &p = points[a], &q = points[b], &r = points[c]; // exact: integers below 2^53
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  Mesh m;
  std::uint32_t first = 2; // the points before it lie on a line
  while (turn(0, 1, first) == 0) ++first;
  std::vector<std::uint32_t> hull; // counterclockwise
  const bool left = turn(0, 1, first) > 0;
  for (std::uint32_t i = 0; i < first; ++i) hull.push_back(left ? i : first - 1 - i);
  for (std::size_t i = 0; i + 1 < hull.size(); ++i)
    m.triangles.push_back({hull[i], hull[i + 1], first});
  hull.push_back(first);
  for (std::uint32_t v = first + 1; v < points.size(); ++v) {
    // the sides that v sees are consecutive and meet at v - 1, the last point of the hull so far
    const auto last = std::find(hull.begin(), hull.end(), v - 1);
    std::rotate(hull.begin(), last, hull.end());
    hull.push_back(v - 1);
    const std::size_t n = hull.size();
    std::size_t low = 0, high = n - 1;
    while (turn(hull[low], hull[low + 1], v) < 0) {
      m.triangles.push_back({hull[low + 1], hull[low], v});
      ++low;
    }
    while (turn(hull[high - 1], hull[high], v) < 0) {
      m.triangles.push_back({hull[high], hull[high - 1], v});
      --high;
    }
    std::vector<std::uint32_t> next(hull.begin() + static_cast<std::ptrdiff_t>(low),
                                    hull.begin() + static_cast<std::ptrdiff_t>(high) + 1);
    next.push_back(v);
    hull = std::move(next);
  }
  m.points = std::move(points);
  return m;
}

TEST_MESHES_INLINE Mesh random_planar(std::size_t n, unsigned size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(
        {static_cast<double>(random() % size), static_cast<double>(random() % size), 0});
  return swept(std::move(points));
}

TEST_MESHES_INLINE Mesh parabola_fan(std::uint32_t n) {
  Mesh m;
  for (std::uint32_t i = 1; i <= n; ++i) m.points.push_back({1.0 * i, 1.0 * i * i, 0});
  for (std::uint32_t i = 0; i + 2 < n; ++i) m.triangles.push_back({i, i + 1, n - 1});
  return m;
}

TEST_MESHES_INLINE Mesh integer_height_field(std::uint32_t n, unsigned range, unsigned seed) {
  Mesh m = grid(n, n);
  std::mt19937 random(seed);
  for (Point& p : m.points) p[2] = static_cast<double>(random() % range);
  return m;
}

TEST_MESHES_INLINE Mesh integer_terrain(std::size_t n, unsigned size, unsigned seed) {
  Mesh m = random_planar(n, size, seed);
  std::mt19937 random(seed + 1);
  for (Point& p : m.points) p[2] = static_cast<double>(random() % size);
  return m;
}

TEST_MESHES_INLINE Mesh rough_grid(std::uint32_t n, unsigned seed, double height) {
  Mesh m = grid(n, n);
  std::mt19937 random(seed);
  const auto noise = [&random] { return static_cast<double>(random()) / 0x1p32 - 0.5; };
  for (Point& p : m.points)
    p = {p[0] + 0.6 * noise(), p[1] + 0.6 * noise(), p[2] + 2 * height * noise()};
  return m;
}

TEST_MESHES_INLINE Mesh box(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  Mesh m;
  const double size[3] = {1.0 * a, 1.0 * b, 1.0 * c};
  const std::uint32_t cells[3] = {a, b, c};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Mesh side = grid(cells[u], cells[v]);
      const auto offset = static_cast<std::uint32_t>(m.points.size());
      for (const Point& p : side.points) {
        Point q;
        q[u] = p[0];
        q[v] = p[1];
        q[axis] = far ? size[axis] : 0;
        m.points.push_back(q);
      }
      for (Triangle t : side.triangles) {
        if (!far) std::swap(t[1], t[2]);
        m.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
      }
    }
  return welded(m);
}

TEST_MESHES_INLINE Mesh sphere(unsigned levels) {
  Mesh m{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
         {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (unsigned i = 0; i < levels; ++i) m = subdivided(m);
  for (Point& p : m.points) {
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (double& x : p) x /= r;
  }
  return m;
}

TEST_MESHES_INLINE Mesh potato(unsigned levels, unsigned seed) {
  Mesh m = sphere(levels);
  std::mt19937 random(seed);
  for (Point& p : m.points) {
    const double r = 1 + 0.3 * static_cast<double>(random()) / 0x1p32;
    p = {3 * r * p[0], 0.7 * r * p[1], r * p[2]};
  }
  return m;
}

TEST_MESHES_INLINE Mesh walls(const std::vector<std::array<double, 2>>& corners,
                              std::uint32_t levels) {
  Mesh m;
  const auto n = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t z = 0; z <= levels; ++z)
    for (const auto& [x, y] : corners) m.points.push_back({x, y, 1.0 * z});
  for (std::uint32_t z = 0; z < levels; ++z)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = n * z + i, b = n * z + (i + 1) % n, c = a + n, d = b + n;
      if ((i + z) % 2 == 0) {
        m.triangles.push_back({a, b, d});
        m.triangles.push_back({a, d, c});
      } else {
        m.triangles.push_back({a, b, c});
        m.triangles.push_back({b, d, c});
      }
    }
  return m;
}

TEST_MESHES_INLINE Mesh prism(const std::vector<std::array<double, 2>>& corners,
                              std::uint32_t levels) {
  Mesh m = walls(corners, levels);
  const auto n = static_cast<std::uint32_t>(corners.size());
  const std::uint32_t top = n * levels;
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    m.triangles.push_back({0, i + 1, i});
    m.triangles.push_back({top, top + i, top + i + 1});
  }
  return m;
}

TEST_MESHES_INLINE Mesh l_shape(std::uint32_t levels) {
  return prism({{1, 1}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}, levels);
}

TEST_MESHES_INLINE Mesh stairs(std::uint32_t steps, std::uint32_t width, double shear) {
  Mesh m = grid(2 * steps, width);
  for (Point& p : m.points) p[1] += shear * p[0];
  for (Point& p : m.points) {
    const auto i = static_cast<std::uint32_t>(p[0]);
    p[0] = (i + 1) / 2;
    p[2] = i / 2;
  }
  return m;
}

TEST_MESHES_INLINE Mesh folded_lattice(std::uint32_t n, std::uint32_t m, std::uint32_t shear) {
  Mesh g = grid(n, m);
  for (Point& p : g.points) {
    const auto i = static_cast<std::uint32_t>(p[0]), j = static_cast<std::uint32_t>(p[1]);
    const std::uint32_t height =
        j % 4 <= 2 ? j % 4 : 4 - j % 4; // rows are 5 apart along the surface
    p = {5.0 * (2 * i + j % 2 + 2 * shear * j), 3.0 * j, 4.0 * height};
  }
  return g;
}

TEST_MESHES_INLINE Mesh with_cap(Mesh m, std::size_t f) {
  const auto [a, b, c] = m.triangles[f];
  const auto v = static_cast<std::uint32_t>(m.points.size());
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = (m.points[a][k] + m.points[b][k]) / 2;
  m.points.push_back(p);
  m.triangles[f] = {a, v, c};
  m.triangles.push_back({v, b, c});
  m.triangles.push_back({a, b, v});
  return m;
}

TEST_MESHES_INLINE Mesh with_needle(Mesh m, std::size_t f, double distance) {
  const auto [a, b, c] = m.triangles[f];
  const auto v = static_cast<std::uint32_t>(m.points.size());
  Point p = m.points[a];
  p[0] += distance;
  m.points.push_back(p);
  m.triangles[f] = {a, b, v};
  m.triangles.push_back({b, c, v});
  m.triangles.push_back({c, a, v});
  return m;
}

} // namespace meshes

#endif // TEST_INTRINSIC_TRIANGULATIONS_MESHES_IMPL_H
