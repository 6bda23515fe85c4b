// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_READER_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/History_replay.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
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
  in.lines(names, [&](std::uint32_t) {
    if (embedded)
      for (double& x : points.emplace_back()) x = in.real("coordinate");
    else
      in.nonnegative(squared_lengths.emplace_back(), "squared length");
  });
  double delta = 0;
  in.line("delta", [&] { in.nonnegative(delta, "delta"); });
  const std::uint32_t faces = read_count(in, "sides", mesh.number_of_faces());
  std::vector<Input_metric::Sides> sides(faces); // not more than faces that have been read
  in.lines(faces, [&](std::uint32_t f) {
    for (std::uint32_t& x : sides[f]) x = in.index(names, embedded ? "vertex" : "edge");
  });
  return Input_metric(std::move(points), std::move(squared_lengths), std::move(sides), delta,
                      scale_exponent);
}

// Reads the moves and what they left, and checks that they can have led from the input to the mesh with its
// values. Every version is consumed by one move, or is a face now.
class History_reader {
  using FT = Interval_nt<false>;
  using Side = Flip_history::Side;

public:
  History_reader(Text_reader& in, const Gluing_map& mesh, const Input_metric& input)
      : history(input.number_of_faces()), in_(in), mesh_(mesh), replay_(start(in, input)),
        edge_(mesh.number_of_edges(), Gluing::none) {}

  Flip_history history;
  std::vector<Exact_euclidean_metric::Version> versions;

  void read_moves(int format_version) {
    const bool only_flips = format_version == 1;
    const std::uint32_t moves = read_count(in_, only_flips ? "flips" : "moves", 1U << 29);
    in_.lines(moves, [&](std::uint32_t) { only_flips ? read_flip() : read_move(in_.word()); });
  }

  // `inserted` is the number of vertices that are not of the input
  void read_versions(std::uint32_t inserted, const std::vector<FT>& squared_lengths,
                     const std::vector<FT>& areas) {
    const std::uint32_t faces = mesh_.number_of_faces();
    if (inserted_ != std::int64_t{inserted})
      in_.fail("the moves leave " + std::to_string(inserted_) +
               " inserted vertices, but there are " + std::to_string(inserted));
    if (read_count(in_, "versions", faces) != faces) in_.fail("every face needs its version");
    if (replay_.number_of_current_versions() != faces)
      in_.fail("the moves leave " + std::to_string(replay_.number_of_current_versions()) +
               " faces, but there are " + std::to_string(faces));
    in_.lines(faces, [&](std::uint32_t f) { read_version_of_face(f, squared_lengths, areas[f]); });
  }

private:
  static History_replay start(const Text_reader& in, const Input_metric& input) {
    try {
      return History_replay(input);
    } catch (const Invalid_input& e) {
      in.fail(e.what());
    }
  }

  void read_flip() {
    const Side left = read_side(), right = read_side();
    in_.finish_line();
    check(replay_.flip(left, right));
    history.record_flip(left, right);
  }

  void read_move(std::string_view word) {
    if (word == flip_name) {
      read_flip();
      return;
    }
    const auto name = std::find_if(vertex_move_names.begin(), vertex_move_names.end(),
                                   [&](const Vertex_move_name& n) { return n.name == word; });
    if (name == vertex_move_names.end())
      in_.fail("the move \"" + std::string(word.substr(0, 40)) + "\" is unknown");
    std::array<Side, 3> parents{};
    for (std::size_t k = 0; k < Flip_history::number_of_parents(name->kind); ++k)
      parents[k] = read_side();
    std::array<double, 3> weights{};
    for (std::size_t k = 0; k < name->weights; ++k) in_.nonnegative(weights[k], "weight");
    in_.finish_line();
    if (name->weights > 0 && representable_weights(weights) != weights)
      in_.fail("the weights are no multiples of 2^-52 that sum to 1, or all but one vanish");
    check(replay_.vertex_move(name->kind, parents, weights));
    history.record_vertex_move(name->kind, parents, weights);
    inserted_ += name->weights > 0 ? 1 : -1;
  }

  void check(const std::string& error) const {
    if (!error.empty()) in_.fail("the move is impossible: " + error);
  }

  void read_version_of_face(std::uint32_t f, const std::vector<FT>& squared_lengths,
                            const FT& area) {
    const std::uint32_t version = read_version();
    const std::uint32_t edge = in_.index(mesh_.number_of_edges(), "edge");
    in_.finish_line();
    Gluing_map::Halfedge h = mesh_.halfedge(Gluing_map::Face{f});
    for (int k = 0; k < 2 && h.index / 2 != edge; ++k) h = mesh_.next(h);
    const Gluing_map::Halfedge n = mesh_.next(h), l = mesh_.next(n);
    if (edge != h.index / 2 || edge == n.index / 2 || edge == l.index / 2)
      in_.fail("edge " + std::to_string(edge) + " is not one side of face " + std::to_string(f));
    check_edge({version, 0}, edge, squared_lengths);
    check_edge({version, 1}, n.index / 2, squared_lengths);
    check_edge({version, 2}, l.index / 2, squared_lengths);
    if (!do_overlap(area, replay_.quadruple_area(version)))
      in_.fail("the area of face " + std::to_string(f) + " is not what the moves make");
    versions.emplace_back(version, edge);
  }

  // checks that an edge is the same, and has the same length, in all its faces
  void check_edge(Side side, std::uint32_t edge, const std::vector<FT>& squared_lengths) {
    const std::uint32_t name = replay_.edge(side);
    if (edge_[edge] == Gluing::none) edge_[edge] = name;
    if (edge_[edge] != name)
      in_.fail("edge " + std::to_string(edge) + " is not what the moves make");
    if (!do_overlap(squared_lengths[edge], replay_.squared_length(name)))
      in_.fail("the squared length of edge " + std::to_string(edge) +
               " is not what the moves make");
  }

  // both contain the exact value; true if bounds are not numbers
  static bool do_overlap(const FT& a, const FT& b) {
    return !(a.sup() < b.inf()) && !(b.sup() < a.inf());
  }

  std::uint32_t read_version() {
    const std::uint32_t v = in_.index(replay_.number_of_versions(), "version");
    if (!replay_.consume(v)) in_.fail("version " + std::to_string(v) + " is used twice");
    return v;
  }
  Side read_side() {
    const std::uint32_t version = read_version();
    return {version, in_.index(3, "slot")};
  }

  Text_reader& in_;
  const Gluing_map& mesh_;
  History_replay replay_;
  std::int64_t inserted_ = 0;
  std::vector<std::uint32_t> edge_; // what the history calls each edge of the mesh
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_READER_H
