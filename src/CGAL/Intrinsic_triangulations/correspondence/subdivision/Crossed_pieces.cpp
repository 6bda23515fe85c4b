// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Crossed_pieces.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/expect_middle.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Twice the signed area of three points, as part of that of the face.
double area(const std::array<double, 3>& p, const std::array<double, 3>& q,
            const std::array<double, 3>& r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

// Where segment pq crosses line rs, as part of it; in the middle if rounding hides it.
double crossing_part(const std::array<double, 3>& p, const std::array<double, 3>& q,
                     const std::array<double, 3>& r, const std::array<double, 3>& s) {
  const double at_p = area(r, s, p), part = at_p / (at_p - area(r, s, q));
  return std::isfinite(part) ? std::clamp(part, 0., 1.) : 0.5;
}

// The sides of the second subdivision inside of each middle face, each by one of its two corners.
struct Inner_sides {
  std::vector<std::uint32_t> begin, corner;
};

Inner_sides inner_sides(const Common_subdivision& s, const std::vector<std::uint32_t>& partner,
                        const Gluing_map& middle) {
  Inner_sides result;
  result.begin.assign(middle.number_of_faces() + 1, 0);
  std::vector<std::uint32_t> inner;
  for (std::uint32_t c = 0; c < s.corner.size(); ++c)
    if (s.side[c].input_edge == Common_subdivision::none && c < partner[c]) inner.push_back(c);
  const auto face = [&](std::uint32_t c) {
    return middle.face(Gluing_map::Halfedge{s.input_halfedge[c]}).index;
  };
  for (const std::uint32_t c : inner) ++result.begin[face(c) + 1];
  for (std::size_t f = 1; f < result.begin.size(); ++f) result.begin[f] += result.begin[f - 1];
  result.corner.resize(inner.size());
  std::vector<std::uint32_t> at = result.begin;
  for (const std::uint32_t c : inner) result.corner[at[face(c)]++] = c;
  return result;
}

} // namespace

Crossed_pieces::Crossed_pieces(const Common_subdivision& first, const Common_subdivision& second,
                               const Input& input, const Gluing_map& middle)
    : a_(first), b_(second), input_(input), middle_(middle), first_(first), second_(second),
      glue_(first_.run()), partner_(second_.run()),
      edges_(first_, second_, middle.number_of_halfedges()), halfedge_(second.corner.size(), none),
      entering_(second.corner.size(), none) {
  expect_paths(first_, glue_, Subdivided::intrinsic, edges_.first(), middle);
  expect_paths(second_, partner_, Subdivided::input, edges_.second(), middle);
  for (std::uint32_t e = 0; e < middle.number_of_edges(); ++e) add_pieces(e);
  const Inner_sides inner = inner_sides(second, partner_, middle);
  for (std::uint32_t i = 0, end = 0; i < first.number_of_faces(); i = end) {
    const std::uint32_t f = first.intrinsic_face[i];
    while (end < first.number_of_faces() && first.intrinsic_face[end] == f) ++end;
    enter_face(f);
    find_chords(first.face_begin[i], first.face_begin[end]);
    for (std::uint32_t n = inner.begin[f]; n < inner.begin[f + 1]; ++n) cross(inner.corner[n]);
  }
  begin_.push_back(static_cast<std::uint32_t>(crossings_.size()));
}

void Crossed_pieces::fail(std::uint32_t corner) const {
  fail_middle(Element_kind::face,
              middle_.face(Gluing_map::Halfedge{b_.input_halfedge[corner]}).index,
              Subdivided::input);
}

std::uint32_t Crossed_pieces::row(std::uint32_t vertex) const {
  const auto vertices = static_cast<std::uint32_t>(b_.vertices.size());
  return vertex < vertices ? b_.vertices[vertex].intrinsic
                           : b_.number_of_intrinsic_vertices + vertex - vertices;
}

// Numbers the edge on both sides of which two corners start.
std::uint32_t Crossed_pieces::add_edge(std::uint32_t corner, std::uint32_t partner) {
  const auto edge = static_cast<std::uint32_t>(begin_.size());
  begin_.push_back(static_cast<std::uint32_t>(crossings_.size()));
  input_edge_.push_back(none);
  for (const std::uint32_t c : {corner, partner}) {
    halfedge_[c] = static_cast<std::uint32_t>(corner_.size());
    corner_.push_back(c);
  }
  return edge;
}

