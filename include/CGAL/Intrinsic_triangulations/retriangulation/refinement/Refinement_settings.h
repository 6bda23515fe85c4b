// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_SETTINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_SETTINGS_H

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The options of `delaunay_refine()`: one type for all named parameters, so that refinement is
// compiled once.
struct Refinement_settings {
  static constexpr double any = std::numeric_limits<double>::infinity();

  double minimum_angle = defaults::min_angle, maximum_circumradius = any, maximum_edge_length = any;
  Refinement_order order = Refinement_order::first_come;
  bool is_conforming = false;
  std::optional<std::uint64_t> maximum_insertions = std::nullopt;

  Refinement_settings() = default;
  template <class NP>
  explicit Refinement_settings(const NP& np)
      : minimum_angle(value_or<tags::minimum_angle>(np, defaults::min_angle)),
        maximum_circumradius(value_or<tags::maximum_circumradius>(np, any)),
        maximum_edge_length(value_or<tags::maximum_edge_length>(np, any)),
        order(value_or<tags::order>(np, Refinement_order::first_come)),
        is_conforming(value_or<tags::conforming>(np, false)),
        maximum_insertions(value_or<tags::maximum_insertions>(np, std::optional<std::uint64_t>())) {
  }
};

// The questions to a visitor, see `Refinement_visitor`, as functions: they hide its type, so that
// refinement is compiled once for a triangulation. Triangulation and visitor must outlive them.
template <class Triangulation>
struct Refinement_questions {
  std::function<bool(const Refinement_counts&)> progress = [](const Refinement_counts&) {
    return true;
  };
  std::function<bool(typename Triangulation::face_descriptor)> is_bad; // empty: none is

  Refinement_questions() = default;
  template <std::derived_from<Refinement_visitor> Visitor>
  Refinement_questions(const Triangulation& t, Visitor& visitor)
      : progress([&visitor](const Refinement_counts& c) { return visitor.progress(c); }) {
    if constexpr (!std::is_same_v<Visitor, Refinement_visitor>)
      is_bad = [&t, &visitor](auto f) { return visitor.is_bad(t, f); };
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_SETTINGS_H
