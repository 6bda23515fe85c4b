// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RANGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RANGES_H

#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <charconv>
#include <limits>
#include <string>

/*!
\file
Which numbers options may have: one table for the program and for Python, with the names that they
have in Python. See `defaults.h` for those that they have if nothing else is asked for.

Up to 2^53 doubles have all whole numbers. A least angle of 60 degrees would allow only equilateral
triangles. More than 10,000 levels are a mistake, as of a length for a number; so are more than 999
directions at a vertex.
*/

namespace CGAL::Intrinsic_triangulations {

/// writes a number with as few digits as tell it from all others: what errors say of an option
inline std::string shortest_text(double x) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

/// The numbers that an option may have.
struct Number_range {
  double least = 0;         ///< the least of them
  double most = 0;          ///< the greatest of them
  bool is_whole = false;    ///< whether only whole numbers are
  bool is_positive = false; ///< whether `least`, which is 0, is none of them

  /// tells whether a number is one of them; NaN is none.
  bool contains(double x) const {
    return x >= least && x <= most && !(is_positive && x == 0) && (!is_whole || x == std::floor(x));
  }
  /// says which numbers these are, for messages.
  std::string description() const;
};

/// The numbers that options may have.
namespace ranges {

/// \cond
inline constexpr double any = std::numeric_limits<double>::infinity();
inline constexpr double finite = std::numeric_limits<double>::max();
inline constexpr double most_whole = 0x1p53;

// clang-format off
#define CGAL_INTRINSIC_TRIANGULATIONS_RANGES(is) \
  is(neighbors,        (Number_range{2, 1e9, true})) \
  is(sharp_angle,      (Number_range{0, 180})) \
  is(min_angle,        (Number_range{0, 59})) \
  is(max_circumradius, (Number_range{0, finite, false, true})) \
  is(max_edge_length,  (Number_range{0, finite, false, true})) \
  is(max_insertions,   (Number_range{0, most_whole, true})) \
  is(odt_length,       (Number_range{0, finite, false, true})) \
  is(heat_time,        (Number_range{0, finite})) \
  is(tolerance,        (Number_range{0, finite})) \
  is(max_vertices,     (Number_range{1, 1e9, true})) \
  is(time_factor,      (Number_range{0, finite, false, true})) \
  is(max_distance,     (Number_range{0, any})) \
  is(cell_tolerance,   (Number_range{0, finite, false, true})) \
  is(levels,           (Number_range{1, 10000, true})) \
  is(degree,           (Number_range{1, 999, true})) \
  is(align,            (Number_range{0, finite})) \
  is(count,            (Number_range{1, most_whole, true})) \
  is(stretch,          (Number_range{1, finite})) \
  is(within,           (Number_range{0, finite})) \
  is(flat_within,      (Number_range{0, 0.1}))
// clang-format on
#define CGAL_INTRINSIC_TRIANGULATIONS_RANGE(name, value) inline constexpr Number_range name = value;
CGAL_INTRINSIC_TRIANGULATIONS_RANGES(CGAL_INTRINSIC_TRIANGULATIONS_RANGE)
#undef CGAL_INTRINSIC_TRIANGULATIONS_RANGE
/// \endcond

} // namespace ranges

inline std::string Number_range::description() const {
  const std::string number = is_whole ? "whole number" : "number";
  const auto text = [](double x) {
    std::string digits = std::to_string(x); // all of the table have few
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  const std::string finite = is_whole || most == ranges::any ? "" : "finite ";
  if (is_positive) return "a " + finite + "positive " + number;
  if (!is_whole && least > 0 && most > 1e9) return "a " + finite + "number from " + text(least);
  if (most >= ranges::most_whole)
    return least == 0 ? "a " + finite + number + " that is not negative" : "a positive " + number;
  return "a " + number + " from " + text(least) + " to " + text(most);
}

/// reports all ranges by their names.
inline Report report_of_ranges() {
  Report report;
#define CGAL_INTRINSIC_TRIANGULATIONS_RANGE(name, value)                                           \
  report[#name] = {{"least", ranges::name.least},                                                  \
                   {"most", ranges::name.most},                                                    \
                   {"whole", ranges::name.is_whole},                                               \
                   {"positive", ranges::name.is_positive},                                         \
                   {"description", ranges::name.description()}};
  CGAL_INTRINSIC_TRIANGULATIONS_RANGES(CGAL_INTRINSIC_TRIANGULATIONS_RANGE)
#undef CGAL_INTRINSIC_TRIANGULATIONS_RANGE
  return report;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RANGES_H
