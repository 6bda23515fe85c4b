// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/search/Length_classes.h>
#include <CGAL/Intrinsic_simplification/isometry/search/compare_sizes.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

bool have_sizes_far_apart(const Singular_surface& a, const Singular_surface& b) {
  constexpr int most_bits = 800; // squared lengths in common units do not overflow
  const int exponent = exponent_to_units_of(b, a);
  if (std::abs(exponent) <= most_bits) return false;
  // A surface fills its units up to a factor that is far below 2^800; areas tell even where flat
  // vertices could not be removed.
  const auto area = [](const Singular_surface& s) {
    double sum = 0;
    const Input_metric& metric = s.surface().metric();
    for (std::uint32_t f = 0; f < s.surface().number_of_faces(); ++f)
      sum += std::sqrt(std::max(metric.squared_quadruple_area<double>(f), 0.));
    return std::log2(sum);
  };
  return std::abs(area(b) + exponent - area(a)) > 1;
}

bool have_different_sizes(const Singular_surface& a, const Singular_surface& b) {
  // of the area and of the border
  const auto sizes = [](const Singular_surface& s, int exponent) {
    const Moved_triangulation& t = s.triangulation();
    Short_ball area(0), border(0);
    for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); ++h) {
      const Gluing_map::Halfedge side{h};
      if (t.mesh().is_removed(side)) continue;
      const Gluing_map::Face f = t.mesh().face(side);
      if (f.index == Gluing::none)
        border = border + sqrt(t.narrow_enclosure(t.length(h / 2)));
      else // of each face three sides
        area = area + t.narrow_enclosure(t.area(f.index));
    }
    return std::pair(area * Short_ball(std::ldexp(1.0, exponent)),
                     border * Short_ball(std::ldexp(1.0, exponent / 2)));
  };
  const auto differ = [](const Short_ball& x, const Short_ball& y) {
    const Uncertain<Sign> sign = (x - y).sign();
    return is_certain(sign) && get_certain(sign) != ZERO;
  };
  const auto first = sizes(a, 0), second = sizes(b, exponent_to_units_of(b, a));
  return differ(first.first, second.first) || differ(first.second, second.second);
}

} // namespace CGAL::Intrinsic_triangulations::internal
