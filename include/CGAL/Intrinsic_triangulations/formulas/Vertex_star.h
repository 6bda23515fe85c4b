// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_STAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_STAR_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/*!
\file
New squared lengths and quadruple areas of insertions, removals and moves of vertices, in any field
(Eq. 23 of the course).
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief indexes the edges and faces at a vertex p of degree three, inside a face ijk.
*/
struct Vertex_star {
  std::array<std::uint32_t, 3> sides;  ///< the edges ij, jk, ki
  std::array<std::uint32_t, 3> spokes; ///< the edges ip, jp, kp
  std::array<std::uint32_t, 3> faces;  ///< the faces ijp, jkp, kip; the first one is ijk without p
};

/// returns the edges and the face of the face ijk without p, as if its first edge were flipped
/// between two such faces: a removal stores values there.
inline Diamond without_vertex(const Vertex_star& s) {
  const auto [ij, jk, ki] = s.sides;
  return {ij, jk, ki, jk, ki, s.faces[0], s.faces[0]};
}

/*!
\brief indexes the edges and faces at a vertex p on the border edge ij of a face ijk.
*/
struct Border_star {
  std::uint32_t ip; ///< the edge ip, which is ij without p
  std::uint32_t pj; ///< the edge pj
  std::uint32_t jk; ///< the edge jk
  std::uint32_t ki; ///< the edge ki
  std::uint32_t pk; ///< the edge pk
  std::uint32_t f;  ///< the face ipk, which is ijk without p
  std::uint32_t g;  ///< the face pjk
};

/// returns the edges and the face of the face ijk without p, see above.
inline Diamond without_vertex(const Border_star& s) {
  return {s.ip, s.jk, s.ki, s.jk, s.ki, s.f, s.f};
}

/*!
\brief rounds barycentric coordinates (down, the first one up) so that they are multiples of 2^-52
that sum to 1 exactly.

Then they define a point exactly, in any field.
\return the coordinates, or nothing if one is negative or not finite, all but one vanish, or the sum
  is not near 1
*/
std::optional<std::array<double, 3>> representable_weights(const std::array<double, 3>& weights);

/*!
\brief computes the squared distance of a point of a triangle ijk from its corner i.

With ij on an axis the point is at ((2 L_ij w_j + p_k w_k), a w_k) / (2 l_ij), p_k = L_ij + L_ki -
L_jk: a sum of squares, which loses nothing to cancellation.
\param ij squared length
\param jk squared length
\param ki squared length
\param area quadruple area
\param w_j weight of j
\param w_k weight of k
\pre `ij` is not zero
*/
template <FieldNumber FT>
FT squared_distance_from_corner(const FT& ij, const FT& jk, const FT& ki, const FT& area,
                                const FT& w_j, const FT& w_k) {
  const FT twice = ij + ij;
  const FT x = twice * w_j + (ij + ki - jk) * w_k;
  const FT y = area * w_k;
  return (x * x + y * y) / (twice + twice);
}

/*!
\brief holds the squared lengths of new edges and the quadruple areas of new faces, in the order of
`Vertex_star` or `Border_star`.
\tparam FT a model of `FieldNumber`
*/
template <FieldNumber FT>
struct Vertex_move_values {
  std::array<FT, 3> squared_lengths; ///< of ip, jp, kp; of ip, pj, pk
  std::array<FT, 3> quadruple_areas; ///< of ijp, jkp, kip; of ipk, pjk
};

/*!
\brief computes the values of the border edge ij and face ijk that remain after removal of a border
vertex p: as of a flip, for the edge and its only face.
\param d the diamond of pk, with face kip on its left
*/
template <FieldNumber FT>
Flipped_values<FT> removed_from_border_edge(const Diamond_values<FT>& d) {
  const FT area = d.area_f + d.area_g;
  return {flipped(d).km, area, area};
}

// ---- a flat vertex that moves among the faces about it (Eq. 8 of the course)

/*!
\brief indexes the edges and faces about a vertex in the interior, counterclockwise.
*/
struct Whole_star {
  std::vector<std::uint32_t> spokes; ///< the edges from the vertex
  std::vector<std::uint32_t> rim;    ///< the edge opposite the vertex in each face
  std::vector<std::uint32_t> faces;  ///< the face after each spoke
};

/*!
\brief holds values of a star, in its order.
\tparam FT a model of `FieldNumber`
*/
template <FieldNumber FT>
struct Whole_star_values {
  std::vector<FT> spokes; ///< squared lengths of the edges from the vertex
  std::vector<FT> rim;    ///< squared lengths of the edges opposite it
  std::vector<FT> areas;  ///< quadruple areas of the faces
};

/*!
\brief returns the values of a star.
\param lengths, areas those of all edges and faces, by number
\param s the star
*/
template <FieldNumber FT>
Whole_star_values<FT> gather(const std::vector<FT>& lengths, const std::vector<FT>& areas,
                             const Whole_star& s) {
  Whole_star_values<FT> v;
  for (std::size_t k = 0; k < s.faces.size(); ++k) {
    v.spokes.push_back(lengths[s.spokes[k]]);
    v.rim.push_back(lengths[s.rim[k]]);
    v.areas.push_back(areas[s.faces[k]]);
  }
  return v;
}

/*!
\brief computes what a star becomes when its vertex moves by b s_0 + c s_1, with s_k the vectors
along its spokes.

With the first spoke as unit all points are in the field: S_k = conj(s_0) s_k as complex numbers,
where conj(s_k) s_k+1 = (L_k + L_k+1 - R_k + i a_k) / 2. New squared lengths are sums of squares,
which lose nothing to cancellation.
\param v the values
\param b the part of the first spoke
\param c the part of the second one
\pre the vertex is flat, the spokes have lengths
\return the new values of spokes and areas; areas are negative where the rim is not seen from there
*/
template <FieldNumber FT>
Whole_star_values<FT> moved_in_star(const Whole_star_values<FT>& v, const FT& b, const FT& c) {
  const std::size_t n = v.spokes.size();
  std::vector<Plane_vector<FT>> s{{v.spokes[0], FT(0)}};
  for (std::size_t k = 0; k + 1 < n; ++k)
    s.push_back(s[k] * scaled_corner(v.spokes[k], v.rim[k], v.spokes[k + 1], v.areas[k]) /
                FT(v.spokes[k] + v.spokes[k]));
  const Plane_vector<FT> to{b * s[0].x + c * s[1].x, c * s[1].y};
  for (Plane_vector<FT>& p : s) p = p - to;
  Whole_star_values<FT> result{{}, v.rim, {}};
  for (std::size_t k = 0; k < n; ++k) {
    result.spokes.push_back(dot(s[k], s[k]) / v.spokes[0]);
    const FT half = cross(s[k], s[(k + 1) % n]) / v.spokes[0];
    result.areas.push_back(half + half);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_VERTEX_STAR_H
