// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/build_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

// A file of the test that runs, removed in the end: tests may run at once.
class File {
public:
  File(const std::string& name, const std::string& text)
      : path_((std::filesystem::temp_directory_path() /
               (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                name))
                  .string()) {
    std::ofstream(path_) << text;
  }
  ~File() { std::filesystem::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

// A square, with a diagonal that is not Delaunay if it is long, and a vertex without faces.
const std::string square = "OFF\n5 2 0\n0 0 0\n3 0 0\n4 4 0\n0 3 0\n7 7 7\n3 0 1 2\n3 0 2 3\n";

std::string message_of(const auto& function) {
  try {
    function();
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
  return {};
}

TEST(read_surface, reads_a_mesh_and_says_what_it_is) {
  const File file("square.off", square);
  const auto built = IT::build_surface<Triangulation>(IT::read_surface(file.path()));
  EXPECT_EQ(built.facts.polygons, 2U);
  EXPECT_EQ(built.facts.counts.faces, 2U);
  EXPECT_EQ(built.facts.counts.boundary_edges, 4U);
  EXPECT_EQ(built.facts.counts.isolated_vertices, 1U);
  EXPECT_EQ(built.facts.domain.kind, IT::Domain_kind::manifold);
  EXPECT_FALSE(built.facts.cloud.has_value());
  const std::vector<Point> points{{0, 0, 0}, {3, 0, 0}, {4, 4, 0}, {0, 3, 0}, {7, 7, 7}};
  EXPECT_EQ(built.points, points);
  EXPECT_EQ(IT::number_of_polygons(built.triangulation.input()), 2U);
}

TEST(read_surface, makes_the_surface_that_words_name) {
  const File file("square.off", square);
  const auto read = [&](const std::string& domain) {
    return IT::read_surface(file.path(), IT::surface_options(domain));
  };
  EXPECT_EQ(read("tufted").facts.domain.kind, IT::Domain_kind::tufted_cover);
  EXPECT_EQ(read("closed").facts.domain.kind, IT::Domain_kind::tufted_cover);
  EXPECT_EQ(read("orientation-cover").facts.domain.kind, IT::Domain_kind::orientation_cover);
  EXPECT_EQ(read("tufted").input.mesh.number_of_faces(), 4U);
  const IT::Read_surface cloud = read("points");
  ASSERT_TRUE(cloud.facts.cloud.has_value());
  EXPECT_EQ(cloud.facts.polygons, 0U);
  const IT::Surface_options options = IT::surface_options("auto", "squared", "planar");
  EXPECT_EQ(options.mollification, IT::Mollification::squared_lengths);
  EXPECT_EQ(options.polygons, IT::Nonplanar_polygons::planar);
}

TEST(read_surface, refuses_words_that_name_nothing) {
  const std::string message = message_of([] { IT::surface_options("tuftd"); });
  EXPECT_NE(message.find("tuftd"), std::string::npos);
  EXPECT_NE(message.find("orientation-cover, tufted"), std::string::npos);
  EXPECT_THROW(IT::surface_options("auto", "some"), IT::Invalid_input);
  EXPECT_THROW(IT::surface_options("auto", "none", "bent"), IT::Invalid_input);
}

TEST(read_surface, gives_each_copy_on_a_cover_the_point_of_its_row) {
  const File file("square.off", square);
  const auto built = IT::build_surface<Triangulation>(
      IT::read_surface(file.path(), IT::surface_options("tufted")));
  ASSERT_EQ(built.points.size(), built.triangulation.input().number_of_rows());
  EXPECT_EQ(built.points[2], (Point{4, 4, 0}));
}

TEST(read_surface, names_the_file_and_refuses_neighbours_of_faces) {
  const File file("square.off", square);
  IT::Surface_options options;
  options.neighbors = 3;
  const std::string message = message_of([&] { IT::read_surface(file.path(), options); });
  EXPECT_EQ(message.find(file.path()), 0U);
  EXPECT_NE(message.find("this file has faces"), std::string::npos);
}

TEST(build_surface, refuses_points_that_are_too_few_or_too_many) {
  const File file("square.off", square);
  const auto build = [&](std::size_t points) {
    return IT::build_surface<Triangulation>(IT::read_surface(file.path()),
                                            std::vector<Point>(points));
  };
  EXPECT_THROW(build(4), IT::Invalid_input);
  EXPECT_THROW(build(6), IT::Invalid_input);
  EXPECT_EQ(build(5).points.size(), 5U);
}

TEST(stored_surface, knows_points_and_counts_after_a_flip) {
  const File file("square.off", square), stored("square.idt", "");
  auto built = IT::build_surface<Triangulation>(IT::read_surface(file.path()));
  EXPECT_EQ(IT::flip_to_delaunay(built.triangulation).flips, 1U);
  IT::write_intrinsic_triangulation(std::filesystem::path(stored.path()), built.triangulation);
  auto again = IT::read_stored_surface<Triangulation>(stored.path());
  EXPECT_EQ(again.points, built.points);
  EXPECT_EQ(again.facts.polygons, 2U);
  EXPECT_EQ(again.facts.counts.faces, 2U);
  IT::Input_edges edges(again.triangulation.input());
  std::vector<char> marks = edges.no_marks();
  ASSERT_TRUE(edges.mark(0, 2, marks)); // the diagonal that was flipped
  EXPECT_EQ(IT::restore_kept_edges(again.triangulation, marks), "");
  EXPECT_EQ(IT::flip_to_delaunay(again.triangulation).flips, 1U);
}

TEST(stored_surface, refuses_options_that_contradict_the_file) {
  const File file("square.off", square), stored("square.idt", "");
  const auto built = IT::build_surface<Triangulation>(IT::read_surface(file.path()));
  IT::write_intrinsic_triangulation(std::filesystem::path(stored.path()), built.triangulation);
  const auto arithmetic = [&](const std::optional<std::string>& asked, bool is_mollified,
                              const IT::Surface_options& options) {
    return IT::stored_arithmetic(stored.path(), asked, is_mollified, options);
  };
  EXPECT_EQ(arithmetic({}, false, {}), "exact");
  EXPECT_EQ(arithmetic("exact", false, {}), "exact");
  const auto refusal = [&](const std::optional<std::string>& asked, bool is_mollified,
                           const IT::Surface_options& options) {
    return message_of([&] { arithmetic(asked, is_mollified, options); });
  };
  EXPECT_NE(refusal("double", false, {}).find("--arithmetic"), std::string::npos);
  EXPECT_NE(refusal({}, true, {}).find("--mollification"), std::string::npos);
  EXPECT_NE(refusal({}, false, IT::surface_options("tufted")).find("--domain"), std::string::npos);
  EXPECT_NE(refusal({}, false, IT::surface_options("points")).find("--domain"), std::string::npos);
  IT::Surface_options options;
  options.neighbors = 5;
  EXPECT_NE(refusal({}, false, options).find("--neighbors"), std::string::npos);
}

} // namespace
