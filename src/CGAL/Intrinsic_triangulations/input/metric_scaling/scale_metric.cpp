// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Scaled_metric.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Plane_sides planar_sides(double L_ij, double L_jk, double L_ki) {
  if (L_ij == 0) return {{{0, 0}, {std::sqrt(L_jk), 0}, {-std::sqrt(L_ki), 0}}};
  const double squared_area = squared_quadruple_area(L_ij, L_jk, L_ki);
  return Intrinsic_triangulations::planar_sides(L_ij, L_jk, L_ki,
                                                squared_area > 0 ? std::sqrt(squared_area) : 0);
}

Plane_sides planar_sides(const Space_sides& s) {
  const double l = norm(s[0]);
  if (l == 0) return {{{0, 0}, {norm(s[1]), 0}, {-norm(s[2]), 0}}};
  const Space_vector<double> x{s[0][0] / l, s[0][1] / l, s[0][2] / l};
  const auto along = [&x](const Space_vector<double>& v) { return inner_product(x, v); };
  const auto across = [&x](const Space_vector<double>& v) { return norm(cross_product(x, v)); };
  return {{{l, 0}, {along(s[1]), across(s[1])}, {along(s[2]), -across(s[2])}}};
}

static void check_new_square(const Intrinsic_input& in, std::uint32_t e, double square) {
  const bool normal = std::isfinite(square) && (square >= std::numeric_limits<double>::min() ||
                                                (square == 0 && in.squared_lengths[e] == 0));
  if (normal) return;
  throw Invalid_input::about(
      Element_kind::edge, e,
      " between vertices " + std::to_string(in.mesh.source({2 * e}).index) + " and " +
          std::to_string(in.mesh.target({2 * e}).index) +
          " gets a length whose square is out of the range of doubles; scale less, "
          "or multiply all lengths by a constant");
}

Intrinsic_input scaled_input(Intrinsic_input&& in, std::vector<double> squared_lengths) {
  for (std::uint32_t e = 0; e < in.mesh.number_of_edges(); ++e)
    check_new_square(in, e, squared_lengths[e]);
  Intrinsic_input scaled(std::move(in.mesh), std::move(squared_lengths), in.mollification);
  scaled.mollification_amount = in.mollification_amount;
  scaled.triangulated_polygons = in.triangulated_polygons;
  scaled.reversed_faces = in.reversed_faces;
  return scaled;
}

Scaled_metric scale_conformally(Metric_source&& s, const std::vector<double>& u,
                                const Metric_scaling_options& options) {
  const Gluing_map& map = s.in.mesh;
  const Power_of_two unit(-s.scale_exponent);
  std::vector<double> squared_lengths(s.in.squared_lengths);
  for (std::uint32_t e = 0; e < map.number_of_edges(); ++e) {
    const double a = u[map.source({2 * e}).index], b = u[map.target({2 * e}).index];
    const double factor = unit(std::exp(a / 2 + b / 2));
    squared_lengths[e] = squared_lengths[e] * factor * factor;
  }
  return finish_scaling(scaled_input(std::move(s.in), std::move(squared_lengths)), options);
}

Plane_sides planar_sides_of_face(const Metric_source& s, std::uint32_t f, bool are_exact) {
  const std::array<std::uint32_t, 3> e = edges_of_face(s.in.mesh, f);
  const std::vector<double>& l = s.in.squared_lengths;
  if (are_exact && !squares_satisfy_triangle_inequality(l[e[0]], l[e[1]], l[e[2]]))
    throw Invalid_input::about(Element_kind::face, f,
                               " violates the triangle inequality before it is scaled; correct the "
                               "lengths of its edges");
  return planar_sides(l[e[0]], l[e[1]], l[e[2]]);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
