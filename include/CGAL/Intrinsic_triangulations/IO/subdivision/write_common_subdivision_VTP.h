// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Base64_writer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// The name of a number type in VTK's XML formats.
template <class T>
inline constexpr std::string_view VTK_type = "";
template <>
inline constexpr std::string_view VTK_type<double> = "Float64";
template <>
inline constexpr std::string_view VTK_type<std::int32_t> = "Int32";
template <>
inline constexpr std::string_view VTK_type<std::int64_t> = "Int64";
template <>
inline constexpr std::string_view VTK_type<std::uint8_t> = "UInt8";

// Writes VTK's XML format for polygon data. Arrays are inline, in base64: the number of their bytes and
// then their numbers, encoded in one go.
class VTP_subdivision_writer {
  using Edge_point = Common_subdivision::Edge_point;
  static constexpr std::uint32_t none = Common_subdivision::none;

public:
  VTP_subdivision_writer(std::ostream& out, const Common_subdivision& s, Subdivision_points points,
                         Vertex_fields fields, bool with_lines)
      : out_(out), s_(s), points_(points), fields_(fields) {
    if (!with_lines) return;
    lines_ = intrinsic_edge_polylines(s);
    for (std::size_t e = 0; e < lines_.size(); ++e)
      if (!lines_[e].empty()) line_edges_.push_back(static_cast<std::uint32_t>(e));
  }

  bool run() {
    out_.text(
        "<?xml version=\"1.0\"?>\n"
        "<!-- Common subdivision of a mesh (the input) and an intrinsic triangulation of it.\n"
        "Numbers count from 0; -1: none. kind 0: vertex of the input; 1: inserted into the\n"
        "intrinsic triangulation; 2: crossing of input_edge and intrinsic_edge.\n"
        "Lines are the intrinsic edges. -->\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"",
        points_.size(), "\" NumberOfVerts=\"0\" NumberOfLines=\"", line_edges_.size(),
        "\" NumberOfStrips=\"0\" NumberOfPolys=\"", s_.number_of_faces(), "\">\n");
    write_point_data();
    write_cell_data();
    out_.text("<Points>\n");
    array<double, 3>("Points", points_.size(), [&](std::size_t v) { return points_[v]; });
    out_.text("</Points>\n");
    write_lines();
    write_polygons();
    out_.text("</Piece>\n</PolyData>\n</VTKFile>\n");
    return out_.flush();
  }

private:
  // Writes `count` tuples, the i-th of which is `tuple(i)`.
  template <class T, std::size_t components, class Tuple>
  void array(std::string_view name, std::size_t count, Tuple tuple) {
    out_.text("<DataArray type=\"", VTK_type<T>, "\" Name=\"", name, "\" NumberOfComponents=\"",
              components, "\" format=\"binary\">\n");
    Base64_writer base64(out_);
    base64.put(std::uint64_t{count * components * sizeof(T)});
    for (std::size_t i = 0; i < count; ++i)
      for (const T x : std::array<T, components>(tuple(i))) base64.put(x);
    base64.finish();
    out_.text("\n</DataArray>\n");
  }
  template <class T, class Value>
  void scalars(std::string_view name, std::size_t count, Value value) {
    array<T, 1>(name, count, [&](std::size_t i) { return std::array<T, 1>{value(i)}; });
  }

  void write_point_data() {
    const std::size_t n = points_.size(), m = s_.vertices.size();
    out_.text("<PointData>\n");
    for (const Vertex_field& field : fields_)
      scalars<double>(field.name, n, [&](std::size_t v) { return field.values[v]; });
    scalars<std::uint8_t>("kind", n,
                          [&](std::size_t v) { return static_cast<std::uint8_t>(s_.kind(v)); });
    scalars<std::int32_t>("input_face", n, [&](std::size_t v) {
      return signed_label(v < m ? s_.vertices[v].input_face : none);
    });
    scalars<std::int32_t>("input_edge", n, [&](std::size_t v) {
      return signed_label(v < m ? none : s_.crossings[v - m].on_input.edge);
    });
    scalars<std::int32_t>("intrinsic_edge", n, [&](std::size_t v) {
      return signed_label(v < m ? none : s_.crossings[v - m].on_intrinsic.edge);
    });
    location<3>("input_vertices", "input_weights", [&](std::size_t v) { return s_.on_input(v); });
    location<2>("intrinsic_vertices", "intrinsic_weights",
                [&](std::size_t v) { return s_.on_intrinsic(v); });
    out_.text("</PointData>\n");
  }

