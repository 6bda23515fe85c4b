// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr std::uint32_t none = Gluing::none;

// The first vertices' sides: on the border the one with the border on its right.
std::vector<std::uint32_t> outgoing_sides(const Gluing& g) {
  std::vector<std::uint32_t> result(g.number_of_vertices, none);
  for (std::uint32_t h = 0; h < g.origin.size(); ++h) {
    std::uint32_t& first = result[g.origin[h]];
    if (first == none || g.glue[h] == none) first = h;
  }
  return result;
}

// The faces at an edge in the plane: the edge runs from `i` at the origin to `j` on the axis, with
// `k` on its left and `m` on its right.
struct Plane_diamond {
  Exact_point i, j, k, m;
  Plane_triangle left() const { return {i, j, k}; }
  Plane_triangle right() const { return {j, i, m}; }
  // what a flip makes of them, in the order of `Coarse_mesh::rewire()`
  Plane_triangle new_left() const { return {m, k, i}; }
  Plane_triangle new_right() const { return {k, m, j}; }
};

Plane_diamond lay_out(double ij, const Coarse_mesh& mesh, std::uint32_t h, std::uint32_t g) {
  const double l = std::sqrt(ij);
  const auto apex = [&](std::uint32_t side, double from, double to) {
    return Exact_point{(ij + from - to) / (2 * l), mesh.quadruple_area(side / 3) / (2 * l)};
  };
  const auto length = [&](std::uint32_t s) { return mesh.length(s); };
  const Exact_point k = apex(h, length(mesh.previous(h)), length(mesh.next(h)));
  const Exact_point m = apex(g, length(mesh.next(g)), length(mesh.previous(g)));
  return {{0, 0}, {l, 0}, k, {m.x, -m.y}};
}

double squared_distance(const Exact_point& p, const Exact_point& q) {
  const double x = p.x - q.x, y = p.y - q.y;
  return x * x + y * y;
}

// The forms of two faces that are flipped, in those that replace them; nothing if that fails.
struct Flipped_forms {
  std::array<Side_values, 2> above, below;
};
std::optional<Flipped_forms> flipped_forms(const Plane_diamond& d,
                                           const std::array<std::array<Side_values, 2>, 2>& q) {
  const Protect_FPU_rounding<true> up;
  const Form_of_sides<Interval> left(d.left()), right(d.right());
  const std::array<Plane_triangle, 2> faces{d.new_left(), d.new_right()};
  Flipped_forms result;
  for (const std::size_t b : {0, 1}) {
    const Enclosed_form f = left(q[0][b]), g = right(q[1][b]);
    const std::array<const Enclosed_form*, 2> both{&f, &g};
    const Form near =
        b == 0 ? join(middle_of(f), middle_of(g)) : meet(middle_of(f), middle_of(g));
    for (const std::size_t k : {0, 1})
      if (b == 1)
        result.below[k] = proven_below(near, faces[k], both);
      else if (const auto above = proven_above(near, faces[k], both))
        result.above[k] = *above;
      else
        return std::nullopt;
  }
  return result;
}

} // namespace

double quadruple_area_of(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (a < c) std::swap(a, c);
  const double p = b + c - a; // `a` is the longest
  const double s = 4 * b * c - p * p;
  return s > 0 ? std::sqrt(s) : 0;
}

bool is_proven_triangle(const Side_values& l) {
  const auto [x, y, z] = l;
  if (!(x > 0 && y > 0 && z > 0)) return false;
  const double longest = std::max({x, y, z});
  // the error of the area is below 2^-100 of the product of the shorter sides
  return squared_quadruple_area(x, y, z) > 0x1p-90 * (x * y * z / longest);
}

bool is_proven_left_turn(const Exact_point& p, const Exact_point& q, const Exact_point& r) {
  const double a = (q.x - p.x) * (r.y - p.y), b = (q.y - p.y) * (r.x - p.x);
  return a - b > 0x1p-49 * (std::abs(a) + std::abs(b)); // above five roundings
}

double spread_of(const Side_values& length, const Face_forms& forms) {
  const double upper = factors(length, forms.below)[1], lower = factors(length, forms.above)[0];
  return lower > 0 ? std::log(upper / lower) / 2 : std::numeric_limits<double>::infinity();
}

