// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_PLACES_H
#define INTRINSIC_PYTHON_PLACES_H

#include "arrays.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

// Points that the user gives: vertices, and places in faces of the mesh.

namespace python {

/// A point that the user gave.
struct Place {
  std::uint32_t vertex = IT::Gluing::none; ///< a vertex, or `none`: then it is in a face
  std::uint32_t face = 0;                  ///< the user's face
  std::array<double, 3> weights{1, 0, 0};  ///< of the corners of the face, which sum to 1

  /// returns whether it is a vertex.
  bool is_vertex() const { return vertex != IT::Gluing::none; }
};

/// The arrays that Python makes of points: faces, barycentric coordinates (n, 3), and vertices, -1
/// for points in faces.
using Place_arrays = std::tuple<Integers, Doubles, Integers>;

/// reads points.
std::vector<Place> places_of(const Place_arrays& arrays);

/// returns the point of the input at a place in a face.
/// \throws Invalid_input naming a face that does not exist, or is a polygon
IT::Surface_point point_on_input(const IT::Input& input, const Place& p);

/// Finds vertices and points of a triangulation at the places that the user gave.
/// \tparam Triangulation a triangulation with integer coordinates
template <class Triangulation>
class Place_finder {
public:
  using Vertex = typename Triangulation::vertex_descriptor; ///< vertex of the triangulation

  /// prepares the search on a triangulation, which must outlive this object unchanged.
  explicit Place_finder(const Triangulation& t) : t_(t) {}

  /// returns the vertex of a row; on a cover, the first copy.
  /// \throws Invalid_input naming a vertex that does not exist, or has no face
  Vertex vertex(std::uint32_t row) {
    const Vertex v = row < t_.input().number_of_rows() ? IT::vertex_of_row(t_, row) : inserted(row);
    if (halfedge(v, t_.mesh()).index == IT::Gluing::none)
      throw IT::Invalid_input(IT::Element_kind::vertex, row,
                              "vertex " + std::to_string(row) +
                                  " is isolated: no face has it; choose another");
    return v;
  }

  /// appends the points of the triangulation at a place: on a cover, in a face, one on each sheet.
  void append(const Place& p, std::vector<IT::Surface_point>& points) {
    if (p.is_vertex()) {
      points.push_back(corner_at(vertex(p.vertex)));
      return;
    }
    const IT::Surface_point first = point_on_input(t_.input(), p);
    append_located(first, p, points);
    if (t_.input().names().sheets == 1) return;
    if (!sheets_) sheets_.emplace(t_.input());
    for (const IT::Surface_point& other : sheets_->others(first)) append_located(other, p, points);
  }

  /// returns the points of the triangulation at places.
  std::vector<IT::Surface_point> points(const std::vector<Place>& places) {
    std::vector<IT::Surface_point> result;
    for (const Place& p : places) append(p, result);
    return result;
  }

private:
  // a corner of a face
  IT::Surface_point corner_at(Vertex v) const {
    const auto in = halfedge(v, t_.mesh());
    const auto out = opposite(in, t_.mesh());
    const bool is_border = face(out, t_.mesh()).index == IT::Gluing::none;
    return {t_.numbers().halfedge(is_border ? next(in, t_.mesh()) : out), {1, 0, 0}};
  }

  void append_located(const IT::Surface_point& on_input, const Place& p,
                      std::vector<IT::Surface_point>& points) const {
    const std::optional<IT::Surface_point> q = IT::locate_on_intrinsic(t_, on_input);
    if (!q)
      throw IT::Invalid_input(IT::Element_kind::face, p.face,
                              "the point in face " + std::to_string(p.face) +
                                  " is not found on the triangulation; choose another");
    points.push_back(*q);
  }

  Vertex inserted(std::uint32_t row) {
    if (inserted_.empty())
      for (const Vertex v : vertices(t_.mesh()))
        if (t_.is_inserted(v)) inserted_.emplace(t_.input_vertex(v), v);
    const auto found = inserted_.find(row);
    if (found != inserted_.end()) return found->second;
    throw IT::Invalid_input(IT::Element_kind::vertex, row,
                            "there is no vertex " + std::to_string(row) + "; numbers are below " +
                                std::to_string(t_.number_of_vertices()));
  }

  const Triangulation& t_;
  std::map<std::uint32_t, Vertex> inserted_; // by rows
  std::optional<IT::internal::Sheets> sheets_;
};

} // namespace python

#endif // INTRINSIC_PYTHON_PLACES_H
