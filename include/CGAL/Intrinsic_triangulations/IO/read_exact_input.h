// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_EXACT_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_EXACT_INPUT_H

#include <CGAL/Intrinsic_triangulations/IO/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/metric/Input_metric.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline Input_metric read_input(Text_reader& in, const Gluing_map& mesh, int scale_exponent) {
  std::vector<Input_metric::Point> points;
  std::vector<double> squared_lengths;
  in.next_line();
  const std::string kind(in.word());
  if (kind != "points" && kind != "squared_lengths")
    in.fail("\"points\" or \"squared_lengths\" is expected, not \"" + kind + "\"");
  const bool embedded = kind == "points";
  const std::uint32_t names = embedded ? mesh.number_of_vertices() : mesh.number_of_edges();
  if (in.integer<std::uint32_t>("number of elements") != names)
    in.fail("there must be " + std::to_string(names) + " " + kind);
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
  std::vector<Input_metric::Sides> sides(read_count(in, "sides", mesh.number_of_faces()));
  if (sides.size() != mesh.number_of_faces()) in.fail("every face needs its sides");
  for (Input_metric::Sides& s : sides) {
    in.next_line();
    for (std::uint32_t& x : s) x = in.index(names, embedded ? "vertex" : "edge");
    in.finish_line();
  }
  return Input_metric(std::move(points), std::move(squared_lengths), std::move(sides), delta,
                      scale_exponent);
}

// Reads the flips and what they left. Every version is consumed by one flip, or is a face now.
class History_reader {
public:
  History_reader(Text_reader& in, const Gluing_map& mesh)
      : history(mesh.number_of_faces()), in_(in), mesh_(mesh), used_(mesh.number_of_faces(), 0) {}

  Flip_history history;
  std::vector<Exact_euclidean_metric::Version> versions;

  void run() {
    const std::uint32_t flips = read_count(in_, "flips", 1U << 29);
    for (std::uint32_t n = 0; n < flips; ++n) {
      in_.next_line();
      const Flip_history::Side left = read_side(), right = read_side();
      in_.finish_line();
      history.record_flip(left, right);
      used_.resize(used_.size() + 2, 0);
    }
    if (read_count(in_, "versions", mesh_.number_of_faces()) != mesh_.number_of_faces())
      in_.fail("every face needs its version");
    for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f) read_face(f);
  }

private:
  void read_face(std::uint32_t f) {
    in_.next_line();
    const std::uint32_t version = read_version();
    const std::uint32_t edge = in_.index(mesh_.number_of_edges(), "edge");
    in_.finish_line();
    const Gluing_map::Halfedge h = mesh_.halfedge(Gluing_map::Face{f}), n = mesh_.next(h);
    if (edge != h.index / 2 && edge != n.index / 2 && edge != mesh_.next(n).index / 2)
      in_.fail("edge " + std::to_string(edge) + " is no side of face " + std::to_string(f));
    versions.emplace_back(version, edge);
  }
  std::uint32_t read_version() {
    const std::uint32_t v = in_.index(static_cast<std::uint32_t>(used_.size()), "version");
    if (used_[v]++ != 0) in_.fail("version " + std::to_string(v) + " is used twice");
    return v;
  }
  Flip_history::Side read_side() {
    const std::uint32_t version = read_version();
    return {version, in_.index(3, "slot")};
  }

  Text_reader& in_;
  const Gluing_map& mesh_;
  std::vector<char> used_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_READ_EXACT_INPUT_H
