// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/VTK_array_writer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Writes VTK's XML format for polygon data: labels are point and cell data, intrinsic edges are lines.
class VTP_subdivision_writer {
  static constexpr std::uint32_t none = Common_subdivision::none;

public:
  VTP_subdivision_writer(Output_buffer& out, const Subdivision_output& o, bool with_lines)
      : out_(out), data_(out), o_(o), s_(o.s) {
    if (!with_lines) return;
    lines_ = intrinsic_edge_polylines(s_);
    for (std::size_t e = 0; e < lines_.size(); ++e)
      if (!lines_[e].empty()) line_edges_.push_back(static_cast<std::uint32_t>(e));
  }

  void run() {
    out_.text(
        "<?xml version=\"1.0\"?>\n"
        "<!-- Common subdivision of a mesh (the input) and an intrinsic triangulation of it.\n"
        "Numbers count from 0; -1: none. kind 0: vertex of the input; 1: inserted into the\n"
        "intrinsic triangulation; 2: crossing of input_edge and intrinsic_edge.\n"
        "Lines are the intrinsic edges. sheet: of a cover, 0 on the front of the user's face,\n"
        "1 on its back. -->\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"",
        o_.points.size(), "\" NumberOfVerts=\"0\" NumberOfLines=\"", line_edges_.size(),
        "\" NumberOfStrips=\"0\" NumberOfPolys=\"", s_.number_of_faces(), "\">\n");
    write_point_data();
    write_cell_data();
    out_.text("<Points>\n");
    data_.arrays("Points", o_.points.size(), [&](std::size_t v) { return o_.points[v]; });
    out_.text("</Points>\n");
    write_lines();
    write_polygons();
    out_.text("</Piece>\n</PolyData>\n</VTKFile>\n");
  }

private:
  void write_point_data() {
    const std::size_t n = o_.points.size();
    out_.text("<PointData>\n");
    write_fields(Subdivision_field::Place::vertices, 0, n);
    for_each_vertex_label(s_, [&](std::string_view name, std::string_view, auto values) {
      data_.arrays(name, n, values);
    });
    out_.text("</PointData>\n");
  }

  // Writes the fields of a place: at the `first` elements, which have none, not a number or no
  // vector.
  void write_fields(Subdivision_field::Place place, std::size_t first, std::size_t n) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const Subdivision_field& field : o_.fields) {
      const std::vector<double>& x = field.values;
      if (field.place != place) continue;
      if (field.components == 1)
        data_.scalars(field.name, n,
                      [&](std::size_t i) { return i < first ? unknown : x[i - first]; });
      else
        data_.arrays(field.name, n, [&](std::size_t i) {
          const std::size_t k = 3 * (i - first);
          return i < first ? std::array{0., 0., 0.} : std::array{x[k], x[k + 1], x[k + 2]};
        });
    }
  }

  // Cells are numbered through: lines before polygons.
  void write_cell_data() {
    const std::size_t m = line_edges_.size(), n = m + s_.number_of_faces();
    const auto label = [&](const std::vector<std::uint32_t>& faces) {
      return [&, m](std::size_t i) { return signed_label(i < m ? none : faces[i - m]); };
    };
    out_.text("<CellData>\n");
    write_fields(Subdivision_field::Place::faces, m, n);
    data_.scalars("input_face", n, label(s_.input_face));
    data_.scalars("intrinsic_face", n, label(s_.intrinsic_face));
    data_.scalars("intrinsic_edge", n,
                  [&](std::size_t i) { return signed_label(i < m ? line_edges_[i] : none); });
    if (!s_.sheet.empty())
      data_.scalars("sheet", n, [&, m](std::size_t i) {
        return i < m ? std::int32_t{-1} : std::int32_t{s_.sheet[i - m]};
      });
    out_.text("</CellData>\n");
  }

  void write_lines() {
    out_.text("<Lines>\n");
    data_.scalars("connectivity", lines_.vertices.size(),
                  [&](std::size_t i) { return std::int64_t{lines_.vertices[i]}; });
    data_.scalars("offsets", line_edges_.size(), [&](std::size_t i) {
      return static_cast<std::int64_t>(lines_.begin[line_edges_[i] + std::size_t{1}]);
    });
    out_.text("</Lines>\n");
  }

  void write_polygons() {
    out_.text("<Polys>\n");
    data_.scalars("connectivity", s_.corner.size(),
                  [&](std::size_t i) { return std::int64_t{s_.corner[i]}; });
    data_.scalars("offsets", s_.number_of_faces(),
                  [&](std::size_t f) { return std::int64_t{s_.face_begin[f + 1]}; });
    out_.text("</Polys>\n");
  }

  Output_buffer& out_;
  VTK_array_writer data_;
  const Subdivision_output& o_;
  const Common_subdivision& s_;
  Edge_polylines lines_;
  std::vector<std::uint32_t> line_edges_; // the edge of each line
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_VTP_H
