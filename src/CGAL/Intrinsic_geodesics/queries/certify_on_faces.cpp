// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/queries/Unfolded_path.h>
#include <CGAL/Intrinsic_geodesics/queries/certify_on_faces.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Faces_in_field.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

bool has_sign(const Long_ball& x, Sign sign) {
  const Uncertain<Sign> s = x.sign();
  return s.is_certain() && s.make_certain() == sign;
}

// At most the argument of a complex number whose imaginary part is not negative. The margin is that
// of conversions and of `atan2`, which errs by less than two units, and of the sums of such angles.
double least_angle(const Plane_vector<Long_ball>& z) {
  const double s = std::max(0.0, z.y.to_double()), c = z.x.to_double(),
               size = std::max(s, std::abs(c));
  const auto error = static_cast<double>(z.y.radius() + z.x.radius());
  if (!(size > 0 && size < 0x1p1000 && error < 0x1p-55 * size)) return 0;
  return std::max(0.0, std::atan2(s, c) - 0x1p-48);
}

// The values of faces, which are kept, and whether all have area.
class Long_values {
public:
  explicit Long_values(const Input_metric& input) : input_(input) {}

  const Input_face_intervals<Long_ball>::Face& operator()(std::uint32_t f) {
    const auto [place, is_new] = values_.try_emplace(f);
    if (is_new) place->second = Input_face_intervals<Long_ball>::face(input_, f);
    have_area = have_area && has_sign(place->second.second, POSITIVE);
    return place->second;
  }
  bool have_area = true;

private:
  const Input_metric& input_;
  std::map<std::uint32_t, Input_face_intervals<Long_ball>::Face> values_;
};

// The same in the field of the areas.
class Field_values {
public:
  using Face = std::pair<std::array<Multiquadratic_number, 3>, Multiquadratic_number>;

  explicit Field_values(const Input_metric& input) : faces_(input) {
    faces_.basis().limit_products(thresholds::words_over_prisms);
  }
  Face operator()(std::uint32_t f) {
    const auto& [l, area] = faces_(f);
    return {{l[0], l[1], l[2]}, Multiquadratic_number(faces_.basis(), area)};
  }

private:
  Faces_in_field faces_;
};

// Two ends of pieces of a path at a vertex: where it comes from, and where it goes on.
template <class Number>
using Rays = std::array<Ray_at_corner<Number>, 2>;

// The faces at a vertex where a path comes from one and goes on into another one.
class Vertex_on_path {
public:
  Vertex_on_path(const Input& input, std::uint32_t row, const Rays<Long_ball>& rays,
                 Long_values& values)
      : input_(input), row_(row) {
    for (const std::uint32_t end : {come, go})
      for (const std::uint32_t side : rays[end - come].face.rows)
        if (side != row) add({end, side, Gluing::none}, rays, values);
    for (std::uint32_t name = 0; name < input.number_of_faces(); name += 2) {
      const std::uint32_t f = input.names().faces.here(name); // a front
      const std::array<std::uint32_t, 3> r = rows_of_face(input, f);
      const auto k = static_cast<unsigned>(std::ranges::find(r, row) - r.begin());
      if (k < 3) add({r[(k + 1) % 3], r[(k + 2) % 3], f}, rays, values);
    }
    find_rests();
  }

  /*
  Whether all ways around the vertex are at least pi: over the sides there, any number of faces at
  each. Those that may be less are compared exactly; not so if there are too many of them.
  \param rays_in_field finds the rays again
  \throws std::length_error if numbers of the field have too many terms
  */
  template <class Rays_in_field>
  bool turns_by_pi(const Rays_in_field& rays_in_field) const {
    Field_values values(input_.metric());
    std::optional<Rays<Multiquadratic_number>> rays;
    const auto sign_of = [&](const auto& faces, const auto& expression) {
      const auto value = [&]<class Number>(const auto& z_of) -> Number {
        std::vector<Face_values<Number>> v;
        for (const Indexed_face& f : faces) {
          const Plane_vector<Number> z = z_of(angles_[f.face]);
          v.push_back({{z.x, Number(0), Number(0)}, z.y});
        }
        return expression(std::span<const Face_values<Number>>(v));
      };
      const Uncertain<Sign> s =
          value.template operator()<Long_ball>([](const Angle& a) { return a.z; }).sign();
      if (s.is_certain()) return s.make_certain();
      if (!rays) rays = rays_in_field(values);
      if (!value
               .template operator()<Multiquadratic_number>(
                   [&](const Angle& a) { return argument(a, *rays, values); })
               .is_zero())
        throw std::length_error("a number of so many bits is not zero");
      return ZERO;
    };
    std::vector<std::uint32_t> way, passed{come};
    std::size_t steps = 0;
    const auto is_pi = [&](const Wedge& w) { return compare_wedge_to_pi(w, sign_of) != SMALLER; };
    return all_ways_from(come, 0, way, passed, steps, is_pi);
  }

private:
  static constexpr std::uint32_t come = Gluing::none - 2, go = Gluing::none - 1;
  static constexpr std::size_t most_steps = 1024; // ways may be exponentially many: no certificate

