// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "gallery.h"
#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::defect;
using subdivision_oracle::Exact;
using subdivision_oracle::Mover;
using subdivision_oracle::Plane;
using subdivision_oracle::Rounded;
using subdivision_oracle::state;

static_assert(IT::IntrinsicCorrespondence<IT::Integer_coordinates, Exact>);
static_assert(IT::IntrinsicCorrespondence<IT::Integer_coordinates, Rounded>);

std::vector<std::pair<std::string, meshes::Mesh>> planar() {
  return {{"grid", meshes::grid(3, 3)},
          {"sheared grid", meshes::sheared_grid(3, 3, 5)},
          {"parabola", meshes::parabola_fan(8)},
          {"random", meshes::random_planar(14, 30, 1)},
          {"coarse random", meshes::random_planar(14, 6, 2)}};
}

template <class T>
void expect_no_defect_on_gallery(bool with_vertices, int moves) {
  for (const gallery::Surface& s : gallery::oriented()) {
    T t(gallery::input(s));
    ASSERT_EQ(defect(t), "") << s.name;
    Mover<T> mover(t, 3);
    for (int i = 0; i < moves; ++i) {
      if (with_vertices)
        mover.move(true);
      else
        t.flip_edge({mover.halfedge(false)});
      if (i % 10 == 0 || i + 1 == moves) {
        ASSERT_EQ(defect(t), "") << s.name << ' ' << i;
      }
    }
  }
}

// ---- against a count in the plane

TEST(Integer_coordinates, Of_the_input_are_its_edges) {
  for (const auto& [name, mesh] : planar()) {
    const Plane<Exact> p(mesh);
    EXPECT_EQ(p.defect(), "") << name;
    EXPECT_EQ(defect(p.t), "") << name;
  }
}

TEST(Integer_coordinates, Count_the_crossings_in_the_plane_after_random_flips) {
  for (const auto& [name, mesh] : planar()) {
    Plane<Exact> p(mesh);
    Mover<Exact> mover(p.t, 1);
    for (int i = 0; i < 300; ++i) {
      p.t.flip_edge({mover.halfedge(false)});
      if (i % 10 == 0) {
        ASSERT_EQ(p.defect(), "") << name << ' ' << i;
      }
    }
    EXPECT_EQ(p.defect(), "") << name;
  }
}

TEST(Integer_coordinates, Count_the_crossings_in_the_plane_after_moves_of_vertices) {
  for (const auto& [name, mesh] : planar()) {
    Plane<Exact> p(mesh);
    Mover<Exact> mover(p.t, 2);
    for (int i = 0; i < 120; ++i) {
      mover.move(
          false, [&](std::uint32_t h, const auto& w) { return p.insert(h, w); },
          [&](IT::Gluing_map::Vertex v, std::uint32_t h, const auto& w) {
            return p.reposition(v, h, w);
          });
      if (i % 4 == 0) {
        ASSERT_EQ(p.defect(), "") << name << ' ' << i;
      }
      if (i % 4 == 0) {
        ASSERT_EQ(defect(p.t), "") << name << ' ' << i;
      }
    }
    EXPECT_GT(mover.statuses[0], 50) << name;
    EXPECT_LT(p.deviation, 0x1p-34) << name; // 2^-40 of the height of an input face, at most 64
  }
}

TEST(Integer_coordinates, Split_edges_where_input_edges_cross_them) {
  // middles of edges between lattice points lie on input edges, which cross at all angles
  Plane<Exact> p(meshes::sheared_grid(3, 3, 2));
  for (int round = 0; round < 2; ++round) {
    IT::flip_to_delaunay(p.t);
    std::vector<std::uint32_t> halfedges;
    for (const auto e : edges(p.t.mesh())) {
      const std::uint32_t h = 2 * p.t.index(e);
      halfedges.push_back(p.view().is_border(h) ? h ^ 1U : h);
    }
    int crossed = 0;
    for (const std::uint32_t h : halfedges) {
      crossed += p.t.correspondence().normal_coordinate(h / 2) > 0 ? 1 : 0;
      ASSERT_EQ(p.insert(h, {0.5, 0.5, 0}).status, IT::Move_status::done) << h;
    }
    EXPECT_GT(crossed, 10);
    EXPECT_EQ(p.defect(), "");
    EXPECT_EQ(defect(p.t), "");
  }
  EXPECT_LT(p.deviation, 0x1p-34);
}

