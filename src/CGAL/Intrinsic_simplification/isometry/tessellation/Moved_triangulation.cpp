// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Moved_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Repartition.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Moved_triangulation::Moved_triangulation(const Corresponding_triangulation& t)
    : numbered_(t.mesh()), recipes_(t), developed_(recipes_), short_(developed_) {
  for (std::uint32_t e = 0; e < t.mesh().number_of_edges(); ++e)
    length_.push_back(recipes_.length_of_edge(e));
  for (std::uint32_t f = 0; f < t.mesh().number_of_faces(); ++f)
    area_.push_back(recipes_.area_of_face(f));
  start_field();
}

void Moved_triangulation::start_field() const {
  exact_ = nullptr; // its numbers refer to the field
  field_ = std::make_unique<Square_root_field>();
  exact_ = std::make_unique<Developed_faces::Evaluation<Square_root_field::Number>>(developed_,
                                                                                    field_.get());
}

namespace {

// For each face, whether one of its corners is flat.
std::vector<char> faces_at_flat_vertices(const std::vector<char>& is_flat, const Gluing_map& mesh) {
  std::vector<char> result(mesh.number_of_faces(), 0);
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h) {
    const Gluing_map::Halfedge side{h};
    if (mesh.face(side).index != Gluing::none && is_flat[mesh.target(side).index] != 0)
      result[mesh.face(side).index] = 1;
  }
  return result;
}

} // namespace

void Moved_triangulation::lay_out_planes(const std::vector<char>& is_flat) {
  std::unordered_set<Gmpq, Hash_of_rational> lengths; // each once
  std::vector<std::optional<const Gmpq*>> known(mesh().number_of_edges());
  const auto find = [&](std::uint32_t edge) -> std::optional<Gmpq> {
    if (recipes_.is_along_input(edge)) {
      const Face_side s = recipes_.input_side_of(edge);
      return recipes_.metric().squared_length<Gmpq>(s.face, s.slot);
    }
    const auto value = [&] { return (*exact_)(recipes_.length_of_edge(edge)); };
    auto x = in_field(few_words, value);
    if (!x) { // in a field without the roots of other planes
      start_field();
      x = in_field(few_words, value);
    }
    return x && x->is_rational() ? std::optional(x->coefficient(0)) : std::nullopt;
  };
  const auto squared_length = [&](std::uint32_t edge) {
    if (!known[edge]) {
      const std::optional<Gmpq> x = find(edge);
      known[edge] = x ? &*lengths.insert(*x).first : nullptr;
    }
    return *known[edge];
  };
  developed_.set_charts(Plane_charts(mesh(), developed_.first_sides(),
                                     faces_at_flat_vertices(is_flat, mesh()), squared_length),
                        is_flat);
  start_field(); // without roots of edges that are not needed
  short_ = Developed_faces::Evaluation<Short_ball>(developed_);
  long_.clear();
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

Moved_triangulation::Moved_diamond Moved_triangulation::diamond(Halfedge h) const {
  const Gluing_map& m = mesh();
  const Halfedge o = Gluing_map::opposite(h), jk = m.next(h), ki = m.next(jk), im = m.next(o),
                 mj = m.next(im);
  Moved_diamond result{{length_[h.index / 2], length_[jk.index / 2], length_[ki.index / 2],
                        length_[im.index / 2], length_[mj.index / 2], area_[m.face(h).index],
                        area_[m.face(o).index]},
                       is_in_one_frame(h) ? developed_.grid(developed_.frame(h)) : nullptr,
                       {}};
  if (result.grid == nullptr) return result;
  const std::array<Halfedge, 4> corners{h, jk, ki, mj};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::optional<Grid_point> p = developed_.grid_point(developed_.source(corners[k]));
    if (!p) {
      result.grid = nullptr;
      break;
    }
    result.corners[k] = *p;
  }
  return result;
}

Diamond_values<double> Moved_triangulation::approximate(Halfedge h) const {
  const Moved_diamond d = diamond(h);
  if (d.grid != nullptr) {
    const std::uint32_t frame = developed_.frame(h);
    if (const auto v = d.grid->approximate(d.corners, approximate(developed_.unit(frame)),
                                           approximate(recipes_.area_of_face(frame))))
      return *v;
  }
  const auto at = [&](std::size_t k) { return approximate(d.ids[k]); };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6)};
}

