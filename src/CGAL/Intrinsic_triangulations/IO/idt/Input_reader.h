// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INPUT_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INPUT_READER_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Reads what a triangulation was built from, the first sections of a file.
class Input_reader {
public:
  explicit Input_reader(Text_reader& in) : in_(in), connectivity_(in) {}

  // \tparam Metric of the triangulation, which gives the surface its lengths and areas
  template <class Metric>
  std::shared_ptr<const Input_definition> run() {
    int scale_exponent = 0;
    in_.line("scale", [&] {
      scale_exponent = in_.integer<int>("exponent");
      if (scale_exponent < -maximal_exponent || scale_exponent > maximal_exponent)
        in_.fail("the exponent is out of range");
    });
    read_report();
    read_kind();
    read_vertices();
    read_edges();
    read_faces();
    Gluing_map& mesh = connectivity_.mesh;
    Input_definition::Parts parts{
        mesh.number_of_vertices(), metric(scale_exponent), read_names(), {}, report_};
    if (!has_surface()) return std::make_shared<const Input_definition>(std::move(parts));
    parts.planar_polygons = read_planar_polygons(parts.names);
    if (!parts.planar_polygons.empty())
      parts.metric.set_excess(planar_excess(mesh, parts.metric.points(), parts.names,
                                            parts.planar_polygons, scale_exponent));
    try {
      const Metric values(mesh, parts.metric);
      return std::make_shared<const Input>(std::move(mesh), std::move(parts), values);
    } catch (const Invalid_input& e) {
      in_.fail(e.what());
    }
  }

private:
  bool has_surface() const { return kind_ != no_input_name; }
  bool has_polygons() const { return kind_ == planar_polygons_name; }
  bool is_embedded() const { return kind_ == points_name || has_polygons(); }

  void read_report() {
    in_.line("degenerate_faces",
             [&] { report_.degenerate_faces = in_.integer<std::size_t>("number of faces"); });
    in_.line("mollification", [&] {
      const std::string name(in_.word());
      const auto kind = std::find_if(mollification_names.begin(), mollification_names.end(),
                                     [&](const auto& n) { return n.second == name; });
      if (kind == mollification_names.end())
        in_.fail("the mollification \"" + shown(name) + "\" is unknown");
      report_.mollification.kind = kind->first;
      in_.nonnegative(report_.mollification.delta, "delta");
    });
    in_.line("renumbered", [&] { report_.renumbered = in_.index(2, "truth value") == 1; });
    in_.line("triangulated_polygons", [&] {
      report_.triangulated_polygons = in_.integer<std::size_t>("number of polygons");
    });
    in_.line("reversed_faces",
             [&] { report_.reversed_faces = in_.integer<std::size_t>("number of faces"); });
  }

  void read_kind() {
    in_.line("input", [this] {
      kind_ = in_.word();
      if (kind_ != points_name && kind_ != squared_lengths_name && kind_ != no_input_name &&
          !has_polygons())
        in_.fail("the input \"" + shown(kind_) + "\" is unknown");
    });
    if (has_surface()) in_.line("delta", [this] { in_.nonnegative(delta_, "delta"); });
  }

  void read_vertices() {
    const std::uint32_t count = read_count(in_, "input_vertices", Gluing::none - 1);
    in_.lines(count, [&](std::uint32_t) {
      vertex_names_.push_back(in_.index(count, "vertex"));
      if (!has_surface()) return;
      connectivity_.read_halfedge_of_vertex();
      if (!is_embedded()) return;
      for (double& x : points_.emplace_back()) x = in_.real("coordinate");
    });
    if (!has_surface()) connectivity_.mesh = Gluing_map(count, 0, 0);
  }

  void read_edges() {
    edges_ = read_count(in_, "input_edges", Gluing::none / 2);
    in_.lines(edges_, [&](std::uint32_t) {
      const std::string_view name = in_.word();
      std::uint32_t i = Gluing::none; // a diagonal of a polygon
      if (name != "-" && (!parse_number(name, i) || i >= edges_))
        in_.fail("\"" + shown(name) + "\" is no valid edge");
      edge_names_.push_back(i);
      if (has_surface() && !is_embedded())
        in_.nonnegative(squared_lengths_.emplace_back(), "squared length");
    });
  }

  void read_faces() {
    const auto read_name = [this](std::uint32_t count) {
      face_names_.push_back(in_.index(count, "face"));
    };
    if (!has_surface()) {
      const std::uint32_t count = read_count(in_, "input_faces", Gluing::none - 1);
      in_.lines(count, [&](std::uint32_t) { read_name(count); });
      return;
    }
    connectivity_.start_faces("input_faces", edges_);
    const std::uint32_t count = connectivity_.mesh.number_of_faces();
    if (count == 0) in_.fail("the input needs a face");
    in_.lines(count, [&](std::uint32_t f) {
      read_name(count);
      connectivity_.read_face(f);
      const auto [h, n, l] = connectivity_.mesh.sides({f});
      if (n.index == (h.index ^ 1U) || l.index == (h.index ^ 1U))
        in_.fail("the first side of the face is glued to another one of it");
    });
    connectivity_.read_border("input_border");
  }

