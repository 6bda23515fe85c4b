// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Crossed_pieces.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Merged_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/expect_middle.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/overlay_subdivisions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Cuts the faces of the second subdivision along the edges of the input that cross them.
class Piece_cutter {
public:
  Piece_cutter(const Common_subdivision& first, const Common_subdivision& second,
               const Input& input, const Gluing_map& middle)
      : a_(first), b_(second), input_(input), crossed_(first, second, input, middle) {}

  Overlaid_subdivision run() {
    s_.number_of_input_vertices = input_.number_of_rows();
    s_.number_of_intrinsic_vertices =
        crossed_.row(static_cast<std::uint32_t>(b_.number_of_vertices()));
    s_.crossings = crossed_.crossings();
    add_vertices();
    for (std::uint32_t f = 0; f < b_.number_of_faces(); ++f) cut(f);
    return {std::move(s_), crossed_.corners()};
  }

private:
  static constexpr std::uint32_t none = Common_subdivision::none;

  // A point of the border of a face of the second subdivision.
  struct Point {
    std::uint32_t vertex;          // of the result
    std::uint32_t corner;          // of the face; the point is there or on the side from there
    std::uint32_t entering = none; // see `Crossed_pieces`
  };
  // An end of a cut.
  struct Cut_end {
    std::size_t point, other;
    std::uint32_t side; // of the first subdivision, that runs from this end
  };
  // A corner of a cell. Its side is a cut, or part of the border.
  struct Cell_corner {
    std::size_t point;
    std::uint32_t cut = none; // side of the first subdivision
  };

  bool is_crossing(std::uint32_t vertex) const { return vertex >= s_.vertices.size(); }

  // ---- Vertices ----

  void add_vertices() {
    for (std::uint32_t v = 0; v < b_.number_of_vertices(); ++v) {
      Common_subdivision::Vertex vertex;
      if (v < b_.vertices.size()) vertex = b_.vertices[v];
      vertex.intrinsic = crossed_.row(v);
      s_.vertices.push_back(vertex);
    }
    for (std::uint32_t c = 0; c < b_.corner.size(); ++c)
      if (b_.corner[c] >= b_.vertices.size() && b_.input_halfedge[c] % 2 == 0) place_inserted(c);
  }

  // Places a crossing of the second subdivision on the part of its middle edge in the first one.
  void place_inserted(std::uint32_t corner) {
    const auto x = static_cast<std::uint32_t>(b_.corner[corner] - b_.vertices.size());
    const std::uint32_t from = crossed_.edges().first_around(x, b_.input_halfedge[corner]),
                        to = crossed_.first().next(from), base = a_.input_halfedge[from];
    const auto parameter = [this](std::uint32_t c, double at_vertex) {
      return is_vertex_of_first(c)
                 ? at_vertex
                 : a_.crossings[a_.corner[c] - a_.vertices.size()].on_intrinsic.parameter;
    };
    const double start = parameter(from, 0), end = parameter(to, 1),
                 ratio = (b_.crossings[x].on_input.parameter - start) / (end - start),
                 part = first_at(b_.corner[corner]) != none ? 0
                        : std::isfinite(ratio)              ? std::clamp(ratio, 0., 1.)
                                                            : 0.5;
    const std::array<double, 3> p = corner_in_input_face(input_, a_, base, from),
                                q = corner_in_input_face(input_, a_, base, to);
    Common_subdivision::Vertex& v = s_.vertices[b_.corner[corner]];
    v.kind = Subdivision_vertex_kind::inserted;
    v.input_halfedge = base;
    v.input_face = input_.face(base);
    v.on_input.size = 3;
    for (std::uint32_t k = 0, h = base; k < 3; ++k, h = input_.next(h)) {
      v.on_input.vertices[k] = input_.names().row(input_.source(h));
      v.on_input.weights[k] = (1 - part) * p[k] + part * q[k];
    }
  }

  // The crossing of the first subdivision at a vertex of the second one, or `none`.
  std::uint32_t first_at(std::uint32_t vertex) const {
    return vertex < b_.vertices.size()
               ? none
               : crossed_.edges().first_at(static_cast<std::uint32_t>(vertex - b_.vertices.size()));
  }
  bool is_vertex_of_first(std::uint32_t c) const { return a_.corner[c] < a_.vertices.size(); }

  // ---- One face of the second subdivision ----

  [[noreturn]] void fail() const { crossed_.fail(b_.face_begin[face_]); }

