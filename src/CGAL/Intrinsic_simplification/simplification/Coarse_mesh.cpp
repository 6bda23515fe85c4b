// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The first vertices' sides: on the border the one with the border on its right.
std::vector<std::uint32_t> outgoing_sides(const Gluing& g) {
  std::vector<std::uint32_t> result(g.number_of_vertices, Gluing::none);
  for (std::uint32_t h = 0; h < g.origin.size(); ++h) {
    std::uint32_t& first = result[g.origin[h]];
    if (first == Gluing::none || g.glue[h] == Gluing::none) first = h;
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

// Multiples of a form that are proven to bound another one, whose values are nearly the same.
Face_forms forms_about(const Side_values& near, const std::array<Interval, 3>& exact) {
  const auto grown = [&](double by) {
    return Side_values{near[0] * by, near[1] * by, near[2] * by};
  };
  double margin = 0x1p-51;
  while (margin < 1 && !is_proven_above(grown(1 + margin), exact)) margin *= 2;
  const Side_values above =
      grown(margin < 1 ? 1 + margin : std::numeric_limits<double>::infinity());
  margin = 0x1p-51;
  while (margin < 1 && !is_proven_below(grown(1 / (1 + margin)), exact)) margin *= 2;
  return {above, grown(margin < 1 ? 1 / (1 + margin) : 0)};
}

// Values that begin at a side of a face, from those that begin at its first side; and back.
Face_forms from_side(const Face_forms& forms, std::uint32_t h) {
  Face_forms result;
  for (std::uint32_t k = 0; k < 3; ++k) {
    result.above[k] = forms.above[(h + k) % 3];
    result.below[k] = forms.below[(h + k) % 3];
  }
  return result;
}
Face_forms to_side(const Face_forms& forms, std::uint32_t h) { return from_side(forms, 3 - h % 3); }

// The forms of two faces that are flipped, in those that replace them; nothing if that fails.
std::optional<std::array<Face_forms, 2>> flipped_forms(const Plane_diamond& d,
                                                       const std::array<Face_forms, 2>& old) {
  const Protect_FPU_rounding<true> up;
  const Form_of_sides left(d.left()), right(d.right());
  const Enclosed_form f = left(old[0].above), g = right(old[1].above), f_below = left(old[0].below),
                      g_below = right(old[1].below);
  const std::array<const Enclosed_form*, 2> above{&f, &g}, below{&f_below, &g_below};
  const Form upper = join(middle_of(f), middle_of(g)),
             lower = meet(middle_of(f_below), middle_of(g_below));
  const std::array<Measured_triangle, 2> faces{Measured_triangle(d.new_left()),
                                               Measured_triangle(d.new_right())};
  std::array<Face_forms, 2> result;
  for (const std::size_t k : {0U, 1U}) {
    const std::optional<Proven_form> proven = proven_above(upper, faces[k], above);
    if (!proven) return std::nullopt;
    result[k] = {proven->values, proven_below(lower, faces[k], below).values};
  }
  return result;
}

} // namespace

bool is_proven_triangle(const Side_values& l) {
  const auto [x, y, z] = l;
  if (!(x > 0 && y > 0 && z > 0)) return false;
  // the error of the area is below 2^-100 of the product of the shorter sides
  const double shorter = std::min({x * y, y * z, z * x});
  return shorter >= std::numeric_limits<double>::min() * 0x1p90 &&
         squared_quadruple_area(x, y, z) > 0x1p-90 * shorter;
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

Exact_point place_in(const Plane_triangle& p, const std::array<double, 3>& weights,
                     std::uint32_t h) {
  Exact_point result;
  for (std::uint32_t k = 0; k < 3; ++k) {
    result.x += weights[(h + k) % 3] * p[k].x;
    result.y += weights[(h + k) % 3] * p[k].y;
  }
  return result;
}

// Faces breadth-first, and vertices in the order in which faces meet them.
Near_order::Near_order(const Gluing& g)
    : vertex(g.number_of_vertices, Gluing::none), face(g.number_of_faces(), Gluing::none) {
  std::vector<std::uint32_t> found;
  found.reserve(face.size());
  const auto visit = [&](std::uint32_t f) {
    if (face[f] != Gluing::none) return;
    face[f] = static_cast<std::uint32_t>(found.size());
    found.push_back(f);
  };
  std::uint32_t met = 0;
  const auto meet = [&](std::uint32_t v) {
    if (vertex[v] == Gluing::none) vertex[v] = met++;
  };
  for (std::uint32_t f = 0, next = 0; f < face.size(); ++f)
    for (visit(f); next < found.size(); ++next)
      for (std::uint32_t h = 3 * found[next]; h < 3 * found[next] + 3; ++h) {
        meet(g.origin[h]);
        if (g.glue[h] != Gluing::none) visit(g.glue[h] / 3);
      }
  for (std::uint32_t v = 0; v < vertex.size(); ++v) meet(v); // isolated ones
}

Coarse_mesh::Coarse_mesh(const Fine_surface& fine)
    : order_(fine.gluing), number_(order_.vertex.size()), faces_(order_.face.size()),
      forms_(faces_.size()), outgoing_(number_.size()), points_(number_.size()) {
  const std::vector<std::uint32_t> outgoing = outgoing_sides(fine.gluing);
  for (std::uint32_t v = 0; v < number_.size(); ++v) {
    number_[order_.vertex[v]] = v;
    outgoing_[order_.vertex[v]] = side(outgoing[v]);
  }
  for (std::uint32_t h = 0; h < fine.gluing.origin.size(); ++h) {
    Coarse_face& f = faces_[order_.face[h / 3]];
    f.glue[h % 3] = side(fine.gluing.glue[h]);
    f.origin[h % 3] = order_.vertex[fine.gluing.origin[h]];
    f.length[h % 3] = fine.squared_length[h];
  }
  start_forms(fine);
}

// Forms that are proven to bound the lengths that doubles have rounded.
void Coarse_mesh::start_forms(const Fine_surface& fine) {
  const Protect_FPU_rounding<true> up;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const Side_values& l = faces_[order_.face[f]].length;
    Face_forms& forms = forms_[order_.face[f]];
    forms = {l, l};
    std::array<Interval, 3> exact;
    bool is_exact = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double e = fine.error.empty() ? 0 : fine.error[3 * f + k];
      exact[k] = Interval(l[k]) + Interval(-e, e);
      is_exact = is_exact && e == 0;
    }
    if (!is_exact) forms = forms_about(l, exact);
  }
}

