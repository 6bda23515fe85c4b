// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SHORTENING_CURVE_SHORTENER_H
#define CGAL_INTRINSIC_GEODESICS_SHORTENING_CURVE_SHORTENER_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// when to stop
struct Shortening_limits {
  std::uint64_t flips = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t shortenings = std::numeric_limits<std::uint64_t>::max();
  double length = -HUGE_VAL; // of all curves, in scaled units
  double rank = HUGE_VAL;    // of the angles of joints, see `Angle_sum`
};

// Makes curves geodesic (§5.1 of the course, Algorithms 6 and 7), the joint with the smallest angle
// first.
//
// The traits decide whether the angle of a free side of a joint is below pi, and whether an edge in
// it can be flipped; doubles only choose the order. Every step makes the curves shorter, and there
// are finitely many geodesic edges below any length (Indermitte et al. 2001), so that exact traits
// end without a cap.
//
// Joint a, b, c of two segments: edges between them are flipped away from b until none has an angle
// below pi at its other end. The rest about b is convex, inside the triangle a b c: shorter than
// the two segments (Sharp and Crane 2020, Theorem 4.1). An edge with one face f on both sides
// cannot be flipped: it leads to a vertex n of degree one, f = b n b, and the third side of f is a
// loop at b around it, both ends of which are in the wedge (or it carries the curve, and the joint
// is not flexible). The angles of f at b are below pi / 2; at the face beyond the loop they sum to
// less than pi, so that one end of the loop has an angle below pi: the loop is flipped before, and
// n gets a second edge.
//
// A loop of one edge at vertex b with an angle below pi is replaced at once by a closed curve
// beyond the faces at b, never by the other two sides of its triangle, which are longer. Its wedge
// is an annulus: the face f = b b n of the loop, and faces b n_i n_(i+1), i from 1 to k, n_1 = n_k
// = n; beyond it is the closed curve C through all n_i.
// - Edges from b to n_2 ... n_(k-1) are flipped away as above, which takes vertices out of C, until
//   these have angles of pi at least.
// - If n has an angle below pi, the edge b n_1 is flipped, which makes n_2 the apex of f and leaves
//   C as it is; then b n_1, at the other end of the wedge, can be flipped away. With k = 2 this
//   does not happen: the angles at b and n sum to 2 pi.
// - When all n_i have pi at least, C is a geodesic of the annulus, which is flat: the shortest of
//   all closed curves in it that wind about once, and the loop, which has a smaller angle, is
//   longer.
// If the wedge is f = b n b alone, the loop contracts to n.
template <class Triangulation>
class Curve_shortener {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;
  using Network = Curve_network<Triangulation>;
  using Side = Joint_side<Triangulation>;
  static constexpr std::uint32_t none = Curve_segments::none;
  static constexpr double rank_beyond_pi = 2.001; // by a milliradian; it only orders sides

public:
  Curve_shortener(Network& network, Session& session, Flip_log<Triangulation>* log)
      : network_(network), t_(network.triangulation()), segments_(network.segments_),
        session_(session), flip_wedge_(t_, session, log) {}

  Shortening_result run(const Shortening_limits& limits,
                        const std::function<bool(const Shortening_result&)>& go_on) {
    for (std::uint32_t c = 0; c < network_.number_of_curves(); ++c)
      network_.for_each_segment(c, [this](std::uint32_t s) {
        length_ += length(network_.halfedge_of(s));
        push(s);
      });
    limits_ = &limits;
    const Proof_watch watch([&] { return go_on(result_); });
    while (!queue_.empty() && result_.status == Status::done) {
      const Joint joint = queue_.top();
      if (joint.rank >= limits.rank || length_ <= limits.length) {
        result_.status = Status::stopped;
        break;
      }
      queue_.pop();
      if (is_alive(joint)) straighten(joint);
      if ((watch.is_stopped() || (++steps_ & 0x3ffU) == 0) &&
          !session_.suspended([&] { return go_on(result_); }))
        result_.status = Status::cancelled;
    }
    return result_;
  }

private:
  // between a segment and the next one
  struct Joint {
    double rank; // of its smaller angle
    std::uint32_t segment, generation, next, next_generation;
    bool is_right_first;
    bool operator<(const Joint& other) const { return rank > other.rank; }
  };

  bool is_alive(const Joint& j) const {
    return segments_[j.segment].generation == j.generation && segments_[j.segment].next == j.next &&
           segments_[j.next].generation == j.next_generation;
  }

  double length(Halfedge h) const {
    return std::sqrt(t_.metric().approximate_squared_length(t_.numbers().halfedge(h) / 2));
  }

