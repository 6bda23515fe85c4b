// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/Piece_places.h>
#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.h>
#include <CGAL/Intrinsic_conformal/layout/turn_back.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Cuts a subdivision open and lays it out.
class Subdivision_opener {
public:
  explicit Subdivision_opener(const Flat_subdivision& in)
      : in_(in), places_(expect_sizes(in)), s_(places_.pieces()), gluer_(s_) {}

  Subdivision_layout run() {
    uncut_ = glue_ = gluer_.run();
    open_sides();
    number_copies();
    copy_faces();
    layout_.is_hyperbolic = in_.is_hyperbolic;
    if (in_.is_hyperbolic)
      lay_out_in_disk();
    else
      lay_out_in_plane();
    if (!in_.input_lengths.empty()) compute_weights();
    return std::move(layout_);
  }

private:
  static constexpr std::uint32_t none = Common_subdivision::none;

  static const Flat_subdivision& expect_sizes(const Flat_subdivision& in) {
    const auto check = [](std::size_t given, std::size_t least, const char* what) {
      if (given < least)
        throw Invalid_input(Element_kind::none, 0,
                            std::to_string(given) + what + ", but " + std::to_string(least) +
                                " are needed; give one for each");
    };
    check(in.flat.length.size(), in.flat.gluing.origin.size(), " sides have lengths");
    std::size_t halfedges = 0;
    for (const std::uint32_t h : in.subdivision.intrinsic_halfedge)
      if (h != none) halfedges = std::max(halfedges, std::size_t{h} + 1);
    check(in.flat.side.size(), halfedges, " halfedges have sides");
    if (!in.is_cone.empty())
      check(in.is_cone.size(), in.flat.gluing.number_of_vertices, " vertices are marked");
    if (!in.factors.empty())
      check(in.factors.size(), in.flat.gluing.number_of_vertices, " vertices have factors");
    const auto edges = [](const Common_subdivision& s) {
      std::size_t bound = 0;
      for (const Common_subdivision::Side& side : s.side)
        if (side.input_edge != none) bound = std::max(bound, std::size_t{side.input_edge} + 1);
      return bound;
    };
    const Common_subdivision& pieces =
        in.overlay == nullptr ? in.subdivision : in.overlay->subdivision;
    std::size_t faces = 0;
    for (const std::uint32_t f : pieces.input_face) faces = std::max(faces, std::size_t{f} + 1);
    check(in.is_cut.size(), edges(pieces), " edges of the input are marked");
    if (!in.input_lengths.empty() || in.overlay != nullptr)
      check(in.input_lengths.size(), edges(in.subdivision), " edges have lengths");
    if (!in.is_wanted.empty()) check(in.is_wanted.size(), faces, " faces are marked");
    return in;
  }

  bool is_wanted(std::uint32_t f) const {
    return in_.is_wanted.empty() || in_.is_wanted[s_.input_face[f]] != 0;
  }

  // Nothing is glued at cut edges, and to faces that are left out.
  void open_sides() {
    for (std::uint32_t c = 0; c < glue_.size(); ++c) {
      const std::uint32_t e = s_.side[c].input_edge, partner = glue_[c];
      if (partner == none) continue;
      if ((e != none && in_.is_cut[e] != 0) || !is_wanted(gluer_.face(c)) ||
          !is_wanted(gluer_.face(partner)))
        glue_[c] = glue_[partner] = none;
    }
  }

  // Corners that are glued together are a vertex; vertices of the triangulation come first.
  void number_copies() {
    const std::vector<std::uint32_t> least =
        joined_sets(s_.corner.size(), [this](const auto& join) {
          for (std::uint32_t c = 0; c < glue_.size(); ++c)
            if (glue_[c] != none) join(c, gluer_.next(glue_[c]));
        });
    copy_.assign(s_.corner.size(), none);
    for (const bool is_crossing : {false, true})
      for (std::uint32_t c = 0; c < copy_.size(); ++c) {
        const std::uint32_t v = s_.corner[c];
        if (!is_wanted(gluer_.face(c)) || (v >= s_.vertices.size()) != is_crossing) continue;
        if (copy_[least[c]] == none) {
          copy_[least[c]] = static_cast<std::uint32_t>(layout_.original_vertex.size());
          layout_.original_vertex.push_back(v);
          if (is_crossing)
            layout_.subdivision.crossings.push_back(s_.crossings[v - s_.vertices.size()]);
          else
            layout_.subdivision.vertices.push_back(s_.vertices[v]);
        }
        copy_[c] = copy_[least[c]];
      }
  }

