// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Joined_numbers.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Dart_matching.h>
#include <CGAL/Intrinsic_simplification/isometry/search/refine_partition.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr std::uint32_t none = Dart_complex::none;

std::uint32_t state(const Directed_dart& d) { return 2 * d.dart + (d.is_mirrored ? 1U : 0U); }
Directed_dart directed_dart(std::uint32_t state) { return {state / 2, state % 2 != 0}; }

void append_shifted(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from,
                    std::uint32_t shift) {
  for (const std::uint32_t x : from) to.push_back(x == none ? none : x + shift);
}

} // namespace

Dart_matching::Dart_matching(const Dart_complex& first, const Labels& first_labels,
                             const Dart_complex* second, const Labels* second_labels) {
  append(first, first_labels);
  number_of_first_components_ = number_of_components_;
  if (second != nullptr) append(*second, *second_labels);
  image_.assign(next_.size(), none);
  refine();
  sort_states();
  for (std::uint32_t c = 0; c < number_of_components_; ++c) group_component(c);
  Joined_numbers orbits(class_.size());
  std::vector<char> fails(class_.size(), 0); // by orbit
  for (Group& g : groups_) {
    find_symmetries(g, orbits, fails);
    if (second == nullptr) g.seconds = g.firsts;
  }
}

bool Dart_matching::are_isomorphic() const {
  return std::all_of(groups_.begin(), groups_.end(),
                     [](const Group& g) { return g.firsts.size() == g.seconds.size(); });
}

void Dart_matching::append(const Dart_complex& c, const Labels& labels) {
  const auto shift = static_cast<std::uint32_t>(next_.size());
  append_shifted(next_, c.next, shift);
  append_shifted(previous_, c.previous, shift);
  append_shifted(opposite_, c.opposite, shift);
  append_shifted(component_, c.component, number_of_components_);
  append_shifted(sides_, c.sides, 0);
  append_shifted(degree_, c.degree, 0);
  append_shifted(label_, labels, 0);
  number_of_components_ += c.number_of_components;
}

// The automaton has two states for each dart; a mirrored one leads to the darts
// before.
void Dart_matching::refine() {
  const std::size_t size = 2 * next_.size();
  using Label = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool>;
  std::vector<Label> labels;
  std::array<std::vector<std::uint32_t>, 2> inverses;
  for (std::uint32_t d = 0; d < next_.size(); ++d) {
    const std::uint32_t o = opposite_[d];
    for (const bool m : {false, true}) {
      const std::uint32_t from = degree_[m ? next_[d] : d], to = degree_[m ? d : next_[d]];
      labels.emplace_back(label_[d], sides_[d], from, to, o == none);
      inverses[0].push_back(state({m ? next_[d] : previous_[d], m}));
      inverses[1].push_back(o == none ? none : state({o, m}));
    }
  }
  std::vector<std::uint32_t> order(size), label(size, 0);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return labels[a] < labels[b]; });
  for (std::size_t i = 1; i < size; ++i)
    label[order[i]] = label[order[i - 1]] + (labels[order[i]] == labels[order[i - 1]] ? 0U : 1U);
  class_ = refine_partition(label, inverses);
}

void Dart_matching::sort_states() {
  states_.resize(class_.size());
  std::iota(states_.begin(), states_.end(), 0U);
  std::sort(states_.begin(), states_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return std::tuple(component_[a / 2], class_[a], a) <
           std::tuple(component_[b / 2], class_[b], b);
  });
  first_state_.assign(number_of_components_ + std::size_t{1}, 0);
  for (const std::uint32_t c : component_) first_state_[c + std::size_t{1}] += 2;
  std::partial_sum(first_state_.begin(), first_state_.end(), first_state_.begin());
}

std::pair<std::size_t, std::size_t> Dart_matching::candidates(std::uint32_t component,
                                                              std::uint32_t its_class) const {
  const auto begin = states_.begin() + static_cast<std::ptrdiff_t>(first_state_[component]),
             end = states_.begin() + static_cast<std::ptrdiff_t>(first_state_[component + 1]);
  const auto first =
      std::partition_point(begin, end, [&](std::uint32_t s) { return class_[s] < its_class; });
  const auto last =
      std::partition_point(first, end, [&](std::uint32_t s) { return class_[s] == its_class; });
  return {static_cast<std::size_t>(first - states_.begin()),
          static_cast<std::size_t>(last - states_.begin())};
}

