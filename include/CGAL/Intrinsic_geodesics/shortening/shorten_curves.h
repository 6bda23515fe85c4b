// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SHORTENING_SHORTEN_CURVES_H
#define CGAL_INTRINSIC_GEODESICS_SHORTENING_SHORTEN_CURVES_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/shortening/Curve_shortener.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief observes shortening; the default visitor does nothing.
*/
struct Shortening_visitor {
  /*!
  \brief is called about every 1024 joints, and now and then during searches for shortest paths.
  \return whether to go on
  */
  bool progress(const Shortening_result&) { return true; }
};

namespace internal {

// Calls another visitor: what it observes is compiled once for all visitors.
struct Any_shortening_visitor {
  std::function<bool(const Shortening_result&)> go_on;
  bool progress(const Shortening_result& r) { return go_on(r); }
};

template <class Triangulation>
std::uint64_t default_cap(const Triangulation& t) {
  return Triangulation::Metric::is_exact ? std::numeric_limits<std::uint64_t>::max()
                                         : flip_cap(num_edges(t.mesh()));
}

template <class Triangulation, class NamedParameters>
std::uint64_t maximum_flips(const Triangulation& t, const NamedParameters& np) {
  return value_or<tags::maximum_number>(np, default_cap(t));
}

// \tparam More names that a function has beside those of `shorten_curves()`
template <class... More, class NamedParameters>
constexpr void expect_shortening_names(const NamedParameters& np) {
  expect_names<tags::relative_length, tags::minimum_joint_angle, tags::maximum_number,
               tags::visitor, More...>(np);
}

template <class Triangulation, class NamedParameters>
Shortening_limits shortening_limits(const Curve_network<Triangulation>& network,
                                    const NamedParameters& np) {
  const Triangulation& t = network.triangulation();
  Shortening_limits limits;
  const double part = value_or<tags::relative_length>(np, 0.);
  if (!(part >= 0 && part <= 1)) throw std::invalid_argument("relative_length must be in [0, 1]");
  const double angle = value_or<tags::minimum_joint_angle>(np, 180.);
  if (!(angle >= 0 && angle <= 180))
    throw std::invalid_argument("minimum_joint_angle must be in [0, 180] degrees");
  if (part > 0) limits.length = std::ldexp(part * network.length(), t.metric().scale_exponent());
  const double radians = angle * std::numbers::pi / 180;
  if (angle < 180) limits.rank = Angle_sum::rank(std::cos(radians), std::sin(radians));
  // with inexact numbers, rounding may make curves go round without a flip
  limits.shortenings = default_cap(t);
  limits.flips = maximum_flips(t, np);
  return limits;
}

template <class Triangulation>
Shortening_result shorten(Curve_network<Triangulation>& network, Flip_log<Triangulation>* log,
                          const Shortening_limits& limits,
                          const std::function<bool(const Shortening_result&)>& go_on) {
  typename Triangulation::Session session(network.triangulation());
  return Curve_shortener<Triangulation>(network, session, log).run(limits, go_on);
}

template <class Triangulation, class NamedParameters>
Shortening_result shorten_curves(Curve_network<Triangulation>& network,
                                 Flip_log<Triangulation>* log, const NamedParameters& np) {
  auto stored_visitor = object_or<tags::visitor>(np, Shortening_visitor());
  auto& observed = unwrapped(stored_visitor);
  return shorten(network, log, shortening_limits(network, np),
                 [&](const Shortening_result& r) { return observed.progress(r); });
}

} // namespace internal

/*!
\brief makes the curves of a network geodesic by flips (FlipOut, §5.1 and §5.2 of the course,
  Algorithms 6 and 7).

Flips create edges along shorter curves. Curves move continuously without crossing: they go around
ends and fixed vertices of other curves, and around the border. At the end each free joint has an
angle of at least pi on both sides, except on sides where a curve or the border is; an angle of
exactly pi is straight. A loop that can shrink to a vertex ends there: `Curve_network::is_point()`.

With exact traits it terminates, also for loops of one edge: the length of all curves decreases in
every step, and there are finitely many geodesic edges below a length. With inexact traits a joint
without gain counts as straight, and caps on the numbers of flips and of shortenings ensure the end.

\tparam Triangulation a model of `GeodesicTriangulation`
\tparam NP a chain of named parameters
\param network the curves
\param np optional named parameters:
  - `relative_length(x)`: stops when the length of all curves is at most x times the initial length;
    until then the curves follow a flow that shortens them (Fig. 37 of the course). Default: 0.
  - `minimum_joint_angle(x)`: stops when all joints that can be straightened have at least this
    angle, in degrees. Default: 180.
  - `maximum_number(n)`: cap on the number of flips. Default: none if the traits are exact, else 100
    per edge and a million.
  - `visitor(v)`: see `Shortening_visitor`
\return counts, and the status: `done`, `stopped`, `cancelled`, `cap`; `stalled` if faces without
  area stop all gain: flips may not open their angles of zero. `Mollification::automatic` leaves no
  such face
\throws std::invalid_argument if a parameter is out of its range
\complexity linear in the number of flips, times the logarithm of the number of joints; the
  literature has no bound on the number of flips
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Shortening_result shorten_curves(Curve_network<Triangulation>& network,
                                 const NP& np = parameters::default_values()) {
  internal::expect_shortening_names(np);
  return internal::shorten_curves(network, static_cast<Flip_log<Triangulation>*>(nullptr), np);
}

/*!
\brief makes the curves of a network geodesic by flips that can be undone; see the overload without
log.
\param network the curves; they must be cleared before `log.undo()`
\param log remembers the flips
\param np see the overload without log
*/
template <GeodesicTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Shortening_result shorten_curves(Curve_network<Triangulation>& network,
                                 Flip_log<Triangulation>& log,
                                 const NP& np = parameters::default_values()) {
  internal::expect_shortening_names(np);
  return internal::shorten_curves(network, &log, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SHORTENING_SHORTEN_CURVES_H
