// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/History_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

struct Format_header {
  int version;
  std::string arithmetic;
};

inline Format_header read_format_header(Text_reader& in) {
  in.next_line();
  if (in.word() != "IDT") in.fail("this is no intrinsic triangulation: \"IDT\" is missing");
  const auto version = in.integer<int>("format version");
  if (version < 1 || version > intrinsic_triangulation_format_version)
    in.fail("format version " + std::to_string(version) + " is unknown, only versions up to " +
            std::to_string(intrinsic_triangulation_format_version) + " can be read");
  std::string arithmetic(in.word());
  if (arithmetic != arithmetic_name<Exact_euclidean_metric> &&
      arithmetic != arithmetic_name<Euclidean_metric<double>>)
    in.fail("the arithmetic \"" + arithmetic + "\" is unknown");
  in.finish_line();
  return {version, std::move(arithmetic)};
}

inline Input_report read_report(Text_reader& in) {
  Input_report report;
  in.line("degenerate_faces",
          [&] { report.degenerate_faces = in.integer<std::size_t>("number of faces"); });
  in.line("mollification", [&] {
    const std::string name(in.word());
    const auto kind = std::find_if(mollification_names.begin(), mollification_names.end(),
                                   [&](const auto& n) { return n.second == name; });
    if (kind == mollification_names.end()) in.fail("the mollification \"" + name + "\" is unknown");
    report.mollification.kind = kind->first;
    in.nonnegative(report.mollification.delta, "delta");
  });
  in.line("renumbered", [&] { report.renumbered = in.index(2, "truth value") == 1; });
  return report;
}

// Checks that the numbers in the input are a permutation, the identity unless renumbered; returns
// the map, which is empty for the identity.
inline std::vector<std::uint32_t> checked_permutation(Text_reader& in, bool renumbered,
                                                      std::vector<std::uint32_t> numbers,
                                                      const std::string& name) {
  std::vector<char> seen(numbers.size(), 0);
  for (std::uint32_t i = 0; i < numbers.size(); ++i)
    if (seen[numbers[i]]++ != 0 || (!renumbered && numbers[i] != i))
      in.fail("input " + name + " " + std::to_string(numbers[i]) + " is not where it belongs");
  return renumbered ? std::move(numbers) : std::vector<std::uint32_t>();
}

// Reads the sections of the file format in their order.
template <class Triangulation>
class Intrinsic_triangulation_reader {
  using Metric = typename Triangulation::Metric;
  using FT = typename Triangulation::FT;

public:
  Intrinsic_triangulation_reader(Text_reader& in, int format_version)
      : in_(in), format_version_(format_version), connectivity_(in, format_version) {}

  Triangulation run() {
    int scale_exponent = 0;
    in_.line("scale", [&] {
      scale_exponent = in_.integer<int>("exponent");
      if (scale_exponent < -maximal_exponent || scale_exponent > maximal_exponent)
        in_.fail("the exponent is out of range");
    });
    const Input_report report = read_report(in_);
    connectivity_.read_vertices();
    check_correspondence();
    connectivity_.start_faces(read_edges());
    read_faces();
    connectivity_.read_border();
    connectivity_.read_input_faces(report.renumbered);
    const std::shared_ptr<Input> input = read_input(report, scale_exponent);
    Metric metric = read_metric(input);
    in_.line("end", [] {});
    if constexpr (has_correspondence) input->keep_values(metric);
    return Triangulation(std::move(connectivity_.mesh), std::move(metric), input);
  }

private:
  static constexpr bool has_correspondence =
      !std::is_same_v<typename Triangulation::Correspondence, No_correspondence>;

  // a correspondence would take inserted vertices for those of its input
  void check_correspondence() const {
    if constexpr (has_correspondence)
      if (connectivity_.input_vertex.size() < connectivity_.number_of_vertices())
        in_.refuse("vertices were inserted, and where they are on the input is not stored; read "
                   "the triangulation with No_correspondence");
  }

  std::uint32_t read_edges() {
    const std::uint32_t edges = read_count(in_, "edges", Gluing::none / 2);
    in_.lines(edges, [this](std::uint32_t) {
      read_value("squared length", squared_lengths_, near_lengths_);
    });
    return edges;
  }

