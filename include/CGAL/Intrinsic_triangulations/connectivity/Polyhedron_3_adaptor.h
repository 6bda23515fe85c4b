// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POLYHEDRON_3_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POLYHEDRON_3_ADAPTOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/Mesh_adaptor.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <array>
#include <cstdint>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief numbers the elements of a `CGAL::Polyhedron_3` in the order of its lists.

A polyhedron with ids (`CGAL::Polyhedron_items_with_id_3`) that may be changed has its ids set and
is read by them; any other polyhedron is numbered in hash maps, which makes it a slow mesh to flip in
but a good one to read from.
*/
template <class K, class I, template <class T1, class T2, class T3> class HDS, class A>
class Mesh_adaptor<Polyhedron_3<K, I, HDS, A>> {
  using Mesh = Polyhedron_3<K, I, HDS, A>;
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;
  static constexpr bool has_ids = requires(Vertex v, Halfedge h, Face f) {
    v->id(), h->id(), f->id();
  };

public:
  /// numbers the elements of `mesh`.
  explicit Mesh_adaptor(const Mesh& mesh) {
    number(vertices(mesh), vertex_);
    number(halfedges(mesh), halfedge_);
    number(faces(mesh), face_);
  }

  /// numbers the elements of a mesh that the caller may change.
  explicit Mesh_adaptor(Mesh& mesh) {
    if constexpr (has_ids) {
      set_ids(vertices(mesh));
      set_ids(halfedges(mesh));
      set_ids(faces(mesh));
      use_ids_ = true;
    } else
      *this = Mesh_adaptor(static_cast<const Mesh&>(mesh));
  }

  /// returns the number of a vertex.
  std::uint32_t vertex(Vertex v) const { return find(v, vertex_); }
  /// returns the number of a halfedge.
  std::uint32_t halfedge(Halfedge h) const { return find(h, halfedge_); }
  /// returns the number of a face.
  std::uint32_t face(Face f) const { return find(f, face_); }

  /// reads the coordinates of a point as doubles.
  template <class Point>
  static std::array<double, 3> coordinates(const Point& p) {
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  /// returns the point map that `mesh` itself has.
  static auto point_map(const Mesh& mesh) { return get(CGAL::vertex_point, mesh); }

private:
  using Numbers = std::unordered_map<const void*, std::uint32_t>;

  template <class Range>
  static void number(const Range& range, Numbers& numbers) {
    for (auto d : range) numbers.emplace(&*d, static_cast<std::uint32_t>(numbers.size()));
  }

  template <class Range>
  static void set_ids(const Range& range) {
    std::size_t i = 0;
    for (auto d : range) d->id() = i++;
  }

  template <class Descriptor>
  std::uint32_t find(Descriptor d, const Numbers& numbers) const {
    if constexpr (has_ids)
      if (use_ids_) return static_cast<std::uint32_t>(d->id());
    return numbers.at(&*d);
  }

  bool use_ids_ = false;
  Numbers vertex_, halfedge_, face_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POLYHEDRON_3_ADAPTOR_H
