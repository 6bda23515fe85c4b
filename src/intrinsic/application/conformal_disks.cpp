// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_disks.h"
#include "../statistics.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

IT::Invalid_input no_disks(const std::string& what) {
  return IT::Invalid_input(IT::Element_kind::none, 0,
                           "--method conformal maps disks, but the surface " + what +
                               "; take intrinsic uniformize, with --cones where it asks for them");
}

// The front of a double, or all of a surface that is none: its faces in the order of the file, with
// the vertices of the file.
// \throws Invalid_input if front and back are one side
IT::Gluing front_of(const IT::Input& surface) {
  const IT::Gluing all = IT::gluing_from_map(surface.mesh());
  const IT::Input_names& names = surface.names();
  std::vector<std::uint32_t> number(all.origin.size(), IT::Gluing::none), sides;
  for (std::uint32_t user = 0; user < surface.number_of_faces(); user += names.sheets)
    for (std::uint32_t k = 0; k < 3; ++k) {
      sides.push_back(3 * names.faces.here(user) + k);
      number[sides.back()] = static_cast<std::uint32_t>(sides.size() - 1);
    }
  IT::Gluing front;
  front.number_of_vertices = static_cast<std::uint32_t>(surface.number_of_rows());
  for (const std::uint32_t h : sides) {
    front.origin.push_back(names.row(all.origin[h]));
    const std::uint32_t other = IT::Gluing::partner(all.glue[h]);
    front.glue.push_back(other == IT::Gluing::none ? other : number[other]);
    if (other != IT::Gluing::none && front.glue.back() == IT::Gluing::none && // but its own back
        names.faces.user(other / 3) / 2 != names.faces.user(h / 3) / 2)
      throw no_disks("is not an oriented manifold");
  }
  return front;
}

// A map between the vertices of the file, on its faces.
Laid_out on_mesh(const IT::Input& surface, const std::vector<Point>& points,
                 const Eigen::MatrixX2d& uv) {
  IT::Intrinsic_input in(IT::Gluing_map::from_valid(front_of(surface)), points,
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

void expect_disks(const IT::Input& surface) {
  if (surface.names().sheets > 2)
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "for a cloud of points only --method spectral works");
  const Input_facts facts = facts_of(IT::Gluing_map::from_valid(front_of(surface)));
  if (facts.nonmanifold_vertices > 0) throw no_disks("has parts that meet at a vertex only");
  if (facts.genus != 0) throw no_disks("has handles");
  if (facts.boundary_loops != facts.components)
    throw no_disks("has " + std::to_string(facts.boundary_loops) + " borders of " +
                   std::to_string(facts.components) + " components");
}

IT::Intrinsic_input double_of(const IT::Input& surface) {
  IT::Gluing g = IT::gluing_from_map(surface.mesh());
  for (std::uint32_t& v : g.origin) v = surface.names().row(v);
  IT::Intrinsic_input in;
  in.mesh = IT::Gluing_map::from_valid(g);
  in.squared_lengths.resize(in.mesh.number_of_edges());
  for (std::uint32_t f = 0; f < surface.number_of_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k)
      in.squared_lengths[in.mesh.sides({f})[k].index / 2] =
          std::ldexp(surface.squared_length(surface.mesh().sides({f})[k].index / 2),
                     -2 * surface.scale_exponent());
    in.names.polygon_of_triangle.push_back(surface.names().polygon(f));
  }
  in.mollification = IT::Mollification::none;
  in.may_renumber = false;
  return IT::make_domain(std::move(in), IT::Domain_kind::closed).input;
}

Computed map_of_disks(Computed computed, const IT::Input& surface,
                      const std::vector<Point>& points, bool is_on_mesh) {
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
  const std::vector<std::uint32_t> corners = front_of(surface).origin;
  for (std::size_t h = 0; h < corners.size(); h += 3)
    triangles.push_back({corners[h], corners[h + 1], corners[h + 2]});
  computed.json["injective_on_input"] = IT::certify_map(triangles, uv).is_injective();
  if (is_on_mesh) computed.laid_out = on_mesh(surface, points, uv);
  return computed;
}

} // namespace program
