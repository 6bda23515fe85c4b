// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_UNFOLDED_PATHS_H
#define TEST_INTRINSIC_TRIANGULATIONS_UNFOLDED_PATHS_H

#include "meshes.h"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// Paths over a mesh in space, in 200 digits: the faces that they cross are laid out in the plane,
// one after the other. Of a path, they use only its vertices and the faces in between.

namespace unfolded_paths {

using Wide = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<200>,
                                           boost::multiprecision::et_off>;
using Vector = std::array<Wide, 2>;

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Wide dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Wide cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Wide norm(const Vector& a) { return sqrt(dot(a, a)); }
inline Wide pi() { return boost::math::constants::pi<Wide>(); }
/// The rounding error of zero in 200 digits.
inline Wide tiny() { return Wide("1e-150"); }

/// The properties of a path, in 200 digits.
struct Path {
  Wide length = 0;
  /// The distance by which it passes an end of an edge on the wrong side, relative to its length:
  /// at most rounding for a straight line.
  Wide deviation = 0;
  /// The smallest angle at a vertex that it passes, on either side; the border has none.
  Wide least_angle = 2 * pi();
};

/// From a vertex to the next one, across faces: each has one edge in common with the next one.
struct Piece {
  std::uint32_t from, to;
  std::vector<std::uint32_t> faces;
};

class Unfolder {
public:
  /// \param mesh oriented, and a manifold
  explicit Unfolder(const meshes::Mesh& mesh) : mesh_(mesh) {
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        face_of_[{mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]}] = f;
  }

  Path operator()(const std::vector<Piece>& pieces) const {
    Path path;
    Stop arrival{};
    for (const Piece& p : pieces) {
      const Line line = unfold(p);
      path.length += line.length;
      path.deviation = std::max(path.deviation, line.deviation);
      if (&p != &pieces.front()) pass(arrival, line.start, path);
      arrival = line.end;
    }
    return path;
  }

private:
  // A triangle in the plane, counterclockwise.
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<Vector, 3> at;
    std::size_t corner(std::uint32_t v) const {
      const auto k = std::find(vertex.begin(), vertex.end(), v) - vertex.begin();
      if (k == 3) throw std::logic_error("the path does not pass from a face to the next");
      return static_cast<std::size_t>(k);
    }
  };
  // Where a line starts or ends: in a face, at a vertex of it, at an angle from the next corner.
  struct Stop {
    std::uint32_t face, vertex;
    Wide angle;
  };
  struct Line {
    Wide length, deviation;
    Stop start, end;
  };
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  Wide squared_length(std::uint32_t a, std::uint32_t b) const {
    Wide sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide d = Wide(mesh_.points[a][k]) - Wide(mesh_.points[b][k]);
      sum += d * d;
    }
    return sum;
  }

  // a face with the side from its corner k on where it is already
  Triangle laid_out(std::uint32_t f, std::size_t k, const Vector& a, const Vector& b) const {
    Triangle t{mesh_.triangles[f], {}};
    const std::uint32_t i = t.vertex[k], j = t.vertex[(k + 1) % 3], m = t.vertex[(k + 2) % 3];
    const Wide ij = squared_length(i, j), im = squared_length(i, m), jm = squared_length(j, m);
    const Wide along = (ij + im - jm) / (2 * ij); // parts of the side
    const Wide square = im / ij - along * along;
    const Wide off = square > 0 ? Wide(sqrt(square)) : Wide(0);
    const Vector d = b - a;
    t.at[k] = a;
    t.at[(k + 1) % 3] = b;
    t.at[(k + 2) % 3] = {a[0] + along * d[0] - off * d[1], a[1] + along * d[1] + off * d[0]};
    return t;
  }
  Triangle laid_out(std::uint32_t f) const {
    const auto& v = mesh_.triangles[f];
    return laid_out(f, 0, {0, 0}, {sqrt(squared_length(v[0], v[1])), 0});
  }

  // the side of a triangle that a face has too, by its first corner
  std::size_t common_side(const Triangle& t, std::uint32_t f) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto across = face_of_.find({t.vertex[(k + 1) % 3], t.vertex[k]});
      if (across != face_of_.end() && across->second == f) return k;
    }
    throw std::logic_error("the path does not pass from a face to the next");
  }

  Line unfold(const Piece& p) const {
    const Triangle first = laid_out(p.faces.front());
    Triangle last = first;
    std::vector<std::array<Vector, 2>> doors; // right and left
    for (std::size_t i = 1; i < p.faces.size(); ++i) {
      const std::size_t k = common_side(last, p.faces[i]);
      const std::uint32_t left = last.vertex[(k + 1) % 3];
      doors.push_back({last.at[k], last.at[(k + 1) % 3]});
      const Triangle next{mesh_.triangles[p.faces[i]], {}};
      last = laid_out(p.faces[i], next.corner(left), doors.back()[1], doors.back()[0]);
    }
    const Vector start = first.at[first.corner(p.from)], end = last.at[last.corner(p.to)];
    const Vector d = end - start;
    Line line{norm(d), 0, stop(first, p.faces.front(), p.from, end),
              stop(last, p.faces.back(), p.to, start)};
    for (const auto& [right, left] : doors)
      line.deviation = std::max({line.deviation, Wide(cross(d, right - start) / dot(d, d)),
                                 Wide(-cross(d, left - start) / dot(d, d))});
    return line;
  }

  static Stop stop(const Triangle& t, std::uint32_t face, std::uint32_t v, const Vector& other) {
    const std::size_t k = t.corner(v);
    return {face, v, angle(t.at[(k + 1) % 3] - t.at[k], other - t.at[k])};
  }
  static Wide angle(const Vector& a, const Vector& b) { return atan2(cross(a, b), dot(a, b)); }

  // the face counterclockwise after another one about a vertex, or before it; none at the border
  std::uint32_t beside(std::uint32_t f, std::uint32_t v, bool is_after) const {
    const auto& t = mesh_.triangles[f];
    const std::size_t k = laid_out(f).corner(v);
    const std::uint32_t w = t[(k + (is_after ? 2 : 1)) % 3];
    const auto found = face_of_.find(is_after ? std::pair{v, w} : std::pair{w, v});
    return found == face_of_.end() ? none : found->second;
  }

  void pass(const Stop& in, const Stop& out, Path& path) const {
    const std::uint32_t v = in.vertex;
    std::uint32_t first = in.face; // of the fan, if it is one
    for (std::uint32_t f = in.face; (f = beside(f, v, false)) != none && f != in.face;) first = f;
    const bool is_on_border = beside(first, v, false) == none;
    if (!is_on_border) first = in.face;
    Wide sum = 0, at_in = 0, at_out = 0;
    std::uint32_t f = first;
    do {
      if (f == in.face) at_in = sum + in.angle;
      if (f == out.face) at_out = sum + out.angle;
      const Triangle t = laid_out(f);
      const std::size_t k = t.corner(v);
      sum += angle(t.at[(k + 1) % 3] - t.at[k], t.at[(k + 2) % 3] - t.at[k]);
      f = beside(f, v, true);
    } while (f != none && f != first);
    const Wide between = abs(at_out - at_in);
    path.least_angle = std::min(path.least_angle, between);
    if (!is_on_border) path.least_angle = std::min(path.least_angle, Wide(sum - between));
  }

  const meshes::Mesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of_;
};

} // namespace unfolded_paths

#endif // TEST_INTRINSIC_TRIANGULATIONS_UNFOLDED_PATHS_H
