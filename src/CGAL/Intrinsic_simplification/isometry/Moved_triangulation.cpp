// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Moved_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Repartition.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Moved_triangulation::Moved_triangulation(const Corresponding_triangulation& t)
    : numbered_(t.mesh()), recipes_(t), developed_(recipes_), short_(recipes_) {
  for (std::uint32_t e = 0; e < t.mesh().number_of_edges(); ++e)
    length_.push_back(recipes_.length_of_edge(e));
  for (std::uint32_t f = 0; f < t.mesh().number_of_faces(); ++f)
    area_.push_back(recipes_.area_of_face(f));
  start_field();
}

void Moved_triangulation::start_field() const {
  exact_ = nullptr; // its numbers refer to the field
  field_ = std::make_unique<Square_root_field>();
  exact_ = std::make_unique<Developed_faces::Evaluation>(developed_, field_.get());
}

Short_ball Moved_triangulation::narrow_enclosure(Id id) const {
  constexpr double narrow = 0x1p-90;
  const auto is_narrow = [](const auto& x) {
    return x.radius() <= narrow * std::abs(x.center().magnitude());
  };
  const Short_ball& quick = short_(id);
  if (is_narrow(quick)) return quick;
  for (const unsigned bits : {256U, 1024U, Mpfr_number::most_bits}) {
    const Mpfr_precision precision(bits);
    const Long_ball& x = long_values(bits)(id);
    if (!is_narrow(x)) continue;
    const double high = x.center().to_double();
    const double low = (x.center() - Mpfr_number(high)).to_double();
    const Double_double center = Double_double(high) + Double_double(low);
    return Short_ball::around(center, std::abs(high) * 2 * narrow);
  }
  return quick;
}

double Moved_triangulation::nearest(Id id) const {
  if (const auto quick = nearest_double(narrow_enclosure(id))) return *quick;
  // a rational number may be in the middle between two doubles, to which no
  // enclosure is narrow
  if (const auto x = in_field(most_words, [&] { return (*exact_)(id); }); x && x->is_rational()) {
    const Mpfr_precision precision(53);
    return Mpfr_number::nearest(x->coefficient(0)).to_double();
  }
  for (const unsigned bits : {256U, 1024U, Mpfr_number::most_bits}) {
    const Mpfr_precision precision(bits);
    if (const auto result = nearest_double(long_values(bits)(id))) return *result;
  }
  throw Undecidable("enclosures of a length stay too wide");
}

Value_recipes::Diamond_ids Moved_triangulation::diamond(Halfedge h) const {
  const Gluing_map& m = mesh();
  const Halfedge o = Gluing_map::opposite(h), jk = m.next(h), im = m.next(o);
  return {length_[h.index / 2],  length_[jk.index / 2],         length_[m.next(jk).index / 2],
          length_[im.index / 2], length_[m.next(im).index / 2], area_[m.face(h).index],
          area_[m.face(o).index]};
}

Diamond_values<double> Moved_triangulation::approximate(Halfedge h) const {
  const Diamond_ids d = diamond(h);
  const auto at = [&](std::size_t k) { return approximate(d[k]); };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6)};
}

Moved_face Moved_triangulation::lay_out(Halfedge h) const {
  const Gluing_map& m = mesh();
  const Halfedge n = m.next(h), l = m.next(n);
  const auto squared = [&](Halfedge x) { return approximate(length_[x.index / 2]); };
  const double ij = squared(h), side = std::sqrt(ij), area = approximate(area_[m.face(h).index]);
  const Plane_vector<double> apex{(ij + squared(l) - squared(n)) / (2 * side), area / (2 * side)};
  return {m.face(h).index, {h.index, n.index, l.index}, {{{0, 0}, {side, 0}, apex}}};
}

namespace {

// the face on the other side of the first side of a face, in the same plane
Moved_face turned_over(Moved_face g, const Moved_face& f) {
  for (Plane_vector<double>& p : g.corners) p = f.corners[1] - p;
  return g;
}

} // namespace

void Moved_triangulation::flip(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge o = Gluing_map::opposite(h), jk = m.next(h), ki = m.next(jk), im = m.next(o),
                 mj = m.next(im);
  const Moved_face f = lay_out(h), g = turned_over(lay_out(o), f);
  const auto &i = f.corners[0], &j = f.corners[1], &k = f.corners[2], &apex = g.corners[2];
  const auto [km, left, right] = recipes_.flip(diamond(h));
  const Moved_face new_f{f.face, {h.index, mj.index, jk.index}, {{k, apex, j}}},
      new_g{g.face, {o.index, ki.index, im.index}, {{apex, k, i}}};
  moves_.push_back(Repartition{{f, g}, {new_f, new_g}});
  developed_.bring_across(m, h);
  developed_.close(h, mj, jk, km, left);
  developed_.close(o, ki, im, km, right);
  developed_.join(h);
  length_[h.index / 2] = km;
  area_[f.face] = left;
  area_[g.face] = right;
  CGAL::Euler::flip_edge(h, m);
}

void Moved_triangulation::remove_inner_vertex(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge jp = m.next(h), jk = m.next(Gluing_map::opposite(jp)), kp = m.next(jk),
                 pj = m.next(kp), ki = m.next(Gluing_map::opposite(kp)), ip = m.next(ki),
                 pk = m.next(ip);
  const std::uint32_t f = m.face(h).index, g = m.face(jk).index, e = m.face(ki).index;
  const Moved_face first = lay_out(h);
  area_[f] = recipes_.sum_of_areas(area_[f], area_[g], area_[e]);
  const auto squared = [&](Halfedge x) { return approximate(length_[x.index / 2]); };
  const auto &i = first.corners[0], &j = first.corners[1], &p = first.corners[2];
  const double ij = squared(h), area = approximate(area_[f]);
  const Plane_vector<double> k{(ij + squared(ki) - squared(jk)) / (2 * j.x), area / (2 * j.x)};
  const Moved_face second{g, {jk.index, kp.index, pj.index}, {{j, k, p}}},
      third{e, {ki.index, ip.index, pk.index}, {{k, i, p}}},
      whole{f, {h.index, jk.index, ki.index}, {{i, j, k}}};
  moves_.push_back(Repartition{{first, second, third}, {whole}});
  developed_.bring_across(m, jp);
  developed_.bring_across(m, m.next(jp));
  developed_.set_area(area_[f], h, jk);
  remove_degree_3_vertex(h, m, numbered_.numbers);
}

void Moved_triangulation::remove_border_vertex(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge pk = m.next(h), kp = Gluing_map::opposite(pk), ki = m.next(pk), pj = m.next(kp),
                 jk = m.next(pj);
  const Moved_face f = lay_out(pk), g = turned_over(lay_out(kp), f);
  const auto &k = f.corners[1], &i = f.corners[2], &j = g.corners[2];
  const auto [length, area] = recipes_.straighten(diamond(pk));
  const Moved_face whole{f.face, {h.index, jk.index, ki.index}, {{i, j, k}}};
  moves_.push_back(Repartition{{f, g}, {whole}});
  developed_.bring_across(m, pk);
  developed_.close(h, jk, ki, length, area);
  length_[h.index / 2] = length;
  area_[f.face] = area;
  Intrinsic_triangulations::remove_border_vertex(h, m, numbered_.numbers);
}

} // namespace CGAL::Intrinsic_triangulations::internal
