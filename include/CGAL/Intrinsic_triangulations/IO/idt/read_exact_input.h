// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_EXACT_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_EXACT_INPUT_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Reads the input of an exact metric, which has no more elements than there are in the mesh now.
inline Input_metric read_input_metric(Text_reader& in, const Gluing_map& mesh,
                                      std::uint32_t input_vertices, int scale_exponent) {
  std::vector<Input_metric::Point> points;
  std::vector<double> squared_lengths;
  in.next_line();
  const std::string kind(in.word());
  if (kind != "points" && kind != "squared_lengths")
    in.fail("\"points\" or \"squared_lengths\" is expected, not \"" + kind + "\"");
  const bool embedded = kind == "points";
  const auto names = in.integer<std::uint32_t>("number of elements");
  if (embedded && names != input_vertices)
    in.fail("there must be " + std::to_string(input_vertices) + " points");
  if (names > mesh.number_of_edges() && !embedded)
    in.fail("there cannot be more than " + std::to_string(mesh.number_of_edges()) +
            " squared lengths");
  in.finish_line();
  for (std::uint32_t i = 0; i < names; ++i) {
    in.next_line();
    if (embedded) {
      points.emplace_back();
      for (double& x : points.back()) x = in.real("coordinate");
    } else
      in.nonnegative(squared_lengths.emplace_back(), "squared length");
    in.finish_line();
  }
  double delta = 0;
  in.next_line();
  in.keyword("delta");
  in.nonnegative(delta, "delta");
  in.finish_line();
  const std::uint32_t faces = read_count(in, "sides", mesh.number_of_faces());
  std::vector<Input_metric::Sides> sides(faces); // not more than faces that have been read
  for (Input_metric::Sides& s : sides) {
    in.next_line();
    for (std::uint32_t& x : s) x = in.index(names, embedded ? "vertex" : "edge");
    in.finish_line();
  }
  return Input_metric(std::move(points), std::move(squared_lengths), std::move(sides), delta,
                      scale_exponent);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_EXACT_INPUT_H
