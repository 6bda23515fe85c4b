// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

Vertex_fans::Vertex_fans(const Input& input) : slot_(input.number_of_halfedges(), Gluing::none) {
  halfedge_.reserve(slot_.size());
  fan_.resize(slot_.size());
  for (std::uint32_t h = 0; h < slot_.size(); ++h)
    if (input.is_border(h ^ 1U)) add_fan(input, h);
  for (std::uint32_t h = 0; h < slot_.size(); ++h)
    if (slot_[h] == Gluing::none) add_fan(input, h);
}

void Vertex_fans::make_room() {
  reserve_at_least(halfedge_, halfedge_.size() + 2);
  reserve_at_least(fan_, fan_.size() + 2);
  reserve_at_least(free_, free_.size() + 1);
}

std::uint32_t Vertex_fans::add_fan_on_edge(std::uint32_t halfedge) {
  std::uint32_t slot = static_cast<std::uint32_t>(halfedge_.size());
  if (free_.empty()) {
    halfedge_.resize(slot + 2);
    fan_.resize(slot + 2, {slot, 2});
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  halfedge_[slot] = halfedge;
  halfedge_[slot + 1] = halfedge ^ 1U;
  return slot;
}

void Vertex_fans::add_fan(const Input& input, std::uint32_t first) {
  const auto begin = static_cast<std::uint32_t>(halfedge_.size());
  for (std::uint32_t h = first;;) {
    slot_[h] = static_cast<std::uint32_t>(halfedge_.size());
    halfedge_.push_back(h);
    if (input.is_border(h)) break;
    h = input.next(input.next(h)) ^ 1U;
    if (h == first) break;
  }
  const auto end = static_cast<std::uint32_t>(halfedge_.size());
  for (std::uint32_t s = begin; s < end; ++s) fan_[s] = {begin, end - begin};
}

} // namespace CGAL::Intrinsic_triangulations
