// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_UNFOLDING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_UNFOLDING_H

#include <CGAL/Intrinsic_triangulations/metric/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/metric/Unfolded_diamond.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the input triangles over which the diamonds of a history lie; integers only.

A flip is drawn in the plane of one input face, its *base*: that of its left parent. For each edge
of its diamond it keeps the *path* of crossings of input edges from the base to the plane in which
that edge was made (an input face, or the base of the flip that made it). The two sides of an edge
were made in one plane, or in two input faces glued along it; hence the paths of both sides give
the path from the base of the left parent to that of the right one. A crossing followed by its
inverse cancels.

What is found is remembered.
*/
class Unfolding {
public:
  /// A slot of a version of a face.
  using Side = Flip_history::Side;

  /// Longest path that is followed. Flips of a flat torus make paths whose length is exponential.
  static constexpr std::size_t maximal_path = 1000;

  /*!
  \brief finds input triangles that reach the corners of the diamond between two sides.
  \return the triangles, or nothing if a path is longer than `maximal_path`, or a vertex was inserted
  or removed on the way
  \complexity linear in the number of ancestors not seen yet, times the length of paths
  */
  std::optional<Unfolded_diamond> diamond(const Flip_history& history, Side left, Side right) {
    const auto is_known = [this](std::uint32_t n) { return flips_.count(n) != 0; };
    for (const std::uint32_t n : history.ancestors(left.version, right.version, is_known))
      flips_.emplace(n, history.is_flip(n)
                            ? flip(history, history.left_parent(n), history.right_parent(n))
                            : Flip{none, {}, {}, {}, {}, {}, {}});
    if (is_too_long(history, left) || is_too_long(history, right)) return std::nullopt;
    const Path t = transition(history, left, right);
    std::array<Corner, 4> corners{start(history, left), start(history, next(left)),
                                  start(history, last(left)), start(history, last(right))};
    corners[3].path = product(t, corners[3].path);
    for (Corner& c : corners) trim(c);
    while (move_base(corners)) {
    }
    return tree(corners);
  }

  /// returns the number of flips that are remembered.
  std::size_t size() const { return flips_.size(); }

private:
  // from a side of an input face to the side that is glued to it
  struct Crossing {
    Side from, to;
  };
  using Path = std::vector<Crossing>;

  // the start of a side of the input face in which the path ends
  struct Corner {
    Path path;
    Side side;
  };

  struct Flip {
    std::uint32_t base; // none if a path is too long, or there is no flip
    Path mj, jk, ki, im;
    Corner k, m;
  };

  static constexpr std::uint32_t none = 0xffffffffU;

  static Side next(Side s) { return {s.version, (s.slot + 1) % 3}; }
  static Side last(Side s) { return {s.version, (s.slot + 2) % 3}; }
  static bool equal(Side s, Side t) { return s.version == t.version && s.slot == t.slot; }

  static void append(Path& p, const Crossing& c) {
    if (!p.empty() && equal(p.back().to, c.from) && equal(p.back().from, c.to))
      p.pop_back();
    else
      p.push_back(c);
  }

  static Path product(Path p, const Path& q) {
    for (const Crossing& c : q) append(p, c);
    return p;
  }

  static Path product_with_inverse(Path p, const Path& q) {
    for (auto c = q.rbegin(); c != q.rend(); ++c) append(p, {c->to, c->from});
    return p;
  }

  std::uint32_t base(const Flip_history& history, std::uint32_t version) const {
    return history.is_input(version) ? version : flips_.at(history.node_of(version)).base;
  }

  // from the base of the version of a side to the plane in which the side was made
  const Path& path(const Flip_history& history, Side s) const {
    static const Path identity;
    if (history.is_input(s.version) || s.slot == 0) return identity;
    const std::uint32_t n = history.flip_of(s.version);
    const Flip& f = flips_.at(n);
    if (s.version == history.left_version(n)) return s.slot == 1 ? f.mj : f.jk;
    return s.slot == 1 ? f.ki : f.im;
  }

  // from the base of the left version to that of the right version
  Path transition(const Flip_history& history, Side left, Side right) const {
    Path result = path(history, left);
    const Side from = history.origin(left);
    if (history.is_input(from.version)) append(result, {from, history.origin(right)});
    return product_with_inverse(std::move(result), path(history, right));
  }

  // where a side starts, from the base of its version
  Corner start(const Flip_history& history, Side s) const {
    const Side o = history.origin(s);
    if (history.is_input(o.version)) return {path(history, s), o};
    const std::uint32_t n = history.flip_of(o.version);
    const Corner& c = o.version == history.left_version(n) ? flips_.at(n).k : flips_.at(n).m;
    return {product(path(history, s), c.path), c.side};
  }

  bool is_too_long(const Flip_history& history, Side s) const {
    return base(history, s.version) == none;
  }

  Flip flip(const Flip_history& history, Side left, Side right) const {
    if (is_too_long(history, left) || is_too_long(history, right))
      return {none, {}, {}, {}, {}, {}, {}};
    const Path t = transition(history, left, right);
    Flip f{base(history, left.version),
           product(t, path(history, last(right))),
           path(history, next(left)),
           path(history, last(left)),
           product(t, path(history, next(right))),
           start(history, last(left)),
           start(history, last(right))};
    f.m.path = product(t, f.m.path);
    trim(f.k);
    trim(f.m);
    for (const Path* p : {&f.mj, &f.jk, &f.ki, &f.im, &f.k.path, &f.m.path})
      if (p->size() > maximal_path) return {none, {}, {}, {}, {}, {}, {}};
    return f;
  }

  // an end of the last edge crossed is seen before crossing it
  static void trim(Corner& c) {
    while (!c.path.empty()) {
      const auto [from, to] = c.path.back();
      if (equal(c.side, to))
        c.side = next(from);
      else if (equal(c.side, next(to)))
        c.side = from;
      else
        return;
      c.path.pop_back();
    }
  }

  // moves the base across an edge that all paths cross, but for those to ends of that edge
  static bool move_base(std::array<Corner, 4>& corners) {
    const auto longest =
        std::max_element(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
          return a.path.size() < b.path.size();
        });
    if (longest->path.empty()) return false;
    const auto [from, to] = longest->path.front();
    for (const Corner& c : corners)
      if (c.path.empty() ? !equal(c.side, from) && !equal(c.side, next(from))
                         : !equal(c.path.front().from, from))
        return false;
    for (Corner& c : corners)
      if (c.path.empty())
        c.side = equal(c.side, from) ? next(to) : to;
      else
        c.path.erase(c.path.begin());
    return true;
  }

  // joins the paths from a common base
  static Unfolded_diamond tree(const std::array<Corner, 4>& corners) {
    Unfolded_diamond result;
    std::vector<std::array<std::uint32_t, 3>> children{{0, 0, 0}}; // 0 if there is none
    const Corner& c = corners.front();
    const Side base = c.path.empty() ? c.side : c.path.front().from;
    result.triangles.push_back({base.version, 0, 0, {0, 1, 2}});
    for (std::size_t i = 0; i < 4; ++i) {
      std::uint32_t t = 0;
      for (const auto& [from, to] : corners[i].path) {
        if (children[t][from.slot] == 0) {
          children[t][from.slot] = static_cast<std::uint32_t>(result.triangles.size());
          result.triangles.push_back(result.beyond(t, from.slot, to.version, to.slot));
          children.push_back({0, 0, 0});
        }
        t = children[t][from.slot];
      }
      result.corners[i] = {t, corners[i].side.slot};
    }
    return result;
  }

  std::unordered_map<std::uint32_t, Flip> flips_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_UNFOLDING_H
