// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Gluing_map::Gluing_map() = default;
Gluing_map::Gluing_map(const Gluing_map& other) = default;
Gluing_map::Gluing_map(Gluing_map&& other) noexcept = default;
Gluing_map& Gluing_map::operator=(const Gluing_map& other) = default;
Gluing_map& Gluing_map::operator=(Gluing_map&& other) noexcept = default;
Gluing_map::~Gluing_map() = default;

Gluing_map::Gluing_map(const Gluing& gluing) {
  validate(gluing);
  *this = from_valid(gluing);
}

Gluing_map Gluing_map::from_valid(const Gluing& gluing) {
  Gluing_map result;
  result.number_edges(gluing);
  result.link_border();
  return result;
}

Gluing_map::Gluing_map(std::uint32_t vertices, std::uint32_t edges, std::uint32_t faces)
    : halfedge_(2 * static_cast<std::size_t>(edges)), vertex_(vertices, Gluing::none),
      face_(faces, Gluing::none) {}

void Gluing_map::make_room() {
  reserve_at_least(vertex_, vertex_.size() + 1);
  reserve_at_least(halfedge_, halfedge_.size() + 6);
  if (!reversed_.empty()) reserve_at_least(reversed_, reversed_.size() + 3);
  reserve_at_least(face_, face_.size() + 2);
  reserve_at_least(free_vertices_, free_vertices_.size() + 1);
  reserve_at_least(free_edges_, free_edges_.size() + 3);
  reserve_at_least(free_faces_, free_faces_.size() + 2);
}

Gluing_map::Edge Gluing_map::add_edge() {
  if (!free_edges_.empty()) {
    const std::uint32_t e = free_edges_.back();
    free_edges_.pop_back();
    halfedge_[2 * e] = halfedge_[2 * e + 1] = {};
    return {e};
  }
  halfedge_.resize(halfedge_.size() + 2);
  if (!reversed_.empty()) reversed_.push_back(0);
  return {number_of_edges() - 1};
}

std::uint32_t Gluing_map::add(std::vector<std::uint32_t>& elements,
                              std::vector<std::uint32_t>& free) {
  if (free.empty()) {
    elements.push_back(Gluing::none);
    return static_cast<std::uint32_t>(elements.size()) - 1;
  }
  const std::uint32_t i = free.back();
  free.pop_back();
  elements[i] = Gluing::none;
  return i;
}

void Gluing_map::number_edges(const Gluing& g) {
  const auto corners = static_cast<std::uint32_t>(g.origin.size());
  std::vector<std::uint32_t> name(corners, Gluing::none);
  std::uint32_t count = 0;
  for (std::uint32_t h = 0; h < corners; ++h) {
    if (name[h] != Gluing::none) continue;
    const std::uint32_t partner = Gluing::partner(g.glue[h]);
    name[h] = 2 * count;
    if (partner != Gluing::none) name[partner] = 2 * count + 1;
    if (Gluing::is_reversed(g.glue[h])) {
      reversed_.resize(count + 1, 0);
      reversed_[count] = 1;
    }
    ++count;
  }
  if (!reversed_.empty()) reversed_.resize(count, 0);
  vertex_.assign(g.number_of_vertices, Gluing::none);
  face_.resize(corners / 3);
  halfedge_.resize(2 * static_cast<std::size_t>(count));
  for (std::uint32_t f = 0; f < corners / 3; ++f) {
    face_[f] = name[3 * f];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t n = 3 * f + (k + 1) % 3;
      halfedge_[name[3 * f + k]] = {name[n], g.origin[n], f};
      vertex_[g.origin[n]] = name[3 * f + k];
    }
  }
}

void Gluing_map::link_border() {
  for (std::uint32_t h = 0; h < halfedge_.size(); ++h) {
    if (halfedge_[h].face != Gluing::none) continue;
    halfedge_[h].target = target(next(next({h ^ 1U}))).index;
    vertex_[halfedge_[h].target] = h;
    if (is_oriented()) set_next({h}, next_on_border({h}));
  }
}

} // namespace CGAL::Intrinsic_triangulations
