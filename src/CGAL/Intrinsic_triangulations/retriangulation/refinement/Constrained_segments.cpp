// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace CGAL::Intrinsic_triangulations {

Constrained_segments::Constrained_segments() = default;
Constrained_segments::Constrained_segments(const Constrained_segments& other) = default;
Constrained_segments::Constrained_segments(Constrained_segments&& other) noexcept = default;
Constrained_segments& Constrained_segments::operator=(const Constrained_segments& other) = default;
Constrained_segments&
Constrained_segments::operator=(Constrained_segments&& other) noexcept = default;
Constrained_segments::~Constrained_segments() = default;

void Constrained_segments::add(const Segment& segment) {
  set(segment.halfedge / 2, static_cast<std::uint32_t>(segments_.size()));
  segments_.push_back(segment);
}

void Constrained_segments::set(std::uint32_t edge, std::uint32_t segment) {
  if (edge >= segment_.size()) segment_.resize(edge + std::size_t{1}, Gluing::none);
  segment_[edge] = segment;
}

void Constrained_segments::note_ends() {
  for (std::uint32_t s = 0; s < segments_.size(); ++s)
    for (const std::uint32_t end : segments_[s].ends) at_[end].push_back(s);
}

bool Constrained_segments::has_small_angle(std::uint32_t vertex) const {
  return has_small_angle_.count(vertex) != 0;
}

void Constrained_segments::note_small_angle(std::uint32_t corner, std::uint32_t s, std::uint32_t t,
                                            double angle) {
  has_small_angle_.insert(corner);
  const auto [known, is_new] =
      small_angle_.insert({{corner, std::min(s, t), std::max(s, t)}, angle});
  known->second = std::min(known->second, angle);
}

void Constrained_segments::split(std::uint32_t whole, const std::array<std::uint32_t, 2>& parts,
                                 const std::array<std::uint32_t, 2>& ends, std::uint32_t vertex,
                                 double parameter) {
  const std::uint32_t s = segment_[whole];
  set(whole, Gluing::none);
  for (const std::uint32_t part : parts) set(part, s);
  Place p{s, {}};
  for (std::size_t i = 0; i < 2; ++i)
    p.distance[i] = (1 - parameter) * distance(s, i, ends[0]) + parameter * distance(s, i, ends[1]);
  place_[vertex] = p;
}

bool Constrained_segments::are_across_small_angle(std::uint32_t v, std::uint32_t w, double bound,
                                                  bool may_be_one_segment) const {
  for (const std::uint32_t s : segments_of(v))
    for (const std::uint32_t t : segments_of(w))
      for (std::size_t i = 0; i < 2 && (s != t || may_be_one_segment); ++i) {
        const std::uint32_t corner = segments_[s].ends[i];
        const std::optional<double> angle = small_angle(corner, s, t);
        if (!angle || corner == v || corner == w) continue;
        const std::size_t j = segments_[t].ends[0] == corner ? 0 : 1;
        const double d = distance(s, i, v), e = distance(t, j, w);
        if (*angle < bound || std::abs(d - e) <= same * d) return true;
      }
  return false;
}

double Constrained_segments::distance(std::uint32_t s, std::size_t end,
                                      std::uint32_t vertex) const {
  const Segment& segment = segments_[s];
  if (segment.ends[0] == segment.ends[1]) return std::numeric_limits<double>::quiet_NaN();
  if (vertex == segment.ends[end]) return 0;
  const auto p = place_.find(vertex);
  return p == place_.end() ? segment.length : p->second.distance[end];
}

std::span<const std::uint32_t> Constrained_segments::segments_of(std::uint32_t vertex) const {
  if (const auto p = place_.find(vertex); p != place_.end())
    return std::span(&p->second.segment, 1);
  const auto a = at_.find(vertex);
  return a == at_.end() ? std::span<const std::uint32_t>() : std::span(a->second);
}

std::optional<double> Constrained_segments::small_angle(std::uint32_t corner, std::uint32_t s,
                                                        std::uint32_t t) const {
  const auto angle = small_angle_.find({corner, std::min(s, t), std::max(s, t)});
  return angle == small_angle_.end() ? std::nullopt : std::optional(angle->second);
}

} // namespace CGAL::Intrinsic_triangulations
