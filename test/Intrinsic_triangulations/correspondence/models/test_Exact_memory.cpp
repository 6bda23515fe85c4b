// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Exact_memory.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Flat_parts;

IT::Input input_of(const meshes::Mesh& m) {
  const IT::Gluing_map map = m.map();
  return {map, IT::Input_metric::from_points(map, m.points, 0)};
}

// over some faces of the input
IT::Unfolded_diamond over(const std::vector<std::uint32_t>& faces) {
  IT::Unfolded_diamond d;
  d.triangles.start({faces[0], 0});
  for (std::size_t i = 1; i < faces.size(); ++i)
    d.triangles.enter(d.triangles.last(), 1, {faces[i], 0});
  return d;
}

std::uint32_t part(Flat_parts& parts, const IT::Input& input, std::uint32_t f, std::uint32_t g,
                   const std::vector<std::uint32_t>& faces) {
  return parts.part(input, f, g, [&] { return over(faces); });
}

TEST(Flat_parts, of_a_box_are_its_sides) {
  const IT::Input input = input_of(meshes::box(2, 3, 4));
  Flat_parts parts(input);
  std::multiset<std::uint32_t> names;
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
    names.insert(part(parts, input, f, f, {f}));
  const std::set<std::uint32_t> sides(names.begin(), names.end());
  EXPECT_EQ(sides.size(), 6U);
  std::multiset<std::size_t> sizes;
  for (const std::uint32_t s : sides) sizes.insert(names.count(s));
  EXPECT_EQ(sizes, (std::multiset<std::size_t>{12, 12, 16, 16, 24, 24}));
}

TEST(Flat_parts, are_exact_to_an_ulp) {
  meshes::Mesh m = meshes::grid(3, 3);
  m.points[5][2] = 0x1p-1000;
  const IT::Input input = input_of(m);
  Flat_parts parts(input);
  std::set<std::uint32_t> names;
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
    names.insert(part(parts, input, f, f, {f}));
  EXPECT_GT(names.size(), 3U);
}

TEST(Flat_parts, stay_where_both_faces_of_a_flip_are_in_one_and_are_searched_elsewhere) {
  const IT::Input input = input_of(meshes::box(2, 2, 2));
  Flat_parts parts(input);
  const std::uint32_t side = part(parts, input, 0, 0, {0});
  std::vector<std::uint32_t> inside, outside;
  for (std::uint32_t f = 1; f < input.number_of_faces(); ++f)
    (part(parts, input, f, f, {f}) == side ? inside : outside).push_back(f);
  ASSERT_EQ(inside.size(), 7U);
  parts.flip(0, inside.front());
  EXPECT_EQ(part(parts, input, 0, inside.front(), {outside.front()}), side); // is not asked
  parts.flip(0, outside.front());
  EXPECT_EQ(part(parts, input, 0, 0, {0, outside.front()}), Flat_parts::none);
}

TEST(Flat_parts, are_forgotten_by_a_flip_with_a_face_that_was_never_asked_for) {
  const IT::Input input = input_of(meshes::box(2, 2, 2));
  Flat_parts parts(input);
  EXPECT_NE(part(parts, input, 0, 0, {0}), Flat_parts::none);
  std::uint32_t other = 1; // of another side
  while (IT::are_coplanar(input.metric(), 0, other, 0) &&
         IT::are_coplanar(input.metric(), 0, other, 1) &&
         IT::are_coplanar(input.metric(), 0, other, 2))
    ++other;
  parts.flip(0, input.number_of_faces() - 1);
  EXPECT_EQ(part(parts, input, 0, 0, {0, other}), Flat_parts::none);
}

} // namespace