// Fewest states look like it: these are the candidates for its images.
std::uint32_t Dart_matching::rarest_dart(std::uint32_t component) const {
  std::uint32_t best = none;
  std::size_t fewest = 0;
  for (std::size_t i = first_state_[component]; i < first_state_[component + 1];) {
    const std::size_t end = candidates(component, class_[states_[i]]).second;
    if (best == none || end - i < fewest) {
      fewest = end - i;
      best = states_[i];
    }
    i = end;
  }
  return best / 2;
}

void Dart_matching::group_component(std::uint32_t component) {
  for (Group& g : groups_)
    if (joins(g, component)) return;
  Group& g = groups_.emplace_back();
  g.first_dart = rarest_dart(component);
  (component < number_of_first_components_ ? g.firsts : g.seconds).push_back({g.first_dart, false});
}

// Finite connected complexes of one size: a map that respects next and opposite
// is a bijection.
bool Dart_matching::joins(Group& group, std::uint32_t component) {
  const std::uint32_t own = component_[group.first_dart];
  const auto size = [this](std::uint32_t c) { return first_state_[c + 1] - first_state_[c]; };
  if (size(own) != size(component) ||
      class_[states_[first_state_[own]]] != class_[states_[first_state_[component]]])
    return false;
  const auto [first, last] = candidates(component, class_[2 * group.first_dart]);
  for (std::size_t i = first; i < last && !is_given_up(); ++i) {
    const Directed_dart to = directed_dart(states_[i]);
    const bool is_isomorphic = try_walk(group.first_dart, to);
    forget_walk();
    if (!is_isomorphic) continue;
    (component < number_of_first_components_ ? group.firsts : group.seconds).push_back(to);
    return true;
  }
  return false;
}

// Symmetries act on states, and none but the identity leaves a state in place.
// So the orbit of the first dart under those found is their group, and no
// member of it has to be walked again. Where a candidate fails, so does its
// orbit.
void Dart_matching::find_symmetries(Group& group, Joined_numbers& orbits,
                                    std::vector<char>& fails) {
  const std::uint32_t own = component_[group.first_dart], start = 2 * group.first_dart;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const bool fail = fails[orbits.set_of(a)] != 0 || fails[orbits.set_of(b)] != 0;
    orbits.join(a, b);
    fails[orbits.set_of(a)] = fail ? 1 : 0;
  };
  const auto [first, last] = candidates(own, class_[start]);
  for (std::size_t i = first; i < last && !is_given_up(); ++i) {
    const std::uint32_t s = states_[i], orbit = orbits.set_of(s);
    if (orbit == orbits.set_of(start) || fails[orbit] != 0) continue;
    const Directed_dart to = directed_dart(s);
    if (try_walk(group.first_dart, to)) {
      for (const std::uint32_t d : visited_)
        for (const bool m : {false, true})
          join(state({d, m}), state({image_[d], m != to.is_mirrored}));
    } else {
      fails[orbit] = 1;
    }
    forget_walk();
  }
  for (std::size_t i = first; i < last; ++i)
    if (orbits.set_of(states_[i]) == orbits.set_of(start))
      group.symmetries.push_back(directed_dart(states_[i]));
}

bool Dart_matching::try_walk(std::uint32_t from, Directed_dart to) {
  ++number_of_walks_;
  if ((number_of_walks_ & 0xffU) == 0) expect_to_go_on(); // short ones
  return walk(from, to, image_, visited_);
}

void Dart_matching::forget_walk() {
  for (const std::uint32_t d : visited_) image_[d] = none;
  visited_.clear();
}

bool Dart_matching::walk(std::uint32_t from, Directed_dart to, std::vector<std::uint32_t>& image,
                         std::vector<std::uint32_t>& visited) const {
  const auto visit = [&](std::uint32_t d, std::uint32_t e) {
    if (image[d] != none) return image[d] == e;
    if (class_[2 * d] != class_[state({e, to.is_mirrored})]) return false;
    image[d] = e;
    visited.push_back(d);
    return true;
  };
  std::size_t i = visited.size();
  if (!visit(from, to.dart)) return false;
  for (; i < visited.size(); ++i) {
    const std::uint32_t d = visited[i], e = image[d], od = opposite_[d], oe = opposite_[e];
    if ((++steps_ & 0x3ffU) == 0) expect_to_go_on();
    if ((od == none) != (oe == none)) return false;
    if (od != none && !visit(od, oe)) return false;
    if (!visit(next_[d], to.is_mirrored ? previous_[e] : next_[e])) return false;
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
