// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Dart_complex::Dart_complex(const Gluing_map& mesh, const std::vector<char>& is_left_out)
    : dart(mesh.number_of_halfedges(), none) {
  using Halfedge = Gluing_map::Halfedge;
  for (std::uint32_t h = 0; h < dart.size(); ++h) {
    if (mesh.is_removed(Halfedge{h}) || mesh.face(Halfedge{h}).index == Gluing::none ||
        is_left_out[h / 2] != 0)
      continue;
    dart[h] = static_cast<std::uint32_t>(halfedge.size());
    halfedge.push_back(h);
  }
  next.resize(halfedge.size());
  previous.resize(halfedge.size());
  opposite.resize(halfedge.size());
  for (std::uint32_t d = 0; d < size(); ++d) {
    Halfedge n = mesh.next(Halfedge{halfedge[d]});
    while (dart[n.index] == none) n = mesh.next(Gluing_map::opposite(n));
    next[d] = dart[n.index];
    previous[next[d]] = d;
    opposite[d] = dart[halfedge[d] ^ 1U];
  }
  count_sides();
  count_degrees(mesh);
  find_components();
}

bool Dart_complex::has_pinched_vertex() const {
  return std::any_of(degree.begin(), degree.end(),
                     [](std::uint32_t d) { return (d & of_pinched_vertex) != 0; });
}

void Dart_complex::count_sides() {
  sides.assign(size(), 0);
  for (std::uint32_t d = 0; d < size(); ++d) {
    if (sides[d] != 0) continue;
    std::uint32_t count = 0, e = d;
    do {
      ++count;
      e = next[e];
    } while (e != d);
    do {
      sides[e] = count;
      e = next[e];
    } while (e != d);
  }
}

// Turns about the source of each dart, from the border on if there is one.
void Dart_complex::count_degrees(const Gluing_map& mesh) {
  degree.assign(size(), 0);
  std::vector<std::uint32_t> fan, number_of_fans(mesh.number_of_vertices(), 0);
  const auto source = [&](std::uint32_t d) {
    return mesh.source(Gluing_map::Halfedge{halfedge[d]}).index;
  };
  for (std::uint32_t d = 0; d < size(); ++d) {
    if (degree[d] != 0) continue;
    std::uint32_t first = d;
    while (opposite[first] != none && next[opposite[first]] != d) first = next[opposite[first]];
    fan.clear();
    std::uint32_t e = first;
    do {
      fan.push_back(e);
      e = opposite[previous[e]];
    } while (e != none && e != first);
    for (const std::uint32_t x : fan) degree[x] = static_cast<std::uint32_t>(fan.size());
    ++number_of_fans[source(d)];
  }
  for (std::uint32_t d = 0; d < size(); ++d)
    if (number_of_fans[source(d)] > 1) degree[d] |= of_pinched_vertex;
}

void Dart_complex::find_components() {
  component.assign(size(), none);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < size(); ++first) {
    if (component[first] != none) continue;
    component[first] = number_of_components++;
    stack.assign(1, first);
    while (!stack.empty()) {
      const std::uint32_t d = stack.back();
      stack.pop_back();
      for (const std::uint32_t e : {next[d], opposite[d]}) {
        if (e == none || component[e] != none) continue;
        component[e] = component[d];
        stack.push_back(e);
      }
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
