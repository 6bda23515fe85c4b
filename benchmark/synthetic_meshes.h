// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_SYNTHETIC_MESHES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_SYNTHETIC_MESHES_H

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

/// Deterministic meshes for measurements and stress tests. All randomness is seeded and drawn from
/// a 64-bit Mersenne twister in a way that does not depend on the standard library.
namespace CGAL::Intrinsic_triangulations::synthetic {

/// holds a triangle soup whose triangles are consistently oriented.
struct Triangle_soup {
  /// Coordinates of the vertices.
  std::vector<std::array<double, 3>> points;
  /// Vertices of each triangle, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Twin of a halfedge on the border.
inline constexpr std::uint32_t no_twin = std::numeric_limits<std::uint32_t>::max();

/// returns the halfedge after `h` in its face; halfedge `3 f + c` leaves corner `c` of face `f`.
inline std::uint32_t next_in_face(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

/// draws an integer in [0, n).
inline std::uint64_t draw_index(std::mt19937_64& rng, std::uint64_t n) { return rng() % n; }

/// draws a real number in [0, 1).
inline double draw_real(std::mt19937_64& rng) {
  return std::ldexp(static_cast<double>(rng() >> 11U), -53);
}

/*!
\brief copies a triangle mesh into a soup, in the order of its vertices and faces.
\tparam Point the point type; its coordinates are converted to `double`
*/
template <class Point>
Triangle_soup to_soup(const CGAL::Surface_mesh<Point>& mesh) {
  Triangle_soup soup;
  soup.points.reserve(mesh.number_of_vertices());
  soup.triangles.reserve(mesh.number_of_faces());
  std::vector<std::uint32_t> number(mesh.num_vertices());
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    number[static_cast<std::size_t>(v)] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto corner = [&](auto g) { return number[static_cast<std::size_t>(mesh.source(g))]; };
    soup.triangles.push_back({corner(h), corner(mesh.next(h)), corner(mesh.prev(h))});
  }
  return soup;
}

/*!
\brief builds a surface mesh from a soup; elements keep the order of the soup.
\tparam Point the point type, constructible from three doubles
\pre the soup is a manifold
*/
template <class Point>
CGAL::Surface_mesh<Point> to_surface_mesh(const Triangle_soup& soup) {
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh mesh;
  using Size = typename Mesh::size_type;
  mesh.reserve(static_cast<Size>(soup.points.size()),
               static_cast<Size>(soup.triangles.size() * 3 / 2 + 1),
               static_cast<Size>(soup.triangles.size()));
  for (const auto& p : soup.points) mesh.add_vertex(Point(p[0], p[1], p[2]));
  using Vertex = typename Mesh::Vertex_index;
  for (const auto& t : soup.triangles) mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

/*!
\brief returns the twin of each halfedge, `no_twin` on the border.
\pre the soup is a manifold with at most one edge between two vertices
\complexity O(n log n)
*/
inline std::vector<std::uint32_t> twins(const Triangle_soup& soup) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sides;
  sides.reserve(3 * soup.triangles.size());
  for (const auto& t : soup.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(t[c], t[(c + 1) % 3]);
      sides.emplace_back((std::uint64_t{low} << 32U) | high,
                         static_cast<std::uint32_t>(sides.size()));
    }
  }
  std::vector<std::uint32_t> twin(sides.size(), no_twin);
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].first != sides[i - 1].first) continue;
    twin[sides[i].second] = sides[i - 1].second;
    twin[sides[i - 1].second] = sides[i].second;
  }
  return twin;
}

/// returns the point `(1 - t) a + t b`.
inline std::array<double, 3> point_between(const std::array<double, 3>& a,
                                           const std::array<double, 3>& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// splits each triangle into four at the midpoints of its edges, once.
inline Triangle_soup midpoint_subdivide_once(const Triangle_soup& soup) {
  const std::vector<std::uint32_t> twin = twins(soup);
  Triangle_soup result{soup.points, {}};
  result.triangles.reserve(4 * soup.triangles.size());
  std::vector<std::uint32_t> middle(twin.size());
  for (std::uint32_t h = 0; h < twin.size(); ++h) {
    if (twin[h] < h) {
      middle[h] = middle[twin[h]];
      continue;
    }
    const auto& t = soup.triangles[h / 3];
    middle[h] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(point_between(soup.points[t[h % 3]], soup.points[t[(h + 1) % 3]], 0.5));
  }
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto [i, j, k] = soup.triangles[f];
    const std::uint32_t ij = middle[3 * f], jk = middle[3 * f + 1], ki = middle[3 * f + 2];
    result.triangles.push_back({i, ij, ki});
    result.triangles.push_back({ij, j, jk});
    result.triangles.push_back({ki, jk, k});
    result.triangles.push_back({ij, jk, ki});
  }
  return result;
}

