// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/expect_middle.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void fail_middle(Element_kind kind, std::size_t element, Subdivided middle) {
  throw Invalid_input::about(
      kind, element,
      middle == Subdivided::intrinsic
          ? " of the middle triangulation is not that of the first subdivision; compute this from "
            "the triangulation as it is now, without border and without inserted vertices"
          : " of the middle triangulation is not that of the second subdivision; compute this from "
            "a triangulation that was built from the middle one as it is now");
}

namespace {

class Middle_checker {
public:
  Middle_checker(const Common_subdivision& s, Subdivided middle, const Gluing_map& mesh)
      : s_(s), mesh_(mesh), middle_(middle) {}

  void expect_arrays(std::size_t others) const {
    const std::size_t corners = s_.corner.size(), faces = s_.face_begin.size() - 1;
    const bool has_sizes =
        !s_.face_begin.empty() && s_.face_begin[0] == 0 && s_.face_begin.back() == corners &&
        s_.side.size() == corners && s_.intrinsic_halfedge.size() == corners &&
        s_.input_halfedge.size() == corners && s_.input_face.size() == faces &&
        s_.intrinsic_face.size() == faces;
    if (!has_sizes) fail_arrays();
    for (std::size_t f = 0; f < faces; ++f)
      if (s_.face_begin[f + 1] > corners || s_.face_begin[f + 1] < s_.face_begin[f] + 3)
        fail_arrays();
    const std::size_t bound = intrinsic_edge_bound(s_);
    for (const Common_subdivision::Crossing& x : s_.crossings)
      if (x.on_intrinsic.edge >= bound) fail_arrays();
    for (std::uint32_t v = 0; v < s_.vertices.size(); ++v)
      if (s_.kind(v) != Subdivision_vertex_kind::input)
        fail_middle(Element_kind::vertex, v, middle_);
    for (std::uint32_t f = 0; f < faces; ++f)
      for (std::uint32_t c = s_.face_begin[f]; c < s_.face_begin[f + 1]; ++c) {
        if (halfedge(c) >= mesh_.number_of_halfedges())
          fail_middle(Element_kind::halfedge, halfedge(c), middle_);
        if (!is_valid(c, others) || face(c) == none || face(c) != face(s_.face_begin[f]))
          fail_middle(Element_kind::edge, halfedge(c) / 2, middle_);
        if (is_intrinsic() && s_.intrinsic_face[f] != face(c))
          fail_middle(Element_kind::face, face(c), middle_);
      }
  }

  void expect_paths(const Piece_gluer& pieces, const std::vector<std::uint32_t>& glue,
                    const Corners_along& along) {
    expect_vertices();
    std::size_t crossings = 0, sides = 0;
    for (std::uint32_t e = 0; e < mesh_.number_of_edges(); ++e) {
      const auto there = along[2 * e], back = along[2 * e + 1];
      if (!is_path(pieces, glue, there) || !is_path(pieces, glue, back) || !fit(there, back))
        fail_middle(Element_kind::edge, e, middle_);
      crossings += there.size() - 1;
      sides += 2 * there.size();
    }
    for (std::uint32_t c = 0; c < glue.size(); ++c) {
      const bool is_inside = edge_of_side(c) == none;
      sides += is_inside ? 1 : 0;
      if (is_inside && (glue[c] == none || face(glue[c]) != face(c)))
        fail_middle(Element_kind::face, face(c), middle_);
    }
    if (crossings != s_.crossings.size() || sides != s_.corner.size())
      fail_middle(Element_kind::edge, 0, middle_);
  }

private:
  static constexpr std::uint32_t none = Common_subdivision::none;

  [[noreturn]] void fail_arrays() const {
    throw Invalid_input(Element_kind::none, 0,
                        std::string("arrays of the ") + (is_intrinsic() ? "first" : "second") +
                            " subdivision disagree; take it from common_subdivision()");
  }