double Coarse_mesh::quadruple_area(std::uint32_t f) const {
  const Side_values& l = faces_[f].length;
  return quadruple_area_of(l[0], l[1], l[2]);
}

double Coarse_mesh::corner_angle(std::uint32_t h) const {
  return std::atan2(quadruple_area(h / 3), length(h) + length(previous(h)) - length(next(h)));
}

void Coarse_mesh::begin() {
  ++step_;
  turned_sides_.clear();
  changed_.clear();
  changed_faces_.clear();
  changed_forms_.clear();
  changed_outgoing_.clear();
  changed_points_.clear();
}

void Coarse_mesh::take_back() {
  const auto put_back = [](const auto& changes, auto& values) { // the last change first
    for (auto c = changes.rbegin(); c != changes.rend(); ++c) values[c->first] = c->second;
  };
  put_back(changed_faces_, faces_);
  put_back(changed_forms_, forms_);
  put_back(changed_outgoing_, outgoing_);
  put_back(changed_points_, points_);
  begin();
}

void Coarse_mesh::list_changed(std::vector<std::uint32_t>& faces) {
  faces.clear();
  for (const std::uint32_t f : changed_)
    if (!std::exchange(faces_[f].is_listed, true)) faces.push_back(f);
  for (const std::uint32_t f : faces) faces_[f].is_listed = false;
}

void Coarse_mesh::take_points(std::uint32_t f, std::vector<std::uint32_t>& points) {
  for (std::uint32_t p = faces_[f].first_point; p != Gluing::none; p = points_[p].next)
    points.push_back(p);
  faces_[f].first_point = Gluing::none;
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
  if (p >= 0 && q >= 0) return false; // most edges are opposite two acute angles
  const double a = quadruple_area(h / 3), b = quadruple_area(g / 3);
  return p * b + q * a < -1e-12 * (std::abs(p) * b + std::abs(q) * a + a * b);
}

