// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Writes the sections of the file format in their order.
template <class Metric>
class Stored_triangulation_writer {
public:
  Stored_triangulation_writer(std::ostream& out, Triangulation_to_write<Metric> t)
      : out_(out, true), t_(std::move(t)), mesh_(t_.mesh) {
    prefer_border_halfedges();
  }

  bool run() {
    write_report();
    if (t_.coordinates == nullptr)
      write_names();
    else
      write_input(t_.coordinates->input());
    write_list("polygons", t_.input.names().polygon_of_triangle);
    out_.line("sheets", t_.input.names().sheets);
    write_list("rows", t_.input.names().row_of_vertex);
    if (t_.coordinates != nullptr && t_.coordinates->input().metric().is_embedded() &&
        has_polygons())
      write_planar_polygons(t_.input.planar_polygons());
    write_vertices();
    write_edges();
    write_faces();
    write_border("border", mesh_);
    if (t_.coordinates != nullptr) write_places();
    out_.line("end");
    return out_.flush();
  }

private:
  // the format requires this at vertices
  void prefer_border_halfedges() {
    for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Gluing_map::Vertex v = mesh_.target({h});
      if (mesh_.face({h}).index == Gluing::none &&
          mesh_.face(mesh_.halfedge(v)).index != Gluing::none)
        mesh_.set_halfedge(v, {h});
    }
  }

  void write_report() {
    const Input_report& report = t_.input.report();
    const auto kind =
        std::find_if(mollification_names.begin(), mollification_names.end(),
                     [&](const auto& n) { return n.first == report.mollification.kind; });
    out_.line("IDT", intrinsic_triangulation_format_version, arithmetic_name<Metric>);
    out_.line("scale", t_.input.scale_exponent());
    out_.line("degenerate_faces", report.degenerate_faces);
    out_.line("mollification", kind->second, report.mollification.delta);
    out_.line("renumbered", report.renumbered ? 1 : 0);
    out_.line("triangulated_polygons", report.triangulated_polygons);
    out_.line("reversed_faces", report.reversed_faces);
  }

  // all data of an input without surface
  void write_names() {
    const Input_names& names = t_.input.names();
    out_.line("input", no_input_name);
    out_.line("input_vertices", t_.input.number_of_vertices());
    for (std::uint32_t v = 0; v < t_.input.number_of_vertices(); ++v)
      out_.line(names.vertices.user(v));
    write_list("input_edges", names.edges.users());
    write_list("input_faces", names.faces.users());
  }

  void write_input(const Input& input) {
    const Input_metric& metric = input.metric();
    const Input_names& names = t_.input.names();
    out_.line("input", !metric.is_embedded() ? squared_lengths_name
                       : has_polygons()      ? planar_polygons_name
                                             : points_name);
    out_.line("delta", metric.delta());
    out_.line("input_vertices", input.number_of_vertices());
    for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v) {
      write_name(names.vertices.user(v));
      write_halfedge_of_vertex(input.mesh(), v);
      if (metric.is_embedded())
        for (const double x : metric.points()[v]) out_.words(x);
      out_.line();
    }
    out_.line("input_edges", input.number_of_edges());
    for (std::uint32_t e = 0; e < input.number_of_edges(); ++e) {
      write_name(names.edges.user(e));
      if (!metric.is_embedded()) out_.words(metric.squared_lengths()[e]);
      out_.line();
    }
    out_.line("input_faces", input.number_of_faces());
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      write_name(names.faces.user(f));
      write_sides(input.mesh(), f);
      out_.line();
    }
    write_border("input_border", input.mesh());
  }

  bool has_polygons() const { return !t_.input.planar_polygons().empty(); }

  void write_planar_polygons(const Planar_polygons& polygons) {
    out_.line(planar_polygons_name, polygons.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const Planar_polygons::Polygon polygon = polygons(polygons.face(i));
      out_.words(polygons.face(i), polygon.points.size());
      for (std::size_t k = 0; k < polygon.points.size(); ++k)
        out_.words(polygon.vertices[k], polygon.points[k][0], polygon.points[k][1]);
      out_.line();
    }
  }

  void write_list(std::string_view keyword, const std::vector<std::uint32_t>& numbers) {
    out_.line(keyword, numbers.size());
    for (const std::uint32_t i : numbers) {
      write_name(i);
      out_.line();
    }
  }

  void write_name(std::uint32_t i) {
    if (i == Gluing::none)
      out_.words("-");
    else
      out_.words(i);
  }

  void write_halfedge_of_vertex(const Gluing_map& mesh, std::uint32_t v) {
    write_name(mesh.halfedge(Gluing_map::Vertex{v}).index);
  }

  void write_sides(const Gluing_map& mesh, std::uint32_t f) {
    const auto [a, b, c] = mesh.sides({f});
    out_.words(a.index, b.index, c.index, mesh.target(c).index, mesh.target(a).index,
               mesh.target(b).index);
  }

  void write_border(std::string_view keyword, const Gluing_map& mesh) {
    std::vector<std::uint32_t> border;
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face({h}).index == Gluing::none) border.push_back(h);
    out_.line(keyword, border.size());
    for (const std::uint32_t h : border) out_.line(h, mesh.next({h}).index);
  }

  void write_vertices() {
    out_.line("vertices", mesh_.number_of_vertices());
    for (std::uint32_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      write_halfedge_of_vertex(mesh_, v);
      out_.line();
    }
  }

  void write_edges() {
    out_.line("edges", mesh_.number_of_edges());
    for (std::uint32_t i = 0; i < mesh_.number_of_edges(); ++i) {
      const std::uint32_t e = t_.old_edges[i];
      write_value(t_.metric.squared_length(e), t_.metric.approximate_squared_length(e));
      if (t_.coordinates != nullptr) {
        out_.words(t_.coordinates->normal_coordinate(e));
        for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
          const std::uint32_t slot = t_.coordinates->roundabout(h);
          write_name(slot == Gluing::none ? slot : t_.coordinates->fans().halfedge(slot));
        }
      }
      out_.line();
    }
  }

  void write_faces() {
    out_.line("faces", mesh_.number_of_faces());
    for (std::uint32_t i = 0; i < mesh_.number_of_faces(); ++i) {
      write_sides(mesh_, i);
      const std::uint32_t f = t_.old_faces[i];
      write_value(t_.metric.quadruple_area(f), t_.metric.approximate_quadruple_area(f));
      out_.line();
    }
  }

  // an interval and a number in it, or just a number
  template <class FT>
  void write_value(const FT& x, double near) {
    if constexpr (Metric::is_exact)
      out_.words(std::max(x.inf(), 0.0), x.sup(), std::max(near, 0.0)); // no value is negative
    else
      out_.words(x);
  }

  void write_places() {
    const std::uint32_t of_input = t_.input.number_of_vertices();
    out_.line("places", mesh_.number_of_vertices() - of_input);
    for (std::uint32_t i = of_input; i < mesh_.number_of_vertices(); ++i) {
      const std::uint32_t to = mesh_.halfedge(Gluing_map::Vertex{i}).index;
      const std::uint32_t from = 2 * t_.old_edges[to / 2] + (to ^ 1U) % 2;
      const auto& [h, w] = t_.coordinates->location(t_.old_vertices[i]);
      // no curve starts from a vertex inside a face
      if (t_.coordinates->roundabout(from) == Gluing::none)
        out_.line(in_face_name, h, w[0], w[1], w[2]);
      else
        out_.line(on_edge_name, h, w[0], w[1]);
    }
  }

  Output_buffer out_; // hexadecimal, so that nothing is rounded
  Triangulation_to_write<Metric> t_;
  Gluing_map& mesh_;
};

} // namespace

template <class Metric>
bool write_stored_triangulation(std::ostream& out, Triangulation_to_write<Metric> t) {
  return Stored_triangulation_writer<Metric>(out, std::move(t)).run();
}
template bool write_stored_triangulation(std::ostream&,
                                         Triangulation_to_write<Exact_euclidean_metric>);
template bool write_stored_triangulation(std::ostream&,
                                         Triangulation_to_write<Euclidean_metric<double>>);

} // namespace CGAL::Intrinsic_triangulations::internal
