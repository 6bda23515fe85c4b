// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_GROWING_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_GROWING_PATHS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Path_record.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Paths of edges, one after the other, whose edges are split where later ones cross them. The
// last one grows.
template <class Triangulation>
class Growing_paths {
public:
  // A vertex on an edge, and the halfedges from it to the ends of the edge, and to the apex of
  // the face in which it was split.
  struct Split {
    Move_status status;
    std::uint32_t to_source, to_target, to_apex;
  };

  // The halfedges of a path so far; paths are numbered from 0.
  std::vector<typename Triangulation::halfedge_descriptor> halfedges(const Triangulation& t,
                                                                     std::size_t i = 0) const {
    std::vector<typename Triangulation::halfedge_descriptor> result;
    for (const std::uint32_t h : paths_[i].halfedges())
      result.push_back(t.numbers().halfedge_at(h));
    return result;
  }
  std::uint32_t last() const { return paths_.back().last(); }
  bool has_edge(std::uint32_t e) const {
    return std::any_of(paths_.begin(), paths_.end(),
                       [e](const Path_record& path) { return path.has_edge(e); });
  }

  void begin() { paths_.emplace_back(); }
  void append(std::uint32_t h) { paths_.back().append(h); }

  // splits the edge of a halfedge that has a face
  Split split(Triangulation& t, std::uint32_t h, double parameter) {
    const Intrinsic_view<Triangulation> view(t);
    const auto last = [&view](std::uint32_t g) { return view.next(view.next(g)); };
    const bool on_border = view.is_border(h ^ 1U);
    const Move_status status =
        typename Triangulation::Session(t).split_edge(t.numbers().halfedge_at(h), parameter).status;
    if (status != Move_status::done) return {status, h, h, h};
    Split s{status, h ^ 1U, 0, 0};
    if (on_border) { // h is the first half
      s.to_apex = view.next(h);
      s.to_target = view.next(s.to_apex ^ 1U);
    } else { // h was flipped, and runs from the vertex to the apex of the other face
      s.to_source = view.next(h ^ 1U);
      s.to_target = last(h) ^ 1U;
      s.to_apex = next_around_source(view, s.to_target);
      // h has come in between if the edge has this face on both sides
      if (s.to_apex / 2 == h / 2) s.to_apex = next_around_source(view, s.to_apex);
    }
    for (Path_record& path : paths_)
      if (h % 2 == 0)
        path.split(h / 2, s.to_source ^ 1U, s.to_target);
      else
        path.split(h / 2, s.to_target ^ 1U, s.to_source);
    return s;
  }

private:
  std::vector<Path_record> paths_{1};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_GROWING_PATHS_H