// Adds the parts of a middle edge between crossings of the second subdivision, with the crossings
// of the first one on each.
void Crossed_pieces::add_pieces(std::uint32_t edge) {
  const auto of_a = edges_.first()[2 * edge], of_b = edges_.second()[2 * edge],
             back = edges_.second()[2 * edge + 1];
  const auto parameter = [&](std::size_t j) {
    return b_.crossings[b_.corner[of_b[j]] - b_.vertices.size()].on_input.parameter;
  };
  std::size_t i = 1;
  for (std::size_t j = 0; j < of_b.size(); ++j) {
    const std::uint32_t e = add_edge(of_b[j], back[of_b.size() - 1 - j]);
    const double from = j == 0 ? 0 : parameter(j), to = j + 1 == of_b.size() ? 1 : parameter(j + 1);
    for (; i < of_a.size(); ++i) {
      const auto x = static_cast<std::uint32_t>(a_.corner[of_a[i]] - a_.vertices.size());
      if (edges_.second_before(x) > j) break;
      if (edges_.second_at(x) != none) continue;
      add_crossing(e, x);
      const double part = (a_.crossings[x].on_intrinsic.parameter - from) / (to - from);
      crossings_.back().on_input = a_.crossings[x].on_input;
      crossings_.back().on_intrinsic.parameter =
          std::isfinite(part) ? std::clamp(part, 0., 1.) : 0.5;
    }
  }
}

void Crossed_pieces::add_crossing(std::uint32_t edge, std::uint32_t source) {
  source_.push_back(source);
  Common_subdivision::Edge_point& p = crossings_.emplace_back().on_intrinsic;
  p.edge = edge;
  const std::uint32_t c = corner_[2 * edge];
  p.vertices = {row(b_.corner[c]), row(b_.corner[second_.next(c)])};
}

std::uint32_t Crossed_pieces::entering(std::uint32_t crossing, std::uint32_t corner) const {
  if (b_.side[corner].input_edge == none)
    return halfedge_[corner] % 2 == 0 ? source_[crossing] : glue_[source_[crossing]];
  const std::uint32_t c = edges_.first_from(source_[crossing], b_.input_halfedge[corner]);
  return glue_[first_.previous(c)];
}

// ---- One face of the middle triangulation ----

void Crossed_pieces::enter_face(std::uint32_t f) {
  border_ = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sides_[k] = middle_.sides({f})[k].index;
    base_[k] = border_;
    border_ += 1 + edges_.number_of_points(sides_[k]);
  }
}

std::uint32_t Crossed_pieces::border_place(std::uint32_t h, std::uint32_t rank) const {
  return base_[h == sides_[0] ? 0 : h == sides_[1] ? 1 : 2] + rank;
}

std::uint32_t Crossed_pieces::place_of_first(std::uint32_t corner) const {
  const std::uint32_t v = a_.corner[corner], h = a_.intrinsic_halfedge[corner];
  const auto vertices = static_cast<std::uint32_t>(a_.vertices.size());
  return border_place(h, v < vertices ? 0 : edges_.rank_of_first(v - vertices, h));
}

std::uint32_t Crossed_pieces::place_of_second(std::uint32_t corner) const {
  const std::uint32_t v = b_.corner[corner], h = b_.input_halfedge[corner];
  const auto vertices = static_cast<std::uint32_t>(b_.vertices.size());
  return border_place(h, v < vertices ? 0 : edges_.rank_of_second(v - vertices, h));
}

// The point of a halfedge, `along` from the source of the first halfedge of its edge.
Crossed_pieces::Place Crossed_pieces::point(std::uint32_t h, double along) const {
  const std::size_t k = h == sides_[0] ? 0 : h == sides_[1] ? 1 : 2;
  Place p{};
  p[k] = h % 2 == 0 ? 1 - along : along;
  p[(k + 1) % 3] = h % 2 == 0 ? along : 1 - along;
  return p;
}

Crossed_pieces::Place Crossed_pieces::point_of_first(std::uint32_t corner) const {
  const std::uint32_t v = a_.corner[corner], h = a_.intrinsic_halfedge[corner];
  return point(h, v < a_.vertices.size()
                      ? h % 2
                      : a_.crossings[v - a_.vertices.size()].on_intrinsic.parameter);
}

