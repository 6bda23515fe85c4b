// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_ON_SHEETS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_ON_SHEETS_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/tracing/within_rounding.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds, on a double cover, both vectors that are one vector on the surface: on the front and
on the back of the face that it points into.

As sources of transport, and as fixed directions, both together have results that do not depend on
which side of a face is its front, if those on both sheets are averaged. At a vertex both are about
the same copy where the cover turns from one side to the other, as over a border: together they
count there by what they have in common, at a border the part along it. On other surfaces the given
one is the only one.
\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Vectors_on_sheets {
public:
  using Vertex = typename Triangulation::vertex_descriptor; ///< vertex of the triangulation

  /// prepares the search on a triangulation, which must outlive this object unchanged.
  /// \complexity linear
  explicit Vectors_on_sheets(const Triangulation& t) : t_(t), sheets_(t.correspondence().input()) {}

  /// returns a vector, and that on the other sheet, if there is one.
  /// \complexity that of `tangent_to_input()` and `tangent_to_intrinsic()`
  std::vector<Tangent_vector> operator()(const Tangent_vector& v) const {
    std::vector<Tangent_vector> result{v};
    if (const std::optional<Tangent_vector> w = other(v)) result.push_back(*w);
    return result;
  }

  /// returns the vertex where a tangent vector is, and the vector in its polar coordinates.
  /// \pre the vector is at a vertex
  std::pair<Vertex, std::complex<double>> at_vertex(const Tangent_vector& v) {
    if (!frames_) frames_.emplace(t_);
    const Intrinsic_view<Triangulation> view(t_);
    const std::uint32_t h = sides_of_face(view, v.point.halfedge)[internal::corner_of(v.point)];
    const Vertex there = t_.numbers().vertex_at(view.source(h));
    return {there,
            frames_->to_field(frames_->number(there), frames_->at_corner(v.point, v.vector))};
  }

  /// returns a vertex and a vector in its polar coordinates, and those on the other sheet.
  std::vector<std::pair<Vertex, std::complex<double>>> operator()(Vertex v,
                                                                  std::complex<double> z) {
    std::vector<std::pair<Vertex, std::complex<double>>> result{{v, z}};
    if (!sheets_.is_cover()) return result;
    const std::optional<Tangent_vector> w = other(tangent_vector(t_, v, z));
    if (w && internal::corner_of(w->point) < 3) result.push_back(at_vertex(*w));
    return result;
  }

  /*!
  \brief averages the directions of a field on both sheets: where a vertex has a copy on the other
  sheet of its first copy, the first one gets the mean direction, and any one that is known.
  \param field a vector per copy, by the numbers of a `Tangent_field`
  \param degree the number of equivalent directions that each vector stands for
  \param fixed vectors that keep their directions, see `smoothest_direction_field()`; of several at
  a vertex, the first one
  \complexity linear on other surfaces; else that of `tangent_to_input()` for each vertex
  */
  Tangent_field averaged(Tangent_field field, int degree = 1,
                         const std::vector<std::pair<Vertex, std::complex<double>>>& fixed = {}) {
    if (!sheets_.is_cover()) return field;
    const Vertex_copies<Triangulation> copies(t_);
    const std::vector<std::uint32_t> first = copies.first_of_copies();
    const auto power = [degree](const std::complex<double>& z) {
      const std::complex<double> u = internal::unit_vector(z);
      return u == 0. ? u : std::polar(1., degree * std::arg(u));
    };
    Tangent_field sums(field.size());
    std::transform(field.begin(), field.end(), sums.begin(), power);
    for (const Vertex v : vertices(t_.mesh())) {
      const std::uint32_t i = copies(v);
      if (first[i] == i || internal::unit_vector(field[i]) == 0.) continue;
      const auto both = (*this)(v, field[i]);
      const auto& [there, z] = both.back();
      if (copies(there) != first[i]) continue;
      sums[first[i]] += power(z);
      if (!internal::is_known(field[first[i]])) field[first[i]] = z;
    }
    for (std::size_t i = 0; i < field.size(); ++i)
      if (const auto u = internal::unit_vector(sums[i]); u != 0.)
        field[i] = std::polar(std::abs(field[i]), std::arg(u) / degree);
    for (std::size_t i = fixed.size(); i-- > 0;)
      field[copies(fixed[i].first)] = internal::unit_vector(fixed[i].second);
    return field;
  }

private:
  std::optional<Tangent_vector> other(const Tangent_vector& v) const {
    if (!sheets_.is_cover()) return std::nullopt;
    std::optional<Tangent_vector> here = tangent_to_input(t_, v);
    const double length = std::hypot(v.vector[0], v.vector[1]);
    if (!here || !(length > 0)) return std::nullopt;
    here->point = internal::within_rounding(t_.correspondence().input(), here->point);
    const internal::Geodesic_walk<Input> walk(t_.correspondence().input(), here->point,
                                              here->vector);
    if (!walk.is_blocked()) here = internal::at_start(walk, length); // in the face it points into
    const auto& w = here->point.weights;
    const Surface_point p{sheets_.other_side(here->point.halfedge), {w[1], w[0], w[2]}};
    return tangent_to_intrinsic(t_, {p, {-here->vector[0], here->vector[1]}});
  }

  const Triangulation& t_;
  internal::Sheets sheets_;
  std::optional<internal::Point_frames<Triangulation>> frames_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_ON_SHEETS_H