  // A corner of a face, between two sides that are named by the rows at their ends; or a part of
  // one, between a ray and a side.
  struct Angle {
    std::uint32_t from, to;
    std::uint32_t face; // none if it is a part
    bool is_mirrored = false;
    Plane_vector<Long_ball> z{}; // its argument is the angle
    double least = 0;            // at most the angle

    std::uint32_t other(std::uint32_t end) const { return end == from ? to : from; }
  };

  // `Angle::z` in numbers of a field
  template <class Number, class Values>
  Plane_vector<Number> argument(const Angle& a, const Rays<Number>& rays, Values& values) const {
    if (a.face == Gluing::none) {
      Plane_vector<Number> z = rays[a.from - come].angle(row_, a.to);
      if (a.is_mirrored) z.y = -z.y;
      return z;
    }
    const std::array<std::uint32_t, 3> r = rows_of_face(input_, a.face);
    const auto k = static_cast<unsigned>(std::ranges::find(r, row_) - r.begin());
    const auto& [l, area] = values(a.face);
    return scaled_corner(l[k], l[(k + 1) % 3], l[(k + 2) % 3], area);
  }

  void add(Angle a, const Rays<Long_ball>& rays, Long_values& values) {
    a.z = argument(a, rays, values);
    a.is_mirrored = a.z.y.to_double() < 0;
    if (a.is_mirrored) a.z.y = -a.z.y;
    a.least = least_angle(a.z);
    angles_.push_back(a);
  }

  // the least angles from sides to where the path goes on
  void find_rests() {
    rest_[go] = 0;
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (const Angle& a : angles_)
        for (const std::uint32_t end : {a.from, a.to}) {
          const auto found = rest_.find(a.other(end));
          if (found == rest_.end() || found->second + a.least > 4) continue;
          const auto [place, is_new] = rest_.try_emplace(end, found->second + a.least);
          is_changed = is_changed || is_new || place->second > found->second + a.least;
          place->second = std::min(place->second, found->second + a.least);
        }
    }
  }

  // Whether all ways on from a side have a property, but those that are certainly beyond pi.
  template <class Has_property>
  bool all_ways_from(std::uint32_t end, double angle, std::vector<std::uint32_t>& way,
                     std::vector<std::uint32_t>& passed, std::size_t& steps,
                     const Has_property& has_property) const {
    if (++steps > most_steps) return false;
    if (end == go) return has_property(wedge(way));
    for (std::uint32_t i = 0; i < angles_.size(); ++i) {
      const Angle& a = angles_[i];
      if (end != a.from && end != a.to) continue;
      const std::uint32_t next = a.other(end);
      const auto rest = rest_.find(next);
      if (rest == rest_.end() || std::ranges::find(passed, next) != passed.end() ||
          angle + a.least + rest->second > std::numbers::pi * (1 + 0x1p-50))
        continue;
      way.push_back(i);
      passed.push_back(next);
      if (!all_ways_from(next, angle + a.least, way, passed, steps, has_property)) return false;
      way.pop_back();
      passed.pop_back();
    }
    return true;
  }

  Wedge wedge(const std::vector<std::uint32_t>& way) const {
    Wedge result;
    for (const std::uint32_t i : way) {
      const Plane_vector<Long_ball>& z = angles_[i].z;
      result.add({i, {}}, Face_values<double>{{z.x.to_double(), 0, 0}, z.y.to_double()});
    }
    return result;
  }

  const Input& input_;
  std::uint32_t row_;
  std::vector<Angle> angles_;
  std::map<std::uint32_t, double> rest_;
};

