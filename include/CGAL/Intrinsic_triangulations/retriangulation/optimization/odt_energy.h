// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_ENERGY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_ENERGY_H

#include <CGAL/Intrinsic_triangulations/triangulation/MeasuredTriangulation.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the energy that optimal Delaunay triangulations make least: the error of interpolating
|x|^2, integrated over the faces (Chen and Xu, Optimal Delaunay triangulations, 2004).

On a flat face the error is the sum of b_i b_j L_ij over its sides, in barycentric coordinates b, whose
integral is A (L_ij + L_jk + L_ki) / 12: the energy is intrinsic. Delaunay flips lower it, and so does
every vertex. For equilateral faces of total area A with sides l it is A l^2 / 4.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return the energy, in the units of the input to the fourth power
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
double odt_energy(const Triangulation& t) {
  const auto& mesh = t.mesh();
  double energy = 0;
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    double sum = 0;
    auto h = halfedge(f, mesh);
    for (int k = 0; k < 3; ++k, h = next(h, mesh))
      sum += t.metric().approximate_squared_length(t.index(edge(h, mesh)));
    energy += t.metric().approximate_quadruple_area(t.index(f)) * sum;
  }
  return std::ldexp(energy / 48, -4 * t.metric().scale_exponent());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_ENERGY_H
