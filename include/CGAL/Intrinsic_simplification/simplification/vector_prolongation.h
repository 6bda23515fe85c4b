// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VECTOR_PROLONGATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VECTOR_PROLONGATION_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/Straight_segments.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Takes tangent vectors from coarse vertices to the places of the fine ones, and turns them there.
template <class Fine, class Coarse>
class Vector_prolongation {
  using Complex = std::complex<double>;

public:
  Vector_prolongation(const Fine& fine, const Coarse& coarse, const Simplification& s)
      : fine_(fine), coarse_(coarse), s_(s), fine_view_(fine), view_(coarse),
        fine_angles_(fine, Border_angles::half_circle), angles_(coarse, Border_angles::half_circle),
        segments_(view_), fine_copies_(fine), copies_(coarse), points_(s.places.size()),
        targets_(s.places.size()) {
    Place_finder<Coarse> find(coarse);
    for (std::uint32_t row = 0; row < s.places.size(); ++row) {
      const Place& p = s.places[row];
      if (!p.is_vertex() && !p.has_face()) continue;
      const Surface_point at = find.points(p).front();
      points_[row] = begun_at_vertex(at);
      targets_[row] = points_[row]->weights[0] == 1
                          ? Geodesic_target::at_vertex(view_.source(points_[row]->halfedge))
                          : Geodesic_target::at_point(view_, at);
    }
  }

  Eigen::SparseMatrix<Complex> matrix() {
    const std::vector<std::uint32_t> first = fine_copies_.first_of_rows();
    for (const auto v : vertices(fine_.mesh())) {
      const std::uint32_t row = fine_.input_vertex(v), copy = fine_copies_(v);
      if (first[row] != copy || !points_[row]) continue;
      if (const Complex turn = turn_at(v, row); turn != Complex(0)) add(copy, row, turn);
    }
    Eigen::SparseMatrix<Complex> result(static_cast<int>(fine_copies_.size()),
                                        static_cast<int>(copies_.size()));
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }

private:
  // A point at a corner as the source of its halfedge.
  Surface_point begun_at_vertex(const Surface_point& p) const {
    std::uint32_t h = p.halfedge;
    for (std::size_t k = 0; k < 3; ++k, h = view_.next(h))
      if (p.weights[k] == 1) return {h, {1, 0, 0}};
    return p;
  }

  // The direction of a segment: at a vertex its polar angle, else that in the frame of the point.
  double direction(std::uint32_t row, const auto& segment) const {
    const double angle = std::atan2(segment.vector.y, segment.vector.x);
    if (points_[row]->weights[0] != 1) return angle;
    return angles_[segment.halfedge] + angles_.scale(segment.halfedge) * angle;
  }

  // The rotation that takes polar angles of the fine vertex to those at its place: the mean over
  // the edges at the vertex, each with the part of the circle that is nearest to it. The segment
  // between the places of its ends is taken for the image of an edge.
  Complex turn_at(typename Fine::vertex_descriptor v, std::uint32_t row) {
    Complex sum = 0;
    double weights = 0;
    const std::uint32_t begin = fine_view_.outgoing_halfedge(fine_.index(v));
    double before = 0; // the corner before the edge
    for (std::uint32_t h = begin;;) {
      const bool is_last = fine_view_.is_border(h);
      const double after = is_last ? 0 : fine_angles_.scale(h) * angle_at_source(fine_view_, h);
      if (h == begin) before = corner_before(begin);
      const Complex image = image_of(h, row);
      sum += (before + after) * image;
      weights += (before + after) * std::abs(image);
      before = after;
      if (is_last) break;
      h = next_around_source(fine_view_, h);
      if (h == begin) break;
    }
    // opposite rotations leave nothing but rounding
    return std::abs(sum) > 0x1p-20 * weights ? unit_vector(sum) : 0;
  }

  double corner_before(std::uint32_t h) const {
    if (fine_view_.is_border(h ^ 1U)) return 0;
    const std::uint32_t other = fine_view_.next(h ^ 1U);
    return fine_angles_.scale(h) * angle_at_source(fine_view_, other);
  }

