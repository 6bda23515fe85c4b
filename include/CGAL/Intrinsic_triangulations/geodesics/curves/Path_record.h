// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H

#include <cstdint>
#include <list>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A path of halfedges, by number, that grows while edges are split, its own among them.
class Path_record {
  using Path = std::list<std::uint32_t>;

public:
  void append(std::uint32_t h);

  // Edge `e` was split: `first` and `second` lead from the source of halfedge 2 e to its target.
  void split(std::uint32_t e, std::uint32_t first, std::uint32_t second);

  std::vector<std::uint32_t> halfedges() const;
  std::uint32_t last() const { return path_.back(); }
  bool has_edge(std::uint32_t e) const { return at_.count(e) != 0; }

private:
  void insert(Path::iterator before, std::uint32_t h);

  Path path_;
  std::unordered_multimap<std::uint32_t, Path::iterator> at_; // by edge
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Path_record_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_H
