// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The halfedge of the input that begins one of the user's triangles; on a cover, its front.
std::uint32_t first_side(const Input& input, std::uint32_t face) {
  const auto refuse = [face](const std::string& what) {
    throw Invalid_input::about(Element_kind::face, face, what);
  };
  const Input_names& names = input.names();
  std::uint32_t triangle = face;
  if (const std::vector<std::uint32_t>& polygon = names.polygon_of_triangle; !polygon.empty()) {
    const auto [begin, end] = std::equal_range(polygon.begin(), polygon.end(), face);
    if (end - begin > names.sheets)
      refuse(" is a polygon, in which barycentric coordinates name no point; triangulate it "
             "before");
    if (end == begin && face <= polygon.back())
      refuse(" has no three different vertices; choose another");
    triangle = end == begin ? Gluing::none : static_cast<std::uint32_t>(begin - polygon.begin());
  }
  if (triangle >= input.number_of_faces()) refuse(" does not exist; choose another");
  return input.halfedge_of_face(names.faces.here(triangle));
}

std::array<double, 3> normalized_weights(const Place& place) {
  std::array<double, 3> weights = place.weights;
  const double sum = weights[0] + weights[1] + weights[2];
  // false for what is not a number; weights that were rounded to single precision pass
  const bool are_weights =
      std::ranges::all_of(weights, [](double w) { return w >= 0; }) && std::abs(sum - 1) <= 1e-6;
  if (!are_weights)
    throw Invalid_input::about(Element_kind::face, place.face,
                               ": " + std::to_string(weights[0]) + ", " +
                                   std::to_string(weights[1]) + ", " + std::to_string(weights[2]) +
                                   " name no point of it; give three weights that are not negative "
                                   "and sum to 1");
  for (double& w : weights) w /= sum;
  return weights;
}

Surface_point turned(const Input& input, const Surface_point& p) {
  return {input.next(p.halfedge), {p.weights[1], p.weights[2], p.weights[0]}};
}

} // namespace

Surface_point with_one_name(const Input& input, const Surface_point& p) {
  return with_one_name(input, Tangent_vector{p, {0, 0}}).point;
}

Tangent_vector with_one_name(const Input& input, const Tangent_vector& v) {
  Surface_point p = v.point;
  unsigned side = 0;
  for (; side < 3 && p.weights[2] != 0; ++side) p = turned(input, p);
  if (side == 3 || corner_of(p) < 3) return v;
  const Unscaled_vector along = Geodesic_face(input, v.point.halfedge).relative_to(side, v.vector);
  if (p.halfedge % 2 == 0 || input.is_border(p.halfedge ^ 1U)) return {p, along};
  return {{p.halfedge ^ 1U, {p.weights[1], p.weights[0], 0}}, {-along[0], -along[1]}};
}

} // namespace internal

Place normalized(const Input& input, const Place& place) {
  if (place.is_vertex() && !place.has_face()) return place;
  std::uint32_t h = internal::first_side(input, place.face);
  Place result = Place::in_face(place.face, internal::normalized_weights(place));
  for (std::size_t k = 0; k < 3; ++k, h = input.next(h))
    if (result.weights[(k + 1) % 3] == 0 && result.weights[(k + 2) % 3] == 0)
      result.vertex = input.names().row(input.source(h));
  return result;
}

Surface_point point_on_input(const Input& input, const Place& place) {
  if (place.has_face()) return {internal::first_side(input, place.face), place.weights};
  const std::uint32_t h = input.outgoing_halfedge(input.names().vertex(place.vertex));
  return {input.is_border(h) ? input.next(h ^ 1U) : h, {1, 0, 0}};
}

} // namespace CGAL::Intrinsic_triangulations
