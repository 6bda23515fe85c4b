// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Length_chain::Link inverse(const Length_chain::Link& link) {
  const Plane_number turn = quotient({1, 0}, link.turn, link.square);
  return {link.square, turn, -product(turn, link.shift, link.square)};
}

// With f(g) = 0: f(0) = f(0) - f(g) is the turn times -g.
Length_chain Length_chain::reversed() const {
  Length_chain result{unit, {}};
  for (std::size_t i = links.size(); i-- > 0;) {
    result.unit = result.unit * norm(links[i].turn, links[i].square);
    result.links.push_back(inverse(links[i]));
  }
  return result;
}

namespace {

constexpr std::uint32_t no_root = Gluing::none;

// The words of a number, as the field of square roots counts them.
std::size_t words(const Gmpq& x) {
  return mpz_size(mpq_numref(x.mpq())) + mpz_size(mpq_denref(x.mpq()));
}

// Counts words of numbers that are multiplied.
class Budget {
public:
  explicit Budget(std::size_t& left) : left_(left) {}
  // \throws std::length_error if they are used up
  void count(std::size_t words) {
    if (words > left_) {
      left_ = 0;
      throw std::length_error("chains of too many words");
    }
    left_ -= words;
  }

private:
  std::size_t& left_;
};

// Roots of square classes, numbered; the root of a square has no number.
class Root_classes {
public:
  explicit Root_classes(Budget budget) : budget_(budget) {}

  // Writes the numbers of a link with the root of its class. \return the class, or no_root
  std::uint32_t reduce(Length_chain::Link& link) {
    const auto is_reduced = [&](const Gmpq& square) {
      budget_.count(words(link.square) * words(square));
      Gmpq root; // of the quotient
      if (!rational_square_root(link.square / square, root)) return false;
      link = {square, {link.turn.x, link.turn.y * root}, {link.shift.x, link.shift.y * root}};
      return true;
    };
    if (is_reduced(Gmpq(1))) return no_root;
    const auto known = std::find_if(squares_.begin(), squares_.end(), is_reduced);
    const auto number = static_cast<std::uint32_t>(known - squares_.begin());
    if (known == squares_.end()) squares_.push_back(link.square);
    return number;
  }
  std::size_t size() const { return squares_.size(); }

private:
  Budget budget_;
  std::vector<Gmpq> squares_;
};

// A link of one of the two chains, with the class of its root.
struct Step {
  Length_chain::Link link;
  std::uint32_t root;
  bool is_of_second;
};

std::vector<Step> steps_of(const Length_chain& chain, bool is_second, Root_classes& roots) {
  std::vector<Step> result;
  for (Length_chain::Link link : chain.links) {
    expect_to_go_on(); // all roots before are compared
    const std::uint32_t root = roots.reduce(link);
    result.push_back({std::move(link), root, is_second});
  }
  return result;
}

// Both chains as one, so that a root of both occurs at one time. Where both go on with new roots,
// one that is in one chain only goes first.
std::vector<Step> merged(std::vector<Step> a, std::vector<Step> b, std::size_t number_of_roots) {
  std::vector<char> is_met(number_of_roots + 1, 0), is_in_a = is_met;
  const auto at = [&](std::vector<char>& flags, const Step& s) -> char& {
    return flags[s.root == no_root ? number_of_roots : s.root];
  };
  for (const Step& s : a) at(is_in_a, s) = 1;
  is_met[number_of_roots] = 1;
  std::vector<Step> result;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool takes_second =
        i == a.size() || (j < b.size() && (at(is_met, b[j]) != 0 || at(is_in_a, b[j]) == 0));
    result.push_back(std::move(takes_second ? b[j++] : a[i++]));
    at(is_met, result.back()) = 1;
  }
  return result;
}

/*
Linear functions of the rest of both chains that all have to vanish. A function has a coefficient
for each component, of 1, x, y and x^2 + y^2 in both planes, and each set of open roots: roots
that occur before and after.
*/
class Difference {
public:
  explicit Difference(Budget budget) : budget_(budget) {}

  // \return whether the steps lead to zero by an identity
  bool vanishes(const Gmpq& unit_a, const Gmpq& unit_b, const std::vector<Step>& steps,
                std::size_t number_of_roots) {
    std::vector<std::size_t> last(number_of_roots, 0);
    for (std::size_t n = 0; n < steps.size(); ++n)
      if (steps[n].root != no_root) last[steps[n].root] = n;
    rows_.assign(1, Row(components, Gmpq(0)));
    rows_[0][3] = unit_a;
    rows_[0][7] = -unit_b;
    for (std::size_t n = 0; n < steps.size(); ++n) {
      expect_to_go_on();
      const std::uint32_t root = steps[n].root;
      if (root != no_root && !open(root)) return false;
      const std::size_t bit = root == no_root ? 0 : bit_of(root);
      for (Row& r : rows_) apply(steps[n], bit, r);
      if (root != no_root && last[root] == n) close(root);
    }
    return std::all_of(rows_.begin(), rows_.end(),
                       [](const Row& r) { return r[0] + r[4] == Gmpq(0); });
  }

private:
  // by sets of open roots, as bits, and then by components
  using Row = std::vector<Gmpq>;
  static constexpr std::size_t components = 8;
  // Chains of one line have one or two open at a time; rows are at most 8 times 2 to this power.
  static constexpr std::size_t most_open = 4;

