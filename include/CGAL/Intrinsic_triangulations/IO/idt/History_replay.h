// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_REPLAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_REPLAY_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Repeats a history move by move, and tells which moves are impossible: exact evaluation trusts a history,
// and would divide by zero or not end where one makes no sense.
//
// Each side of each version has the name of its edge, a number; the sides that a move joins must have the
// same. Input sides from points are named by their ends: edges between the same vertices have the same
// length. Values are intervals, as wide as they get; only what is certainly wrong is an error.
class History_replay {
public:
  using FT = Interval_nt<false>;
  using Scope = Protect_FPU_rounding<true>;
  using Side = Flip_history::Side;
  using Kind = Flip_history::Vertex_move::Kind;

  // throws Invalid_input if a face violates the triangle inequality
  explicit History_replay(const Input_metric& input) {
    const Scope scope;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> between;
    const auto name = [&](const Input_metric::Sides& s, unsigned k) {
      if (!input.is_embedded()) return s[k];
      const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(s[k], s[(k + 1) % 3]);
      return between.emplace(ends, static_cast<std::uint32_t>(between.size())).first->second;
    };
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f) {
      Names names{};
      for (unsigned k = 0; k < 3; ++k) {
        names[k] = name(input.sides(f), k);
        if (names[k] >= lengths_.size()) lengths_.resize(names[k] + std::size_t{1});
        lengths_[names[k]] = input.squared_length<FT>(f, k);
      }
      add(names, Intrinsic_triangulations::quadruple_area<FT>(input, f));
    }
  }

  // the bound of the numbers of versions
  std::uint32_t number_of_versions() const { return static_cast<std::uint32_t>(names_.size()); }
  // the number of versions that no move consumed
  std::uint32_t number_of_current_versions() const { return current_; }

  // consumes a version; false if it does not exist any more
  bool consume(std::uint32_t version) {
    if (consumed_[version] != 0) return false;
    consumed_[version] = 1;
    --current_;
    return true;
  }

  std::uint32_t edge(Side s) const { return names_[s.face][s.slot]; }
  const FT& squared_length(std::uint32_t edge) const { return lengths_[edge]; }
  const FT& quadruple_area(std::uint32_t version) const { return areas_[version]; }

  // Both return what is wrong, or nothing. The versions are consumed already.
  std::string flip(Side left, Side right) {
    const Scope scope;
    const auto [ij, jk, ki] = edges(left);
    const auto [ji, im, mj] = edges(right);
    if (ij != ji) return different_edges;
    const Diamond_values<FT> d = diamond_values(face(left), face(right));
    if (d.ij.sup() <= 0) return zero_length;
    const Flipped_values<FT> n = flipped(d);
    if (n.area_f.sup() < 0 || n.area_g.sup() < 0) return "the diamond is not convex";
    if (n.km.sup() <= 0) return zero_length;
    const std::uint32_t km = new_edge(n.km);
    add({km, mj, jk}, n.area_f);
    add({km, ki, im}, n.area_g);
    return {};
  }

  std::string vertex_move(Kind kind, const std::array<Side, 3>& parents,
                          const std::array<double, 3>& weights) {
    const Scope scope;
    switch (kind) {
    case Kind::insert_in_face:
      return insert(parents[0], inserted_in_face(face(parents[0]), weights));
    case Kind::insert_in_border_edge:
      return insert_on_border(parents[0], inserted_in_border_edge(face(parents[0]), weights[1]));
    case Kind::remove_from_face:
      return remove(parents);
    case Kind::remove_from_border_edge:
      break;
    }
    return remove_from_border(parents[0], parents[1]);
  }

private:
  using Names = std::array<std::uint32_t, 3>;

  static constexpr const char* different_edges = "the move joins different edges";
  static constexpr const char* zero_length = "an edge has length zero";

  std::string insert(Side side, const Vertex_move_values<FT>& values) {
    const Names ijk = edges(side);
    if (has_zero_length(ijk) || !are_lengths(values, 3)) return zero_length;
    Names spokes{};
    for (std::size_t k = 0; k < 3; ++k) spokes[k] = new_edge(values.squared_lengths[k]);
    for (std::size_t k = 0; k < 3; ++k)
      add({ijk[k], spokes[(k + 1) % 3], spokes[k]}, values.quadruple_areas[k]);
    add_unused();
    return {};
  }

  std::string insert_on_border(Side side, const Vertex_move_values<FT>& values) {
    const auto [ij, jk, ki] = edges(side);
    if (has_zero_length({ij, jk, ki}) || !are_lengths(values, 3)) return zero_length;
    const std::uint32_t ip = new_edge(values.squared_lengths[0]);
    const std::uint32_t pj = new_edge(values.squared_lengths[1]);
    const std::uint32_t pk = new_edge(values.squared_lengths[2]);
    add({ip, pk, ki}, values.quadruple_areas[0]);
    add({pj, jk, pk}, values.quadruple_areas[1]);
    return {};
  }

  std::string remove(const std::array<Side, 3>& parents) {
    Names outer{};
    std::array<FT, 3> areas;
    for (std::size_t k = 0; k < 3; ++k) {
      outer[k] = edge(parents[k]);
      areas[k] = areas_[parents[k].face];
      if (edges(parents[k])[1] != edges(parents[(k + 1) % 3])[2]) return different_edges;
    }
    add(outer, removed_from_face(areas[0], areas[1], areas[2]).quadruple_areas[0]);
    add_unused();
    return {};
  }

  std::string remove_from_border(Side left, Side right) {
    const auto [pk, ki, ip] = edges(left);
    const auto [kp, pj, jk] = edges(right);
    if (pk != kp) return different_edges;
    if (has_zero_length({pk, pk, pk})) return zero_length;
    const auto values = removed_from_border_edge(diamond_values(face(left), face(right)));
    if (!are_lengths(values, 1)) return zero_length;
    add({new_edge(values.squared_lengths[0]), jk, ki}, values.quadruple_areas[0]);
    add_unused();
    return {};
  }

  bool has_zero_length(const Names& edges) const {
    return std::any_of(edges.begin(), edges.end(),
                       [this](std::uint32_t e) { return lengths_[e].sup() <= 0; });
  }
  static bool are_lengths(const Vertex_move_values<FT>& values, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      if (values.squared_lengths[k].sup() <= 0) return false;
    return true;
  }

  Names edges(Side s) const {
    const Names& n = names_[s.face];
    return {n[s.slot], n[(s.slot + 1) % 3], n[(s.slot + 2) % 3]};
  }
  Face_values<FT> face(Side s) const {
    const auto [ij, jk, ki] = edges(s);
    return {{lengths_[ij], lengths_[jk], lengths_[ki]}, areas_[s.face]};
  }

  static FT positive_part(const FT& x) { return {std::max(x.inf(), 0.0), x.sup()}; }
  std::uint32_t new_edge(const FT& squared_length) {
    lengths_.push_back(positive_part(squared_length));
    return static_cast<std::uint32_t>(lengths_.size() - 1);
  }
  void add(const Names& names, const FT& area) {
    names_.push_back(names);
    areas_.push_back(positive_part(area));
    consumed_.push_back(0);
    ++current_;
  }
  // insertions in faces, and removals, take one number more than they make versions
  void add_unused() {
    add({}, FT(0));
    consume(number_of_versions() - 1);
  }

  std::vector<Names> names_; // of each version
  std::vector<FT> areas_;
  std::vector<char> consumed_;
  std::vector<FT> lengths_; // of each edge
  std::uint32_t current_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_HISTORY_REPLAY_H
