// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Kept_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace CGAL::Intrinsic_triangulations::internal {

void Kept_crossings::keep_always(std::size_t number_of_edges) {
  lists_ = Crossing_lists(number_of_edges);
  size_ = 0;
  are_kept_ = is_decided_ = true;
}

void Kept_crossings::keep_always(const Vertex_fans& fans, const Edge_crossings& all) {
  keep(fans, all);
  is_decided_ = true;
}

void Kept_crossings::forget_beyond(std::size_t edges, Normal_coordinate more) {
  if (size_ + static_cast<std::size_t>(more) > 2 * most(edges)) forget();
}

void Kept_crossings::forget() {
  if (is_decided_) return;
  lists_ = {};
  size_ = 0;
  are_kept_ = false;
}

void Kept_crossings::announce(const Vertex_fans& fans, const Flip& move,
                              const Corner_coordinates& f, const Corner_coordinates& g,
                              Normal_coordinate n_ki, Normal_coordinate n_im, std::uint32_t along) {
  // Curves that cross km have one end on the path k, i, m around the quad, without k and m, and the
  // other on the path k, j, m. Seen from ki and im, all do but those arcs about i, counted from i
  // along ij, that are arcs about i on the other side too, or end there at the opposite corner:
  // they are last on ki and first on im. Between ki and im the curves from i cross: to jk, along
  // ij, to mj.
  announced_[0].clear();
  // so that to take it back allocates no memory: then there are as many runs
  announced_[0].reserve(lists_[move.ij / 2].size());
  const Appender append{*this, fans, announced_[0]};
  append(move.ki, 0, n_ki - std::min(f.cutting[0], g.cutting[1] + g.emanating[2]));
  append(move.jk ^ 1U, f.cutting[2], f.cutting[2] + f.emanating[0]);
  if (along != Gluing::none) append_run(fans, announced_[0], {along, 1});
  append(move.mj ^ 1U, g.cutting[0], g.cutting[0] + g.emanating[1]);
  append(move.im, std::min(g.cutting[1], f.cutting[0] + f.emanating[2]), n_im);
}

void Kept_crossings::store(const Vertex_fans& fans, const Flip& move, Normal_coordinate n) {
  store(fans, move.km, n, announced_[0]);
}

void Kept_crossings::announce(const Vertex_fans& fans, const std::array<std::uint32_t, 3>& sides,
                              const Normals& normals, const Face_region& region) {
  const Corner_coordinates c = corner_coordinates(normals);
  for (unsigned k = 0; k < 3; ++k) {
    announced_[k].clear();
    find_crossings_of_spoke(k, sides, normals, c, region, Appender{*this, fans, announced_[k]});
  }
}

void Kept_crossings::keep(const Vertex_fans& fans, const Edge_crossings& all) {
  lists_ = Crossing_lists(all.begin.size() - 1);
  size_ = 0;
  Runs runs;
  for (std::uint32_t e = 0; e + 1 < all.begin.size(); ++e) {
    runs.clear();
    for (const std::uint32_t x : all.entered_on(e)) append_run(fans, runs, {x, 1});
    lists_.assign(e, runs);
    size_ += runs.size();
  }
  are_kept_ = true;
}

void Kept_crossings::store(const Vertex_fans& fans, std::uint32_t h,
                           [[maybe_unused]] Normal_coordinate n, Runs& list) {
  CGAL_assertion(std::accumulate(list.begin(), list.end(), std::size_t{0},
                                 [](std::size_t sum, const Crossing_run& r) {
                                   return sum + r.count();
                                 }) == static_cast<std::size_t>(crossings(n))); // Eq. 13
  if (h % 2 != 0) {
    std::reverse(list.begin(), list.end());
    for (Crossing_run& r : list) r = r.reversed(fans);
  }
  size_ += list.size();
  size_ -= lists_[h / 2].size();
  lists_.assign(h / 2, list);
}

} // namespace CGAL::Intrinsic_triangulations::internal
