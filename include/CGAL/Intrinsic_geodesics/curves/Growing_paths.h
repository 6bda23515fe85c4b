// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_GROWING_PATHS_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_GROWING_PATHS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Paths of edges, one after the other, whose edges are split where later ones cross them. The
// last one grows.
template <class Triangulation>
class Growing_paths {
  using Path = std::list<std::uint32_t>; // of halfedges

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
    for (const std::uint32_t h : paths_[i]) result.push_back(t.numbers().halfedge_at(h));
    return result;
  }
  std::uint32_t last() const { return paths_.back().back(); }
  bool has_edge(std::uint32_t e) const { return at_.count(e) != 0; }

  void begin() { paths_.emplace_back(); }
  void append(std::uint32_t h) { insert(paths_.size() - 1, paths_.back().end(), h); }

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
      // h is in between if the edge has this face on both sides
      if (s.to_apex / 2 == h / 2) s.to_apex = next_around_source(view, s.to_apex);
    }
    if (h % 2 == 0)
      replace(h / 2, s.to_source ^ 1U, s.to_target);
    else
      replace(h / 2, s.to_target ^ 1U, s.to_source);
    return s;
  }

private:
  // where an edge is in a path
  struct Place {
    std::size_t path;
    Path::iterator at;
  };

  void insert(std::size_t path, Path::iterator before, std::uint32_t h) {
    at_.emplace(h / 2, Place{path, paths_[path].insert(before, h)});
  }

  // `first` and `second` lead from the source of halfedge 2 e to its target.
  void replace(std::uint32_t e, std::uint32_t first, std::uint32_t second) {
    std::vector<Place> along;
    const auto [begin, end] = at_.equal_range(e);
    for (auto i = begin; i != end; ++i) along.push_back(i->second);
    at_.erase(begin, end);
    for (const auto& [path, at] : along) {
      const bool is_forward = *at % 2 == 0;
      insert(path, at, is_forward ? first : second ^ 1U);
      insert(path, at, is_forward ? second : first ^ 1U);
      paths_[path].erase(at);
    }
  }

  std::vector<Path> paths_{1};
  std::unordered_multimap<std::uint32_t, Place> at_; // by edge
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_GROWING_PATHS_H
