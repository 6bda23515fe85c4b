// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Frame_maps.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Joined_numbers.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Developed_faces::Developed_faces(const Value_recipes& recipes) : recipes_(recipes) {
  const Gluing_map& mesh = recipes.triangulation().mesh();
  first_side_.resize(mesh.number_of_faces());
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h) {
    face_.push_back(mesh.face(Halfedge{h}).index);
    next_.push_back(mesh.next(Halfedge{h}).index);
    if (face_[h] != Gluing::none) first_side_[face_[h]] = h;
  }
  start();
}

void Developed_faces::set_charts(Plane_charts charts, const std::vector<char>& is_flat) {
  charts_ = std::move(charts);
  start();
  join_creases(is_flat);
  map_at_start_ = map_;
}

void Developed_faces::start() {
  const Gluing_map& mesh = recipes_.triangulation().mesh();
  const std::uint32_t n = number_of_halfedges();
  maps_ = Frame_maps(n, charts_);
  frame_at_start_.resize(first_side_.size());
  for (std::uint32_t f = 0; f < frame_at_start_.size(); ++f)
    frame_at_start_[f] = charts_.chart(f) == Plane_charts::none ? f : charts_.chart(f);
  point_.resize(n);
  std::iota(point_.begin(), point_.end(), Point{0});
  frame_.assign(n, Gluing::none);
  map_.assign(n, Frame_maps::identity);
  std::vector<Point> known;
  const auto first_with = [&known](std::uint32_t number, Point p) {
    if (number >= known.size()) known.resize(number + std::size_t{1}, Gluing::none);
    return known[number] == Gluing::none ? known[number] = p : known[number];
  };
  for (std::uint32_t h = 0; h < n; ++h) {
    if (face_[h] == Gluing::none) continue;
    frame_[h] = frame_at_start_[face_[h]];
    if (charts_.chart(face_[h]) != Plane_charts::none)
      point_[h] = first_with(charts_.number_of_point(h), h);
    const std::uint32_t other = face_[h ^ 1U];
    if (other == Gluing::none) continue;
    if (charts_.chart(face_[h]) == Plane_charts::none || frame_at_start_[other] != frame_[h])
      map_[h] = Frame_maps::across(h);
    else if (const auto motion = charts_.motion_across(mesh, Halfedge{h}))
      map_[h] = maps_.motion(*motion);
  }
  map_at_start_ = map_;
  point_at_start_ = point_;
}

// Around a flat vertex where two frames meet, on a crease, the maps across both edges are the same.
void Developed_faces::join_creases(const std::vector<char>& is_flat) {
  const Gluing_map& mesh = recipes_.triangulation().mesh();
  const auto is_crossed = [this](std::uint32_t h) { return map_[h] == Frame_maps::across(h); };
  Joined_numbers crease(number_of_halfedges());
  for (std::uint32_t v = 0; v < is_flat.size(); ++v) {
    const Halfedge first = mesh.halfedge(Gluing_map::Vertex{v});
    if (is_flat[v] == 0 || first.index == Gluing::none) continue;
    std::vector<std::uint32_t> crossed; // those that start at the vertex
    bool is_inner = true;
    for_each_outgoing(Gluing_map::Vertex{v}, mesh, [&](Halfedge h) {
      is_inner = is_inner && face_[h.index] != Gluing::none;
      if (map_[h.index] != Frame_maps::identity) crossed.push_back(h.index);
    });
    if (!is_inner || crossed.size() != 2 || !is_crossed(crossed[0]) || !is_crossed(crossed[1]))
      continue;
    crease.join(crossed[0], crossed[1] ^ 1U);
    crease.join(crossed[0] ^ 1U, crossed[1]);
  }
  std::vector<std::uint32_t> first(number_of_halfedges(), Gluing::none);
  for (std::uint32_t h = number_of_halfedges(); h-- > 0;) first[crease.set_of(h)] = h;
  for (std::uint32_t h = 0; h < number_of_halfedges(); ++h) {
    if (!is_crossed(h)) continue;
    const std::uint32_t own = first[crease.set_of(h)], back = first[crease.set_of(h ^ 1U)];
    map_[h] = Frame_maps::across(own < back ? own : back ^ 1U);
  }
}

void Developed_faces::apply(const Gluing_map& mesh, Halfedge h, Frame_maps::Map map,
                            std::uint32_t frame) {
  if (map == Frame_maps::identity) return;
  const Frame_maps::Map back = maps_.inverse(map);
  Halfedge x = h;
  do {
    point_[x.index] = image(map, point_[x.index]);
    frame_[x.index] = frame;
    const Halfedge y = Gluing_map::opposite(x);
    if (mesh.face(y).index != Gluing::none) {
      map_[x.index] = maps_.composed(map, map_[x.index]);
      map_[y.index] = maps_.composed(map_[y.index], back);
    }
    x = mesh.next(x);
  } while (x != h);
}