/// splits each triangle into `4^times` at the midpoints of its edges.
inline Triangle_soup midpoint_subdivide(Triangle_soup soup, unsigned times) {
  for (unsigned i = 0; i < times; ++i) soup = midpoint_subdivide_once(soup);
  return soup;
}

/// multiplies the first coordinate of every point by `factor`.
inline Triangle_soup stretch_x(Triangle_soup soup, double factor) {
  for (auto& p : soup.points) p[0] *= factor;
  return soup;
}

/// splits edges of a soup held in flat arrays; each split takes constant time.
class Edge_splitter {
public:
  /// pairs the halfedges of `soup` and numbers its edges.
  explicit Edge_splitter(Triangle_soup soup) : soup_(std::move(soup)), twin_(twins(soup_)) {
    edge_.resize(twin_.size());
    for (std::uint32_t h = 0; h < twin_.size(); ++h) {
      if (twin_[h] < h) {
        edge_[h] = edge_[twin_[h]];
      } else {
        edge_[h] = new_edge(h);
      }
    }
  }

  /// returns the number of edges.
  std::size_t number_of_edges() const { return side_.size(); }
  /// returns the vertices that edge `e` joins.
  std::array<std::uint32_t, 2> ends(std::size_t e) const {
    return {origin(side_[e]), origin(next_in_face(side_[e]))};
  }
  /// returns the soup.
  const Triangle_soup& soup() const { return soup_; }
  /// moves the soup out.
  Triangle_soup take_soup() && { return std::move(soup_); }

  /// reserves room for `faces` triangles.
  void reserve(std::size_t faces) {
    soup_.triangles.reserve(faces + 1);
    soup_.points.reserve(soup_.points.size() + faces / 2);
    twin_.reserve(3 * faces + 3);
    edge_.reserve(3 * faces + 3);
    side_.reserve(3 * faces / 2 + 3);
  }

  /// splits edge `e` at parameter `t`, and its one or two faces with it.
  void split(std::size_t e, double t) {
    const std::uint32_t h = side_[e], g = twin_[h];
    const std::uint32_t i = origin(h), j = origin(next_in_face(h));
    const auto m = static_cast<std::uint32_t>(soup_.points.size());
    soup_.points.push_back(point_between(soup_.points[i], soup_.points[j], t));
    const std::uint32_t mj = split_face(h, m); // now h goes from i to m, and mj from m to j
    edge_[mj] = new_edge(mj);
    if (g == no_twin) return;
    const std::uint32_t mi = split_face(g, m); // now g goes from j to m, and mi from m to i
    twin_[h] = mi;
    twin_[mi] = h;
    edge_[mi] = edge_[h];
    twin_[g] = mj;
    twin_[mj] = g;
    edge_[g] = edge_[mj];
  }

private:
  std::uint32_t origin(std::uint32_t h) const { return soup_.triangles[h / 3][h % 3]; }

  std::uint32_t new_edge(std::uint32_t h) {
    side_.push_back(h);
    return static_cast<std::uint32_t>(side_.size() - 1);
  }

  /// turns face ijk of `h = ij` into imk, appends face mjk, and returns its halfedge mj.
  std::uint32_t split_face(std::uint32_t h, std::uint32_t m) {
    const std::uint32_t jk = next_in_face(h), k = origin(next_in_face(jk));
    const auto mj = static_cast<std::uint32_t>(twin_.size());
    soup_.triangles.push_back({m, origin(jk), k});
    soup_.triangles[jk / 3][jk % 3] = m;
    twin_.insert(twin_.end(), {no_twin, twin_[jk], jk});
    edge_.insert(edge_.end(), {0, edge_[jk], 0});
    if (twin_[jk] != no_twin) twin_[twin_[jk]] = mj + 1;
    side_[edge_[jk]] = mj + 1;
    twin_[jk] = mj + 2;
    edge_[jk] = edge_[mj + 2] = new_edge(jk);
    return mj;
  }

  Triangle_soup soup_;
  std::vector<std::uint32_t> twin_; // per halfedge
  std::vector<std::uint32_t> edge_; // per halfedge
  std::vector<std::uint32_t> side_; // per edge, one of its halfedges
};

/*!
\brief splits edges drawn uniformly at random, at a parameter in [0.1, 0.9), until there are at
least `faces` faces: slivers in an order that is hard on caches.
*/
inline Triangle_soup random_edge_splits(Triangle_soup soup, std::size_t faces,
                                        std::uint64_t seed = 12345) {
  std::mt19937_64 rng(seed);
  Edge_splitter splitter(std::move(soup));
  splitter.reserve(faces);
  while (splitter.soup().triangles.size() < faces) {
    const auto e = static_cast<std::size_t>(draw_index(rng, splitter.number_of_edges()));
    splitter.split(e, 0.1 + 0.8 * draw_real(rng));
  }
  return std::move(splitter).take_soup();
}