  Input_metric metric(int scale_exponent) {
    const Gluing_map& mesh = connectivity_.mesh;
    if (!has_surface()) return Input_metric({}, {}, {}, 0, scale_exponent);
    Input_metric result =
        is_embedded()
            ? Input_metric::from_points(mesh, std::move(points_), scale_exponent)
            : Input_metric::from_squared_lengths(mesh, std::move(squared_lengths_), scale_exponent);
    result.set_delta(delta_);
    return result;
  }

  Input_names read_names() {
    Input_names names;
    names.vertices = element_names(std::move(vertex_names_), "vertex");
    names.edges = element_names(std::move(edge_names_), "edge");
    names.faces = element_names(std::move(face_names_), "face");
    const std::uint32_t count = read_count(in_, "polygons", Gluing::none - 1);
    in_.lines(count, [&](std::uint32_t) {
      // the user's faces without area have a number, but no triangle
      names.polygon_of_triangle.push_back(in_.index(Gluing::none, "polygon"));
    });
    if (count != 0 && count != connectivity_.mesh.number_of_faces() && has_surface())
      in_.fail("every face of the input needs its polygon, or none");
    in_.line("sheets", [&] {
      names.sheets = in_.index(most_sheets, "number of sheets");
      if (names.sheets == 0) in_.fail("the number of sheets must be at least 1");
    });
    read_rows(names.row_of_vertex);
    return names;
  }

  Planar_polygons read_planar_polygons(const Input_names& names) {
    Planar_polygons result;
    if (!has_polygons()) return result;
    const std::uint32_t vertices = connectivity_.mesh.number_of_vertices();
    const std::uint32_t rows = names.number_of_rows(vertices);
    const std::uint32_t count =
        read_count(in_, planar_polygons_name, connectivity_.mesh.number_of_faces());
    std::vector<std::uint32_t> corners;
    std::vector<Planar_polygons::Point> points;
    in_.lines(count, [&](std::uint32_t i) {
      const std::uint32_t face = in_.index(Gluing::none, "polygon");
      if (i > 0 && face <= result.face(i - 1)) in_.fail("the polygons are not in their order");
      corners.resize(in_.index(rows + 1, "number of corners"));
      points.resize(corners.size());
      for (std::size_t k = 0; k < corners.size(); ++k) {
        corners[k] = in_.index(rows, "vertex");
        for (double& x : points[k]) x = in_.real("coordinate");
      }
      result.add(face, corners, points);
    });
    check_corners(names, result);
    return result;
  }

  // The triangles of a polygon are between its corners.
  void check_corners(const Input_names& names, const Planar_polygons& polygons) const {
    for (std::uint32_t f = 0; f < connectivity_.mesh.number_of_faces(); ++f) {
      const Planar_polygons::Polygon polygon = polygons(names.polygon(f));
      if (polygon.points.empty()) continue;
      for (const Gluing_map::Halfedge h : connectivity_.mesh.sides({f}))
        if (polygon.corner(names.row(connectivity_.mesh.source(h).index)) == polygon.points.size())
          in_.fail("a triangle of face " + std::to_string(names.polygon(f)) +
                   " has a vertex that is no corner of its planar polygon");
    }
  }

  // Every row has a vertex, in their order.
  void read_rows(std::vector<std::uint32_t>& rows) {
    const std::uint32_t vertices = connectivity_.mesh.number_of_vertices(),
                        count = read_count(in_, "rows", vertices);
    in_.lines(count, [&](std::uint32_t i) {
      rows.push_back(in_.index(count, "row"));
      if (rows[i] > (i == 0 ? 0 : rows[i - 1] + 1) || (i > 0 && rows[i] < rows[i - 1]))
        in_.fail("row " + std::to_string(rows[i]) + " is not where it belongs");
    });
    if (count != 0 && count != vertices)
      in_.fail("every vertex of the input needs its row, or none");
  }

  // Checks that no name occurs twice, and that elements with names are in order unless renumbered.
  Element_names element_names(std::vector<std::uint32_t> names, const std::string& kind) const {
    std::vector<char> seen(names.size(), 0);
    bool is_identity = true;
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      is_identity = is_identity && names[i] == i;
      if (names[i] == Gluing::none) continue;
      if (seen[names[i]]++ != 0 || (!report_.renumbered && kind != "edge" && names[i] != i))
        in_.fail("the name " + std::to_string(names[i]) + " of a " + kind +
                 " is not where it belongs");
    }
    return is_identity ? Element_names() : Element_names(std::move(names));
  }

  // Covers of triangles have two, those of clouds six: so many are a damaged file.
  static constexpr std::uint32_t most_sheets = 1U << 16;
  static constexpr int maximal_exponent = 2200; // beyond that of the quotient of any two doubles

  Text_reader& in_;
  Connectivity_reader connectivity_;
  Input_report report_;
  std::string kind_;
  double delta_ = 0;
  std::uint32_t edges_ = 0;
  std::vector<std::uint32_t> vertex_names_, edge_names_, face_names_;
  std::vector<Input_metric::Point> points_;
  std::vector<double> squared_lengths_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INPUT_READER_H