// Proves one path.
class Path_on_faces_prover {
public:
  Path_on_faces_prover(const Input& input, const Traced_curve& path)
      : input_(input), path_(path), precision_(static_cast<unsigned>(std::min<std::size_t>(
                                        Mpfr_number::most_bits, 256 + 8 * path.points.size()))),
        values_(input.metric()), piece_(input, path, values_) {}

  Certificate_on_faces run() {
    const std::size_t n = path_.points.size();
    if (path_.status != Status::done || path_.faces.size() + 1 != n)
      return unproven("rounding has led the path astray");
    for (std::size_t before = 0, first = 0, last = 1; first + 1 < n;
         before = first, first = last++) {
      const Ray_at_corner<Long_ball> end = std::move(piece_.end);
      while (last + 1 < n && !row_at(path_.points[last])) ++last;
      if (!is_straight(first, last))
        return unproven("a vertex is within rounding of the path, or a face has no area");
      add_length();
      if (first > 0 && obstacle_.empty() && !turns_by_pi(before, first, last, {end, piece_.begin}))
        obstacle_ = "the path passes vertex " + std::to_string(*row_at(path_.points[first])) +
                    ", and a way around it turns by less than pi, or by so nearly pi that it is "
                    "not decided";
    }
    return {obstacle_, length_};
  }

private:
  static Certificate_on_faces unproven(const std::string& obstacle) {
    return {obstacle, {0, std::numeric_limits<double>::infinity()}};
  }

  // The row of the vertex where a point is, if there is one.
  std::optional<std::uint32_t> row_at(const Surface_point& p) const {
    const unsigned k = corner_of(p);
    if (k == 3) return std::nullopt;
    return input_.names().row(input_.source(sides_of_face(input_, p.halfedge)[k]));
  }

  // Whether the straight line between two points is in the faces between them.
  bool is_straight(std::size_t first, std::size_t last) {
    if (!piece_.unfold(first, last) || !values_.have_area) return false;
    const auto is_on_side = [this](Sign side) {
      return [this, side](const Plane_vector<Long_ball>& v) {
        return has_sign(cross(piece_.begin.direction, v - piece_.start), side);
      };
    };
    return std::ranges::all_of(piece_.right, is_on_side(NEGATIVE)) &&
           std::ranges::all_of(piece_.left, is_on_side(POSITIVE));
  }

  void add_length() {
    const Plane_vector<Long_ball>& line = piece_.begin.direction;
    const Long_ball length = sqrt(dot(line, line) * values_(piece_.begin.face.face).first[0]);
    const double l = length.to_double(),
                 error = static_cast<double>(length.radius()) * (1 + 0x1p-40) + l * 0x1p-51;
    const double unit = std::ldexp(1.0, -input_.scale_exponent());
    length_ += Interval_nt<>(unit * std::max(0.0, l - error), unit * (l + error));
  }

  // Whether all ways around a vertex, between the pieces before and after it, are at least pi.
  bool turns_by_pi(std::size_t before, std::size_t at, std::size_t after,
                   const Rays<Long_ball>& rays) {
    if (rays[0].face.face == rays[1].face.face) return false;
    const auto rays_in_field = [&](Field_values& values) {
      Path_unfolder<Multiquadratic_number, Field_values> piece(input_, path_, values);
      Rays<Multiquadratic_number> result;
      piece.unfold(before, at);
      result[0] = piece.end;
      piece.unfold(at, after);
      result[1] = piece.begin;
      return result;
    };
    try {
      return Vertex_on_path(input_, *row_at(path_.points[at]), rays, values_)
          .turns_by_pi(rays_in_field);
    } catch (const std::length_error&) {
      return false;
    }
  }

  const Input& input_;
  const Traced_curve& path_;
  Mpfr_precision precision_;
  Long_values values_;
  Path_unfolder<Long_ball, Long_values> piece_;
  std::string obstacle_;
  Interval_nt<> length_{0};
};

} // namespace

} // namespace internal

Certificate_on_faces certify_on_faces(const Input& input, const Traced_curve& path) {
  return internal::Path_on_faces_prover(input, path).run();
}

} // namespace CGAL::Intrinsic_triangulations
