// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Coordinates_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Input_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

// Returns the arithmetic.
std::string read_format_header(Text_reader& in) {
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
template <class Metric>
class Stored_triangulation_reader {
  using FT = typename Metric::FT;

public:
  Stored_triangulation_reader(Text_reader& in, bool lies_on_input)
      : in_(in), connectivity_(in), lies_on_input_(lies_on_input) {}

  Stored_triangulation<Metric> run() {
    const std::shared_ptr<const Input_definition> input = Input_reader(in_).run<Metric>();
    check_input(*input);
    if (input->surface() != nullptr)
      coordinates_.emplace(in_, std::shared_ptr<const Input>(input, input->surface()));
    read_vertices(input->number_of_vertices());
    connectivity_.start_faces("faces", read_edges());
    read_faces();
    connectivity_.read_border("border");
    std::optional<Integer_coordinates> coordinates;
    if (coordinates_) coordinates = coordinates_->run(connectivity_.mesh);
    in_.line("end", [] {});
    const int scale_exponent = input->scale_exponent();
    if (!coordinates)
      return {input, std::move(connectivity_.mesh), metric(scale_exponent), std::nullopt};
    const Numbered_mesh numbered(connectivity_.mesh);
    check_curves(in_, numbered, *coordinates);
    Metric values = metric(scale_exponent);
    if constexpr (Metric::is_exact) Value_check(in_, numbered, *coordinates).run(values);
    return {input, std::move(connectivity_.mesh), std::move(values), std::move(coordinates)};
  }

private:
  void check_input(const Input_definition& input) const {
    if (input.surface() != nullptr) return;
    if (Metric::is_exact) in_.fail("exact values need the input that defines them");
    if (lies_on_input_)
      in_.refuse("the file does not say how the triangulation lies on its input; start from the "
                 "mesh, or read it with No_correspondence");
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
  bool lies_on_input_;
  std::optional<Coordinates_reader> coordinates_; // if there is an input to lie on
  std::vector<FT> squared_lengths_, areas_;
  std::vector<double> near_lengths_, near_areas_;
};

} // namespace

std::ifstream open_triangulation(const std::filesystem::path& path) {
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

template <class Metric>
Stored_triangulation<Metric> read_stored_triangulation(std::istream& in, const std::string& name,
                                                       bool lies_on_input) {
  Text_reader text(in, name);
  const std::string stored = read_format_header(text);
  if (stored != arithmetic_name<Metric>)
    text.refuse("the triangulation is stored in " + stored +
                " arithmetic; read it with traits of that arithmetic");
  return Stored_triangulation_reader<Metric>(text, lies_on_input).run();
}
template Stored_triangulation<Exact_euclidean_metric>
read_stored_triangulation(std::istream&, const std::string&, bool);
template Stored_triangulation<Euclidean_metric<double>>
read_stored_triangulation(std::istream&, const std::string&, bool);

} // namespace internal

std::string read_intrinsic_triangulation_arithmetic(const std::filesystem::path& path) {
  std::ifstream in = internal::open_triangulation(path);
  internal::Text_reader text(in, path.string());
  return internal::read_format_header(text);
}

} // namespace CGAL::Intrinsic_triangulations
