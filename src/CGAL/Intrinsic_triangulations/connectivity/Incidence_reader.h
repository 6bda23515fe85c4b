// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INCIDENCE_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INCIDENCE_READER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Reads faces.
class Incidence_reader {
  using Ends = std::array<std::uint32_t, 2>; // source and target
  struct Side {
    std::uint32_t edge = Gluing::none;
    bool along = false;
  };

public:
  explicit Incidence_reader(const Signed_incidence& s)
      : in_(s), ends_(s.number_of_edges, {Gluing::none, Gluing::none}),
        sides_(3 * std::size_t{s.number_of_faces}) {
    if (s.number_of_faces > (Gluing::reversed_bit - 1) / 3)
      throw Invalid_input(Element_kind::none, 0, "a gluing holds at most 715827882 faces");
    read_edges();
    read_faces();
    for (std::uint32_t f = 0; f < s.number_of_faces; ++f) chain(f);
    gluing.number_of_vertices = s.number_of_vertices;
    gluing.glue.assign(sides_.size(), Gluing::none);
    for (const Side& side : sides_) edge_of_halfedge.push_back(side.edge);
    find_faces_of_edges();
  }

  Gluing gluing; // nothing is glued yet
  std::vector<std::uint32_t> edge_of_halfedge;
  Sides_by_edge edges; // in the order of entries

  // Refuses an edge with more than two faces.
  [[noreturn]] void fail_shared(std::uint32_t e) const {
    std::string faces;
    for (const Edge_side& side : edges[e].first(3))
      faces += std::to_string(side.halfedge / 3) + ", ";
    fail(Element_kind::edge, e,
         " has more than two faces (" + faces +
             "...); split it so that at most two remain, or make a cover by `make_domain()`");
  }

private:
  [[noreturn]] static void fail(Element_kind kind, std::uint32_t i, const std::string& what) {
    throw Invalid_input::about(kind, i, what);
  }

  static void check_entry(const Incidence_entry& x, std::uint32_t rows, std::uint32_t columns,
                          Element_kind kind, const char* column_name) {
    if (x.row >= rows) fail(kind, x.row, " is out of range");
    if (x.column >= columns)
      fail(kind, x.row,
           std::string(" refers to ") + column_name + " " + std::to_string(x.column) +
               ", which does not exist");
    if (x.sign != 1 && x.sign != -1)
      fail(kind, x.row,
           std::string(" has the entry ") + std::to_string(x.sign) + " at " + column_name + " " +
               std::to_string(x.column) + "; entries are +1 and -1, and are not summed");
  }

  void read_edges() {
    for (const Incidence_entry& x : in_.vertex_edge) {
      check_entry(x, in_.number_of_edges, in_.number_of_vertices, Element_kind::edge, "vertex");
      std::uint32_t& end = ends_[x.row][x.sign < 0 ? 0 : 1];
      if (end != Gluing::none)
        fail(Element_kind::edge, x.row,
             x.sign < 0 ? " starts from two vertices; give one -1 and one +1"
                        : " ends at two vertices; give one -1 and one +1");
      end = x.column;
    }
    for (std::uint32_t e = 0; e < in_.number_of_edges; ++e)
      if (ends_[e][0] == Gluing::none || ends_[e][1] == Gluing::none)
        fail(Element_kind::edge, e,
             " has fewer than two ends; give one -1 and one +1, for a loop at the same vertex");
  }

  void read_faces() {
    std::vector<std::uint32_t> count(in_.number_of_faces, 0);
    for (const Incidence_entry& x : in_.edge_face) {
      check_entry(x, in_.number_of_faces, in_.number_of_edges, Element_kind::face, "edge");
      if (count[x.row] < 3) sides_[3 * std::size_t{x.row} + count[x.row]] = {x.column, x.sign > 0};
      ++count[x.row];
    }
    for (std::uint32_t f = 0; f < in_.number_of_faces; ++f)
      if (count[f] != 3)
        fail(Element_kind::face, f,
             " has " + std::to_string(count[f]) +
                 " sides; give three entries, two of them at an edge where it is glued to itself");
  }

  std::uint32_t source(const Side& s) const { return ends_[s.edge][s.along ? 0 : 1]; }
  std::uint32_t target(const Side& s) const { return ends_[s.edge][s.along ? 1 : 0]; }

  // puts the sides of a face in cyclic order and appends their origins
  void chain(std::uint32_t f) {
    Side* const s = &sides_[3 * std::size_t{f}];
    const auto chains = [&] {
      return target(s[0]) == source(s[1]) && target(s[1]) == source(s[2]) &&
             target(s[2]) == source(s[0]);
    };
    if (!chains()) {
      std::swap(s[1], s[2]);
      if (!chains())
        fail(Element_kind::face, f,
             " has sides " + std::to_string(s[0].edge) + ", " + std::to_string(s[2].edge) + ", " +
                 std::to_string(s[1].edge) +
                 " that do not run around a triangle; check the signs of its row");
    }
    for (int k = 0; k < 3; ++k) gluing.origin.push_back(source(s[k]));
  }

  void find_faces_of_edges() {
    edges.first.assign(std::size_t{in_.number_of_edges} + 1, 0);
    for (const Side& side : sides_) ++edges.first[side.edge + std::size_t{1}];
    for (std::uint32_t e = 0; e < in_.number_of_edges; ++e) {
      if (edges.first[e + 1] == 0) fail(Element_kind::edge, e, " has no face; remove it");
      edges.first[e + 1] += edges.first[e];
    }
    std::vector<std::uint32_t> next(edges.first.begin(), edges.first.end() - 1);
    std::vector<char> is_taken(sides_.size(), 0);
    edges.sides.resize(sides_.size());
    for (const Incidence_entry& x : in_.edge_face) {
      std::uint32_t h = 3 * x.row; // sides may have changed places
      while (is_taken[h] != 0 || sides_[h].edge != x.column || sides_[h].along != (x.sign > 0)) ++h;
      is_taken[h] = 1;
      edges.sides[next[x.column]++] = {h, sides_[h].along};
    }
  }

  const Signed_incidence& in_;
  std::vector<Ends> ends_;
  std::vector<Side> sides_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INCIDENCE_READER_H
