// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

using Long_number = Ball<Mpfr_number>;

struct Long_vector {
  Long_number x, y;

  friend Long_vector operator-(const Long_vector& a, const Long_vector& b) {
    return {a.x - b.x, a.y - b.y};
  }
};
Long_number cross(const Long_vector& a, const Long_vector& b) { return a.x * b.y - a.y * b.x; }
Long_number dot(const Long_vector& a, const Long_vector& b) { return a.x * b.x + a.y * b.y; }

bool has_sign(const Long_number& x, Sign sign) {
  const Uncertain<Sign> s = x.sign();
  return s.is_certain() && s.make_certain() == sign;
}

// At most the angle of a vector with this sine and cosine, up to a factor. The margin is that of
// conversions and of `atan2`, which errs by less than two units, and of the sums of such angles.
double least_angle(const Long_number& sine, const Long_number& cosine) {
  const double s = std::abs(sine.to_double()), c = cosine.to_double(),
               size = std::max(s, std::abs(c));
  const auto error = static_cast<double>(sine.radius() + cosine.radius());
  if (!(size > 0 && size < 0x1p1000 && error < 0x1p-55 * size)) return 0;
  return std::max(0.0, std::atan2(s, c) - 0x1p-48);
}

// A face in the plane: its corners by rows, counterclockwise unless it is turned over.
struct Laid_out_face {
  std::uint32_t face = Gluing::none;
  std::array<std::uint32_t, 3> rows{};
  std::array<Long_vector, 3> corners;
  bool is_turned = false;

  unsigned corner(std::uint32_t row) const {
    return static_cast<unsigned>(std::ranges::find(rows, row) - rows.begin());
  }
};

// A direction in a face, from one of its corners.
struct Ray_at_corner {
  Laid_out_face face;
  Long_vector direction;

  // Its least angles with the other sides at a corner, by the rows at their ends.
  std::map<std::uint32_t, double> angles(std::uint32_t row) const {
    const unsigned k = face.corner(row);
    std::map<std::uint32_t, double> result;
    for (const unsigned other : {(k + 1) % 3, (k + 2) % 3}) {
      const Long_vector side = face.corners[other] - face.corners[k];
      result[face.rows[other]] = least_angle(cross(direction, side), dot(direction, side));
    }
    return result;
  }
};

// Proves one path.
class Path_on_faces_prover {
public:
  Path_on_faces_prover(const Input& input, const Traced_curve& path)
      : input_(input), path_(path), precision_(static_cast<unsigned>(std::min<std::size_t>(
                                        Mpfr_number::most_bits, 256 + 8 * path.points.size()))) {}

  Certificate_on_faces run() {
    const std::size_t n = path_.points.size();
    if (path_.status != Status::done || path_.faces.size() + 1 != n)
      return unproven("rounding has led the path astray");
    for (std::size_t first = 0, last = 1; first + 1 < n; first = last++) {
      while (last + 1 < n && !row_at(path_.points[last])) ++last;
      if (!lay_out(first, last))
        return unproven("a vertex is within rounding of the path, or a face has no area");
      if (first > 0 && obstacle_.empty() && !turns_by_pi(*row_at(path_.points[first])))
        obstacle_ = "the path passes vertex " + std::to_string(*row_at(path_.points[first])) +
                    ", and a way around it turns by less than pi, or by pi within rounding";
      end_ = next_end_;
    }
    return {obstacle_, length_};
  }

private:
  static Certificate_on_faces unproven(const std::string& obstacle) {
    return {obstacle, {0, std::numeric_limits<double>::infinity()}};
  }

  const Input_face_intervals<Long_number>::Face& values(std::uint32_t f) {
    const auto [place, is_new] = values_.try_emplace(f);
    if (is_new) place->second = Input_face_intervals<Long_number>::face(input_.metric(), f);
    return place->second;
  }
  std::array<std::uint32_t, 3> rows(std::uint32_t f) const {
    std::array<std::uint32_t, 3> result{};
    std::ranges::transform(sides_of_face(input_, input_.halfedge_of_face(f)), result.begin(),
                           [&](std::uint32_t h) { return input_.names().row(input_.source(h)); });
    return result;
  }

  // The row of the vertex where a point is, if there is one.
  std::optional<std::uint32_t> row_at(const Surface_point& p) const {
    for (unsigned k = 0; k < 3; ++k)
      if (p.weights[(k + 1) % 3] == 0 && p.weights[(k + 2) % 3] == 0)
        return input_.names().row(input_.source(sides_of_face(input_, p.halfedge)[k]));
    return std::nullopt;
  }

  // Places the apex of a face above or below a side whose ends are there.
  bool place_apex(Laid_out_face& f, unsigned k) {
    const auto& [l, area] = values(f.face);
    const Long_number &ij = l[k], &jk = l[(k + 1) % 3], &ki = l[(k + 2) % 3];
    if (!has_sign(area, POSITIVE) || !has_sign(ij, POSITIVE)) return false;
    const Long_number x = (ij + ki - jk) / (ij + ij), up = area / (ij + ij),
                      y = f.is_turned ? -up : up;
    const Long_vector& a = f.corners[k];
    const Long_vector side = f.corners[(k + 1) % 3] - a;
    f.corners[(k + 2) % 3] = {a.x + side.x * x - side.y * y, a.y + side.x * y + side.y * x};
    return true;
  }

