// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_SECTORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_SECTORS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A vector in a face of the input.
struct Input_vector {
  std::uint32_t halfedge; ///< a side of the face; `Gluing::none` if no face has the vertex
  Unscaled_vector vector; ///< along the halfedge, and to the left of it
};

/*!
\brief knows, about each vertex of a triangulation, in which face of the input a vector lies.

`vectors_in_space()` makes it for one field. Keep it to take many fields to space: a vector then
costs a search in the faces about its vertex, and no query of the correspondence.

Faces about a vertex are sectors of its polar coordinates, see `Tangent_field`. A vertex inserted on
an edge has two, or one on the border, and a vertex inserted in a face has one. Vectors that point
out of the surface are in the frame of the first or the last face, whichever side is nearer.
*/
class Vertex_sectors {
public:
  /*!
  \brief finds the sectors of all vertices.
  \tparam Triangulation a model of `CorrespondingTriangulation`
  \param t the triangulation; its input must outlive this object unchanged
  \complexity that of `trace_edge()` for each vertex, and linear in the number of faces
  */
  template <QueriedTriangulation Triangulation>
  explicit Vertex_sectors(const Triangulation& t) : input_(&t.correspondence().input()) {
    const auto queries = internal::queries(t);
    const Vertex_copies copies(t);
    const Intrinsic_view<Triangulation> view(t);
    fan_.resize(copies.size(), Gluing::none);
    for (const auto v : vertices(t.mesh())) {
      if (internal::is_isolated(t, v)) continue;
      const auto axis = queries.walk_on_input(view.outgoing_halfedge(t.index(v)), 0);
      add(copies(v), {axis.face().side[0], axis.weights()}, axis.direction());
    }
  }

  /*!
  \brief finds the sectors of all vertices, and keeps the axes of their faces in space, so that
  reading them for one more field takes no point, root or division. They take 48 bytes per sector,
  about 340 per vertex.
  \param points where the user's vertices are
  */
  template <QueriedTriangulation Triangulation>
  Vertex_sectors(const Triangulation& t, std::span<const std::array<double, 3>> points)
      : Vertex_sectors(t) {
    place(points);
  }

  /// returns how many vectors a `Tangent_field` has on the triangulation.
  std::size_t size() const { return fan_.size(); }

  /*!
  \brief returns a vector at a vertex as a vector in a face of the input.
  \param i the number of the vertex in a `Tangent_field`
  \param z the vector
  \complexity linear in the degree of the vertex
  */
  Input_vector on_input(std::size_t i, std::complex<double> z) const {
    if (fan_[i] == Gluing::none) return {Gluing::none, {0, 0}};
    const In_sector found = in_sector(fans_[fan_[i]], z);
    return {sectors_[found.sector].halfedge, {found.vector.real(), found.vector.imag()}};
  }

  /*!
  \brief takes a field to space.
  \param field the vectors
  \return vectors, indexed as `field`; zero for numbers that no vertex with a face has. Vectors in
    faces without area go straight on to the plane of the nearest face that has one
  \throws std::invalid_argument if the field does not have `size()` vectors
  \pre the constructor was given points
  \complexity that of `on_input()` for each vertex
  */
  std::vector<std::array<double, 3>> in_space(const Tangent_field& field) const;

private:
  // Orthogonal unit vectors along the halfedge of a sector, and to the left of it, in space.
  using Axes = std::array<std::array<double, 3>, 2>;
  // The sectors of a vertex, counterclockwise from its real axis.
  struct Fan {
    std::uint32_t vertex; // its number
    std::uint32_t begin, end;
    bool is_on_border;
    double factor; // from polar angles to those on the surface
  };
  // A part of the face of a halfedge; it follows those with smaller angles.
  struct Sector {
    std::uint32_t halfedge;
    double angle; // on the surface, from the real axis to the halfedge
  };
  // A vector in a sector: along its halfedge, and to the left of it.
  struct In_sector {
    std::size_t sector;
    std::complex<double> vector;
  };

  // Adds a vertex at a point of the input, where its real axis has a direction.
  void add(std::uint32_t vertex, const Surface_point& p, const Plane_vector<double>& axis);
  void add_about_vertex(Fan& fan, std::uint32_t h, double angle);
  void add_beside_edge(Fan& fan, std::uint32_t h, double angle);
  void place(std::span<const std::array<double, 3>> points);
  In_sector in_sector(const Fan& fan, std::complex<double> z) const;

  const Input* input_;
  std::vector<std::uint32_t> fan_; // by the numbers of a field
  // In the order of the input, which keeps neighbours together: reading is half as long.
  std::vector<Fan> fans_;
  std::vector<Sector> sectors_;
  std::vector<Axes> axes_; // of sectors; those beyond faces without area
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_SECTORS_H
