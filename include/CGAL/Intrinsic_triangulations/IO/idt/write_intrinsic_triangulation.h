// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Numbers some numbers anew, from 0 and in their order.
class Ranks {
public:
  // those of the elements of a range
  template <class Range, class Number>
  Ranks(const Range& range, Number number) {
    for (const auto element : range) numbers_.push_back(number(element));
    std::sort(numbers_.begin(), numbers_.end());
    if (!numbers_.empty()) rank_.resize(numbers_.back() + std::size_t{1});
    for (std::uint32_t i = 0; i < numbers_.size(); ++i) rank_[numbers_[i]] = i;
  }

  std::uint32_t rank(std::uint32_t number) const { return rank_[number]; }
  std::uint32_t number(std::uint32_t rank) const { return numbers_[rank]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(numbers_.size()); }

private:
  std::vector<std::uint32_t> rank_, numbers_;
};

// The elements of a triangulation, numbered without the gaps that removals leave. Otherwise the order
// stays: vertices of the input come first. To be used like a `Mesh_adaptor`.
template <class Triangulation>
class Compact_numbers {
  using Mesh = typename Triangulation::Mesh;

public:
  explicit Compact_numbers(const Triangulation& t)
      : t_(t), vertex_(vertices(t.mesh()), number()), edge_(edges(t.mesh()), number()),
        face_(faces(t.mesh()), number()) {}

  const Ranks& edge_ranks() const { return edge_; }
  const Ranks& face_ranks() const { return face_; }

  std::uint32_t vertex(typename Triangulation::vertex_descriptor v) const {
    return vertex_.rank(t_.index(v));
  }
  std::uint32_t halfedge(typename Triangulation::halfedge_descriptor h) const {
    const std::uint32_t i = t_.numbers().halfedge(h);
    return 2 * edge_.rank(i / 2) + i % 2;
  }
  std::uint32_t face(typename Triangulation::face_descriptor f) const {
    return face_.rank(t_.index(f));
  }

  std::uint32_t vertex_capacity(const Mesh&) const { return vertex_.count(); }
  std::uint32_t edge_capacity(const Mesh&) const { return edge_.count(); }
  std::uint32_t face_capacity(const Mesh&) const { return face_.count(); }

private:
  auto number() const {
    return [this](auto element) { return t_.index(element); };
  }

  const Triangulation& t_;
  Ranks vertex_, edge_, face_;
};

// Writes the sections of the file format in their order.
template <class Triangulation>
class Intrinsic_triangulation_writer {
  using Metric = typename Triangulation::Metric;
  using Halfedge = Gluing_map::Halfedge;

public:
  Intrinsic_triangulation_writer(std::ostream& out, const Triangulation& t)
      : out_(out), t_(t), numbers_(t), mesh_(numbered_copy(t.mesh(), numbers_)) {
    prefer_border_halfedges();
  }

