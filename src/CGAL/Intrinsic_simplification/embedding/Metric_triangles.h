// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_METRIC_TRIANGLES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_METRIC_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex that was removed, and its place in a face.
struct Removed_vertex {
  std::uint32_t vertex;
  std::uint32_t face;
  std::array<Double_double, 3> weights; // of the corners of the face
};

// The two triangles at the halfedge h = ij in one plane: i = (0, 0), j = (length, 0), k above, m
// below. Twice the edge times each coordinate is a polynomial in squared lengths and areas.
struct Metric_diamond {
  Double_double length, kx, ky, mx, my; // my is positive, the point is (mx, -my)

  // Sines of the angles at i and at j, of both triangles together.
  std::array<double, 2> sines() const;
};

/*
The triangles of a closed oriented surface, with squared lengths of 106 bits: lengths stay precise
over very many flips. Halfedges are those of a `Gluing`. Vertices can be removed where the surface
is flat; their places are kept in later flips.
*/
class Metric_triangles {
public:
  // \param gluing without border \param squared by halfedge
  Metric_triangles(Gluing gluing, std::vector<Double_double> squared);

  std::uint32_t number_of_vertices() const { return gluing_.number_of_vertices; }
  std::uint32_t number_of_faces() const { return gluing_.number_of_faces(); }
  std::uint32_t number_of_halfedges() const { return 3 * number_of_faces(); }
  static std::uint32_t next(std::uint32_t h) { return Gluing::next(h); }
  static std::uint32_t previous(std::uint32_t h) { return next(next(h)); }
  std::uint32_t opposite(std::uint32_t h) const { return gluing_.glue[h]; }
  std::uint32_t source(std::uint32_t h) const { return gluing_.origin[h]; }
  std::uint32_t target(std::uint32_t h) const { return gluing_.origin[next(h)]; }
  // a halfedge from a vertex
  std::uint32_t outgoing(std::uint32_t v) const { return outgoing_[v]; }
  bool is_removed(std::uint32_t face) const { return source(3 * face) == Gluing::none; }

  const Double_double& squared_length(std::uint32_t h) const { return squared_[h]; }
  double length(std::uint32_t h) const { return length_[h]; }
  // of the angle at the source of h
  double sine(std::uint32_t h) const { return sine_[h]; }
  double cosine(std::uint32_t h) const { return cosine_[h]; }
  // of each vertex: a full turn less the angles there
  std::vector<double> curvatures() const;
  double curvature(std::uint32_t v) const; // to the last bits, though it is small
  std::uint32_t degree(std::uint32_t v) const;

  // \pre both sides of h are in different faces
  Metric_diamond unfold(std::uint32_t h) const;
  bool is_in_two_faces(std::uint32_t h) const { return h / 3 != opposite(h) / 3; }
  // turns ij to mk: h runs from m to k. \pre the diamond is convex, maybe straight at one end
  void flip(std::uint32_t h, const Metric_diamond& d);
  // multiplies squared lengths of edges by a factor for each end at a vertex: it becomes flat
  // \return whether it is flat up to rounding of 106 bits; else nothing is proven
  bool flatten(std::uint32_t vertex);
  // gives the edges other lengths, \param squared by halfedge
  void change_lengths(const std::vector<Double_double>& squared);
  // removes a vertex with three faces, none of its edges a loop
  void remove(std::uint32_t vertex);
  // numbers what is left anew. \return the vertices that are left, by their numbers before
  std::vector<std::uint32_t> compress();

  const std::vector<Removed_vertex>& removed() const { return removed_; }
  // A bound: since the beginning, no curve has become longer or shorter by more than the
  // exponential of this. Infinite: nothing is proven.
  double stretch_exponent() const;

private:
  void glue(std::uint32_t g, std::uint32_t h);
  void set_length(std::uint32_t h, const Double_double& squared);
  void set_corners(std::uint32_t face);
  // calls f with each halfedge from a vertex
  template <class Function>
  void for_outgoing(std::uint32_t v, const Function& f) const {
    std::uint32_t h = outgoing_[v];
    do {
      f(h);
      h = opposite(previous(h));
    } while (h != outgoing_[v]);
  }
  void scale_edges(std::uint32_t vertex, const std::vector<Double_double>& before,
                   const Double_double& factor);
  void add_stretch(std::uint32_t face, const std::array<Double_double, 3>& before);
  void move_removed(std::uint32_t h, const Metric_diamond& d);
  // the vertex, and those removed before in its faces, in the triangle that is left of them
  void place_in_rim(std::uint32_t vertex, const std::array<std::uint32_t, 3>& rim);

  Gluing gluing_;
  std::vector<Double_double> squared_;
  std::vector<double> length_, sine_, cosine_;
  std::vector<double> stretch_; // exponents, by face
  std::vector<std::uint32_t> outgoing_;
  std::vector<Removed_vertex> removed_;
  std::vector<std::vector<std::uint32_t>> removed_in_; // by face; empty if none was removed
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_METRIC_TRIANGLES_H
