// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H

#include <cstdint>
#include <iterator>
#include <list>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A path of halfedges, by number, that grows while edges are split, its own among them.
class Path_record {
  using Path = std::list<std::uint32_t>;

public:
  void append(std::uint32_t h) { insert(path_.end(), h); }

  // Edge `e` was split: `first` and `second` lead from the source of halfedge 2 e to its target.
  void split(std::uint32_t e, std::uint32_t first, std::uint32_t second) {
    std::vector<Path::iterator> along;
    const auto [begin, end] = at_.equal_range(e);
    for (auto i = begin; i != end; ++i) along.push_back(i->second);
    at_.erase(begin, end);
    for (const Path::iterator i : along) {
      const bool is_forward = *i % 2 == 0;
      insert(i, is_forward ? first : second ^ 1U);
      insert(i, is_forward ? second : first ^ 1U);
      path_.erase(i);
    }
  }

  std::vector<std::uint32_t> halfedges() const { return {path_.begin(), path_.end()}; }

private:
  void insert(Path::iterator before, std::uint32_t h) {
    at_.emplace(h / 2, path_.insert(before, h));
  }

  Path path_;
  std::unordered_multimap<std::uint32_t, Path::iterator> at_; // by edge
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H
