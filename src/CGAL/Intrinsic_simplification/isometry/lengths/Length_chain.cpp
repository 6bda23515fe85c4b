// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

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

// What a link does to the functions 1, x, y and x^2 + y^2 of its plane, times one positive number,
// so that all entries are integers.
class Integer_link {
public:
  explicit Integer_link(const Length_chain::Link& link) {
    const auto& [q, t, s] = link;
    Gmpz d(1);
    for (const Gmpq* x : {&t.x, &t.y, &s.x, &s.y}) mpz_lcm(d.mpz(), d.mpz(), mpq_denref(x->mpq()));
    const auto integer = [&d](const Gmpq& x) { return x.numerator() * (d / x.denominator()); };
    const Gmpz n = q.numerator(), m = q.denominator(), tx = integer(t.x), ty = integer(t.y),
               sx = integer(s.x), sy = integer(s.y);
    whole = d * d * m;
    x_to_one = d * m * sx;
    square_to_one = m * sx * sx + n * sy * sy;
    x_to_x = d * m * tx;
    square_to_x = 2 * (m * sx * tx + n * sy * ty);
    square_to_square = m * tx * tx + n * ty * ty;
    const std::array<Gmpz, 2> factors{m, n};
    for (std::size_t k = 0; k < 2; ++k) {
      y_to_one[k] = d * factors[k] * sy;
      y_to_x[k] = d * factors[k] * ty;
      square_to_y[k] = -2 * factors[k] * (sx * ty - sy * tx);
    }
    divide();
  }

  Gmpz whole, x_to_one, square_to_one, x_to_x, square_to_x, square_to_square;
  // times the root: in functions without it, and in those with it
  std::array<Gmpz, 2> y_to_one, y_to_x, square_to_y;

private:
  void divide() {
    const std::array<Gmpz*, 12> all{
        &whole,       &x_to_one,    &square_to_one, &x_to_x,    &square_to_x,    &square_to_square,
        &y_to_one[0], &y_to_one[1], &y_to_x[0],     &y_to_x[1], &square_to_y[0], &square_to_y[1]};
    Gmpz divisor(0);
    for (const Gmpz* x : all) mpz_gcd(divisor.mpz(), divisor.mpz(), x->mpz());
    for (Gmpz* x : all) mpz_divexact(x->mpz(), x->mpz(), divisor.mpz());
  }
};

/*
Linear functions of the rest of both chains that all have to vanish, each up to a factor: so all
numbers are integers, and a common divisor is found once for a function, not in each operation. A
function has a coefficient for each component, of 1, x, y and x^2 + y^2 in both planes, and each set
of open roots: roots that occur before and after.
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
    rows_.assign(1, Row(components, Gmpz(0)));
    rows_[0][3] = unit_a.numerator() * unit_b.denominator();
    rows_[0][7] = -(unit_b.numerator() * unit_a.denominator());
    for (std::size_t n = 0; n < steps.size(); ++n) {
      expect_to_go_on();
      const std::uint32_t root = steps[n].root;
      if (root != no_root && !open(root)) return false;
      const std::size_t bit = root == no_root ? 0 : bit_of(root);
      const Integer_link link(steps[n].link);
      for (Row& r : rows_) apply(link, steps[n].is_of_second ? 4 : 0, bit, r);
      if (root != no_root && last[root] == n) close(root);
    }
    return std::all_of(rows_.begin(), rows_.end(),
                       [](const Row& r) { return mpz_sgn((r[0] + r[4]).mpz()) == 0; });
  }

private:
  // by sets of open roots, as bits, and then by components
  using Row = std::vector<Gmpz>;
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
    for (Row& r : rows_) r.resize(2 * r.size(), Gmpz(0));
    return true;
  }

  // Copies of a number share it: here each has its own, so that it can be changed.
  static Row zeros(std::size_t size) {
    Row result(size);
    for (Gmpz& x : result) x = Gmpz(0);
    return result;
  }

  // to += a b. \pre no other number shares `to`
  void add_product(const Gmpz& a, const Gmpz& b, Gmpz& to) {
    budget_.count(mpz_size(a.mpz()) * mpz_size(b.mpz()));
    mpz_addmul(to.mpz(), a.mpz(), b.mpz());
  }

  // f(z) = u + v x + w y + q |z|^2 becomes f(turn z + shift)
  // \param first component of the plane of the link
  void apply(const Integer_link& link, std::size_t first, std::size_t bit, Row& row) {
    const Row old = std::exchange(row, zeros(row.size()));
    for (std::size_t set = 0; set < row.size() / components; ++set) {
      const std::size_t other_plane = set * components + (4 - first);
      for (std::size_t k = 0; k < 4; ++k)
        add_product(link.whole, old[other_plane + k], row[other_plane + k]);
      const Gmpz* const f = &old[set * components + first];
      Gmpz* const same = &row[set * components + first];
      add_product(link.whole, f[0], same[0]);
      add_product(link.x_to_one, f[1], same[0]);
      add_product(link.square_to_one, f[3], same[0]);
      add_product(link.x_to_x, f[1], same[1]);
      add_product(link.square_to_x, f[3], same[1]);
      add_product(link.x_to_x, f[2], same[2]);
      add_product(link.square_to_square, f[3], same[3]);
      const std::size_t has_root = (set & bit) != 0 ? 1 : 0;
      Gmpz* const other = &row[(set ^ bit) * components + first];
      add_product(link.y_to_one[has_root], f[2], other[0]);
      add_product(link.y_to_x[has_root], f[2], other[1]);
      add_product(-link.y_to_x[has_root], f[1], other[2]);
      add_product(link.square_to_y[has_root], f[3], other[2]);
    }
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
      divide(r);
      for (std::size_t k = 0; k < rows_.size(); ++k) eliminate(pivots[k], rows_[k], r);
      const auto pivot =
          std::find_if(r.begin(), r.end(), [](const Gmpz& x) { return mpz_sgn(x.mpz()) != 0; });
      if (pivot == r.end()) continue;
      pivots.push_back(static_cast<std::size_t>(pivot - r.begin()));
      rows_.push_back(std::move(r));
    }
    if (rows_.empty()) rows_.emplace_back(all.front().size(), Gmpz(0));
  }

  // Makes a row zero at the pivot of another one, which is zero before it.
  void eliminate(std::size_t pivot, const Row& by, Row& row) {
    if (mpz_sgn(row[pivot].mpz()) == 0) return;
    Gmpz divisor;
    mpz_gcd(divisor.mpz(), row[pivot].mpz(), by[pivot].mpz());
    const Gmpz factor = by[pivot] / divisor, other = -(row[pivot] / divisor);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Gmpz before = std::exchange(row[i], Gmpz(0));
      add_product(factor, before, row[i]);
      add_product(other, by[i], row[i]);
    }
    divide(row);
  }

  static void divide(Row& row) {
    Gmpz divisor(0);
    for (std::size_t i = 0; i < row.size() && divisor != Gmpz(1); ++i)
      mpz_gcd(divisor.mpz(), divisor.mpz(), row[i].mpz());
    if (divisor == Gmpz(0) || divisor == Gmpz(1)) return;
    for (Gmpz& x : row) mpz_divexact(x.mpz(), x.mpz(), divisor.mpz());
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
