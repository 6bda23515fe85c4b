// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Coordinates_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Input_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the arithmetic.
inline std::string read_format_header(Text_reader& in) {
  in.next_line();
  if (in.word() != "IDT") in.fail("this is no intrinsic triangulation: \"IDT\" is missing");
  const auto version = in.integer<int>("format version");
  if (version != intrinsic_triangulation_format_version)
    in.refuse("the file has format version " + std::to_string(version) + ", only version " +
              std::to_string(intrinsic_triangulation_format_version) +
              " can be read; make the triangulation again from its mesh");
  std::string arithmetic(in.word());
  if (arithmetic != arithmetic_name<Exact_euclidean_metric> &&
      arithmetic != arithmetic_name<Euclidean_metric<double>>)
    in.fail("the arithmetic \"" + shown(arithmetic) + "\" is unknown");
  in.finish_line();
  return arithmetic;
}

// Reads the sections of the file format in their order.
template <class Triangulation>
class Intrinsic_triangulation_reader {
  using Metric = typename Triangulation::Metric;
  using FT = typename Triangulation::FT;

public:
  explicit Intrinsic_triangulation_reader(Text_reader& in) : in_(in), connectivity_(in) {}

  Triangulation run() {
    const std::shared_ptr<const Input_definition> input = Input_reader(in_).run<Metric>();
    check_input(*input);
    if (input->surface() != nullptr)
      coordinates_.emplace(in_, std::shared_ptr<const Input>(input, input->surface()));
    read_vertices(input->number_of_vertices());
    connectivity_.start_faces("faces", read_edges());
    read_faces();
    connectivity_.read_border("border");
    if (coordinates_) return on_surface(std::shared_ptr<const Input>(input, input->surface()));
    in_.line("end", [] {});
    if constexpr (Triangulation::has_correspondence)
      in_.fail("the file does not contain the input"); // check_input() has refused it
    else
      return Triangulation(std::move(connectivity_.mesh), metric(input->scale_exponent()), input);
  }

private:
  void check_input(const Input_definition& input) const {
    if (input.surface() != nullptr) return;
    if (Metric::is_exact) in_.fail("exact values need the input that defines them");
    if (Triangulation::has_correspondence)
      in_.refuse("the file does not say how the triangulation lies on its input; start from the "
                 "mesh, or read it with No_correspondence");
  }

  Triangulation on_surface(const std::shared_ptr<const Input>& input) {
    const Integer_coordinates coordinates = coordinates_->run(connectivity_.mesh);
    in_.line("end", [] {});
    const Numbered_mesh numbered(connectivity_.mesh);
    check_curves(in_, numbered, coordinates);
    Metric values = metric(input->scale_exponent());
    if constexpr (Metric::is_exact) Value_check(in_, numbered, coordinates).run(values);
    return Triangulation(std::move(connectivity_.mesh), std::move(values), input, coordinates);
  }

  void read_vertices(std::uint32_t of_input) {
    const std::uint32_t count = read_count(in_, "vertices", Gluing::none - 1);
    if (count < of_input) in_.fail("the input has more vertices");
    in_.lines(count, [this](std::uint32_t) { connectivity_.read_halfedge_of_vertex(); });
  }

  std::uint32_t read_edges() {
    const std::uint32_t edges = read_count(in_, "edges", Gluing::none / 2);
    in_.lines(edges, [this](std::uint32_t) {
      read_value("squared length", squared_lengths_, near_lengths_);
      if (coordinates_) coordinates_->read_edge();
    });
    return edges;
  }

  void read_faces() {
    in_.lines(connectivity_.mesh.number_of_faces(), [this](std::uint32_t f) {
      connectivity_.read_face(f);
      read_value("quadruple area", areas_, near_areas_);
      if constexpr (!Metric::is_exact) check_area(f);
    });
  }

  // Lengths and area are redundant; rounding leaves differences of some 1e-16 of what is below,
  // flips enlarge them a little.
  void check_area(std::uint32_t f) const {
    const auto sides = connectivity_.mesh.sides({f});
    double x = squared_lengths_[sides[0].index / 2], y = squared_lengths_[sides[1].index / 2],
           z = squared_lengths_[sides[2].index / 2];
    const double square = areas_.back() * areas_.back(),
                 difference = square - squared_quadruple_area(x, y, z);
    sort_descending(x, y, z);
    if (!(std::abs(difference) <= 0x1p-30 * x * (std::abs(z - (x - y)) + 2 * z)) ||
        (z == 0 && square > 0))
      in_.fail("the sides of face " + std::to_string(f) + " do not span its area");
  }

