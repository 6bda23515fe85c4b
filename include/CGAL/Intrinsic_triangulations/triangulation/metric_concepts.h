// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_CONCEPTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

/*!
\file
The syntax of the concepts of metrics and traits. The page of each concept describes semantics,
cost, and which operation needs which function.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {
// The argument of a metric that decides by the input: see `Exact_values`.
struct Any_exact_values {
  using FT = Interval_nt<false>;
  Sign sign(const Diamond&, const Recorded_diamond_expression&, Diamond_values<FT>&,
            Predicate_statistics&) const;
  Sign sign(std::span<const Indexed_face>, const Recorded_face_expression&,
            std::vector<Face_values<FT>>&, Predicate_statistics&) const;
  unsigned for_each_enclosure(std::span<const Indexed_face>, unsigned, const auto& visit) const;
  FT first_squared_length(const Indexed_face&, unsigned) const;
  double nonzero_weight(const Diamond&, Predicate_statistics&) const;
};

// Decides expressions in the values of a diamond, with exact values if they are given.
template <class Metric, class... Exact>
concept Decides_expressions = requires(const Metric& c, const Diamond& d, const Exact&... exact) {
  { c.sign(d, Delaunay_expression(), exact...) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_source_expression(), exact...) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_target_expression(), exact...) } -> std::same_as<Sign>;
};

// Decides flips by functions of their own.
template <class Metric, class... Exact>
concept Has_flip_predicates = requires(const Metric& c, const Diamond& d, const Exact&... exact) {
  { c.delaunay_sign(d, exact...) } -> std::same_as<Sign>;
  { c.is_flippable(d, exact...) } -> std::same_as<bool>;
};

template <class Metric, class... Exact>
concept Decides_flips = (Decides_expressions<Metric, Exact...> ||
                         Has_flip_predicates<Metric, Exact...>)&&requires(const Metric& c,
                                                                          const Diamond& d,
                                                                          const Exact&... exact) {
  { c.is_locally_delaunay(d, exact...) } -> std::same_as<bool>;
};

template <class Metric>
concept Decides_by_input = Decides_flips<Metric, Any_exact_values>;

// Decides any expressions.
template <class Metric>
concept Decides_signs =
    Decides_expressions<Metric> || Decides_expressions<Metric, Any_exact_values>;

// Has no values of its own: those that flips make are none.
template <class Metric>
concept Stores_nothing = std::is_empty_v<typename Metric::Flipped> &&
    requires(const Metric& metric) {
  { metric.has_only_positive_areas() } -> std::same_as<bool>;
};

// Measures the angles at an edge.
template <class Metric, class... Exact>
concept Measures_diamonds = Decides_expressions<Metric, Exact...> &&
    requires(const Metric& c, const Diamond& d, const Exact&... exact) {
  { c.cotangent_weight(d, exact...) } -> std::convertible_to<double>;
};

} // namespace internal

/*!
\brief requires the storage of a metric that decides flips.

Syntax of \ref ::IntrinsicMetric, which describes its meaning.
*/
template <class Metric>
concept IntrinsicMetric =
    (internal::Decides_flips<Metric> ||
     internal::Decides_by_input<Metric>)&&std::default_initializable<Metric>&& std::
        movable<Metric>&& std::default_initializable<typename Metric::Scope>&& std::
            constructible_from<Metric, const Gluing_map&, const Input_metric&>&& requires(
                Metric& m, const Metric& c, const Diamond& d) {
  typename Metric::FT;
  { Metric::is_exact } -> std::convertible_to<bool>;
  { c.compute_flip(d) } -> std::same_as<std::optional<typename Metric::Flipped>>;
  m.store_flip(d, *c.compute_flip(d));
  { c.scale_exponent() } -> std::same_as<int>;
};

/*!
\brief requires a metric with lengths, areas and angles.

Syntax of \ref ::EuclideanMetric, which describes its meaning.
*/
template <class Metric>
concept EuclideanMetric = IntrinsicMetric<Metric> &&
    (internal::Measures_diamonds<Metric> ||
     internal::Measures_diamonds<Metric, internal::Any_exact_values>)&&requires(const Metric& c,
                                                                                const Diamond& d,
                                                                                std::uint32_t i) {
  { c.compute_flip_to_zero_area(d) } -> std::same_as<std::optional<typename Metric::Flipped>>;
  { c.cotangent_weight(i, i, i, i) } -> std::convertible_to<double>;
  { c.is_degenerate(i) } -> std::same_as<bool>;
  { c.is_zero_length(i) } -> std::same_as<bool>;
  { c.squared_length(i) } -> std::convertible_to<typename Metric::FT>;
  { c.quadruple_area(i) } -> std::convertible_to<typename Metric::FT>;
  { c.approximate_squared_length(i) } -> std::same_as<double>;
  { c.approximate_quadruple_area(i) } -> std::same_as<double>;
};

namespace internal {

// Returns the values that a flip will replace.
template <class Metric>
concept Remembers_flips = requires(const Metric& c, const Diamond& d) {
  { c.before_flip(d) } -> std::same_as<typename Metric::Flipped>;
};

// Has lambda lengths, and multiplies those of edges by factors of their vertices.
template <class Metric>
concept Scales_vertices = requires(Metric& m, std::span<const double> factors, std::uint32_t i) {
  m.set_factors(factors, factors);
  m.scale(i, i, i);
};

// Computes the values of an insertion from stored ones.
template <class Metric>
concept Measures_insertions = requires(const Metric& c, const Vertex_star& star,
                                       const Border_star& border,
                                       const std::array<double, 3>& weights, double parameter) {
  {
    c.inserted_values(star, weights)
    } -> std::same_as<std::optional<Vertex_move_values<typename Metric::FT>>>;
  {
    c.inserted_values(border, parameter)
    } -> std::same_as<std::optional<Vertex_move_values<typename Metric::FT>>>;
};

// Stores the values of an insertion.
template <class Metric>
concept Stores_insertions = requires(Metric& m, const Vertex_star& star, const Border_star& border,
                                     const Vertex_move_values<typename Metric::FT>& values) {
  m.insert_in_face(star, values);
  m.insert_in_border_edge(border, values);
};

// Receives the values of an insertion from the places of vertices on the input, and decides by
// those.
template <class Metric>
concept Defined_by_places = Decides_by_input<Metric> && Stores_insertions<Metric>;

} // namespace internal

/*!
\brief requires a metric that follows the insertion and removal of vertices.

Syntax of \ref ::RefinableMetric, which describes its meaning.
*/
template <class Metric>
concept RefinableMetric = EuclideanMetric<Metric> && internal::Remembers_flips<Metric> &&
    internal::Stores_insertions<Metric> &&
    (internal::Measures_insertions<Metric> ||
     internal::Decides_by_input<Metric>)&&requires(Metric& m, const Vertex_star& star,
                                                   const Border_star& border) {
  m.remove_from_face(star);
  m.remove_from_border_edge(border);
};

/*!
\brief requires the arithmetic of an intrinsic triangulation.

Syntax of \ref ::IntrinsicTriangulationTraits, which describes its meaning.
*/
template <class Traits>
concept IntrinsicTriangulationTraits = requires {
  typename Traits::FT;
  typename Traits::Metric;
}
&&IntrinsicMetric<typename Traits::Metric>&&
    std::same_as<typename Traits::FT, typename Traits::Metric::FT>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_CONCEPTS_H