  // The rotation of one edge; zero if it is not known.
  Complex image_of(std::uint32_t h, std::uint32_t row) {
    const auto to = fine_.numbers().vertex_at(fine_view_.target(h));
    const std::uint32_t other = fine_.input_vertex(to);
    if (!points_[other] || other == row) return 0;
    // no segment is longer than the image of the edge; in units of the coarse surface
    const double length = std::sqrt(fine_view_.squared_length(h / 2));
    const double reach = std::ldexp(s_.stretch.upper * (1 + 0x1p-40) * length,
                                    view_.scale_exponent() - fine_view_.scale_exponent());
    const auto segment = segments_.find(*points_[row], targets_[other], reach);
    if (!segment || (segment->vector.x == 0 && segment->vector.y == 0)) return 0;
    return std::polar(1., direction(row, *segment) - fine_angles_[h]);
  }

  // Vectors keep their angles with the segment from the corner of a face to a point in it.
  void add(std::uint32_t copy, std::uint32_t row, const Complex& turn) {
    const Surface_point& p = *points_[row];
    const Geodesic_face face(view_, p.halfedge);
    for (unsigned k = 0; k < 3; ++k) {
      if (!(p.weights[k] > 0)) continue;
      const std::uint32_t side = face.side[k];
      Complex factor = 1;
      if (p.weights[k] != 1) {
        const Plane_vector<double> from = Plane_vector<double>{0, 0} - face.to_corner(p.weights, k);
        const Plane_vector<double> inside = face.relative_to(k, from);
        const double polar = angles_[side] + angles_.scale(side) * std::atan2(inside.y, inside.x);
        factor = std::polar(1., std::atan2(from.y, from.x) - polar);
      }
      const auto v = coarse_.numbers().vertex_at(view_.source(side));
      entries_.emplace_back(static_cast<int>(copy), static_cast<int>(copies_(v)),
                            p.weights[k] * factor * std::conj(turn));
    }
  }

  const Fine& fine_;
  const Coarse& coarse_;
  const Simplification& s_;
  Intrinsic_view<Fine> fine_view_;
  Intrinsic_view<Coarse> view_;
  Halfedge_angles fine_angles_, angles_;
  Straight_segments<Intrinsic_view<Coarse>> segments_;
  Vertex_copies<Fine> fine_copies_;
  Vertex_copies<Coarse> copies_;
  std::vector<std::optional<Surface_point>> points_; // on the coarse triangulation, by rows
  std::vector<Geodesic_target> targets_;
  std::vector<Eigen::Triplet<Complex>> entries_;
};

} // namespace internal

/*!
\brief returns the matrix that takes tangent vectors from the coarse vertices to the fine ones.

Vectors are those of a `Tangent_field` on both triangulations, in the polar coordinates of their
vertices. From the corners of its coarse face, vectors are transported along straight lines to the
place of a fine vertex, and averaged there with its weights. Then they are turned as the map from
the fine to the coarse surface turns the edges at the fine vertex, in the mean. Parallel fields on
flat surfaces stay parallel where one shortest segment joins the places of neighbours.

A change of the axes at a vertex changes a row or a column by a factor of absolute value 1.
\tparam Fine a model of `NumberedTriangulation`
\tparam Coarse a model of `CorrespondingTriangulation` and `NumberedTriangulation`
\param fine the triangulation that was simplified, or another one of its surface with the same
  vertices
\param coarse a triangulation of `s.surface`; it may have been flipped or refined
\param s the simplification
\return fine by coarse vectors; the absolute values in a row are weights of the place in its face of
  `coarse`, and sum to 1 up to rounding, or less where corners of the face are one vertex. Rows are
  empty of isolated vertices, on a cover of all copies of a vertex but the first one, and where the
  turn is not known: edges that become loops do not tell it, nor edges whose images cancel, as where
  several shortest segments join two vertices
\throws Invalid_input if a place is not found
\complexity linear in the number of fine edges, times the faces that one of them crosses
*/
template <NumberedTriangulation Fine, QueriedTriangulation Coarse>
Eigen::SparseMatrix<std::complex<double>>
vector_prolongation(const Fine& fine, const Coarse& coarse, const Simplification& s) {
  return internal::Vector_prolongation<Fine, Coarse>(fine, coarse, s).matrix();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_VECTOR_PROLONGATION_H
