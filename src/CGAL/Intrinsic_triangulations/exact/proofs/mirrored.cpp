// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

/*
A reflection of the unfolded triangles of a diamond onto themselves: a map of the tree of triangles
that turns each over, with the same side lengths, and neighbors to neighbors. Then the figure in the
plane has that reflection, too, since the triangles determine it.
*/
class Strip_reflection {
public:
  Strip_reflection(const Input_metric& input, const Unfolded_diamond& diamond)
      : input_(input), diamond_(diamond) {}

  // whether there is one that takes corners i to a and j to b, hence a to i and b to j
  bool exchanges(std::size_t a, std::size_t b) {
    const std::uint32_t i = diamond_.point(0), j = diamond_.point(1), to_i = diamond_.point(a);
    const Unfolded_diamond::Corner& start = diamond_.corners[0];
    for (std::uint32_t t = 0; t < diamond_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (diamond_.triangles[t].point[k] == to_i &&
            maps_all({start.triangle, t, (start.corner + k) % 3}) && image_[i] == to_i &&
            image_[j] == diamond_.point(b) && image_[to_i] == i && image_[diamond_.point(b)] == j)
          return true;
    return false;
  }

private:
  static constexpr std::uint32_t none = Unfolded_diamond::Triangles::none;

  // corner c of triangle `from` is mapped to corner `sum` - c of triangle `to`
  struct Step {
    std::uint32_t from, to, sum;
    std::uint32_t corner(std::uint32_t c) const { return (sum + 3 - c) % 3; }
    std::uint32_t side(std::uint32_t s) const { return (sum + 5 - s) % 3; }
  };

  // extends the map of one triangle to the others; returns whether that is possible
  bool maps_all(const Step& first) {
    if (!are_mirrored(first)) return false; // most are not
    image_.assign(diamond_.triangles.size() + 2, none);
    std::vector<Step> stack{first};
    std::vector<bool> is_done(diamond_.triangles.size());
    while (!stack.empty()) {
      const Step s = stack.back();
      stack.pop_back();
      is_done[s.from] = true;
      for (std::uint32_t k = 0; k < 3; ++k) {
        image_[diamond_.triangles[s.from].point[k]] = diamond_.triangles[s.to].point[s.corner(k)];
        const std::uint32_t next = diamond_.triangles[s.from].beyond[k],
                            to = diamond_.triangles[s.to].beyond[s.side(k)];
        if ((next == none) != (to == none)) return false;
        if (next == none || is_done[next]) continue;
        stack.push_back({next, to, (side_to(next, s.from) + side_to(to, s.to) + 1) % 3});
        if (!are_mirrored(stack.back())) return false;
      }
    }
    return true;
  }

  std::uint32_t side_to(std::uint32_t t, std::uint32_t neighbor) const {
    const auto& beyond = diamond_.triangles[t].beyond;
    return beyond[0] == neighbor ? 0 : beyond[1] == neighbor ? 1 : 2;
  }

  // whether the sides have the same lengths
  bool are_mirrored(const Step& s) const {
    const auto side = [this](std::uint32_t t, std::uint32_t k) -> Face_side {
      const Face_side& first = diamond_.triangles[t].side;
      return {first.face, (first.slot + k) % 3};
    };
    for (std::uint32_t k = 0; k < 3; ++k)
      if (!have_same_length(side(s.from, k), side(s.to, s.side(k)))) return false;
    return true;
  }
  bool have_same_length(Face_side a, Face_side b) const {
    return are_reflected(a, b) ||
           (has_length_of<Interval_nt<false>>(a, b) && has_length_of<Mpzf>(a, b));
  }
  template <class FT>
  bool has_length_of(Face_side a, Face_side b) const {
    return CGAL::possibly(input_.squared_length<FT>(a.face, a.slot) ==
                          input_.squared_length<FT>(b.face, b.slot));
  }
  // whether their coordinates agree but for signs, as on most symmetric surfaces
  bool are_reflected(Face_side a, Face_side b) const {
    const Input_metric::Sides &f = input_.sides(a.face), &g = input_.sides(b.face);
    if (!input_.is_embedded()) return f[a.slot] == g[b.slot];
    if (input_.excess(a.face, a.slot) != input_.excess(b.face, b.slot)) return false;
    const auto &p = input_.points()[f[a.slot]], &q = input_.points()[f[(a.slot + 1) % 3]],
               &r = input_.points()[g[b.slot]], &s = input_.points()[g[(b.slot + 1) % 3]];
    for (std::size_t x = 0; x < 3; ++x)
      if (!(p[x] == r[x] && q[x] == s[x]) && !(p[x] == s[x] && q[x] == r[x]) &&
          !(p[x] == -r[x] && q[x] == -s[x]) && !(p[x] == -s[x] && q[x] == -r[x]))
        return false;
    return true;
  }

  const Input_metric& input_;
  const Unfolded_diamond& diamond_;
  std::vector<std::uint32_t> image_; // of each point
};

} // namespace

} // namespace internal

Answer
Mirrored_proof::operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const {
  if (q.expression.zero_meaning() != Zero_meaning::cocircular || q.figure.has_inserted_corners())
    return Answer::open;
  internal::Strip_reflection reflection(q.input, q.figure);
  return reflection.exchanges(2, 3) || reflection.exchanges(3, 2) ? Answer::zero : Answer::open;
}

} // namespace CGAL::Intrinsic_triangulations
