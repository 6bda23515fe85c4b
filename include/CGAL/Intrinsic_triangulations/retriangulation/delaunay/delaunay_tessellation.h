// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TESSELLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TESSELLATION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief maps the mesh of a Delaunay tessellation to the intrinsic triangulation. Its elements are
numbered in the order of iteration.
*/
struct Delaunay_tessellation {
  /// Number of cells: faces of the mesh.
  std::uint32_t number_of_cells = 0;
  /// For each number of an intrinsic face the cell that contains it.
  std::vector<std::uint32_t> cell;
  /// For each edge of the mesh the number of the intrinsic edge that it is, with the same
  /// direction.
  std::vector<std::uint32_t> intrinsic_edge;
  /// For each vertex of the mesh its row, `t.input_vertex(v)`: its number, except on a cover.
  std::vector<std::uint32_t> row;
};

namespace internal {

// Builds the mesh from the intrinsic halfedges, except those of edges inside cells.
template <class Triangulation, class Mesh>
class Tessellation_builder {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Graph_traits = boost::graph_traits<typename Triangulation::Mesh>;
  using New_traits = boost::graph_traits<Mesh>;

public:
  Tessellation_builder(const Triangulation& t, Mesh& mesh)
      : t_(t), copies_(t), mesh_(mesh), side_(2 * std::size_t{t.numbers().edge_capacity(t.mesh())}),
        is_left_out_(t.numbers().edge_capacity(t.mesh()), 0) {
    result_.cell.assign(t.numbers().face_capacity(t.mesh()), Gluing::none);
  }

  Delaunay_tessellation build() {
    for (const auto e : check_delaunay(t_).cocircular_edges) is_left_out_[t_.index(e)] = 1;
    for (std::size_t v = 0; v < copies_.size(); ++v) vertex_.push_back(add_vertex(mesh_));
    result_.row.resize(vertex_.size());
    for (const auto v : vertices(t_.mesh())) result_.row[copies_(v)] = t_.input_vertex(v);
    for (const auto e : edges(t_.mesh())) add_sides(t_.index(e));
    for (const Halfedge h : halfedges(t_.mesh()))
      if (is_kept(h)) join(h);
    for (const Halfedge h : halfedges(t_.mesh()))
      if (is_kept(h) && !is_border(h) && result_.cell[t_.index(face(h, t_.mesh()))] == Gluing::none)
        add_cell(h);
    // where there is a border, it is that halfedge of a vertex which is on it
    for (const bool border : {false, true})
      for (const Halfedge h : halfedges(t_.mesh()))
        if (is_kept(h) && is_border(h) == border) set_halfedge(new_target(h), new_side(h), mesh_);
    return result_;
  }

private:
  bool is_border(Halfedge h) const { return face(h, t_.mesh()) == Graph_traits::null_face(); }
  bool is_kept(Halfedge h) const { return is_left_out_[t_.numbers().halfedge(h) / 2] == 0; }
  auto new_side(Halfedge h) const { return side_[t_.numbers().halfedge(h)]; }
  auto new_target(Halfedge h) const { return vertex_[copies_(target(h, t_.mesh()))]; }

  void add_sides(std::uint32_t e) {
    if (is_left_out_[e] != 0) return;
    side_[2 * e] = halfedge(add_edge(mesh_), mesh_);
    side_[2 * e + 1] = opposite(side_[2 * e], mesh_);
    result_.intrinsic_edge.push_back(e);
  }

  // the halfedge after `h` on the boundary of its cell
  Halfedge next_kept(Halfedge h) const {
    Halfedge n = next(h, t_.mesh());
    while (!is_kept(n)) n = next(opposite(n, t_.mesh()), t_.mesh());
    return n;
  }

  void join(Halfedge h) {
    set_next(new_side(h), new_side(next_kept(h)), mesh_);
    set_target(new_side(h), new_target(h), mesh_);
    set_face(new_side(h), New_traits::null_face(), mesh_);
  }

  // The walk along the boundary of a cell meets all of its faces, since they form a tree. Otherwise
  // they would surround a vertex of their circle, or its center, and that would not be flat.
  void add_cell(Halfedge first) {
    const auto cell = add_face(mesh_);
    set_halfedge(cell, new_side(first), mesh_);
    Halfedge h = first;
    do {
      set_face(new_side(h), cell, mesh_);
      for (Halfedge n = h;; n = opposite(n, t_.mesh())) {
        result_.cell[t_.index(face(n, t_.mesh()))] = result_.number_of_cells;
        n = next(n, t_.mesh());
        if (is_kept(n)) {
          h = n;
          break;
        }
      }
    } while (h != first);
    ++result_.number_of_cells;
  }

  const Triangulation& t_;
  Vertex_copies<Triangulation> copies_;
  Mesh& mesh_;
  std::vector<typename New_traits::vertex_descriptor> vertex_; // per copy
  std::vector<typename New_traits::halfedge_descriptor> side_; // per intrinsic halfedge
  std::vector<char> is_left_out_;                              // per intrinsic edge
  Delaunay_tessellation result_;
};

} // namespace internal

/*!
\brief builds the Delaunay tessellation as a polygon mesh: the faces of a Delaunay triangulation,
joined across edges whose opposite angles sum to exactly pi (§4.1 of the course).

It is the same for all Delaunay triangulations of a surface (Bobenko and Springborn 2007). Its cells
are polygons inscribed in empty circles. Two cells may share several sides, and one cell may have a
side twice: the result is a Delta-complex. Its sides have the lengths of intrinsic edges.
\tparam Triangulation a model of `IntrinsicTriangulation` and `IndexedTriangulation`; with inexact
  traits some edges whose angles sum to pi are kept, by rounding
\tparam Mesh a model of `MutableFaceGraph`: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, OpenMesh's
polygon meshes
\param t the triangulation \pre all edges are locally Delaunay; others are kept
\param mesh an empty mesh, which is built: its vertices are those of `t` in the order of rows,
  `t.input_vertex(v)`, without points; on a cover, a row has a vertex for each of its copies, see
  `Delaunay_tessellation::row`
\return the elements of `t` for those of the mesh
\complexity linear
*/
template <IntrinsicTriangulation Triangulation, class Mesh>
  requires IndexedTriangulation<Triangulation>
      Delaunay_tessellation delaunay_tessellation(const Triangulation& t, Mesh& mesh) {
    return internal::Tessellation_builder<Triangulation, Mesh>(t, mesh).build();
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TESSELLATION_H
