// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SUBDIVISION_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SUBDIVISION_H

#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/overlay_subdivisions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Layouts in the plane of the common subdivision of a mesh and a flat or hyperbolic intrinsic
triangulation. Seams are edges of the mesh, so that each corner of the mesh has one place.

If the flat metric is discretely conformal to that of the mesh, with lengths
\f$\lambda_{ij} w_i w_j\f$, the layout is the map by *projective interpolation* (Springborn,
Schröder, Pinkall, Conformal equivalence of triangle meshes, 2008; Gillespie, Springborn, Crane,
Discrete conformal equivalence of polyhedral surfaces, 2021): on each face of the subdivision the
homogeneous coordinates (x q, y q, q) of the plane are linear functions on the face of the mesh. At
a vertex q is \f$1 / w_i^2\f$. Vertices are light-like vectors \f$v_i\f$ with \f$-2 \langle v_i, v_j
\rangle = \lambda_{ij}^2\f$, and the factors change their lengths: \f$v_i' = w_i^2 v_i\f$. A point
\f$X = (1 - p) v_i + p v_j\f$ of an edge has \f$-\langle X, X \rangle = p (1 - p) \lambda_{ij}^2\f$,
from which q follows at crossings. Both faces beside an edge give the same points there, so that the
map is continuous.

A hyperbolic triangle has corners P_i in the hyperboloid model, with
\f$\langle P_i - P_j, P_i - P_j \rangle = \lambda_{ij}^2\f$. So its plane is that of the vectors
\f$v_i'\f$ but for a motion, and the same sums of corners are the points of the map:
\f$(1 - p) P_i + p P_j\f$ on an edge. Linear on the faces of the mesh are q times the points of the
hyperboloid, which are homogeneous coordinates in Klein's model.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds what `lay_out_subdivision()` needs, as arrays.
*/
struct Flat_subdivision {
  /// \brief The common subdivision of the mesh and the flat triangulation.
  ///
  /// Places of crossings on the mesh are those in its metric; places on the triangulation are those
  /// in the flat metric: in a conformal metric, with its scaled vectors.
  const Common_subdivision& subdivision;
  /// The flat triangulation, with its lengths and `side`; or hyperbolic triangles with theirs.
  const Surface_to_cut& flat;
  /// Nonzero for each edge of the input, by its number there, that is cut.
  const std::vector<char>& is_cut;
  /// Nonzero for each face of the input, as `Common_subdivision::input_face` names it, that is laid
  /// out: half of a doubled surface. Empty: all are.
  std::vector<char> is_wanted{};
  /// The factor w of each vertex of `flat.gluing`. Empty: all are 1.
  std::vector<double> factors{};
  /// The length of each edge of the input, before scaling. Empty: weights are not computed.
  std::vector<double> input_lengths{};
  /// Whether triangles are hyperbolic, with hyperbolic lengths as of `hyperbolic_surface()`.
  bool is_hyperbolic = false;
  /// Nonzero for each vertex of `flat.gluing` that is a cone; seams end there if the surface is
  /// hyperbolic. Empty: none is.
  std::vector<char> is_cone{};
  /// \brief The pieces to lay out, if the flat triangulation started from another triangulation
  /// than that of the mesh.
  ///
  /// That one is then the input of `subdivision`, of which `input_lengths` are; and this is the
  /// overlay of its subdivision with the mesh and `subdivision`. Cuts and wanted faces are those of
  /// the mesh. Null: the input of `subdivision` is the mesh.
  const Overlaid_subdivision* overlay = nullptr;
};

