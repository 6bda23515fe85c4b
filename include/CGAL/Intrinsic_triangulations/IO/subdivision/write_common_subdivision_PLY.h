// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline constexpr std::string_view PLY_comments =
    "comment common subdivision of a mesh (the input) and an intrinsic triangulation of it\n"
    "comment numbers count from 0; -1: none\n"
    "comment vertex kind 0: vertex of the input; 1: inserted into the intrinsic triangulation;\n"
    "comment   2: crossing of input_edge and intrinsic_edge\n"
    "comment vertex location: the sum of weight * vertex, on the input and on the intrinsic one\n"
    "comment vertex input_face: a face of the input that contains it; -1 for crossings\n"
    "comment face: contained in input_face and intrinsic_face; neighbours of these differ in "
    "colour\n"
    "comment edge: lies on input_edge, on intrinsic_edge or on both\n";
inline constexpr std::string_view PLY_vertex_properties =
    "property double x\nproperty double y\nproperty double z\n"
    "property uchar kind\n"
    "property int input_face\nproperty int input_edge\nproperty int intrinsic_edge\n"
    "property int input_vertex_0\nproperty int input_vertex_1\nproperty int input_vertex_2\n"
    "property double input_weight_0\nproperty double input_weight_1\n"
    "property double input_weight_2\n"
    "property int intrinsic_vertex_0\nproperty int intrinsic_vertex_1\n"
    "property double intrinsic_weight_0\nproperty double intrinsic_weight_1\n";
inline constexpr std::string_view PLY_face_properties =
    "property list uchar int vertex_indices\n"
    "property int input_face\nproperty int intrinsic_face\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";
inline constexpr std::string_view PLY_edge_properties =
    "property int vertex1\nproperty int vertex2\n"
    "property int input_edge\nproperty int intrinsic_edge\n";

// Writes the elements of a PLY file, in binary or as text.
template <bool is_binary>
class PLY_subdivision_writer {
public:
  PLY_subdivision_writer(std::ostream& out, const Common_subdivision& s, Subdivision_points points,
                         Vertex_fields fields)
      : out_(out), s_(s), points_(points), fields_(fields) {}

  bool run() {
    write_header();
    for (std::size_t v = 0; v < points_.size(); ++v) write_vertex(v);
    const std::vector<Rgb_color> colors = intrinsic_face_colors(s_);
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) write_face(f, colors);
    for_each_subdivision_edge(
        s_, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side& side) {
          put(signed_label(a), signed_label(b), signed_label(side.input_edge),
              signed_label(side.intrinsic_edge));
          end();
        });
    return out_.flush();
  }

private:
  void write_header() {
    std::size_t edges = 0;
    for_each_subdivision_edge(
        s_, [&](std::uint32_t, std::uint32_t, const Common_subdivision::Side&) { ++edges; });
    out_.text("ply\nformat ", is_binary ? "binary_little_endian" : "ascii", " 1.0\n", PLY_comments,
              "element vertex ", points_.size(), "\n", PLY_vertex_properties);
    for (const Vertex_field& field : fields_) out_.text("property double ", field.name, "\n");
    out_.text("element face ", s_.number_of_faces(), "\n", PLY_face_properties, "element edge ",
              edges, "\n", PLY_edge_properties, "end_header\n");
  }

  void write_vertex(std::size_t v) {
    put(points_[v][0], points_[v][1], points_[v][2], static_cast<std::uint8_t>(s_.kind(v)));
    if (v < s_.vertices.size()) {
      put(signed_label(s_.vertices[v].input_face), signed_label(Common_subdivision::none),
          signed_label(Common_subdivision::none));
    } else {
      const Common_subdivision::Crossing& c = s_.crossings[v - s_.vertices.size()];
      put(signed_label(Common_subdivision::none), signed_label(c.on_input.edge),
          signed_label(c.on_intrinsic.edge));
    }
    write_location<3>(s_.on_input(v));
    write_location<2>(s_.on_intrinsic(v));
    for (const Vertex_field& field : fields_) put(field.values[v]);
    end();
  }

  template <std::size_t size>
  void write_location(const Weighted_vertices& w) {
    for (std::size_t i = 0; i < size; ++i)
      put(signed_label(i < w.size ? w.vertices[i] : Common_subdivision::none));
    for (std::size_t i = 0; i < size; ++i) put(i < w.size ? w.weights[i] : 0.);
  }

  // A face has at most six sides: it is in a face of the input and in an intrinsic one.
  void write_face(std::size_t f, const std::vector<Rgb_color>& colors) {
    const std::span<const std::uint32_t> face = s_.face(f);
    put(static_cast<std::uint8_t>(face.size()));
    for (const std::uint32_t v : face) put(signed_label(v));
    const Rgb_color& c = colors[s_.intrinsic_face[f]];
    put(signed_label(s_.input_face[f]), signed_label(s_.intrinsic_face[f]), c[0], c[1], c[2]);
    end();
  }

  template <class... Values>
  void put(Values... values) {
    if constexpr (is_binary)
      (out_.binary(values), ...);
    else
      (put_word(values), ...);
  }
  template <class Value>
  void put_word(Value value) {
    if (!at_start_) out_.text(' ');
    at_start_ = false;
    out_.text(value);
  }
  void end() {
    if constexpr (!is_binary) out_.text('\n');
    at_start_ = true;
  }

  Output_buffer out_;
  const Common_subdivision& s_;
  Subdivision_points points_;
  Vertex_fields fields_;
  bool at_start_ = true;
};

} // namespace internal

/*!
\brief writes a common subdivision with all its labels as PLY.

Elements `vertex`, `face` and, each once, `edge`; comments in the header say what the properties mean.
\param out the stream, binary
\param s the subdivision
\param points the position of each vertex, see `positions()`
\param fields numbers to be written for each vertex
\param options `binary`: little endian, else text, both without loss
\throws Invalid_input if `points` or a field do not have one value for each vertex
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision_PLY(std::ostream& out, const Common_subdivision& s,
                                         std::span<const std::array<double, 3>> points,
                                         std::span<const Vertex_field> fields = {},
                                         const Common_subdivision_output& options = {}) {
  internal::check_output(s, points, fields);
  internal::check_written(
      options.binary ? internal::PLY_subdivision_writer<true>(out, s, points, fields).run()
                     : internal::PLY_subdivision_writer<false>(out, s, points, fields).run());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_PLY_H
