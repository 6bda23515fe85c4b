// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_disks.h"
#include "../statistics.h"
#include "application.h"

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

} // namespace program
