// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_CURVE_TOPOLOGY_H
#define TEST_INTRINSIC_TRIANGULATIONS_CURVE_TOPOLOGY_H

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

// Crossings and homotopy classes of curves, from their halfedges and the connectivity only.

namespace curve_topology {

namespace IT = CGAL::Intrinsic_triangulations;

// ---- crossings

/// Curves at vertices. Two curves along the same edges cross if one comes from the left of the
/// other and leaves to its right; the order in the network has no effect.
class Crossings {
public:
  template <class Network>
  explicit Crossings(const Network& network) {
    const auto& t = network.triangulation();
    const IT::Intrinsic_view view(t);
    place_.resize(2 * std::size_t{t.numbers().edge_capacity(t.mesh())});
    for (const auto e : edges(t.mesh()))
      for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1}) {
        std::uint32_t n = 0; // clockwise
        for (std::uint32_t g = h; place_[g].fan == none; g = view.next(g ^ 1U))
          place_[g] = {h, n++};
      }
    for (std::uint32_t c = 0; c < network.number_of_curves(); ++c)
      add(network, network.halfedges(c), network.is_loop(c));
  }

  /// Adds a curve that is not in the network; it never goes out and back along an edge.
  template <class Network, class Halfedges>
  void add(const Network& network, const Halfedges& halfedges, bool is_loop) {
    const auto& t = network.triangulation();
    Curve curve{{}, {}, is_loop};
    for (const auto h : halfedges) {
      curve.way.push_back(t.numbers().halfedge(h));
      curve.is_fixed.push_back(network.is_fixed(target(h, t.mesh())));
    }
    curves_.push_back(curve);
  }

  /// The number of crossings at vertices that are not fixed, each counted more than once.
  std::size_t count() const {
    std::size_t n = 0;
    for (const Curve& a : curves_)
      for (const Curve& b : curves_) n += count(a, b, &a == &b) + count(a, reversed(b), false);
    return n;
  }

private:
  static constexpr std::uint32_t none = IT::Gluing::none;
  struct Curve {
    std::vector<std::uint32_t> way;
    std::vector<bool> is_fixed; // the target of each halfedge
    bool is_loop;
    // none: it ends before
    std::uint32_t at(std::size_t i) const {
      if (is_loop) return way[i % way.size()];
      return i < way.size() ? way[i] : none;
    }
    bool is_fixed_after(std::size_t i) const { return is_fixed[i % way.size()]; }
  };
  // of a halfedge among those from its source
  struct Place {
    std::uint32_t fan = none, rank = 0;
  };

  static Curve reversed(const Curve& c) {
    Curve r{{}, {}, c.is_loop};
    const std::size_t n = c.way.size();
    for (std::size_t i = n; i-- > 0;) {
      r.way.push_back(c.way[i] ^ 1U);
      r.is_fixed.push_back(c.is_fixed[(i + n - 1) % n]);
    }
    return r;
  }

  std::size_t count(const Curve& a, const Curve& b, bool are_same) const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.way.size(); ++i)
      for (std::size_t j = 0; j < b.way.size(); ++j)
        if (!(are_same && i == j) && do_cross(a, i, b, j)) ++n;
    return n;
  }

  // Whether a halfedge is on the left of a curve that comes along the opposite of `back` and goes on along `out`.
  bool is_left(std::uint32_t back, std::uint32_t out, std::uint32_t h) const {
    const std::uint32_t b = place_[back].rank, x = place_[h].rank, o = place_[out].rank;
    return b < o ? b < x && x < o : b < x || x < o;
  }

  // Whether curves that come from different edges to the targets of their halfedges i and j cross there, or where they part after they have run along the
  // same edges.
  bool do_cross(const Curve& a, std::size_t i, const Curve& b, std::size_t j) const {
    const std::uint32_t back = a.at(i) ^ 1U, from = b.at(j) ^ 1U;
    std::uint32_t out = a.at(i + 1), to = b.at(j + 1);
    if (place_[back].fan != place_[from].fan || back == from || out == none || to == none)
      return false;
    if (out == from || to == back)
      return false; // they have an edge in common in the other direction
    const bool comes_from_left = is_left(back, out, from);
    std::size_t n = 0;
    for (; !a.is_fixed_after(i + n); ++n) {
      if (out == none || to == none || n > a.way.size() + b.way.size()) return false;
      if (out != to) return comes_from_left != is_left(a.at(i + n) ^ 1U, out, to);
      out = a.at(i + n + 2);
      to = b.at(j + n + 2);
    }
    return false;
  }

  std::vector<Place> place_; // per halfedge
  std::vector<Curve> curves_;
};

