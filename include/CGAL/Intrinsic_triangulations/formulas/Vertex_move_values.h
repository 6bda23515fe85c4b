// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_MOVE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_MOVE_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>

#include <array>
#include <cstddef>

/*!
\file
What insertions and removals of vertices make, in any field.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the squared lengths of new edges and the quadruple areas of new faces, as far as there are
any, in the order of `Vertex_star` or `Border_star`.
\tparam FT a model of `Field`
*/
template <class FT>
struct Vertex_move_values {
  std::array<FT, 3> squared_lengths; ///< of ip, jp, kp; of ip, pj, pk; of ij
  std::array<FT, 3> quadruple_areas; ///< of ijp, jkp, kip; of ipk, pjk; of ijk
};

/*!
\brief computes the values at a vertex inserted in a face ijk.
\param face the face, from side ij
\param weights barycentric coordinates of the vertex
\pre no side has length zero
*/
template <class FT>
Vertex_move_values<FT> inserted_in_face(const Face_values<FT>& face,
                                        const std::array<double, 3>& weights) {
  Vertex_move_values<FT> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto side = [&](std::size_t l) { return face.squared_lengths[(k + l) % 3]; };
    const FT next(weights[(k + 1) % 3]), last(weights[(k + 2) % 3]);
    result.squared_lengths[k] =
        squared_distance_from_corner(side(0), side(1), side(2), face.quadruple_area, next, last);
    result.quadruple_areas[k] = last * face.quadruple_area;
  }
  return result;
}

/*!
\brief computes the values at a vertex inserted on the border edge ij of a face ijk.
\param face the face, from side ij
\param parameter weight of j
\pre ki does not have length zero
*/
template <class FT>
Vertex_move_values<FT> inserted_in_border_edge(const Face_values<FT>& face, double parameter) {
  const FT t(parameter), rest = FT(1) - t;
  const auto& [ij, jk, ki] = face.squared_lengths;
  const FT& area = face.quadruple_area;
  return {{t * t * ij, rest * rest * ij, squared_distance_from_corner(ki, ij, jk, area, rest, t)},
          {t * area, rest * area, FT(0)}};
}

/*!
\brief computes the values of the face that three faces at a vertex make together, which has their outer
sides.
*/
template <class FT>
Vertex_move_values<FT> removed_from_face(const FT& area_f, const FT& area_g, const FT& area_h) {
  return {{FT(0), FT(0), FT(0)}, {area_f + area_g + area_h, FT(0), FT(0)}};
}

/*!
\brief computes the values of the border edge and face that are left when a vertex on the border goes.
\param d the diamond of pk, with face kip on its left
*/
template <class FT>
Vertex_move_values<FT> removed_from_border_edge(const Diamond_values<FT>& d) {
  return {{flipped(d).km, FT(0), FT(0)}, {d.area_f + d.area_g, FT(0), FT(0)}};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_MOVE_VALUES_H
