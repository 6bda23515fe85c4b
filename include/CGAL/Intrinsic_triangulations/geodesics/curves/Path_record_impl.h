// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Path_record.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Path_record::append(std::uint32_t h) {
  insert(path_.end(), h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Path_record::split(std::uint32_t e, std::uint32_t first,
                                                             std::uint32_t second) {
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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<std::uint32_t> Path_record::halfedges() const {
  return {path_.begin(), path_.end()};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Path_record::insert(Path::iterator before,
                                                              std::uint32_t h) {
  at_.emplace(h / 2, path_.insert(before, h));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_PATH_RECORD_IMPL_H
