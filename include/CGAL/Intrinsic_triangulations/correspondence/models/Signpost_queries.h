// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/locate_by_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/signpost_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Answers queries by tracing geodesics, see `Curve_queries`.
template <class Triangulation, class Signposts>
class Signpost_queries {
public:
  Signpost_queries(const Triangulation& t, const Signposts& signposts)
      : t_(t), signposts_(signposts) {}

  std::optional<Mapped_point> on_input(const Surface_point& p) const {
    return find_on_input(t_, signposts_, p);
  }
  std::optional<Mapped_point> on_intrinsic(const Surface_point& p) const {
    return find_on_intrinsic(t_, signposts_, p);
  }
  Edge_path path_on_input(std::uint32_t edge) const {
    return trace_edge_by_signposts(t_, signposts_, edge);
  }
  Edge_path path_on_intrinsic(std::uint32_t x) const {
    return trace_input_edge_by_signposts(t_, signposts_, x);
  }
  std::uint32_t input_edge_along(std::uint32_t edge) const {
    const std::uint32_t h = path_on_input(edge).along;
    return h == Gluing::none ? h : h / 2;
  }
  auto walk_on_input(std::uint32_t h, double turn) const { return signposts_.walk(h, turn); }
  std::optional<Corner_direction> direction_on_intrinsic(std::uint32_t x, double turn) const {
    return signposts_.intrinsic_direction(Intrinsic_view<Triangulation>(t_), x, turn);
  }
  Integer_coordinates curves() const { return integer_coordinates(t_, signposts_); }

private:
  const Triangulation& t_;
  const Signposts& signposts_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H