  // the joint after a segment, if it may be moved
  void push(std::uint32_t s) {
    const std::uint32_t next = segments_[s].next;
    if (next == none || network_.is_fixed(target(network_.halfedge_of(s), t_.mesh()))) return;
    std::array<double, 2> rank{HUGE_VAL, HUGE_VAL}; // on the left and on the right
    for (const bool is_left : {true, false}) {
      Angle_sum sum;
      if (Side(t_, segments_, s, is_left).find_free_wedge(t_, segments_, sum))
        rank[is_left ? 0 : 1] = sum.rank();
    }
    const auto [left, right] = rank;
    if (std::min(left, right) < HUGE_VAL)
      queue_.push({std::min(left, right), s, segments_[s].generation, next,
                   segments_[next].generation, right < left && left > rank_beyond_pi});
  }

  // joints at a vertex where other curves are, which may have become free
  void push_joints_at(Halfedge in) {
    const auto& number = t_.numbers();
    Halfedge h = in;
    do {
      const std::uint32_t i = number.halfedge(h);
      for (std::uint32_t s = segments_.outermost(i); s != none; s = segments_.beside(s, i ^ 1U))
        if (segments_[s].halfedge == i)
          push(s);
        else if (segments_[s].previous != none)
          push(segments_[s].previous);
      h = opposite(next(h, t_.mesh()), t_.mesh());
    } while (h != in);
  }

  // the side that is below pi first, if only one seems to be
  void straighten(const Joint& joint) {
    for (const bool is_left : {!joint.is_right_first, joint.is_right_first}) {
      const Side side(t_, segments_, joint.segment, is_left);
      Wedge wedge;
      if (!side.find_free_wedge(t_, segments_, wedge)) continue;
      if (!reduce(side, wedge)) return;
      ++result_.wedge_checks;
      const Comparison_result c =
          side.is_turn(t_, segments_) ? SMALLER : compare_to_pi(session_, side.in, side.out, wedge);
      if (c == EQUAL) ++result_.exact_ties;
      if (c != SMALLER) continue;
      if (wedge.has_flat_face && gains_nothing()) {
        result_.status = Status::stalled;
        return;
      }
      if (side.first == side.second)
        shorten_loop(side);
      else
        shorten(side);
      return;
    }
  }

  // Faces without area may leave an angle of zero that no flip opens. Such steps gain no length and
  // may repeat forever: they end after many steps without a gain beyond 9,000 roundings.
  bool gains_nothing() {
    if (length_ < least_length_ * (1 - 1e-12)) {
      least_length_ = length_;
      idle_steps_ = 0;
    }
    return ++idle_steps_ > most_idle_steps;
  }
  static constexpr std::uint64_t most_idle_steps = 10000; // each gains 1e-16 on average: rounding

  // Where the angle of a wedge is nearly pi, edges in it are flipped away before the comparison:
  // that leaves two corners, whose sum is far cheaper to decide than that of many. (If it leaves
  // more, the angle is below pi: the polygon of b, a, c and the far ends of k - 1 edges has k + 2
  // corners, which sum to k pi; those of the edges have pi at least, so that b has less.) One flip
  // per corner: where b has loops, flips at an angle of pi need not end. False if the cap is
  // reached.
  bool reduce(const Side& side, Wedge& wedge) {
    if (wedge.faces.size() <= 2 || !wedge.sum().is_nearly_pi()) return true;
    if (!flip_out(side.in, side.out, wedge.faces.size() - 2)) return false;
    wedge = {};
    return side.find_free_wedge(t_, segments_, wedge);
  }

  // Flips edges in the wedge from h to g, on the left of h, away from its vertex, `most` at most.
  // False if the cap is reached.
  bool flip_out(Halfedge h, Halfedge g,
                std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
    const std::uint64_t left = limits_->flips - result_.flips;
    const bool is_done = flip_wedge_(opposite(h, t_.mesh()), g, true, std::min(left, most), result_,
                                     [](Halfedge) {});
    if (is_done || most < left) return true;
    result_.status = Status::cap;
    return false;
  }

  // the sides opposite the vertex in the wedge from h to g, from the source of h to the target of g
  std::vector<Halfedge> arc(Halfedge h, Halfedge g) const {
    std::vector<Halfedge> result;
    for (Halfedge x = h;; x = opposite(x, t_.mesh())) {
      const Halfedge out = next(x, t_.mesh());
      result.push_back(opposite(next(out, t_.mesh()), t_.mesh()));
      if (out == g) return result;
      x = out;
    }
  }

  void shorten(const Side& side) {
    const bool is_turn = side.is_turn(t_, segments_);
    if (!is_turn && !flip_out(side.in, side.out)) return;
    const std::vector<Halfedge> way = is_turn ? std::vector<Halfedge>() : arc(side.in, side.out);
    if (is_turn || is_shorter(way, length(side.in) + length(side.out))) replace(side, way);
  }
  // With inexact traits an angle near pi may be below it on both sides of a joint, and flips that
  // open it may be refused: the joint is straight up to rounding if nothing is gained there.
  bool is_shorter(const std::vector<Halfedge>& way, double before) const {
    if (Triangulation::Metric::is_exact) return true;
    double after = 0;
    for (const Halfedge h : way) after += length(h);
    return after < before;
  }