  void cut(std::uint32_t f) {
    face_ = f;
    collect_points();
    find_cuts();
    std::vector<std::vector<Cell_corner>> open(1); // cells, each inside the one before
    std::size_t next = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      open.back().push_back({i});
      for (; next < cuts_.size() && cuts_[next].point == i; ++next) {
        open.back().back().cut = cuts_[next].side;
        if (cuts_[next].other < i) {
          if (open.size() == 1) fail();
          finish(open.back());
          open.pop_back();
        } else {
          open.emplace_back();
        }
        open.back().push_back({i});
      }
    }
    finish(open.back());
  }

  void collect_points() {
    points_.clear();
    const auto vertices = static_cast<std::uint32_t>(s_.vertices.size());
    for (std::uint32_t c = b_.face_begin[face_]; c < b_.face_begin[face_ + 1]; ++c) {
      points_.push_back({b_.corner[c], c, crossed_.entering_at(c)});
      const std::uint32_t h = crossed_.halfedge(c), begin = crossed_.crossings_begin(h / 2),
                          end = crossed_.crossings_begin(h / 2 + 1);
      for (std::uint32_t n = 0; n < end - begin; ++n) {
        const std::uint32_t x = h % 2 == 0 ? begin + n : end - 1 - n;
        points_.push_back({vertices + x, c, crossed_.entering(x, c)});
      }
    }
  }

  // Pairs the points where edges of the input enter the face: an edge that enters once ends at a
  // vertex of both. At each point cuts are in the order in which cells end there and then begin.
  void find_cuts() {
    std::vector<std::pair<std::uint32_t, std::size_t>> sides; // the less of both, and the point
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (const std::uint32_t e = points_[i].entering; e != none)
        sides.emplace_back(std::min(e, crossed_.partner(e)), i);
    std::sort(sides.begin(), sides.end());
    cuts_.clear();
    for (std::size_t n = 0; n < sides.size(); ++n) {
      const std::size_t i = sides[n].second;
      const bool is_pair = n + 1 < sides.size() && sides[n + 1].first == sides[n].first;
      const std::size_t j = is_pair ? sides[++n].second : corner_at_end(points_[i].entering);
      cuts_.push_back({i, j, points_[i].entering});
      cuts_.push_back({j, i, crossed_.partner(points_[i].entering)});
    }
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut_end& p, const Cut_end& q) {
      return std::tuple(p.point, p.other > p.point, q.other) <
             std::tuple(q.point, q.other > q.point, p.other);
    });
  }

  // The corner of the face, at a middle vertex, at which a side of the first subdivision ends.
  std::size_t corner_at_end(std::uint32_t side) const {
    const std::uint32_t h = a_.intrinsic_halfedge[crossed_.first().next(side)];
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (points_[i].vertex < b_.vertices.size() && b_.input_halfedge[points_[i].corner] == h)
        return i;
    fail();
  }

  // ---- One cell ----

  void finish(const std::vector<Cell_corner>& cell) {
    const std::uint32_t face = face_of_first(cell),
                        input_face = input_.face(a_.input_halfedge[a_.face_begin[face]]);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Point& p = points_[cell[k].point];
      const std::uint32_t before = cell[k == 0 ? cell.size() - 1 : k - 1].cut;
      s_.corner.push_back(p.vertex);
      s_.intrinsic_halfedge.push_back(crossed_.halfedge(p.corner));
      s_.side.push_back(side(p, cell[k].cut));
      s_.input_halfedge.push_back(
          is_crossing(p.vertex) ? a_.input_halfedge[cell[k].cut == none ? before : cell[k].cut]
                                : input_halfedge(p, face));
      if (p.vertex < b_.vertices.size()) s_.vertices[p.vertex].input_face = input_face;
    }
    s_.face_begin.push_back(static_cast<std::uint32_t>(s_.corner.size()));
    s_.input_face.push_back(input_face);
    s_.intrinsic_face.push_back(face_);
  }

  // The face of the first subdivision that contains a cell: some side of the cell is part of a
  // middle edge or of an input edge.
  std::uint32_t face_of_first(const std::vector<Cell_corner>& cell) const {
    for (const Cell_corner& c : cell) {
      if (c.cut != none) return crossed_.first().face(c.cut);
      if (b_.side[points_[c.point].corner].input_edge != none)
        return crossed_.first().face(first_along(points_[c.point]));
    }
    fail();
  }

  // The corner of the first subdivision whose side contains what follows a point of a middle edge.
  std::uint32_t first_along(const Point& p) const {
    const std::uint32_t h = b_.input_halfedge[p.corner];
    if (is_crossing(p.vertex)) // the edge of the input comes from the cell before
      return crossed_.first().next(crossed_.partner(p.entering));
    if (p.vertex < b_.vertices.size()) return crossed_.edges().first()[h].front();
    return crossed_.edges().first_around(p.vertex - static_cast<std::uint32_t>(b_.vertices.size()),
                                         h);
  }

  Common_subdivision::Side side(const Point& p, std::uint32_t cut) const {
    if (cut != none) return {a_.side[cut].input_edge, none};
    const std::uint32_t edge = crossed_.halfedge(p.corner) / 2;
    return {b_.side[p.corner].input_edge == none ? crossed_.input_edge(edge)
                                                 : a_.side[first_along(p)].input_edge,
            edge};
  }

  // The halfedge of the input at a vertex that is not a crossing.
  std::uint32_t input_halfedge(const Point& p, std::uint32_t face) const {
    const std::uint32_t h = b_.input_halfedge[p.corner];
    if (const std::uint32_t x = first_at(p.vertex);
        x != none || p.vertex < b_.vertices.size()) { // a corner of the face, too
      for (std::uint32_t c = a_.face_begin[face]; c < a_.face_begin[face + 1]; ++c)
        if (a_.intrinsic_halfedge[c] == h &&
            (x == none ? is_vertex_of_first(c) : a_.corner[c] == a_.vertices.size() + x))
          return a_.input_halfedge[c];
      fail();
    }
    const std::uint32_t base = s_.vertices[p.vertex].input_halfedge;
    const bool is_on_edge = a_.side[first_along(p)].input_edge != none;
    return is_on_edge && h % 2 != 0 ? base ^ 1U : base;
  }

  const Common_subdivision &a_, &b_;
  const Input& input_;
  Crossed_pieces crossed_;
  Common_subdivision s_;
  // of the face at hand
  std::uint32_t face_ = 0;
  std::vector<Point> points_;
  std::vector<Cut_end> cuts_;
};

} // namespace

} // namespace internal

Overlaid_subdivision overlay_subdivisions(const Common_subdivision& first,
                                          const Common_subdivision& second, const Input& input,
                                          const Gluing_map& middle) {
  using internal::Subdivided;
  internal::expect_arrays(first, Subdivided::intrinsic, middle, input.number_of_halfedges());
  internal::expect_arrays(second, Subdivided::input, middle,
                          2 * internal::intrinsic_edge_bound(second));
  return internal::Piece_cutter(first, second, input, middle).run();
}

} // namespace CGAL::Intrinsic_triangulations
