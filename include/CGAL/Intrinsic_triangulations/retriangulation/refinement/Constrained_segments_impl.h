// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool
Constrained_segments::is_on_segment(std::uint32_t vertex) const {
  return place_.count(vertex) != 0;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Constrained_segments::split(std::uint32_t whole, const std::array<std::uint32_t, 2>& parts,
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool
Constrained_segments::are_across_small_angle(std::uint32_t v, std::uint32_t w, double bound,
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Constrained_segments::set(std::uint32_t edge,
                                                                    std::uint32_t segment) {
  if (edge >= segment_.size()) segment_.resize(edge + std::size_t{1}, Gluing::none);
  segment_[edge] = segment;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE double
Constrained_segments::distance(std::uint32_t s, std::size_t end, std::uint32_t vertex) const {
  const Segment& segment = segments_[s];
  if (segment.ends[0] == segment.ends[1]) return std::numeric_limits<double>::quiet_NaN();
  if (vertex == segment.ends[end]) return 0;
  const auto p = place_.find(vertex);
  return p == place_.end() ? segment.length : p->second.distance[end];
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::span<const std::uint32_t>
Constrained_segments::segments_of(std::uint32_t vertex) const {
  if (const auto p = place_.find(vertex); p != place_.end())
    return std::span(&p->second.segment, 1);
  const auto a = at_.find(vertex);
  return a == at_.end() ? std::span<const std::uint32_t>() : std::span(a->second);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<double>
Constrained_segments::small_angle(std::uint32_t corner, std::uint32_t s, std::uint32_t t) const {
  const auto angle = small_angle_.find({corner, std::min(s, t), std::max(s, t)});
  return angle == small_angle_.end() ? std::nullopt : std::optional(angle->second);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_IMPL_H