std::array<double, 3> weights_in(const Plane_triangle& p, const Exact_point& q) {
  const auto area = [](const Exact_point& a, const Exact_point& b, const Exact_point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double x = area(q, p[1], p[2]), y = area(q, p[2], p[0]), z = area(q, p[0], p[1]);
  const double sum = x + y + z;
  return {x / sum, y / sum, z / sum};
}

Coarse_mesh::Coarse_mesh(const Fine_surface& fine)
    : faces_(fine.gluing.number_of_faces()), forms_(faces_.size()), outgoing_(outgoing_sides(fine.gluing)),
      points_(fine.gluing.number_of_vertices) {
  for (std::uint32_t h = 0; h < fine.gluing.origin.size(); ++h) {
    Coarse_face& f = faces_[h / 3];
    f.glue[h % 3] = fine.gluing.glue[h];
    f.origin[h % 3] = fine.gluing.origin[h];
    f.length[h % 3] = fine.squared_length[h];
  }
  start_forms(fine);
}

// Forms that are proven to bound the lengths that doubles have rounded.
void Coarse_mesh::start_forms(const Fine_surface& fine) {
  const Protect_FPU_rounding<true> up;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const Coarse_face& face = faces_[f];
    Face_forms& forms = forms_[f];
    forms.above = forms.below = face.length;
    std::array<Interval, 3> exact;
    bool is_exact = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double e = fine.error.empty() ? 0 : fine.error[3 * f + k], l = face.length[k];
      exact[k] = Interval(l) + Interval(-e, e);
      is_exact = is_exact && e == 0;
    }
    if (is_exact) continue;
    const auto grown = [](const Side_values& q, double by) {
      return Side_values{q[0] * by, q[1] * by, q[2] * by};
    };
    double margin = 0x1p-51;
    while (margin < 1 && !is_proven_above(face.length, Interval(1 + margin), exact))
      margin *= 2;
    forms.above = grown(face.length, margin < 1 ? 1 + 2 * margin
                                               : std::numeric_limits<double>::infinity());
    // x above l / (1 + margin) everywhere if (1 + margin) x - l is not negative
    const auto is_below = [&](double by) {
      const Interval c = Interval(1) / Interval(by);
      std::array<Interval, 3> d;
      for (std::size_t k = 0; k < 3; ++k) d[k] = exact[k] - c * Interval(face.length[k]);
      return d[0].inf() >= 0 && d[2].inf() >= 0 &&
             (Interval(4) * d[0] * d[2] - square(d[0] + d[2] - d[1])).inf() >= 0;
    };
    for (margin = 0x1p-51; margin < 1 && !is_below(1 + margin);) margin *= 2;
    forms.below = grown(face.length, margin < 1 ? 1 / (1 + 2 * margin) : 0);
  }
}

double Coarse_mesh::quadruple_area(std::uint32_t f) const {
  const Side_values& l = faces_[f].length;
  return quadruple_area_of(l[0], l[1], l[2]);
}

void Coarse_mesh::begin() {
  changed_faces_.clear();
  changed_forms_.clear();
  changed_outgoing_.clear();
  changed_points_.clear();
}

void Coarse_mesh::take_back() {
  for (const auto& [f, face] : std::views::reverse(changed_faces_)) faces_[f] = face;
  for (const auto& [f, forms] : std::views::reverse(changed_forms_)) forms_[f] = forms;
  for (const auto& [v, h] : std::views::reverse(changed_outgoing_)) outgoing_[v] = h;
  for (const auto& [v, point] : std::views::reverse(changed_points_)) points_[v] = point;
  begin();
}

void Coarse_mesh::take_points(std::uint32_t f, std::vector<std::uint32_t>& points) {
  for (std::uint32_t p = faces_[f].first_point; p != none; p = points_[p].next)
    points.push_back(p);
  faces_[f].first_point = none;
}

void Coarse_mesh::put_point(std::uint32_t v, std::uint32_t f,
                            const std::array<double, 3>& weights) {
  changed_points_.emplace_back(v, points_[v]);
  std::array<double, 3> w;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += w[k] = std::max(weights[k], 0.);
  points_[v] = {f, faces_[f].first_point, {w[0] / sum, w[1] / sum, w[2] / sum}};
  faces_[f].first_point = v;
}

bool Coarse_mesh::violates_delaunay(std::uint32_t h) const {
  if (!is_flippable(h)) return false;
  const std::uint32_t g = glued(h);
  const double e = length(h);
  const double p = length(next(h)) + length(previous(h)) - e;
  const double q = length(next(g)) + length(previous(g)) - e;
  const double a = quadruple_area(h / 3), b = quadruple_area(g / 3);
  return p * b + q * a < -1e-12 * (std::abs(p) * b + std::abs(q) * a + a * b);
}

