// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/Piece_places.h>
#include <CGAL/Intrinsic_conformal/layout/turn_back.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

class Front_layout {
public:
  explicit Front_layout(const Scaled_surface& surface)
      : in_(surface), mesh_(surface.mesh ? surface.mesh->triangles : surface.start),
        opened_(mesh_) {}

  Scaled_layout run(const Flat_torus* torus) {
    for (const Surface_to_cut* surface : {&in_.start, &in_.flat, &mesh_})
      if (surface->side.empty())
        throw Invalid_input(Element_kind::none, 0,
                            "a surface does not tell the sides of its halfedges; make it with "
                            "flat_surface()");
    find_front();
    const std::vector<char> is_cut = edges_to_cut();
    const Flat_subdivision in = arrays(is_cut);
    layout_ = lay_out_subdivision(in);
    Scaled_layout result;
    result.distortion = measure_distortion(pieces(), layout_.positions);
    if (torus != nullptr) change_basis(*torus, Piece_places(in));
    result.certificate = certify_map(layout_);
    if (in_.is_hyperbolic) result.flipped_geodesic_triangles = flipped_geodesic_triangles(layout_);
    result.without_area = bad_triangles_without_area();
    name_faces();
    result.seams = seams(is_cut);
    result.closed = layout_.subdivision;
    glue(result.closed);
    result.layout = std::move(layout_);
    return result;
  }

private:
  // How many triangles are turned or flat on faces without area.
  std::size_t bad_triangles_without_area() const {
    if (in_.has_no_area.empty()) return 0;
    const Common_subdivision& s = layout_.subdivision;
    const std::vector<std::array<std::uint32_t, 3>> triangles = triangles_of_pieces(s);
    std::size_t result = 0, t = 0;
    for (std::uint32_t f = 0; f < s.number_of_faces(); ++f)
      for (std::size_t k = 2; k < s.face(f).size(); ++k, ++t)
        if (in_.has_no_area[s.input_face[f]] != 0 && is_bad(triangles[t])) ++result;
    return result;
  }

  bool is_bad(const std::array<std::uint32_t, 3>& triangle) const {
    return in_.is_hyperbolic ? is_turned_in_disk(layout_.positions, triangle)
                             : is_turned(layout_.positions, triangle);
  }

  std::size_t number_of_sides() const { return opened_.gluing.origin.size(); }
  bool is_front(std::uint32_t side) const {
    return !in_.names.is_cover() || in_.names.faces.user(side / 3) % 2 == 0;
  }
  // A free vertex inside has some angle.
  bool is_cone(std::uint32_t row) const {
    return in_.angles.is_free(row) || in_.angles.radians(row) != Multiple_of_pi().radians();
  }

  // The subdivision of what is laid out.
  Flat_subdivision arrays(const std::vector<char>& is_cut) const {
    Flat_subdivision result{in_.subdivision, in_.flat, is_cut, is_wanted_};
    for (const std::uint32_t row : in_.row)
      result.factors.push_back(row == Gluing::none ? 1 : in_.factors[row]);
    result.input_lengths.resize(in_.start.side.size() / 2);
    for (std::size_t h = 0; h < in_.start.side.size(); ++h)
      if (const std::uint32_t side = in_.start.side[h]; side != Gluing::none)
        result.input_lengths[h / 2] = in_.start.length[side];
    result.is_hyperbolic = in_.is_hyperbolic;
    for (const std::uint32_t row : in_.row)
      result.is_cone.push_back(row != Gluing::none && is_cone(row) ? 1 : 0);
    if (in_.mesh) result.overlay = &in_.mesh->overlay;
    return result;
  }

  // Parts the front of a double from its back.
  void find_front() {
    if (!in_.names.is_cover()) return;
    is_wanted_.resize(number_of_sides() / 3);
    for (std::uint32_t h = 0; h < number_of_sides(); ++h) {
      is_wanted_[h / 3] = is_front(h) ? 1 : 0;
      const std::uint32_t entry = mesh_.gluing.glue[h];
      const std::uint32_t other = entry == Gluing::none ? Gluing::none : Gluing::partner(entry);
      if (other == Gluing::none || is_front(h) == is_front(other)) continue;
      if (in_.names.is_cloud() ||
          in_.names.faces.user(h / 3) / 2 != in_.names.faces.user(other / 3) / 2)
        throw Invalid_input(Element_kind::none, 0,
                            "the faces are not oriented alike, so that the surface has no front "
                            "that can be laid out; orient them, or take the scale factors alone");
      opened_.gluing.glue[h] = Gluing::none;
    }
  }