  void copy_faces() {
    Common_subdivision& r = layout_.subdivision;
    r.number_of_input_vertices = s_.number_of_input_vertices;
    r.number_of_intrinsic_vertices = s_.number_of_intrinsic_vertices;
    for (std::uint32_t f = 0; f < s_.number_of_faces(); ++f) {
      if (!is_wanted(f)) continue;
      for (std::uint32_t c = s_.face_begin[f]; c < s_.face_begin[f + 1]; ++c) {
        r.corner.push_back(copy_[c]);
        r.side.push_back(s_.side[c]);
        r.intrinsic_halfedge.push_back(s_.intrinsic_halfedge[c]);
        r.input_halfedge.push_back(s_.input_halfedge[c]);
        if (glue_[c] == none) ++r.number_of_border_edges;
        original_corner_.push_back(c);
      }
      r.face_begin.push_back(static_cast<std::uint32_t>(r.corner.size()));
      r.input_face.push_back(s_.input_face[f]);
      r.intrinsic_face.push_back(s_.intrinsic_face[f]);
      if (!s_.sheet.empty()) r.sheet.push_back(s_.sheet[f]);
      layout_.original_face.push_back(f);
    }
  }

  // For each corner the corner of the layout that the one with this partner is.
  std::vector<std::uint32_t> partners(const std::vector<std::uint32_t>& glue) const {
    std::vector<std::uint32_t> corner(s_.corner.size(), none);
    for (std::uint32_t c = 0; c < original_corner_.size(); ++c) corner[original_corner_[c]] = c;
    std::vector<std::uint32_t> result;
    for (const std::uint32_t c : original_corner_)
      result.push_back(glue[c] == none ? none : corner[glue[c]]);
    return result;
  }

  Glued_pieces glued_pieces() const {
    const Common_subdivision& r = layout_.subdivision;
    return {static_cast<std::uint32_t>(r.number_of_vertices()), r.face_begin, r.corner,
            partners(glue_)};
  }

  void lay_out_in_plane() {
    Plane_pieces p{glued_pieces(), {}, {}};
    p.turn.assign(p.vertex.size(), 1);
    for (std::uint32_t f = 0; f < p.size(); ++f)
      for (std::uint32_t c = p.begin[f]; c < p.begin[f + 1]; ++c) {
        p.side.push_back(place(p.next(f, c)) - place(c));
        if (p.glue[c] != none && side(c) != none)
          p.turn[c] = places_.turn(side(c), side(p.glue[c]));
      }
    const Developed<Plane_pieces> developed = develop(p);
    layout_.positions = developed.rows();
    pack_components(layout_.positions, components());
    layout_.largest_side_error = developed.largest_error;
  }

  void lay_out_in_disk() {
    Disk_pieces p{glued_pieces(), {}, {}};
    p.turn.resize(p.vertex.size());
    std::vector<std::uint32_t> partner = partners(uncut_);
    for (std::uint32_t c = 0; c < p.vertex.size(); ++c) {
      p.place.push_back(Disk_point::at(place(c)));
      if (partner[c] == none) continue;
      if (side(c) != none) p.turn[c] = places_.motion(side(c), side(partner[c]));
      if (p.glue[c] != none) partner[c] = none; // no seam
    }
    const Developed_disk developed = develop(p);
    layout_.positions = developed.rows();
    layout_.largest_side_error = developed.largest_error;
    layout_.radius = developed.radius;
    std::vector<char> is_cone(p.number_of_vertices, 0);
    for (std::uint32_t c = 0; c < p.vertex.size() && !in_.is_cone.empty(); ++c)
      if (s_.kind(s_.corner[original_corner_[c]]) == Subdivision_vertex_kind::input)
        is_cone[p.vertex[c]] = in_.is_cone[places_.vertex(original_corner_[c])];
    layout_.pairings = side_pairings(p, developed, find_seams(p, partner, is_cone), is_cone);
  }

  // the place of a corner of the layout in the frame of its flat triangle
  std::complex<double> place(std::uint32_t c) const { return places_.at(original_corner_[c]).z; }
  // the side of the flat surface that a side of the layout lies on, or `none`
  std::uint32_t side(std::uint32_t c) const { return places_.side(original_corner_[c]); }

