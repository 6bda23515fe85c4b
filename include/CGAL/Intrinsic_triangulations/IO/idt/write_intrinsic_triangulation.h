// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Numbers elements of a triangulation anew: in their order, but without the gaps that removals leave.
struct Compact_order {
  template <class Triangulation, class Range>
  Compact_order(const Triangulation& t, const Range& range) {
    for (const auto element : range) old.push_back(t.index(element));
    std::sort(old.begin(), old.end());
    if (!old.empty()) now.resize(old.back() + std::size_t{1});
    for (std::uint32_t i = 0; i < old.size(); ++i) now[old[i]] = i;
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(old.size()); }

  std::vector<std::uint32_t> old, now; // numbers, by those now and by the old ones
};

// Vertices of the input come first. To be used like a `Mesh_adaptor`.
template <class Triangulation>
struct Compact_numbers {
  using Mesh = typename Triangulation::Mesh;

  explicit Compact_numbers(const Triangulation& triangulation)
      : t(triangulation), of_vertices(t, vertices(t.mesh())), of_edges(t, edges(t.mesh())),
        of_faces(t, faces(t.mesh())) {}

  std::uint32_t vertex(typename Triangulation::vertex_descriptor v) const {
    return of_vertices.now[t.index(v)];
  }
  std::uint32_t halfedge(typename Triangulation::halfedge_descriptor h) const {
    const std::uint32_t i = t.numbers().halfedge(h);
    return 2 * of_edges.now[i / 2] + i % 2;
  }
  std::uint32_t face(typename Triangulation::face_descriptor f) const {
    return of_faces.now[t.index(f)];
  }

  std::uint32_t vertex_capacity(const Mesh&) const { return of_vertices.count(); }
  std::uint32_t edge_capacity(const Mesh&) const { return of_edges.count(); }
  std::uint32_t face_capacity(const Mesh&) const { return of_faces.count(); }

  const Triangulation& t;
  Compact_order of_vertices, of_edges, of_faces;
};

// Writes the sections of the file format in their order.
template <class Triangulation>
class Intrinsic_triangulation_writer {
  using Metric = typename Triangulation::Metric;

public:
  Intrinsic_triangulation_writer(std::ostream& out, const Triangulation& t)
      : out_(out, true), t_(t), numbers_(t), mesh_(numbered_copy(t.mesh(), numbers_)) {
    prefer_border_halfedges();
    find_coordinates();
  }

  bool run() {
    write_report();
    if (coordinates_ == nullptr)
      write_names();
    else
      write_input(coordinates_->input());
    write_list("polygons", t_.input().names().polygon_of_triangle);
    out_.line("sheets", t_.input().names().sheets);
    write_list("rows", t_.input().names().row_of_vertex);
    if (coordinates_ != nullptr && coordinates_->input().metric().is_embedded() && has_polygons())
      write_planar_polygons(t_.input().planar_polygons());
    write_vertices();
    write_edges();
    write_faces();
    write_border("border", mesh_);
    if (coordinates_ != nullptr) write_places();
    out_.line("end");
    return out_.flush();
  }

private:
  // none if doubles are all that there is
  void find_coordinates() {
    if constexpr (Metric::is_exact) {
      coordinates_ = t_.places_.coordinates(t_);
      if (coordinates_ == nullptr)
        throw std::length_error("an edge crosses more input edges than a file can count");
    } else if constexpr (Triangulation::has_correspondence) {
      if (t_.input().is_defined_by_metric())
        coordinates_ = integer_coordinates_of(t_.correspondence());
    }
  }

