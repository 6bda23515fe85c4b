// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_POLYHEDRON_3_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_POLYHEDRON_3_ADAPTOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief numbers the elements of a `CGAL::Polyhedron_3` in the order of its lists.

A polyhedron with ids (`CGAL::Polyhedron_items_with_id_3`) that may be changed has its ids set and
is read by them; any other polyhedron is numbered in hash maps, which are slow for flips but good
for reading.
*/
template <class K, class I, template <class T1, class T2, class T3> class HDS, class A>
class Mesh_adaptor<Polyhedron_3<K, I, HDS, A>>
    : public Indexed_mesh_adaptor<Polyhedron_3<K, I, HDS, A>> {
  using Mesh = Polyhedron_3<K, I, HDS, A>;
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  static constexpr bool has_ids = requires(Vertex v, Halfedge h, Face f) {
    v->id(), h->id(), f->id();
  };

public:
  /// \cond see the primary template
  explicit Mesh_adaptor(const Mesh& mesh) { number(mesh); }

  explicit Mesh_adaptor(Mesh& mesh) {
    use_ids_ = has_ids;
    number(mesh);
  }

  // numbers are not in the order of lists any more after removals; elements that were moved to
  // `copy` keep theirs
  Mesh_adaptor(Mesh& copy, const Mesh_adaptor& numbers, const Mesh& original) {
    if (copy.size_of_vertices() != original.size_of_vertices()) {
      *this = numbers;
      return;
    }
    use_ids_ = has_ids;
    renumber(CGAL::vertices(copy), vertices_, CGAL::vertices(original), numbers, numbers.vertices_);
    renumber(CGAL::halfedges(copy), halfedges_, CGAL::halfedges(original), numbers,
             numbers.halfedges_);
    renumber(CGAL::faces(copy), faces_, CGAL::faces(original), numbers, numbers.faces_);
  }

  std::uint32_t vertex(Vertex v) const { return find(v, vertices_); }
  std::uint32_t halfedge(Halfedge h) const { return find(h, halfedges_); }
  std::uint32_t face(Face f) const { return find(f, faces_); }

  Vertex vertex_at(std::uint32_t i) const { return vertices_.elements[i]; }
  Halfedge halfedge_at(std::uint32_t i) const { return halfedges_.elements[i]; }
  Face face_at(std::uint32_t i) const { return faces_.elements[i]; }

  // The elements themselves are allocated one by one: that may fail later, which ends the program.
  void make_room(Mesh&) {
    make_room(1, vertices_);
    make_room(6, halfedges_);
    make_room(2, faces_);
  }
  void add(Vertex v, const Mesh&) { add(v, vertices_); }
  void add(Edge e, const Mesh& mesh) {
    Halfedge h = CGAL::halfedge(e, mesh);
    if (!halfedges_.free.empty()) h = h->opposite(); // the side that was freed last is the odd one
    add(h, halfedges_);
    add(h->opposite(), halfedges_);
  }
  void add(Face f, const Mesh&) { add(f, faces_); }
  void remove(Vertex v, const Mesh&) { remove(v, vertices_); }
  void remove(Edge e, const Mesh& mesh) {
    Halfedge h = CGAL::halfedge(e, mesh);
    if (halfedge(h) % 2 != 0) h = h->opposite();
    remove(h, halfedges_);
    remove(h->opposite(), halfedges_);
  }
  void remove(Face f, const Mesh&) { remove(f, faces_); }

  std::uint32_t vertex_capacity(const Mesh&) const { return capacity(vertices_); }
  std::uint32_t edge_capacity(const Mesh&) const { return capacity(halfedges_) / 2; }
  std::uint32_t face_capacity(const Mesh&) const { return capacity(faces_); }
  /// \endcond

private:
  template <class Descriptor>
  struct Numbering {
    std::vector<Descriptor> elements;                      // by number
    std::vector<std::uint32_t> free;                       // numbers without an element
    std::unordered_map<const void*, std::uint32_t> number; // unless elements have ids
  };

  template <class Descriptor>
  static void make_room(std::size_t count, Numbering<Descriptor>& n) {
    reserve_at_least(n.elements, n.elements.size() + count);
    reserve_at_least(n.free, n.free.size() + count);
  }

  void number(const Mesh& mesh) {
    for (const Vertex v : CGAL::vertices(mesh)) add(v, vertices_);
    for (const Edge e : CGAL::edges(mesh)) add(e, mesh);
    for (const Face f : CGAL::faces(mesh)) add(f, faces_);
  }

  template <class Descriptor>
  static std::uint32_t capacity(const Numbering<Descriptor>& n) {
    return static_cast<std::uint32_t>(n.elements.size());
  }

  // copies of elements come in the same order as the elements
  template <class Range, class ConstRange, class Descriptor>
  void renumber(const Range& copies, Numbering<Descriptor>& n, const ConstRange& originals,
                const Mesh_adaptor& numbers, const Numbering<Descriptor>& original_numbers) {
    n.elements.resize(original_numbers.elements.size());
    n.free = original_numbers.free;
    auto original = originals.begin();
    for (const Descriptor d : copies)
      assign(d, numbers.find(Descriptor(*original++), original_numbers), n);
  }

  template <class Descriptor>
  void add(Descriptor d, Numbering<Descriptor>& n) {
    std::uint32_t i = capacity(n);
    if (n.free.empty()) {
      n.elements.emplace_back();
    } else {
      i = n.free.back();
      n.free.pop_back();
    }
    assign(d, i, n);
  }

  template <class Descriptor>
  void assign(Descriptor d, std::uint32_t i, Numbering<Descriptor>& n) {
    n.elements[i] = d;
    if constexpr (has_ids)
      if (use_ids_) {
        d->id() = i;
        return;
      }
    n.number[&*d] = i;
  }

  template <class Descriptor>
  void remove(Descriptor d, Numbering<Descriptor>& n) {
    n.free.push_back(find(d, n));
    n.number.erase(&*d);
  }

  template <class Descriptor>
  std::uint32_t find(Descriptor d, const Numbering<Descriptor>& n) const {
    if constexpr (has_ids)
      if (use_ids_) return static_cast<std::uint32_t>(d->id());
    return n.number.at(&*d);
  }

  bool use_ids_ = false;
  Numbering<Vertex> vertices_;
  Numbering<Halfedge> halfedges_;
  Numbering<Face> faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_POLYHEDRON_3_ADAPTOR_H