  bool run() {
    write_header();
    write_vertices();
    write_edges();
    write_faces();
    write_border();
    write_input_faces();
    if constexpr (Metric::is_exact) {
      write_input(t_.input().metric());
      write_history(t_.metric().history());
      write_versions();
    }
    out_.line("end");
    return out_.flush();
  }

private:
  // the format asks for this at vertices, whatever a mesh does
  void prefer_border_halfedges() {
    for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Gluing_map::Vertex v = mesh_.target({h});
      if (mesh_.face({h}).index == Gluing::none &&
          mesh_.face(mesh_.halfedge(v)).index != Gluing::none)
        mesh_.set_halfedge(v, {h});
    }
  }

  void write_header() {
    const Input_report& report = t_.report();
    const auto kind =
        std::find_if(mollification_names.begin(), mollification_names.end(),
                     [&](const auto& n) { return n.first == report.mollification.kind; });
    out_.line("IDT", intrinsic_triangulation_format_version, arithmetic_name<Metric>);
    out_.line("scale", t_.input().scale_exponent());
    out_.line("degenerate_faces", report.degenerate_faces);
    out_.line("mollification", kind->second, report.mollification.delta);
    out_.line("renumbered", report.renumbered ? 1 : 0);
  }

  void write_vertices() {
    out_.line("vertices", mesh_.number_of_vertices());
    for (std::uint32_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      if (v < t_.input().number_of_vertices())
        out_.words(t_.input().names().vertices.user(v));
      else
        out_.words("-");
      const Halfedge h = mesh_.halfedge(Gluing_map::Vertex{v});
      if (h.index == Gluing::none)
        out_.line("-");
      else
        out_.line(h.index);
    }
  }

  void write_edges() {
    out_.line("edges", mesh_.number_of_edges());
    for (std::uint32_t i = 0; i < mesh_.number_of_edges(); ++i) {
      const std::uint32_t e = numbers_.edge_ranks().number(i);
      write_value(t_.metric().squared_length(e), t_.metric().approximate_squared_length(e));
    }
  }

  void write_faces() {
    out_.line("faces", mesh_.number_of_faces());
    for (std::uint32_t i = 0; i < mesh_.number_of_faces(); ++i) {
      const auto [a, b, c] = mesh_.sides({i});
      out_.words(a.index, b.index, c.index, mesh_.target(c).index, mesh_.target(a).index,
                 mesh_.target(b).index);
      const std::uint32_t f = numbers_.face_ranks().number(i);
      write_value(t_.metric().quadruple_area(f), t_.metric().approximate_quadruple_area(f));
    }
  }

  // an interval and a number in it, or just a number
  template <class FT>
  void write_value(const FT& x, double near) {
    if constexpr (Metric::is_exact)
      out_.line(x.inf(), x.sup(), near);
    else
      out_.line(x);
  }

  void write_border() {
    std::vector<std::uint32_t> border;
    for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h)
      if (mesh_.face({h}).index == Gluing::none) border.push_back(h);
    out_.line("border", border.size());
    for (const std::uint32_t h : border) out_.line(h, mesh_.next({h}).index);
  }

  // nothing if faces were not renumbered
  void write_input_faces() {
    const std::vector<std::uint32_t>& faces = t_.input().names().faces.users();
    out_.line("input_faces", faces.size());
    for (const std::uint32_t f : faces) out_.line(f);
  }

  void write_input(const Input_metric& input) {
    if (input.is_embedded()) {
      out_.line("points", input.points().size());
      for (const Input_metric::Point& p : input.points()) out_.line(p[0], p[1], p[2]);
    } else {
      out_.line("squared_lengths", input.squared_lengths().size());
      for (const double x : input.squared_lengths()) out_.line(x);
    }
    out_.line("delta", input.delta());
    out_.line("sides", input.number_of_faces());
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      const Input_metric::Sides& s = input.sides(f);
      out_.line(s[0], s[1], s[2]);
    }
  }

  void write_history(const Flip_history& history) {
    out_.line("moves", history.number_of_flips() + history.number_of_vertex_moves());
    for (std::uint32_t n = 0; n < history.number_of_nodes(); ++n) {
      if (history.is_flip(n)) {
        out_.words(flip_name);
        write_side(history.left_parent(n));
        write_side(history.right_parent(n));
        out_.line();
      } else if (history.vertex_move(n).node == n) // the first of its nodes
        write_vertex_move(history.vertex_move(n));
    }
  }

  void write_vertex_move(const Flip_history::Vertex_move& m) {
    const Vertex_move_name& name =
        *std::find_if(vertex_move_names.begin(), vertex_move_names.end(),
                      [&](const Vertex_move_name& n) { return n.kind == m.kind; });
    out_.words(name.name);
    for (std::size_t k = 0; k < Flip_history::number_of_parents(m.kind); ++k)
      write_side(m.parents[k]);
    for (std::size_t k = 0; k < name.weights; ++k) out_.words(m.weights[k]);
    out_.line();
  }

  void write_side(const Flip_history::Side& s) { out_.words(s.face, s.slot); }

  void write_versions() {
    out_.line("versions", mesh_.number_of_faces());
    for (std::uint32_t i = 0; i < mesh_.number_of_faces(); ++i) {
      const auto [version, edge] = t_.metric().version(numbers_.face_ranks().number(i));
      out_.line(version, numbers_.edge_ranks().rank(edge));
    }
  }

  Basic_output_buffer<true> out_; // hexadecimal, so that nothing is rounded
  const Triangulation& t_;
  Compact_numbers<Triangulation> numbers_;
  Gluing_map mesh_; // with these numbers
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
\complexity linear in the mesh and, with exact traits, in the number of moves done
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
  Replacing_file file(path);
  try {
    write_intrinsic_triangulation(file.stream(), t);
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