Plane_face Moved_triangulation::lay_out(Halfedge h) const {
  const Gluing_map& m = mesh();
  const Halfedge n = m.next(h), l = m.next(n);
  const auto squared = [&](Halfedge x) { return approximate(length_[x.index / 2]); };
  const double ij = squared(h), side = std::sqrt(ij), area = approximate(area_[m.face(h).index]);
  const Plane_vector<double> apex{(ij + squared(l) - squared(n)) / (2 * side), area / (2 * side)};
  return {m.face(h).index, {h.index, n.index, l.index}, {{{0, 0}, {side, 0}, apex}}};
}

Plane_vector<double> Moved_triangulation::approximate_vector(Developed_faces::Point from,
                                                             Developed_faces::Point to) const {
  const auto difference = [&](auto& values) {
    const auto v = values.point(to) - values.point(from);
    const bool is_narrow = v.x.radius() <= 0x1p-60 * (1 + std::abs(v.x.to_double())) &&
                           v.y.radius() <= 0x1p-60 * (1 + std::abs(v.y.to_double()));
    return std::pair(Plane_vector<double>{v.x.to_double(), v.y.to_double()}, is_narrow);
  };
  auto [v, is_narrow] = difference(short_);
  for (const unsigned bits : {256U, 1024U}) {
    if (is_narrow) break;
    const Mpfr_precision precision(bits);
    std::tie(v, is_narrow) = difference(long_values(bits));
  }
  return v;
}

bool Moved_triangulation::has_area(const std::array<Developed_faces::Point, 3>& corners) const {
  const auto is_proven = [&](auto& values) {
    const auto origin = values.point(corners[0]);
    const Uncertain<Sign> s =
        cross(values.point(corners[1]) - origin, values.point(corners[2]) - origin).sign();
    return is_certain(s) && get_certain(s) != ZERO;
  };
  if (is_proven(short_)) return true;
  const Mpfr_precision precision(1024);
  return is_proven(long_values(1024));
}

Moved_face Moved_triangulation::face_at(Halfedge h) const {
  const Halfedge n = mesh().next(h), l = mesh().next(n);
  return {mesh().face(h).index,
          {h.index, n.index, l.index},
          {developed_.source(h), developed_.source(n), developed_.source(l)}};
}

std::vector<Plane_face> Moved_triangulation::lay_out(const Repartition& move,
                                                     const Repartition::Faces& faces) const {
  const Developed_faces::Point origin = move.before.front().corners.front();
  std::vector<Plane_face> result;
  for (const Moved_face& f : faces) {
    const auto corner = [&](std::size_t k) { return approximate_vector(origin, f.corners[k]); };
    result.push_back({f.face, f.sides, {{corner(0), corner(1), corner(2)}}, has_area(f.corners)});
  }
  return result;
}

void Moved_triangulation::name_areas(std::initializer_list<Halfedge> faces) {
  for (const Halfedge h : faces) {
    developed_.choose_frame(mesh(), h);
    area_[mesh().face(h).index] = developed_.name_area(mesh(), h);
  }
}

void Moved_triangulation::flip(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge o = Gluing_map::opposite(h);
  developed_.bring_across(m, h);
  Repartition move{{face_at(h), face_at(o)}, {}};
  developed_.flip(m, h);
  CGAL::Euler::flip_edge(h, m);
  move.after = {face_at(h), face_at(o)};
  moves_.push_back(move);
  name_areas({h, o});
  length_[h.index / 2] = developed_.name_length(m, h);
}

void Moved_triangulation::remove_inner_vertex(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge jp = m.next(h), pi = m.next(jp);
  for (const Halfedge x : {jp, pi}) developed_.bring_across(m, x);
  Repartition move{{face_at(h), face_at(m.next(Gluing_map::opposite(jp))),
                    face_at(m.next(m.next(Gluing_map::opposite(pi))))},
                   {}};
  remove_degree_3_vertex(h, m, numbered_.numbers);
  move.after = {face_at(h)};
  moves_.push_back(move);
  name_areas({h});
}

void Moved_triangulation::remove_border_vertex(Halfedge h) {
  Gluing_map& m = numbered_.mesh;
  const Halfedge pk = m.next(h), kp = Gluing_map::opposite(pk);
  developed_.bring_across(m, pk);
  Repartition move{{face_at(pk), face_at(kp)}, {}};
  Intrinsic_triangulations::remove_border_vertex(h, m, numbered_.numbers);
  move.after = {face_at(h)};
  moves_.push_back(move);
  name_areas({h});
  length_[h.index / 2] = developed_.name_length(m, h);
}

} // namespace CGAL::Intrinsic_triangulations::internal
