// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_MESHES_H
#define TEST_INTRINSIC_TRIANGULATIONS_MESHES_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

// Small meshes in space as tests of Delaunay flips.

namespace meshes {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;

using Triangle = std::array<std::uint32_t, 3>;

struct Mesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  IT::Gluing_map map() const {
    return IT::Gluing_map(
        IT::gluing_from_triangles(static_cast<std::uint32_t>(points.size()), triangles));
  }
  IT::Intrinsic_input input(IT::Mollification m = IT::Mollification::none) const {
    return {map(), points, m};
  }
};

// ---- points of space

inline Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline double dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
inline double distance(const Point& p, const Point& q) { return norm(minus(p, q)); }

/// Where a point of a surface is, such as an input, whose vertices are at these points.
template <class Surface, class Surface_point>
Point position(const Surface& s, const std::vector<Point>& points, const Surface_point& p) {
  Point x{};
  auto h = p.halfedge;
  for (const double w : p.weights) {
    for (std::size_t k = 0; k < 3; ++k) x[k] += w * points[s.source(h)][k];
    h = s.next(h);
  }
  return x;
}

/// A normal of a polygon, as long as its area.
inline Point area_vector(const std::vector<Point>& points, std::span<const std::uint32_t> polygon) {
  Point sum{};
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Point n = cross(minus(points[polygon[k - 1]], points[polygon[0]]),
                          minus(points[polygon[k]], points[polygon[0]]));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += n[c] / 2;
  }
  return sum;
}
inline double area(const Mesh& m) {
  double sum = 0;
  for (const Triangle& t : m.triangles) sum += norm(area_vector(m.points, t));
  return sum;
}

// ---- changes of meshes

/// Multiplies coordinates: exactly, if `factor` is a power of two.
Mesh scaled(Mesh m, double factor);

Mesh translated(Mesh m, const Point& by);

/// Reflected in the plane x = 0; triangles turn with it.
Mesh mirrored(Mesh m);

/// A random order of 0, 1, ..., n - 1.
std::vector<std::uint32_t> permutation(std::size_t n, unsigned seed);

/// Vertex `v` becomes vertex `order[v]`; triangles are shuffled, and start from another corner.
Mesh permuted(const Mesh& m, const std::vector<std::uint32_t>& order, unsigned seed);

/// Every triangle becomes four; new points are midpoints.
Mesh subdivided(const Mesh& m);

/// Welds the vertices that lie in the same place.
Mesh welded(const Mesh& m);

// ---- flat

/// Cells of size dx by dy, each cut by a diagonal; vertex (i, j) has number (n + 1) j + i.
Mesh grid(std::uint32_t n, std::uint32_t m, double dx = 1, double dy = 1);

/// A grid with x shifted by `shear` times y: long thin triangles.
Mesh sheared_grid(std::uint32_t n, std::uint32_t m, double shear);

/*!
Triangulates the convex hull of points in the plane by sweeping them in lexicographic order: each
point is joined to all that it sees of the hull of those before. Coordinates are integers below
2^20.
*/
Mesh swept(std::vector<Point> points);

/// `n` random points of integer coordinates below `size`, triangulated badly.
Mesh random_planar(std::size_t n, unsigned size, unsigned seed);

/// The points (i, i^2), all joined to the last: no circle through four of them, and far from
/// Delaunay.
Mesh parabola_fan(std::uint32_t n);

// ---- in space

/// Heights in 0, ..., `range` - 1 over a grid: random integers.
Mesh integer_height_field(std::uint32_t n, unsigned range, unsigned seed);

/// A random planar triangulation lifted to random integer heights.
Mesh integer_terrain(std::size_t n, unsigned size, unsigned seed);

/// A grid moved at random in all directions: no ties.
Mesh rough_grid(std::uint32_t n, unsigned seed, double height = 0.8);

/// The surface of a box of a x b x c unit cells.
Mesh box(std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// An octahedron subdivided and projected to the sphere.
Mesh sphere(unsigned levels);

/// A sphere pulled apart and dented: obtuse triangles, no ties.
Mesh potato(unsigned levels, unsigned seed);

/*!
Walls over a closed polygon with corners in the plane z = 0, in `levels` bands of height 1, without
floor and ceiling; diagonals alternate. All wall faces are rectangles: their diagonals are ties.
*/
Mesh walls(const std::vector<std::array<double, 2>>& corners, std::uint32_t levels);

/// A prism over an integer polygon, convex or star-shaped from its first corner, with fans as ends.
Mesh prism(const std::vector<std::array<double, 2>>& corners, std::uint32_t levels);

/// An L of unit squares, thick: with a reentrant edge.
Mesh l_shape(std::uint32_t levels);

/// Stairs of unit squares, sheared along the steps.
Mesh stairs(std::uint32_t steps, std::uint32_t width, double shear = 0);

/*!
The square lattice turned by 45 degrees, sheared, and folded along every other row through a 3-4-5
angle: squares of the lattice have their corners in two planes, and are ties. Integer coordinates.
*/
Mesh folded_lattice(std::uint32_t n, std::uint32_t m, std::uint32_t shear);

// ---- degenerate

/// Splits the first side of face `f` at its midpoint, in that face alone and with the same
/// vertices on the other side: the new triangle has its third vertex exactly inside its long edge.
Mesh with_cap(Mesh m, std::size_t f);

/// Splits face `f` at a point that lies on its first corner, or off it by `distance` along x.
Mesh with_needle(Mesh m, std::size_t f, double distance);

} // namespace meshes

#ifndef TEST_MESHES_COMPILED
#include "meshes_impl.h"
#endif

#endif // TEST_INTRINSIC_TRIANGULATIONS_MESHES_H
