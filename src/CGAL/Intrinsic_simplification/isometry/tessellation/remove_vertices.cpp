// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Moved_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Repartition.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/remove_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/flip_away.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The edges at a vertex, see `Flat_vertex_removal`. Ears of one plane go before: a vertex on a
// crease leaves faces of planes, without new roots.
class Moved_star {
public:
  using Halfedge = Gluing_map::Halfedge;
  using Vertex = Gluing_map::Vertex;

  Moved_star(Moved_triangulation& t, Vertex v)
      : t_(t), mesh_(t.mesh()), v_(v),
        is_on_border_(mesh_.face(mesh_.halfedge(v)).index == Gluing::none) {}

  const std::vector<Halfedge>& find_edges() {
    edges_.clear();
    for_each_outgoing(v_, mesh_, [this](Halfedge h) { edges_.push_back(h); });
    return edges_;
  }
  std::array<bool, 3> are_here(Halfedge h) const {
    const auto is_v = [this](Halfedge x) { return mesh_.target(x).index == v_.index; };
    return {is_v(h), is_v(mesh_.next(h)), is_v(mesh_.next(Gluing_map::opposite(h)))};
  }
  bool is_in_two_faces(Halfedge h) const { return t_.has_diamond(h); }
  Ear_rank rank(Halfedge h) const {
    const Diamond_values<double> d = t_.approximate(h);
    const double area = flipped(d).area_f;
    return {t_.is_in_one_frame(h),
            area > 0 ? -Delaunay_expression()(d) / area : -std::numeric_limits<double>::infinity()};
  }
  bool flip(Halfedge h, bool is_last) {
    const auto d = t_.diamond(h);
    if (t_.sign(d, Convexity_at_target_expression()) != POSITIVE) return false;
    const Sign s = t_.sign(d, Convexity_at_source_expression());
    if (s == NEGATIVE || (s == ZERO && (!is_last || is_on_border_))) return false;
    t_.flip(h);
    return true;
  }
  void take_out() {
    if (is_on_border_)
      t_.remove_border_vertex(border_halfedge());
    else
      t_.remove_inner_vertex(mesh_.next(edges_.front()));
  }

private:
  // the halfedge of a face that ends at the vertex and runs along the border
  Halfedge border_halfedge() const {
    for (const Halfedge h : edges_)
      if (mesh_.face(h).index == Gluing::none) return Gluing_map::opposite(h);
    return edges_.front();
  }

  Moved_triangulation& t_;
  const Gluing_map& mesh_;
  Vertex v_;
  bool is_on_border_;
  std::vector<Halfedge> edges_;
};

bool remove_vertex(Moved_triangulation& t, Gluing_map::Vertex v) {
  expect_to_go_on();
  Moved_star star(t, v);
  return Flat_vertex_removal(star).run();
}

// Flips edges, given by their numbers, and those of the faces that this makes.
// \throws Undecidable also if the triangulation has taken more than so many moves
void flip_to_delaunay(Moved_triangulation& t, std::vector<std::uint32_t> stack,
                      std::size_t most_moves) {
  const Gluing_map& mesh = t.mesh();
  while (!stack.empty()) {
    const Gluing_map::Halfedge h{2 * stack.back()};
    stack.pop_back();
    if (mesh.is_removed(h) || !t.has_diamond(h)) continue;
    expect_to_go_on();
    if (t.sign(t.diamond(h), Delaunay_expression()) != NEGATIVE) continue;
    if (t.moves().size() >= most_moves) throw Undecidable("flips are too many");
    t.flip(h);
    for (const Gluing_map::Halfedge s : {h, Gluing_map::opposite(h)})
      for (Gluing_map::Halfedge n = mesh.next(s); n != s; n = mesh.next(n))
        stack.push_back(n.index / 2);
  }
}

// Flips the edges of faces that moves have made, from a move on.
void flip_to_delaunay(Moved_triangulation& t, std::size_t first_move) {
  std::vector<std::uint32_t> stack;
  for (std::size_t n = first_move; n < t.moves().size(); ++n)
    for (const Moved_face& f : t.moves()[n].after)
      for (const std::uint32_t h : f.sides) stack.push_back(h / 2);
  flip_to_delaunay(t, std::move(stack), std::numeric_limits<std::size_t>::max());
}

// The vertices that edges join to one, among those to be removed; none of them
// is found again.
std::vector<Gluing_map::Vertex> cluster_of(Gluing_map::Vertex v, const Gluing_map& mesh,
                                           std::vector<char>& are_left) {
  std::vector<Gluing_map::Vertex> cluster{v};
  are_left[v.index] = 0;
  for (std::size_t i = 0; i < cluster.size(); ++i)
    for_each_outgoing(cluster[i], mesh, [&](Gluing_map::Halfedge h) {
      const Gluing_map::Vertex w = mesh.target(h);
      if (std::exchange(are_left[w.index], 0) != 0) cluster.push_back(w);
    });
  return cluster;
}

} // namespace

// Vertices of one plane follow each other, so that few square roots are needed
// at a time. In random order, values follow from each other in few steps.
void remove_vertices(Moved_triangulation& t, const std::vector<char>& are_removed,
                     bool stays_delaunay) {
  t.lay_out_planes(are_removed);
  std::vector<char> are_left = are_removed;
  std::vector<Gluing_map::Vertex> others;
  std::mt19937 random;
  const auto remove = [&](Gluing_map::Vertex v) { return remove_vertex(t, v); };
  for (std::uint32_t v = 0; v < are_left.size(); ++v) {
    if (are_left[v] == 0 || t.mesh().halfedge(Gluing_map::Vertex{v}).index == Gluing::none)
      continue;
    std::vector<Gluing_map::Vertex> cluster = cluster_of(Gluing_map::Vertex{v}, t.mesh(), are_left);
    std::shuffle(cluster.begin(), cluster.end(), random);
    const std::size_t first_move = t.moves().size();
    while (std::erase_if(cluster, remove) > 0) {
    }
    if (stays_delaunay) flip_to_delaunay(t, first_move);
    others.insert(others.end(), cluster.begin(), cluster.end());
  }
  // flips that failed may block others; those to Delaunay undo them
  std::size_t first_move = t.moves().size();
  const auto restore = [&] {
    flip_to_delaunay(t, first_move);
    first_move = t.moves().size();
  };
  if (!remove_in_rounds(others, remove, restore))
    throw Undecidable("flips could not remove a flat vertex");
}

void make_delaunay(Moved_triangulation& t, std::size_t most_moves) {
  std::vector<std::uint32_t> all(t.mesh().number_of_edges());
  std::iota(all.begin(), all.end(), 0U);
  flip_to_delaunay(t, std::move(all), most_moves);
}

} // namespace CGAL::Intrinsic_triangulations::internal