  // the least vertex of the component of each vertex
  std::vector<std::uint32_t> components() const {
    const Common_subdivision& r = layout_.subdivision;
    return joined_sets(r.number_of_vertices(), [&r](const auto& join) {
      for (std::size_t f = 0; f < r.number_of_faces(); ++f)
        for (const std::uint32_t v : r.face(f)) join(r.face(f)[0], v);
    });
  }

  void compute_weights() {
    const std::vector<std::uint32_t>& corner = layout_.subdivision.corner;
    layout_.weights.setOnes(static_cast<Eigen::Index>(layout_.subdivision.number_of_vertices()));
    for (std::uint32_t c = 0; c < corner.size(); ++c)
      layout_.weights[static_cast<Eigen::Index>(corner[c])] = places_.at(original_corner_[c]).q;
  }

  const Flat_subdivision& in_;
  Piece_places places_;
  const Common_subdivision& s_; // the pieces
  Piece_gluer gluer_;
  std::vector<std::uint32_t> glue_, uncut_; // by corners of the subdivision
  std::vector<std::uint32_t> copy_;         // the vertex after the cut at each of those
  std::vector<std::uint32_t> original_corner_;
  Subdivision_layout layout_;
};

// u at each vertex: -log q at those of the input, and linear on its faces between them.
Eigen::VectorXd log_scale(const Subdivision_layout& layout) {
  const Common_subdivision& s = layout.subdivision;
  std::map<std::uint32_t, double> u;
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v)
    if (s.kind(v) == Subdivision_vertex_kind::input)
      u[s.on_input(v).vertices[0]] = -std::log(layout.weights[v]);
  Eigen::VectorXd result(layout.weights.size());
  for (std::uint32_t v = 0; v < s.number_of_vertices(); ++v) {
    const Weighted_vertices on = s.on_input(v);
    result[v] = 0;
    for (std::size_t i = 0; i < on.size; ++i) result[v] += on.weights[i] * u.at(on.vertices[i]);
  }
  return result;
}

} // namespace

} // namespace internal

Subdivision_layout lay_out_subdivision(const Flat_subdivision& s) {
  Subdivision_layout layout = internal::Subdivision_opener(s).run();
  if (!layout.is_hyperbolic)
    internal::turn_back(internal::triangles_of_pieces(layout.subdivision), layout.positions);
  return layout;
}

std::vector<std::array<double, 2>> corner_coordinates(const Subdivision_layout& layout,
                                                      std::size_t halfedges) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 2>> result(halfedges, {unknown, unknown});
  const Common_subdivision& s = layout.subdivision;
  for (std::size_t c = 0; c < s.corner.size(); ++c) {
    if (s.kind(s.corner[c]) != Subdivision_vertex_kind::input) continue;
    const auto v = static_cast<Eigen::Index>(s.corner[c]);
    result.at(s.input_halfedge[c]) = {layout.positions(v, 0), layout.positions(v, 1)};
  }
  return result;
}

Map_certificate certify_map(const Subdivision_layout& layout) {
  return certify_map(internal::triangles_of_pieces(layout.subdivision), layout.positions);
}

std::size_t flipped_geodesic_triangles(const Subdivision_layout& layout) {
  std::size_t flipped = 0;
  for (const std::array<std::uint32_t, 3>& t : internal::triangles_of_pieces(layout.subdivision))
    if (internal::is_turned_in_disk(layout.positions, t)) ++flipped;
  return flipped;
}

std::vector<Subdivision_field> fields_of_layout(const Subdivision_layout& layout) {
  const Eigen::MatrixX2d& z = layout.positions;
  std::vector<Subdivision_field> result;
  result.emplace_back("u", Eigen::VectorXd(z.col(0)));
  result.emplace_back("v", Eigen::VectorXd(z.col(1)));
  if (layout.weights.size() == 0) return result;
  std::vector<std::array<double, 3>> homogeneous;
  for (Eigen::Index v = 0; v < z.rows(); ++v) {
    std::array<double, 3> point{z(v, 0), z(v, 1), 1};
    if (const double square = z.row(v).squaredNorm(); layout.is_hyperbolic)
      point = {2 * point[0] / (1 - square), 2 * point[1] / (1 - square),
               (1 + square) / (1 - square)};
    for (double& x : point) x *= layout.weights[v];
    homogeneous.push_back(point);
  }
  result.emplace_back("homogeneous_uv", homogeneous);
  result.emplace_back("log_scale", internal::log_scale(layout));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
