// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

void label_with_polygons(Common_subdivision& s,
                         std::span<const std::uint32_t> polygon_of_triangle) {
  if (polygon_of_triangle.empty()) return;
  const auto rename = [&](std::uint32_t& f) {
    if (f != Common_subdivision::none) f = polygon_of_triangle[f];
  };
  for (std::uint32_t& f : s.input_face) rename(f);
  for (Common_subdivision::Vertex& v : s.vertices) rename(v.input_face);
}

namespace internal {
namespace {

constexpr std::string_view PLY_comments =
    "comment common subdivision of a mesh (the input) and an intrinsic triangulation of it\n"
    "comment numbers count from 0; -1: none\n"
    "comment vertex kind 0: vertex of the input; 1: inserted into the intrinsic triangulation;\n"
    "comment   2: crossing of input_edge and intrinsic_edge\n"
    "comment vertex location: the sum of weight * vertex, on the input and on the intrinsic one\n"
    "comment vertex input_face: a face of the input that contains it; -1 for crossings\n"
    "comment face: contained in input_face and intrinsic_face; neighbours of these differ in "
    "colour\n"
    "comment sheet: of a cover, 0 on the front of the user's face, 1 on its back\n"
    "comment edge: lies on input_edge, on intrinsic_edge or on both\n";

constexpr std::string_view VTP_comment =
    "<!-- Common subdivision of a mesh (the input) and an intrinsic triangulation of it.\n"
    "Numbers count from 0; -1: none. kind 0: vertex of the input; 1: inserted into the\n"
    "intrinsic triangulation; 2: crossing of input_edge and intrinsic_edge.\n"
    "Lines are the intrinsic edges. sheet: of a cover, 0 on the front of the user's face,\n"
    "1 on its back. -->\n";

Column positions_column(const Subdivision_output& o) {
  return tuples("Points", {"x", "y", "z"}, o.points.size(),
                [&o](std::size_t v) { return o.points[v]; });
}

// Appends the fields of a place. The `first` elements have none: not a number, or no vector.
void add_fields(std::vector<Column>& columns, const Subdivision_output& o,
                Subdivision_field::Place place, std::size_t first = 0) {
  for (const Subdivision_field& field : o.fields) {
    if (field.place != place) continue;
    const std::size_t n = field.components;
    const double unknown = n == 1 ? std::numeric_limits<double>::quiet_NaN() : 0;
    columns.push_back({field.name, component_names(field), number_type<double>,
                       first + field.values.size() / n,
                       [=, &field](Output_buffer& out, std::size_t i, std::size_t end) {
                         for (; i < end; ++i)
                           for (std::size_t c = 0; c < n; ++c)
                             out.number(i < first ? unknown : field.values[n * (i - first) + c]);
                       }});
  }
}

// A list of numbers of each face for PLY: `write` writes those of a corner. A face has at most six
// sides: it is in a face of the input and in an intrinsic one.
template <class Write>
Column lists_of_faces(const Common_subdivision& s, const std::string& name, std::string_view type,
                      std::size_t numbers_at_corner, Write write) {
  return {"",
          {name},
          {type, "", 0},
          s.number_of_faces(),
          [=, &s](Output_buffer& out, std::size_t f, std::size_t end) {
            for (; f < end; ++f) {
              out.number(static_cast<std::uint8_t>(numbers_at_corner * s.face(f).size()));
              for (std::size_t c = s.face_begin[f]; c < s.face_begin[f + 1]; ++c) write(out, c);
            }
          }};
}
Column corners_of_faces(const Common_subdivision& s) {
  return lists_of_faces(
      s, "vertex_indices", "list uchar int", 1,
      [&s](Output_buffer& out, std::size_t c) { out.number(signed_label(s.corner[c])); });
}

// Fields of these names are places in the plane.
const Subdivision_field* find_field(const Subdivision_output& o, std::string_view name,
                                    Subdivision_field::Place place) {
  const auto i = std::ranges::find_if(o.fields, [&](const Subdivision_field& f) {
    return f.name == name && f.place == place && f.components == 1;
  });
  return i == o.fields.end() ? nullptr : &*i;
}

// Appends the fields at corners, and places in the plane as viewers have them.
void add_corner_fields(std::vector<Column>& columns, const Subdivision_output& o) {
  constexpr auto corners = Subdivision_field::Place::corners;
  for (const Subdivision_field& field : o.fields)
    if (field.place == corners)
      columns.push_back(lists_of_faces(
          o.s, field.name, "list uchar double", 1,
          [&field](Output_buffer& out, std::size_t c) { out.number(field.values[c]); }));
  const Subdivision_field *const u = find_field(o, "u", corners), *const v =
                                                                      find_field(o, "v", corners);
  if (u == nullptr || v == nullptr) return;
  columns.push_back(lists_of_faces(o.s, "texcoord", "list uchar float", 2,
                                   [u, v](Output_buffer& out, std::size_t c) {
                                     for (const Subdivision_field* f : {u, v})
                                       out.number(static_cast<float>(f->values[c]));
                                   }));
}

// Each edge of a subdivision once: the corner where it starts, and its other end.
using Subdivision_edges = std::vector<std::array<std::uint32_t, 2>>;
Subdivision_edges edges_of_subdivision(const Common_subdivision& s) {
  Subdivision_edges edges;
  for_each_subdivision_edge(
      s, [&](std::uint32_t, std::uint32_t end, const Common_subdivision::Side& side) {
        edges.push_back({static_cast<std::uint32_t>(&side - s.side.data()), end});
      });
  return edges;
}
Column ends_and_labels(const Subdivision_edges& edges, const Common_subdivision& s) {
  return tuples("edge", {"vertex1", "vertex2", "input_edge", "intrinsic_edge"}, edges.size(),
                [&](std::size_t e) {
                  const auto& [corner, end] = edges[e];
                  const Common_subdivision::Side& side = s.side[corner];
                  return std::array{signed_label(s.corner[corner]), signed_label(end),
                                    signed_label(side.input_edge),
                                    signed_label(side.intrinsic_edge)};
                });
}

// Elements vertex, face and edge with all labels. Comments in the header say what properties mean.
void write_subdivision_PLY(Output_buffer& out, const Subdivision_output& o, bool is_binary) {
  const Common_subdivision& s = o.s;
  const std::size_t n = s.number_of_faces();
  const std::vector<Rgb_color> colors = intrinsic_face_colors(s);
  const Subdivision_edges edges = edges_of_subdivision(s);
  Table vertices{"vertex", {positions_column(o)}};
  for (Column& column : vertex_labels(s)) vertices.columns.push_back(std::move(column));
  add_fields(vertices.columns, o, Subdivision_field::Place::vertices);
  Table faces{
      "face",
      {corners_of_faces(s),
       numbers("input_face", n, [&](std::size_t f) { return signed_label(s.input_face[f]); }),
       numbers("intrinsic_face", n,
               [&](std::size_t f) { return signed_label(s.intrinsic_face[f]); }),
       tuples("color", {"red", "green", "blue"}, n,
              [&](std::size_t f) { return colors[s.intrinsic_face[f]]; })}};
  if (!s.sheet.empty())
    faces.columns.push_back(numbers("sheet", n, [&](std::size_t f) { return s.sheet[f]; }));
  add_fields(faces.columns, o, Subdivision_field::Place::faces);
  add_corner_fields(faces.columns, o);
  write_PLY(out, is_binary, PLY_comments,
            std::array{std::move(vertices), std::move(faces),
                       Table{"edge", {ends_and_labels(edges, s)}}});
}

// Labels are point and cell data, intrinsic edges are lines. Cells: lines before polygons.
void write_subdivision_VTP(Output_buffer& out, const Subdivision_output& o, bool has_lines) {
  constexpr std::uint32_t none = Common_subdivision::none;
  const Common_subdivision& s = o.s;
  const Edge_polylines lines = has_lines ? intrinsic_edge_polylines(s) : Edge_polylines();
  std::vector<std::uint32_t> edges; // that of each line
  for (std::uint32_t e = 0; e < lines.size(); ++e)
    if (!lines[e].empty()) edges.push_back(e);
  const std::size_t m = edges.size(), n = m + s.number_of_faces();
  const auto label = [m](const std::vector<std::uint32_t>& of_faces) {
    return [m, &of_faces](std::size_t i) { return signed_label(i < m ? none : of_faces[i - m]); };
  };
  Table points{"PointData", {}}, cells{"CellData", {}};
  add_fields(points.columns, o, Subdivision_field::Place::vertices);
  for (Column& column : vertex_labels(s)) points.columns.push_back(std::move(column));
  add_fields(cells.columns, o, Subdivision_field::Place::faces, m);
  cells.columns.push_back(numbers("input_face", n, label(s.input_face)));
  cells.columns.push_back(numbers("intrinsic_face", n, label(s.intrinsic_face)));
  cells.columns.push_back(numbers("intrinsic_edge", n, [&, m](std::size_t i) {
    return signed_label(i < m ? edges[i] : none);
  }));
  if (!s.sheet.empty())
    cells.columns.push_back(numbers("sheet", n, [&, m](std::size_t i) {
      return i < m ? std::int32_t{-1} : std::int32_t{s.sheet[i - m]};
    }));
  write_VTP(
      out, VTP_comment,
      std::array{std::move(points), std::move(cells), Table{"Points", {positions_column(o)}},
                 VTK_cells(
                     "Lines", lines.vertices.size(),
                     [&](std::size_t i) { return lines.vertices[i]; }, m,
                     [&](std::size_t i) { return lines.begin[edges[i] + 1]; }),
                 VTK_cells(
                     "Polys", s.corner.size(), [&](std::size_t i) { return s.corner[i]; },
                     s.number_of_faces(), [&](std::size_t f) { return s.face_begin[f + 1]; })});
}

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

// Comments before elements have the numbers of faces of both triangulations and of edges.
void write_OBJ(Output_buffer& out, const Subdivision_output& o, bool with_lines) {
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

// Polygons in the colours of `intrinsic_face_colors()`.
void write_OFF(Output_buffer& out, const Subdivision_output& o) {
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

// Binary: each convex polygon as a fan of triangles, coordinates rounded to single precision.
void write_STL(Output_buffer& out, const Subdivision_output& o) {
  check_STL_range(o.points);
  // exactly 80 bytes, which must not start with "solid" as text does
  std::string title = "binary STL: common subdivision of a mesh and an intrinsic triangulation";
  title.resize(80, ' ');
  out.text(title);
  out.binary(static_cast<std::uint32_t>(o.s.corner.size() - 2 * o.s.number_of_faces()));
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

} // namespace

void write_subdivision(std::ostream& out, std::string_view extension, const Subdivision_output& o,
                       const Subdivision_format& format) {
  const std::string name = plain_extension(extension);
  check_output(o);
  Output_buffer buffer(out);
  if (name == "ply")
    write_subdivision_PLY(buffer, o, format.is_binary.value_or(true));
  else if (name == "obj")
    write_OBJ(buffer, o, format.has_lines.value_or(false));
  else if (name == "off")
    write_OFF(buffer, o);
  else if (name == "stl")
    write_STL(buffer, o);
  else if (name == "vtp")
    write_subdivision_VTP(buffer, o, format.has_lines.value_or(true));
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write the common subdivision to .ply, .obj, "
                            ".off, .stl or .vtp");
  if (!buffer.flush())
    throw std::runtime_error("the common subdivision cannot be written completely");
}

void write_subdivision(const std::filesystem::path& path, const Subdivision_output& o,
                       const Subdivision_format& format) {
  write_file(path, [&](std::ostream& out) {
    write_subdivision(out, path.extension().string(), o, format);
  });
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