  void shorten_loop(const Side& side) {
    const auto& mesh = t_.mesh();
    while (true) {
      const Halfedge first = next(side.in, mesh), last = opposite(next(first, mesh), mesh);
      if (first == last) {
        network_.curves_[segments_[side.first].curve].start = target(first, mesh);
        replace(side, {});
        return;
      }
      if (!flip_out(opposite(first, mesh), last)) return;
      const std::vector<Halfedge> beyond = arc(opposite(first, mesh), last);
      if (session_.compare_angle_to_pi(opposite(beyond.front(), mesh),
                                       opposite(beyond.back(), mesh)) != SMALLER) {
        if (is_shorter(beyond, length(side.in))) replace(side, beyond);
        return;
      }
      if (!flip_first(first)) return;
    }
  }
  // false if that is refused, or the cap is reached
  bool flip_first(Halfedge e) {
    if (result_.flips == limits_->flips) {
      result_.status = Status::cap;
    } else if (flip_wedge_.flip(e) == Move_status::done) {
      ++result_.flips;
      return true;
    } else {
      ++result_.refused_flips;
    }
    return false;
  }

  // Puts a way along the sides of the faces of a wedge in place of two segments, or of one that is
  // a loop. It lies on that side of its edges where the faces of the wedge are.
  void replace(const Side& side, const std::vector<Halfedge>& way) {
    if (++result_.shortenings == limits_->shortenings) result_.status = Status::cap;
    const std::uint32_t curve = segments_[side.first].curve;
    const std::uint32_t s = side.is_reversed ? side.second : side.first;
    const std::uint32_t n = side.is_reversed ? side.first : side.second;
    std::uint32_t before = segments_[s].previous, after = segments_[n].next;
    if (s == n || before == n) before = after = none; // all of a loop
    const Halfedge back = opposite(side.in, t_.mesh());
    if (way.empty() && before == none && after == none && s != n)
      network_.curves_[curve].start = target(back, t_.mesh());
    std::vector<Halfedge> shared; // to vertices where other curves are
    for (const Halfedge h : {side.in, side.out, back})
      if (network_.number_of_ends(target(h, t_.mesh())) > 2) shared.push_back(h);
    remove(s);
    if (n != s) remove(n);
    const Chain chain = insert(curve, side.is_reversed, way);
    link(curve, before, chain, after);
    if (before != none) push(before);
    for (std::uint32_t x = chain.first; x != none; x = x == chain.last ? none : segments_[x].next)
      push(x);
    for (const Halfedge h : shared) push_joints_at(h);
  }

  void remove(std::uint32_t s) {
    length_ -= length(network_.halfedge_of(s));
    network_.remove_segment(s);
  }

  struct Chain {
    std::uint32_t first, last;
  };
  Chain insert(std::uint32_t curve, bool is_reversed, const std::vector<Halfedge>& way) {
    Chain chain{none, none};
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Halfedge seen = is_reversed ? way[way.size() - 1 - i] : way[i];
      const Halfedge h = is_reversed ? opposite(seen, t_.mesh()) : seen;
      const std::uint32_t s = segments_.add(t_.numbers().halfedge(h), curve);
      segments_.stack(s, t_.numbers().halfedge(opposite(seen, t_.mesh())));
      network_.count_ends(h, 1);
      length_ += length(h);
      segments_.link(chain.last, s);
      if (chain.first == none) chain.first = s;
      chain.last = s;
    }
    return chain;
  }

  // links new segments with those before and after them; there may be none of either
  void link(std::uint32_t curve, std::uint32_t before, const Chain& chain, std::uint32_t after) {
    auto& c = network_.curves_[curve];
    const bool is_whole_loop = c.is_loop && before == none;
    const std::uint32_t first = chain.first != none ? chain.first : after;
    const std::uint32_t last = chain.last != none ? chain.last : before;
    segments_.link(before, first);
    segments_.link(last, is_whole_loop ? first : after);
    if (c.is_loop || before == none) c.first = first;
    if (c.is_loop)
      c.last = first == none ? none : segments_[first].previous;
    else if (after == none)
      c.last = last;
  }

  Network& network_;
  Triangulation& t_;
  Curve_segments& segments_;
  Session& session_;
  Wedge_flipper<Triangulation> flip_wedge_;
  const Shortening_limits* limits_ = nullptr;
  std::priority_queue<Joint> queue_;
  Shortening_result result_;
  double length_ = 0; // of all curves, in scaled units
  double least_length_ = HUGE_VAL;
  std::uint64_t steps_ = 0, idle_steps_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_SHORTENING_CURVE_SHORTENER_H
