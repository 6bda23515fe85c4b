// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALE_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALE_METRIC_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Scaled_metric.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Tensor_norm.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
New lengths for the edges of a surface: metric scaling (§4.8 of the course).

The input is a mesh in space (any that `Intrinsic_input` takes), an `Intrinsic_input` (for gluings
with squared lengths, triangle soups, and other point maps), or the current edges of an
`Intrinsic_triangulation`. The result is an abstract metric on the same triangles: element number n
of the result, of reports and of errors is the n-th vertex, edge or face in the order of iteration
of the mesh (of `mesh()`, if a triangulation is given).

The new surface is *not* the old one: it has other areas, distances and cone angles. A triangulation
built from it takes it as its input and corresponds to its triangles; its points have no coordinates
in space. Both surfaces share the triangles of the mesh: a face and barycentric coordinates on the
new input also name a point of the old surface.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The sides of a triangle as vectors of the plane, for any lengths. They sum to zero only up to
// rounding: each coordinate has an error of a few u times the length of its side. Where ij has
// length zero, jk lies on the x-axis; where lengths violate the triangle inequality, or there is no
// area, the height of k is zero.
Plane_sides planar_sides(double L_ij, double L_jk, double L_ki);

// The same of the sides i -> j, j -> k, k -> i as vectors of space.
using Space_sides = std::array<Space_vector<double>, 3>;
Plane_sides planar_sides(const Space_sides& s);

// The value at `x` of a functor or of a property map.
template <class Field, class Descriptor>
double value_at(const Field& field, Descriptor x) {
  if constexpr (std::is_invocable_v<const Field&, Descriptor>)
    return CGAL::to_double(field(x));
  else {
    using boost::get;
    return CGAL::to_double(get(field, x));
  }
}

Intrinsic_input scaled_input(Intrinsic_input&& in, std::vector<double> squared_lengths);

Scaled_metric scale_conformally(Metric_source&& s, const std::vector<double>& u,
                                const Metric_scaling_options& options);

// A vector of space in the units of the input, see `unscaled()` for those of the plane.
inline std::array<double, 3> unscaled(std::array<double, 3> v, int scale_exponent) {
  for (double& x : v) x = std::ldexp(x, -scale_exponent);
  return v;
}

// Squared lengths: for each edge, the square of the mean of `norm(face, vector)` over its sides.
// `sides(face number)` are the vectors; it may refer to `s`, which is left as it is until the last
// line.
template <class Mesh, class Sides, class Norm>
Scaled_metric scale_by_norm(const Mesh& mesh, Metric_source&& s, const Sides& sides,
                            const Norm& norm, const Metric_scaling_options& options) {
  std::vector<double> sum(s.in.mesh.number_of_edges(), 0);
  std::vector<unsigned char> count(sum.size(), 0);
  std::uint32_t f = 0;
  for (const auto face : faces(named_mesh(mesh))) {
    const auto vectors = sides(f); // of the plane or of space
    const std::array<std::uint32_t, 3> e = edges_of_face(s.in.mesh, f);
    for (std::size_t k = 0; k < 3; ++k) {
      ++count[e[k]];
      if (s.in.squared_lengths[e[k]] == 0) continue;
      const double length = CGAL::to_double(norm(face, unscaled(vectors[k], s.scale_exponent)));
      if (!std::isfinite(length) || !(length > 0))
        throw Invalid_input::about(Element_kind::face, f,
                                   " has a norm that gives its side " + std::to_string(k) +
                                       " the length " + text_of_length(length) +
                                       "; give one that is positive and finite");
      sum[e[k]] += length;
    }
    ++f;
  }
  for (std::size_t e = 0; e < sum.size(); ++e) {
    sum[e] /= count[e] == 0 ? 1 : count[e];
    sum[e] *= sum[e];
  }
  return finish_scaling(scaled_input(std::move(s.in), std::move(sum)), options);
}

// The lengths of a triangulation are rounded: those of a face without area may not be exact.
Plane_sides planar_sides_of_face(const Metric_source& s, std::uint32_t f, bool are_exact);

inline Space_sides sides_of_face_in_space(const Metric_source& s, std::uint32_t f) {
  const auto [h, n, l] = s.in.mesh.sides({f});
  return {s.side_in_space(h), s.side_in_space(n), s.side_in_space(l)};
}

// Norms are given per face: the faces must be those of the user.
template <class Mesh>
Metric_source read_triangles(const Mesh& mesh) {
  Metric_source s = read_metric(mesh);
  if constexpr (std::is_same_v<decltype(named_mesh(mesh)), const Mesh&>)
    if (s.in.triangulated_polygons > 0) gluing_map_from_face_graph(mesh); // throws, and names one
  return s;
}

} // namespace internal

/*!
\brief requires a surface whose metric can be scaled: a mesh of triangles or polygons in space, an
`Intrinsic_input`, or a triangulation.

Syntax of \ref ::ScalableSurface, where its meaning is described.
*/
template <class Mesh>
concept ScalableSurface =
    TriangulationWithMetric<Mesh> || std::same_as<Mesh, Intrinsic_input> || ReadableFaceGraph<Mesh>;

/*!
\brief requires a functor or a readable property map from the vertices of a surface to numbers.

Syntax of \ref ::VertexFactors, where its meaning is described.
*/
template <class Factors, class Mesh>
concept VertexFactors = std::invocable<const Factors&, internal::Named_vertex<Mesh>> ||
                        std::convertible_to < internal::Named_vertex<Mesh>,
typename boost::property_traits<Factors>::key_type > ;

/*!
\brief requires a functor that measures vectors in the faces of a surface.

Syntax of \ref ::FaceNorm, where its meaning is described.
*/
template <class Norm, class Mesh, class Vector>
concept FaceNorm = requires(const Norm& norm, internal::Named_face<Mesh> f, const Vector& v) {
  CGAL::to_double(norm(f, v));
};

