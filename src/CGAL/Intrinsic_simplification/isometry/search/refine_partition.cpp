// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/search/refine_partition.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Classes of states, each a range of one array, with its marked states in
// front.
class Partition {
public:
  explicit Partition(const std::vector<std::uint32_t>& label)
      : states_(label.size()), place_(label.size()), class_(label.size()) {
    std::iota(states_.begin(), states_.end(), 0U);
    std::stable_sort(states_.begin(), states_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return label[a] < label[b]; });
    for (std::uint32_t i = 0; i < states_.size(); ++i) {
      if (i == 0 || label[states_[i]] != label[states_[i - 1]]) ranges_.push_back({i, i, i});
      place_[states_[i]] = i;
      class_[states_[i]] = size() - 1;
      ranges_.back().end = i + 1;
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(ranges_.size()); }
  std::span<const std::uint32_t> states(std::uint32_t c) const {
    return std::span(states_).subspan(ranges_[c].begin, ranges_[c].end - ranges_[c].begin);
  }
  const std::vector<std::uint32_t>& class_of() const { return class_; }

  void mark(std::uint32_t state) {
    Range& r = ranges_[class_[state]];
    if (r.marked_end == r.begin) touched_.push_back(class_[state]);
    const std::uint32_t i = place_[state], j = r.marked_end++;
    std::swap(states_[i], states_[j]);
    place_[states_[i]] = i;
    place_[states_[j]] = j;
  }

  // Splits classes with marked states and others. Calls a function with the
  // smaller part of each, which becomes a new class.
  template <class Visit>
  void split(const Visit& visit) {
    for (const std::uint32_t c : touched_) {
      Range& r = ranges_[c];
      const std::uint32_t middle = std::exchange(r.marked_end, r.begin);
      if (middle == r.end) continue;
      const bool is_front = middle - r.begin <= r.end - middle;
      const Range part = is_front ? Range{r.begin, r.begin, middle} : Range{middle, middle, r.end};
      (is_front ? r.begin : r.end) = middle;
      r.marked_end = r.begin;
      for (std::uint32_t i = part.begin; i < part.end; ++i) class_[states_[i]] = size();
      ranges_.push_back(part);
      visit(size() - 1);
    }
    touched_.clear();
  }

private:
  struct Range {
    std::uint32_t begin, marked_end, end;
  };
  std::vector<std::uint32_t> states_, place_, class_, touched_;
  std::vector<Range> ranges_;
};

} // namespace

std::vector<std::uint32_t> refine_partition(const std::vector<std::uint32_t>& label,
                                            std::span<const std::vector<std::uint32_t>> inverses) {
  Partition partition(label);
  std::vector<std::uint32_t> open(partition.size()), splitter;
  std::iota(open.begin(), open.end(), 0U);
  while (!open.empty()) {
    const std::span<const std::uint32_t> states = partition.states(open.back());
    open.pop_back();
    expect_to_go_on();
    splitter.assign(states.begin(), states.end());
    for (const std::vector<std::uint32_t>& inverse : inverses) {
      for (const std::uint32_t s : splitter)
        if (inverse[s] != Gluing::none) partition.mark(inverse[s]);
      // If a class waits and is split, both of its parts have to be used, and
      // are: the larger part keeps the number that waits. If it was used, the
      // smaller part is enough.
      partition.split([&](std::uint32_t part) { open.push_back(part); });
    }
  }
  return partition.class_of();
}

} // namespace CGAL::Intrinsic_triangulations::internal
