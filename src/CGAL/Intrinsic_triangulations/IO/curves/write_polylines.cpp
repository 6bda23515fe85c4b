// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
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
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

// Cells of some kind: their points, by number, one after another; where each ends; their labels.
struct Labelled_cells {
  std::vector<std::size_t> points, ends;
  std::vector<std::int32_t> labels;
};

// Polylines with their points numbered through.
struct Numbered_polylines {
  std::vector<std::array<double, 3>> points;
  std::vector<std::int32_t> point_labels;
  Labelled_cells verts, lines; // a closed line has its first point again in the end

  explicit Numbered_polylines(std::span<const Polyline> polylines) {
    for (const Polyline& p : polylines) {
      if (p.points.empty()) continue;
      Labelled_cells& cells = p.number_of_segments() > 0 ? lines : verts;
      const std::size_t first = points.size();
      for (const std::array<double, 3>& x : p.points) {
        cells.points.push_back(points.size());
        points.push_back(x);
        point_labels.push_back(p.label);
      }
      if (p.number_of_segments() > 0 && p.is_closed) cells.points.push_back(first);
      cells.ends.push_back(cells.points.size());
      cells.labels.push_back(p.label);
    }
  }
};

// Cells are numbered through: those of one point before lines.
void write_polylines_VTP(Output_buffer& out, const Numbered_polylines& p,
                         const std::string& label) {
  const auto at = [](const auto& values) { return [&](std::size_t i) { return values[i]; }; };
  const auto cells = [&](const std::string& name, const Labelled_cells& c) {
    return VTK_cells(name, c.points.size(), at(c.points), c.ends.size(), at(c.ends));
  };
  std::vector<std::int32_t> labels = p.verts.labels;
  labels.insert(labels.end(), p.lines.labels.begin(), p.lines.labels.end());
  write_VTP(
      out, "",
      std::array<Table, 4>{
          {{"CellData Scalars=\"" + label + "\"", {numbers(label, labels.size(), at(labels))}},
           {"Points", {tuples("Points", {"x", "y", "z"}, p.points.size(), at(p.points))}},
           cells("Verts", p.verts),
           cells("Lines", p.lines)}});
}

// Numbers of vertices count from 1.
void write_polylines_OBJ(Output_buffer& out, const Numbered_polylines& p,
                         const std::string& label) {
  out.text("# polylines and their labels: ", label, "\n");
  for (const std::array<double, 3>& x : p.points) out.line('v', x[0], x[1], x[2]);
  const auto write = [&](char kind, const Labelled_cells& cells) {
    for (std::size_t i = 0, k = 0; i < cells.ends.size(); ++i) {
      out.line("#", label, cells.labels[i]);
      out.words(kind);
      for (; k < cells.ends[i]; ++k) out.words(cells.points[k] + 1);
      out.line();
    }
  };
  write('l', p.lines);
  write('p', p.verts);
}

void write_polylines_PLY(Output_buffer& out, const Numbered_polylines& p,
                         const std::string& label) {
  std::vector<std::array<std::int32_t, 3>> edges; // and their labels
  for (std::size_t i = 0, k = 0; i < p.lines.ends.size(); ++i, ++k)
    for (; k + 1 < p.lines.ends[i]; ++k)
      edges.push_back({static_cast<std::int32_t>(p.lines.points[k]),
                       static_cast<std::int32_t>(p.lines.points[k + 1]), p.lines.labels[i]});
  const std::size_t n = p.points.size();
  write_PLY(out, true, "comment polylines and their labels\n",
            std::array<Table, 2>{
                {{"vertex",
                  {tuples("Points", {"x", "y", "z"}, n, [&](std::size_t v) { return p.points[v]; }),
                   numbers(label, n, [&](std::size_t v) { return p.point_labels[v]; })}},
                 {"edge",
                  {tuples("edge", {"vertex1", "vertex2", label}, edges.size(),
                          [&](std::size_t e) { return edges[e]; })}}}});
}

} // namespace
} // namespace internal

void write_polylines(std::ostream& out, std::string_view extension,
                     std::span<const Polyline> polylines, const std::string& label) {
  const std::string name = internal::plain_extension(extension);
  const internal::Numbered_polylines numbered(polylines);
  internal::Output_buffer buffer(out);
  if (name == "vtp")
    internal::write_polylines_VTP(buffer, numbered, label);
  else if (name == "obj")
    internal::write_polylines_OBJ(buffer, numbered, label);
  else if (name == "ply")
    internal::write_polylines_PLY(buffer, numbered, label);
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write polylines to .vtp, .obj or .ply");
  if (!buffer.flush()) throw std::runtime_error("the polylines cannot be written completely");
}

void write_polylines(const std::string& path, std::span<const Polyline> polylines,
                     const std::string& label) {
  write_file(path, [&](std::ostream& out) {
    write_polylines(out, std::filesystem::path(path).extension().string(), polylines, label);
  });
}

} // namespace CGAL::Intrinsic_triangulations
