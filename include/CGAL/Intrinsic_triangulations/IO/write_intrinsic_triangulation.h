// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/IO/Text_writer.h>
#include <CGAL/Intrinsic_triangulations/IO/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Writes the sections of the file format in their order.
template <class Triangulation>
class Intrinsic_triangulation_writer {
  using Metric = typename Triangulation::Metric;
  using Halfedge = Gluing_map::Halfedge;

public:
  Intrinsic_triangulation_writer(std::ostream& out, const Triangulation& t) : out_(out), t_(t) {}

  void run() {
    check();
    const As_gluing_map read(t_.mesh()); // elements have the numbers of the triangulation
    const Gluing_map& mesh = *read;
    write_header();
    write_vertices(mesh);
    write_edges(mesh);
    write_faces(mesh);
    write_border(mesh);
    if constexpr (Metric::is_exact) {
      write_input(t_.metric().input());
      write_history(t_.metric().history());
    }
    out_.line("end");
    out_.flush();
  }

private:
  // vertices of the triangulation have to be those of the input, and the history to be flips
  void check() const {
    bool only_flips = true;
    for (const auto v : vertices(t_.mesh())) only_flips = only_flips && !t_.is_inserted(v);
    if constexpr (Metric::is_exact)
      only_flips = only_flips && t_.metric().history().number_of_vertex_moves() == 0;
    std::uint32_t next_edge = 0, next_face = 0; // gaps, or another order, come from removals
    for (const auto e : edges(t_.mesh())) only_flips = only_flips && t_.index(e) == next_edge++;
    for (const auto f : faces(t_.mesh())) only_flips = only_flips && t_.index(f) == next_face++;
    if (!only_flips)
      throw Invalid_input(
          Element_kind::none, 0,
          "vertices have been inserted, which the file format of intrinsic "
          "triangulations does not hold; write it before inserting vertices, or write "
          "the common subdivision");
  }

  void write_header() {
    const Input_report& report = t_.report();
    const auto kind =
        std::find_if(mollification_names.begin(), mollification_names.end(),
                     [&](const auto& n) { return n.first == report.mollification.kind; });
    out_.line("IDT", intrinsic_triangulation_format_version, arithmetic_name<Metric>);
    out_.line("scale", t_.metric().scale_exponent());
    out_.line("degenerate_faces", report.degenerate_faces);
    out_.line("mollification", kind->second, report.mollification.delta);
    out_.line("renumbered", report.renumbered ? 1 : 0);
  }

  static std::uint32_t input_number(const std::vector<std::uint32_t>& map, std::uint32_t i) {
    return map.empty() ? i : map[i];
  }

  void write_vertices(const Gluing_map& mesh) {
    out_.line("vertices", mesh.number_of_vertices());
    for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const std::uint32_t input = input_number(t_.renumbering().input_vertex, v);
      const Halfedge h = mesh.halfedge(Gluing_map::Vertex{v});
      if (h.index == Gluing::none)
        out_.line(input, "-");
      else
        out_.line(input, h.index);
    }
  }

  void write_edges(const Gluing_map& mesh) {
    out_.line("edges", mesh.number_of_edges());
    for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
      if constexpr (Metric::is_exact)
        out_.line(t_.metric().squared_length(e), t_.metric().approximate_squared_length(e));
      else
        out_.line(t_.metric().squared_length(e));
  }

  void write_faces(const Gluing_map& mesh) {
    out_.line("faces", mesh.number_of_faces());
    for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Halfedge a = mesh.halfedge(Gluing_map::Face{f}), b = mesh.next(a), c = mesh.next(b);
      out_.words(a.index, b.index, c.index, mesh.target(c).index, mesh.target(a).index,
                 mesh.target(b).index, input_number(t_.renumbering().input_face, f));
      if constexpr (Metric::is_exact)
        out_.line(t_.metric().quadruple_area(f), t_.metric().approximate_quadruple_area(f));
      else
        out_.line(t_.metric().quadruple_area(f));
    }
  }

  void write_border(const Gluing_map& mesh) {
    std::uint32_t count = 0;
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
      count += mesh.face({h}).index == Gluing::none ? 1 : 0;
    out_.line("border", count);
    for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.face({h}).index == Gluing::none) out_.line(h, mesh.next({h}).index);
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
    out_.line("flips", history.number_of_flips());
    for (std::uint32_t n = 0; n < history.number_of_flips(); ++n) {
      const Flip_history::Side left = history.left_parent(n), right = history.right_parent(n);
      out_.line(left.version, left.slot, right.version, right.slot);
    }
    out_.line("versions", history.number_of_input_faces());
    for (std::uint32_t f = 0; f < history.number_of_input_faces(); ++f) {
      const auto [version, edge] = t_.metric().version(f);
      out_.line(version, edge);
    }
  }

  Text_writer out_;
  const Triangulation& t_;
};

} // namespace internal

/*!
\brief writes an intrinsic triangulation in the format of `intrinsic_triangulation_format.h`, without
loss.

\tparam Triangulation an `Intrinsic_triangulation` with `Exact_euclidean_traits` or
  `Euclidean_traits<double>`, and any mesh
\param out the stream
\param t the triangulation
\throws std::runtime_error if the stream fails
\throws Invalid_input if vertices have been inserted: the format holds flips only
\complexity linear in the mesh and, with exact traits, in the number of flips done
*/
template <class Triangulation>
void write_intrinsic_triangulation(std::ostream& out, const Triangulation& t) {
  static_assert(!internal::arithmetic_name<typename Triangulation::Metric>.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  internal::Intrinsic_triangulation_writer<Triangulation>(out, t).run();
  if (!out.flush())
    throw std::runtime_error("the intrinsic triangulation cannot be written completely");
}

/*!
\brief writes an intrinsic triangulation to a file, ordinarily with extension `.idt`.

Whatever fails, the file is complete or what it was before: see `Replacing_file`.
\tparam Triangulation see above
\param path the file
\param t the triangulation
\throws std::runtime_error naming the file if it cannot be written
\throws Invalid_input if vertices have been inserted; the file is what it was then
\complexity see above
*/
template <class Triangulation>
void write_intrinsic_triangulation(const std::filesystem::path& path, const Triangulation& t) {
  Replacing_file file(path);
  try {
    write_intrinsic_triangulation(file.stream(), t);
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_INTRINSIC_TRIANGULATION_H