bool Coarse_mesh::flip(std::uint32_t h) {
  const std::uint32_t g = glued(h);
  const Plane_diamond d = lay_out(length(h), *this, h, g);
  if (!(d.k.y > 0 && d.m.y < 0 && is_proven_left_turn(d.m, d.k, d.i) &&
        is_proven_left_turn(d.k, d.m, d.j)))
    return false;
  const double km = squared_distance(d.k, d.m);
  if (!is_proven_triangle({km, length(previous(h)), length(next(g))}) ||
      !is_proven_triangle({km, length(previous(g)), length(next(h))}))
    return false;
  const std::array<Face_forms, 2> old{from_side(forms_[h / 3], h), from_side(forms_[g / 3], g)};
  const std::optional<std::array<Face_forms, 2>> now = flipped_forms(d, old);
  if (!now) return false;
  change(h / 3);
  change(g / 3);
  moving_.clear();
  take_points(h / 3, moving_);
  const std::size_t left = moving_.size();
  take_points(g / 3, moving_);
  rewire(h, km);
  for (std::size_t n = 0; n < moving_.size(); ++n) {
    const auto& w = points_[moving_[n]].weights;
    const Exact_point p = n < left ? place_in(d.left(), w, h) : place_in(d.right(), w, g);
    const bool is_left = (d.k.x - d.m.x) * (p.y - d.m.y) >= (d.k.y - d.m.y) * (p.x - d.m.x);
    const std::array<double, 3> u = weights_in(is_left ? d.new_left() : d.new_right(), p);
    std::array<double, 3> weights;
    for (std::uint32_t k = 0; k < 3; ++k) weights[((is_left ? h : g) + k) % 3] = u[k];
    put_point(moving_[n], (is_left ? h : g) / 3, weights);
  }
  change_forms(h / 3) = to_side((*now)[0], h);
  change_forms(g / 3) = to_side((*now)[1], g);
  return true;
}

// With h from i to j, k on its left and m on its right: h runs from m to k afterwards, and faces
// are m k i and k m j.
void Coarse_mesh::rewire(std::uint32_t h, double km) {
  const std::uint32_t g = glued(h), jk = next(h), ki = previous(h), im = next(g), mj = previous(g);
  const std::uint32_t i = origin(h), j = origin(g), k = origin(ki), m = origin(mj);
  const std::array<std::pair<std::uint32_t, std::uint32_t>, 4> first{
      {{i, outgoing_[i]}, {j, outgoing_[j]}, {k, outgoing_[k]}, {m, outgoing_[m]}}};
  if (tracks_turns_ && outgoing_[i] == h) add_turn(i, -corner_angle(im));
  if (tracks_turns_ && outgoing_[j] == g) add_turn(j, -corner_angle(jk));
  // each of the outer sides moves to the place of another one
  const std::array<std::uint32_t, 4> was{ki, im, mj, jk}, is{jk, ki, im, mj};
  const auto moved = [&](std::uint32_t s) {
    const auto at = std::ranges::find(was, s);
    return at == was.end() ? s : is[static_cast<std::size_t>(at - was.begin())];
  };
  struct Outer {
    std::uint32_t glued;
    double length;
    bool is_kept;
  };
  std::array<Outer, 4> outer;
  std::ranges::transform(was, outer.begin(), [this](std::uint32_t s) {
    return Outer{glued(s), length(s), is_kept_side(s)};
  });
  const auto put = [&](std::uint32_t s, std::uint32_t v) { faces_[s / 3].origin[s % 3] = v; };
  put(h, m), put(jk, k), put(ki, i);
  put(g, k), put(im, m), put(mj, j);
  faces_[h / 3].kept_sides = faces_[g / 3].kept_sides = 0;
  set_length(h, km);
  set_length(g, km);
  for (std::size_t n = 0; n < 4; ++n) {
    set_length(is[n], outer[n].length);
    if (outer[n].is_kept) keep_side(is[n]);
    const std::uint32_t o = moved(outer[n].glued);
    if (o != Gluing::none && o / 3 != h / 3 && o / 3 != g / 3) change_neighbour(o / 3);
    glue(is[n], o);
  }
  for (const auto& [v, old] : first)
    if (old / 3 == h / 3 || old / 3 == g / 3)
      set_outgoing(v, old == h ? ki : old == g ? mj : moved(old));
}

} // namespace CGAL::Intrinsic_triangulations::internal
