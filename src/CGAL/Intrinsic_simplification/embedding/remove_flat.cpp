// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.h>
#include <CGAL/Intrinsic_simplification/simplification/flip_away.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The power of i with respect to the circle about j, k and m, negative inside.
double power_of_source(const Metric_diamond& d) {
  const Double_double jj = d.length * d.length, kk = d.kx * d.kx + d.ky * d.ky,
                      mm = d.mx * d.mx + d.my * d.my;
  const Double_double jk = d.length * d.ky, km = -(d.kx * d.my + d.ky * d.mx), mj = d.my * d.length;
  const double area = (jk + km + mj).to_double();
  return area > 0 ? -(jj * km + kk * mj + mm * jk).to_double() / area
                  : -std::numeric_limits<double>::infinity();
}

// The edges at a vertex, see `Flat_vertex_removal`. By rounding, faces may seem a little concave at
// the vertex where they are straight: with four edges on two lines, no diamond is strictly convex
// there.
class Metric_star {
public:
  using Halfedge = std::uint32_t;

  // The vertex becomes flat.
  Metric_star(Metric_triangles& t, std::uint32_t v)
      : t_(t), v_(v), straight_(t.flatten(v) ? 0x1p-80 : 1e-9) {}

  const std::vector<Halfedge>& find_edges() {
    edges_.clear();
    Halfedge h = t_.outgoing(v_);
    do {
      edges_.push_back(h);
      h = t_.opposite(Metric_triangles::previous(h));
    } while (h != t_.outgoing(v_));
    return edges_;
  }
  std::array<bool, 3> are_here(Halfedge h) const {
    return {t_.target(h) == v_, t_.source(Metric_triangles::previous(h)) == v_,
            t_.source(Metric_triangles::previous(t_.opposite(h))) == v_};
  }
  bool is_in_two_faces(Halfedge h) const { return t_.is_in_two_faces(h); }
  Ear_rank rank(Halfedge h) const { return {false, power_of_source(t_.unfold(h))}; }
  bool flip(Halfedge h, bool /* is_last */) {
    const Metric_diamond d = t_.unfold(h);
    const std::array<double, 2> sines = d.sines();
    const bool is_loop = t_.target(h) == v_;
    if (!(sines[1] > 0) || !(sines[0] > (is_loop ? 0 : -straight_))) return false;
    t_.flip(h, d);
    for (const Halfedge side : {h, t_.opposite(h)}) add_changed(side / 3);
    return true;
  }
  void take_out() {
    for (const Halfedge h : edges_) changed_.push_back(Metric_triangles::next(h));
    t_.remove(v_);
    add_changed(edges_.front() / 3);
  }
  // Makes the triangles Delaunay again.
  // \param equal weights, for which convex is Delaunay
  void restore(const Vertex_weights& equal) {
    std::erase_if(changed_, [this](Halfedge h) { return t_.is_removed(h / 3); });
    flip_to_convex(t_, equal, changed_);
  }

private:
  void add_changed(std::uint32_t face) {
    for (Halfedge h = 3 * face; h < 3 * face + 3; ++h) changed_.push_back(h);
  }

  Metric_triangles& t_;
  std::uint32_t v_;
  double straight_;
  std::vector<Halfedge> edges_, changed_; // changed: of faces that are new
};

// Vertices that have to go. After removals, some more of them have lost their curvature to others.
std::vector<std::uint32_t> flat_ones(const Metric_triangles& t, const std::vector<double>& within) {
  const std::vector<double> curvature = t.curvatures(); // a full turn if removed
  std::vector<std::uint32_t> result;
  for (std::uint32_t v = 0; v < t.number_of_vertices(); ++v)
    if (curvature[v] <= within[v]) result.push_back(v);
  return result;
}

// The greatest curvature of a vertex that still counts as flat. Neighbours that were made flat may
// have left it some, by the rounding of lengths. A vertex with more is a corner, and stays.
double most_curvature(double within) {
  constexpr double of_rounding = 1e-6; // see flat_curvatures()
  return std::max(within, std::clamp(8 * within, 1e-9, of_rounding));
}

} // namespace

bool remove_flat(Metric_triangles& t, const std::vector<double>& within, Embedding_run& run) {
  const Vertex_weights equal(t.number_of_vertices());
  std::vector<std::uint32_t> left = flat_ones(t, within);
  bool is_stopped = false;
  const auto remove = [&](std::uint32_t v) {
    is_stopped = is_stopped || !run.goes_on();
    if (is_stopped) return false;
    if (t.curvature(v) > most_curvature(within[v])) return true; // stays
    Metric_star star(t, v);
    const bool is_gone = Flat_vertex_removal(star).run();
    star.restore(equal);
    return is_gone;
  };
  return remove_in_rounds(left, remove, [&] {
    if (left.empty()) left = flat_ones(t, within);
  });
}

} // namespace CGAL::Intrinsic_triangulations::internal