  void read_faces() {
    in_.lines(connectivity_.mesh.number_of_faces(), [this](std::uint32_t f) {
      connectivity_.read_face(f);
      read_value("quadruple area", areas_, near_areas_);
    });
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

  Input_names read_names(bool renumbered) {
    if (renumbered) check_number_of_input_faces();
    Input_names names;
    names.vertices = Element_names(
        checked_permutation(in_, renumbered, std::move(connectivity_.input_vertex), "vertex"));
    names.faces = Element_names(
        checked_permutation(in_, renumbered, std::move(connectivity_.input_face), "face"));
    if (renumbered) // which the file does not hold
      names.edges = Element_names(
          std::vector<std::uint32_t>(connectivity_.mesh.number_of_edges(), Gluing::none));
    return names;
  }

  // The triangulation is its own input. Where vertices were inserted, what is known of it are its vertices.
  std::shared_ptr<Input> read_input(const Input_report& report, int scale_exponent) {
    const auto vertices = static_cast<std::uint32_t>(connectivity_.input_vertex.size());
    const Gluing_map& mesh = connectivity_.mesh;
    Input_names names = read_names(report.renumbered);
    Input_metric metric({}, {}, {}, 0, scale_exponent);
    if constexpr (Metric::is_exact) metric = read_input_metric(in_, mesh, vertices, scale_exponent);
    auto input = std::make_shared<Input>(
        vertices == mesh.number_of_vertices() ? mesh : Gluing_map(vertices, 0, 0),
        std::move(metric), std::move(names));
    input->set_report(report);
    return input;
  }

  // an inserted vertex makes two faces more, on the border one
  void check_number_of_input_faces() const {
    const std::size_t inserted =
        connectivity_.number_of_vertices() - connectivity_.input_vertex.size();
    const std::size_t more = connectivity_.mesh.number_of_faces() - connectivity_.input_face.size();
    if (more < inserted || more > 2 * inserted)
      in_.fail("so many inserted vertices do not fit the numbers of faces before and after");
  }

  Metric read_metric(const std::shared_ptr<const Input>& input) {
    if constexpr (Metric::is_exact) {
      History_reader history(in_, connectivity_.mesh, input->metric());
      history.read_moves(format_version_);
      history.read_versions(connectivity_.mesh.number_of_vertices() - input->number_of_vertices(),
                            squared_lengths_, areas_);
      return Metric(input, std::move(history.history), std::move(history.versions),
                    std::move(squared_lengths_), std::move(areas_), std::move(near_lengths_),
                    std::move(near_areas_));
    } else
      return Metric(input->scale_exponent(), std::move(squared_lengths_), std::move(areas_));
  }

  static constexpr int maximal_exponent = 2200; // beyond that of the quotient of any two doubles

  Text_reader& in_;
  int format_version_;
  Connectivity_reader connectivity_;
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
it goes on exactly as that would have; numbers are without the gaps that removals leave. How predicates
were decided so far is not kept, nor is a correspondence.

The file is checked as far as it takes to use it safely: counts, numbers, that the faces fit
together, that values are not negative. With exact traits the moves are repeated from the input in
interval arithmetic, and must lead to the faces and their values.
\tparam Triangulation an `Intrinsic_triangulation` with the arithmetic of the file, and any mesh; without
  correspondence if vertices were inserted
\param in the stream
\param name name of the file, for messages
\throws Invalid_input naming the file and the line if it is truncated or malformed, is of a later
  version or of another arithmetic
\complexity linear; memory follows the size of the file, never a count in it
*/
template <IntrinsicTriangulation Triangulation>
Triangulation read_intrinsic_triangulation(std::istream& in, const std::string& name) {
  constexpr std::string_view arithmetic = internal::arithmetic_name<typename Triangulation::Metric>;
  static_assert(!arithmetic.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  internal::Text_reader text(in, name);
  const internal::Format_header header = internal::read_format_header(text);
  if (header.arithmetic != arithmetic)
    text.refuse("the triangulation is stored in " + header.arithmetic +
                " arithmetic; read it with traits of that arithmetic");
  return internal::Intrinsic_triangulation_reader<Triangulation>(text, header.version).run();
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
  return internal::read_format_header(text).arithmetic;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
