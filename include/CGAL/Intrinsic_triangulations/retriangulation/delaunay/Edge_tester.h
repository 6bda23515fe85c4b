// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_EDGE_TESTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_EDGE_TESTER_H

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Summed_weights.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/// What a test of every edge for the Delaunay property finds.
struct Tested_edges {
  std::size_t non_delaunay = 0;             ///< without constrained edges
  std::size_t cocircular = 0;               ///< ties, without constrained edges
  std::size_t constrained = 0;              ///< edges that are kept
  std::size_t constrained_non_delaunay = 0; ///< of these, the ones that are not Delaunay
  std::uint64_t probable_zero = 0;          ///< ties taken for such without proof
};

namespace internal {

// Tests every edge, and finds its cotangent weight, see `statistics_tolerance`; that of a tie is 0.
// With exact traits the test is exact. It relies on enclosures of the values that are stored, and
// on signs that were decided before; to test independently of these, see `certify_delaunay()`.
template <class Triangulation, class Constrained, class Visit>
class Edge_tester {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Const_session;

public:
  // \param sums of all faces
  // \param quality gets the weights
  // \param visit called with a halfedge of each edge, and the weight
  Edge_tester(const Triangulation& t, const Constrained& constrained,
              const Summed_weights<Triangulation>& sums, Quality& quality, const Visit& visit)
      : t_(t), constrained_(constrained), sums_(sums), quality_(quality), visit_(visit) {}

  Tested_edges operator()() {
    const std::uint64_t& zeros = t_.metric().statistics().probable_zero;
    const std::uint64_t before = zeros;
    for (const typename Triangulation::edge_descriptor e : edges(t_.mesh())) {
      add(e);
      if (size_ == block_.size()) finish();
    }
    finish();
    result_.probable_zero = zeros - before;
    return result_;
  }

private:
  struct Tested {
    Halfedge h;
    double weight = 0;
    Sign sign = POSITIVE; // of pi minus the angles opposite the edge, if it can be flipped
    bool has_faces = false, can_be_flipped = false;
  };

  void add(typename Triangulation::edge_descriptor e) {
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    const Halfedge h = halfedge(e, t_.mesh());
    const auto f = face(h, t_.mesh()), g = face(opposite(h, t_.mesh()), t_.mesh());
    Tested& x = block_[size_] = {h};
    x.has_faces = f != null && g != null;
    x.can_be_flipped = x.has_faces && f != g;
    std::optional<double> w;
    if (x.can_be_flipped) w = sums_.certain(t_.index(e), statistics_tolerance);
    w ? set_weight(x, *w) : void(open_[number_of_open_++] = size_);
    ++size_;
  }

  // Where stored values prove the weight to be accurate, they prove its sign, too, which is the
  // same: so each edge is tested once.
  static void set_weight(Tested& x, double weight) {
    x.weight = weight;
    if (x.can_be_flipped) x.sign = CGAL::sign(weight);
  }

  // What sums leave open was mostly decided by flips, and is remembered.
  void decide(const Session& session, Tested& x) const {
    if constexpr (Has_enclosures<typename Triangulation::Metric>)
      if (x.can_be_flipped)
        if (const auto w = t_.metric().stored_weight(t_.diamond(x.h), statistics_tolerance))
          return set_weight(x, *w);
    if (x.can_be_flipped) x.sign = session.delaunay_sign(x.h);
    if (x.sign != ZERO)
      x.weight = session.cotangent_weight(edge(x.h, t_.mesh()), statistics_tolerance);
  }

  // Visits and counts the edges that were added, in the default floating point environment.
  void finish() {
    if (number_of_open_ > 0) {
      const Session session(t_);
      for (std::size_t i = 0; i < number_of_open_; ++i) decide(session, block_[open_[i]]);
    }
    for (std::size_t i = 0; i < size_; ++i) {
      const Tested& x = block_[i];
      if (x.has_faces) add_weight(x.weight, quality_);
      visit_(x.h, x.weight);
      const bool is_kept = get(constrained_, edge(x.h, t_.mesh()));
      result_.constrained += std::size_t{is_kept};
      if (x.sign == NEGATIVE) ++(is_kept ? result_.constrained_non_delaunay : result_.non_delaunay);
      if (x.sign == ZERO && !is_kept) ++result_.cocircular;
    }
    size_ = number_of_open_ = 0;
  }

  const Triangulation& t_;
  const Constrained& constrained_;
  const Summed_weights<Triangulation>& sums_;
  Quality& quality_;
  const Visit& visit_;
  Tested_edges result_;
  std::array<Tested, 256> block_{};     // a change of rounding takes long
  std::array<std::size_t, 256> open_{}; // which of these sums leave open
  std::size_t size_ = 0, number_of_open_ = 0;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_EDGE_TESTER_H