/*!
\brief builds a torus of `rows` parallel circles around its axis with `columns` points each; column
`j` of a row is joined to column `j + shift` of the next one.

Major radius 1. A shift of `s` costs about `s` flips per vertex. Without waves all quadrilaterals of
the result are isosceles trapezoids, cocircular up to rounding.
\param waves relative height of waves on the tube
\pre `rows >= 3`, `columns >= 3`, `shift < columns`
*/
inline Triangle_soup torus(std::uint32_t rows, std::uint32_t columns, double tube_radius,
                           std::uint32_t shift, double waves = 0) {
  Triangle_soup soup;
  soup.points.reserve(std::size_t{rows} * columns);
  soup.triangles.reserve(std::size_t{2} * rows * columns);
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double u = 2 * std::numbers::pi * j / columns, v = 2 * std::numbers::pi * i / rows;
      const double tube = tube_radius * (1 + waves * std::sin(2 * u + 3 * v));
      const double r = 1 + tube * std::cos(v);
      soup.points.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
      const std::uint32_t here = i * columns, there = (i + 1) % rows * columns;
      const std::uint32_t a = here + j, b = here + (j + 1) % columns;
      const std::uint32_t c = there + (j + 1 + shift) % columns, d = there + (j + shift) % columns;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({b, c, d});
    }
  }
  return soup;
}

/// builds the sheared torus of the measurements: 400 x 200 vertices, tube radius 0.35, shift 25;
/// 1.92 million flips make it Delaunay.
inline Triangle_soup shear_torus() { return torus(200, 400, 0.35, 25); }

/*!
\brief builds a torus of about `faces` faces in good order whose flips per face do not depend on its
size: twice as many columns as rows, tube radius 0.35 and waves of a tenth of it, shift 2.
*/
inline Triangle_soup torus_of_size(std::size_t faces) {
  const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(faces) / 4) + 0.5);
  return torus(rows, 2 * rows, 0.35, 2, 0.1);
}

/*!
\brief builds a thin plate as CAD programs triangulate it: no vertices but those of its outline, so
that its faces are slivers.

The outline is an ellipse with `n` points at uneven distances; the walls are strips of
quadrilaterals. Flips in a bad order wind edges around the plate: several times as many as with long
edges first.
\param aspect length of the ellipse over its width
\param thickness in units of the mean distance of points
\param is_fan whether both faces are fans, from opposite ends; else they are cut at random
\pre `n >= 4`
*/
inline Triangle_soup sliver_plate(std::uint32_t n, double aspect, double thickness, bool is_fan,
                                  std::uint64_t seed = 1) {
  std::mt19937_64 rng(seed);
  Triangle_soup soup;
  const double a = n / 4., b = a / aspect; // the circumference is about 4 a
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * std::numbers::pi * (i + 0.8 * draw_real(rng)) / n;
    soup.points.push_back({a * std::cos(u), b * std::sin(u), 0});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto [x, y, z] = soup.points[i];
    soup.points.push_back({x, y, thickness});
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({i, j, n + j});
    soup.triangles.push_back({i, n + j, n + i});
  }
  for (const std::uint32_t side :
       {0U, 1U}) { // both turn around by n / 2: fans are from opposite ends
    std::vector<std::array<std::uint32_t, 2>> chains = {{0, n - 1}};
    while (!chains.empty()) {
      const auto [i, k] = chains.back();
      chains.pop_back();
      if (k - i < 2) continue;
      const auto j =
          is_fan ? k - 1 : i + 1 + static_cast<std::uint32_t>(draw_index(rng, k - i - 1));
      chains.push_back({i, j});
      chains.push_back({j, k});
      const auto vertex = [=](std::uint32_t v) { return side * n + (v + side * (n / 2)) % n; };
      if (side == 0)
        soup.triangles.push_back({vertex(k), vertex(j), vertex(i)});
      else
        soup.triangles.push_back({vertex(i), vertex(j), vertex(k)});
    }
  }
  return soup;
}

/*!
\brief triangulates the strip between the parabolas `y = 1 + x^2/4` and `y = -1 - x^2/4` so that
every way to Delaunay takes a number of flips quadratic in `n`.

Each chain has `n` points. The triangulations of the strip are the words in n - 1 letters U and L
(bases on the upper and lower chain), a flip exchanges two neighbouring letters; the mesh is
`U...UL...L`, the Delaunay triangulation alternates by symmetry: about `n^2 / 2` exchanges.
\pre `n >= 2`
*/
inline Triangle_soup double_parabola(std::uint32_t n) {
  Triangle_soup soup;
  for (const double side : {-1., 1.}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = 2. * i / (n - 1) - 1;
      soup.points.push_back({x, side * (1 + x * x / 4), 0});
    }
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) soup.triangles.push_back({0, n + i + 1, n + i});
  for (std::uint32_t i = 0; i + 1 < n; ++i) soup.triangles.push_back({i, i + 1, 2 * n - 1});
  return soup;
}

} // namespace CGAL::Intrinsic_triangulations::synthetic

#endif // CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_SYNTHETIC_MESHES_H