void Developed_faces::bring_across(const Gluing_map& mesh, Halfedge h) {
  apply(mesh, Gluing_map::opposite(h), map_[h.index], frame_[h.index]);
}

void Developed_faces::choose_frame(const Gluing_map& mesh, Halfedge h) {
  const Halfedge n = mesh.next(h);
  const std::array<Point, 3> corners{source(h), source(n), source(mesh.next(n))};
  const auto letters_after = [&](Frame_maps::Map map) {
    std::size_t sum = 0;
    for (const Point p : corners) sum += maps_.number_of_letters(maps_.composed(map, map_of(p)));
    return sum;
  };
  std::size_t fewest = letters_after(Frame_maps::identity);
  Frame_maps::Map best = Frame_maps::identity;
  Point its_corner = 0;
  for (const Point p : corners) {
    const Frame_maps::Map back = maps_.inverse(map_of(p));
    if (fewest == 0 || back == Frame_maps::identity) continue;
    if (const std::size_t letters = letters_after(back); letters < fewest) {
      fewest = letters;
      best = back;
      its_corner = start_of(p);
    }
  }
  apply(mesh, h, best, frame_at_start_[face_[its_corner]]);
}

void Developed_faces::flip(const Gluing_map& mesh, Halfedge h) {
  const Halfedge o = Gluing_map::opposite(h);
  point_[h.index] = point_[mesh.next(mesh.next(h)).index];
  point_[o.index] = point_[mesh.next(mesh.next(o)).index];
}

Developed_faces::Value Developed_faces::name_length(const Gluing_map& mesh, Halfedge h) {
  const Point from = source(h), first = start_of(from);
  const Point to = image(maps_.inverse(map_of(from)), source(mesh.next(h)));
  return add({{first, to, 0}, frame_at_start_[face_[first]], false});
}

Developed_faces::Value Developed_faces::name_area(const Gluing_map& mesh, Halfedge h) {
  const Halfedge n = mesh.next(h);
  return add({{source(h), source(n), source(mesh.next(n))}, frame_[h.index], true});
}

Developed_faces::Value Developed_faces::add(const Quantity& q) {
  quantities_.push_back(q);
  return recipes_.number_of_values() + static_cast<Value>(quantities_.size()) - 1;
}

Developed_faces::Point Developed_faces::image(Frame_maps::Map map, Point p) {
  map = maps_.composed(map, map_of(p));
  p = start_of(p);
  if (map == Frame_maps::identity) return p;
  const std::uint64_t key = (std::uint64_t{map} << 32U) | p;
  if (const auto known = known_images_.find(key); known != known_images_.end())
    return known->second;
  Point result = 0;
  if (const std::optional<Image> nearer = across_first_edge({map, p})) {
    result = image(nearer->map, nearer->start);
  } else {
    result = number_of_halfedges() + static_cast<Point>(images_.size());
    images_.push_back({map, p, grid_point(Image{map, p})});
  }
  known_images_.emplace(key, result);
  return result;
}

// A corner on the first edge that its map crosses is a corner beyond it, too.
std::optional<Developed_faces::Image> Developed_faces::across_first_edge(const Image& i) {
  const Gluing_map& mesh = recipes_.triangulation().mesh();
  const Frame_maps::Map letter = maps_.first_letter(i.map);
  std::optional<Point> beyond;
  for_each_outgoing(mesh.source(Halfedge{i.start}), mesh, [&](Halfedge h) {
    if (beyond) return;
    const Halfedge o = Gluing_map::opposite(h);
    const Point here = point_at_start_[h.index], there = point_at_start_[next_[o.index]];
    if (map_at_start_[h.index] == letter && there == i.start) beyond = here;
    if (map_at_start_[o.index] == letter && here == i.start) beyond = there;
  });
  if (!beyond) return std::nullopt;
  return Image{maps_.without_first_letter(i.map), *beyond};
}

// ---- computation --------------------------------------------------------------------------------

namespace {

void set_from_rational(const Gmpq& x, Square_root_field::Number& to) {
  to = Square_root_field::Number(x);
}

void set_from_rational(const Gmpq& x, Long_ball& to) { to = enclosure_of(x); }

void set_from_rational(const Gmpq& x, Short_ball& to) {
  constexpr std::size_t exact = 53;
  const auto is_double = [](mpz_srcptr n) { return mpz_sizeinbase(n, 2) <= exact; };
  const mpz_srcptr numerator = mpq_numref(x.mpq()), denominator = mpq_denref(x.mpq());
  if (is_double(numerator) && is_double(denominator)) {
    to = Short_ball(mpz_get_d(numerator));
    if (mpz_cmp_ui(denominator, 1) != 0) to = to / Short_ball(mpz_get_d(denominator));
    return;
  }
  const Mpfr_precision precision(160);
  const Mpfr_number center = Mpfr_number::nearest(x);
  const double high = center.to_double(), low = (center - Mpfr_number(high)).to_double();
  // more than the rounding of `low`, or what underflows
  to = Short_ball::around(Double_double(high) + Double_double(low),
                          std::abs(high) * 0x1p-100 + 0x1p-1070);
}

template <class FT>
FT from_rational(const Gmpq& x) {
  FT result;
  set_from_rational(x, result);
  return result;
}

} // namespace

