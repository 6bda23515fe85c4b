// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Intervals, and doubles in the middle of each, in one go: both are in the cache then.
struct Enclosing_values {
  std::vector<Interval_nt<false>> enclosures;
  std::vector<double> middles;

  explicit Enclosing_values(std::size_t size) {
    enclosures.reserve(size);
    middles.reserve(size);
  }
  void add(const Interval_nt<false>& x) {
    enclosures.push_back(x);
    middles.push_back(CGAL::to_double(x));
  }
};

Enclosed_values enclosed_input(const Gluing_map& mesh, const Input_metric& input) {
  const Protect_FPU_rounding<true> scope;
  Enclosing_values lengths(mesh.number_of_edges()), areas(input.number_of_faces());
  bool are_lengths_positive = true;
  for_each_squared_length<Interval_nt<false>>(input, mesh, [&](const Interval_nt<false>& x) {
    lengths.add(x);
    are_lengths_positive = are_lengths_positive && x.sup() > 0;
  });
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
    areas.add(quadruple_area<Interval_nt<false>>(input, f));
  return {std::move(lengths.enclosures), std::move(areas.enclosures), std::move(lengths.middles),
          std::move(areas.middles), are_lengths_positive};
}

Vertex_move_values<double> doubles_within(const Vertex_move_values<Interval_nt<false>>& values) {
  Vertex_move_values<double> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result.squared_lengths[k] = CGAL::to_double(values.squared_lengths[k]);
    result.quadruple_areas[k] = CGAL::to_double(values.quadruple_areas[k]);
  }
  return result;
}

} // namespace

} // namespace internal

Exact_euclidean_metric::Exact_euclidean_metric(const Gluing_map& mesh, const Input_metric& input)
    : Enclosed_values(internal::enclosed_input(mesh, input)),
      scale_exponent_(input.scale_exponent()) {}

std::optional<Exact_euclidean_metric::Flipped>
Exact_euclidean_metric::compute_flip_to_zero_area(const Diamond& d) const {
  std::optional<Flipped> n = compute_flip(d);
  n->enclosure.area_f = quadruple_area(d.f) + quadruple_area(d.g);
  n->enclosure.area_g = FT(0);
  n->approximation.area_f = approximate_quadruple_area(d.f) + approximate_quadruple_area(d.g);
  n->approximation.area_g = 0;
  return n;
}

void Exact_euclidean_metric::insert_in_face(const Vertex_star& s,
                                            const Vertex_move_values<FT>& values) noexcept {
  store(s.spokes, s.faces, {values, internal::doubles_within(values)});
  signs_.forget(s.sides);
  signs_.forget(s.spokes);
}

Exact_euclidean_metric::Flipped Exact_euclidean_metric::removed_values(const Vertex_star& s) const {
  const auto [f, g, h] = s.faces;
  Flipped n = stored(without_vertex(s));
  n.enclosure.area_f = quadruple_area(f) + quadruple_area(g) + quadruple_area(h);
  n.approximation.area_f =
      approximate_quadruple_area(f) + approximate_quadruple_area(g) + approximate_quadruple_area(h);
  n.enclosure.area_g = n.enclosure.area_f;
  n.approximation.area_g = n.approximation.area_f;
  return n;
}

void Exact_euclidean_metric::insert_in_border_edge(const Border_star& s,
                                                   const Vertex_move_values<FT>& values) noexcept {
  const auto& [l, a] = values;
  const Vertex_move_values<FT> on_border{{l[0], l[1], l[2]}, {a[2], a[1], FT(0)}};
  store(std::array{s.ip, s.pj, s.pk}, std::array{s.f, s.g},
        {on_border, internal::doubles_within(on_border)});
  signs_.forget(std::array{s.ip, s.pj, s.jk, s.ki, s.pk});
}

Exact_euclidean_metric::Flipped Exact_euclidean_metric::removed_values(const Border_star& s) const {
  const Diamond d{s.pk, s.ki, s.ip, s.pj, s.jk, s.f, s.g};
  return {removed_from_border_edge(enclosure(d)), removed_from_border_edge(approximation(d))};
}

} // namespace CGAL::Intrinsic_triangulations
