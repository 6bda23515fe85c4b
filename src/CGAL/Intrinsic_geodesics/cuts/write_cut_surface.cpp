// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

constexpr std::string_view cut_PLY_comments =
    "comment a triangle mesh (the input), cut open along curves\n"
    "comment numbers count from 0; -1: none\n"
    "comment vertex: a copy of original_vertex; it is input_vertex, or lies inside of input_edge\n"
    "comment   or of input_face\n"
    "comment face: a part of input_face, in a component across edges\n"
    "comment edge: lies on input_edge; curve: label of the cut, 0: none\n";

constexpr std::string_view cut_VTP_comment =
    "<!-- A triangle mesh (the input), cut open along curves. Numbers count from 0; -1: none.\n"
    "Points: copies of original_vertex; each is input_vertex, or lies inside of input_edge or of\n"
    "input_face. -->\n";

// What is written.
struct Cut_output {
  const Cut_surface& s;
  std::span<const std::array<double, 3>> points;
  std::span<const std::array<double, 2>> texture;

  std::size_t number_of_faces() const { return s.input_face.size(); }
};

std::int32_t signed_number(std::uint32_t i) { return static_cast<std::int32_t>(i); }

std::vector<Column> cut_vertex_labels(const Cut_surface& s) {
  const std::size_t n = s.vertices.size();
  const auto label = [&](const char* name, std::uint32_t Cut_surface::Vertex::*of) {
    return numbers(name, n, [&s, of](std::size_t v) { return signed_number(s.vertices[v].*of); });
  };
  return {numbers("original_vertex", n,
                  [&s](std::size_t v) { return signed_number(s.original_vertex[v]); }),
          label("input_vertex", &Cut_surface::Vertex::input_vertex),
          label("input_edge", &Cut_surface::Vertex::input_edge),
          label("input_face", &Cut_surface::Vertex::input_face)};
}

Column cut_points(const Cut_output& o) {
  return tuples("Points", {"x", "y", "z"}, o.points.size(),
                [&o](std::size_t v) { return o.points[v]; });
}

Column cut_faces(const Cut_output& o) {
  return {"",
          {"vertex_indices"},
          {"list uchar int", "", 0},
          o.number_of_faces(),
          [&o](Output_buffer& out, std::size_t f, std::size_t end) {
            for (; f < end; ++f) {
              out.number(std::uint8_t{3});
              for (const std::uint32_t v : o.s.face(f)) out.number(signed_number(v));
            }
          }};
}

Column cut_texture(const Cut_output& o) {
  return {"",
          {"texcoord"},
          {"list uchar double", "", 0},
          o.number_of_faces(),
          [&o](Output_buffer& out, std::size_t f, std::size_t end) {
            for (; f < end; ++f) {
              out.number(std::uint8_t{6});
              for (const std::array<double, 2>& p : o.texture.subspan(3 * f, 3))
                for (const double x : p) out.number(x);
            }
          }};
}

// Labels of faces.
std::vector<Column> cut_face_labels(const Cut_surface& s) {
  const auto label = [&](const char* name, const std::vector<std::uint32_t>& all) {
    return numbers(name, all.size(), [&all](std::size_t f) { return signed_number(all[f]); });
  };
  return {label("input_face", s.input_face), label("component", s.component)};
}

std::vector<Rgb_color> component_colors(const Cut_surface& s) {
  return intrinsic_face_colors(drawn_as_subdivision(s));
}

// Each edge once, as the first of its sides.
std::vector<std::uint32_t> first_sides(const Cut_surface& s) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t h = 0; h < s.gluing.glue.size(); ++h)
    if (h < s.gluing.glue[h]) result.push_back(h);
  return result;
}

void write_cut_PLY(Output_buffer& out, const Cut_output& o) {
  const Cut_surface& s = o.s;
  const std::vector<Rgb_color> colors = component_colors(s);
  const std::vector<std::uint32_t> sides = first_sides(s);
  Table vertices{"vertex", {cut_points(o)}}, faces{"face", {cut_faces(o)}};
  for (Column& column : cut_vertex_labels(s)) vertices.columns.push_back(std::move(column));
  if (!o.texture.empty()) faces.columns.push_back(cut_texture(o));
  for (Column& column : cut_face_labels(s)) faces.columns.push_back(std::move(column));
  faces.columns.push_back(tuples("color", {"red", "green", "blue"}, o.number_of_faces(),
                                 [&](std::size_t f) { return colors[s.component[f]]; }));
  const Column ends = tuples(
      "edge", {"vertex1", "vertex2", "input_edge", "curve"}, sides.size(), [&](std::size_t i) {
        const std::uint32_t h = sides[i];
        return std::array{signed_number(s.gluing.origin[h]),
                          signed_number(s.gluing.origin[Gluing::next(h)]),
                          signed_number(s.sides[h].input_edge), signed_number(s.sides[h].curve)};
      });
  write_PLY(out, true, cut_PLY_comments,
            std::array{std::move(vertices), std::move(faces), Table{"edge", {ends}}});
}

