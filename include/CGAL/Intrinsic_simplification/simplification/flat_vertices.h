// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether the angles of a wedge that sum to nearly 2 pi, on the border to nearly pi, do so exactly.
template <class Triangulation>
bool is_flat_wedge(const Triangulation& t, const Wedge& wedge, bool is_on_border) {
  if (t.sign(wedge.all_faces(), Wedge_sine_expression{wedge.all_scales()}) != ZERO) return false;
  return t.sign(wedge.all_faces(), Wedge_cosine_expression{wedge.all_scales()}) ==
         (is_on_border ? NEGATIVE : POSITIVE);
}

// Whether a vertex that is nearly flat is exactly flat.
template <class Triangulation>
bool is_flat(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  [[maybe_unused]] const typename Triangulation::Const_session session(t); // for signs
  const auto& mesh = t.mesh();
  // to the vertex; on the border the one after which corners begin
  const auto first = halfedge(v, mesh);
  const bool is_on_border = CGAL::is_border(first, mesh);
  Wedge wedge;
  auto h = is_on_border ? opposite(next(first, mesh), mesh) : first;
  const auto before = h;
  do {
    // `h` runs to the vertex, with the corner on its left
    if (CGAL::is_border(h, mesh)) break;
    const auto out = next(h, mesh);
    const auto number = [&](auto g) { return t.numbers().halfedge(g) / 2; };
    const Indexed_face f{t.numbers().face(face(h, mesh)),
                         {number(out), number(next(out, mesh)), number(h)}};
    wedge.add(f, near_values(t, f));
    h = opposite(out, mesh);
  } while (h != before);
  return is_flat_wedge(t, wedge, is_on_border);
}

// For each vertex, in the order of the mesh, whether it is flat to within an angle.
// \throws Invalid_input if the angle is negative
template <class Triangulation>
std::vector<char> flat_vertices(const Triangulation& t, double within) {
  if (!(within >= 0))
    throw Invalid_input(Element_kind::none, 0,
                        "an angle within which vertices are flat is not negative, as " +
                            std::to_string(within) + " is");
  constexpr double nearly = 1e-6; // above the rounding of angles
  std::vector<char> result;
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    const double k =
        halfedge(v, t.mesh()) == null ? 8 : std::abs(gaussian_curvature(t, v)); // 8: isolated
    result.push_back((within > 0 && k <= within) || (k <= nearly && is_flat(t, v)) ? 1 : 0);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FLAT_VERTICES_H
