// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

double Multiple_of_pi::radians() const {
  return static_cast<double>(numerator) * std::numbers::pi / static_cast<double>(denominator);
}

Prescribed_angles::Prescribed_angles(const std::vector<double>& radians) : angles_(radians.size()) {
  for (std::size_t v = 0; v < radians.size(); ++v) set(v, radians[v]);
}

namespace internal {

namespace {

// The angles of one component.
struct Component_angles {
  std::size_t first = 0;      // vertex
  std::size_t count = 0;      // of vertices
  std::size_t full_turns = 0; // of them: the default angle
  bool has_free = false, is_rational = true;
  CGAL::Gmpq multiples = 0; // of pi
  double radians = 0;       // of the others
  double rounded = 0;       // what rounding took from that sum

  void add(double angle) { // both parts are exact: Knuth's sum
    const double sum = radians + angle, part = sum - radians;
    rounded += (radians - (sum - part)) + (angle - part);
    radians = sum;
  }
};

void expect_positive(const Prescribed_angles& angles, std::size_t v) {
  const bool is_positive =
      angles.is_multiple(v) ? angles.multiple(v).numerator > 0 && angles.multiple(v).denominator > 0
                            : angles.radians(v) > 0 && std::isfinite(angles.radians(v));
  if (!is_positive)
    throw Invalid_input::about(Element_kind::vertex, v,
                               ": its angle is not positive; give a positive number of radians");
}

std::vector<Component_angles> angle_sums(const Prescribed_angles& angles,
                                         const std::vector<std::uint32_t>& component,
                                         std::size_t components) {
  if (angles.size() != component.size())
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(angles.size()) + " angles for " +
                            std::to_string(component.size()) +
                            " vertices; give one number per vertex, in the order of the mesh");
  std::vector<Component_angles> sums(components);
  for (std::size_t v = 0; v < angles.size(); ++v) {
    if (component[v] == Gluing::none) continue;
    Component_angles& sum = sums[component[v]];
    if (sum.count++ == 0) sum.first = v;
    if (angles.is_free(v)) {
      sum.has_free = true;
      continue;
    }
    expect_positive(angles, v);
    if (!angles.is_multiple(v)) {
      sum.is_rational = false;
      sum.add(angles.radians(v));
    } else if (const Multiple_of_pi m = angles.multiple(v); m == Multiple_of_pi()) {
      ++sum.full_turns;
    } else {
      sum.multiples = sum.multiples + CGAL::Gmpq(static_cast<double>(m.numerator)) /
                                          CGAL::Gmpq(static_cast<double>(m.denominator));
    }
  }
  for (Component_angles& sum : sums)
    sum.multiples = sum.multiples + CGAL::Gmpq(2 * static_cast<double>(sum.full_turns));
  return sums;
}

// By how much a sum is larger than that of a flat surface of so many faces.
struct Excess {
  double radians;
  int sign; // zero if the sum is that one, up to rounding

  Excess(const Component_angles& sum, std::size_t faces, std::uint32_t sheets) {
    const CGAL::Gmpq needed =
        CGAL::Gmpq(static_cast<double>(faces)) / CGAL::Gmpq(static_cast<double>(sheets));
    const CGAL::Gmpq rest = sum.multiples - needed;
    radians = CGAL::to_double(rest) * std::numbers::pi + sum.radians + sum.rounded;
    // Sixteen units in the last place of each angle: of those the user's program rounded.
    const double total = CGAL::to_double(needed) * std::numbers::pi;
    const bool is_zero = std::abs(radians) <= total * 0x1p-48;
    sign = static_cast<int>(sum.is_rational ? CGAL::sign(rest) : CGAL::sign(is_zero ? 0 : radians));
  }
};

[[noreturn]] void throw_gauss_bonnet(const Component_angles& sum, double excess,
                                     std::size_t components) {
  std::ostringstream message;
  message.precision(std::numeric_limits<double>::max_digits10);
  message << "the angles of the component of vertex " << sum.first
          << " break the theorem of Gauss and Bonnet: their sum is too "
          << (excess > 0 ? "large" : "small") << " by " << std::abs(excess) << " radians ("
          << std::abs(excess) / std::numbers::pi << " pi); ";
  if (sum.full_turns == sum.count) // the default, perhaps not asked for
    message << "with full turns everywhere only tori are flat: give it cones"
            << (components > 1
                    ? ", or take the " + std::to_string(components) + " components one by one"
                    : "");
  else
    message << "change the angles of some vertices by that much in all, or let the border be free";
  throw Invalid_input(Element_kind::vertex, sum.first, message.str());
}

} // namespace

std::vector<double> checked_gauss_bonnet(const Prescribed_angles& angles,
                                         const std::vector<std::uint32_t>& component,
                                         const std::vector<std::size_t>& faces,
                                         std::uint32_t sheets) {
  std::vector<double> correction(faces.size(), 0);
  const std::vector<Component_angles> sums = angle_sums(angles, component, faces.size());
  for (std::size_t c = 0; c < faces.size(); ++c) {
    const Component_angles& sum = sums[c];
    if (sum.has_free || sum.count == 0) continue;
    const Excess excess(sum, faces[c], sheets);
    if (excess.sign != 0) throw_gauss_bonnet(sum, excess.radians, faces.size());
    if (!sum.is_rational) correction[c] = -excess.radians / static_cast<double>(sum.count);
  }
  return correction;
}

void check_hyperbolic_angles(const Prescribed_angles& angles,
                             const std::vector<std::uint32_t>& component,
                             const std::vector<std::size_t>& faces, std::uint32_t sheets) {
  const std::vector<Component_angles> sums = angle_sums(angles, component, faces.size());
  for (std::size_t c = 0; c < faces.size(); ++c) {
    if (sums[c].has_free || sums[c].count == 0) continue;
    const Excess excess(sums[c], faces[c], sheets);
    if (excess.sign < 0) continue;
    std::ostringstream message;
    message.precision(std::numeric_limits<double>::max_digits10);
    message
        << "the component of vertex " << sums[c].first
        << " has no hyperbolic metric with these angles: by the theorem of Gauss and Bonnet its "
           "area would be ";
    if (excess.sign == 0)
      message << "0, as it is flat; take the target plane, or torus,";
    else
      message << -excess.radians << " (" << -excess.radians / std::numbers::pi
              << " pi); take the target sphere, if there are no cones,";
    message << " or give cones with smaller angles";
    throw Invalid_input(Element_kind::vertex, sums[c].first, message.str());
  }
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
