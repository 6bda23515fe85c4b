// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_results.h"
#include "../statistics.h"
#include "application.h"
#include "cut.h"

#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// A map between the vertices of the file, on its faces.
Laid_out on_mesh(const IT::Input& surface, const std::vector<Point>& points,
                 const Eigen::MatrixX2d& uv) {
  IT::Intrinsic_input in(IT::Gluing_map::from_valid(IT::front_of(surface)), points,
                         IT::Mollification::none);
  in.may_renumber = false;
  for (std::uint32_t f = 0; f < in.mesh.number_of_faces(); ++f)
    in.names.polygon_of_triangle.push_back(
        surface.names().polygon(surface.names().faces.here(f * surface.names().sheets)));
  const std::vector<std::uint32_t> polygons = in.names.polygon_of_triangle;
  const Solved_triangulation<IT::Euclidean_traits<double>> mesh(std::move(in));
  Surface_with_fields result{IT::common_subdivision(mesh), points, {}};
  IT::label_with_polygons(result.s, polygons);
  for (const Eigen::Index c : {0, 1})
    result.fields.emplace_back(c == 0 ? "u" : "v", Eigen::VectorXd(uv.col(c)));
  return {result, result};
}

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

Computed map_of_disks(Computed computed, const IT::Input& surface, const std::vector<Point>& points,
                      bool is_on_mesh) {
  computed.command = "parametrize";
  computed.timed = Computed().timed;
  const Surface_with_fields& opened = computed.laid_out->opened;
  Eigen::MatrixX2d uv =
      Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(surface.number_of_rows()), 2);
  for (std::size_t v = 0; v < opened.s.vertices.size(); ++v)
    if (opened.s.kind(v) == IT::Subdivision_vertex_kind::input)
      for (const Eigen::Index c : {0, 1})
        uv(opened.s.vertices[v].on_input.vertices[0], c) =
            opened.fields[static_cast<std::size_t>(c)].values[v];
  computed.functions = {{"u", uv.col(0)}, {"v", uv.col(1)}};
  computed.is_map = true;
  computed.json["method"] = "conformal";
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::vector<std::uint32_t> corners = IT::front_of(surface).origin;
  for (std::size_t h = 0; h < corners.size(); h += 3)
    triangles.push_back({corners[h], corners[h + 1], corners[h + 2]});
  computed.json["injective_on_input"] = IT::certify_map(triangles, uv).is_injective();
  if (is_on_mesh) computed.laid_out = on_mesh(surface, points, uv);
  return computed;
}

Laid_out shown_layout(const IT::Scaled_layout& layout, const std::vector<Point>& points,
                      Json& json) {
  json["mean_quasi_conformal"] = layout.distortion.mean_quasi_conformal;
  json["max_quasi_conformal"] = layout.distortion.maximum_quasi_conformal;
  json["min_area_ratio"] = layout.distortion.minimum_area_ratio;
  json["max_area_ratio"] = layout.distortion.maximum_area_ratio;
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
  const std::vector<IT::Subdivision_field>& fields = result.opened.fields;
  result.closed.fields = {fields[0], fields[1]}; // u and v
  take_to_corners(s, result.closed.fields);
  for (const auto& [i, j] : layout.seams)
    result.seams.push_back({{points[i], points[j]}, false, 0});
  return result;
}

} // namespace program