  // an interval and a number in it, or just a number
  void read_value(const char* what, std::vector<FT>& values, std::vector<double>& near) {
    in_.nonnegative(values.emplace_back(), what);
    if constexpr (Metric::is_exact) {
      in_.nonnegative(near.emplace_back(), what);
      if (near.back() < values.back().inf() || near.back() > values.back().sup())
        in_.fail(std::string(what) + " is not within its bounds");
    }
  }

  Metric metric(int scale_exponent) {
    if constexpr (Metric::is_exact)
      return Metric(scale_exponent,
                    Enclosed_values(std::move(squared_lengths_), std::move(areas_),
                                    std::move(near_lengths_), std::move(near_areas_)));
    else
      return Metric(scale_exponent, std::move(squared_lengths_), std::move(areas_));
  }

  Text_reader& in_;
  Connectivity_reader connectivity_;
  std::optional<Coordinates_reader> coordinates_; // if there is an input to lie on
  std::vector<FT> squared_lengths_, areas_;
  std::vector<double> near_lengths_, near_areas_;
};

inline std::ifstream open_triangulation(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream in;
  if (!std::filesystem::is_directory(path, ignored)) in.open(path, std::ios::binary);
  if (!in.is_open())
    throw Invalid_input(Element_kind::none, 0,
                        path.string() +
                            ": the file does not exist or cannot be opened; check its name and "
                            "permissions");
  return in;
}

} // namespace internal

/*!
\brief reads an intrinsic triangulation in the format of `intrinsic_triangulation_format.h`.

All values are those of the triangulation that was written, and so is the order of the elements, so that
it goes on exactly as that would have; numbers are without the gaps that removals leave. The input is that of the triangulation that was written. How predicates were decided so far is not kept.

The correspondence may be another one than that of the triangulation that was written: none, or integer coordinates or
explicit crossings, unless the file has doubles only.

The file is checked as far as it takes to use it safely: counts, numbers, that the faces fit together, that values are
not negative, that curves are the edges of the input. With exact traits each face is unfolded over the input in interval
arithmetic, and its values must not contradict the stored ones.
\tparam Triangulation an `Intrinsic_triangulation` with the arithmetic of the file, and any mesh
\param in the stream
\param name name of the file, for messages
\throws Invalid_input naming the file and the line if it is truncated or malformed, is of another
  version or of another arithmetic, or does not say how the triangulation lies on its input where a correspondence
  needs that
\complexity linear in the mesh and in the crossings of its edges with those of the input; memory follows the size of
  the file, never a count in it, but for explicit crossings
*/
template <IntrinsicTriangulation Triangulation>
Triangulation read_intrinsic_triangulation(std::istream& in, const std::string& name) {
  constexpr std::string_view arithmetic = internal::arithmetic_name<typename Triangulation::Metric>;
  static_assert(!arithmetic.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  constexpr bool is_readable =
      internal::Restorable<typename Triangulation::Correspondence, Triangulation>;
  static_assert(is_readable, "files hold integer coordinates, from which signposts are not made; "
                             "read with Integer_coordinates");
  internal::Text_reader text(in, name);
  const std::string stored = internal::read_format_header(text);
  if (stored != arithmetic)
    text.refuse("the triangulation is stored in " + stored +
                " arithmetic; read it with traits of that arithmetic");
  return internal::Intrinsic_triangulation_reader<Triangulation>(text).run();
}

/*!
\brief reads an intrinsic triangulation from a file: see the overload with a stream.
\param path the file
\throws Invalid_input also if the file cannot be opened
*/
template <IntrinsicTriangulation Triangulation>
Triangulation read_intrinsic_triangulation(const std::filesystem::path& path) {
  std::ifstream in = internal::open_triangulation(path);
  return read_intrinsic_triangulation<Triangulation>(in, path.string());
}

/*!
\brief tells in which arithmetic an intrinsic triangulation is stored: `"exact"` or `"double"`.
\param path the file
\throws Invalid_input naming the file and the line if the file cannot be opened, or is of another
  format or version
\complexity constant
*/
inline std::string read_intrinsic_triangulation_arithmetic(const std::filesystem::path& path) {
  std::ifstream in = internal::open_triangulation(path);
  internal::Text_reader text(in, path.string());
  return internal::read_format_header(text);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
