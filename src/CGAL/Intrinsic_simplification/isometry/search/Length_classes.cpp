// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Strip_names.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Length_classes.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

int exponent_to_units_of(const Singular_surface& from, const Singular_surface& to) {
  return 2 * (to.start().input().scale_exponent() - from.start().input().scale_exponent());
}

namespace {

// A squared length, or another measure of an edge, in the units of the first surface.
struct Length {
  std::uint32_t surface;
  Value_recipes::Id id;
  Short_ball value;
};

enum class Equality { equal, different, open };

// Compares squared lengths that enclosures of 106 bits do not tell apart.
class Exact_comparison {
public:
  explicit Exact_comparison(std::span<const Singular_surface* const> surfaces)
      : surfaces_(surfaces) {
    start_field();
  }

  Equality operator()(const Length& x, const Length& y) {
    if (x.surface == y.surface && x.id == y.id) return Equality::equal;
    if (const auto n = name(x); n && n == name(y)) return Equality::equal;
    if (have_identical_chains(x, y)) return Equality::equal;
    for (int attempt = 0; attempt < 2 && words_left_ > 0; ++attempt) {
      try {
        return compare_in_field(x, y);
      } catch (const std::length_error&) { // once more in a field without the roots of others
        start_field();
      }
    }
    const auto differ = in_growing_precision([&]() -> std::optional<bool> {
      const Uncertain<Sign> s = (long_value(x) - long_value(y)).sign();
      return is_certain(s) ? std::optional(get_certain(s) != ZERO) : std::nullopt;
    });
    return !differ ? Equality::open : *differ ? Equality::different : Equality::equal;
  }

  // Lengths from now on are not compared with those before: chains of a large surface take much
  // memory.
  void forget_chains() { known_chains_.clear(); }

private:
  using Number = Square_root_field::Number;

  const Value_recipes& recipes(const Length& x) const {
    return surfaces_[x.surface]->triangulation().recipes();
  }
  int exponent(const Length& x) const {
    return exponent_to_units_of(*surfaces_[x.surface], *surfaces_.front());
  }

  static std::uint64_t key(const Length& x) { return (std::uint64_t{x.surface} << 32U) | x.id; }

  std::optional<Strip_names::Name> name(const Length& x) {
    if (!recipes(x).is_length_of_edge(x.id)) return std::nullopt;
    if (const auto known = known_names_.find(key(x)); known != known_names_.end())
      return known->second;
    return known_names_.emplace(key(x), names_.name(recipes(x), x.id, exponent(x))).first->second;
  }

  const std::optional<Length_chain>& chain(const Length& x) {
    if (const auto known = known_chains_.find(key(x)); known != known_chains_.end())
      return known->second;
    std::optional<Length_chain> c = surfaces_[x.surface]->triangulation().developed().chain(x.id);
    if (c) c->unit = scaled_by_power_of_two(c->unit, exponent(x));
    return known_chains_.emplace(key(x), std::move(c)).first->second;
  }

  bool have_identical_chains(const Length& x, const Length& y) {
    if (words_left_ == 0) return false;
    const std::optional<Length_chain>&a = chain(x), &b = chain(y);
    if (!a || !b) return false;
    const std::size_t most = std::min(words_left_, most_words);
    std::size_t left = most;
    const bool are_equal = are_identical(*a, *b, left);
    words_left_ -= most - left;
    return are_equal;
  }

  Equality compare_in_field(const Length& x, const Length& y) {
    const std::size_t most = std::min(words_left_, most_words);
    field_->limit_products(most);
    struct Count { // also if the field gives up
      std::size_t& left;
      std::size_t before;
      const Square_root_field& field;
      ~Count() { left -= before - field.words_left(); }
    } const count{words_left_, most, *field_};
    const auto value = [&](const Length& l) {
      return exact_[l.surface](l.id) * Number(scaled_by_power_of_two(Gmpq(1), exponent(l)));
    };
    return (value(x) - value(y)).is_zero() ? Equality::equal : Equality::different;
  }

  Long_ball long_value(const Length& x) const {
    Developed_faces::Evaluation<Long_ball> values(
        surfaces_[x.surface]->triangulation().developed());
    return values(x.id) * Long_ball(std::ldexp(1.0, exponent(x)));
  }

  void start_field() {
    exact_.clear(); // its numbers refer to the field
    field_ = std::make_unique<Square_root_field>();
    for (const Singular_surface* s : surfaces_)
      exact_.emplace_back(s->triangulation().developed(), field_.get());
  }

  // words of coefficients, and of numbers of chains, that one proof may cost, and all together:
  // seconds
  static constexpr std::size_t most_words = std::size_t(1) << 23;

