// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "conformal_disks.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace program {

namespace {

void expect_disks(const IT::Input& surface) {
  const Input_facts facts = facts_of(surface.mesh());
  std::string what;
  if (surface.names().sheets > 1)
    what = "is not an oriented manifold";
  else if (facts.nonmanifold_vertices > 0)
    what = "has parts that meet at a vertex only";
  else if (facts.genus != 0)
    what = "has handles";
  else if (facts.boundary_loops != facts.components)
    what.append("has ")
        .append(std::to_string(facts.boundary_loops))
        .append(" borders of ")
        .append(std::to_string(facts.components))
        .append(" components");
  if (!what.empty())
    throw std::runtime_error("--method conformal maps disks, but the surface " + what +
                             "; take intrinsic uniformize, with --cones where it asks for them");
}

} // namespace

IT::Intrinsic_input ideal_double(const IT::Input& surface) {
  expect_disks(surface);
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

Computed computed_of(const IT::Conformal_metric& metric, Laid_out laid_out, std::size_t vertices,
                     Json json) {
  json["status"] = name(metric.status);
  json["iterations"] = metric.iterations;
  json["residual"] = metric.residual;
  json["proven_residual"] =
      metric.proven_residual ? finite_or_null(*metric.proven_residual) : Json(nullptr);
  json["flips"] = metric.flips;
  const auto [least, largest] = std::minmax_element(metric.u.begin(), metric.u.end());
  json["least_u"] = *least;
  json["largest_u"] = *largest;
  json["max_scale_ratio"] = finite_or_null(std::exp(*largest - *least));
  Computed computed{"parametrize", std::move(json), {}};
  const Surface_with_fields& surface = laid_out.opened;
  for (std::size_t c = 0; c < 2; ++c) {
    const IT::Subdivision_field& field = surface.fields[c];
    Function& f = computed.functions.emplace_back();
    f.name = field.name;
    f.values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vertices));
    for (std::size_t v = 0; v < surface.s.vertices.size(); ++v)
      f.values[surface.s.vertices[v].on_input.vertices[0]] = field.values[v];
  }
  computed.is_map = true;
  computed.laid_out = std::move(laid_out);
  return computed;
}

} // namespace program
