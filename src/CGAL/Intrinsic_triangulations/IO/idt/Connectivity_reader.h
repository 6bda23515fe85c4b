// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_CONNECTIVITY_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_CONNECTIVITY_READER_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The line "keyword count".
inline std::uint32_t read_count(Text_reader& in, std::string_view keyword, std::uint32_t most) {
  std::uint32_t count = 0;
  in.line(keyword, [&] {
    count = in.integer<std::uint32_t>("number of elements");
    if (count > most) in.fail("so many " + std::string(keyword) + " are impossible here");
  });
  return count;
}

// Reads the connectivity of one surface. Memory follows what it has read, never a count.
class Connectivity_reader {
public:
  explicit Connectivity_reader(Text_reader& in) : in_(in) {}

  Gluing_map mesh;

  std::uint32_t number_of_vertices() const { return static_cast<std::uint32_t>(halfedge_.size()); }

  // a word of the line of a vertex
  void read_halfedge_of_vertex() {
    const std::string_view h = in_.word();
    halfedge_.push_back(Gluing::none);
    if (h != "-" && !parse_number(h, halfedge_.back())) in_.fail("the halfedge is not a number");
  }

  void start_faces(std::string_view keyword, std::uint32_t edges) {
    // every edge was read, and has at most two of the three sides of a face
    const auto most = static_cast<std::uint32_t>(2 * std::uint64_t{edges} / 3);
    mesh = Gluing_map(number_of_vertices(), edges, read_count(in_, keyword, most));
  }

  void read_face(std::uint32_t f) {
    std::uint32_t h[3], v[3];
    for (std::uint32_t& x : h) x = in_.index(mesh.number_of_halfedges(), "halfedge");
    for (std::uint32_t& x : v) x = in_.index(mesh.number_of_vertices(), "vertex");
    for (unsigned k = 0; k < 3; ++k) {
      if (mesh.next({h[k]}).index != Gluing::none)
        in_.fail("halfedge " + std::to_string(h[k]) + " is in a face already");
      mesh.set_next({h[k]}, {h[(k + 1) % 3]});
      mesh.set_target({h[k]}, {v[(k + 1) % 3]});
      mesh.set_face({h[k]}, {f});
    }
    mesh.set_halfedge(Gluing_map::Face{f}, {h[0]});
    for (unsigned k = 0; k < 3; ++k) check_ends(h[k], v[k]);
  }

  void read_border(std::string_view keyword) {
    const std::uint32_t count = read_count(in_, keyword, mesh.number_of_halfedges());
    std::vector<char> followed(mesh.number_of_halfedges(), 0);
    in_.lines(count, [&](std::uint32_t) {
      const std::uint32_t h = in_.index(mesh.number_of_halfedges(), "halfedge");
      const std::uint32_t n = in_.index(mesh.number_of_halfedges(), "halfedge");
      if (mesh.next({h}).index != Gluing::none || mesh.face({h ^ 1U}).index == Gluing::none)
        in_.fail("halfedge " + std::to_string(h) + " is not on the border, or occurs twice");
      if (mesh.face({n}).index != Gluing::none || mesh.face({n ^ 1U}).index == Gluing::none ||
          followed[n]++ != 0)
        in_.fail("halfedge " + std::to_string(n) + " cannot follow on the border");
      const Gluing_map::Vertex v = source_of_side(h ^ 1U);
      if (mesh.target({n ^ 1U}) != v)
        in_.fail("halfedge " + std::to_string(n) + " does not start where " + std::to_string(h) +
                 " ends");
      mesh.set_next({h}, {n});
      mesh.set_target({h}, v);
    });
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.next({h}).index == Gluing::none)
        in_.fail("halfedge " + std::to_string(h) + " is in no face and not on the border");
    set_halfedges_of_vertices();
  }

private:
  // the vertex that a side of a face starts from
  Gluing_map::Vertex source_of_side(std::uint32_t h) const {
    return mesh.target(mesh.next(mesh.next({h})));
  }

  // Compares the ends of a side that starts from `v` with those on the other side.
  void check_ends(std::uint32_t h, std::uint32_t v) {
    const std::uint32_t o = h ^ 1U;
    if (mesh.face({o}).index == Gluing::none) return;
    if (mesh.target({o}).index != v || source_of_side(o) != mesh.target({h}))
      in_.fail("the two sides of edge " + std::to_string(h / 2) + " have different end vertices");
  }

  void set_halfedges_of_vertices() {
    for (std::uint32_t v = 0; v < halfedge_.size(); ++v) {
      const std::uint32_t h = halfedge_[v];
      if (h == Gluing::none) continue;
      if (h >= mesh.number_of_halfedges() || mesh.target({h}).index != v)
        in_.fail("the halfedge of vertex " + std::to_string(v) + " does not end there");
      mesh.set_halfedge(Gluing_map::Vertex{v}, {h});
    }
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h) check_halfedge_of_target(h);
  }

  // walks around vertices start from their halfedges, and end on the border
  void check_halfedge_of_target(std::uint32_t h) const {
    const Gluing_map::Vertex v = mesh.target({h});
    const Gluing_map::Halfedge first = mesh.halfedge(v);
    if (first.index == Gluing::none)
      in_.fail("vertex " + std::to_string(v.index) + " has faces and needs a halfedge");
    if (mesh.face({h}).index == Gluing::none && mesh.face(first).index != Gluing::none)
      in_.fail("the halfedge of vertex " + std::to_string(v.index) +
               " is not on the border, but the vertex is");
  }

  Text_reader& in_;
  std::vector<std::uint32_t> halfedge_; // of each vertex
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_CONNECTIVITY_READER_H