void write_cut_VTP(Output_buffer& out, const Cut_output& o) {
  Table points{"PointData", cut_vertex_labels(o.s)}, cells{"CellData", cut_face_labels(o.s)};
  write_VTP(out, cut_VTP_comment,
            std::array{std::move(points), std::move(cells), Table{"Points", {cut_points(o)}},
                       VTK_cells(
                           "Polys", o.s.gluing.origin.size(),
                           [&](std::size_t i) { return o.s.gluing.origin[i]; }, o.number_of_faces(),
                           [](std::size_t f) { return 3 * (f + 1); })});
}

// A group begins where the component of the next face is another one.
void write_cut_OBJ(Output_buffer& out, const Cut_output& o) {
  out.text("# a triangle mesh, cut open along curves; groups are components\n");
  for (const std::array<double, 3>& p : o.points) out.line('v', p[0], p[1], p[2]);
  for (const std::array<double, 2>& p : o.texture) out.line("vt", p[0], p[1]);
  for (std::size_t f = 0; f < o.number_of_faces(); ++f) {
    if (f == 0 || o.s.component[f] != o.s.component[f - 1])
      out.text("g component_", o.s.component[f], '\n');
    out.words('f');
    for (std::size_t k = 0; k < 3; ++k) {
      out.text(' ', std::uint64_t{o.s.face(f)[k]} + 1);
      if (!o.texture.empty()) out.text('/', 3 * f + k + 1);
    }
    out.line();
  }
}

void write_cut_OFF(Output_buffer& out, const Cut_output& o) {
  const std::vector<Rgb_color> colors = component_colors(o.s);
  out.text("OFF\n", o.points.size(), ' ', o.number_of_faces(), " 0\n");
  for (const std::array<double, 3>& p : o.points) out.line(p[0], p[1], p[2]);
  for (std::size_t f = 0; f < o.number_of_faces(); ++f) {
    const auto v = o.s.face(f);
    const Rgb_color& c = colors[o.s.component[f]];
    out.line(3, v[0], v[1], v[2], c[0], c[1], c[2]);
  }
}

void check_cut_output(const Cut_output& o) {
  const auto fail = [](std::size_t given, const char* what, std::size_t expected,
                       const char* elements) {
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(given) + what +
                            "; give one for each of the " + std::to_string(expected) + elements);
  };
  if (o.points.size() != o.s.vertices.size())
    fail(o.points.size(), " points", o.s.vertices.size(), " vertices of the cut surface");
  if (!o.texture.empty() && o.texture.size() != o.s.sides.size())
    fail(o.texture.size(), " texture coordinates", o.s.sides.size(), " corners of the cut surface");
}

} // namespace
} // namespace internal

Common_subdivision drawn_as_subdivision(const Cut_surface& s) {
  constexpr std::uint32_t none = Common_subdivision::none;
  Common_subdivision r;
  r.number_of_intrinsic_vertices = static_cast<std::uint32_t>(s.vertices.size());
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
    const Cut_surface::Vertex& of = s.vertices[v];
    const bool is_of_input = of.input_vertex != none;
    if (is_of_input && of.input_vertex == v) ++r.number_of_input_vertices;
    r.vertices.push_back(
        {v, is_of_input ? Subdivision_vertex_kind::input : Subdivision_vertex_kind::inserted,
         of.input_face, of.on_input, of.input_halfedge});
  }
  std::uint32_t edges = 0;
  r.corner = s.gluing.origin;
  for (std::uint32_t h = 0; h < s.gluing.origin.size(); ++h) {
    const bool is_border = s.gluing.glue[h] == Gluing::none;
    r.side.push_back({s.sides[h].input_edge, is_border ? edges++ : none});
    r.intrinsic_halfedge.push_back(none);
    r.input_halfedge.push_back(none);
  }
  r.number_of_border_edges = edges;
  for (std::uint32_t f = 0; f < s.input_face.size(); ++f) r.face_begin.push_back(3 * f + 3);
  r.input_face = s.input_face;
  r.intrinsic_face = s.component;
  return r;
}

void write_cut_surface(std::ostream& out, std::string_view extension, const Cut_surface& s,
                       std::span<const std::array<double, 3>> points,
                       std::span<const std::array<double, 2>> texture) {
  const std::string name = internal::plain_extension(extension);
  const internal::Cut_output o{s, points, texture};
  internal::check_cut_output(o);
  internal::Output_buffer buffer(out);
  if (name == "ply")
    internal::write_cut_PLY(buffer, o);
  else if (name == "obj")
    internal::write_cut_OBJ(buffer, o);
  else if (name == "off")
    internal::write_cut_OFF(buffer, o);
  else if (name == "vtp")
    internal::write_cut_VTP(buffer, o);
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write the cut surface to .ply, .obj, .off or "
                            ".vtp");
  if (!buffer.flush()) throw std::runtime_error("the cut surface cannot be written completely");
}

void write_cut_surface(const std::string& path, const Cut_surface& s,
                       std::span<const std::array<double, 3>> points,
                       std::span<const std::array<double, 2>> texture) {
  write_file(path, [&](std::ostream& out) {
    write_cut_surface(out, std::filesystem::path(path).extension().string(), s, points, texture);
  });
}

} // namespace CGAL::Intrinsic_triangulations
