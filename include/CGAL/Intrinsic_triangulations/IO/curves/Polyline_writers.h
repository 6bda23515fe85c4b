// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_WRITERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_WRITERS_H

#include <CGAL/Intrinsic_triangulations/IO/curves/Polyline.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/VTK_array_writer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Polylines with their points numbered through.
struct Numbered_polylines {
  std::vector<std::array<double, 3>> points;
  std::vector<std::int32_t> point_labels;
  // of all polylines with several points, then of those with a single one: their vertices, the first one
  // again in the end of those that are closed
  std::vector<std::vector<std::int64_t>> lines, verts;
  std::vector<std::int32_t> line_labels, vert_labels;

  explicit Numbered_polylines(std::span<const Polyline> polylines) {
    for (const Polyline& p : polylines) {
      std::vector<std::int64_t> vertices;
      for (const std::array<double, 3>& x : p.points) {
        vertices.push_back(static_cast<std::int64_t>(points.size()));
        points.push_back(x);
        point_labels.push_back(p.label);
      }
      if (vertices.empty()) continue;
      const bool is_line = p.number_of_segments() > 0;
      if (is_line && p.is_closed) vertices.push_back(vertices.front());
      (is_line ? lines : verts).push_back(std::move(vertices));
      (is_line ? line_labels : vert_labels).push_back(p.label);
    }
  }
};

// Cells of VTK's XML format: their points one after another, and where each cell ends.
inline void write_VTK_cells(Output_buffer& out, std::string_view kind,
                            const std::vector<std::vector<std::int64_t>>& cells) {
  std::vector<std::int64_t> connectivity, offsets;
  for (const std::vector<std::int64_t>& cell : cells) {
    connectivity.insert(connectivity.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  VTK_array_writer data(out);
  out.text("<", kind, ">\n");
  data.scalars("connectivity", connectivity.size(), [&](std::size_t i) { return connectivity[i]; });
  data.scalars("offsets", offsets.size(), [&](std::size_t i) { return offsets[i]; });
  out.text("</", kind, ">\n");
}

// Cells are numbered through: those of one point before lines.
inline void write_polylines_VTP(Output_buffer& out, std::span<const Polyline> polylines,
                                std::string_view label) {
  const Numbered_polylines p(polylines);
  VTK_array_writer data(out);
  out.text("<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"",
           p.points.size(), "\" NumberOfVerts=\"", p.verts.size(), "\" NumberOfLines=\"",
           p.lines.size(), "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<CellData Scalars=\"",
           label, "\">\n");
  const std::size_t m = p.verts.size();
  data.scalars(label, m + p.lines.size(),
               [&](std::size_t i) { return i < m ? p.vert_labels[i] : p.line_labels[i - m]; });
  out.text("</CellData>\n<Points>\n");
  data.arrays("Points", p.points.size(), [&](std::size_t v) { return p.points[v]; });
  out.text("</Points>\n");
  write_VTK_cells(out, "Verts", p.verts);
  write_VTK_cells(out, "Lines", p.lines);
  out.text("</Piece>\n</PolyData>\n</VTKFile>\n");
}

// Numbers of vertices count from 1.
inline void write_polylines_OBJ(Output_buffer& out, std::span<const Polyline> polylines,
                                std::string_view label) {
  const Numbered_polylines p(polylines);
  out.text("# polylines and their labels: ", label, "\n");
  for (const std::array<double, 3>& x : p.points) out.line('v', x[0], x[1], x[2]);
  const auto write = [&](char kind, const auto& cells, const auto& labels) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      out.words("#", label);
      out.line(labels[i]);
      out.words(kind);
      for (const std::int64_t v : cells[i]) out.words(v + 1);
      out.line();
    }
  };
  write('l', p.lines, p.line_labels);
  write('p', p.verts, p.vert_labels);
}

// Binary, little endian.
inline void write_polylines_PLY(Output_buffer& out, std::span<const Polyline> polylines,
                                std::string_view label) {
  const Numbered_polylines p(polylines);
  std::size_t edges = 0;
  for (const std::vector<std::int64_t>& line : p.lines) edges += line.size() - 1;
  out.text("ply\nformat binary_little_endian 1.0\n"
           "comment polylines and their labels\nelement vertex ",
           p.points.size(),
           "\nproperty double x\nproperty double y\nproperty double z\nproperty int ", label,
           "\nelement edge ", edges, "\nproperty int vertex1\nproperty int vertex2\nproperty int ",
           label, "\nend_header\n");
  for (std::size_t v = 0; v < p.points.size(); ++v) {
    for (const double x : p.points[v]) out.binary(x);
    out.binary(p.point_labels[v]);
  }
  for (std::size_t i = 0; i < p.lines.size(); ++i)
    for (std::size_t k = 0; k + 1 < p.lines[i].size(); ++k) {
      out.binary(static_cast<std::int32_t>(p.lines[i][k]));
      out.binary(static_cast<std::int32_t>(p.lines[i][k + 1]));
      out.binary(p.line_labels[i]);
    }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_POLYLINE_WRITERS_H
