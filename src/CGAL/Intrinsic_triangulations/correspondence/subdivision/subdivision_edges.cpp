// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

std::size_t intrinsic_edge_bound(const Common_subdivision& s) {
  std::size_t bound = 0;
  for (const Common_subdivision::Side& side : s.side)
    if (side.intrinsic_edge != Common_subdivision::none)
      bound = std::max(bound, std::size_t{side.intrinsic_edge} + 1);
  return bound;
}

} // namespace internal

namespace {

using internal::intrinsic_edge_bound;

// The vertices of a subdivision at the ends of each intrinsic edge, `none` for unused numbers.
std::vector<std::array<std::uint32_t, 2>> intrinsic_edge_ends(const Common_subdivision& s) {
  constexpr std::uint32_t none = Common_subdivision::none;
  std::vector<std::array<std::uint32_t, 2>> ends(intrinsic_edge_bound(s), {none, none});
  for_each_subdivision_edge(
      s, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side& side) {
        if (side.intrinsic_edge != none)
          ends[side.intrinsic_edge] = {std::min(a, b), std::max(a, b)};
      });
  std::vector<std::uint32_t> number(s.number_of_intrinsic_vertices, none);
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v) number[s.vertices[v].intrinsic] = v;
  for (const Common_subdivision::Crossing& c : s.crossings)
    for (std::size_t k = 0; k < 2; ++k)
      ends[c.on_intrinsic.edge][k] = number[c.on_intrinsic.vertices[k]];
  return ends;
}

} // namespace

Edge_polylines intrinsic_edge_polylines(const Common_subdivision& s) {
  const auto place = [&](std::size_t i) {
    const Common_subdivision::Edge_point& p = s.crossings[i].on_intrinsic;
    return std::make_tuple(p.edge, p.parameter, i);
  };
  const auto is_before = [&](std::size_t i, std::size_t j) { return place(i) < place(j); };
  std::vector<std::size_t> order(s.crossings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!std::is_sorted(order.begin(), order.end(), is_before))
    std::sort(order.begin(), order.end(), is_before);
  Edge_polylines result;
  auto next = order.begin();
  for (const std::array<std::uint32_t, 2>& ends : intrinsic_edge_ends(s)) {
    if (ends[0] != Common_subdivision::none) {
      result.vertices.push_back(ends[0]);
      for (; next != order.end() && s.crossings[*next].on_intrinsic.edge == result.size(); ++next)
        result.vertices.push_back(static_cast<std::uint32_t>(s.vertices.size() + *next));
      result.vertices.push_back(ends[1]);
    }
    result.begin.push_back(result.vertices.size());
  }
  return result;
}

namespace {

// An edge of a subdivision that lies on an edge of the input.
struct Part_of_input_edge {
  std::uint32_t edge;
  std::array<std::uint32_t, 2> ends;
};

// Puts the parts of one input edge in order: between its ends, which are vertices of the input,
// every vertex is the end of two parts.
class Part_chain {
public:
  Part_chain(const Common_subdivision& s, std::span<const Part_of_input_edge> parts);

  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

private:
  // the other end of a part at `v` that has not been passed
  std::uint32_t next(std::uint32_t v);

  // the direction from the crossings, whose order is safe from rounding
  bool is_backwards(const Common_subdivision& s) const;

  std::span<const Part_of_input_edge> parts_;
  std::vector<bool> is_used_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at_; // vertices, and parts that end there
  std::vector<std::uint32_t> vertices_;
};

Part_chain::Part_chain(const Common_subdivision& s, std::span<const Part_of_input_edge> parts)
    : parts_(parts), is_used_(parts.size(), false) {
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    for (const std::uint32_t v : parts[i].ends) at_.emplace_back(v, i);
  std::sort(at_.begin(), at_.end());
  std::uint32_t v = at_.front().first; // the smallest, but for inserted vertices
  for (const auto& [end, part] : at_)
    if (s.kind(end) == Subdivision_vertex_kind::input) {
      v = end;
      break;
    }
  vertices_.push_back(v);
  for (std::size_t i = 0; i < parts.size(); ++i) vertices_.push_back(v = next(v));
  if (is_backwards(s)) std::reverse(vertices_.begin(), vertices_.end());
}

std::uint32_t Part_chain::next(std::uint32_t v) {
  auto i = std::lower_bound(at_.begin(), at_.end(), std::pair(v, 0U));
  while (is_used_[i->second]) ++i;
  is_used_[i->second] = true;
  const std::array<std::uint32_t, 2>& ends = parts_[i->second].ends;
  return ends[0] == v ? ends[1] : ends[0];
}

bool Part_chain::is_backwards(const Common_subdivision& s) const {
  double first = -1, last = -1;
  for (const std::uint32_t v : vertices_)
    if (s.kind(v) == Subdivision_vertex_kind::crossing) {
      last = s.crossings[v - s.vertices.size()].on_input.parameter;
      if (first < 0) first = last;
    }
  if (first < last || first > last) return first > last;
  // one crossing: the edge ends at the vertices that it names
  for (const std::uint32_t v : vertices_)
    if (s.kind(v) == Subdivision_vertex_kind::crossing)
      return s.vertices[vertices_.front()].intrinsic !=
             s.crossings[v - s.vertices.size()].on_input.vertices[0];
  return vertices_.front() > vertices_.back();
}

} // namespace

Edge_polylines input_edge_polylines(const Common_subdivision& s) {
  std::vector<Part_of_input_edge> parts;
  for_each_subdivision_edge(
      s, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side& side) {
        if (side.input_edge != Common_subdivision::none) parts.push_back({side.input_edge, {a, b}});
      });
  std::sort(parts.begin(), parts.end(),
            [](const auto& p, const auto& q) { return p.edge < q.edge; });
  Edge_polylines result;
  for (auto begin = parts.begin(); begin != parts.end();) {
    const auto end =
        std::find_if(begin, parts.end(), [&](const auto& p) { return p.edge != begin->edge; });
    result.begin.resize(begin->edge + std::size_t{1}, result.vertices.size());
    const Part_chain chain(s, std::span(begin, end));
    result.vertices.insert(result.vertices.end(), chain.vertices().begin(), chain.vertices().end());
    result.begin.push_back(result.vertices.size());
    begin = end;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
