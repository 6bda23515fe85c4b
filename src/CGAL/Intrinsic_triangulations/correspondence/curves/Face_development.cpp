// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_development.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

std::optional<unsigned> Face_development::shared_corner(std::uint32_t triangle,
                                                        const Corner& c) const {
  for (unsigned m = 0; m < 3; ++m) {
    if (c.weights[m] != 1) continue;
    const Triangle_strips::Points points = triangles_.points(triangle);
    const auto p = std::find(points.begin(), points.end(), triangles_.points(c.triangle)[m]);
    if (p != points.end()) return static_cast<unsigned>(p - points.begin());
  }
  return std::nullopt;
}

boost::container::small_vector<std::uint32_t, 2> Face_development::children(std::uint32_t t) const {
  boost::container::small_vector<std::uint32_t, 2> result;
  const auto branch = static_cast<std::uint32_t>(along_) + 1;
  for (const std::uint32_t child : {t + 1, branch})
    if (child <= last() && triangles_.parent(child) == t) result.push_back(child);
  return result;
}

void Face_development::enter_back(const Input& input, const Vertex_fans& fans) {
  std::reverse(entered_.begin(), entered_.end());
  for (Crossing_run& run : entered_) run = run.reversed(fans);
  triangles_.enter(input, fans, region_at(first_, curves_.cutting[first_]), entered_);
}

bool Face_development::name_curve(std::uint32_t child, Face_region& r) const {
  const auto c = static_cast<Normal_coordinate>(child);
  const unsigned end = (first_ + 1) % 3, third = (first_ + 2) % 3;
  r = middle_region();
  r.is_on_curve = true;
  const Normal_coordinate cut_first = curves_.cutting[first_];
  const bool at_first = c <= cut_first,
             in_fan = !at_first && fan_ < 3 && c <= cut_first + curves_.emanating[fan_];
  r.corner = at_first ? first_ : in_fan ? fan_ : c <= along_ ? end : third;
  if (fan_ < 3)
    r.right_of_fan = at_first ? 0 : in_fan ? c - 1 - cut_first : curves_.emanating[fan_];
  if (!in_fan)
    r.cutting[r.corner] = at_first      ? c - 1
                          : c <= along_ ? along_ - c
                                        : along_ + curves_.cutting[third] - c;
  return at_first || in_fan;
}

} // namespace CGAL::Intrinsic_triangulations
