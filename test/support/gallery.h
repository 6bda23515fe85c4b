// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_GALLERY_H
#define TEST_INTRINSIC_TRIANGULATIONS_GALLERY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Delta-complexes that break code for simplicial complexes, with known properties of each.

namespace gallery {

using CGAL::Intrinsic_triangulations::Gluing;
using CGAL::Intrinsic_triangulations::Gluing_map;
using Point = std::array<double, 3>;

struct Counts {
  std::uint32_t vertices, edges, faces, boundary_loops;
  std::uint32_t components = 1, genus = 0, nonmanifold_vertices = 0, isolated_vertices = 0;
  bool is_orientable = true;
};

struct Surface {
  std::string name;
  Gluing gluing;
  Counts expected;
  std::vector<double> squared_length_of_side; // of each halfedge of the gluing
  std::vector<Point> points = {};             // one per vertex, if it lies in space

  std::ptrdiff_t euler_characteristic() const {
    return std::ptrdiff_t{expected.vertices} - std::ptrdiff_t{expected.edges} +
           std::ptrdiff_t{expected.faces};
  }
  friend std::ostream& operator<<(std::ostream& out, const Surface& s) { return out << s.name; }
};

struct Glued {
  std::uint32_t first, second;
  bool reversed = false;
};

/// Glues sides of faces; vertices are what the gluings make of the corners.
Gluing glue(std::uint32_t faces, const std::vector<Glued>& pairs);

/// A triangulation in space.
Surface embedded(const std::string& name, std::vector<Point> points,
                 const std::vector<std::array<std::uint32_t, 3>>& triangles,
                 const Counts& expected);

/// An abstract surface of faces with the same three squared lengths.
Surface abstract(const std::string& name, Gluing g, const Counts& expected,
                 const std::array<double, 3>& sides = {1, 1, 1});

/// Squared lengths per edge of `Gluing_map(s.gluing)`.
std::vector<double> squared_lengths(const Surface& s);

/// A surface by its lengths, with its numbers.
inline CGAL::Intrinsic_triangulations::Intrinsic_input input(const Surface& s) {
  using namespace CGAL::Intrinsic_triangulations;
  Intrinsic_input result(Gluing_map(s.gluing), squared_lengths(s), Mollification::none);
  result.may_renumber = false;
  return result;
}

// ---- closed and orientable

/// The unit square with opposite sides glued.
Surface one_vertex_torus();

/// n times m unit squares, each cut by a diagonal.
Surface flat_torus(std::uint32_t n, std::uint32_t m);

/// A sphere: the two sides of one triangle.
Surface triangle_pillow();

Surface tetrahedron();

/// A tetrahedron over an equilateral triangle whose other edges are shorter than its circumradius,
/// 0.577: all triangle inequalities hold, and it embeds nowhere.
Surface tetrahedron_that_embeds_nowhere();

/// Two self-folded triangles glued along their loops.
Surface doubled_self_folded_cone();

/// A regular octagon in the unit circle, glued by a b a^-1 b^-1 c d c^-1 d^-1.
Surface octagon_of_genus_2();

// ---- with a border

Surface triangle();

/// One triangle with two sides glued: a cone, whose border is a loop.
Surface self_folded_cone();

/// A self-folded triangle inside a bordered one.
Surface self_folded_in_a_digon();

Surface two_triangles_sharing_two_edges();

Surface disc_fan(std::uint32_t n);

Surface annulus(std::uint32_t n);

// ---- not orientable

Surface moebius_strip(std::uint32_t n);

/// Two sides of one triangle, glued along their direction.
Surface moebius_triangle();

Surface klein_bottle();

Surface projective_plane();

// ---- with nonmanifold or isolated vertices

Surface two_tetrahedra_sharing_a_vertex();

Surface bow_tie();

/// Two fans on the same centre, with an isolated vertex between them in the numbering.
Surface two_fans_and_an_isolated_vertex();

/// The whole gallery.
std::vector<Surface> all();

/// Those whose gluings respect the orientation, so that meshes with halfedges can represent them.
std::vector<Surface> oriented();

} // namespace gallery

#ifndef TEST_MESHES_COMPILED
#include "gallery_impl.h"
#endif

#endif // TEST_INTRINSIC_TRIANGULATIONS_GALLERY_H