  // Vertices inside of what is laid out where angles are no full turns.
  std::vector<std::uint32_t> cones() const {
    std::vector<char> is_inside(opened_.gluing.number_of_vertices, 0); // isolated ones are not
    for (const std::uint32_t v : opened_.gluing.origin) is_inside[v] = 1;
    for (std::uint32_t h = 0; h < number_of_sides(); ++h)
      if (!is_front(h) || opened_.gluing.glue[h] == Gluing::none)
        is_inside[opened_.gluing.origin[h]] = 0;
    std::vector<std::uint32_t> result;
    for (std::uint32_t v = 0; v < in_.row.size(); ++v)
      if (in_.row[v] != Gluing::none && is_inside[v] != 0 && is_cone(in_.row[v]))
        result.push_back(v);
    return result;
  }

  // The mesh with the hyperbolic lengths of its edges, piece by piece.
  Surface_to_cut hyperbolic_mesh() const {
    const std::vector<char> no_cut(mesh_.side.size() / 2, 0);
    const Flat_subdivision in = arrays(no_cut);
    const Piece_places places(in);
    const Common_subdivision& s = places.pieces();
    const auto place = [&places](std::uint32_t c) { return Disk_point::at(places.at(c).z); };
    std::vector<double> length(mesh_.side.size() / 2, 0);
    for (std::size_t f = 0; f < s.number_of_faces(); ++f)
      for (std::uint32_t c = s.face_begin[f]; c < s.face_begin[f + 1]; ++c)
        if (const std::uint32_t e = s.side[c].input_edge; e != Common_subdivision::none) {
          const std::uint32_t next = c + 1 == s.face_begin[f + 1] ? s.face_begin[f] : c + 1;
          length[e] += place(c).distance(place(next)) / 2; // pieces on both sides of the edge
        }
    Surface_to_cut result = opened_;
    for (std::size_t h = 0; h < mesh_.side.size(); ++h)
      if (const std::uint32_t side = mesh_.side[h]; side != Gluing::none)
        result.length[side] = length[h / 2];
    return result;
  }

  std::vector<char> edges_to_cut() const {
    const std::vector<char> is_cut = in_.is_hyperbolic
                                         ? cut_to_round_disk(hyperbolic_mesh(), cones())
                                         : cut_to_disk(opened_, cones());
    std::vector<char> result(mesh_.side.size() / 2, 0);
    for (std::size_t h = 0; h < mesh_.side.size(); ++h)
      if (const std::uint32_t side = mesh_.side[h]; side != Gluing::none && is_cut[side] != 0)
        result[h / 2] = 1;
    return result;
  }

  // The triangles that the polygons are made of, with their lengths on the input.
  Face_table pieces() const {
    const Common_subdivision& s = layout_.subdivision;
    Face_table table;
    table.number_of_rows = s.number_of_vertices();
    for (std::size_t f = 0; f < s.number_of_faces(); ++f)
      for (std::uint32_t c = s.face_begin[f] + 2; c < s.face_begin[f + 1]; ++c) {
        const std::array<std::uint32_t, 3> corners{s.face_begin[f], c - 1, c};
        Table_face& face = table.faces.emplace_back();
        std::array<std::complex<double>, 3> z;
        for (std::size_t k = 0; k < 3; ++k) {
          face.rows[k] = static_cast<int>(s.corner[corners[k]]);
          z[k] = place_on_input(corners[k]);
        }
        for (std::size_t k = 0; k < 3; ++k)
          face.squared_lengths[k] = std::norm(z[(k + 1) % 3] - z[k]);
        face.quadruple_area = 2 * std::abs(std::imag(std::conj(z[1] - z[0]) * (z[2] - z[0])));
      }
    return table;
  }

  // The place of a corner in the triangle of the mesh, its first side on the real axis.
  std::complex<double> place_on_input(std::uint32_t c) const {
    const Common_subdivision& s = layout_.subdivision;
    const std::uint32_t h = s.input_halfedge[c], side = mesh_.side[h], first = side - side % 3;
    const double* const l = &mesh_.length[first];
    const double x = (l[0] * l[0] + l[2] * l[2] - l[1] * l[1]) / (2 * l[0]);
    const std::complex<double> apex(x, std::sqrt(std::max(0., l[2] * l[2] - x * x)));
    const std::array<std::complex<double>, 3> z{0, l[0], apex};
    const std::uint32_t k = side - first;
    if (s.kind(s.corner[c]) == Subdivision_vertex_kind::inserted) {
      const Common_subdivision::Vertex& v = s.vertices[s.corner[c]];
      std::array<double, 3> weights = v.on_input.weights;
      if (h != v.input_halfedge) std::swap(weights[0], weights[1]);
      return weights[0] * z[k] + weights[1] * z[(k + 1) % 3] + weights[2] * z[(k + 2) % 3];
    }
    const double p = along(s, c, h, &Common_subdivision::Crossing::on_input);
    return (1 - p) * z[k] + p * z[(k + 1) % 3];
  }