TEST(Integer_coordinates, Count_the_crossings_where_vertices_lie_on_input_edges_inside_faces) {
  // the input has one diagonal of a square, the triangulation the other: its edge crosses the
  // diagonal at the middle, and later edges cross it at rational points
  Plane<Exact> p(meshes::grid(2, 2));
  for (const auto e : edges(p.t.mesh())) p.t.flip_edge(halfedge(e, p.t.mesh()));
  ASSERT_EQ(p.defect(), "");
  Mover<Exact> mover(p.t, 4);
  int on_edges = 0;
  for (int i = 0; i < 80; ++i) {
    const std::uint32_t h = mover.halfedge(false);
    // quarters: many of these points are on input edges
    const double a = 0.25 * mover.below(4),
                 b = 0.25 * mover.below(5 - static_cast<unsigned>(4 * a));
    const auto n = p.insert(h, {1 - a - b, a, b});
    if (n.status == IT::Move_status::done) {
      mover.inserted.push_back(n.vertex);
      const IT::Intrinsic_view<Exact> view(p.t);
      on_edges += p.t.correspondence().roundabout(view.outgoing_halfedge(p.t.index(n.vertex))) !=
                  subdivision_oracle::none;
    }
    ASSERT_EQ(p.defect(), "") << i;
    for (int k = 0; k < 5; ++k) p.t.flip_edge({mover.halfedge(false)});
    ASSERT_EQ(p.defect(), "") << i;
    if (mover.inserted.size() > 6) {
      const std::uint32_t k = mover.below(mover.inserted.size());
      if (p.t.remove_vertex(mover.inserted[k]) == IT::Move_status::done)
        mover.inserted.erase(mover.inserted.begin() + k);
      ASSERT_EQ(p.defect(), "") << i;
      ASSERT_EQ(defect(p.t), "") << i;
    }
  }
  EXPECT_GT(on_edges, 12);
}

// ---- on any surface

TEST(Integer_coordinates, Describe_curves_on_the_gallery_after_flips) {
  expect_no_defect_on_gallery<Exact>(false, 60);
  expect_no_defect_on_gallery<Rounded>(false, 60);
}

TEST(Integer_coordinates, Describe_curves_on_the_gallery_after_moves_of_vertices) {
  expect_no_defect_on_gallery<Exact>(true, 40);
}

TEST(Integer_coordinates, Describe_curves_on_the_gallery_after_moves_of_vertices_in_doubles) {
  expect_no_defect_on_gallery<Rounded>(true, 150);
}

TEST(Integer_coordinates, Describe_curves_after_a_thousand_moves_in_doubles_on_small_meshes) {
  for (const auto& [name, mesh] :
       {std::pair{"box", meshes::box(1, 1, 1)}, std::pair{"octahedron", meshes::sphere(0)},
        std::pair{"rough grid", meshes::rough_grid(3, 1)}}) {
    Rounded t(subdivision_oracle::input(mesh));
    Mover<Rounded> mover(t, 5);
    for (int i = 0; i < 1000; ++i) {
      mover.move(true);
      if (i % 20 == 0) {
        ASSERT_EQ(defect(t), "") << name << ' ' << i;
      }
    }
    EXPECT_EQ(defect(t), "") << name;
    RecordProperty(std::string(name) + " not removable", mover.statuses[8]);
  }
}

TEST(Integer_coordinates, Are_restored_by_four_flips) {
  for (const auto& [name, mesh] : {std::pair{"potato", meshes::potato(2, 1)},
                                   std::pair{"terrain", meshes::integer_terrain(40, 30, 2)}}) {
    Exact t(subdivision_oracle::input(mesh));
    Mover<Exact> mover(t, 6);
    for (int i = 0; i < 300; ++i) t.flip_edge({mover.halfedge(false)});
    const auto before = state(t);
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      if (t.flip_status(h) != IT::Move_status::done) continue;
      for (int i = 0; i < 4; ++i) ASSERT_EQ(t.flip_edge(h), IT::Move_status::done);
    }
    EXPECT_EQ(state(t), before) << name;
  }
}

TEST(Integer_coordinates, Are_restored_by_removing_what_was_inserted) {
  Exact t(subdivision_oracle::input(meshes::rough_grid(5, 2)));
  Mover<Exact> mover(t, 7);
  for (int i = 0; i < 200; ++i) t.flip_edge({mover.halfedge(false)});
  const auto before = state(t);
  for (int i = 0; i < 60; ++i) {
    const auto n = t.insert_vertex({mover.halfedge(false)}, mover.weights(false));
    ASSERT_EQ(n.status, IT::Move_status::done);
    ASSERT_EQ(t.remove_vertex(n.vertex), IT::Move_status::done);
    ASSERT_EQ(state(t), before) << i;
  }
}

TEST(Integer_coordinates, Come_back_when_everything_is_removed_and_flipped_to_delaunay) {
  for (const auto& [name, mesh] : {std::pair{"rough grid", meshes::rough_grid(4, 3)},
                                   std::pair{"potato", meshes::potato(1, 4)}}) {
    Exact t(subdivision_oracle::input(mesh));
    IT::flip_to_delaunay(t);
    const auto normal_coordinates = [&] {
      std::vector<int> n;
      for (const auto e : edges(t.mesh()))
        n.push_back(t.correspondence().normal_coordinate(t.index(e)));
      std::sort(n.begin(), n.end());
      return n;
    };
    const std::vector<int> before = normal_coordinates();
    Mover<Exact> mover(t, 8);
    for (int i = 0; i < 100; ++i) mover.move(true);
    for (int pass = 0; pass < 10 && !mover.inserted.empty(); ++pass) {
      IT::flip_to_delaunay(t);
      std::erase_if(mover.inserted, [&](IT::Gluing_map::Vertex v) {
        return t.remove_vertex(v) == IT::Move_status::done;
      });
    }
    ASSERT_TRUE(mover.inserted.empty()) << name;
    IT::flip_to_delaunay(t);
    EXPECT_EQ(normal_coordinates(), before) << name;
    EXPECT_EQ(defect(t), "") << name;
  }
}

} // namespace