bool Coarse_mesh::flip(std::uint32_t h) {
  const std::uint32_t g = glued(h), f = h / 3, e = g / 3;
  const Plane_diamond d = lay_out(length(h), *this, h, g);
  if (!(d.k.y > 0 && d.m.y < 0 && is_proven_left_turn(d.m, d.k, d.i) &&
        is_proven_left_turn(d.k, d.m, d.j)))
    return false;
  const double km = squared_distance(d.k, d.m);
  if (!is_proven_triangle({km, length(previous(h)), length(next(g))}) ||
      !is_proven_triangle({km, length(previous(g)), length(next(h))}))
    return false;
  const auto rotated = [](const Side_values& q, std::uint32_t k) {
    return Side_values{q[k], q[(k + 1) % 3], q[(k + 2) % 3]};
  };
  const auto flipped =
      flipped_forms(d, {{{rotated(forms_[f].above, h % 3), rotated(forms_[f].below, h % 3)},
                         {rotated(forms_[e].above, g % 3), rotated(forms_[e].below, g % 3)}}});
  if (!flipped) return false;
  change(f);
  change(e);
  change_forms(f);
  change_forms(e);
  // points, by their places in the plane
  moving_.clear();
  take_points(f, moving_);
  const std::size_t left = moving_.size();
  take_points(e, moving_);
  rewire(h, km);
  const std::array<std::uint32_t, 2> side{h, g};
  const std::array<Plane_triangle, 2> old{d.left(), d.right()},
      now{d.new_left(), d.new_right()};
  for (std::size_t n = 0; n < moving_.size(); ++n) {
    const std::size_t from = n < left ? 0 : 1;
    const auto& w = points_[moving_[n]].weights;
    Exact_point p;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double weight = w[(side[from] + k) % 3];
      p.x += weight * old[from][k].x;
      p.y += weight * old[from][k].y;
    }
    const std::size_t to =
        (d.k.x - d.m.x) * (p.y - d.m.y) - (d.k.y - d.m.y) * (p.x - d.m.x) >= 0 ? 0 : 1;
    const std::array<double, 3> u = weights_in(now[to], p);
    std::array<double, 3> weights;
    for (std::uint32_t k = 0; k < 3; ++k) weights[(side[to] + k) % 3] = u[k];
    put_point(moving_[n], side[to] / 3, weights);
  }
  for (const std::size_t n : {0, 1})
    for (std::uint32_t k = 0; k < 3; ++k) {
      Face_forms& forms = forms_[side[n] / 3];
      forms.above[(side[n] + k) % 3] = flipped->above[n][k];
      forms.below[(side[n] + k) % 3] = flipped->below[n][k];
    }
  return true;
}

// With h from i to j, k on its left and m on its right: h runs from m to k afterwards, and faces
// are m k i and k m j.
void Coarse_mesh::rewire(std::uint32_t h, double km) {
  const std::uint32_t g = glued(h), jk = next(h), ki = previous(h), im = next(g), mj = previous(g);
  const std::uint32_t i = origin(h), j = origin(g), k = origin(ki), m = origin(mj);
  std::array<std::pair<std::uint32_t, std::uint32_t>, 4> first; // vertices, their sides
  for (std::size_t n = 0; n < 4; ++n) {
    const std::uint32_t v = std::array{i, j, k, m}[n];
    first[n] = {v, outgoing_[v]};
  }
  struct Outer {
    std::uint32_t glued;
    double length;
    bool is_kept;
  };
  const auto outer = [this](std::uint32_t s) {
    return Outer{glued(s), length(s), is_kept_side(s)};
  };
  const std::array<Outer, 4> before{outer(ki), outer(im), outer(mj), outer(jk)};
  const std::array<std::uint32_t, 4> was{ki, im, mj, jk}, is{jk, ki, im, mj};
  const auto moved = [&](std::uint32_t s) {
    for (std::size_t n = 0; n < 4; ++n)
      if (s == was[n]) return is[n];
    return s;
  };
  Coarse_face& f = faces_[h / 3];
  Coarse_face& e = faces_[g / 3];
  f.origin[h % 3] = m, f.origin[jk % 3] = k, f.origin[ki % 3] = i;
  e.origin[g % 3] = k, e.origin[im % 3] = m, e.origin[mj % 3] = j;
  f.kept_sides = e.kept_sides = 0;
  set_length(h, km);
  set_length(g, km);
  for (std::size_t n = 0; n < 4; ++n) {
    const std::uint32_t s = is[n], o = moved(before[n].glued);
    set_length(s, before[n].length);
    if (before[n].is_kept)
      faces_[s / 3].kept_sides = static_cast<std::uint8_t>(faces_[s / 3].kept_sides | 1U << s % 3);
    if (o != none && o / 3 != h / 3 && o / 3 != g / 3) change(o / 3);
    glue(s, o);
  }
  for (const auto& [v, old] : first)
    if (old / 3 == h / 3 || old / 3 == g / 3)
      set_outgoing(v, old == h ? ki : old == g ? mj : moved(old));
}

} // namespace CGAL::Intrinsic_triangulations::internal