  bool is_intrinsic() const { return middle_ == Subdivided::intrinsic; }
  // the halfedge of the middle triangulation at a corner, and of the other one
  std::uint32_t halfedge(std::uint32_t c) const {
    return is_intrinsic() ? s_.intrinsic_halfedge[c] : s_.input_halfedge[c];
  }
  std::uint32_t other_halfedge(std::uint32_t c) const {
    return is_intrinsic() ? s_.input_halfedge[c] : s_.intrinsic_halfedge[c];
  }
  std::uint32_t face(std::uint32_t c) const {
    return mesh_.face(Gluing_map::Halfedge{halfedge(c)}).index;
  }
  std::uint32_t edge_of_side(std::uint32_t c) const {
    return is_intrinsic() ? s_.side[c].intrinsic_edge : s_.side[c].input_edge;
  }
  bool is_crossing(std::uint32_t c) const { return s_.corner[c] >= s_.vertices.size(); }

  // Whether the numbers at a corner are in range and fit together.
  bool is_valid(std::uint32_t c, std::size_t others) const {
    if (s_.corner[c] >= s_.number_of_vertices() || other_halfedge(c) >= others) return false;
    const auto& [input_edge, intrinsic_edge] = s_.side[c];
    if ((input_edge != none && input_edge != s_.input_halfedge[c] / 2) ||
        (intrinsic_edge != none && intrinsic_edge != s_.intrinsic_halfedge[c] / 2))
      return false;
    if (!is_crossing(c)) return true;
    const Common_subdivision::Crossing& x = s_.crossings[s_.corner[c] - s_.vertices.size()];
    return x.on_input.edge == s_.input_halfedge[c] / 2 &&
           x.on_intrinsic.edge == s_.intrinsic_halfedge[c] / 2;
  }

  // Each vertex of the triangulation is one of the subdivision.
  void expect_vertices() const {
    std::vector<std::uint32_t> vertex(mesh_.number_of_vertices(), none),
        number(s_.vertices.size(), none);
    for (std::uint32_t c = 0; c < s_.corner.size(); ++c) {
      if (is_crossing(c)) continue;
      const std::uint32_t v = mesh_.source(Gluing_map::Halfedge{halfedge(c)}).index,
                          w = s_.corner[c];
      if (vertex[v] == none && number[w] == none) {
        vertex[v] = w;
        number[w] = v;
      }
      if (vertex[v] != w || number[w] != v) fail_middle(Element_kind::vertex, v, middle_);
    }
  }

  // Whether corners along a halfedge begin and end at vertices, and at each crossing between there
  // is a side from inside of the face.
  bool is_path(const Piece_gluer& pieces, const std::vector<std::uint32_t>& glue,
               std::span<const std::uint32_t> corners) const {
    if (corners.empty() || is_crossing(corners[0]) || is_crossing(pieces.next(corners.back())))
      return false;
    for (const std::uint32_t c : corners.subspan(1))
      if (!is_crossing(c) || edge_of_side(pieces.previous(c)) != none ||
          glue[pieces.previous(c)] == none)
        return false;
    return mesh_.source(Gluing_map::Halfedge{halfedge(pieces.next(corners.back()))}) ==
           mesh_.target(Gluing_map::Halfedge{halfedge(corners[0])});
  }

  // Whether both sides of an edge have the same crossings.
  bool fit(std::span<const std::uint32_t> there, std::span<const std::uint32_t> back) const {
    if (there.size() != back.size()) return false;
    for (std::size_t i = 1; i < there.size(); ++i)
      if (s_.corner[there[i]] != s_.corner[back[back.size() - i]]) return false;
    return true;
  }

  const Common_subdivision& s_;
  const Gluing_map& mesh_;
  Subdivided middle_;
};

} // namespace

void expect_arrays(const Common_subdivision& s, Subdivided middle, const Gluing_map& mesh,
                   std::size_t others) {
  Middle_checker(s, middle, mesh).expect_arrays(others);
}

void expect_paths(const Piece_gluer& pieces, const std::vector<std::uint32_t>& glue,
                  Subdivided middle, const Corners_along& along, const Gluing_map& mesh) {
  Middle_checker(pieces.subdivision(), middle, mesh).expect_paths(pieces, glue, along);
}

} // namespace CGAL::Intrinsic_triangulations::internal