/*!
\brief scales the metric of a surface by a factor e^u_i per vertex, l'_ij = exp((u_i + u_j) / 2)
l_ij.

A constant u multiplies lengths by e^u and areas by e^2u. With u_i = -2 log |x_i| the result has the
lengths between the points x_i inverted in the unit sphere: their distances are
|x_i - x_j| / (|x_i| |x_j|).

Polygonal faces are triangulated first, as `Intrinsic_input` does.
\tparam Mesh see the file's description
\tparam Factors a functor or a readable property map from vertex descriptors (those of `mesh`, of
  `mesh.mesh()` for an `Intrinsic_triangulation`, of `Gluing_map` for an `Intrinsic_input`) to
  numbers
\param mesh the surface
\param u the logarithmic factors
\param np optional named parameters: - `triangle_inequality(x)`: treatment of faces that violate it,
  a `Triangle_inequality`. Default: `refuse`. - `margin(x)`: for `repair`, that of
  `shorten_edges()`, by which sides are shorter than the other two together, as a fraction of the
  shorter of those; above 0, at most 1. Default: 1e-5.
\return the new metric and a report
\throws Invalid_input naming a vertex with a factor that is not finite, an edge whose new squared
  length is not a normal `double`, or a face that violates the triangle inequality if it is refused
\complexity linear, and that of `shorten_edges()`
*/
template <ScalableSurface Mesh, VertexFactors<Mesh> Factors,
          NamedParameters NP = parameters::Parameters<>>
Scaled_metric scale_conformally(const Mesh& mesh, const Factors& u,
                                const NP& np = parameters::default_values()) {
  internal::Metric_source source = internal::read_metric(mesh);
  std::vector<double> factors;
  for (const auto v : vertices(internal::named_mesh(mesh))) {
    factors.push_back(internal::value_at(u, v));
    if (!std::isfinite(factors.back()))
      throw Invalid_input::about(Element_kind::vertex, factors.size() - 1,
                                 " has a conformal factor that is not finite; correct it");
  }
  return internal::scale_conformally(std::move(source), factors,
                                     internal::metric_scaling_options(np));
}

/*!
\brief scales the metric of a surface by a norm per face, which may depend on the direction: the new
length of an edge is that of its vector, averaged over the faces at the edge (§4.8 of the course).

In the frame of a face i and j are source and target of `halfedge(face, mesh)`, k is the third
corner; i is the origin, j lies on the positive x-axis, k above it. If i and j are in the same
place, k lies on the x-axis.

The norm is called once for each side of nonzero length of each face, for the vector along the side
with the face on its left: i -> j, j -> k, k -> i. On the border, one face counts. If both sides of
an edge are in one face, the norms of two vectors of that face are averaged. `Tensor_norm` makes
norms from tensors and from stretches.
\tparam Mesh see the file's description; faces must be triangles
\tparam Norm a functor: `norm(face_descriptor, Unscaled_vector)` is a length, positive and
  homogeneous in the vector; descriptors as for `scale_conformally()`
\param mesh the surface
\param norm the norms
\param np optional named parameters, see `scale_conformally()`
\return the new metric and a report
\throws Invalid_input naming a face with a norm that is not positive or not finite, a face that is
  not a triangle, or as `scale_conformally()`
\complexity linear, and that of `shorten_edges()`
*/
template <ScalableSurface Mesh, FaceNorm<Mesh, Unscaled_vector> Norm,
          NamedParameters NP = parameters::Parameters<>>
Scaled_metric scale_by_norm(const Mesh& mesh, const Norm& norm,
                            const NP& np = parameters::default_values()) {
  auto source = internal::read_triangles(mesh);
  const bool embedded = !source.in.points.empty();
  const auto sides = [&source, embedded](std::uint32_t f) {
    return embedded
               ? internal::planar_sides(internal::sides_of_face_in_space(source, f))
               : internal::planar_sides_of_face(source, f, std::is_same_v<Mesh, Intrinsic_input>);
  };
  return internal::scale_by_norm(mesh, std::move(source), sides, norm,
                                 internal::metric_scaling_options(np));
}

/*!
\brief scales the metric of a surface in space by a norm per face, given for vectors of space: see
`scale_by_norm()`.

Use it for fields given in space: speeds, directions of curvature. A norm that is the same in all
faces and comes from an inner product gives the lengths of the mesh transformed linearly.
\tparam Mesh a mesh in space, or `Intrinsic_input` with points; faces must be triangles
\tparam Norm a functor: `norm(face_descriptor, std::array<double, 3>)` is a length
\param mesh the surface
\param norm the norms
\param np optional named parameters, see `scale_conformally()`
\return the new metric and a report
\throws Invalid_input if `mesh` has no points, and as `scale_by_norm()`
\complexity as `scale_by_norm()`
*/
template <ScalableSurface Mesh, FaceNorm<Mesh, std::array<double, 3>> Norm,
          NamedParameters NP = parameters::Parameters<>>
  requires(!TriangulationWithMetric<Mesh>)
Scaled_metric scale_by_norm_in_space(const Mesh& mesh, const Norm& norm,
                                     const NP& np = parameters::default_values()) {
  auto source = internal::read_triangles(mesh);
  if (source.in.points.empty() && source.in.mesh.number_of_edges() > 0)
    throw Invalid_input(Element_kind::none, 0,
                        "the surface has no points in space; give norms in the faces' own frames");
  const auto sides = [&source](std::uint32_t f) {
    return internal::sides_of_face_in_space(source, f);
  };
  return internal::scale_by_norm(mesh, std::move(source), sides, norm,
                                 internal::metric_scaling_options(np));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALE_METRIC_H
