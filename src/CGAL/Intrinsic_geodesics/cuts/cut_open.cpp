// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

// Unglues the sides of cut edges, and lists them.
void open_seams(const std::vector<char>& is_cut, Opened_surface& s) {
  std::vector<std::uint32_t>& glue = s.gluing.glue;
  for (std::uint32_t h = 0; h < glue.size(); ++h) {
    const std::uint32_t p = Gluing::partner(glue[h]);
    if (p == Gluing::none || (is_cut[h] == 0 && is_cut[p] == 0)) continue;
    s.seams.push_back({h, glue[h]});
    glue[h] = glue[p] = Gluing::none;
  }
}

// Calls a function for the corners beside a corner, across the sides that meet there.
template <class Function>
void for_each_corner_beside(const Gluing& g, std::uint32_t corner, const Function& f) {
  const std::uint32_t coming = Gluing::next(Gluing::next(corner));
  for (const std::uint32_t h : {corner, coming}) {
    const std::uint32_t entry = g.glue[h];
    if (entry == Gluing::none) continue;
    const std::uint32_t p = Gluing::partner(entry);
    f((h == corner) == Gluing::is_reversed(entry) ? p : Gluing::next(p));
  }
}

// Gives each fan of corners a vertex: the first one at a vertex keeps its number.
void divide_vertices(Opened_surface& s) {
  Gluing& g = s.gluing;
  const std::vector<std::uint32_t> before = g.origin;
  std::vector<char> is_taken(g.number_of_vertices, 0), is_visited(before.size(), 0);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < before.size(); ++first) {
    if (is_visited[first] != 0) continue;
    std::uint32_t v = before[first];
    if (is_taken[v] != 0) {
      v = g.number_of_vertices++;
      s.original_vertex.push_back(before[first]);
    } else {
      is_taken[v] = 1;
    }
    is_visited[first] = 1;
    stack.assign(1, first);
    while (!stack.empty()) {
      const std::uint32_t c = stack.back();
      stack.pop_back();
      g.origin[c] = v;
      for_each_corner_beside(g, c, [&](std::uint32_t d) {
        if (is_visited[d] != 0) return;
        is_visited[d] = 1;
        stack.push_back(d);
      });
    }
  }
}

} // namespace

Opened_surface cut_open(const Gluing& g, const std::vector<char>& is_cut) {
  if (is_cut.size() != g.origin.size())
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(is_cut.size()) +
                            " marks of sides to cut; give one for each of the " +
                            std::to_string(g.origin.size()) + " sides of faces");
  Opened_surface s{g, {}, {}};
  for (std::uint32_t v = 0; v < g.number_of_vertices; ++v) s.original_vertex.push_back(v);
  open_seams(is_cut, s);
  divide_vertices(s);
  return s;
}

} // namespace CGAL::Intrinsic_triangulations