  std::span<const Singular_surface* const> surfaces_;
  std::size_t words_left_ = std::size_t(1) << 27;
  Strip_names names_;
  // by surface and value
  std::unordered_map<std::uint64_t, std::optional<Strip_names::Name>> known_names_;
  std::unordered_map<std::uint64_t, std::optional<Length_chain>> known_chains_;
  std::unique_ptr<Square_root_field> field_;
  std::vector<Developed_faces::Evaluation<Number>> exact_;
};

// The squared lengths of all edges of the tessellations, by size.
std::vector<Length> sorted_lengths(std::span<const Singular_surface* const> surfaces,
                                   std::span<const Dart_complex* const> complexes) {
  std::vector<Length> all;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    const Dart_complex& darts = *complexes[s];
    const Short_ball factor(std::ldexp(1.0, exponent_to_units_of(*surfaces[s], *surfaces[0])));
    for (std::uint32_t d = 0; d < darts.size(); ++d) {
      if (darts.opposite[d] < d) continue; // its edge was added
      expect_to_go_on();
      const Value_recipes::Id id = surfaces[s]->measure(darts.halfedge[d] / 2);
      all.push_back({s, id, surfaces[s]->triangulation().narrow_enclosure(id) * factor});
    }
  }
  std::sort(all.begin(), all.end(), [](const Length& a, const Length& b) {
    return (a.value.center() - b.value.center()).magnitude() < 0;
  });
  return all;
}

// Calls a function with each maximal run of lengths that enclosures do not tell
// apart.
template <class Visit>
void for_each_run(std::span<const Length> all, const Visit& visit) {
  const auto radius = [&](std::size_t i) { return all[i].value.radius() * (1 + 0x1p-40); };
  // lower bounds of each length and all after it: a later enclosure may be wider
  std::vector<Double_double> lower(all.size());
  for (std::size_t i = all.size(); i-- > 0;) {
    lower[i] = all[i].value.center() - Double_double(radius(i));
    if (i + 1 < all.size() && (lower[i + 1] - lower[i]).magnitude() < 0) lower[i] = lower[i + 1];
  }
  std::size_t begin = 0;
  Double_double upper;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > begin && (lower[i] - upper).magnitude() > 0x1p-99 * upper.magnitude()) {
      visit(all.subspan(begin, i - begin));
      begin = i;
    }
    const Double_double above = all[i].value.center() + Double_double(radius(i));
    if (i == begin || (above - upper).magnitude() > 0) upper = above;
  }
  if (begin < all.size()) visit(all.subspan(begin));
}

using Classes_by_id = std::vector<std::unordered_map<Value_recipes::Id, std::uint32_t>>;

Length_classes classes_of_darts(std::span<const Singular_surface* const> surfaces,
                                std::span<const Dart_complex* const> complexes,
                                const Classes_by_id& by_id) {
  Length_classes result;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    std::vector<std::uint32_t>& of_dart = result.of_dart.emplace_back();
    for (const std::uint32_t h : complexes[s]->halfedge)
      of_dart.push_back(3 * by_id[s].at(surfaces[s]->measure(h / 2)) +
                        surfaces[s]->number_of_copied_ends(h / 2));
  }
  return result;
}

} // namespace

Length_classes exact_length_classes(std::span<const Singular_surface* const> surfaces) {
  Exact_comparison compare(surfaces);
  Classes_by_id by_id(surfaces.size());
  std::uint32_t number_of_classes = 0;
  bool are_proven = true;
  std::vector<const Dart_complex*> darts;
  for (const Singular_surface* s : surfaces) darts.push_back(&s->darts());
  const std::vector<Length> all = sorted_lengths(surfaces, darts);
  const bool are_separated = std::all_of(all.begin(), all.end(), [](const Length& x) {
    return x.value.radius() <= 0x1p-80 * std::abs(x.value.center().magnitude());
  });
  for_each_run(all, [&](std::span<const Length> run) {
    compare.forget_chains();
    std::vector<std::pair<const Length*, std::uint32_t>> classes;
    for (const Length& x : run) {
      expect_to_go_on();
      const auto is_same = [&](const auto& c) {
        if (is_certain((x.value - c.first->value).sign()) &&
            get_certain((x.value - c.first->value).sign()) != ZERO)
          return false;
        // one open comparison leaves the answer open: all others would be in vain
        const Equality e = are_proven ? compare(x, *c.first) : Equality::open;
        are_proven = are_proven && e != Equality::open;
        return e != Equality::different;
      };
      const auto found = std::find_if(classes.begin(), classes.end(), is_same);
      const std::uint32_t c = found == classes.end() ? number_of_classes++ : found->second;
      if (found == classes.end()) classes.emplace_back(&x, c);
      by_id[x.surface].emplace(x.id, c);
    }
  });
  Length_classes result = classes_of_darts(surfaces, darts, by_id);
  result.are_proven = are_proven;
  result.are_separated = are_separated;
  return result;
}

Length_classes rounded_length_classes(std::span<const Singular_surface* const> surfaces,
                                      double error, std::span<const Dart_complex* const> darts) {
  Classes_by_id by_id(surfaces.size());
  std::uint32_t number = 0;
  double before = 0;
  for (const Length& x : sorted_lengths(surfaces, darts)) {
    const double value = x.value.to_double();
    if (value > before * (1 + 2 * error)) ++number; // squares differ twice as much
    before = value;
    by_id[x.surface].emplace(x.id, number);
  }
  return classes_of_darts(surfaces, darts, by_id);
}

} // namespace CGAL::Intrinsic_triangulations::internal
