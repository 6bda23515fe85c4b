// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/subdivision_formats.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

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

} // namespace

// Points, polygons and fields.
static void write_plain_PLY(Output_buffer& out, const Subdivision_output& o, bool is_binary) {
  Table vertices{"vertex", {positions_column(o)}}, faces{"face", {corners_of_faces(o.s)}};
  add_fields(vertices.columns, o, Subdivision_field::Place::vertices);
  add_fields(faces.columns, o, Subdivision_field::Place::faces);
  add_corner_fields(faces.columns, o);
  write_PLY(out, is_binary, "", std::array{std::move(vertices), std::move(faces)});
}

void write_subdivision_PLY(Output_buffer& out, const Subdivision_output& o, bool is_binary,
                           bool is_plain) {
  if (is_plain) return write_plain_PLY(out, o, is_binary);
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

} // namespace CGAL::Intrinsic_triangulations::internal
