// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/queries/Curve_inserter.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

Unscaled_vector Laid_out_line::vector(std::size_t first, std::size_t last) const {
  Unscaled_vector sum{0, 0};
  Plane_vector<double> x{1, 0}; // the x-axis of the frame
  for (std::size_t i = first; i < last; ++i) {
    if (i > first && !turn(i, x)) break;
    const Unscaled_vector v = piece(i);
    sum = {sum[0] + x[0] * v[0] - x[1] * v[1], sum[1] + x[0] * v[1] + x[1] * v[0]};
  }
  return sum;
}

double Laid_out_line::length(std::size_t first, std::size_t last) const {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    const Unscaled_vector v = piece(i);
    sum += std::hypot(v[0], v[1]);
  }
  return sum;
}

Surface_point Laid_out_line::point(std::size_t i, std::size_t piece) const {
  constexpr double nearness = 0x1p-31; // of vertices that a line inserter passes, see there
  Surface_point p = seen_in_face(input_, curve_.points[i], curve_.faces[piece]);
  const bool is_end = i == 0 || i + 1 == curve_.points.size(); // where a vertex may be inserted
  for (std::size_t k = 0; k < 3 && !is_end; ++k)
    if (p.weights[k] >= 1 - nearness) {
      p.weights = {0, 0, 0};
      p.weights[k] = 1;
    }
  return p;
}

Unscaled_vector Laid_out_line::piece(std::size_t i) const {
  return vector_between(input_, point(i, i), point(i + 1, i));
}

static Plane_vector<double> edge_in_frame(const Input& input, std::uint32_t h, std::uint32_t f) {
  const Geodesic_face face(input, input.halfedge_of_face(f));
  return face.edge[face.side[0] == h ? 0 : face.side[1] == h ? 1 : 2];
}

// From the frame of the face before point i to that of the face after it. False if they are not
// adjacent there.
bool Laid_out_line::turn(std::size_t i, Plane_vector<double>& x) const {
  if (curve_.faces[i - 1] == curve_.faces[i]) return true;
  const Surface_point p = point(i, i - 1);
  std::uint32_t h = p.halfedge;
  for (unsigned k = 0; k < 3; ++k, h = input_.next(h)) {
    if (p.weights[(k + 2) % 3] != 0 || input_.is_border(h ^ 1U) ||
        input_.face(h ^ 1U) != curve_.faces[i])
      continue;
    const Plane_vector<double> a = edge_in_frame(input_, h, curve_.faces[i - 1]),
                               b = edge_in_frame(input_, h ^ 1U, curve_.faces[i]);
    // the turn from -b to a
    const double c = -dot(a, b), s = cross(a, b), l = std::hypot(c, s);
    x = {(x[0] * c - x[1] * s) / l, (x[0] * s + x[1] * c) / l};
    return true;
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