  std::size_t bit_of(std::uint32_t root) const {
    const auto at = std::find(open_.begin(), open_.end(), root);
    return std::size_t(1) << static_cast<std::size_t>(at - open_.begin());
  }

  bool open(std::uint32_t root) {
    if (std::find(open_.begin(), open_.end(), root) != open_.end()) return true;
    if (open_.size() == most_open) return false;
    open_.push_back(root);
    for (Row& r : rows_) r.resize(2 * r.size(), Gmpq(0));
    return true;
  }

  // f(z) = u + v x + w y + q |z|^2 becomes f(turn z + shift)
  void apply(const Step& step, std::size_t bit, Row& row) {
    const auto& [square, t, s] = step.link;
    budget_.count((words(square) + words(t.x) + words(t.y) + words(s.x) + words(s.y)) *
                  words_of(row, step.is_of_second ? 4 : 0));
    const Gmpq norm_of_turn = norm(t, square), norm_of_shift = norm(s, square),
               real = 2 * (s.x * t.x + square * s.y * t.y), imaginary = 2 * (s.x * t.y - s.y * t.x);
    const Row old = row;
    const std::size_t first = step.is_of_second ? 4 : 0;
    for (std::size_t set = 0; set < row.size() / components; ++set) {
      const Gmpq* const f = &old[set * components + first];
      Gmpq* const same = &row[set * components + first];
      same[0] += f[1] * s.x + f[3] * norm_of_shift;
      same[1] = same[1] + f[1] * (t.x - 1) + f[3] * real;
      same[2] = same[2] + f[2] * (t.x - 1);
      same[3] = same[3] + f[3] * (norm_of_turn - 1);
      // times the root
      const bool has_root = (set & bit) != 0;
      Gmpq* const other = &row[(set ^ bit) * components + first];
      const Gmpq factor = has_root ? square : Gmpq(1);
      other[0] += factor * f[2] * s.y;
      other[1] += factor * f[2] * t.y;
      other[2] -= factor * (f[1] * t.y + f[3] * imaginary);
    }
  }

  // The words of the four components of one plane.
  static std::size_t words_of(const Row& row, std::size_t first) {
    std::size_t result = 0;
    for (std::size_t i = first; i < row.size(); i += components)
      for (std::size_t k = 0; k < components / 2; ++k) result += words(row[i + k]);
    return result;
  }

  // The coefficients of a root that does not occur again have to vanish as those without it do.
  void close(std::uint32_t root) {
    const std::size_t bit = bit_of(root), upper = rows_[0].size() / components / 2;
    std::vector<Row> all;
    for (const Row& r : rows_)
      for (const std::size_t part : {std::size_t(0), bit}) {
        Row half;
        for (std::size_t n = 0; n < upper; ++n) {
          const std::size_t below = n & (bit - 1), set = 2 * (n - below) + below + part;
          half.insert(half.end(), r.begin() + static_cast<std::ptrdiff_t>(set * components),
                      r.begin() + static_cast<std::ptrdiff_t>((set + 1) * components));
        }
        all.push_back(std::move(half));
      }
    open_.erase(std::find(open_.begin(), open_.end(), root));
    keep_basis(std::move(all));
  }

  void keep_basis(std::vector<Row> all) {
    rows_.clear();
    std::vector<std::size_t> pivots;
    for (Row& r : all) {
      expect_to_go_on();
      for (std::size_t k = 0; k < rows_.size(); ++k)
        subtract(Gmpq(r[pivots[k]]), rows_[k], pivots[k], r);
      const auto pivot =
          std::find_if(r.begin(), r.end(), [](const Gmpq& x) { return x != Gmpq(0); });
      if (pivot == r.end()) continue;
      const Gmpq scale = 1 / *pivot;
      pivots.push_back(static_cast<std::size_t>(pivot - r.begin()));
      for (Gmpq& x : r) x = x * scale;
      rows_.push_back(std::move(r));
    }
    if (rows_.empty()) rows_.emplace_back(all.front().size(), Gmpq(0));
  }

  // Subtracts a multiple of a row that is zero before its pivot.
  void subtract(const Gmpq& factor, const Row& row, std::size_t pivot, Row& from) {
    if (factor == Gmpq(0)) return;
    for (std::size_t i = pivot; i < from.size(); ++i) {
      budget_.count(words(factor) * words(row[i]));
      from[i] -= factor * row[i];
    }
  }

  Budget budget_;
  std::vector<std::uint32_t> open_;
  std::vector<Row> rows_;
};

bool have_zero_difference(const Length_chain& a, const Length_chain& b, const Budget& budget) {
  Root_classes roots(budget);
  std::vector<Step> first = steps_of(a, false, roots), second = steps_of(b, true, roots);
  const std::vector<Step> steps = merged(std::move(first), std::move(second), roots.size());
  return Difference(budget).vanishes(a.unit, b.unit, steps, roots.size());
}

} // namespace

bool are_identical(const Length_chain& a, const Length_chain& b, std::size_t& words_left) {
  const Budget budget(words_left);
  try {
    return have_zero_difference(a, b, budget) || have_zero_difference(a, b.reversed(), budget);
  } catch (const std::length_error&) { // nothing is known
    return false;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
