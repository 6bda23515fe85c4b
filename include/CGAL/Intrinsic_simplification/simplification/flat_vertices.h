// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H

#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Decides at which vertices the angles of the faces of an input sum to exactly 2 pi, on the border to
exactly pi. Moves of a triangulation do not change these sums.

Intervals tell most vertices from flat ones. The others are decided in integers, without any other
proof. Let the corners at a vertex be arguments of z = p + i sqrt(D), where p = L_ij + L_ki - L_jk
and D = 16 A^2 are rational. All D whose products are squares of rationals form a class, with a
representative d; the product of the z of a class is a number of the field of sqrt(-d).

Theorem. The angles sum to a multiple of pi iff those of each class sum to a multiple of pi / 2, or
for d = 1 of pi / 4, and all together to a multiple of pi.

Proof. For a class j let u_j be the product of its z, divided by the conjugate number: its argument
is twice the sum of the angles, and its norm is 1. Let the product of all u_j be 1. A symmetry s of
the field of all sqrt(-d_j) takes u_j to itself or its conjugate 1 / u_j, by the sign c_j(s) of what
it makes of sqrt(-d_j). So the product of all u_j to the power c_j(s) is 1, too. To the power
c_i(s), and multiplied over all s, it is u_i to the number of symmetries, a power of 2: the classes
differ, and so do the characters c_j, which are orthogonal. So u_i is a root of unity in a field of
one imaginary square root, whose order is a power of 2: 1, -1, or if d_i = 1 also i, -i. []

Angles are positive, so that a flat vertex has at most four classes beside d = 1, on the border
two; an accurate sum of the angles in doubles tells which multiple of pi / 4 is theirs. So the time
is nearly linear in the degree.
*/
// \param corners the vertex at the source of each side of each face
// \param half_turns for each vertex, the multiple of pi that makes it flat; 0: nothing does
std::vector<char> flat_vertices(const Input_metric& metric, std::span<const std::uint32_t> corners,
                                std::span<const std::uint8_t> half_turns);

// The same for a surface. Isolated vertices, and those that join several fans of faces, are not
// flat.
std::vector<char> flat_vertices(const Input& surface);

// By the number of the vertex. \throws Invalid_input if the corners of input faces are unknown
template <class Triangulation>
std::vector<char> flat_input_vertices(const Triangulation& t) {
  if (const Input* surface = t.input().surface()) return flat_vertices(*surface);
  const Input_metric& metric = t.input().metric();
  if (!metric.is_embedded())
    throw Invalid_input(Element_kind::none, 0,
                        "without correspondence and points, the angles of the input are unknown; "
                        "use a triangulation with correspondence, such as "
                        "Corresponding_triangulation");
  std::vector<std::uint32_t> corners;
  for (std::uint32_t f = 0; f < metric.number_of_faces(); ++f)
    corners.insert(corners.end(), metric.sides(f).begin(), metric.sides(f).end());
  const auto& mesh = t.mesh();
  const std::vector<std::uint32_t> fans = umbrellas(mesh);
  std::vector<std::uint8_t> half_turns(t.input().number_of_vertices(), 0);
  auto fan = fans.begin();
  for (const typename Triangulation::vertex_descriptor v : vertices(mesh))
    if (*fan++ == 1 && !t.is_inserted(v))
      half_turns[t.index(v)] = CGAL::is_border(halfedge(v, mesh), mesh) ? 1 : 2;
  return flat_vertices(metric, corners, half_turns);
}

// For each vertex, in the order of the mesh, whether it is flat to within an angle.
// \throws Invalid_input if the angle is out of range, or see above
template <class Triangulation>
std::vector<char> flat_vertices(const Triangulation& t, double within) {
  if (!ranges::within.contains(within))
    throw Invalid_input(Element_kind::none, 0,
                        "the angle within which vertices are flat is " + shortest_text(within) +
                            "; give " + ranges::within.description() + ", in radians");
  const std::vector<char> is_flat = flat_input_vertices(t);
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
  std::vector<char> result;
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    const bool is_nearly_flat =
        within > 0 && halfedge(v, t.mesh()) != null && std::abs(gaussian_curvature(t, v)) <= within;
    // an inserted vertex is in a face or on an edge of the input
    result.push_back(is_nearly_flat || t.is_inserted(v) || is_flat[t.index(v)] != 0 ? 1 : 0);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H