  template <std::size_t size, class Location>
  void location(std::string_view vertices, std::string_view weights, Location where) {
    array<std::int32_t, size>(vertices, points_.size(), [&](std::size_t v) {
      const Weighted_vertices w = where(v);
      std::array<std::int32_t, size> result;
      for (std::size_t i = 0; i < size; ++i)
        result[i] = signed_label(i < w.size ? w.vertices[i] : none);
      return result;
    });
    array<double, size>(weights, points_.size(), [&](std::size_t v) {
      const Weighted_vertices w = where(v);
      std::array<double, size> result;
      for (std::size_t i = 0; i < size; ++i) result[i] = i < w.size ? w.weights[i] : 0.;
      return result;
    });
  }

  // Cells are numbered through: lines before polygons.
  void write_cell_data() {
    const std::size_t m = line_edges_.size(), n = m + s_.number_of_faces();
    const auto label = [&](const std::vector<std::uint32_t>& faces) {
      return [&, m](std::size_t i) { return signed_label(i < m ? none : faces[i - m]); };
    };
    out_.text("<CellData>\n");
    scalars<std::int32_t>("input_face", n, label(s_.input_face));
    scalars<std::int32_t>("intrinsic_face", n, label(s_.intrinsic_face));
    scalars<std::int32_t>("intrinsic_edge", n, [&](std::size_t i) {
      return signed_label(i < m ? line_edges_[i] : none);
    });
    out_.text("</CellData>\n");
  }

  void write_lines() {
    out_.text("<Lines>\n");
    scalars<std::int64_t>("connectivity", lines_.vertices.size(),
                          [&](std::size_t i) { return std::int64_t{lines_.vertices[i]}; });
    scalars<std::int64_t>("offsets", line_edges_.size(), [&](std::size_t i) {
      return static_cast<std::int64_t>(lines_.begin[line_edges_[i] + std::size_t{1}]);
    });
    out_.text("</Lines>\n");
  }

  void write_polygons() {
    out_.text("<Polys>\n");
    scalars<std::int64_t>("connectivity", s_.corner.size(),
                          [&](std::size_t i) { return std::int64_t{s_.corner[i]}; });
    scalars<std::int64_t>("offsets", s_.number_of_faces(),
                          [&](std::size_t f) { return std::int64_t{s_.face_begin[f + 1]}; });
    out_.text("</Polys>\n");
  }

  Output_buffer out_;
  const Common_subdivision& s_;
  Subdivision_points points_;
  Vertex_fields fields_;
  Intrinsic_edge_polylines lines_;
  std::vector<std::uint32_t> line_edges_; // the edge of each line
};

} // namespace internal

/*!
\brief writes a common subdivision with all its labels as VTP, VTK's XML format for polygon data.

Labels are point and cell data; the intrinsic edges are lines.
\param out the stream
\param s the subdivision
\param points the position of each vertex, see `positions()`; written without loss
\param fields numbers to be written for each vertex
\param options `lines_in_VTP`
\throws Invalid_input if `points` or a field do not have one value for each vertex
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision_VTP(std::ostream& out, const Common_subdivision& s,
                                         std::span<const std::array<double, 3>> points,
                                         std::span<const Vertex_field> fields = {},
                                         const Common_subdivision_output& options = {}) {
  internal::check_output(s, points, fields);
  internal::check_written(
      internal::VTP_subdivision_writer(out, s, points, fields, options.lines_in_VTP).run());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H