  // the format asks for this at vertices, whatever a mesh does
  void prefer_border_halfedges() {
    for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Gluing_map::Vertex v = mesh_.target({h});
      if (mesh_.face({h}).index == Gluing::none &&
          mesh_.face(mesh_.halfedge(v)).index != Gluing::none)
        mesh_.set_halfedge(v, {h});
    }
  }

  void write_report() {
    const Input_report& report = t_.report();
    const auto kind =
        std::find_if(mollification_names.begin(), mollification_names.end(),
                     [&](const auto& n) { return n.first == report.mollification.kind; });
    out_.line("IDT", intrinsic_triangulation_format_version, arithmetic_name<Metric>);
    out_.line("scale", t_.input().scale_exponent());
    out_.line("degenerate_faces", report.degenerate_faces);
    out_.line("mollification", kind->second, report.mollification.delta);
    out_.line("renumbered", report.renumbered ? 1 : 0);
    out_.line("triangulated_polygons", report.triangulated_polygons);
    out_.line("reversed_faces", report.reversed_faces);
  }

  // all that is known of an input without surface
  void write_names() {
    const Input_names& names = t_.input().names();
    out_.line("input", no_input_name);
    out_.line("input_vertices", t_.input().number_of_vertices());
    for (std::uint32_t v = 0; v < t_.input().number_of_vertices(); ++v)
      out_.line(names.vertices.user(v));
    write_list("input_edges", names.edges.users());
    write_list("input_faces", names.faces.users());
  }

  void write_input(const Input& input) {
    const Input_metric& metric = input.metric();
    const Input_names& names = t_.input().names();
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

  bool has_polygons() const { return !t_.input().planar_polygons().empty(); }

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
      const std::uint32_t e = numbers_.of_edges.old[i];
      write_value(t_.metric().squared_length(e), t_.metric().approximate_squared_length(e));
      if (coordinates_ != nullptr) {
        out_.words(coordinates_->normal_coordinate(e));
        for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
          const std::uint32_t slot = coordinates_->roundabout(h);
          write_name(slot == Gluing::none ? slot : coordinates_->fans().halfedge(slot));
        }
      }
      out_.line();
    }
  }

  void write_faces() {
    out_.line("faces", mesh_.number_of_faces());
    for (std::uint32_t i = 0; i < mesh_.number_of_faces(); ++i) {
      write_sides(mesh_, i);
      const std::uint32_t f = numbers_.of_faces.old[i];
      write_value(t_.metric().quadruple_area(f), t_.metric().approximate_quadruple_area(f));
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
    const std::uint32_t of_input = t_.input().number_of_vertices();
    out_.line("places", mesh_.number_of_vertices() - of_input);
    for (std::uint32_t i = of_input; i < mesh_.number_of_vertices(); ++i) {
      const auto v = t_.numbers().vertex_at(numbers_.of_vertices.old[i]);
      const std::uint32_t to = t_.numbers().halfedge(halfedge(v, t_.mesh()));
      const auto& [h, w] = coordinates_->location(t_.index(v));
      // no curve starts from a vertex inside a face
      if (coordinates_->roundabout(to ^ 1U) == Gluing::none)
        out_.line(in_face_name, h, w[0], w[1], w[2]);
      else
        out_.line(on_edge_name, h, w[0], w[1]);
    }
  }

  Output_buffer out_; // hexadecimal, so that nothing is rounded
  const Triangulation& t_;
  Compact_numbers<Triangulation> numbers_;
  Gluing_map mesh_; // with these numbers
  const Integer_coordinates* coordinates_ = nullptr;
};

} // namespace internal

/*!
\brief writes an intrinsic triangulation in the format of `intrinsic_triangulation_format.h`, without
loss.

Elements keep their order; those after removed ones move up to smaller numbers.
\tparam Triangulation an `Intrinsic_triangulation` with `Exact_euclidean_traits` or
  `Euclidean_traits<double>`, and any mesh
\param out the stream
\param t the triangulation
\throws std::runtime_error if the stream fails
\complexity linear in the mesh and, with exact traits, if no vertex was ever inserted, in the number of flips done
*/
template <IntrinsicTriangulation Triangulation>
void write_intrinsic_triangulation(std::ostream& out, const Triangulation& t) {
  static_assert(!internal::arithmetic_name<typename Triangulation::Metric>.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  if (!internal::Intrinsic_triangulation_writer<Triangulation>(out, t).run())
    throw std::runtime_error("the intrinsic triangulation cannot be written completely");
}

/*!
\brief writes an intrinsic triangulation to a file, ordinarily with extension `.idt`.

Whatever fails, the file is complete or what it was before: see `Replacing_file`. Otherwise see the overload with
a stream.
\param path the file
\param t the triangulation
\throws std::runtime_error naming the file if it cannot be written
*/
template <IntrinsicTriangulation Triangulation>
void write_intrinsic_triangulation(const std::filesystem::path& path, const Triangulation& t) {
  write_file(path, [&t](std::ostream& out) { write_intrinsic_triangulation(out, t); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
