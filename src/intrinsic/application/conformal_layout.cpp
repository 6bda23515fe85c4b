// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_layout.h"

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace program {

Laid_out shown_layout(const IT::Scaled_layout& layout, const std::vector<Point>& points,
                      Json& json) {
  json["mean_quasi_conformal"] = finite_or_null(layout.distortion.mean_quasi_conformal);
  json["max_quasi_conformal"] = finite_or_null(layout.distortion.maximum_quasi_conformal);
  const IT::Map_certificate& c = layout.certificate;
  json["injective"] = c.is_injective();
  json["locally_injective"] = c.is_locally_injective();
  json["flipped_faces"] = c.flipped;
  json["degenerate_faces"] = c.degenerate;
  const IT::Common_subdivision& s = layout.layout.subdivision;
  Laid_out result{{s, IT::positions(s, points), IT::fields_of_layout(layout.layout)},
                  {layout.closed, IT::positions(layout.closed, points), {}},
                  {}};
  for (const Eigen::Index k : {0, 1}) {
    std::vector<double> at_corners;
    for (const std::uint32_t v : s.corner) at_corners.push_back(layout.layout.positions(v, k));
    result.closed.fields.emplace_back(k == 0 ? "u" : "v", std::move(at_corners),
                                      IT::Subdivision_field::Place::corners);
  }
  for (const auto& [i, j] : layout.seams)
    result.seams.push_back({{points[i], points[j]}, false, 0});
  return result;
}

} // namespace program
