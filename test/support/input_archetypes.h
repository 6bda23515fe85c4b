// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_INPUT_ARCHETYPES_H
#define TEST_INTRINSIC_TRIANGULATIONS_INPUT_ARCHETYPES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// Ranges, meshes and functors that offer what a concept of inputs asks for and nothing else.

namespace archetypes {

namespace IT = CGAL::Intrinsic_triangulations;

/// Converts to a number, and does nothing else.
struct Converts_to_number {
  operator std::int64_t() const { return value; }
  std::int64_t value;
};

/// A point with three members.
class Point_in_space {
public:
  Point_in_space(double x, double y, double z) : x_(x), y_(y), z_(z) {}
  double x() const { return x_; }
  double y() const { return y_; }
  double z() const { return z_; }

private:
  double x_, y_, z_;
};

/// A model of `PointRange`, and with ranges of numbers of `FaceRange`.
template <class T>
class Range {
public:
  explicit Range(std::vector<T> values) : values_(std::move(values)) {}
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

private:
  std::vector<T> values_;
};

/// Three numbers.
class Triple {
public:
  explicit Triple(const std::array<short, 3>& t) : t_(t) {}
  short operator[](std::size_t k) const { return t_[k]; }

private:
  std::array<short, 3> t_;
};

/// A model of `TriangleRange`.
class Triangles : public Range<Triple> {
public:
  using Range::Range;
  std::size_t size() const { return static_cast<std::size_t>(end() - begin()); }
};

/// A model of `ReadableFaceGraph`: hides the rest of a `Gluing_map`.
class Readable_mesh {
public:
  explicit Readable_mesh(const IT::Gluing_map& map = {}) : map_(map) {}

  friend auto vertices(const Readable_mesh& m) { return vertices(m.map_); }
  friend auto halfedges(const Readable_mesh& m) { return halfedges(m.map_); }
  friend auto edges(const Readable_mesh& m) { return edges(m.map_); }
  friend auto faces(const Readable_mesh& m) { return faces(m.map_); }
  friend auto num_vertices(const Readable_mesh& m) { return num_vertices(m.map_); }
  friend auto num_edges(const Readable_mesh& m) { return num_edges(m.map_); }
  friend auto num_faces(const Readable_mesh& m) { return num_faces(m.map_); }
  friend auto next(IT::Gluing_map::Halfedge h, const Readable_mesh& m) { return next(h, m.map_); }
  friend auto opposite(IT::Gluing_map::Halfedge h, const Readable_mesh& m) {
    return opposite(h, m.map_);
  }
  friend auto source(IT::Gluing_map::Halfedge h, const Readable_mesh& m) {
    return source(h, m.map_);
  }
  friend auto target(IT::Gluing_map::Halfedge h, const Readable_mesh& m) {
    return target(h, m.map_);
  }
  friend auto face(IT::Gluing_map::Halfedge h, const Readable_mesh& m) { return face(h, m.map_); }
  friend auto edge(IT::Gluing_map::Halfedge h, const Readable_mesh& m) { return edge(h, m.map_); }
  friend auto halfedge(IT::Gluing_map::Vertex x, const Readable_mesh& m) {
    return halfedge(x, m.map_);
  }
  friend auto halfedge(IT::Gluing_map::Edge x, const Readable_mesh& m) {
    return halfedge(x, m.map_);
  }
  friend auto halfedge(IT::Gluing_map::Face x, const Readable_mesh& m) {
    return halfedge(x, m.map_);
  }

protected:
  IT::Gluing_map map_;
};

/// A model of `WritableFaceGraph`.
class Writable_mesh : public Readable_mesh {
public:
  friend auto add_vertex(Writable_mesh& m) { return add_vertex(m.map_); }
  friend auto add_edge(Writable_mesh& m) { return add_edge(m.map_); }
  friend auto add_face(Writable_mesh& m) { return add_face(m.map_); }
  friend void remove_vertex(IT::Gluing_map::Vertex x, Writable_mesh& m) {
    remove_vertex(x, m.map_);
  }
  friend void remove_edge(IT::Gluing_map::Edge x, Writable_mesh& m) { remove_edge(x, m.map_); }
  friend void remove_face(IT::Gluing_map::Face x, Writable_mesh& m) { remove_face(x, m.map_); }
  friend void set_next(IT::Gluing_map::Halfedge x, IT::Gluing_map::Halfedge y, Writable_mesh& m) {
    set_next(x, y, m.map_);
  }
  friend void set_target(IT::Gluing_map::Halfedge x, IT::Gluing_map::Vertex y, Writable_mesh& m) {
    set_target(x, y, m.map_);
  }
  friend void set_face(IT::Gluing_map::Halfedge x, IT::Gluing_map::Face y, Writable_mesh& m) {
    set_face(x, y, m.map_);
  }
  friend void set_halfedge(IT::Gluing_map::Vertex x, IT::Gluing_map::Halfedge y, Writable_mesh& m) {
    set_halfedge(x, y, m.map_);
  }
  friend void set_halfedge(IT::Gluing_map::Face x, IT::Gluing_map::Halfedge y, Writable_mesh& m) {
    set_halfedge(x, y, m.map_);
  }
};

/// A model of `VertexFactors` and of `FaceNorm`: the same number everywhere.
struct Vertex_factors {
  float operator()(IT::Gluing_map::Vertex) const { return 0.5F; }
};
struct Face_norm {
  template <class Vector>
  float operator()(IT::Gluing_map::Face, const Vector&) const {
    return 1;
  }
};

/// A model of `NumberedTriangles`: the faces of a `Gluing_map`.
struct Numbered_triangles {
  std::uint32_t next(std::uint32_t h) const { return map.next({h}).index; }
  const IT::Gluing_map& map;
};

/// A model of `NormalCoordinates`.
struct Normal_coordinates {
  IT::Normal_coordinate normal_coordinate(std::uint32_t e) const { return n[e]; }
  std::vector<IT::Normal_coordinate> n;
};

} // namespace archetypes

template <>
struct boost::graph_traits<archetypes::Readable_mesh>
    : boost::graph_traits<CGAL::Intrinsic_triangulations::Gluing_map> {};
template <>
struct boost::graph_traits<archetypes::Writable_mesh>
    : boost::graph_traits<CGAL::Intrinsic_triangulations::Gluing_map> {};

namespace archetypes {

/// Numbers of the elements.
template <class Mesh>
class Numbers_of_mesh : public CGAL::Intrinsic_triangulations::Indexed_mesh_adaptor<Mesh> {
  using Map = CGAL::Intrinsic_triangulations::Gluing_map;

public:
  explicit Numbers_of_mesh(const Mesh&) {}
  static std::uint32_t vertex(Map::Vertex v) { return v.index; }
  static std::uint32_t halfedge(Map::Halfedge h) { return h.index; }
  static std::uint32_t face(Map::Face f) { return f.index; }
};

} // namespace archetypes

template <>
class CGAL::Intrinsic_triangulations::Mesh_adaptor<archetypes::Readable_mesh>
    : public archetypes::Numbers_of_mesh<archetypes::Readable_mesh> {
public:
  using Numbers_of_mesh::Numbers_of_mesh;
};

#endif // TEST_INTRINSIC_TRIANGULATIONS_INPUT_ARCHETYPES_H
