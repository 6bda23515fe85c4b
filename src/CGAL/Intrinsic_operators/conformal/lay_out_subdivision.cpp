// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/conformal/Piece_gluer.h>
#include <CGAL/Intrinsic_operators/conformal/Plane_pieces.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_subdivision.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Cuts a subdivision open and lays it out.
class Subdivision_developer {
public:
  explicit Subdivision_developer(const Flat_subdivision& in)
      : in_(in), s_(in.subdivision), gluer_(in.subdivision) {
    const auto check = [](std::size_t given, std::size_t least, const char* what) {
      if (given < least)
        throw Invalid_input(Element_kind::none, 0,
                            std::to_string(given) + what + ", but " + std::to_string(least) +
                                " are needed; give one for each");
    };
    check(in.flat.length.size(), in.flat.gluing.origin.size(), " sides have lengths");
    if (!in.factors.empty())
      check(in.factors.size(), in.flat.gluing.number_of_vertices, " vertices have factors");
    std::size_t edges = 0, faces = 0;
    for (const Common_subdivision::Side& side : s_.side)
      if (side.input_edge != none) edges = std::max(edges, std::size_t{side.input_edge} + 1);
    for (const std::uint32_t f : s_.input_face) faces = std::max(faces, std::size_t{f} + 1);
    check(in.is_cut.size(), edges, " edges of the input are marked");
    if (!in.input_lengths.empty()) check(in.input_lengths.size(), edges, " edges have lengths");
    if (!in.is_wanted.empty()) check(in.is_wanted.size(), faces, " faces are marked");
  }

  Subdivision_layout run() {
    glue_ = gluer_.run();
    open_sides();
    number_copies();
    copy_faces();
    sides_ = sides_of_triangles(in_.flat);
    const Developed_pieces developed = develop(pieces());
    layout_.positions = rows_of_points(developed.position);
    layout_.largest_side_error = developed.largest_error;
    if (!in_.input_lengths.empty()) compute_weights();
    return std::move(layout_);
  }

private:
  static constexpr std::uint32_t none = Common_subdivision::none;

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

  Plane_pieces pieces() const {
    const Common_subdivision& r = layout_.subdivision;
    Plane_pieces p;
    p.number_of_vertices = static_cast<std::uint32_t>(r.number_of_vertices());
    p.begin = r.face_begin;
    p.vertex = r.corner;
    p.turn.assign(r.corner.size(), 1);
    p.glue.assign(r.corner.size(), none);
    std::vector<std::uint32_t> corner(s_.corner.size(), none);
    for (std::uint32_t c = 0; c < original_corner_.size(); ++c) corner[original_corner_[c]] = c;
    for (std::uint32_t f = 0; f < p.size(); ++f)
      for (std::uint32_t c = p.begin[f]; c < p.begin[f + 1]; ++c) {
        p.side.push_back(place(p.next(f, c)) - place(c));
        const std::uint32_t partner = glue_[original_corner_[c]];
        if (partner == none) continue;
        p.glue[c] = corner[partner];
        if (r.side[c].intrinsic_edge != none)
          p.turn[c] = turn_across(sides_[side(c)], sides_[side(p.glue[c])]);
      }
    return p;
  }

  // the side of the flat surface that a corner is on, or starts at
  std::uint32_t side(std::uint32_t c) const {
    return in_.side[layout_.subdivision.intrinsic_halfedge[c]];
  }
  // the place of a corner in the frame of its intrinsic face
  std::complex<double> place(std::uint32_t c) const {
    const Common_subdivision& r = layout_.subdivision;
    const std::uint32_t h = side(c);
    std::complex<double> z = 0;
    for (std::uint32_t i = h - h % 3; i < h; ++i) z += sides_[i];
    if (r.corner[c] < r.vertices.size()) return z;
    const double p = r.crossings[r.corner[c] - r.vertices.size()].on_intrinsic.parameter;
    return z + (r.intrinsic_halfedge[c] % 2 == 0 ? p : 1 - p) * sides_[h];
  }

  void compute_weights() {
    const Common_subdivision& r = layout_.subdivision;
    layout_.weights.setOnes(static_cast<Eigen::Index>(r.number_of_vertices()));
    for (std::uint32_t c = 0; c < r.corner.size(); ++c) {
      double& weight = layout_.weights[static_cast<Eigen::Index>(r.corner[c])];
      if (r.corner[c] < r.vertices.size()) {
        const double w = in_.factors.empty() ? 1 : in_.factors[in_.flat.gluing.origin[side(c)]];
        weight = 1 / (w * w);
        continue;
      }
      const Common_subdivision::Crossing& x = r.crossings[r.corner[c] - r.vertices.size()];
      const double p = x.on_input.parameter, q = x.on_intrinsic.parameter;
      weight = in_.input_lengths[x.on_input.edge] / in_.flat.length[side(c)] *
               std::sqrt(p * (1 - p) / (q * (1 - q)));
    }
  }

  const Flat_subdivision& in_;
  const Common_subdivision& s_;
  Piece_gluer gluer_;
  std::vector<std::uint32_t> glue_; // by corners of the subdivision
  std::vector<std::uint32_t> copy_; // the vertex after the cut at each of those
  std::vector<std::uint32_t> original_corner_;
  std::vector<std::complex<double>> sides_; // of the flat surface
  Subdivision_layout layout_;
};

} // namespace

} // namespace internal

Subdivision_layout lay_out_subdivision(const Flat_subdivision& s) {
  return internal::Subdivision_developer(s).run();
}

std::vector<std::array<double, 2>> corner_coordinates(const Subdivision_layout& layout,
                                                      std::size_t halfedges) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 2>> result(halfedges, {unknown, unknown});
  const Common_subdivision& s = layout.subdivision;
  for (std::size_t c = 0; c < s.corner.size(); ++c) {
    if (s.corner[c] >= s.vertices.size()) continue;
    const auto v = static_cast<Eigen::Index>(s.corner[c]);
    result.at(s.input_halfedge[c]) = {layout.positions(v, 0), layout.positions(v, 1)};
  }
  return result;
}

Map_certificate certify_map(const Subdivision_layout& layout) {
  const Common_subdivision& s = layout.subdivision;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t k = 2; k < s.face(f).size(); ++k)
      triangles.push_back({s.face(f)[0], s.face(f)[k - 1], s.face(f)[k]});
  return certify_map(triangles, layout.positions);
}

std::vector<Subdivision_field> fields_of_layout(const Subdivision_layout& layout) {
  const Eigen::MatrixX2d& z = layout.positions;
  std::vector<Subdivision_field> result;
  result.emplace_back("u", Eigen::VectorXd(z.col(0)));
  result.emplace_back("v", Eigen::VectorXd(z.col(1)));
  if (layout.weights.size() == 0) return result;
  std::vector<std::array<double, 3>> homogeneous;
  for (Eigen::Index v = 0; v < z.rows(); ++v)
    homogeneous.push_back(
        {z(v, 0) * layout.weights[v], z(v, 1) * layout.weights[v], layout.weights[v]});
  result.emplace_back("homogeneous_uv", homogeneous);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