// ---- homotopy

/// A product of generators of the fundamental group and their inverses, -1 - g for that of g.
using Word = std::vector<int>;

inline Word inverse(Word w) {
  std::reverse(w.begin(), w.end());
  for (int& x : w) x = -1 - x;
  return w;
}
inline void append(Word& w, const Word& more) {
  for (const int x : more)
    if (!w.empty() && w.back() == -1 - x)
      w.pop_back();
    else
      w.push_back(x);
}
inline Word cyclically_reduced(const Word& w) {
  std::size_t n = 0;
  while (2 * n + 1 < w.size() && w[n] == -1 - w[w.size() - 1 - n]) ++n;
  const auto k = static_cast<std::ptrdiff_t>(n);
  return {w.begin() + k, w.end() - k};
}

/// The fundamental group of a connected surface: words of its halfedges, from a tree of faces,
/// which gives the edge of each face to its parent, and a tree of other edges, which are the
/// neutral element. With a border the result is a free group, else it has one relation.
class Fundamental_group {
public:
  explicit Fundamental_group(const IT::Input& input)
      : input_(input), word_(input.number_of_halfedges()) {
    std::vector<bool> is_in_tree(word_.size() / 2, false);
    std::vector<std::uint32_t> order = span_faces(is_in_tree); // halfedges to the face before
    span_vertices(is_in_tree);
    for (std::uint32_t e = 0; e < is_in_tree.size(); ++e)
      if (!is_in_tree[e]) set(2 * e, {rank_++});
    for (; !order.empty(); order.pop_back()) {
      const std::uint32_t h = order.back();
      if (h == none) continue; // the first face of a closed surface
      Word w = word_[input_.next(h)];
      append(w, word_[input_.next(input_.next(h))]);
      set(h, inverse(w));
    }
    if (is_closed_) {
      std::uint32_t h = input_.halfedge_of_face(0);
      for (unsigned k = 0; k < 3; ++k, h = input_.next(h)) append(relator_, word_[h]);
      relator_ = cyclically_reduced(relator_);
    }
  }

  const Word& word(std::uint32_t h) const { return word_[h]; }
  int rank() const { return rank_; }
  bool is_closed() const { return is_closed_; }

  /// Dehn's algorithm, for closed surfaces of genus 2 and above.
  bool is_trivial(Word w) const {
    if (!is_closed_) return w.empty();
    if (rank_ == 0) return true;
    if (rank_ == 2) return exponents(w) == exponents({});
    while (shorten(w)) {
    }
    return w.empty();
  }
  /// Whether loops may be deformed into each other; on closed surfaces above genus 1, whether they are homologous, and both or none trivial.
  bool are_conjugate(const Word& v, const Word& w) const {
    if (is_closed_) return exponents(v) == exponents(w) && is_trivial(v) == is_trivial(w);
    const Word a = cyclically_reduced(v);
    Word b = cyclically_reduced(w);
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, b.size()); ++i) {
      if (a == b) return true;
      std::rotate(b.begin(), b.begin() + 1, b.end());
    }
    return false;
  }

