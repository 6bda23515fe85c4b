// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/read_exact_input.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

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
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

inline std::string read_format_header(Text_reader& in) {
  in.next_line();
  if (in.word() != "IDT") in.fail("this is no intrinsic triangulation: \"IDT\" is missing");
  const auto version = in.integer<int>("format version");
  if (version != intrinsic_triangulation_format_version)
    in.fail("format version " + std::to_string(version) + " is unknown, only " +
            std::to_string(intrinsic_triangulation_format_version) + " can be read");
  const std::string arithmetic(in.word());
  if (arithmetic != arithmetic_name<Exact_euclidean_metric> &&
      arithmetic != arithmetic_name<Euclidean_metric<double>>)
    in.fail("the arithmetic \"" + arithmetic + "\" is unknown");
  in.finish_line();
  return arithmetic;
}

inline Input_report read_report(Text_reader& in) {
  Input_report report;
  in.next_line();
  in.keyword("degenerate_faces");
  report.degenerate_faces = in.integer<std::size_t>("number of faces");
  in.finish_line();
  in.next_line();
  in.keyword("mollification");
  const std::string name(in.word());
  const auto kind = std::find_if(mollification_names.begin(), mollification_names.end(),
                                 [&](const auto& n) { return n.second == name; });
  if (kind == mollification_names.end()) in.fail("the mollification \"" + name + "\" is unknown");
  report.mollification.kind = kind->first;
  in.nonnegative(report.mollification.delta, "delta");
  in.finish_line();
  in.next_line();
  in.keyword("renumbered");
  report.renumbered = in.index(2, "truth value") == 1;
  in.finish_line();
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
Triangulation read_sections(Text_reader& in) {
  using Metric = typename Triangulation::Metric;
  using FT = typename Triangulation::FT;
  in.next_line();
  in.keyword("scale");
  const auto scale_exponent = in.integer<int>("exponent");
  in.finish_line();
  const Input_report report = read_report(in);
  Connectivity_reader connectivity(in);
  connectivity.read_vertices();
  std::vector<FT> squared_lengths(0), areas(0);
  std::vector<double> near_lengths(0), near_areas(0);
  const std::uint32_t edges = read_count(in, "edges", Gluing::none / 2);
  for (std::uint32_t e = 0; e < edges; ++e) {
    in.next_line();
    in.nonnegative(squared_lengths.emplace_back(), "squared length");
    if (Metric::is_exact) in.nonnegative(near_lengths.emplace_back(), "squared length");
    in.finish_line();
  }
  connectivity.start_faces(edges);
  for (std::uint32_t f = 0; f < connectivity.mesh.number_of_faces(); ++f) {
    in.next_line();
    connectivity.read_face(f);
    in.nonnegative(areas.emplace_back(), "quadruple area");
    if (Metric::is_exact) in.nonnegative(near_areas.emplace_back(), "quadruple area");
    in.finish_line();
  }
  connectivity.read_border();
  Renumbering renumbering{
      checked_permutation(in, report.renumbered, std::move(connectivity.input_vertex), "vertex"),
      checked_permutation(in, report.renumbered, std::move(connectivity.input_face), "face")};
  Metric metric;
  if constexpr (Metric::is_exact) {
    auto input =
        std::make_shared<const Input_metric>(read_input(in, connectivity.mesh, scale_exponent));
    History_reader history(in, connectivity.mesh);
    history.run();
    metric = Metric(std::move(input), std::move(history.history), std::move(history.versions),
                    std::move(squared_lengths), std::move(areas), std::move(near_lengths),
                    std::move(near_areas));
  } else
    metric = Metric(scale_exponent, std::move(squared_lengths), std::move(areas));
  in.next_line();
  in.keyword("end");
  in.finish_line();
  return Triangulation(std::move(connectivity.mesh), std::move(metric), std::move(renumbering),
                       report);
}

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

All numbers and values are those of the triangulation that was written, so that it goes on exactly as
that would have. Only how predicates were decided so far is not kept.

The file is checked as far as it takes to use it safely: counts, numbers, that the faces fit
together, that values are not negative. That stored values belong to the input is not checked.
\tparam Triangulation an `Intrinsic_triangulation` with the arithmetic of the file, and any mesh
\param in the stream
\param name name of the file, for messages
\throws Invalid_input naming the file and the line if it is truncated or malformed, is of another
  version or arithmetic
\complexity linear; memory follows the size of the file, never a count in it
*/
template <class Triangulation>
Triangulation read_intrinsic_triangulation(std::istream& in, const std::string& name) {
  constexpr std::string_view arithmetic = internal::arithmetic_name<typename Triangulation::Metric>;
  static_assert(!arithmetic.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  internal::Text_reader text(in, name);
  if (const std::string found = internal::read_format_header(text); found != arithmetic)
    throw Invalid_input(Element_kind::none, 0,
                        name + ":1: the triangulation is stored in " + found +
                            " arithmetic; read it with traits of that arithmetic");
  return internal::read_sections<Triangulation>(text);
}

/*!
\brief reads an intrinsic triangulation from a file.
\tparam Triangulation see above
\param path the file
\throws Invalid_input see above, and if the file cannot be opened
\complexity see above
*/
template <class Triangulation>
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_INTRINSIC_TRIANGULATION_H
