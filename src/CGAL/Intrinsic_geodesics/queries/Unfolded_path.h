// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_UNFOLDED_PATH_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_UNFOLDED_PATH_H

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The rows of the corners of a face.
inline std::array<std::uint32_t, 3> rows_of_face(const Input& input, std::uint32_t f) {
  std::array<std::uint32_t, 3> result{};
  std::ranges::transform(sides_of_face(input, input.halfedge_of_face(f)), result.begin(),
                         [&](std::uint32_t h) { return input.names().row(input.source(h)); });
  return result;
}

// A face in the plane: its corners by rows, counterclockwise unless it is turned over.
template <class Number>
struct Laid_out_face {
  std::uint32_t face = Gluing::none;
  std::array<std::uint32_t, 3> rows{};
  std::array<Plane_vector<Number>, 3> corners{};
  bool is_turned = false;

  unsigned corner(std::uint32_t row) const {
    return static_cast<unsigned>(std::ranges::find(rows, row) - rows.begin());
  }
};

// A direction in a face, from one of its corners.
template <class Number>
struct Ray_at_corner {
  Laid_out_face<Number> face{};
  Plane_vector<Number> direction{};

  // Its angle with the side from a corner of the face to another one, up to its sign: the argument.
  Plane_vector<Number> angle(std::uint32_t row, std::uint32_t other) const {
    const auto& p = face.corners;
    return in_frame(direction, p[face.corner(other)] - p[face.corner(row)]);
  }
};

/*
Unfolds the faces that a path passes between two of its points, in numbers of a field: the unit is
the first side of the first face.
\\tparam Values returns the squared lengths and the quadruple area of a face
*/
template <class Number, class Values>
class Path_unfolder {
public:
  using Vector = Plane_vector<Number>;

  Path_unfolder(const Input& input, const Traced_curve& path, Values& values)
      : input_(input), path_(path), values_(values) {}

  // Returns whether the faces follow each other.
  bool unfold(std::size_t first, std::size_t last) {
    Laid_out_face<Number> f{path_.faces[first], rows_of_face(input_, path_.faces[first])};
    f.corners[1].x = Number(1);
    right.clear();
    left.clear();
    place_apex(f, 0);
    begin.face = f;
    const std::optional<Vector> from = position(f, path_.points[first]);
    for (std::size_t i = first + 1; i < last; ++i)
      if (!cross_side(f, path_.points[i])) return false;
    const std::optional<Vector> to = position(f, path_.points[last]);
    if (!from || !to) return false;
    start = *from;
    begin.direction = *to - *from;
    end = {std::move(f), *from - *to};
    return true;
  }

  // what was unfolded last: the point where it starts, its ends, and the ends of crossed sides
  Vector start{};
  Ray_at_corner<Number> begin{}, end{};
  std::vector<Vector> right{}, left{};

private:
  // above or below a side whose ends are there
  void place_apex(Laid_out_face<Number>& f, unsigned k) {
    const auto& [l, area] = values_(f.face);
    Vector up = apex(l[k], l[(k + 1) % 3], l[(k + 2) % 3], area);
    if (f.is_turned) up.y = -up.y;
    const Vector& a = f.corners[k];
    f.corners[(k + 2) % 3] = a + (f.corners[(k + 1) % 3] - a) * up;
  }

  // Goes on into the face of the halfedge of a point on one of its sides.
  bool cross_side(Laid_out_face<Number>& f, const Surface_point& p) {
    const std::uint32_t face = input_.face(p.halfedge);
    Laid_out_face<Number> next{face, rows_of_face(input_, face)};
    const auto sides = sides_of_face(input_, input_.halfedge_of_face(face));
    const auto j = static_cast<unsigned>(std::ranges::find(sides, p.halfedge) - sides.begin());
    const unsigned k = f.corner(next.rows[j]), m = f.corner(next.rows[(j + 1) % 3]);
    if (k == 3 || m == 3 || p.weights[2] != 0) return false;
    const bool is_along = m == (k + 1) % 3; // both sides in the same direction
    next.is_turned = is_along != f.is_turned;
    next.corners[j] = f.corners[k];
    next.corners[(j + 1) % 3] = f.corners[m];
    // the face that is left lies to the left of its sides, unless it is turned over
    const bool is_right = is_along != f.is_turned;
    right.push_back(f.corners[is_right ? k : m]);
    left.push_back(f.corners[is_right ? m : k]);
    f = std::move(next);
    place_apex(f, j);
    return true;
  }

  // of a point in a face, or on its boundary
  std::optional<Vector> position(const Laid_out_face<Number>& f, const Surface_point& p) const {
    const bool is_inside = std::ranges::find(p.weights, 0.0) == p.weights.end();
    if (is_inside && input_.face(p.halfedge) != f.face) return std::nullopt;
    const auto sides = sides_of_face(input_, p.halfedge);
    Vector result{};
    Number sum;
    for (unsigned i = 0; i < 3; ++i) {
      if (p.weights[i] == 0) continue;
      const unsigned k = f.corner(input_.names().row(input_.source(sides[i])));
      if (k == 3) return std::nullopt;
      const Number w(p.weights[i]);
      result = result + w * f.corners[k];
      sum = sum + w;
    }
    return result / sum;
  }

  const Input& input_;
  const Traced_curve& path_;
  Values& values_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_UNFOLDED_PATH_H