Crossed_pieces::Place Crossed_pieces::point_of_second(std::uint32_t corner) const {
  const std::uint32_t v = b_.corner[corner], h = b_.input_halfedge[corner];
  return point(h, v < b_.vertices.size() ? h % 2
                                         : b_.crossings[v - b_.vertices.size()].on_input.parameter);
}

// Sorts the ends of input edges between corners of the first subdivision along the border; those at
// one point in the order in which a chord that runs along the border crosses them.
void Crossed_pieces::find_chords(std::uint32_t begin, std::uint32_t end) {
  ends_.clear();
  for (std::uint32_t c = begin; c < end; ++c)
    if (a_.side[c].intrinsic_edge == none)
      ends_.push_back({place_of_first(c), place_of_first(first_.next(c)), c});
  const auto key = [this](const Chord_end& e) {
    return std::tuple((e.at + border_ - e.other) % border_, e.corner);
  };
  std::sort(ends_.begin(), ends_.end(), [&](const Chord_end& e, const Chord_end& f) {
    return e.at != f.at ? e.at < f.at : key(e) < key(f);
  });
}

// Adds the side of a corner of the second subdivision, and the input edges that cross it: those
// with one end on each side of it.
void Crossed_pieces::cross(std::uint32_t corner) {
  const std::uint32_t next = second_.next(corner), edge = add_edge(corner, partner_[corner]);
  const std::uint32_t from = place_of_second(corner), to = place_of_second(next);
  const auto distance = [&](std::uint32_t place) { return (place + border_ - from) % border_; };
  const std::uint32_t span = distance(to);
  const Place p = point_of_second(corner), q = point_of_second(next);
  const auto begin = std::upper_bound(ends_.begin(), ends_.end(), from,
                                      [](std::uint32_t x, const Chord_end& e) { return x < e.at; });
  double reached = 0;
  for (std::size_t n = 0; n < ends_.size(); ++n) {
    const auto i = (static_cast<std::size_t>(begin - ends_.begin()) + n) % ends_.size();
    const Chord_end& e = ends_[i];
    if (distance(e.at) == 0 || distance(e.at) >= span) break;
    if (distance(e.other) <= span) continue;
    const Place r = point_of_first(e.corner), s = point_of_first(first_.next(e.corner));
    add_crossing(edge, e.corner);
    reached = std::max(reached, crossing_part(p, q, r, s));
    crossings_.back().on_input = on_input(e.corner, crossing_part(r, s, p, q));
    crossings_.back().on_intrinsic.parameter = reached;
  }
  meet(corner);
  meet(partner_[corner]);
}

// Where the side of a corner starts at a crossing of both subdivisions, the input edge from there
// is the side or runs into the face on one side of it.
void Crossed_pieces::meet(std::uint32_t corner) {
  const auto vertices = static_cast<std::uint32_t>(b_.vertices.size());
  const std::uint32_t v = b_.corner[corner], next = second_.next(corner);
  if (v < vertices || edges_.first_at(v - vertices) == none) return;
  const std::uint32_t from = place_of_second(corner), to = place_of_second(next);
  const auto distance = [&](std::uint32_t place) { return (place + border_ - from) % border_; };
  const auto e = std::lower_bound(ends_.begin(), ends_.end(), from,
                                  [](const Chord_end& end, std::uint32_t x) { return end.at < x; });
  if (e == ends_.end()) fail(corner);
  if (e->other == to)
    input_edge_[halfedge_[corner] / 2] = a_.side[e->corner].input_edge;
  else if (distance(e->other) > distance(to))
    entering_[corner] = e->corner;
  else
    entering_[second_.next(partner_[corner])] = e->corner;
}

// A point of a side of the first subdivision along an edge of the input.
Common_subdivision::Edge_point Crossed_pieces::on_input(std::uint32_t corner, double along) const {
  const std::uint32_t x = a_.input_halfedge[corner];
  const auto parameter = [&](std::uint32_t c, bool is_target) -> double {
    if (a_.corner[c] < a_.vertices.size()) return is_target == (x % 2 == 0) ? 1 : 0;
    return a_.crossings[a_.corner[c] - a_.vertices.size()].on_input.parameter;
  };
  const std::uint32_t h = x & ~1U;
  const double place =
      (1 - along) * parameter(corner, false) + along * parameter(first_.next(corner), true);
  return {
      x / 2, {input_.names().row(input_.source(h)), input_.names().row(input_.target(h))}, place};
}

} // namespace CGAL::Intrinsic_triangulations::internal
