// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/subdivision_formats.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A line with the numbers of vertices as OBJ has them, from 1.
void write_OBJ_vertices(Output_buffer& out, char kind, std::span<const std::uint32_t> vertices) {
  out.words(kind);
  for (const std::uint32_t v : vertices) out.words(std::uint64_t{v} + 1);
  out.line();
}

// Places in the plane for OBJ, each once at a vertex, and their number at each corner.
struct OBJ_texture {
  std::vector<std::array<double, 2>> places;
  std::vector<std::uint32_t> at_corner; // none: there is no texture
};
OBJ_texture texture_of(const Subdivision_output& o) {
  OBJ_texture result;
  for (const auto place : {Subdivision_field::Place::vertices, Subdivision_field::Place::corners}) {
    const Subdivision_field *const u = find_field(o, "u", place), *const v =
                                                                      find_field(o, "v", place);
    if (u == nullptr || v == nullptr) continue;
    if (place == Subdivision_field::Place::vertices) {
      for (std::size_t i = 0; i < o.points.size(); ++i)
        result.places.push_back({u->values[i], v->values[i]});
      result.at_corner = o.s.corner;
      return result;
    }
    constexpr std::uint32_t none = Common_subdivision::none;
    std::vector<std::uint32_t> first(o.points.size(), none), next; // places of a vertex
    for (std::size_t c = 0; c < o.s.corner.size(); ++c) {
      const std::array<double, 2> p{u->values[c], v->values[c]};
      std::uint32_t i = first[o.s.corner[c]];
      while (i != none && result.places[i] != p) i = next[i];
      if (i == none) {
        i = static_cast<std::uint32_t>(next.size());
        result.places.push_back(p);
        next.push_back(first[o.s.corner[c]]);
        first[o.s.corner[c]] = i;
      }
      result.at_corner.push_back(i);
    }
  }
  return result;
}

// A face, with the numbers of places in the plane if there are any.
void write_OBJ_face(Output_buffer& out, const Common_subdivision& s, std::size_t f,
                    const OBJ_texture& texture) {
  if (texture.at_corner.empty()) return write_OBJ_vertices(out, 'f', s.face(f));
  out.words('f');
  for (std::size_t c = s.face_begin[f]; c < s.face_begin[f + 1]; ++c)
    out.text(' ', std::uint64_t{s.corner[c]} + 1, '/', std::uint64_t{texture.at_corner[c]} + 1);
  out.line();
}

using STL_point = std::array<double, 3>;

// The unit normal of a triangle; 0 if its corners are collinear.
STL_point STL_normal(const STL_point& a, const STL_point& b, const STL_point& c) {
  const STL_point n = cross_product(difference(b, a), difference(c, a));
  const double length = norm(n);
  return length > 0 ? STL_point{n[0] / length, n[1] / length, n[2] / length} : STL_point{0, 0, 0};
}

void check_STL_range(std::span<const STL_point> points) {
  for (const STL_point& p : points)
    for (const double x : p)
      if (std::abs(x) > static_cast<double>(std::numeric_limits<float>::max()))
        throw Invalid_input(Element_kind::none, 0,
                            "a coordinate exceeds the range of STL; scale the mesh, or write .ply");
}

} // namespace

void write_subdivision_OBJ(Output_buffer& out, const Subdivision_output& o, bool with_lines) {
  const Common_subdivision& s = o.s;
  out.text("# common subdivision of a mesh (the input) and an intrinsic triangulation of it\n"
           "# numbers in comments count from 0; input_faces: one for each face that follows\n");
  for (const std::array<double, 3>& p : o.points) out.line('v', p[0], p[1], p[2]);
  const OBJ_texture texture = texture_of(o);
  for (const std::array<double, 2>& p : texture.places) out.line("vt", p[0], p[1]);
  for (std::size_t f = 0, end = 0; f < s.number_of_faces(); f = end) {
    out.words("# intrinsic_face", s.intrinsic_face[f], "input_faces");
    for (; end < s.number_of_faces() && s.intrinsic_face[end] == s.intrinsic_face[f]; ++end)
      out.words(s.input_face[end]);
    out.line();
    for (std::size_t g = f; g < end; ++g) write_OBJ_face(out, s, g, texture);
  }
  if (!with_lines) return;
  const Edge_polylines lines = intrinsic_edge_polylines(s);
  for (std::size_t e = 0; e < lines.size(); ++e) {
    if (lines[e].empty()) continue;
    out.line("# intrinsic_edge", e);
    write_OBJ_vertices(out, 'l', lines[e]);
  }
}

// Polygons as fans of triangles, of which each convex polygon with n corners has n - 2.
static std::size_t number_of_triangles(const Common_subdivision& s) {
  return s.corner.size() - 2 * s.number_of_faces();
}

static void write_plain_OFF(Output_buffer& out, const Subdivision_output& o) {
  out.text("OFF\n", o.points.size(), ' ', number_of_triangles(o.s), " 0\n");
  for (const std::array<double, 3>& p : o.points) out.line(p[0], p[1], p[2]);
  for (std::size_t f = 0; f < o.s.number_of_faces(); ++f) {
    const std::span<const std::uint32_t> v = o.s.face(f);
    for (std::size_t k = 2; k < v.size(); ++k) out.line(3, v[0], v[k - 1], v[k]);
  }
}

void write_subdivision_OFF(Output_buffer& out, const Subdivision_output& o, bool is_plain) {
  if (is_plain) return write_plain_OFF(out, o);
  out.text("OFF\n", o.points.size(), ' ', o.s.number_of_faces(), " 0\n");
  for (const std::array<double, 3>& p : o.points) out.line(p[0], p[1], p[2]);
  const std::vector<Rgb_color> colors = intrinsic_face_colors(o.s);
  for (std::size_t f = 0; f < o.s.number_of_faces(); ++f) {
    out.words(o.s.face(f).size());
    for (const std::uint32_t v : o.s.face(f)) out.words(v);
    const Rgb_color& c = colors[o.s.intrinsic_face[f]];
    out.line(c[0], c[1], c[2]);
  }
}

void write_subdivision_STL(Output_buffer& out, const Subdivision_output& o) {
  check_STL_range(o.points);
  // exactly 80 bytes, which must not start with "solid" as text does
  std::string title = "binary STL: common subdivision of a mesh and an intrinsic triangulation";
  title.resize(80, ' ');
  out.text(title);
  out.binary(static_cast<std::uint32_t>(number_of_triangles(o.s)));
  for (std::size_t f = 0; f < o.s.number_of_faces(); ++f) {
    const std::span<const std::uint32_t> face = o.s.face(f);
    const STL_point& a = o.points[face[0]];
    for (std::size_t k = 2; k < face.size(); ++k) {
      const STL_point &b = o.points[face[k - 1]], &c = o.points[face[k]];
      for (const STL_point& p : {STL_normal(a, b, c), a, b, c})
        for (const double x : p) out.binary(static_cast<float>(x));
      out.binary(std::uint16_t{0});
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
