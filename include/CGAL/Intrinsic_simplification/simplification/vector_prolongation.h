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
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

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
        segments_(view_), fine_copies_(fine), first_(fine_copies_.first_of_rows()), copies_(coarse),
        points_(s.places.size()), targets_(s.places.size()),
        mean_upper_(std::isfinite(s.stretch.mean_upper) ? s.stretch.mean_upper : 1) {
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
    for (const auto v : vertices(fine_.mesh())) {
      const std::uint32_t row = fine_.input_vertex(v), copy = fine_copies_(v);
      if (first_[row] != copy || !points_[row]) continue;
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
    const unsigned corner = corner_of(p);
    if (corner == 3) return p;
    std::uint32_t h = p.halfedge;
    for (unsigned k = 0; k < corner; ++k) h = view_.next(h);
    return {h, {1, 0, 0}};
  }

  // The direction of a segment: at a vertex its polar angle, else that in the frame of the point.
  double direction(std::uint32_t row, const auto& segment) const {
    const double angle = std::atan2(segment.vector.y, segment.vector.x);
    if (points_[row]->weights[0] != 1) return angle;
    return angles_[segment.halfedge] + angles_.scale(segment.halfedge) * angle;
  }

  // The rotation that takes polar angles of the fine vertex to those at its place: the mean over
  // the edges at the vertex, each with the part of the circle that is nearest to it. A segment
  // between the places of its ends is taken for the image of an edge: of several the one nearest to
  // the rotation.
  Complex turn_at(typename Fine::vertex_descriptor v, std::uint32_t row) {
    images_.clear();
    edges_.clear();
    const std::uint32_t begin = fine_view_.outgoing_halfedge(fine_.index(v));
    double before = 0; // the corner before the edge
    for (std::uint32_t h = begin;;) {
      const bool is_last = fine_view_.is_border(h);
      const double after = is_last ? 0 : fine_angles_.scale(h) * angle_at_source(fine_view_, h);
      if (h == begin) before = corner_before(begin);
      find_images(h, row, before + after);
      before = after;
      if (is_last) break;
      h = next_around_source(fine_view_, h);
      if (h == begin) break;
    }
    return best_turn();
  }

  // A rotation on which many edges agree. Without a choice it is their mean; else each image of an
  // edge is tried, and the best one must be the only one.
  Complex best_turn() const {
    double weights = 0;
    for (const Edge_images& e : edges_) weights += e.weight;
    Complex best = 0, other = 0; // the best two that differ
    const std::size_t tries = images_.size() == edges_.size() ? 1 : images_.size();
    for (std::size_t n = 0; n < tries && n < images_.size(); ++n) {
      const Complex sum = sum_near(images_[n]);
      if (std::norm(sum) > std::norm(best)) {
        if (is_other(sum, best)) other = best;
        best = sum;
      } else if (std::norm(sum) > std::norm(other) && is_other(sum, best)) {
        other = sum;
      }
    }
    // opposite rotations leave nothing but rounding
    const double least = 0x1p-20 * weights;
    return std::abs(best) > std::abs(other) + least ? unit_vector(best) : 0;
  }

  static bool is_other(const Complex& a, const Complex& b) {
    return std::abs(b) == 0 || std::abs(unit_vector(a) - unit_vector(b)) > 0x1p-10;
  }

  // The sum over the edges of their images that are nearest to a rotation.
  Complex sum_near(const Complex& turn) const {
    Complex sum = 0;
    const auto closeness = [&](const Complex& z) { return (std::conj(turn) * z).real(); };
    for (const Edge_images& e : edges_) {
      Complex nearest = images_[e.begin];
      for (std::size_t k = e.begin + 1; k < e.end; ++k)
        if (closeness(images_[k]) > closeness(nearest)) nearest = images_[k];
      sum += e.weight * nearest;
    }
    return sum;
  }

  double corner_before(std::uint32_t h) const {
    if (fine_view_.is_border(h ^ 1U)) return 0;
    const std::uint32_t other = fine_view_.next(h ^ 1U);
    return fine_angles_.scale(h) * angle_at_source(fine_view_, other);
  }

  // Adds the rotations that an edge may have: none if none is known.
  void find_images(std::uint32_t h, std::uint32_t row, double weight) {
    const auto to = fine_.numbers().vertex_at(fine_view_.target(h));
    const std::uint32_t other = fine_.input_vertex(to);
    if (fine_copies_(to) != first_[other]) return; // places are those of first copies
    if (!points_[other] || (other == row && to != fine_.numbers().vertex_at(fine_view_.source(h))))
      return;
    // no segment is longer than the image of the edge; in units of the coarse surface
    const double length = std::ldexp((1 + 0x1p-40) * std::sqrt(fine_view_.squared_length(h / 2)),
                                     view_.scale_exponent() - fine_view_.scale_exponent());
    Edge_images edge{weight, images_.size(), 0};
    for (const auto& segment : segments_.find(*points_[row], targets_[other], mean_upper_ * length,
                                              s_.stretch.upper * length))
      images_.push_back(std::polar(1., direction(row, segment) - fine_angles_[h]));
    edge.end = images_.size();
    if (edge.end > edge.begin) edges_.push_back(edge);
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

  // Rotations of one edge, among those of all at a vertex.
  struct Edge_images {
    double weight;
    std::size_t begin, end;
  };

  const Fine& fine_;
  const Coarse& coarse_;
  const Simplification& s_;
  Intrinsic_view<Fine> fine_view_;
  Intrinsic_view<Coarse> view_;
  Halfedge_angles fine_angles_, angles_;
  Straight_segments<Intrinsic_view<Coarse>> segments_;
  Vertex_copies<Fine> fine_copies_;
  std::vector<std::uint32_t> first_; // copies, by rows
  Vertex_copies<Coarse> copies_;
  std::vector<std::optional<Surface_point>> points_; // on the coarse triangulation, by rows
  std::vector<Geodesic_target> targets_;
  double mean_upper_; // 1 if a thin face has no bound
  std::vector<Complex> images_;
  std::vector<Edge_images> edges_;
  std::vector<Eigen::Triplet<Complex>> entries_;
};

} // namespace internal

/*!
\brief returns the matrix that takes tangent vectors from the coarse vertices to the fine ones.

Vectors are those of a `Tangent_field` on both triangulations, in the polar coordinates of their
vertices. From the corners of its coarse face, vectors are transported along straight lines to the
place of a fine vertex, and averaged there with its weights. Then they are turned as the map from
the fine to the coarse surface turns the edges at the fine vertex, in the mean. Where several
segments of about the length of an edge join the places of its ends, as on narrow tori, those are
taken with which most edges agree on one turn. Parallel fields on flat surfaces stay parallel.

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
  turn is not known: where edges agree on two turns, or their images cancel
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
