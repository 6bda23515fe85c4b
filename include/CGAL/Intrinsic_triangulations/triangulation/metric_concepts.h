// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_CONCEPTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

/*!
\file
The syntax of the concepts of metrics and traits. The page of each concept describes semantics,
cost, and which operation needs which function.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {
// Decides expressions in the values of a diamond.
template <class Metric>
concept Decides_expressions = requires(const Metric& c, const Diamond& d) {
  { c.sign(d, Delaunay_expression()) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_source_expression()) } -> std::same_as<Sign>;
  { c.sign(d, Convexity_at_target_expression()) } -> std::same_as<Sign>;
};

// Decides flips by functions of its own.
template <class Metric>
concept Has_flip_predicates = requires(const Metric& c, const Diamond& d) {
  { c.delaunay_sign(d) } -> std::same_as<Sign>;
  { c.is_flippable(d) } -> std::same_as<bool>;
};

template <class Metric>
concept Decides_flips = (Decides_expressions<Metric> ||
                         Has_flip_predicates<Metric>)&&requires(const Metric& c, const Diamond& d) {
  { c.is_locally_delaunay(d) } -> std::same_as<bool>;
};

// Answers only what it is certain of; a decider above it answers the rest.
template <class Metric>
concept Answers_if_certain = requires(const Metric& c, const Diamond& d) {
  { c.certain_delaunay(d) } -> std::same_as<Certainty>;
};

// Stores enclosures of lengths and areas, and takes better ones.
template <class Metric>
concept Has_enclosures = Answers_if_certain<Metric> &&
    requires(const Metric& c, const Diamond& d, const Indexed_face& face, std::uint32_t edge,
             const Diamond_values<Interval_nt<false>>& better,
             const Face_values<Interval_nt<false>>& better_face) {
  { c.certain_sign(d, Delaunay_expression()) } -> std::same_as<std::optional<Sign>>;
  { c.stored_weight(d, 1e-12) } -> std::same_as<std::optional<double>>;
  { c.is_narrow(face) } -> std::same_as<bool>;
  { c.is_narrow(edge) } -> std::same_as<bool>;
  { c.enclosure(d) } -> std::same_as<Diamond_values<Interval_nt<false>>>;
  c.enclosures(std::span(&face, 1));
  c.refine(d, better);
  c.refine(face, better_face);
  c.refine_length(edge, better.ij);
  c.remembered_signs();
  c.statistics();
};

// Has lambda lengths, and multiplies those of edges by factors of their vertices.
template <class Metric>
concept Scales_vertices = requires(Metric& m, std::span<const double> factors, std::uint32_t i) {
  m.set_factors(factors, factors);
  m.scale(i, i, i);
};

// Stores enclosures of lambda lengths, and takes better ones.
template <class Metric>
concept Has_lambda_enclosures = Answers_if_certain<Metric> && Scales_vertices<Metric> &&
    requires(const Metric& c, const Diamond& d, std::uint32_t edge) {
  { c.certain_delaunay_sign(c.values(d)) } -> std::same_as<std::optional<Sign>>;
  { c.is_narrow(edge) } -> std::same_as<bool>;
  c.refine(edge, c.before_flip(d));
  c.input_lambdas();
  c.remembered_signs();
  c.statistics();
};

// Any expressions are decided, by the metric or its decider.
template <class Metric>
concept Decides_signs = Decides_expressions<Metric> ||
    (Answers_if_certain<Metric> && !Scales_vertices<Metric>);

// Has no values of its own: those that flips make are none.
template <class Metric>
concept Stores_nothing = std::is_empty_v<typename Metric::Flipped> &&
    requires(const Metric& metric) {
  { metric.has_only_positive_areas() } -> std::same_as<bool>;
};

// There is a decider for what the metric leaves open.
template <class Metric>
concept Has_decider = Answers_if_certain<Metric> &&
    (Has_enclosures<Metric> || Has_lambda_enclosures<Metric> || Stores_nothing<Metric>);

// Measures the angles at an edge.
template <class Metric>
concept Measures_diamonds = Decides_expressions<Metric> &&
    requires(const Metric& c, const Diamond& d) {
  { c.cotangent_weight(d) } -> std::convertible_to<double>;
};

} // namespace internal

/*!
\brief requires the storage of a metric that decides flips, or answers what it is certain of.

Syntax of \ref ::IntrinsicMetric, which describes its meaning.
*/
template <class Metric>
concept IntrinsicMetric =
    (internal::Decides_flips<Metric> || internal::Has_decider<Metric>)&&std::default_initializable<
        Metric>&& std::movable<Metric>&& std::default_initializable<typename Metric::Scope>&& std::
        constructible_from<Metric, const Gluing_map&, const Input_metric&>&& requires(
            Metric& m, const Metric& c, const Diamond& d, typename Metric::Flipped values) {
  typename Metric::FT;
  { Metric::is_exact } -> std::convertible_to<bool>;
  { c.compute_flip(d) } -> std::same_as<std::optional<typename Metric::Flipped>>;
  { m.store_flip(d, std::move(values)) }
  noexcept;
  { c.scale_exponent() } -> std::same_as<int>;
};

/*!
\brief requires a metric with lengths, areas and angles.

Syntax of \ref ::EuclideanMetric, which describes its meaning.
*/
template <class Metric>
concept EuclideanMetric = IntrinsicMetric<Metric> &&
    (internal::Measures_diamonds<Metric> ||
     internal::Has_enclosures<Metric>)&&requires(const Metric& c, const Diamond& d,
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
                                     Vertex_move_values<typename Metric::FT> values,
                                     std::uint32_t count) {
  m.make_room(count, count);
  { m.insert_in_face(star, std::move(values)) }
  noexcept;
  { m.insert_in_border_edge(border, std::move(values)) }
  noexcept;
};

} // namespace internal

/*!
\brief requires a metric that follows the insertion and removal of vertices.

Syntax of \ref ::RefinableMetric, which describes its meaning.
*/
template <class Metric>
concept RefinableMetric = EuclideanMetric<Metric> && internal::Remembers_flips<Metric> &&
    internal::Stores_insertions<Metric> &&
    (internal::Measures_insertions<Metric> ||
     internal::Has_enclosures<Metric>)&&requires(const Metric& c, const Vertex_star& star,
                                                 const Border_star& border) {
  { c.removed_values(star) } -> std::same_as<typename Metric::Flipped>;
  { c.removed_values(border) } -> std::same_as<typename Metric::Flipped>;
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
