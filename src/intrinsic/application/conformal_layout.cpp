// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_layout.h"

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace program {

namespace {

// What Poincaré's disk has besides: orientations with geodesic sides, and the group.
void report_disk(const IT::Scaled_layout& layout, Json& json) {
  const IT::Side_pairings& pairings = layout.layout.pairings;
  json["flipped_geodesic_faces"] = layout.flipped_geodesic_triangles;
  json["radius"] = layout.layout.radius;
  json["seam_error"] = pairings.largest_seam_error;
  json["relation_error"] = pairings.largest_relation_error;
  Json motions = Json::array();
  for (const IT::Disk_seam& seam : pairings.seams)
    motions.push_back(
        {seam.motion.a.real(), seam.motion.a.imag(), seam.motion.b.real(), seam.motion.b.imag()});
  json["generators"] = std::move(motions);
}

} // namespace

Laid_out shown_layout(const IT::Scaled_layout& layout, const std::vector<Point>& points,
                      Json& json) {
  json["mean_quasi_conformal"] = finite_or_null(layout.distortion.mean_quasi_conformal);
  json["max_quasi_conformal"] = finite_or_null(layout.distortion.maximum_quasi_conformal);
  json["min_area_ratio"] = finite_or_null(layout.distortion.minimum_area_ratio);
  json["max_area_ratio"] = finite_or_null(layout.distortion.maximum_area_ratio);
  const IT::Map_certificate& c = layout.certificate;
  json["injective"] = c.is_injective();
  json["locally_injective"] = c.is_locally_injective();
  json["border_is_simple"] = c.border_is_simple;
  json["flipped_faces"] = c.flipped;
  json["degenerate_faces"] = c.degenerate;
  json["without_area"] = layout.without_area;
  if (layout.layout.is_hyperbolic) report_disk(layout, json);
  const IT::Common_subdivision& s = layout.layout.subdivision;
  Laid_out result{{s, IT::positions(s, points), IT::fields_of_layout(layout.layout)},
                  {layout.closed, IT::positions(layout.closed, points), {}},
                  {},
                  layout.layout.is_hyperbolic};
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