private:
  static constexpr std::uint32_t none = IT::Gluing::none;

  void set(std::uint32_t h, const Word& w) {
    word_[h] = w;
    word_[h ^ 1U] = inverse(w);
  }

  // by edges that are in no tree yet
  void span_vertices(std::vector<bool>& is_in_tree) const {
    std::vector<bool> is_reached(input_.number_of_vertices(), false);
    std::multimap<std::uint32_t, std::uint32_t> outgoing;
    for (std::uint32_t h = 0; h < word_.size(); ++h) outgoing.emplace(input_.source(h), h);
    std::deque<std::uint32_t> queue{input_.source(0)};
    is_reached[queue.front()] = true;
    for (; !queue.empty(); queue.pop_front()) {
      const auto [begin, end] = outgoing.equal_range(queue.front());
      for (auto i = begin; i != end; ++i) {
        const std::uint32_t h = i->second, v = input_.source(h ^ 1U);
        if (is_reached[v] || is_in_tree[h / 2]) continue;
        is_reached[v] = is_in_tree[h / 2] = true;
        queue.push_back(v);
      }
    }
  }

  // from outside across one edge of the border, or from a face of a closed surface
  std::vector<std::uint32_t> span_faces(std::vector<bool>& is_in_tree) {
    std::vector<std::uint32_t> order{none};
    for (std::uint32_t h = 0; h < word_.size() && is_closed_; ++h)
      if (input_.is_border(h)) {
        is_closed_ = false;
        order.front() = h ^ 1U;
      }
    std::vector<bool> is_reached(input_.number_of_faces(), false);
    is_reached[is_closed_ ? 0 : input_.face(order.front())] = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::uint32_t h = order[i] == none ? input_.halfedge_of_face(0) : order[i];
      if (order[i] != none) is_in_tree[h / 2] = true;
      for (unsigned k = 0; k < 3; ++k, h = input_.next(h)) {
        const std::uint32_t f = input_.face(h ^ 1U);
        if (f == none || is_reached[f]) continue;
        is_reached[f] = true;
        order.push_back(h ^ 1U);
      }
    }
    return order;
  }

  std::vector<int> exponents(const Word& w) const {
    std::vector<int> sum(static_cast<std::size_t>(rank_), 0);
    for (const int x : w) sum[static_cast<std::size_t>(x < 0 ? -1 - x : x)] += x < 0 ? -1 : 1;
    return sum;
  }

  // replaces more than half of the relator, or of its inverse, by the inverse of the rest
  bool shorten(Word& w) const {
    const std::size_t n = relator_.size();
    for (const Word& r : {relator_, inverse(relator_)})
      for (std::size_t i = 0; i < w.size(); ++i)
        for (std::size_t k = 0; k < n; ++k) {
          std::size_t m = 0;
          while (m < n && i + m < w.size() && w[i + m] == r[(k + m) % n]) ++m;
          if (2 * m <= n) continue;
          Word rest;
          for (std::size_t x = m; x < n; ++x) rest.push_back(r[(k + x) % n]);
          const auto begin = w.begin() + static_cast<std::ptrdiff_t>(i);
          Word result(w.begin(), begin);
          append(result, inverse(rest));
          append(result, Word(begin + static_cast<std::ptrdiff_t>(m), w.end()));
          w = result;
          return true;
        }
    return false;
  }

  const IT::Input& input_;
  std::vector<Word> word_; // per halfedge
  bool is_closed_ = true;
  int rank_ = 0;
  Word relator_;
};

/// The word of a curve of the triangulation. From face to face the curve moves to an end of the
/// edge in between, and along the sides of faces.
/// \pre no vertex is inserted, and no two faces of the input have two edges in common
template <class Triangulation, class Halfedges>
Word word_of(const Fundamental_group& group, const Triangulation& t, const Halfedges& halfedges) {
  const IT::Input& input = t.input();
  Word w;
  for (const auto x : halfedges) {
    const std::vector<std::uint32_t> faces = trace_curve(t, std::vector{x}).faces;
    std::uint32_t at = t.index(source(x, t.mesh()));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::uint32_t h = input.halfedge_of_face(faces[i]), to = t.index(target(x, t.mesh()));
      for (std::uint32_t g = h, k = 0; k < 3; ++k, g = input.next(g)) {
        if (i + 1 < faces.size() && input.face(g ^ 1U) == faces[i + 1]) to = input.source(g & ~1U);
        if (input.source(g) == at) h = g;
      }
      for (; input.source(h) != to; h = input.next(h)) append(w, group.word(h));
      at = to;
    }
  }
  return w;
}

} // namespace curve_topology

#endif // TEST_INTRINSIC_TRIANGULATIONS_CURVE_TOPOLOGY_H