template <class FT>
const FT& Developed_faces::Evaluation<FT>::operator()(Value id) {
  const Value start = faces_->recipes_.number_of_values();
  if (id < start) return values_(id);
  const FT* known = moved_values_.find(id - start);
  return known != nullptr
             ? *known
             : moved_values_.add(id - start, computed(faces_->quantities_[id - start]));
}

template <class FT>
FT Developed_faces::Evaluation<FT>::computed(const Quantity& q) {
  const FT unit = values_(faces_->unit(q.frame));
  const Vector origin = point(q.points[0]), a = point(q.points[1]) - origin;
  if (!q.is_area) return unit * dot(a, a);
  return (unit + unit) * cross(a, point(q.points[2]) - origin);
}

template <class FT>
const typename Developed_faces::Evaluation<FT>::Vector&
Developed_faces::Evaluation<FT>::point(Point p) {
  if (const Vector* known = points_.find(p)) return *known;
  const std::uint32_t n = faces_->number_of_halfedges();
  return points_.add(p, p < n ? point_at_start(p) : computed(faces_->images_[p - n]));
}

template <class FT>
typename Developed_faces::Evaluation<FT>::Vector
Developed_faces::Evaluation<FT>::computed(const Image& image) {
  const Motion& m = motion(image.map);
  return m.turn * point(image.start) + m.shift;
}

template <class FT>
typename Developed_faces::Evaluation<FT>::Vector
Developed_faces::Evaluation<FT>::in_chart(const Plane_number& z, std::uint32_t chart) {
  return {from_rational<FT>(z.x),
          from_rational<FT>(z.y) * values_(faces_->recipes_.area_of_face(chart))};
}

template <class FT>
typename Developed_faces::Evaluation<FT>::Vector
Developed_faces::Evaluation<FT>::point_at_start(std::uint32_t halfedge) {
  const std::uint32_t face = faces_->face_[halfedge];
  const Plane_charts& charts = faces_->charts_;
  if (charts.chart(face) != Plane_charts::none)
    return in_chart(charts.point(charts.number_of_point(halfedge)), charts.chart(face));
  const std::uint32_t first = faces_->first_side_[face], second = faces_->next_[first],
                      third = faces_->next_[second];
  if (halfedge == first) return {FT(0), FT(0)};
  if (halfedge == second) return {FT(1), FT(0)};
  const auto squared = [&](std::uint32_t h) -> FT {
    return values_(faces_->recipes_.length_of_edge(h / 2));
  };
  const FT unit = squared(first), twice = unit + unit;
  return {(unit + squared(third) - squared(second)) / twice,
          values_(faces_->recipes_.area_of_face(face)) / twice};
}

template <class FT>
const typename Developed_faces::Evaluation<FT>::Motion&
Developed_faces::Evaluation<FT>::motion(Map map) {
  const auto known = motions_.find(map);
  return known != motions_.end() ? known->second
                                 : motions_.emplace(map, computed(map)).first->second;
}

template <class FT>
typename Developed_faces::Evaluation<FT>::Motion
Developed_faces::Evaluation<FT>::computed(Map map) {
  const Frame_maps& maps = faces_->maps_;
  if (maps.is_at_start(map)) return motion_at_start(Frame_maps::halfedge(map));
  if (const Plane_motion* m = maps.motion_of(map))
    return {in_chart(m->turn, m->chart), in_chart(m->shift, m->chart)};
  const std::vector<Map>& letters = maps.letters(map);
  Motion result = motion(letters.front());
  for (std::size_t i = 1; i < letters.size(); ++i) {
    const Motion& next = motion(letters[i]);
    result = {result.turn * next.turn, result.turn * next.shift + result.shift};
  }
  return result;
}

// The edge is one segment in both frames: the turn is the quotient of two vectors.
template <class FT>
typename Developed_faces::Evaluation<FT>::Motion
Developed_faces::Evaluation<FT>::motion_at_start(std::uint32_t halfedge) {
  const std::uint32_t other = halfedge ^ 1U;
  const Vector from = point(faces_->next_[other]), to = point(halfedge),
               side = point(faces_->next_[halfedge]) - to, before = point(other) - from;
  const FT quotient = values_(faces_->unit(faces_->frame_at_start_[faces_->face_[other]])) /
                      values_(faces_->recipes_.length_of_edge(halfedge / 2));
  const Vector turn = quotient * (side * Vector{before.x, -before.y});
  return {turn, to - turn * from};
}

template class Developed_faces::Evaluation<Short_ball>;
template class Developed_faces::Evaluation<Long_ball>;
template class Developed_faces::Evaluation<Square_root_field::Number>;

} // namespace CGAL::Intrinsic_triangulations::internal