/*!
\brief is the layout of a common subdivision in the plane.
*/
struct Subdivision_layout {
  /// The faces that are laid out, cut open: each copy of a vertex is a vertex of its own.
  Common_subdivision subdivision;
  /// The vertex before the cut of each vertex.
  std::vector<std::uint32_t> original_vertex;
  /// The face before that each face is.
  std::vector<std::uint32_t> original_face;
  /// The place of each vertex of `subdivision` in the plane, where components lie beside each
  /// other, see `pack_components()`; of a hyperbolic one in Poincaré's disk.
  Eigen::MatrixX2d positions;
  /// The number q of each vertex; empty without input lengths.
  Eigen::VectorXd weights;
  /// The largest difference of a side in the plane, as a vector, from the side of its face in its
  /// direction, relative to the longest side of the face.
  double largest_side_error = 0;
  bool is_hyperbolic = false; ///< as `Flat_subdivision::is_hyperbolic`
  /// How the copies of a cut through a hyperbolic surface fit together; sides have the numbers of
  /// the corners of `subdivision` where they start.
  Side_pairings pairings{};
  /// The largest hyperbolic distance of a vertex from the centre; 0 in the plane.
  double radius = 0;
};

/*!
\brief lays the common subdivision of a mesh and a flat triangulation out in the plane.

The edges to cut must make disks of the faces that are laid out, and pass through all cones; see
`cut_to_disk()`. Faces of the triangulation may be on both sides of a cut.

In the plane the smallest piece of a component is at the origin, where doubles are densest. Faces
that are as small as the distance of doubles at their place, and which rounding has turned over, are
turned back by moves of vertices of that size, where a local search finds some. `certify_map()`
counts those that are left.
\param s the subdivision
\return the layout
  A hyperbolic one is as `lay_out_in_disk()` makes it; `cut_to_round_disk()` has the cut for it
\throws Invalid_input if sizes disagree, or no triangle has the sides of a face of `s.flat`
\pre `s.subdivision` is the common subdivision of the input and the triangulation, without inserted
  vertices
\complexity that of a sparse factorization, and n log n; of a hyperbolic one n log n
*/
Subdivision_layout lay_out_subdivision(const Flat_subdivision& s);

/*!
\brief returns the places of the corners of the input's faces.
\param layout the layout
\param halfedges the number of halfedges of the input
\return the place of the source of each halfedge, in its face; NaN for a halfedge without a face
  that is laid out
\complexity linear
*/
std::vector<std::array<double, 2>> corner_coordinates(const Subdivision_layout& layout,
                                                      std::size_t halfedges);

/*!
\brief certifies, with exact predicates, that no face of a layout turns over.

Each polygon is divided into triangles from its first corner. A convex polygon, as they are before
rounding, keeps its orientation exactly if all of these do.
\param layout the layout
\return the certificate of these triangles, numbered in the order of the polygons; the border is
  simple only if the layout consists of disks that do not overlap
\complexity O(n log n)
*/
Map_certificate certify_map(const Subdivision_layout& layout);

/*!
\brief counts the triangles of a layout in Poincaré's disk that are not counterclockwise, with
geodesics as sides. It is exact for the places as they are.

Triangles are those that `certify_map()` makes of polygons. It tells about straight sides in
Poincaré's disk, as of texture coordinates that are linear on pieces.
\param layout a hyperbolic layout
\return how many triangles turn over or have corners on one geodesic
\complexity linear
*/
std::size_t flipped_geodesic_triangles(const Subdivision_layout& layout);

/*!
\brief returns the coordinates as fields for `write_common_subdivision()`.
\param layout the layout
\return numbers `u` and `v` per vertex of `layout.subdivision`, which OBJ files have as texture
  coordinates, linear on each face; and, if there are weights, vectors `homogeneous_uv` with the
  coordinates (x q, y q, q), for projective interpolation; of a hyperbolic layout, q times the
  points of the hyperboloid: homogeneous coordinates in Klein's model of the plane. Numbers
  `log_scale` are u of the scale factors exp(u/2), linear along edges of the input.
\complexity linear
*/
std::vector<Subdivision_field> fields_of_layout(const Subdivision_layout& layout);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SUBDIVISION_H
