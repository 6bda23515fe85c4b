// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
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

// Flips edges away from one vertex, and removes it.
class Flat_vertex_remover {
public:
  Flat_vertex_remover(Metric_triangles& t, const Vertex_weights& equal) : t_(t), equal_(equal) {}

  // \return whether the vertex is gone; otherwise others may have to be removed first. The
  // triangles are Delaunay again.
  bool remove(std::uint32_t v) {
    changed_.clear();
    straight_ = t_.flatten(v) ? 0x1p-80 : 1e-9;
    const bool is_gone = flip_away(v) && take_out(v);
    std::erase_if(changed_, [this](std::uint32_t h) { return t_.is_removed(h / 3); });
    flip_to_convex(t_, equal_, changed_);
    return is_gone;
  }

private:
  struct Candidate {
    int gain; // number of edge ends that leave the vertex
    double power;
    std::uint32_t halfedge;
  };

  int gain(std::uint32_t h) const {
    const std::uint32_t v = t_.source(h);
    const auto is_v = [&](std::uint32_t w) { return w == v ? 1 : 0; };
    return 1 + is_v(t_.target(h)) - is_v(t_.source(Metric_triangles::previous(h))) -
           is_v(t_.source(Metric_triangles::previous(t_.opposite(h))));
  }

  // Where the faces about a vertex are Delaunay, so are ears whose circles contain it the least:
  // Devillers, "On deletion in Delaunay triangulations" (1999). Where edges from the vertex to
  // itself block all ears, a flip that takes no end away changes the faces.
  std::vector<Candidate> candidates(std::uint32_t v) {
    std::vector<Candidate> result;
    std::uint32_t h = t_.outgoing(v);
    do {
      if (const int g = gain(h); t_.is_in_two_faces(h) && g >= 0)
        result.push_back(
            {g, g > 0 ? power_of_source(t_.unfold(h)) : static_cast<double>(random_()), h});
      h = t_.opposite(Metric_triangles::previous(h));
    } while (h != t_.outgoing(v));
    std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
      return std::pair(a.gain, a.power) > std::pair(b.gain, b.power);
    });
    return result;
  }

  bool flip_one(std::uint32_t v) {
    for (const Candidate& c : candidates(v)) {
      const Metric_diamond d = t_.unfold(c.halfedge);
      const std::array<double, 2> sines = d.sines();
      const bool is_loop = t_.target(c.halfedge) == v;
      if (!(sines[1] > 0) || !(sines[0] > (is_loop ? 0 : -straight_))) continue;
      t_.flip(c.halfedge, d);
      for (const std::uint32_t side : {c.halfedge, t_.opposite(c.halfedge)})
        for (std::uint32_t k = 0; k < 3; ++k) changed_.push_back(side - side % 3 + k);
      return true;
    }
    return false;
  }

  bool flip_away(std::uint32_t v) {
    for (std::uint32_t left = 8 * t_.degree(v) + 32; t_.degree(v) > 3; --left)
      if (left == 0 || !flip_one(v)) return false;
    return true;
  }

  bool take_out(std::uint32_t v) {
    const std::uint32_t first = t_.outgoing(v);
    std::uint32_t h = first;
    do {
      if (t_.target(h) == v) return false;
      changed_.push_back(Metric_triangles::next(h));
      h = t_.opposite(Metric_triangles::previous(h));
    } while (h != first);
    if (t_.degree(v) != 3) return false;
    t_.remove(v);
    for (std::uint32_t k = 0; k < 3; ++k) changed_.push_back(first - first % 3 + k);
    return true;
  }

  Metric_triangles& t_;
  const Vertex_weights& equal_;        // weights, for which convex is Delaunay
  std::vector<std::uint32_t> changed_; // halfedges of faces that flips have made
  // Straight at the vertex is enough: with four edges on two lines, no diamond is strictly convex
  // there. The face without area that the flip makes goes with the vertex.
  double straight_ = 0;
  std::minstd_rand random_;
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
  Flat_vertex_remover remover(t, equal);
  // Loops at a vertex may go with its neighbours.
  for (bool was_blocked = false; !left.empty();) {
    std::vector<std::uint32_t> again;
    for (const std::uint32_t v : left) {
      if (!run.goes_on()) return false;
      if (t.curvature(v) <= most_curvature(within[v]) && !remover.remove(v)) again.push_back(v);
    }
    const bool is_blocked = again.size() == left.size();
    if (is_blocked && was_blocked) return false;
    was_blocked = is_blocked;
    left = again.empty() ? flat_ones(t, within) : std::move(again);
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