  static std::complex<double> vector_on_torus(std::uint32_t side, const Flat_layout& torus) {
    const std::vector<std::uint32_t>& origin = torus.surface.gluing.origin;
    return point_of_row(torus.positions, origin[Gluing::next(side)]) -
           point_of_row(torus.positions, origin[side]);
  }

  // Turns the layout as that of the torus, and takes coordinates along the translations.
  void change_basis(const Flat_torus& torus, const Piece_places& places) {
    const Common_subdivision& s = layout_.subdivision;
    std::complex<double> turn = 0;
    for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
      // the corner before the cut
      std::uint32_t uncut = places.pieces().face_begin[layout_.original_face[f]];
      for (std::uint32_t c = s.face_begin[f] + 1; c < s.face_begin[f + 1]; ++c)
        if (const std::uint32_t side = places.side(uncut++); side != Gluing::none)
          turn += std::conj(point_of_row(layout_.positions, s.corner[c]) -
                            point_of_row(layout_.positions, s.corner[c - 1])) *
                  vector_on_torus(side, torus.layout);
    }
    turn /= std::abs(turn);
    const auto [a, b] = torus.translations;
    Eigen::Matrix2d basis, rotation;
    basis << a.real(), b.real(), a.imag(), b.imag();
    rotation << turn.real(), -turn.imag(), turn.imag(), turn.real();
    layout_.positions *= (basis.inverse() * rotation).transpose();
    turn_back(triangles_of_pieces(s), layout_.positions);
  }

  // Labels faces with the polygons of the file.
  void name_faces() {
    Common_subdivision& s = layout_.subdivision;
    const auto rename = [this](std::uint32_t& f) {
      if (f != Gluing::none) f = in_.names.polygon(f);
    };
    for (std::uint32_t& f : s.input_face) rename(f);
    for (Common_subdivision::Vertex& v : s.vertices) rename(v.input_face);
    s.sheet.clear();
  }

  // The rows of the ends of edges that were cut.
  std::vector<std::array<std::uint32_t, 2>> seams(const std::vector<char>& is_cut) const {
    std::vector<std::array<std::uint32_t, 2>> result;
    const std::vector<std::uint32_t>& origin = mesh_.gluing.origin;
    for (std::uint32_t e = 0; e < is_cut.size(); ++e) {
      const std::uint32_t side = mesh_.side[2 * e];
      if (is_cut[e] == 0 || is_on_border(e) || !is_front(side)) continue;
      result.push_back({in_.row[origin[side]], in_.row[origin[Gluing::next(side)]]});
    }
    return result;
  }

  // Makes one vertex of all copies, in the order before the cut.
  void glue(Common_subdivision& s) const {
    const Common_subdivision& cut = layout_.subdivision;
    const std::vector<std::uint32_t>& original = layout_.original_vertex;
    const Common_subdivision& all = in_.mesh ? in_.mesh->overlay.subdivision : in_.subdivision;
    std::vector<std::uint32_t> number(all.number_of_vertices(), Gluing::none);
    for (std::uint32_t v = 0; v < original.size(); ++v) number[original[v]] = v; // a copy
    s.vertices.clear();
    s.crossings.clear();
    for (std::uint32_t& v : number) {
      if (v == Gluing::none) continue; // not on the front
      const std::uint32_t copy = v;
      v = static_cast<std::uint32_t>(s.number_of_vertices());
      if (copy < cut.vertices.size())
        s.vertices.push_back(cut.vertices[copy]);
      else
        s.crossings.push_back(cut.crossings[copy - cut.vertices.size()]);
    }
    for (std::uint32_t& v : s.corner) v = number[original[v]];
    s.number_of_border_edges = 0;
    for (const Common_subdivision::Side& side : s.side)
      if (side.input_edge != Gluing::none && is_on_border(side.input_edge))
        ++s.number_of_border_edges;
  }

  bool is_on_border(std::uint32_t edge) const {
    const std::uint32_t side = mesh_.side[2 * edge];
    return side == Gluing::none || opened_.gluing.glue[side] == Gluing::none;
  }

  const Scaled_surface& in_;
  const Surface_to_cut& mesh_;
  Surface_to_cut opened_; // the mesh, of a double without the gluing of front and back
  std::vector<char> is_wanted_;
  Subdivision_layout layout_;
};

} // namespace

} // namespace internal

Scaled_layout lay_out_scaled(const Scaled_surface& surface, const Flat_torus* torus) {
  return internal::Front_layout(surface).run(torus);
}

} // namespace CGAL::Intrinsic_triangulations