  // Goes on into the face of the halfedge of a point on one of its sides.
  bool cross_side(Laid_out_face& f, const Surface_point& p, std::vector<Long_vector>& right,
                  std::vector<Long_vector>& left) {
    Laid_out_face next{input_.face(p.halfedge), {}, {}, false};
    next.rows = rows(next.face);
    const auto sides = sides_of_face(input_, input_.halfedge_of_face(next.face));
    const auto j = static_cast<unsigned>(std::ranges::find(sides, p.halfedge) - sides.begin());
    const std::uint32_t a = next.rows[j], b = next.rows[(j + 1) % 3];
    const unsigned k = f.corner(a), m = f.corner(b);
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
    return place_apex(f, j);
  }

  // A point in a face, or on its boundary.
  std::optional<Long_vector> position(const Laid_out_face& f, const Surface_point& p) const {
    const bool is_inside = std::ranges::find(p.weights, 0.0) == p.weights.end();
    if (is_inside && input_.face(p.halfedge) != f.face) return std::nullopt;
    const auto sides = sides_of_face(input_, p.halfedge);
    Long_number x, y, sum;
    for (unsigned i = 0; i < 3; ++i) {
      if (p.weights[i] == 0) continue;
      const unsigned k = f.corner(input_.names().row(input_.source(sides[i])));
      if (k == 3) return std::nullopt;
      const Long_number w(p.weights[i]);
      x = x + w * f.corners[k].x;
      y = y + w * f.corners[k].y;
      sum = sum + w;
    }
    return Long_vector{x / sum, y / sum};
  }

  // Unfolds the faces between two points. Returns whether the straight line between them is there.
  bool lay_out(std::size_t first, std::size_t last) {
    Laid_out_face f{path_.faces[first], rows(path_.faces[first]), {}, false};
    f.corners[1].x = Long_number(1);
    if (!place_apex(f, 0)) return false;
    const std::optional<Long_vector> start = position(f, path_.points[first]);
    const Laid_out_face first_face = f;
    std::vector<Long_vector> right, left;
    for (std::size_t i = first + 1; i < last; ++i)
      if (!cross_side(f, path_.points[i], right, left)) return false;
    const std::optional<Long_vector> end = position(f, path_.points[last]);
    if (!start || !end) return false;
    const Long_vector line = *end - *start;
    const auto is_on_side = [&](Sign side) {
      return [&line, &start, side](const Long_vector& v) {
        return has_sign(cross(line, v - *start), side);
      };
    };
    if (!std::ranges::all_of(right, is_on_side(NEGATIVE)) ||
        !std::ranges::all_of(left, is_on_side(POSITIVE)))
      return false;
    begin_ = {first_face, line};
    next_end_ = {f, *start - *end};
    add_length(sqrt(dot(line, line) * values(first_face.face).first[0]));
    return true;
  }

  void add_length(const Long_number& length) {
    const double l = length.to_double(),
                 error = static_cast<double>(length.radius()) * (1 + 0x1p-40) + l * 0x1p-51;
    const double unit = std::ldexp(1.0, -input_.scale_exponent());
    length_ += Interval_nt<>(unit * std::max(0.0, l - error), unit * (l + error));
  }

  // The faces about a vertex: the rows of two sides, and the angle between them.
  struct Corner {
    std::uint32_t from, to;
    double angle;
  };
  std::vector<Corner> corners_about(std::uint32_t row) {
    std::vector<Corner> result;
    for (std::uint32_t name = 0; name < input_.number_of_faces(); name += 2) {
      const std::uint32_t f = input_.names().faces.here(name); // a front
      const std::array<std::uint32_t, 3> r = rows(f);
      const auto k = static_cast<unsigned>(std::ranges::find(r, row) - r.begin());
      if (k == 3) continue;
      const auto& [l, area] = values(f);
      result.push_back({r[(k + 1) % 3], r[(k + 2) % 3],
                        least_angle(area, l[k] + l[(k + 2) % 3] - l[(k + 1) % 3])});
    }
    return result;
  }

  // Whether all ways around a vertex, from where the path comes to where it goes on, are at least
  // pi: shortest ways over the sides at the vertex, any number of faces at each.
  bool turns_by_pi(std::uint32_t row) {
    if (end_.face.face == begin_.face.face) return false;
    std::map<std::uint32_t, double> least = end_.angles(row);
    const std::vector<Corner> corners = corners_about(row);
    const auto shorten = [&least](std::uint32_t from, std::uint32_t to, double angle) {
      const auto found = least.find(from);
      if (found == least.end() || found->second + angle > 4) return false;
      const auto [place, is_new] = least.try_emplace(to, found->second + angle);
      if (!is_new && place->second <= found->second + angle) return false;
      place->second = found->second + angle;
      return true;
    };
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (const Corner& c : corners) {
        is_changed |= shorten(c.from, c.to, c.angle);
        is_changed |= shorten(c.to, c.from, c.angle);
      }
    }
    return std::ranges::all_of(begin_.angles(row), [&least](const auto& last) {
      const auto found = least.find(last.first);
      return found == least.end() || found->second + last.second > std::numbers::pi * (1 + 0x1p-50);
    });
  }

  const Input& input_;
  const Traced_curve& path_;
  Mpfr_precision precision_;
  std::map<std::uint32_t, Input_face_intervals<Long_number>::Face> values_;
  Ray_at_corner end_, begin_, next_end_; // where pieces end at a vertex, and begin there
  std::string obstacle_;
  Interval_nt<> length_{0};
};

} // namespace

} // namespace internal

Certificate_on_faces certify_on_faces(const Input& input, const Traced_curve& path) {
  return internal::Path_on_faces_prover(input, path).run();
}

} // namespace CGAL::Intrinsic_triangulations
