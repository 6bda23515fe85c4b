// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline constexpr std::string_view PLY_comments =
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
inline constexpr std::string_view PLY_face_properties =
    "property list uchar int vertex_indices\n"
    "property int input_face\nproperty int intrinsic_face\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";
inline constexpr std::string_view PLY_edge_properties =
    "property int vertex1\nproperty int vertex2\n"
    "property int input_edge\nproperty int intrinsic_edge\n";

template <class T>
inline constexpr std::string_view PLY_type = std::is_same_v<T, double>         ? "double"
                                             : std::is_same_v<T, std::int32_t> ? "int"
                                                                               : "uchar";

// Writes PLY with all labels: elements vertex, face and, each once, edge. Comments in the header say what
// properties mean. Binary is little endian; both are without loss.
template <bool is_binary>
class PLY_subdivision_writer {
public:
  PLY_subdivision_writer(Output_buffer& out, const Subdivision_output& o)
      : out_(out), o_(o), s_(o.s) {}

  void run() {
    write_header();
    for (std::size_t v = 0; v < o_.points.size(); ++v) write_vertex(v);
    const std::vector<Rgb_color> colors = intrinsic_face_colors(s_);
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) write_face(f, colors);
    for_each_subdivision_edge(
        s_, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side& side) {
          put(signed_label(a), signed_label(b), signed_label(side.input_edge),
              signed_label(side.intrinsic_edge));
          end();
        });
  }

private:
  void write_header() {
    std::size_t edges = 0;
    for_each_subdivision_edge(
        s_, [&](std::uint32_t, std::uint32_t, const Common_subdivision::Side&) { ++edges; });
    out_.text("ply\nformat ", is_binary ? "binary_little_endian" : "ascii", " 1.0\n", PLY_comments,
              "element vertex ", o_.points.size(), "\n");
    for (const char c : {'x', 'y', 'z'}) out_.text("property double ", c, "\n");
    for_each_vertex_label(s_, [&](std::string_view, std::string_view component, auto values) {
      using Values = decltype(values(0));
      constexpr std::size_t components = std::tuple_size_v<Values>;
      for (std::size_t i = 0; i < components; ++i)
        out_.text("property ", PLY_type<typename Values::value_type>, ' ',
                  component_name(component, i, components), '\n');
    });
    declare_fields(Subdivision_field::Place::vertices);
    out_.text("element face ", s_.number_of_faces(), "\n", PLY_face_properties,
              s_.sheet.empty() ? "" : "property uchar sheet\n");
    declare_fields(Subdivision_field::Place::faces);
    out_.text("element edge ", edges, "\n", PLY_edge_properties, "end_header\n");
  }

  void declare_fields(Subdivision_field::Place place) {
    for (const Subdivision_field& field : o_.fields)
      if (field.place == place)
        for (const std::string& name : component_names(field))
          out_.text("property double ", name, "\n");
  }
  void write_fields(Subdivision_field::Place place, std::size_t i) {
    for (const Subdivision_field& field : o_.fields)
      for (std::size_t c = 0; field.place == place && c < field.components; ++c)
        put(field.values[field.components * i + c]);
  }

  void write_vertex(std::size_t v) {
    put(o_.points[v][0], o_.points[v][1], o_.points[v][2]);
    for_each_vertex_label(s_, [&](std::string_view, std::string_view, auto values) {
      for (const auto x : values(v)) put(x);
    });
    write_fields(Subdivision_field::Place::vertices, v);
    end();
  }

  // A face has at most six sides: it is in a face of the input and in an intrinsic one.
  void write_face(std::size_t f, const std::vector<Rgb_color>& colors) {
    const std::span<const std::uint32_t> face = s_.face(f);
    put(static_cast<std::uint8_t>(face.size()));
    for (const std::uint32_t v : face) put(signed_label(v));
    const Rgb_color& c = colors[s_.intrinsic_face[f]];
    put(signed_label(s_.input_face[f]), signed_label(s_.intrinsic_face[f]), c[0], c[1], c[2]);
    if (!s_.sheet.empty()) put(s_.sheet[f]);
    write_fields(Subdivision_field::Place::faces, f);
    end();
  }

  template <class... Values>
  void put(Values... values) {
    if constexpr (is_binary)
      (out_.binary(values), ...);
    else
      out_.words(values...);
  }
  void end() {
    if constexpr (!is_binary) out_.line();
  }

  Output_buffer& out_;
  const Subdivision_output& o_;
  const Common_subdivision& s_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H
