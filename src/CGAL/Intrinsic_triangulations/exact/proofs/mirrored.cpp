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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

/*
A map of some of the unfolded triangles of a diamond to others that turns each over, with the same
side lengths, and neighbors to neighbors. Triangles that are connected determine their figure in the
plane: the map is an isometry there that changes the orientation. It is a reflection if it has a
fixed point: a point, or the midpoint of two points that it exchanges. Triangles in between need not
be symmetric, such as those of sheets of a cover that are glued in another way.
*/
class Strip_reflection {
public:
  Strip_reflection(const Input_metric& input, const Unfolded_diamond& diamond)
      : input_(input), diamond_(diamond), steps_left_(64 * diamond.size() + 1024) {}

  // whether there is a reflection that exchanges corners i and a, and j and b
  bool exchanges(std::size_t a, std::size_t b) {
    const std::uint32_t i = diamond_.point(0), j = diamond_.point(1), to_i = diamond_.point(a),
                        to_j = diamond_.point(b);
    for (std::uint32_t s = 0; s < diamond_.triangles.size(); ++s)
      if (const std::uint32_t c = corner_at(s, i); c < 3)
        for (std::uint32_t t = 0; t < diamond_.triangles.size(); ++t)
          if (const std::uint32_t d = corner_at(t, to_i); d < 3 && maps({s, t, (c + d) % 3}) &&
                                                          is_reflection_ &&
                                                          (image_[j] == to_j || image_[to_j] == j))
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

  // which corner of a triangle a point is, or 3
  std::uint32_t corner_at(std::uint32_t triangle, std::uint32_t point) const {
    const auto& p = diamond_.triangles[triangle].point;
    return static_cast<std::uint32_t>(std::find(p.begin(), p.end(), point) - p.begin());
  }

  // extends the map of one triangle to as many others as possible; false if there is none
  bool maps(const Step& first) {
    if (!are_mirrored(first)) return false; // most are not
    image_.assign(diamond_.triangles.size() + 2, none);
    is_reflection_ = false;
    std::vector<Step> stack{first};
    std::vector<bool> is_done(diamond_.triangles.size());
    while (!stack.empty()) {
      const Step s = stack.back();
      stack.pop_back();
      if (steps_left_ == 0) return false;
      --steps_left_;
      is_done[s.from] = true;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t p = diamond_.triangles[s.from].point[k],
                            q = diamond_.triangles[s.to].point[s.corner(k)];
        image_[p] = q;
        is_reflection_ = is_reflection_ || p == q || image_[q] == p;
        const std::uint32_t next = diamond_.triangles[s.from].beyond[k],
                            to = diamond_.triangles[s.to].beyond[s.side(k)];
        if (next == none || to == none || is_done[next]) continue;
        const Step step{next, to, (side_to(next, s.from) + side_to(to, s.to) + 1) % 3};
        if (are_mirrored(step)) stack.push_back(step);
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
  std::vector<std::uint32_t> image_; // of each point that is mapped
  bool is_reflection_ = false;       // whether the map has a fixed point
  std::size_t steps_left_; // of all maps: there are many about a corner of equal triangles
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
