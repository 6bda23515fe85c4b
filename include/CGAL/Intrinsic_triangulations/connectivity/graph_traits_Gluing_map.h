// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GRAPH_TRAITS_GLUING_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GRAPH_TRAITS_GLUING_MAP_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>

/*!
\file
The functions of BGL's `MutableFaceGraph` for `Gluing_map`, found by argument-dependent lookup.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Iterates over all elements of one kind.
template <class Descriptor>
class Gluing_iterator
    : public boost::iterator_facade<Gluing_iterator<Descriptor>, Descriptor,
                                    std::bidirectional_iterator_tag, Descriptor, std::ptrdiff_t> {
public:
  Gluing_iterator() = default;
  // at the first element of `map` from number `i` on that is not removed
  Gluing_iterator(const Gluing_map& map, std::uint32_t i, std::uint32_t end)
      : map_(map.has_garbage() ? &map : nullptr), end_(end), current_{i} {
    skip();
  }

private:
  friend class boost::iterator_core_access;
  Descriptor dereference() const { return current_; }
  bool equal(const Gluing_iterator& o) const { return current_ == o.current_; }
  void increment() {
    ++current_.index;
    skip();
  }
  void decrement() {
    do --current_.index;
    while (map_ != nullptr && map_->is_removed(current_));
  }
  void skip() {
    while (map_ != nullptr && current_.index < end_ && map_->is_removed(current_)) ++current_.index;
  }

  const Gluing_map* map_ = nullptr; // null if no element is skipped
  std::uint32_t end_ = 0;
  Descriptor current_;
};

// Maps an element to its number.
template <class Descriptor>
struct Gluing_index_map {
  using key_type = Descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;
  friend std::size_t get(const Gluing_index_map&, Descriptor d) { return d.index; }
  std::size_t operator[](Descriptor d) const { return d.index; }
};

} // namespace internal

/// \cond the BGL vocabulary, specified by CGAL and Boost
inline Gluing_map::Halfedge next(Gluing_map::Halfedge h, const Gluing_map& g) { return g.next(h); }
inline Gluing_map::Halfedge prev(Gluing_map::Halfedge h, const Gluing_map& g) {
  return g.previous(h);
}
inline Gluing_map::Halfedge opposite(Gluing_map::Halfedge h, const Gluing_map&) {
  return Gluing_map::opposite(h);
}
inline Gluing_map::Vertex target(Gluing_map::Halfedge h, const Gluing_map& g) {
  return g.target(h);
}
inline Gluing_map::Vertex source(Gluing_map::Halfedge h, const Gluing_map& g) {
  return g.source(h);
}
inline Gluing_map::Vertex target(Gluing_map::Edge e, const Gluing_map& g) {
  return g.target({2 * e.index});
}
inline Gluing_map::Vertex source(Gluing_map::Edge e, const Gluing_map& g) {
  return g.source({2 * e.index});
}
inline Gluing_map::Face face(Gluing_map::Halfedge h, const Gluing_map& g) { return g.face(h); }
inline Gluing_map::Edge edge(Gluing_map::Halfedge h, const Gluing_map&) { return {h.index / 2}; }
inline Gluing_map::Halfedge halfedge(Gluing_map::Edge e, const Gluing_map&) {
  return {2 * e.index};
}
inline Gluing_map::Halfedge halfedge(Gluing_map::Vertex v, const Gluing_map& g) {
  return g.halfedge(v);
}
inline Gluing_map::Halfedge halfedge(Gluing_map::Face f, const Gluing_map& g) {
  return g.halfedge(f);
}

template <class Descriptor>
auto gluing_range(const Gluing_map& g, std::uint32_t n) {
  using I = internal::Gluing_iterator<Descriptor>;
  return CGAL::Iterator_range<I>(I(g, 0, n), I(g, n, n));
}
inline auto vertices(const Gluing_map& g) {
  return gluing_range<Gluing_map::Vertex>(g, g.number_of_vertices());
}
inline auto halfedges(const Gluing_map& g) {
  return gluing_range<Gluing_map::Halfedge>(g, g.number_of_halfedges());
}
inline auto edges(const Gluing_map& g) {
  return gluing_range<Gluing_map::Edge>(g, g.number_of_edges());
}
inline auto faces(const Gluing_map& g) {
  return gluing_range<Gluing_map::Face>(g, g.number_of_faces());
}
inline std::size_t num_vertices(const Gluing_map& g) { return g.number_of_vertices(); }
inline std::size_t num_halfedges(const Gluing_map& g) { return g.number_of_halfedges(); }
inline std::size_t num_edges(const Gluing_map& g) { return g.number_of_edges(); }
inline std::size_t num_faces(const Gluing_map& g) { return g.number_of_faces(); }

inline void set_next(Gluing_map::Halfedge h, Gluing_map::Halfedge n, Gluing_map& g) {
  g.set_next(h, n);
}
inline void set_target(Gluing_map::Halfedge h, Gluing_map::Vertex v, Gluing_map& g) {
  g.set_target(h, v);
}
inline void set_face(Gluing_map::Halfedge h, Gluing_map::Face f, Gluing_map& g) {
  g.set_face(h, f);
}
inline void set_halfedge(Gluing_map::Vertex v, Gluing_map::Halfedge h, Gluing_map& g) {
  g.set_halfedge(v, h);
}
inline void set_halfedge(Gluing_map::Face f, Gluing_map::Halfedge h, Gluing_map& g) {
  g.set_halfedge(f, h);
}
inline Gluing_map::Vertex add_vertex(Gluing_map& g) { return g.add_vertex(); }
inline Gluing_map::Edge add_edge(Gluing_map& g) { return g.add_edge(); }
inline Gluing_map::Face add_face(Gluing_map& g) { return g.add_face(); }
inline void remove_vertex(Gluing_map::Vertex v, Gluing_map& g) { g.remove_vertex(v); }
inline void remove_edge(Gluing_map::Edge e, Gluing_map& g) { g.remove_edge(e); }
inline void remove_face(Gluing_map::Face f, Gluing_map& g) { g.remove_face(f); }

inline internal::Gluing_index_map<Gluing_map::Vertex> get(boost::vertex_index_t,
                                                          const Gluing_map&) {
  return {};
}
inline internal::Gluing_index_map<Gluing_map::Halfedge> get(boost::halfedge_index_t,
                                                            const Gluing_map&) {
  return {};
}
inline internal::Gluing_index_map<Gluing_map::Edge> get(boost::edge_index_t, const Gluing_map&) {
  return {};
}
inline internal::Gluing_index_map<Gluing_map::Face> get(boost::face_index_t, const Gluing_map&) {
  return {};
}
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

/// \cond
namespace boost {

template <>
struct graph_traits<CGAL::Intrinsic_triangulations::Gluing_map> {
private:
  using Map = CGAL::Intrinsic_triangulations::Gluing_map;
  template <class D>
  using Iterator = CGAL::Intrinsic_triangulations::internal::Gluing_iterator<D>;
  struct Category : bidirectional_graph_tag, vertex_list_graph_tag, edge_list_graph_tag {};

public:
  using vertex_descriptor = Map::Vertex;
  using halfedge_descriptor = Map::Halfedge;
  using edge_descriptor = Map::Edge;
  using face_descriptor = Map::Face;
  using vertex_iterator = Iterator<vertex_descriptor>;
  using halfedge_iterator = Iterator<halfedge_descriptor>;
  using edge_iterator = Iterator<edge_descriptor>;
  using face_iterator = Iterator<face_descriptor>;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using directed_category = undirected_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  using traversal_category = Category;
  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct graph_traits<const CGAL::Intrinsic_triangulations::Gluing_map>
    : graph_traits<CGAL::Intrinsic_triangulations::Gluing_map> {};

template <class Tag>
  requires(std::is_same_v<Tag, vertex_index_t> || std::is_same_v<Tag, halfedge_index_t> ||
           std::is_same_v<Tag, edge_index_t> || std::is_same_v<Tag, face_index_t>)
struct property_map<CGAL::Intrinsic_triangulations::Gluing_map, Tag> {
  using type = decltype(get(Tag(), CGAL::Intrinsic_triangulations::Gluing_map()));
  using const_type = type;
};

} // namespace boost

template <class Tag>
struct std::hash<CGAL::Intrinsic_triangulations::Gluing_descriptor<Tag>> {
  std::size_t
  operator()(const CGAL::Intrinsic_triangulations::Gluing_descriptor<Tag>& d) const noexcept {
    return d.index;
  }
};
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GRAPH_TRAITS_GLUING_MAP_H
